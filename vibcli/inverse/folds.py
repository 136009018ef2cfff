"""Limits of stability that no change of sign between two values tells: the equilibrium is followed from one value to
the next, to a limit point (fold) where it meets an unstable one and both vanish, to a branching, or to its end."""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium.continuation import Branch
from vibcli.numerics.root_finding import bracketed

if TYPE_CHECKING:
    import numpy as np

    from vibcli.inverse.conditions import ConditionSystem

SAME = 1e-6
FARTHER = 1.3       # growth over the second half of the steps of a way that vanish: what ends at a place grows by 1


class Limit(NamedTuple):
    """An equilibrium whose K is singular: the value of the parameter, {coordinate: float}, whether it is a fold, its
    lowest eigenvalue relative to K, and what is stiff along each coordinate."""

    value: float
    position: dict[str, Any]
    fold: bool
    residual: float
    felt: tuple[Any, ...]


class End(NamedTuple):
    """An equilibrium followed from one value of the parameter goes no further than another; `runs`: the coordinate
    along which it runs off, or None."""

    start: float
    value: float
    runs: str


def followed(system: "ConditionSystem", places: Sequence[float]) -> tuple[list[Limit], list[End]]:
    """([Limit], [End]) of the stable equilibria of a ConditionSystem with one parameter,
    from each of the ascending places to its neighbours."""
    limits, ends = [], []
    for a, b in pairwise(places):
        for one, other in ((a, b), (b, a)):
            found = _between(system, one, other)
            if found is None:
                break
            limits += [limit for limit in found[0] if not any(_same(limit.value, known.value) for known in limits)]
            ends += found[1]
    return limits, ends


def _same(a: float, b: float) -> bool:
    return abs(a - b) <= SAME * max(abs(a), abs(b))


def _between(system: "ConditionSystem", one: float, other: float) -> tuple[list[Limit], list[End]] | None:
    """(limits, ends) on the way from one value to another; None where the equilibria of both are on one branch."""
    here, there = (system.rest.get((value,)) for value in (one, other))
    if here is None or here.system.is_linear or here.equilibrium.drawn:
        return None if here is not None and there is not None and there.equilibrium.drawn else ([], [])
    branch = Branch(here.numeric, system.names[0])
    start = branch.start(one, here.equilibrium.values)
    if start is None or not lowest(start.K) > 0:
        return [], []
    found = branch.followed(start, other)
    if found.arrived and there is not None and branch.alike(found.place.position, there.equilibrium.values):
        return None
    changed = _branching(branch, found.way)
    if changed is not None:
        return [changed], []
    if found.arrived:
        return [], []
    fold = branch.fold(found.place)
    if fold is not None and (fold.value - found.place.value) * (other - one) > 0:
        return [_limit(branch, fold, True)], []
    return [], [End(one, found.place.value, _runs_off(branch, found))]


def _limit(branch: Branch, place: Any, fold: bool) -> Limit:
    felt = tuple(branch.size / float(scale) ** 2 for scale in branch.scale)
    return Limit(place.value, place.position, fold, abs(lowest(place.K)) / branch.size, felt)


def lowest(K: "np.ndarray") -> float:
    import numpy as np

    return float(np.linalg.eigvals(K).real.min())


def _branching(branch: Branch, way: Sequence[Any]) -> Limit | None:
    """The Limit where the lowest eigenvalue of K changes its sign on a followed way; None where it keeps it."""
    for a, b in pairwise(way):
        if lowest(b.K) <= 0:
            places = {}

            def function(value: float, start: Any = a, places: dict[float, Any] = places) -> float | None:
                found = branch.followed(start, value)
                places[value] = found.place
                return lowest(found.place.K) / branch.size if found.arrived else None

            value = bracketed(function, a.value, lowest(a.K) / branch.size, b.value, lowest(b.K) / branch.size)
            return None if value is None else _limit(branch, places.get(value, b), False)
    return None


def _runs_off(branch: Branch, found: Any) -> str | None:
    """The coordinate that grows without bound as the way ends; None where none does."""
    first, middle, last = found.way[0], found.way[len(found.way) // 2], found.place
    before, grown = abs(middle.q - first.q), abs(last.q - first.q)
    i = int(grown.argmax())
    return str(branch.names[i]) if grown[i] > FARTHER * before[i] else None
