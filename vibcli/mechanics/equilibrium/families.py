"""Lines and surfaces of equilibria: directions along which a position can be moved and stays balanced.

A singular J alone does not tell them from a multiple zero (V = x⁴): a step along the direction, brought back to
balance across it, must not lead back.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.equilibrium.newton import settled
from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place, near_drawn

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
    from vibcli.mechanics.numeric_system import NumericSystem

STEP, SINGULAR, PACE = 0.05, 1e-8, 0.25
SAMPLES = 12            # positions near the drawn one by which sizes are learnt
REACHED, CLOSE, CORRECTIONS = 1e-6, 1e-9, 6


def null_directions(place: Place) -> np.ndarray:
    """Orthonormal directions in which J vanishes but for rounding, as rows."""
    _, values, rows = np.linalg.svd(place.J)
    found: np.ndarray = rows[values <= SINGULAR * max(values[0], 1.0)]
    return found


def free_directions(forces: Forces, place: Place) -> np.ndarray:
    """Orthonormal directions, as rows, in which neighbours of an equilibrium are equilibria."""
    null = null_directions(place)
    moves = [move for row in null if (move := _moved(forces, place, row)) is not None]
    if not moves:
        return np.zeros((0, len(place.z)))
    _, values, rows = np.linalg.svd(np.array(moves) @ null.T @ null)
    found: np.ndarray = rows[:len(values)][values > 0.1 * values[0]]
    return found


def _moved(forces: Forces, place: Place, row: np.ndarray) -> np.ndarray | None:
    """Where a step along a direction leads, brought back to balance; None where that is back to the place."""
    there = forces.at(place.z + STEP * row)
    there = None if there is None else settled(forces, there, SINGULAR)
    if there is None or not len(null_directions(there)):
        return None
    move = forces.gap(there.z, place.z)
    return move if float(np.linalg.norm(move)) > STEP / 2 else None


class Family:
    """Equilibria that hang together: the first that was met, its free directions, and all places met so far."""

    def __init__(self, place: Place, rows: np.ndarray) -> None:
        self.place, self.rows, self.met = place, rows, [place]

    def holds(self, forces: Forces, place: Place) -> bool:
        """Does a walk along the family, from its nearest known place, lead to another equilibrium?"""
        if len(null_directions(place)) < len(self.rows):
            return False
        def away(other: Place) -> float:
            return float(np.linalg.norm(forces.gap(place.z, other.z)))

        here, before = min(self.met, key=away), np.inf
        while (distance := away(here)) < before:
            if distance <= REACHED:
                self.met.append(place)
                return True
            rows = null_directions(here)
            along = rows.T @ (rows @ forces.gap(place.z, here.z))
            length = float(np.linalg.norm(along))
            if not length > 1e-3 * distance:
                return False
            here, before = _returned(forces, here.z + along * min(1.0, PACE / length)), distance
            if here is None:
                return False
        return False


def _returned(forces: Forces, z: np.ndarray) -> Place:
    """The place near z to which a few Newton steps across the null directions lead."""
    place = forces.at(z)
    for _ in range(CORRECTIONS):
        if place is None or place.residual <= CLOSE:
            break
        place = forces.at(place.z + place.step(SINGULAR))
    return place


def freedom(equilibrium: "Equilibrium", forces: Forces) -> int:
    """In how many directions an Equilibrium can be moved and stays one."""
    place = forces.at(forces.vector(equilibrium.values))
    return 0 if place is None else len(free_directions(forces, place))


def learnt(numeric: "NumericSystem") -> Forces:
    """The Forces of a Problem, their size learnt near the drawn position."""
    forces = Forces(numeric, numeric.scene.coordinates)
    forces.learn_periods()
    forces.learn_sizes(near_drawn(forces, SAMPLES))
    return forces
