"""Fields: what may stand where. One declaration gives the reading, the error messages, the manual and the schema.

A kind reads a document node into a value, or reports what was expected and found. An Element is a mapping with
declared keys; reading one gives a Record. Expressions are parsed here and kept as trees; what their names mean
and whether their dimensions fit is settled by the reader, once all names are known.
"""

from collections.abc import Callable
from typing import NamedTuple

from vibcli.base import units
from vibcli.base.diagnostics import quoted
from vibcli.base.spelling import near, nearest
from vibcli.language.document.document import Mapping, Scalar, Sequence
from vibcli.language.reader import Expression, Record, Reference, article, check_name
from vibcli.language.record_calls import with_record_calls
from vibcli.symbolic.parser import ExpressionError, parse, plain_name


class Kind:
    """What a field may hold: `read(node, reader)`, `schema()`, and `wants`, which completes "expected …"."""

    wants = "a value"
    about = None


class Text(Kind):
    wants = "text"

    def read(self, node, reader):
        if not isinstance(node, Scalar):
            return reader.expected(node, self.wants)
        return node.text

    def schema(self):
        return {"type": ["string", "number"]}


class Quantity(NamedTuple):
    """An expression of a given dimension; `unit` None leaves it to be inferred; `equation`: an example of one that is
    due instead."""

    unit: str | None = None
    equation: str | None = None

    @property
    def dimension(self):
        return None if self.unit is None else units.parse_unit(self.unit).dimension

    @property
    def wants(self):
        if self.equation:
            return "an equation"
        if self.unit is None:
            return "an expression"
        return units.wanted(self.unit, self.dimension)

    def read(self, node, reader):
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants, f"write for example {self.sample}" if self.sample else None)
        try:
            tree = parse(node.text, self.equation)
        except ExpressionError as error:
            return reader.report(node.place(error.offset, error.width), error.message, error.hint)
        if reader.records and "(" in node.text:
            tree = with_record_calls(tree, reader.records)
        expression = Expression(node, tree, self.unit, self.dimension)
        reader.expressions[node] = expression
        return expression

    @property
    def sample(self):
        return f"3 {self.unit}" if self.unit and self.dimension else None

    def schema(self):
        return {"type": ["string", "number"]}


class MotionField(Quantity):
    """A displacement or rotation in coordinates; a bare name here, if no parameter, is a coordinate."""

    __slots__ = ()

    def read(self, node, reader):
        expression = super().read(node, reader)
        if expression is not None:
            reader.motions[node] = expression
        return expression


class Load(Quantity):
    """An expression of the time, coordinates and velocities."""

    __slots__ = ()

    def read(self, node, reader):
        expression = super().read(node, reader)
        if expression is not None:
            reader.loads[node] = expression
        return expression


class EquationField(Load):
    """An equation between coordinates and the time."""

    __slots__ = ()


class NewName(Text):
    """A name that is good within the one element."""

    wants = "a name"

    def read(self, node, reader):
        return check_name(node, reader, ("t", "pi")) if isinstance(node, Scalar) else reader.expected(node, self.wants)


class NameOf(Kind):
    """The name of something declared elsewhere in the file, in one of the namespaces of spec.py."""

    def __init__(self, wants, *namespaces):
        self.wants, self.namespaces = wants, namespaces

    def read(self, node, reader):
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants)
        name = Reference(plain_name(node.text.strip()), node.where)
        reader.references.append((name, self.namespaces, self.wants))
        return name

    def schema(self):
        return {"type": "string"}


class Choice(Kind):
    def __init__(self, *words):
        self.words = words

    @property
    def wants(self):
        *words, last = self.words
        return ("one of " if len(words) > 1 else "") + (", ".join(words) + " or " if words else "the word ") + last

    def read(self, node, reader):
        if not isinstance(node, Scalar) or node.text not in self.words:
            meant = near(node.text, self.words) if isinstance(node, Scalar) else None
            return reader.expected(node, self.wants, meant and f"did you mean '{meant}'?")
        return node.text

    def schema(self):
        return {"enum": list(self.words)}


class Flag(Choice):
    def __init__(self):
        super().__init__("true", "false")

    def read(self, node, reader):
        word = super().read(node, reader)
        return None if word is None else word == "true"

    def schema(self):
        return {"type": "boolean"}


class Many(NamedTuple):
    """A list of one kind; `least` and `most` bound its length; `named`: what it is, in words."""

    kind: object
    least: int = 0
    most: int = 10000
    named: str | None = None

    @property
    def wants(self):
        return self.named or (f"a list of {self.least}" if self.least == self.most else "a list")

    def read(self, node, reader):
        if not isinstance(node, Sequence) or not self.least <= len(node.items) <= self.most:
            if isinstance(node, Sequence):
                count = {0: "an empty list", 1: "one item"}.get(len(node.items), f"{len(node.items)} items")
                return reader.report(node.where, f"expected {self.wants}, found {count}")
            one = isinstance(node, Scalar) and node.text.strip() and isinstance(self.kind, Choice)
            return reader.expected(node, self.wants, f"write [{node.text.strip()[:40]}]" if one else None)
        items = [self.kind.read(item, reader) for item in node.items]
        return None if any(item is None for item in items) else items

    def schema(self):
        return {"type": "array", "items": self.kind.schema(), "minItems": self.least, "maxItems": self.most}


