"""A scene seen in a mirror: what stands or points to the right, to the left; what turns one way round, the other way.

Coordinates of pins, turns and of `move:` are counted by the axes of the picture: in the mirror they are −1 times as
large, and so they are written wherever they stand; one along a direction keeps its sign, as the direction turns. What
has a sense that nobody mirrors here is refused by its name.
"""

import re
from collections.abc import Callable, Iterator
from typing import Any

from vibcli.base.errors import PhysicsError
from vibcli.evidence.stress.rewritten import TOLD
from vibcli.language.document.nodes import Mapping, Scalar, Sequence

AS_IT_IS = (*TOLD, "answers", "parameters", "records", "motion", "find", "damping", "variants")
BODY = ("shape", "mass", "density", "inertia", "gyration", "radius", "width", "height", "a", "b", "weld", "looks")
CONNECTION = ("k", "c", "friction", "law", "stretch", "free_length", "preload", "acts", "gap", "torsion")
SENSES = ("law", "preload", "gap", "acts")      # of a torsion, what tells one sense from the other
LOPSIDED = ("sector", "arch")
TURNS = {"pin": ("by",), "turn": ("by",), "move": ("by",), "roll": ("turn", "swing")}
TIES = {"equation", "join", "link", "rope", "point", "surface"}
OTHER_SIDE = {"left_of": "right_of", "right_of": "left_of"}
EXPONENT = re.compile(r"(?<![^\W\d])[\d.][eE]$")
PLAIN = re.compile(r"[^\W\d]\w*")


class NotDrawn(PhysicsError):
    """Nothing of a scene has a place in the plane."""


def mirrored(top: Mapping) -> Mapping:
    """The document of the scene in the mirror; PhysicsError where something of it is not mirrored."""
    if not any(map(_is_place, _sequences(top))):
        raise NotDrawn("nothing of it has a place in the plane")
    turned = turned_round(top)
    return _each(top, _Sections(turned).sections)


def turned_round(top: Mapping) -> frozenset[str]:
    """The names of coordinates that have the other sign in the mirror."""
    found: set[str] = set()
    bodies = top.entries.get("bodies", (None, None))[1]
    for _, record in bodies.entries.values() if isinstance(bodies, Mapping) else ():
        for kind, keys in TURNS.items():
            motion = record.entries.get(kind, (None, None))[1] if isinstance(record, Mapping) else None
            for key in keys if isinstance(motion, Mapping) else keys[:1]:
                found |= _names(motion.entries.get(key, (None, None))[1] if isinstance(motion, Mapping) else motion)
    return frozenset(found)


def _names(motion):
    """Of a motion, or of [x, y, phi], those that are counted by the axes."""
    parts = motion.items[::2] if isinstance(motion, Sequence) else [motion]
    return {part.text.strip() for part in parts if isinstance(part, Scalar) and PLAIN.fullmatch(part.text.strip())}


def _sequences(node: Any) -> Iterator[Sequence]:
    if isinstance(node, Sequence):
        yield node
    for part in node.items if isinstance(node, Sequence) else (
            [value for _, value in node.entries.values()] if isinstance(node, Mapping) else ()):
        yield from _sequences(part)


def _is_place(node):
    """Two expressions, one of which at least is no name."""
    return len(node.items) == 2 and all(isinstance(one, Scalar) for one in node.items) and not all(
        PLAIN.fullmatch(one.text.split(".")[0].strip()) for one in node.items)


def _each(node: Any, change: Callable[[str, Any], Any]) -> Mapping:
    if not isinstance(node, Mapping):
        raise PhysicsError("what is written in short is not mirrored")
    return Mapping(node.where, {name: (key, change(name, value)) for name, (key, value) in node.entries.items()})


