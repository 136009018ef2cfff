"""Is an equilibrium stable where coordinates have no inertia?

Where springs, weights and loads have a potential and dampers take energy away, it is stable if that is least, whatever
has inertia and whatever a damper resists (Thomson & Tait 1879, Chetaev 1955): by the signs of K, of all coordinates.
What follows the rest statically over a hill of the potential leaves it as soon as it is given the least mass.

Otherwise the finite roots of λ² M + λ C + K decide, if what follows statically is held by its own stiffness K_z:
wherever det K_z < 0 it is not, whatever masses and dampers are added; where loads alone make K_z unsymmetric and hold
it, they decide.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.method import dragged
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import FactoredSystem

FOLLOWS, FALLS, UNKNOWN = "follows", "falls", "unknown"
ROUNDING = 2.0 ** -50       # of a sum in floats, relative to its terms
LOOSE = 1e-12               # of the largest damping: what no damper resists
DIGITS, ZERO = 50, 1e-35    # where floats do not tell a sign
MOST_PRECISE = 40           # coordinates


class Direction:
    """A direction in which K vanishes; index: its number, from 1."""

    __slots__ = ("index", "shape")

    def __init__(self, index: int, shape: np.ndarray) -> None:
        self.index, self.shape = index, shape


class Signs(NamedTuple):
    """How many eigenvalues of K are negative, and the Directions of those that are zero."""

    negative: int
    null: list[Direction]


def signs_of_stiffness(configuration: "Configuration") -> Signs:
    """Of K, which is symmetric, in floats where they tell the signs, else to DIGITS digits."""
    elements = configuration.linear_system
    K = elements.stiffness_array()
    unit = _units(K)
    values, vectors = np.linalg.eigh(unit[:, None] * (K + K.T) / 2 * unit)
    doubt = _rounding(elements, unit, values)
    if np.abs(values).min() <= doubt and configuration.sources[0] is not None and elements.n <= MOST_PRECISE:
        values, doubt = _precisely(configuration.sources[0](DIGITS), unit)
    null = [Direction(i, unit * vectors[:, j]) for i, j in enumerate(np.flatnonzero(np.abs(values) <= doubt), 1)]
    return Signs(int((values < -doubt).sum()), null)


def _units(K: np.ndarray) -> np.ndarray:
    """Of the coordinates, so that the largest entry of each row is near 1."""
    sizes = np.abs(K).max(axis=1, initial=0.0)
    return 1 / np.sqrt(np.where(sizes == 0, 1.0, sizes))


def margins(modal: "ModalAnalysis") -> tuple[list[float], float]:
    """(numbers of which one passes through zero at the limit of stability, their size): the eigenvalues of K, taken
    relative to the sizes of its terms, or −Re λ of all modes."""
    elements = modal.configuration.linear_system
    if takes_energy(elements):
        return _relative(elements), 1.0
    held, damped = of_what_follows(elements), modal.damped
    if held == FALLS:
        return [-1.0], 1.0
    if held != FOLLOWS or damped is None:
        raise PhysicsError("loads without a potential act where something has no inertia: masses or dampers would "
                           "decide where the limit of stability is", "give it a mass or a damper")
    return [-float(mode.eigenvalue.real) for mode in damped], max(float(abs(mode.eigenvalue)) for mode in damped) or 1.0


def _relative(elements: "FactoredSystem") -> list[float]:
    """The eigenvalues of K, each coordinate in units in which the terms of its own stiffness add up to 1."""
    unit = 1 / np.sqrt(np.maximum(_sizes(elements).diagonal(), np.finfo(float).tiny))
    K = elements.stiffness_array()
    found: list[float] = np.linalg.eigvalsh(unit[:, None] * (K + K.T) / 2 * unit).tolist()
    return found


def _sizes(elements: "FactoredSystem") -> np.ndarray:
    """The sums of the magnitudes of the terms of K."""
    size = np.zeros((elements.n, elements.n))
    for weight, row in elements.springs:
        for i, x in row.items():
            for j, y in row.items():
                size[i, j] += abs(weight * x * y)
    for pair, x in (elements.K_size or elements.K).items():
        size[pair] += abs(x)
    return size


def _rounding(elements: "FactoredSystem", unit: np.ndarray, values: np.ndarray) -> float:
    """How far the eigenvalues may be off that floats give."""
    size = _sizes(elements)
    off = np.abs(unit[:, None] * size * unit).sum(axis=1).max(initial=0.0)
    found: float = ROUNDING * off + elements.n * ROUNDING * np.abs(values).max(initial=0.0)
    return found


def _precisely(elements: "FactoredSystem", unit: np.ndarray) -> tuple[np.ndarray, float]:
    """(eigenvalues in ascending order, what counts as zero) of elements in numbers of mpmath."""
    import mpmath

    with mpmath.workdps(DIGITS):
        K = mpmath.zeros(elements.n)
        for (i, j), x in elements.stiffness().items():
            K[i, j] = x * float(unit[i]) * float(unit[j])
        values = np.array([float(value) for value in mpmath.eigsy(K, eigvals_only=True)])
    return values, ZERO * max(np.abs(values).max(initial=0.0), 1.0)


def takes_energy(elements: Any) -> bool:
    """Has what acts a potential, and does everything else only take energy away: K is symmetric and C, without G, not
    negative?"""
    if elements.circulatory or any(elements.G.values()) or any(elements.drag.values()):
        return False
    if not any(elements.C.values()):
        return all(c >= 0 for c, _ in elements.dampers)
    C = elements.arrays()[1]
    unit = _units(C)
    values = np.linalg.eigvalsh(unit[:, None] * C * unit)
    return bool(values[0] >= -LOOSE * np.abs(values).max())


def of_what_follows(elements: Any) -> str:
    """FOLLOWS, FALLS or UNKNOWN: of the directions that neither inertia nor a damper resists, by their stiffness."""
    Z = _following(elements)
    K = Z.T @ elements.stiffness_array() @ Z
    unit = _units(K)
    K = unit[:, None] * K * unit
    values = np.linalg.eigvalsh((K + K.T) / 2)
    doubt = ROUNDING * len(K) * np.abs(values).max(initial=0.0)
    if not len(values) or values[0] > doubt:
        return FOLLOWS
    symmetric = np.abs(K - K.T).max() <= ROUNDING * len(K)
    down = values[0] < -doubt if symmetric else np.linalg.det(K) < -ROUNDING * len(K)
    return FALLS if down else UNKNOWN


def _following(elements: "FactoredSystem") -> np.ndarray:
    """The directions without inertia and damping, as columns."""
    moved = dragged(elements)
    still = [i for i in sorted(elements.massless) if i not in moved]
    _, C, G, _ = elements.arrays()
    columns = [np.eye(elements.n)[still].T]
    if moved:
        own = (C + G)[np.ix_(moved, moved)]
        unit = _units(own)
        _, sizes, rows = np.linalg.svd(unit[:, None] * own * unit)
        loose = np.zeros((elements.n, int((sizes <= LOOSE * max(sizes[0], 1e-300)).sum())))
        loose[moved] = unit[:, None] * rows[len(rows) - loose.shape[1]:].T
        columns.append(loose)
    return np.concatenate(columns, axis=1)
