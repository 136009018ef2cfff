"""Steps of a path on which the rate p′ of the parameter comes near to zero and back: does it change its sign between?

Two limit points next to each other, as where a path nearly has a level inflection, may lie within one step. Where |p′|
has a least value over some steps it is sought there, and a step that holds two limit points is cut in two.
"""

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from vibcli.analyses.limit_points.path import EquilibriumPath
from vibcli.analyses.limit_points.path_step import PathStep

if TYPE_CHECKING:
    from vibcli.analyses.limit_points.path_step import PathPoint

PARTS, TRIALS, NARROW, GOLDEN = 8, 24, 1e-4, 0.3819660112501051


def cut_at_dips(path: EquilibriumPath, steps: Iterable[PathStep]) -> Iterator[PathStep]:
    """The steps, those with two limit points in two."""
    before, dip = None, False
    for step in (part for whole in steps for part in _looked_into(path, whole)):
        if before is None:
            before = step
            continue
        least = _is_least(before, step)
        yield from _cut(path, before) if dip or least else (before,)
        before, dip = step, least
    if before is not None:
        yield from _cut(path, before) if dip else (before,)


def _looked_into(path: EquilibriumPath, step: PathStep) -> list[PathStep]:
    """A step on which p turns back in short parts: it may do so three times."""
    if (_rate(step.start) < 0) == (_rate(step.end) < 0) or step.corner or step.branching:
        return [step]
    points = [step.start, *(path.corrected(step.start, step.step * i / PARTS) for i in range(1, PARTS)), step.end]
    if any(point is None for point in points):
        return [step]
    return [PathStep(one, other, float((other.y - one.y) @ one.tangent), False) for one, other in pairwise(points)]


def _rate(point: "PathPoint") -> float:
    return float(point.tangent[-1])


def _is_least(one: PathStep, other: PathStep) -> bool:
    """Is |p′| between two steps less than before and after, without a change of its sign?"""
    a, b, c = _rate(one.start), _rate(one.end), _rate(other.end)
    return (a < 0) == (b < 0) == (c < 0) and abs(b) <= min(abs(a), abs(c))


def _cut(path: EquilibriumPath, step: PathStep) -> tuple[PathStep, ...]:
    """By golden section: a point at which p′ has the other sign, if there is one."""
    sign = 1.0 if _rate(step.start) > 0 else -1.0
    if sign * _rate(step.end) <= 0 or step.corner or step.branching:
        return (step,)
    low, high, inner, at_inner = 0.0, step.step, None, 0.0
    for _ in range(TRIALS):
        trial = low + GOLDEN * (high - low) if inner is None else (
            inner + GOLDEN * (high - inner) if high - inner > inner - low else inner - GOLDEN * (inner - low))
        point = path.corrected(step.start, trial)
        if point is None:
            break
        there = sign * _rate(point)
        if there < 0:
            return _halves(path, step, point, trial)
        if inner is None or there < at_inner:
            if inner is not None:
                low, high = (inner, high) if trial > inner else (low, inner)
            inner, at_inner = trial, there
        else:
            low, high = (low, trial) if trial > inner else (trial, high)
        if high - low < NARROW * step.step:
            break
    return (step,)


def _halves(path: EquilibriumPath, step: PathStep, point: "PathPoint", reached: float) -> tuple[PathStep, ...]:
    rest = float((step.end.y - point.y) @ point.tangent)
    end = path.corrected(point, rest)
    if end is None:
        return (step,)
    return PathStep(step.start, point, reached, False), PathStep(point, end, rest, False)
