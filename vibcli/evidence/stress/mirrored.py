"""A scene seen in a mirror: what stands or points to the right, to the left; what turns one way round, the other way.

Coordinates of pins, turns and of `move:` are counted by the axes of the picture: in the mirror they are −1 times as
large, and so they are written wherever they stand; one along a direction keeps its sign, as the direction turns. What
has a sense that nobody mirrors here is refused by its name.
"""

import re
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, cast

from vibcli.base.enumeration import listed
from vibcli.base.errors import PhysicsError
from vibcli.evidence.stress.rewritten import TOLD, WORDS, opposite
from vibcli.evidence.stress.turned_coordinates import (
    ACROSS,
    PLAIN,
    TURNS,
    drawn_members,
    lines_of,
    on_a_line,
    turned_round,
)
from vibcli.language.document.nodes import Mapping, Scalar, Sequence

AS_IT_IS = (*TOLD, "answers", "parameters", "records", "motion", "find", "damping", "variants", "choose")
BODY = ("shape", "mass", "density", "inertia", "gyration", "radius", "half_angle", "width", "height", "a", "b", "weld",
        "looks", "cut")
CONNECTION = ("k", "c", "friction", "law", "stretch", "free_length", "preload", "acts", "gap", "torsion",
              "series", "parallel")
OTHER_WAY = {"tension": "compression", "compression": "tension"}
LOPSIDED = ("sector", "arch")       # whose axis points along `angle`; others are the same after half a turn
MEMBERS = (*ACROSS, "bars", "shafts")
PLACED = frozenset(("at", "from", "to", "clamp", "weld"))       # what gives a body a place, in which it slides
TIES = ("equation", "join", "link", "rope", "point", "surface", "gear", "belt", "radii", "carrier", "inside", "crossed")
OTHER_SIDE = {"left_of": "right_of", "right_of": "left_of"}


class NotDrawn(PhysicsError):
    """Nothing of a scene has a place in the plane."""


def mirrored(top: Mapping) -> Mapping:
    """The document of the scene in the mirror; PhysicsError where something of it is not mirrored."""
    drawn = [part for name, (_, part) in top.entries.items() if name not in AS_IT_IS]
    if "matrices" in top.entries or not any(_is_place(one) for part in drawn for one in _sequences(part)):
        raise NotDrawn("nothing of it has a place in the plane")
    turned = turned_round(top)
    return _each(top, _Sections(turned, drawn_members(top), lines_of(top)).sections)


def _sequences(node: Any) -> Iterator[Sequence]:
    if isinstance(node, Sequence):
        yield node
    for part in node.items if isinstance(node, Sequence) else (
            [value for _, value in node.entries.values()] if isinstance(node, Mapping) else ()):
        yield from _sequences(part)


def _is_place(node: Sequence) -> bool:
    """Two expressions, one of which at least is no name."""
    return len(node.items) == 2 and all(isinstance(one, Scalar) for one in node.items) and not all(
        PLAIN.fullmatch(one.text.split(".")[0].strip()) for one in node.items)


def _each(node: Any, change: Callable[[str, Any], Any]) -> Mapping:
    if not isinstance(node, Mapping):
        raise PhysicsError("what is written in short is not mirrored")
    return Mapping(node.where, {name: (key, change(name, value)) for name, (key, value) in node.entries.items()})


