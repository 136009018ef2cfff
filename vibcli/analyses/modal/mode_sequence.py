"""Modes in order, as many as there are: a list, or found as they are asked for.

A member with distributed inertia has modes without end, and of very many coordinates the lowest modes alone are found.
Nothing walks through them all: it asks for one, for the first few, for those up to a frequency, or for those that are
shown.
"""

from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from math import inf
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.damped_far import Annulus
    from vibcli.analyses.continuous.damped_source import Region
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode

USUAL = 5           # that oscillate, where nobody says how many
MOST = 10_000       # at once
FAR = 50            # beyond those that are known, to be found without the ones between
_index = attrgetter("index")
FEW = 20            # asked for at once, with which one more is found where shapes are told apart from the next


class NoMoreTold(PhysicsError):
    """Modes are asked for beyond those that can be told."""


class Selection(NamedTuple):
    """Modes that are asked for: from index `first` to `last`, or all up to the angular frequency `up_to`."""

    first: int = 1
    last: int = 0
    up_to: float | None = None


class Modes(Sequence[Any]):
    """Modes by ascending index, undamped or damped, their places counted from 0 as in a list. finite: are they a list?

    Where they are none a `source` finds them: source.numbered(first, last) those of the indices from `first` to
    `last`, counted from 1, source.count(Omega) how many have ω ≤ Omega, those that grow and the rigid ones among them.
    What needs all of them is refused then.
    """

    __slots__ = ("_apart", "_known", "_solved", "_source", "finite")

    def __init__(self, known: "Sequence[Mode | DampedMode]", source: Any = None,
                 solved: Callable[..., Any] | None = None) -> None:
        """All of them, or the first and a source; `solved(find, *args)` runs what finds more as a task."""
        self._known: list[Any] = list(known)
        self._source, self._apart = source, {}
        self._solved, self.finite = solved or _run, source is None

    def __len__(self) -> int:
        return len(self._all())

    def __iter__(self) -> Iterator[Any]:
        return iter(self._all())

    def __bool__(self) -> bool:
        return not self.finite or bool(self._known)

    def __getitem__(self, place: Any) -> Any:
        if self.finite:
            return self._known[place]
        last = place.stop if isinstance(place, slice) else place + 1
        if last is None or last < 0 or place == -1:
            self._refuse_all()
        return self._until(last)[place]

    def first(self, count: int) -> list[Any]:
        """Those up to the index `count`, fewer where there are no more, or no more are told."""
        try:
            return self.numbered(1, count)
        except NoMoreTold:
            return self._between(1, count)

    def numbered(self, first: int, last: int) -> list[Any]:
        """Those of the indices from `first` to `last`, fewer where there are no more."""
        if not self.finite:
            if last - max(first - 1, self._reached) > MOST:
                raise _too_many(last - first + 1)
            if first > self._reached + FAR:
                return self._jumped(first, last)
            self._until(last)
            self._until(first)      # says why where none of them is told
        return self._between(first, last)

    def alone(self, index: int) -> Any:
        """The one of an index, found without those before it where they are not known."""
        if self.finite or index <= self._reached:
            return self.numbered(index, index)[0]
        return self._jumped(index, index)[0]

    def up_to(self, Omega: float) -> list[Any]:
        """All with ω ≤ Omega, those that grow and the rigid ones among them."""
        if self.finite:
            return [mode for mode in self._known if not mode.omega or mode.omega * (1 - mode.error) <= Omega]
        return self.first(self._solved(self._source.count, Omega))

    def between(self, low: float, high: float) -> list[Any]:
        """All with low < ω ≤ high, however many, found without those far before."""
        if self.finite:
            return [mode for mode in self.up_to(high) if (mode.omega or 0.0) > low]
        below, last = (self._solved(self._source.count, Omega) for Omega in (low, high))
        return [mode for first in range(below + 1, last + 1, MOST)
                for mode in self.numbered(first, min(first + MOST - 1, last))]

    def shown(self, asked: Selection | None = None) -> list[Any]:
        """Those asked for; else all, or without end those that grow, the rigid ones and five more, of damped ones no
        more than 20 beyond those shown without dampers: a damper that drives makes modes grow without end."""
        if asked is not None:
            return self.numbered(asked.first, asked.last) if asked.up_to is None else self.up_to(asked.up_to)
        if self.finite:
            return list(self._known)
        found, count, wanted = [], 0, USUAL
        most = getattr(self._source, "most_shown", inf)
        while count < wanted and count < most:
            count, found = wanted, self.first(wanted)
            wanted = USUAL + len({mode.index for mode in found if not mode.omega or mode.growth_rate is not None})
        return found

    @property
    def ground(self) -> Any:
        """How many grow and how many do not oscillate, told by counts, without modes, where these have no end."""
        return self._source.ground

    @property
    def grow(self) -> bool:
        """Do some grow?"""
        if self.finite:
            return any(mode.growth_rate is not None for mode in self._known)
        return bool(self.ground.growing)

    def counted_above(self, mode: "Mode") -> int | None:
        """How many modes have at most the frequency of this one, certain by a count just above it; None where that
        does not tell, or the modes are a list."""
        found: int | None = None if self.finite else self._solved(self._source.counted_above, mode)
        return found

    @property
    def region(self) -> "Region | None":
        """Of damped modes without end the circle up to which all are known; None where the modes are a list."""
        found: Region | None = getattr(self._source, "region", None)
        return found

    def proof(self, found: "Sequence[DampedMode]") -> "Region | Annulus | None":
        """Of damped modes without end what tells that none of these is missing; None where the modes are a list."""
        if not found or self.finite:
            return None
        proof: Region | Annulus | None = self._source.proof(found[0].index, found[-1].index)
        return proof

    def _between(self, first: int, last: int) -> list[Any]:
        """Those known of the indices from `first` to `last`."""
        start = bisect_left(self._known, first, key=_index)
        return self._known[start:bisect_left(self._known, last + 1, start, key=_index)]

    @property
    def _reached(self) -> int:
        """The index up to which all are known."""
        return self._known[-1].index if self._known else 0

    def _jumped(self, first: int, last: int) -> list[Any]:
        """Those of the indices from `first` to `last`, without those before."""
        if (first, last) not in self._apart:
            self._apart[first, last] = list(self._solved(self._source.numbered, first, last))
        found: list[Any] = self._apart[first, last]
        return found

    def _until(self, last: int) -> list[Any]:
        """Those known, up to the index `last` at least."""
        if last > self._reached:
            ahead = getattr(self._source, "ahead", 0) if last <= FEW else 0
            self._known.extend(self._solved(self._source.numbered, self._reached + 1, last + ahead))
        return self._known

    def _all(self) -> list[Any]:
        if not self.finite:
            self._refuse_all()
        return self._known

    def _refuse_all(self) -> None:
        """The refusal of what needs all modes where they are found as they are asked for."""
        if hasattr(self._source, "require_all"):
            self._source.require_all()
        raise PhysicsError("a member with distributed inertia has modes without end: what needs all of them is not "
                           "found", "ask for some of them, as omega[1] or find: [{modes: 5}]")


def _run(find: Callable[..., Any], *args: Any) -> Any:
    found: int | list[Mode] = find(*args)
    return found


def _too_many(count: int) -> PhysicsError:
    return PhysicsError(f"{count} modes are asked for; at most {MOST} are found at once",
                        "ask for fewer, as find: [{modes: [990, 1000]}]")
