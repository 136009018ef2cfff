"""Shapes of a uniform member by itself at frequencies that are known: many at a time."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.natural_frequencies import NaturalFrequency
from vibcli.analyses.continuous.rayleigh_steps import nearer, settled, start
from vibcli.analyses.continuous.refinement import PARTS, away_from_poles
from vibcli.numerics.sparse_elimination import product, quadratic

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.analyses.continuous.uniform_members import UniformMember

SHARES = (*PARTS, 0.382, 0.29)      # of the length: every 64th mode may rest at all of the first ones
STEPS = 2
ERROR = 2e-15       # of closed forms: five roundings, and those of the data


def uniform_modes(member: "UniformMember", system: "ContinuousSystem", first: int, last: int) -> list[NaturalFrequency]:
    """The natural frequencies first … last of those that bend or stretch, counted without the resting ones."""
    numbers = np.arange(first, last + 1)
    squares, phases = member.squares(numbers), member.wave_numbers(numbers)
    found: dict[int, NaturalFrequency] = {}
    places = _places(member.piece.order, phases)
    for place in np.unique(places).tolist():
        divided = system.refined({0: system.number(SHARES[place])})
        chosen = np.flatnonzero(places == place)
        x = _shapes(divided, squares[chosen])
        for column, at in enumerate(chosen.tolist()):
            shape, home = x[:, column], divided
            if not np.isfinite(shape).all():
                home = away_from_poles(system, squares[at], squares[at])
                shape = _shapes(home, squares[at:at + 1])[:, 0]
            number = int(numbers[at]) + member.resting
            found[number] = NaturalFrequency(number, squares[at], ERROR, shape, home)
    return [found[number] for number in sorted(found)]


def _places(order: int, phases: np.ndarray) -> Any:
    """For each βL the place in SHARES of a division whose two pieces are far from frequencies of their own."""
    shift, lowest = (0.0, 1.0) if order == 2 else (0.5, 1.5)
    nearest = []
    for part in SHARES:
        turns = np.array([phases * part, phases * (1 - part)]) / np.pi
        pole = np.maximum(np.round(turns - shift) + shift, lowest)
        nearest.append(np.abs(turns - pole).min(axis=0))
    return np.argmax(nearest, axis=0)


def _shapes(system, squares):
    """The shapes at each ω², xᵀ ∂D/∂s² x = 1, (coordinates, number of them)."""
    x = start(system, len(squares))
    with np.errstate(all="ignore"):
        entries, _, slope = system.dynamic_stiffness(squares)
        for _ in range(STEPS):
            x = nearer(system, squares, product(system.pattern, slope, x))
            x = x / np.sqrt(quadratic(system.pattern, slope, x))
        x = settled(system, squares, entries, x)
    return x / np.sqrt(quadratic(system.pattern, slope, x))
