"""Modes of a uniform member by itself: many at a time, in closed form."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.natural_frequencies import NaturalFrequency
from vibcli.analyses.continuous.refinement import PARTS
from vibcli.analyses.continuous.uniform_curves import uniform_curves

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.analyses.continuous.uniform_curves import UniformCurves
    from vibcli.analyses.continuous.uniform_members import UniformMember

SHARES = (*PARTS, 0.382, 0.29)      # of the length: every 64th mode may rest at all of the first ones
ERROR = 2e-15       # of closed forms: five roundings, and those of the data


def uniform_modes(member: "UniformMember", system: "ContinuousSystem", first: int, last: int,
                  divided: "dict[tuple[int, ...], ContinuousSystem]") -> list[NaturalFrequency]:
    """The natural frequencies first … last of those that bend or stretch, counted without the resting ones; divided:
    {places in SHARES, piece by piece: the system divided there}, filled as they are needed, so that modes of all calls
    share them."""
    numbers = np.arange(first, last + 1)
    squares, curves = member.squares(numbers), uniform_curves(member, numbers)
    pieces = system.ordered
    lengths = [float(one.piece.length) for one in pieces]
    places = np.array([_places(member.piece.order, member.wave_numbers(numbers) * (length / member.piece.length))
                       for length in lengths]).T
    homes = list(map(tuple, places.tolist()))
    for home in {*homes} - {*divided}:
        divided[home] = system.refined({k: system.number(SHARES[place]) for k, place in enumerate(home)})
    shapes = _shapes(system, curves, np.array(SHARES)[places])
    known = curves.each() if len(pieces) == 1 else [None] * len(numbers)
    return [NaturalFrequency(number, square, ERROR, shape, divided[home], curve) for number, square, shape, home, curve
            in zip((numbers + member.resting).tolist(), squares, shapes, homes, known, strict=True)]


def _places(order: int, phases: np.ndarray) -> Any:
    """For each βl of a piece the place in SHARES of a division whose parts are far from frequencies of their own."""
    shift, lowest = (0.0, 1.0) if order == 2 else (0.5, 1.5)
    nearest = []
    for part in SHARES:
        turns = np.array([phases * part, phases * (1 - part)]) / np.pi
        pole = np.maximum(np.round(turns - shift) + shift, lowest)
        nearest.append(np.abs(turns - pole).min(axis=0))
    return np.argmax(nearest, axis=0)


def _shapes(system: "ContinuousSystem", curves: "UniformCurves", shares: np.ndarray) -> np.ndarray:
    """Each over the coordinates of the ends of pieces, then of the nodes at shares of their lengths, (modes, pieces):
    (modes, coordinates)."""
    half, pieces = 2 if curves.bends else 1, system.ordered
    found = np.empty((len(shares), system.n + half * len(pieces)))
    begin = min(float(one.start) for one in pieces)
    for k, one in enumerate(pieces):
        start, length, at = float(one.start) - begin, float(one.piece.length), system.n + half * k
        left, inside, right = (curves.along(start + x)[:, :half] for x in (0.0, length * shares[:, k], length))
        for values, row in zip(np.concatenate([left, right], axis=1).T, one.rows, strict=True):
            for i, x in row.items():
                if x:
                    found[:, i] = values / x
        found[:, at:at + half] = inside
    return found