class _Sections:
    """Each part of a scene in the mirror; `turned`: names of coordinates whose sign is another one there; `drawn`:
    members in the plane, whose displacement across is to the left of their way from end to end; `lines`: surfaces."""

    def __init__(self, turned: frozenset[str], drawn: frozenset[str] = frozenset(),
                 lines: frozenset[str] = frozenset()) -> None:
        self.turned, self.drawn, self.lines = turned, drawn, lines
        names = "|".join(map(re.escape, sorted(turned, key=len, reverse=True)))
        self._names = re.compile(rf"(?<![\w.'])({names})('*)(?![\w.(\[])") if turned else None

    def sections(self, name: str, node: Any) -> Any:
        """A section of the scene."""
        if name == "gravity":
            return self.vector(node)
        if name in AS_IT_IS:
            return node
        change: Any = {
            "bodies": self.body, "springs": partial(self.connection, "d"), "dampers": partial(self.connection, "v"),
            "forces": self.load, "points": self.point, "constraints": self.constraint, "surfaces": self.surface,
            "energies": self.expression, **dict.fromkeys(MEMBERS, self.member)}.get(name)
        if name in ("initial", "equilibrium") and isinstance(node, Mapping):
            return _each(node, self.start)
        if name == "coordinates":
            return _each(node, self.coordinate) if isinstance(node, Mapping) else node
        if change is None or not isinstance(node, Mapping):
            raise PhysicsError(f"what '{name}' is in a mirror is not told")
        return _each(node, lambda _, record: change(record))

    def expression(self, node: Any) -> Any:
        """An expression with the coordinates of the mirror."""
        if isinstance(node, (Sequence, Mapping)):
            raise PhysicsError("an expression is given by more than a text")
        text = self._names.sub(r"(-\1\2)", node.text) if self._names else node.text
        return Scalar(text, node.where, node.quoted)

    def negative(self, node: Any) -> Scalar:
        """An expression of the other sign."""
        found = self.expression(node)
        return Scalar(opposite(found.text), found.where, True)

    def vector(self, node: Any) -> Any:
        """A place or direction [x, y]; names stay as they are."""
        if not isinstance(node, Sequence):
            return node
        found = Sequence(node.where)
        found.items.extend([self.negative(node.items[0]), *map(self.expression, node.items[1:])])
        return found

    def start(self, name: str, node: Any) -> Any:
        """What a coordinate or a rate of it is at the start."""
        if name == "released":
            return node
        return self.negative(node) if name.rstrip("'") in self.turned else self.expression(node)

    def coordinate(self, name: str, record: Any) -> Any:
        """What is said of a coordinate: how large it is as drawn."""
        if not isinstance(record, Mapping) or name not in self.turned:
            return record
        return _each(record, lambda key, node: self.negative(node) if key == "drawn" else node)

    def body(self, record: Any) -> Any:
        """A body with what moves it, or one of its parts."""
        placed = not isinstance(record, Mapping) or not PLACED.isdisjoint(record.entries)
        found = _each(record, lambda name, node: node if name == "slide" and not placed else
                      self._part_of_body(name, node))
        if "shape" in found.entries and found.entries["shape"][1].text in LOPSIDED:
            key, angle = record.entries.get("angle", (Scalar("angle", record.where), Scalar("0", record.where)))
            axis = Scalar(f"pi - ({self.expression(angle).text})", record.where, True)
            found = Mapping(found.where, {**found.entries, "angle": (key, axis)})
        return found

    def member(self, record: Any) -> Any:
        """A beam, string, bar or shaft, which has ends that are drawn or no place at all."""
        return _each(record, lambda name, node: self.vector(node) if name in ("from", "to") else node)

    def _part_of_body(self, name: str, node: Any) -> Any:
        if name in BODY:
            return node
        if name in ("at", "from", "to"):
            return self.vector(node)
        if name in ("pin", "turn", "move", "slide"):
            return self._motion(name, node)
        if name == "roll":
            return _each(node, self._part_of_roll)
        if name == "angle":
            return self.negative(node)
        if name == "parts":
            return self._list(node, self.body)
        if name == "clamp":
            return _each(node, lambda _, at: self.vector(at)) if isinstance(node, Mapping) else self.vector(node)
        raise PhysicsError(f"what '{name}' of a body is in a mirror is not told")

    def _motion(self, kind: str, node: Any) -> Mapping:
        if not isinstance(node, Mapping):
            node = Mapping(node.where, {"by": (Scalar("by", node.where), node)})
        by, entries = node.entries["by"], dict(node.entries)
        on_surface = kind == "slide" and "surface" in entries
        kept = on_a_line(node, self.lines) if on_surface else kind == "slide"
        entries["by"] = by[0], self._displacement(by[1]) if kept else self._turned_by(by[1])
        if "at" in entries:
            entries["at"] = entries["at"][0], self.vector(entries["at"][1])
        if kind == "slide" and not on_surface:
            key, along = entries.get("along", (Scalar("along", node.where), _right(node.where)))
            entries["along"] = key, self.vector(along)
        return Mapping(node.where, entries)

    def _part_of_roll(self, name: str, node: Any) -> Any:
        if name in TURNS["roll"]:
            return self._turned_by(node)
        if name == "flat":
            return self._ends(node)
        if name not in ("surface", "between", "radius", "travel"):
            raise PhysicsError(f"what '{name}' of what rolls is in a mirror is not told")
        return self._displacement(node) if name == "travel" else node

    def surface(self, record: Any) -> Any:
        """A line, a circle or the curve y = f(x), in the mirror f(−x)."""
        def part(name: str, node: Any) -> Any:
            if name == "curve":
                return _of_negative(node, record.entries["in"][1].text.strip())
            return self._ends(node) if name == "line" else self.vector(node) if name == "circle" else node

        return _each(record, part)

    def _displacement(self, node: Any) -> Scalar:
        return cast("Scalar", node if PLAIN.fullmatch(node.text.strip()) else self.expression(node))

    def _turned_by(self, node: Any) -> Any:
        if isinstance(node, Sequence):
            found = Sequence(node.where)
            found.items.extend(self._turned_by(one) if place % 2 == 0 else self._displacement(one)
                               for place, one in enumerate(node.items))
            return found
        return node if node.text.strip() in self.turned or node.text.strip() == "0" else self.negative(node)

    def connection(self, letter: str, record: Any) -> Any:
        """A spring or a damper, whose law is a function of the letter."""
        found = _each(record, partial(self._part_of_connection, letter))
        if "torsion" in found.entries:
            found = _each(found, partial(_part_of_torsion, letter))
        key, preload = found.entries.get("preload", (None, None))
        if "torsion" in found.entries and preload is not None and preload.text not in WORDS:
            found = Mapping(found.where, {**found.entries, "preload": (key, self.negative(preload))})
        return found

    def _part_of_connection(self, letter: str, name: str, node: Any) -> Any:
        if name == "between":
            return self._list(node, self.vector)
        if name not in CONNECTION:
            raise PhysicsError(f"what '{name}' of a spring or damper is in a mirror is not told")
        return self.expression(node) if isinstance(node, Scalar) else node if name == "law" else self._list(
            node, partial(self.connection, letter))

    def load(self, record: Any) -> Any:
        """A force or a moment."""
        if not isinstance(record, Mapping):
            raise PhysicsError("a load that is written in short is not mirrored")
        if "unbalance" in record.entries:
            return self._unbalance(record)
        if "per_length" in record.entries:
            across = record.entries["body"][1].text.strip() in self.drawn
            return _each(record, lambda name, node: self.negative(node) if name == "per_length" and across else node)
        of = record.entries.get("coordinate", (None, Scalar("", record.where)))[1]
        other = of.text.strip() in self.turned
        return _each(record, lambda name, node: (
            self.negative(node) if name == "moment" or (name == "value" and other)
            else self.vector(node) if isinstance(node, Sequence)
            else self.expression(node) if name in ("force", "value") else node))

    def _unbalance(self, record: Any) -> Mapping:
        """u Ω² (−cos Ωt, sin Ωt), which turns the other way."""
        if record.entries.keys() != {"at", "unbalance", "speed"}:
            raise PhysicsError("an unbalance is mirrored by its 'at', 'unbalance' and 'speed' alone")
        u, speed = (f"({record.entries[name][1].text})" for name in ("unbalance", "speed"))
        force = Sequence(record.where)
        force.items.extend(Scalar(f"{sign}{u}*{speed}^2*{wave}({speed}*t)", record.where, True)
                           for sign, wave in (("-", "cos"), ("", "sin")))
        return Mapping(record.where, {"at": record.entries["at"], "force": (Scalar("force", record.where), force)})

    def constraint(self, record: Any) -> Any:
        """What ties motions together: gears and belts turn against each other as before."""
        if isinstance(record, Scalar):
            return self.expression(record)
        if not isinstance(record, Mapping) or not record.entries.keys() <= set(TIES):
            raise PhysicsError(f"of constraints {listed(TIES)} are mirrored")
        return _each(record, lambda name, node: self.expression(node) if name == "equation" else
                     self._ends(node) if isinstance(node, Sequence) and name != "point" else self.vector(node))

    def _ends(self, node: Any) -> Sequence:
        return self._list(node, lambda one: self._guide(one) if isinstance(one, Mapping) else self.vector(one))

    def _list(self, node: Any, change: Callable[[Any], Any]) -> Sequence:
        found = Sequence(node.where)
        found.items.extend(map(change, node.items))
        return found

    def _guide(self, record: Any) -> Mapping:
        """A pulley that a rope passes, on its other side."""
        return Mapping(record.where, {OTHER_SIDE.get(name, name): (key, self.vector(node))
                                      for name, (key, node) in record.entries.items()})

    def point(self, record: Any) -> Any:
        """A point, fixed or carried."""
        if isinstance(record, Sequence):
            return self.vector(record)
        return _each(record, lambda name, node: self.vector(node) if name in ("at", "moves") else node)


def _of_negative(node: Any, name: str) -> Scalar:
    """An expression of a variable at its negative."""
    text = re.sub(rf"(?<![\w.'])({re.escape(name)})('*)(?![\w.(\[])", r"(-\1\2)", node.text)
    return Scalar(text, node.where, node.quoted)


def _part_of_torsion(letter: str, name: str, node: Any) -> Any:
    """−F(−d) of a law F(d), −F(−v) of a damper: it turns the other way round."""
    if name in ("law", "acts") and not isinstance(node, Scalar):
        raise PhysicsError("a torsion whose law is a table is not mirrored")
    if name == "law":
        return Scalar(opposite(_of_negative(node, letter).text), node.where, True)
    return Scalar(OTHER_WAY.get(node.text, node.text), node.where) if name == "acts" else node


def _right(where: Any) -> Sequence:
    """[1, 0]"""
    found = Sequence(where)
    found.items.extend([Scalar("1", where), Scalar("0", where)])
    return found
