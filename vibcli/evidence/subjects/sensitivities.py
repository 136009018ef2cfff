"""Derivatives of natural frequencies by parameters."""

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.evidence.methods.assembled_modes import rates_of
from vibcli.evidence.reference.sensitivities import sensitivity as true_sensitivity
from vibcli.evidence.reference.sensitivities import undamped
from vibcli.evidence.subject import BY_DIFFERENCES, Subject, of_number
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities import equilibrium
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import about_which

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef


def sensitivity(problem: "Problem", tree: "QuantityRef") -> Subject:
    """sensitivity[i, p]; others solve the scene anew at two values of p."""
    measure(problem, tree)          # refused where there is none
    asked, which = about_which(tree)
    one = problem if which is None else equilibrium.about(problem, int(which))
    number, name = int(asked.indices[0]), asked.indices[1]
    true = true_sensitivity(one.configuration, number, name)
    return of_number(BY_DIFFERENCES, one, tree, "of a natural frequency to a parameter", true,
                     _differences(one.configuration, number, name), float(true.about),
                     lambda: problem.about(Configuration(problem.numeric)))


def _differences(configuration: Configuration, number: int, name: str) -> Callable[[float], float]:
    """Central ones with a step relative to the parameter."""
    p = configuration.numeric.floats[name]

    def omega(value: float) -> float:
        given = {name: Fraction(value)}
        M, _, G, K = undamped(Configuration(configuration.numeric.sharing(given)).linear_system).arrays()
        return cast("float", sorted(x.imag for x in rates_of(_squares(M, G, K)).values)[number - 1])

    def estimate(step: float) -> float:
        h = step * (abs(p) or 1.0)
        return (omega(p + h) - omega(p - h)) / (2 * h)

    return estimate


def _squares(M: np.ndarray, G: np.ndarray, K: np.ndarray) -> np.ndarray:
    """ω² of K φ = ω² M φ; of gyroscopic scenes by the state matrix."""
    import scipy.linalg

    if not G.any():
        return cast("np.ndarray", scipy.linalg.eigvals(K, M))
    n = len(M)
    A = np.block([[np.zeros_like(M), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, G)]])
    return -np.array([x for x in np.linalg.eigvals(A) if x.imag >= 0]) ** 2
