"""All zeros of the force of one coordinate between bounds.

The range is cut into cells, each halved until F shows no zero there, or is monotone with a change of sign, or vanishes
throughout but for rounding. A cell is judged by F and its derivative J at both ends and in the middle, so that double
zeros and close pairs are seen where F does not change sign. A pole changes sign too, but F is not small there.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place

CELLS, WIDEST = 256, 16           # cells a turn, or a length of 2π times the figure; turns up to which they are added
NARROW, WIDE, STEEP = 1e-10, 1e-2, 1e3
AT_END = 1e-8                     # of a stretch: a kink there is no zero of its own
EDGE = {False: 1e-6, True: 1e-4}  # how far cells are cut where forces end, or loops can no longer be closed


def zeros(forces: "Forces", low: float, high: float,
          finest: float = 1) -> "list[tuple[Place, tuple[float, float] | None]]":
    """[(place, (from, to) or None)]: isolated zeros, and stretches along which no force acts; `finest`: the least
    part of a turn that is cut into as many cells as a part of it holds."""
    cells = int(CELLS * np.clip((high - low) / math.tau, finest, WIDEST))
    edges = _edges(forces, np.linspace(low, high, cells + 1))
    found, flat = [], []
    for a, b in pairwise(edges):
        _search(forces, a, b, found, flat)
    stretches = [_stretch(forces, *group) for group in _joined(flat)]
    ends = [ends for _, ends in stretches if ends is not None]
    return [(place, None) for place, _ in found
            if not any(a - AT_END <= place.where[0] <= b + AT_END for a, b in ends)] + stretches


def _edges(forces: "Forces", points: np.ndarray) -> "list[tuple[float, Place]]":
    """[(z, place)] outwards from the drawn position; where a loop cannot close, it is not followed beyond."""
    middle = int(np.searchsorted(points, forces.vector(forces.numeric.drawn_floats)[0]))
    places = dict.fromkeys(range(len(points)))
    for way in (range(middle, len(points)), range(middle - 1, -1, -1)):
        for i in way:
            places[i] = forces.at(points[i:i + 1])
            if places[i] is None and forces.looped:
                break
    return [(z, places[i]) for i, z in enumerate(points)]


def _search(forces: "Forces", a: "tuple[float, Place | None]", b: "tuple[float, Place]",
            found: "list[tuple[Place, None]]", flat: "list[tuple[Place, Place]]") -> None:
    """Appends the zeros between two (z, place) to `found`, and (place, place) where F vanishes throughout to `flat`."""
    left = [(a, b)]
    while left:
        a, b = left.pop()
        middle = 0.5 * (a[0] + b[0])
        m, wide = (middle, forces.at(np.array([middle]))), b[0] - a[0]
        cell = (a[1], m[1], b[1])
        if any(place is None for place in cell):
            if wide > EDGE[forces.looped] and any(place is not None for place in cell):
                left += [(m, b), (a, m)]
        elif all(map(forces.balanced, cell)):
            flat.append((a[1], b[1]))
        elif _monotone(cell, wide) or (wide <= NARROW and not _empty(cell, wide)):
            crossing = a[1].F[0] * b[1].F[0] <= 0
            place = zero_between(forces, a[1], b[1]) if crossing else min(cell, key=lambda p: abs(p.F[0]))
            if place is not None and forces.balanced(place):
                found.append((place, None))
        elif not _empty(cell, wide):
            left += [(m, b), (a, m)]


def _empty(cell: "tuple[Place, Place, Place]", wide: float) -> bool:
    """Is F too large at all three places to vanish between them, its slope being what it is? So it is near a pole."""
    F, J = [place.F[0] for place in cell], [abs(place.J[0][0]) for place in cell]
    if wide < WIDE and min(map(abs, F)) > STEEP:
        return True
    return (min(F) > 0 or max(F) < 0) and min(map(abs, F)) > max(J) * wide and _smooth(cell, wide)


def _monotone(cell: "tuple[Place, Place, Place]", wide: float) -> bool:
    J = [place.J[0][0] for place in cell]
    return (min(J) > 0 or max(J) < 0) and min(map(abs, J)) > 0.25 * max(map(abs, J)) and _smooth(cell, wide)


def _smooth(cell: "tuple[Place, Place, Place]", wide: float) -> bool:
    """Do the differences of F agree with its slopes (Simpson's rule)?"""
    (a, m, b), J = (place.F[0] for place in cell), [place.J[0][0] for place in cell]
    rounding = 1e-13 * max(place.size[0] for place in cell)
    return (abs(b - a - wide * (J[0] + 4 * J[1] + J[2]) / 6) <= 0.1 * wide * max(map(abs, J)) + rounding
            and abs(m - a - wide * (J[0] + J[1]) / 4) <= 0.2 * wide * max(map(abs, J)) + rounding)


def zero_between(forces: "Forces", a: "Place", b: "Place", slope: bool = False) -> "Place":
    """The place between two where F (or its slope) changes sign, by Newton's method kept within the bracket."""
    def f(place: "Place") -> float:
        return place.J[0][0] if slope else place.F[0]

    for place in (a, b):
        if f(place) == 0:
            return place
    best = min(a, b, key=lambda place: abs(f(place)))
    for _ in range(200):
        low, high, z = a.where[0], b.where[0], best.where[0]
        there = z - f(best) / best.J[0][0] if not slope and best.J[0][0] else low
        if there == z:
            break
        if not low < there < high:
            there = 0.5 * (low + high)
        trial = None if there in (low, high) else forces.at([there])
        if trial is None:
            break
        if f(trial) == 0:
            return trial
        a, b = (trial, b) if f(trial) * f(a) > 0 else (a, trial)
        best = min(a, b, key=lambda place: abs(f(place)))
    return best


def _joined(flat: "Sequence[tuple[Place, Place]]") -> "list[tuple[Place, Place]]":
    """Stretches of adjacent flat cells: [(first place, last place)]."""
    groups = []
    for a, b in sorted(flat, key=lambda cell: cell[0].where[0]):
        if groups and groups[-1][1] is a:
            groups[-1] = (groups[-1][0], b)
        else:
            groups.append((a, b))
    return groups


def _stretch(forces: "Forces", a: "Place", b: "Place") -> "tuple[Place, tuple[float, float] | None]":
    """A stretch of neutral places, by the one nearest to the drawn position; of a short one the multiple zero in it."""
    if b.where[0] - a.where[0] > WIDE:
        return forces.at(np.clip(forces.vector(forces.numeric.drawn_floats), a.z, b.z)), (a.where[0], b.where[0])
    if a.J[0][0] * b.J[0][0] < 0:
        return zero_between(forces, a, b, slope=True), None
    return forces.at(0.5 * (a.z + b.z)), None
