"""Places along a member: its ends, steps of section, and all that stands somewhere on it."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.member_ends import HOLDS
from vibcli.elements.member_fields import MemberKind, members_of
from vibcli.language.member_signals import oscillator_parts

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from vibcli.base.errors import Where
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.language.reader import Record
    from vibcli.language.spec import Spec
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

ROUNDING = 1e-9         # of the length of a member: places nearer than that are one
OBLIQUE = re.compile(r"-?(?P<r>[^\W\d]\w*)\*(?P<function>cos|sin)\((?P<angle>[^()]+)\)")     # r*cos(alpha)
ALIKE = 1e-12           # of the length: what no rounding of places leaves between them


class PlaceAlong(NamedTuple):
    """A place on a member, as it is written; the ends that stand there, as [fields of `left` or `right`], and records
    of what is attached."""

    node: "Node"
    text: str
    where: "Where"
    ends: "list[Record | str]"
    attached: "list[Record]"


def left_text(spec: "Spec") -> str:
    """The left end of a member as a place."""
    return spec.example("0 m")


def right_text(record: "Record") -> str:
    """The right end of a member as a place: its length as written, or the sum of its segments."""
    if "length" in record:
        text: str = record["length"].text
        return text
    if "segments" not in record:
        return _drawn_length(record)
    return " + ".join(segment["length"].text for segment in record["segments"])


def _drawn_length(record: "Record") -> str:
    """How far the ends of a member lie apart as drawn: one coordinate, r of r cos α and r sin α, or by Pythagoras."""
    ends: list[list[str]] = [[part.text.strip() for part in record[key]] for key in ("from", "to")]
    if any(len(end) != 2 for end in ends):      # a name that is no point: refused where places are found
        return "0"
    apart = [i for i in (0, 1) if ends[0][i] != ends[1][i]]
    from_zero = len(apart) == 1 and ends[0][apart[0]].partition(" ")[0] == "0"
    if from_zero:
        return ends[1][apart[0]].removeprefix("-").strip()
    parts = [ends[1][i] if ends[0][i].partition(" ")[0] == "0" else f"{ends[1][i]} - ({ends[0][i]})" for i in apart]
    squares = [f"{part}^2" if part.isidentifier() else f"({part})^2" for part in parts]
    return _radius(parts) or f"sqrt({' + '.join(squares)})"


def _radius(parts: list[str]) -> str | None:
    """r of r cos α and r sin α, in either order."""
    found = [one.group("r", "angle", "function") for one in map(OBLIQUE.fullmatch, parts) if one]
    if len(found) == 2 and found[0][:2] == found[1][:2] and found[0][2] != found[1][2]:
        return str(found[0][0])
    return None


def asked_places(name: str, spec: "Spec") -> "Iterator[Any]":
    """Fields with places on the member `name`: of what is attached, of its points, and of other members held to it."""
    record = members_of(spec)[name][1]
    for attached in record.get("attached", ()):
        yield attached["at"]
    for point in (spec.get("member_points") or {}).values():
        if point["body"].text == name:
            yield point["at"]
    for load in (spec.get("forces") or {}).values():
        if "per_length" in load and load["body"].text == name:
            yield from (load[key] for key in ("from", "to") if key in load)
    for _, other in members_of(spec).values():
        for side in ("left", "right"):
            end = other.get(side)
            if end is not None and not isinstance(end, str) and "at" in end and any(
                    end[word].text == name for word in HOLDS if word in end):
                yield end["at"]


def places_of(name: str, record: "Record", segments: "Sequence[MemberSegment]", scene: "Builder") -> list[PlaceAlong]:
    """All Places of a member from left to right; those that are one by rounding are one, the ends first."""
    start, end = segments[0].start, segments[-1].end
    found = [PlaceAlong(start, left_text(scene.spec), record.where, [record.get("left", "free")], []),
             PlaceAlong(end, right_text(record), record.where, [record.get("right", "free")], [])]
    length = scene.number(end)
    attached = {id(part["at"]): part for part in record.get("attached", ())}
    for expression in asked_places(name, scene.spec):
        node = scene.lower(expression)
        here = [attached[id(expression)]] if id(expression) in attached else []
        x = scene.number(node)
        if not -ROUNDING * length <= x <= (1 + ROUNDING) * length:
            at, whole = scene.figures(node, end)
            scene.report(expression.where, f"'{expression.text}' is {at} m along '{name}', which is {whole} m long",
                         "places count from its left end")
            continue
        _add(found, PlaceAlong(node, expression.text, expression.where, [], here), x, length, scene)
    texts = []
    for segment in segments[:-1]:
        texts.append(segment.text)
        _add(found, PlaceAlong(segment.end, " + ".join(texts), record.where, [], []), scene.number(segment.end), length,
             scene)
    return sorted(found, key=lambda place: scene.number(place.node))


def _add(found: list[PlaceAlong], place: PlaceAlong, x: float, length: float, scene: "Builder") -> None:
    same = next((other for other in found if abs(scene.number(other.node) - x) <= ROUNDING * length), None)
    if same is None:
        found.append(place)
    else:
        apart = abs(scene.number(same.node) - x)
        if apart > ALIKE * length:
            scene.report(place.where, f"'{place.text}' is {apart:.3g} m away from '{same.text}', on a member of "
                         f"{length:.6g} m: too near to be another place", f"write '{same.text}' for both")
        same.attached.extend(place.attached)


def motions_of(spec: "Spec") -> "Iterator[tuple[str, bool]]":
    """(name, is it an angle?) of every coordinate that members may have: u or φ, and slopes, at their places."""
    for name, (kind, record) in members_of(spec).items():
        texts = [left_text(spec), right_text(record), *(place.text for place in asked_places(name, spec))]
        lengths = [segment["length"].text for segment in record.get("segments", ())]
        texts += [" + ".join(lengths[:i]) for i in range(1, len(lengths))]
        for text in dict.fromkeys(texts):
            yield from _named(name, kind, text)
            yield from ((f"{name}.{part}({text})", kind.torsional) for part in oscillator_parts(record))


def _named(name: str, kind: MemberKind, text: str) -> "Iterator[tuple[str, bool]]":
    yield f"{name}.{kind.motion}({text})", kind.torsional
    yield f"{name}.along({text})", False
    if kind.bends:
        yield f"{name}.slope({text})", True
