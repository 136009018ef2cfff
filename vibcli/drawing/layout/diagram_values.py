"""The values that are written beside a diagram of a force or moment along a member."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.mechanics.internal_forces import InternalForce

JUMP = 1e-6         # of the largest value: what is less is none
STEP = 1e-3         # of a stretch, by which its slope is found
ASIDE = 0.98, 0.02  # of two stretches, places on both sides of the end between them


def told(force: "InternalForce") -> list[tuple[float, float]]:
    """[(place, value)] from left to right: at both ends and on both sides of jumps, where the curve is largest or
    least, between its parts too; where it is the same all along, in the middle alone."""
    least, found = JUMP * force.largest, []
    for run in _runs(force, least):
        values = [value for _, value in run]
        if max(values) - min(values) <= least:
            found.append(((run[0][0] + run[-1][0]) / 2, values[0]))
            continue
        found += [run[0], run[-1]]
        for before, here, after in zip(run, run[1:], run[2:], strict=False):
            rise, then = here[1] - before[1], after[1] - here[1]
            if abs(rise) > least and (abs(then) <= least or rise * then < 0) and abs(here[1]) > least:
                found.append(here)
    return sorted(found)


def error_of_zero(force: "InternalForce", x: float) -> float:
    """How far a place may be off at which a force changes its sign, as its values may be off."""
    stretch = next(one for one in force.stretches if x <= one.end)
    low, high = max(x - STEP * (stretch.end - stretch.start), stretch.start), min(
        x + STEP * (stretch.end - stretch.start), stretch.end)
    first, last = stretch.values(np.array([low, high]))
    off = force.error(x)
    found: float = off and off * (high - low) / max(abs(last - first), 1e-300)
    return found


def zeros(force: "InternalForce") -> list[float]:
    """The places within a member at which a force changes its sign without a jump."""
    found, least = [], JUMP * force.largest
    for stretch in force.stretches:
        found += stretch.zeros(force.largest)
    for left, right in pairwise(force.stretches):
        here = [stretch.values(np.array([left.end]))[0] for stretch in (left, right)]
        beside = [stretch.values(np.array([stretch.start + ASIDE[i] * (stretch.end - stretch.start)]))[0]
                  for i, stretch in enumerate((left, right))]
        if max(map(abs, here)) <= least and beside[0] * beside[1] < 0:
            found.append(left.end)
    return sorted(found)


def _runs(force: "InternalForce", least: float) -> list[list[tuple[float, float]]]:
    """Stretches of the curve without jumps, each the (place, value) of its ends, of extremes and of stations."""
    runs: list[list[tuple[float, float]]] = []
    for stretch in force.stretches:
        places = [stretch.start, *stretch.extremes(), stretch.end]
        points = list(zip(places, stretch.values(np.array(places)).tolist(), strict=True))
        if runs and abs(runs[-1][-1][1] - points[0][1]) <= least:
            runs[-1] += points[1:]
        else:
            runs.append(points)
    return runs
