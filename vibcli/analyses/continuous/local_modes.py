"""All modes within a narrow bracket at a time: those that coincide, nearly coincide, or lie at a pole of D."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.rayleigh_steps import nearer, start
from vibcli.analyses.continuous.refinement import away_from_poles
from vibcli.numerics.sparse_elimination import product, quadratic

if TYPE_CHECKING:
    from vibcli.analyses.continuous.brackets import Bracket
    from vibcli.analyses.continuous.system import ContinuousSystem

STEPS = 12
STEADY = 64         # roundings of z that are no step any more
SPARE = 2           # vectors more than modes, so that near ones outside do not mix in


def local_modes(system: "ContinuousSystem", bracket: "Bracket"
                ) -> "tuple[ContinuousSystem, np.ndarray, np.ndarray, list[int]]":
    """The system with further nodes, z ascending, shapes in columns, indices of the modes within a bracket.

    D(z) x = 0 is D(z₀) x = (z − z₀) D′ x close to z₀: iterated in a subspace of each part that nothing ties to others,
    so that each shape is one of a part; of modes that coincide those of the first part come first.
    """
    system = away_from_poles(system, bracket.low, bracket.high)
    wanted = bracket.above - bracket.below
    indices = list(range(bracket.below + 1, bracket.above + 1))
    middle, width = (bracket.low + bracket.high) / 2, (bracket.high - bracket.low) / 2
    parts, near = _subspaces(system, wanted + SPARE), np.zeros(0)
    for _ in range(STEPS):
        moved, parts = _stepped(system, system.numbers([middle]), parts)
        before, near = near, _within(bracket, middle + moved)[:wanted]
        steady = len(before) and max(abs(moved[near])) <= STEADY * system.unit * abs(middle)
        values = middle + moved[near]
        if steady:
            break
        middle = sum(values) / wanted if all(abs(values - middle) <= 2 * width) else middle
    if max(values) - min(values) <= STEADY * system.unit * abs(middle):
        near = np.sort(near)
    return system, values, np.hstack(parts)[:, near], indices


def _subspaces(system: "ContinuousSystem", size: int) -> list[np.ndarray]:
    """At most `size` vectors of each part that has inertia and that nothing ties to others."""
    found, inertia = [], system.dynamic_stiffness(system.numbers([system.scale]))[2]
    for part in system.pattern.parts:
        held = np.zeros((system.n, 1), bool)
        held[part] = True
        if inertia[part].any():
            found.append(np.where(held, start(system, min(size, len(part))), system.number(0)))
    return found


def _stepped(system: "ContinuousSystem", z: np.ndarray, parts: Any) -> tuple[np.ndarray, Any]:
    """The eigenvalues by which z moves, and the vectors of each part, after one step."""
    entries, _, slope = system.dynamic_stiffness(z)
    x = nearer(system, z, product(system.pattern, slope, np.hstack(parts)))
    own = np.split(x, np.cumsum([part.shape[1] for part in parts])[:-1], axis=1)
    moved, parts = zip(*(projected(system, entries, slope, part) for part in own), strict=True)
    return np.concatenate(moved), parts


def _within(bracket: "Bracket", z: np.ndarray) -> np.ndarray:
    """The places of z, those within the bracket first, of others the nearest; ascending where there are enough."""
    middle = (bracket.low + bracket.high) / 2
    wanted = bracket.above - bracket.below
    inside = [i for i, x in enumerate(z) if bracket.low < x < bracket.high]
    outside = sorted((i for i in range(len(z)) if i not in inside), key=lambda i: abs(z[i] - middle))
    return np.array(sorted((inside + outside)[:wanted], key=lambda i: z[i]), int)


def projected(system: "ContinuousSystem", entries: np.ndarray, slope: np.ndarray, x: np.ndarray
              ) -> tuple[np.ndarray, np.ndarray]:
    """The eigenvalues by which z moves and the vectors of D, D′ in the space of x; LinAlgError where these are no
    numbers."""
    size = x.shape[1]
    stiff, mass = np.empty((size, size), x.dtype), np.empty((size, size), x.dtype)
    with np.errstate(divide="ignore", invalid="ignore"):
        x = x / np.sqrt(abs(quadratic(system.pattern, slope, x)))
        for j in range(size):
            column = x[:, j:j + 1]
            stiff[:, j] = quadratic(system.pattern, entries, x, column)
            mass[:, j] = quadratic(system.pattern, slope, x, column)
    moved, basis = _pencil(stiff, mass)
    return moved, x @ basis


def _pencil(stiff: Any, mass: Any) -> tuple[np.ndarray, np.ndarray]:
    """The eigenvalues and vectors of stiff y = λ mass y, yᵀ mass y = 1."""
    if stiff.dtype.kind == "O":
        return _precise_pencil(stiff, mass)
    values, basis = np.linalg.eigh(mass)
    kept = values > values.max() * 1e-13
    if not kept.any():
        raise np.linalg.LinAlgError
    basis = basis[:, kept] / np.sqrt(values[kept])
    values, vectors = np.linalg.eigh(basis.conj().T @ stiff @ basis)
    return values, basis @ vectors


def _precise_pencil(stiff: np.ndarray, mass: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    import mpmath

    values, basis = mpmath.eigsy(mpmath.matrix(mass.tolist()))
    size = len(stiff)
    kept = [k for k in range(size) if values[k] > values[size - 1] * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)]
    basis = np.array([[basis[i, k] / mpmath.sqrt(values[k]) for k in kept] for i in range(size)], object)
    values, vectors = mpmath.eigsy(mpmath.matrix((basis.T @ stiff @ basis).tolist()))
    vectors = np.array(vectors.tolist(), object).reshape(len(kept), len(kept))
    return np.array(list(values), object), basis @ vectors
