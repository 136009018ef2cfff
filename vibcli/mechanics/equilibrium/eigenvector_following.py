"""Equilibria with a number of unstable directions that is asked for, by following eigenvectors of J.

From any place uphill along the k softest directions and downhill along the others (Cerjan & Miller 1981, J. Chem. Phys.
75, 2800): what Newton's method passes by, since there the forces grow on the way, is reached as well.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.equilibrium.multistart import spread
from vibcli.mechanics.equilibrium.newton import CLOSE, settled

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.distinct_roots import Found
    from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place

STEPS, LONGEST, SOFTEST, ASIDE, STARTS = 80, 0.3, 1e-3, 0.2, 10


def look_for(forces: "Forces", found: "Found", index: int) -> bool:
    """Adds places whose J has a determinant of this sign, from beside those that are known and from points between;
    True if one is new."""
    low, high = found.box
    starts = [*_beside(forces, found), *(low + part * (high - low) for part in spread(len(low), STARTS * len(low)))]
    before = found.count
    for uphill in range(0 if index > 0 else 1, len(low) + 1, 2):
        for z in starts:
            place = _followed(forces, z, found.box, uphill)
            if place is not None:
                found.add(place)
        if found.count > before:
            return True
    return False


def _beside(forces: "Forces", found: "Found") -> Iterator[np.ndarray]:
    """Places to both sides of those known, along the directions in which they are soft or stiff."""
    for place in found.isolated:
        for direction in np.linalg.eigh(_symmetric(place.J))[1].T:
            yield place.z + ASIDE * direction
            yield place.z - ASIDE * direction


def _followed(forces: "Forces", z: np.ndarray, box: Sequence[np.ndarray], uphill: int) -> "Place | None":
    """The balanced Place that is reached from z; None of none in the box."""
    low, high = box
    for _ in range(STEPS):
        place = forces.at(z)
        if place is None or np.any(((z < low) | (z > high)) & ~forces.periodic):
            return None
        if place.residual <= CLOSE:
            return settled(forces, place)
        sizes, directions = np.linalg.eigh(_symmetric(place.J))
        sizes = np.maximum(np.abs(sizes), SOFTEST * np.abs(sizes).max())
        if not sizes.all():
            return None
        sizes[:uphill] *= -1
        step = -directions @ (directions.T @ place.F / sizes)
        z = z + step * min(1.0, LONGEST / max(np.linalg.norm(step), 1e-300))  # type: ignore[operator]
    return None


def _symmetric(J: list[list[float]]) -> np.ndarray:
    found: np.ndarray = 0.5 * (np.array(J) + np.transpose(J))
    return found
