"""Modes of a uniform member by itself: many at a time, in closed form."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.natural_frequencies import NaturalFrequency
from vibcli.analyses.continuous.refinement import PARTS
from vibcli.analyses.continuous.uniform_curves import uniform_curves

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.analyses.continuous.uniform_members import UniformMember

SHARES = (*PARTS, 0.382, 0.29)      # of the length: every 64th mode may rest at all of the first ones
ERROR = 2e-15       # of closed forms: five roundings, and those of the data


def uniform_modes(member: "UniformMember", system: "ContinuousSystem", first: int, last: int) -> list[NaturalFrequency]:
    """The natural frequencies first … last of those that bend or stretch, counted without the resting ones."""
    numbers = np.arange(first, last + 1)
    squares, curves = member.squares(numbers), uniform_curves(member, numbers)
    places = _places(member.piece.order, member.wave_numbers(numbers))
    homes = {place: system.refined({0: system.number(SHARES[place])}) for place in set(places.tolist())}
    shapes = _shapes(member.piece.length, system, curves, np.array(SHARES)[places])
    return [NaturalFrequency(number, square, ERROR, shape, homes[place], curve) for number, square, shape, place, curve
            in zip((numbers + member.resting).tolist(), squares, shapes, places.tolist(), curves.each(), strict=True)]


def _places(order: int, phases: np.ndarray) -> Any:
    """For each βL the place in SHARES of a division whose two pieces are far from frequencies of their own."""
    shift, lowest = (0.0, 1.0) if order == 2 else (0.5, 1.5)
    nearest = []
    for part in SHARES:
        turns = np.array([phases * part, phases * (1 - part)]) / np.pi
        pole = np.maximum(np.round(turns - shift) + shift, lowest)
        nearest.append(np.abs(turns - pole).min(axis=0))
    return np.argmax(nearest, axis=0)


def _shapes(length, system, curves, shares):
    """Each over the coordinates of the ends, then of the node at its share of the length: (modes, coordinates)."""
    half = 2 if curves.bends else 1
    left, inside, right = (curves.along(x)[:, :half] for x in (0.0, length * shares, length))
    ends = np.concatenate([left, right], axis=1)
    found = np.empty((len(shares), system.n + half))
    for values, row in zip(ends.T, system.ordered[0].rows, strict=True):
        for i, x in row.items():
            if x:
                found[:, i] = values / x
    found[:, system.n:] = inside
    return found
