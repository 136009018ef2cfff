"""Estimates of natural frequencies by Rayleigh, Dunkerley and Ritz, without members."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import estimates as reference
from vibcli.evidence.reference.settled import TrueValues
from vibcli.evidence.subject import ESTIMATE, Subject, of_number
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities.expression import measure
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef


def rayleigh(problem: "Problem", tree: "QuantityRef") -> Subject:
    """By the deflection under all inertia that moves like the first."""
    M, K = _matrices(problem, tree)
    kinds = [problem.system.dimension(name) for name in problem.scene.coordinates]
    first = next(kind for kind, row in zip(kinds, M, strict=True) if row.any())
    alike = [int(kind == first) for kind in kinds]

    def plain() -> float:
        bent = np.linalg.solve(K, M @ alike)
        return cast("float", np.sqrt(bent @ K @ bent / (bent @ M @ bent)))

    return _subject(problem, tree, reference.rayleigh(problem.configuration.precise_system, alike), plain)


def dunkerley(problem: "Problem", tree: "QuantityRef") -> Subject:
    """By the sum of all flexibilities."""
    M, K = _matrices(problem, tree)
    return _subject(problem, tree, reference.dunkerley(problem.configuration.precise_system),
                    lambda: np.trace(np.linalg.solve(K, M)) ** -0.5)


def ritz(problem: "Problem", tree: "QuantityRef") -> Subject:
    """By the shapes that are assumed."""
    M, K = _matrices(problem, tree)
    number = int(tree.indices[0])
    Phi = np.array(_shapes(problem, Floats), dtype=float).T

    def plain() -> float:
        import scipy.linalg

        return cast("float", scipy.linalg.eigh(Phi.T @ K @ Phi, Phi.T @ M @ Phi, eigvals_only=True)[number - 1] ** 0.5)

    return _subject(problem, tree, reference.ritz(
        problem.configuration.precise_system, lambda: _shapes(problem, multiprecision()), number), plain)


def _matrices(problem: "Problem", tree: "QuantityRef") -> tuple[np.ndarray, np.ndarray]:
    """(M, K) in floats, refused where there is no estimate, or no matrix."""
    measure(problem, tree)
    if problem.scene.pieces:
        raise PhysicsError("no reference is found of estimates for members")
    M, _, _, K = problem.configuration.linear_system.arrays()
    return M, K


def _shapes(problem: "Problem", arithmetic: Any) -> "list[list[float | mpmath.mpf]]":
    """A list of amplitudes for each shape."""
    scene, known = problem.scene, problem.numeric.values(arithmetic)
    zero = arithmetic.number(0)
    return [[evaluate([scene.lower(shape[name])], arithmetic, known)[0] if name in shape else zero
             for name in scene.coordinates] for shape in problem.spec.get("find").about("ritz")["shapes"]]


def _subject(problem: "Problem", tree: "QuantityRef", true: TrueValues, plain: Callable[[], Any]) -> Subject:
    return of_number(ESTIMATE, problem, tree, "an estimate of a natural frequency", true, plain,
                     float(true.values[0]), lambda: problem.about(Configuration(problem.numeric)))
