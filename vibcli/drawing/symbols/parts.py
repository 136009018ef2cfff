"""Parts of a spring or damper: in series one behind the other, in parallel side by side between two bars, nested."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import Polyline
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import support

if TYPE_CHECKING:
    from vibcli.language.reader import Record

ROW = 15.0          # across, of each of those that stand side by side
NAMED = 10.0        # across, of a name
LEAD, MOST = 5.0, 0.12      # to a bar and from it, at most in parts of the length

Place = tuple[float, float]


def between(record: "Mapping[Any, Any] | Record", start: Place, end: Place, drawn: float, line: str,
            single: Callable[..., Any], room: float | None = None) -> list[Any]:
    """All parts of a record, single(start, end, drawn, scale) being one, `scale` across; line: the style of leads."""
    room = ROW * rows(record) if room is None else room
    if "series" in record:
        return _in_series(record["series"], start, end, drawn, line, single, room)
    if "parallel" in record:
        return _in_parallel(record["parallel"], start, end, drawn, line, single, room)
    found: list[Any] = single(start, end, drawn, min(1.0, room / ROW))
    return found


def rows(record: "Mapping[Any, Any] | Record") -> int:
    """How many of its parts stand side by side at most."""
    if "parallel" in record:
        return sum(map(rows, record["parallel"]))
    return max(map(rows, record["series"])) if "series" in record else 1


def offsets(records: "Sequence[Mapping[Any, Any] | Record]", apart: float) -> list[float]:
    """How far across each of some elements with the same ends lies, the first one on the left of their direction; of
    three or more with room for a name between them."""
    apart += NAMED * (len(records) > 2)
    widths = [max(apart, (ROW + 3) * rows(record)) if rows(record) > 1 else apart for record in records]
    return [sum(widths) / 2 - sum(widths[:i]) - width / 2 for i, width in enumerate(widths)]


def sides(t: float, among: "Sequence[Any]") -> tuple[float, ...]:
    """On which side of an element `t` across from the middle of some its name stands: 1 left of their direction, −1
    right; none where any will do."""
    return (1.0 if t > 0 else -1.0,) if len(among) > 1 and t else ()



def _weights(parts: "Sequence[Mapping[Any, Any] | Record]") -> list[int]:
    """How much of a row each part needs: what holds a row of its own needs more."""
    return [max((len(branch.get("series", ())) or 1) for branch in part.get("parallel", ()) or (part,))
            for part in parts]


def _in_series(parts: "Sequence[Mapping[Any, Any] | Record]", start: Place, end: Place, drawn: float, line: str,
               single: Callable[..., Any], room: float | None) -> list[Any]:
    at, length = plane.along(start, end), plane.distance(start, end)
    weights, done, found = _weights(parts), 0.0, []
    dots: list[Any] = []
    for part, weight in zip(parts, weights, strict=True):
        share = weight / sum(weights)
        found += between(part, at(done * length), at((done + share) * length), drawn * share, line, single, room)
        dots += support.dot(at(done * length)) if done else []
        done += share
    return found + dots


def _in_parallel(parts: "Sequence[Mapping[Any, Any] | Record]", start: Place, end: Place, drawn: float, line: str,
                 single: Callable[..., Any], room: float | None) -> list[Any]:
    at, length = plane.along(start, end), plane.distance(start, end)
    lead, steps = min(LEAD, MOST * length), [room * rows(part) / sum(map(rows, parts)) for part in parts]
    sides = [room / 2 - sum(steps[:i]) - step / 2 for i, step in enumerate(steps)]
    found: list[Any] = [Polyline((at(0), at(lead)), line), Polyline((at(length - lead), at(length)), line)]
    for place in (lead, length - lead):
        found.append(Polyline((at(place, sides[0]), at(place, sides[-1])), line))
    for part, side, step in zip(parts, sides, steps, strict=True):
        found += between(part, at(lead, side), at(length - lead, side), drawn * (1 - 2 * lead / length), line, single,
                         step)
    return found