class _Sections:
    """Each part of a scene in the mirror; `turned`: names of coordinates whose sign is another one there."""

    def __init__(self, turned: frozenset[str]):
        self.turned = turned
        names = "|".join(map(re.escape, sorted(turned, key=len, reverse=True)))
        self._names = re.compile(rf"(?<![\w.'])({names})('*)(?![\w.(\[])") if turned else None

    def sections(self, name: str, node: Any) -> Any:
        """A section of the scene."""
        if name == "gravity":
            return self.vector(node)
        if name in AS_IT_IS:
            return node
        change = {"bodies": self.body, "springs": self.connection, "dampers": self.connection, "forces": self.load,
                  "points": self.point, "constraints": self.constraint, "surfaces": self.surface,
                  "energies": self.expression}.get(name)
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
        """A body with what moves it."""
        shape = record.entries.get("shape", (None, None))[1] if isinstance(record, Mapping) else None
        if isinstance(shape, Scalar) and shape.text in LOPSIDED:
            raise PhysicsError(f"how the shape '{shape.text}' stands in a mirror is not told")
        return _each(record, self._part_of_body)

    def _part_of_body(self, name, node):
        if name in BODY:
            return node
        if name in ("at", "from", "to"):
            return self.vector(node)
        if name in ("pin", "turn", "move", "slide"):
            return self._motion(name, node)
        if name == "roll":
            return _each(node, self._part_of_roll)
        if name == "angle":
            return self.negative(node)      # of what is the same after half a turn
        raise PhysicsError(f"what '{name}' of a body is in a mirror is not told")

    def _motion(self, kind, node):
        if not isinstance(node, Mapping):
            node = Mapping(node.where, {"by": (Scalar("by", node.where), node)})
        if kind == "slide" and "surface" in node.entries:
            raise PhysicsError("on which side of a surface something slides in a mirror is not told")
        by, entries = node.entries["by"], dict(node.entries)
        entries["by"] = by[0], self._displacement(by[1]) if kind == "slide" else self._turned_by(by[1])
        if "at" in entries:
            entries["at"] = entries["at"][0], self.vector(entries["at"][1])
        if kind == "slide":
            key, along = entries.get("along", (Scalar("along", node.where), _right(node.where)))
            entries["along"] = key, self.vector(along)
        return Mapping(node.where, entries)

    def _part_of_roll(self, name, node):
        if name in TURNS["roll"]:
            return self._turned_by(node)
        if name == "flat":
            return self._ends(node)
        if name not in ("surface", "between", "radius", "travel"):
            raise PhysicsError(f"what '{name}' of what rolls is in a mirror is not told")
        return self._displacement(node) if name == "travel" else node

    def surface(self, record: Any) -> Any:
        """A line or a circle."""
        if not isinstance(record, Mapping) or "curve" in record.entries:
            raise PhysicsError("a surface given by a curve is not mirrored")
        return _each(record, lambda name, node: self._ends(node) if name == "line" else
                     self.vector(node) if name == "circle" else node)

    def _displacement(self, node):
        return node if PLAIN.fullmatch(node.text.strip()) else self.expression(node)

    def _turned_by(self, node):
        if isinstance(node, Sequence):
            found = Sequence(node.where)
            found.items.extend(self._turned_by(one) if place % 2 == 0 else self._displacement(one)
                               for place, one in enumerate(node.items))
            return found
        return node if node.text.strip() in self.turned or node.text.strip() == "0" else self.negative(node)

    def connection(self, record: Any) -> Any:
        """A spring or a damper."""
        found = _each(record, self._part_of_connection)
        if "torsion" in found.entries and any(word in found.entries for word in SENSES):
            raise PhysicsError("a torsion that tells one sense from the other is not mirrored")
        return found

    def _part_of_connection(self, name, node):
        if name == "between":
            found = Sequence(node.where)
            found.items.extend(map(self.vector, node.items))
            return found
        if name not in CONNECTION:
            raise PhysicsError(f"what '{name}' of a spring or damper is in a mirror is not told")
        return self.expression(node)

    def load(self, record: Any) -> Any:
        """A force or a moment."""
        if not isinstance(record, Mapping) or "unbalance" in record.entries or "per_length" in record.entries:
            raise PhysicsError("an unbalance and a load along a member are not mirrored")
        of = record.entries.get("coordinate", (None, Scalar("", record.where)))[1]
        other = of.text.strip() in self.turned
        return _each(record, lambda name, node: (
            self.negative(node) if name == "moment" or (name == "value" and other)
            else self.vector(node) if isinstance(node, Sequence)
            else self.expression(node) if name in ("force", "value") else node))

    def constraint(self, record: Any) -> Any:
        """An equation, a joint or a link of two points, a rope over pulleys, a point on a surface."""
        if not isinstance(record, Mapping) or not record.entries.keys() <= TIES:
            raise PhysicsError("only equations, joints, links, ropes and points on surfaces are mirrored")
        return _each(record, lambda name, node: self.expression(node) if name == "equation" else
                     self._ends(node) if isinstance(node, Sequence) and name != "point" else self.vector(node))

    def _ends(self, node):
        found = Sequence(node.where)
        found.items.extend(self._guide(one) if isinstance(one, Mapping) else self.vector(one) for one in node.items)
        return found

    def _guide(self, record):
        """A pulley that a rope passes, on its other side."""
        return Mapping(record.where, {OTHER_SIDE.get(name, name): (key, self.vector(node))
                                      for name, (key, node) in record.entries.items()})

    def point(self, record: Any) -> Any:
        """A point, fixed or carried."""
        if isinstance(record, Sequence):
            return self.vector(record)
        return _each(record, lambda name, node: self.vector(node) if name in ("at", "moves") else node)


def opposite(text: str) -> str:
    """A sum with the other sign, of as many summands: those of a load are steady or in time one by one."""
    found, depth, start = [""], 0, 0
    for place, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        before = text[:place].rstrip()
        if letter in "+-" and not depth and before and before[-1] not in "*/^,+-·" and not EXPONENT.search(
                text[:place]):
            found[-1] += f"({text[start:place].strip()})"
            found.append("+" if letter == "-" else "-")
            start = place + 1
    found[-1] += f"({text[start:].strip()})"
    return "-" + " ".join(found)


def _right(where):
    """[1, 0]"""
    found = Sequence(where)
    found.items.extend([Scalar("1", where), Scalar("0", where)])
    return found