def vector(unit, wants, kind=Quantity):
    return Many(kind(unit), 2, 2, wants)


class OneOf(NamedTuple):
    """Alternatives told apart by the node's form."""

    wants: str
    scalar: object = None
    sequence: object = None
    mapping: object = None

    @property
    def kinds(self):
        """{form of a node: kind} of the forms that it may have."""
        pairs = ((Scalar, self.scalar), (Sequence, self.sequence), (Mapping, self.mapping))
        return {form: kind for form, kind in pairs if kind is not None}

    def read(self, node, reader):
        kind = self.kinds.get(type(node))
        return reader.expected(node, self.wants) if kind is None else kind.read(node, reader)

    def schema(self):
        return {"anyOf": [kind.schema() for kind in self.kinds.values()]}


PLACE = OneOf("a place [x, y] or the name of a point or body",
              scalar=NameOf("the name of a point or body", "points", "bodies"), sequence=vector("m", "a place [x, y]"))
END = OneOf("a place [x, y], the name of a point or body, or ground",
            scalar=NameOf("the name of a point or body, or ground", "points", "bodies", "ground"),
            sequence=vector("m", "a place [x, y]"))
BODY = NameOf("the name of a body", "bodies")
ENDS = Many(END, 2, 2, "two ends [A, B]")


class Field(NamedTuple):
    """A key of an element: its kind and what it means, in a few words."""

    kind: object
    about: str
    required: bool = False


class Element(NamedTuple):
    """A mapping with declared keys. `short` is the key that a bare value stands for (`slide: x` is `{by: x}`);
    `exclusive` lists groups of keys of which at most one may stand, `needs` groups of which at least one must.
    `settle(record, reader)` sets dimensions that depend on the other keys, and reports keys that do not go together;
    `instead` says what to write for a key that is missed here; `signals` are those of what joins two ends, {part:
    (its unit, that of torsion)}."""

    name: str
    about: str
    fields: dict[str, Field]
    short: str | None = None
    exclusive: tuple = ()
    needs: tuple = ()
    settle: Callable | None = None
    example: str | None = None
    instead: dict[str, str] = {}
    signals: dict[str, tuple[str, str]] = {}

    @property
    def wants(self):
        keys = ", ".join(list(self.fields)[:5]) + (", …" if len(self.fields) > 5 else "")
        if self.short is not None:
            return f"{self.fields[self.short].kind.wants}, or a mapping {{{keys}}}"
        return f"{article(self.name)} as a mapping {{{keys}}}"

    def read(self, node, reader, name=None, where=None):
        where = where or node.where
        if not isinstance(node, Mapping):
            if self.short is None or (isinstance(node, Scalar) and not node.text.strip()):
                return reader.expected(node, self.wants)
            value = self.fields[self.short].kind.read(node, reader)
            return None if value is None else Record(self, name, where, {self.short: value}, {self.short: node.where})
        before = len(reader.diagnostics)
        values, keys = {}, {}
        for key, (key_node, value_node) in node.entries.items():
            keys[key] = key_node.where
            field = self.fields.get(key)
            if field is None:
                reader.report(key_node.where, f"unknown key {quoted(key)} in {article(self.name)}",
                              self.instead.get(key) or nearest(key, self.fields))
                continue
            value = field.kind.read(value_node, reader)
            if value is not None:
                values[key] = value
        self._rules(reader, where, keys)
        if len(reader.diagnostics) > before:
            return None
        record = Record(self, name, where, values, keys)
        if self.settle:
            self.settle(record, reader)
        return record

    def _rules(self, reader, where, keys):
        given = set(keys) | {near(key, self.fields) for key in keys if key not in self.fields}
        for key, field in self.fields.items():
            if field.required and key not in given:
                reader.report(where, f"this {self.name} needs '{key}': {field.about}")
        for group in self.exclusive:
            present = [key for key in keys if key in group]
            if len(present) > 1:
                reader.report(keys[present[1]], f"'{present[1]}' contradicts '{present[0]}' in one {self.name}",
                              "give one of " + ", ".join(group))
        for group in self.needs:
            if not any(key in given for key in group):
                reader.report(where, f"this {self.name} needs " + " or ".join(f"'{key}'" for key in group),
                              f"{group[0]}: {self.fields[group[0]].about}")

    def schema(self):
        mapping = {"type": "object", "additionalProperties": False, "properties": {
            key: {**field.kind.schema(), "description": field.about} for key, field in self.fields.items()}}
        required = [key for key, field in self.fields.items() if field.required]
        if required:
            mapping["required"] = required
        if self.short is None:
            return mapping
        return {"anyOf": [self.fields[self.short].kind.schema(), mapping]}
