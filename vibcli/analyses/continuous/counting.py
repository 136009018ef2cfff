"""How many natural frequencies lie below one: bounds of the count that no rounding can turn.

What rounds in D is a matrix below a diagonal one, |ΔD| ≤ E: where D − E and D + E have as many negative eigenvalues as
each other, D has so many too. E follows from the magnitudes that each entry was added and eliminated from. What rounds
in the argument √z of d is a change of frequency, which a bracket has to allow for.
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem

GUARD = 12          # roundings in an entry of D: of its data, of d, of the sum
ELIMINATED = 4      # roundings in a product that elimination subtracts
SLACK = 1.5         # how much wider than what rounds in the entries E is, for what rounds in the elimination
UNKNOWN = 1 << 40


class Count(NamedTuple):
    """At each z: `below` ≤ J ≤ `above`; held: J₀ of each piece, (pieces, number of z)."""

    below: np.ndarray
    above: np.ndarray
    held: np.ndarray


def count(system: "ContinuousSystem", z: np.ndarray, slack: float = SLACK) -> Count:
    """The Count at each z; slack ≥ 1: by how much E is widened, so that what grows in the elimination has room."""
    held = system.held(z)
    shift = held.sum(axis=0)
    if not system.n:
        return Count(shift, shift, held)
    entries, sizes, slope = system.dynamic_stiffness(z)
    scale = scales(system, z, sizes, slope)
    room = rounding(system, sizes, scale) * slack
    twice = [np.concatenate([part, part], axis=1) for part in (entries, sizes, scale)]
    (below, above), sure = _negative(system, *twice, np.concatenate([room, -room], axis=1))
    finite = np.isfinite(sizes.astype(float)).all(axis=0)
    unsure = np.flatnonzero(finite & ~sure.all(axis=0))
    if len(unsure):
        below[unsure], above[unsure] = by_eigenvalues(
            system, entries[:, unsure], scale[:, unsure], room[:, unsure])
    return Count(shift + np.where(finite, below, 0), np.where(finite, shift + above, UNKNOWN), held)


def rounding(system: "ContinuousSystem", sizes: np.ndarray, scale: np.ndarray) -> np.ndarray:
    """The diagonal of E, (n, number of z), for entries that were added from such magnitudes: with any scale
    2 |xᵢ xⱼ| ≤ xᵢ² scaleᵢ/scaleⱼ + xⱼ² scaleⱼ/scaleᵢ."""
    i, j = system.pattern.above
    room, ratio = sizes[:system.n] * 1, scale[i] / scale[j]
    np.add.at(room, i, sizes[system.n:] * ratio)
    np.add.at(room, j, sizes[system.n:] / ratio)
    return room * (GUARD * system.unit)


def scales(system: "ContinuousSystem", z: np.ndarray, sizes: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """What each coordinate is measured by, √ of a stiffness, (n, number of z), in floats."""
    n = system.n
    return cast("np.ndarray", np.sqrt(np.maximum((sizes[:n] + abs(z) * abs(slope[:n])).astype(float), 1e-300)))


def _negative(system: "ContinuousSystem", entries: np.ndarray, sizes: np.ndarray, scale: np.ndarray,
              room: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The negative eigenvalues of D + room, and whether E covers what the elimination rounds, of two halves."""
    shifted = entries.copy()
    shifted[:system.n] = shifted[:system.n] + room
    factors = system.eliminated(shifted, sizes)
    negative = factors.negative().reshape(2, -1)
    if system.pattern.tree:
        return negative, np.ones(negative.shape, bool)
    rounded = rounding(system, factors.products, scale) * (ELIMINATED / GUARD)
    return negative, (rounded <= abs(room) * (1 - 1 / SLACK)).all(axis=0).reshape(2, -1)


def by_eigenvalues(system: "ContinuousSystem", entries: np.ndarray, scale: np.ndarray, room: np.ndarray
                   ) -> tuple[np.ndarray, np.ndarray]:
    """Bounds of the number of negative eigenvalues from all of them, where elimination without exchanges grows."""
    n, count_ = scale.shape
    scale = 1 / scale
    full = np.zeros((count_, n, n), entries.dtype)
    for (i, j), place in system.pattern.places.items():
        full[:, i, j] = entries[place] * scale[i] * scale[j]
        full[:, j, i] = np.conj(full[:, i, j])
    values = np.array([_precise(one) for one in full]) if system.digits else np.linalg.eigvalsh(full)
    margin = (room * scale ** 2).max(axis=0) + 4 * n * system.unit * abs(values).max(axis=1)
    return (values < -margin[:, None]).sum(axis=1), (values < margin[:, None]).sum(axis=1)


def _precise(matrix: np.ndarray) -> np.ndarray:
    """The eigenvalues of a matrix in numbers of mpmath."""
    import mpmath

    found = mpmath.eighe(mpmath.matrix(matrix.tolist()), eigvals_only=True)
    return np.array(list(found), object)
