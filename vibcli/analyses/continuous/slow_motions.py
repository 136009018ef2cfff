"""Slow motions of members for a look: those in which pieces bend as at rest.

With the exact D(0) and its inertia D′(0), D(0) x = λ D′(0) x: as many λ are negative as modes grow (Sylvester), λ ≥ ω²
where none is, and λ = ω² where that vanishes.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.counting import rounding, scales
from vibcli.analyses.continuous.local_modes import projected
from vibcli.analyses.continuous.rigid_motions import rigid_count
from vibcli.analyses.continuous.system import continuous_system
from vibcli.base.errors import PhysicsError
from vibcli.numerics.sparse_elimination import product, quadratic

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.mechanics.factored_system import FactoredSystem

MIDDLE = 0.5
MOVING = 2          # motions at least that are not rigid
TOLD = 1e-7         # of the first λ, below which rounding is no matter
DIGITS, STEPS = 40, 3


def slow_squares(elements: "FactoredSystem") -> tuple[int, list[float]] | None:
    """(rigid motions, λ of the others ascending, the first in more digits where it is small); None where a half of a
    piece buckles with its ends held."""
    rigid = rigid_count(elements)
    system, z = _halved(continuous_system(elements), rigid), np.zeros(1)
    if system.held(z).any():
        return None
    entries, sizes, inertia = system.dynamic_stiffness(z)
    try:
        squares, shapes = projected(system, entries, inertia, np.eye(system.n))
    except np.linalg.LinAlgError:
        raise PhysicsError("the data are so far apart that floats do not tell what holds the members",
                           "look for lengths and stiffnesses of very different size") from None
    moving = np.sort(np.argsort(abs(squares), kind="stable")[rigid:])
    found, shape = squares[moving].tolist(), shapes[:, moving[:1]]
    rounds = (abs(shape) ** 2 * rounding(system, sizes, scales(system, z, sizes, inertia))).sum()
    if max(rounds, system.unit * abs(squares).max()) > TOLD * abs(found[0]):
        found[0] = _precise(elements, rigid, shape, found[0])
    return rigid, found


def _halved(system: "ContinuousSystem", rigid: int) -> "ContinuousSystem":
    """With nodes in the middle of pieces, until enough can move."""
    while True:
        system = system.refined(dict.fromkeys(range(len(system.pieces)), system.number(MIDDLE)))
        if system.n >= rigid + MOVING:
            return system


def _precise(elements: Any, rigid: int, shape: np.ndarray, near: Any) -> float:
    """λ next to one that rounds, by inverse iteration in more digits."""
    from mpmath import mp

    with mp.workdps(DIGITS + 5):
        system = _halved(continuous_system(elements.each(mp.mpf), DIGITS).plain, rigid)
        entries, sizes, inertia = system.dynamic_stiffness(system.numbers([0]))
        factors = system.eliminated(entries - (near + system.scale * system.aside) * inertia, sizes)
        x = np.array([system.numbers(row) for row in shape])
        for _ in range(STEPS):
            x = factors.solved(product(system.pattern, inertia, x))
            x = x / mp.sqrt(quadratic(system.pattern, inertia, x)[0])
        return float(quadratic(system.pattern, entries, x)[0])
