"""The indices of the equilibria found against the degree on the bounds: where they differ, at least one is missing.

An equilibrium at which J is proved to be regular has the index sign det J; within bounds the indices of all sum to the
degree of the forces there. That they do is no proof that none is missing: two of opposite indices may be.
"""

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium.completeness import ForceBounds, outside
from vibcli.mechanics.equilibrium.degree import degree
from vibcli.mechanics.equilibrium.eigenvector_following import look_for
from vibcli.mechanics.equilibrium.scaled_forces import Forces, TooMuch

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.distinct_roots import Found

T = TypeVar("T")
PIECES, ROUNDS, PLACES, AWAY = 20_000, 10, 20_000, 1e-9


class Indices(NamedTuple):
    """The sum of the indices of those found, and the degree."""

    sum: int
    degree: int

    @property
    def agree(self) -> bool:
        return self.sum == self.degree


def compared(forces: Forces, found: "Found") -> Indices | None:
    """The Indices of what is found, more being searched for where they do not agree; None where either is unknown."""
    if forces.looped or found.full:
        return None
    try:
        enclosed = ForceBounds(forces)
    except (KeyError, ArithmeticError):
        return None
    total = _sum(enclosed, found)
    asked = None if total is None else within_limit(forces, "the degree of the forces on the bounds", PIECES,
                                                     lambda: degree(enclosed, *found.box))
    if asked is None:
        return None
    if total != asked:
        within_limit(forces, "the search for what is missing", PLACES, lambda: _missing(enclosed, found, asked))
        total = _sum(enclosed, found)
    return None if total is None else Indices(total, asked)


def _missing(enclosed: ForceBounds, found: "Found", asked: int) -> None:
    """Search on until the indices agree, or are no longer known, or nothing new turns up."""
    for _ in range(ROUNDS):
        total = _sum(enclosed, found)
        if total in (asked, None) or not look_for(enclosed.forces, found, asked - total):
            return


def within_limit(forces: Forces, what: str, limit: int, act: Callable[[], T]) -> T | None:
    """What an act returns, None where it takes more steps than its limit or finds more than can be listed."""
    with forces.work.task(what, limit) as task, task.kept(), suppress(TooMuch):
        return act()
    return None


def _sum(enclosed: ForceBounds, found: "Found") -> int | None:
    """The sum of the indices of what is found; None where one of them is not known, lies on the bounds or is no place
    of its own."""
    low, high = found.box
    total, regions = 0, []
    for place in found.isolated:
        inside = enclosed.forces.periodic | ((place.z > low + AWAY) & (place.z < high - AWAY))
        region = enclosed.region(place.z) if inside.all() else None
        if region is None or not len(outside(place.z[None], place.z[None], regions)[0]):
            return None
        regions.append(region)
        total += int(np.linalg.slogdet(place.J)[0])
    return None if found.families else total
