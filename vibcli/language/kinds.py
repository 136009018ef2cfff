"""Kinds of what may stand in a field: texts, names, words, expressions, lists and alternatives of them.

A kind reads a document node into a value, or reports what was expected and found. Expressions are parsed here and kept
as trees; what their names mean and whether their dimensions fit is settled by the reader, once all names are known.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import near
from vibcli.language.document.document import Mapping, Scalar, Sequence
from vibcli.language.reader import Expression, Reference, check_name
from vibcli.language.record_calls import with_record_calls
from vibcli.symbolic.parser import parse, plain_name
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode


class Kind:
    """The kind of what a field holds: `read(node, reader)`, `schema()`, and `wants`, which completes "expected …"."""

    wants = "a value"
    about = None


class Text(Kind):
    wants = "text"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Scalar):
            return reader.expected(node, self.wants)
        return node.text

    def schema(self) -> dict[str, Any]:
        return {"type": ["string", "number"]}


class Quantity(NamedTuple):
    """An expression of a given dimension; `unit` None leaves it to be inferred; `equation`: an example of one that is
    due instead. `kept`: the dictionary of the reader that takes it up beside that of all expressions."""

    unit: str | None = None
    equation: str | None = None
    kept = None

    @property
    def dimension(self) -> Any:
        return None if self.unit is None else units.parse_unit(self.unit).dimension

    @property
    def wants(self) -> str:
        if self.equation:
            return "an equation"
        if self.unit is None:
            return "an expression"
        return units.wanted(self.unit, self.dimension)

    def read(self, node: Any, reader: Any) -> Any:
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
        if self.kept:
            getattr(reader, self.kept)[node] = expression
        return expression

    @property
    def sample(self) -> str:
        return f"3 {self.unit}" if self.unit and self.dimension else None

    def schema(self) -> dict[str, Any]:
        return {"type": ["string", "number"]}


class MotionField(Quantity):
    """A displacement or rotation in coordinates; a bare name here, if no parameter, is a coordinate."""

    __slots__ = ()
    kept = "motions"

    @property
    def sample(self) -> str:
        return "x" if self.unit == "m" else "phi"


class Load(Quantity):
    """An expression of the time, coordinates and velocities."""

    __slots__ = ()
    kept = "loads"


class EquationField(Load):
    """An equation between coordinates and the time."""

    __slots__ = ()


class NewName(Text):
    """A name that is good within the one element."""

    wants = "a name"

    def read(self, node: Any, reader: Any) -> Any:
        return check_name(node, reader, ("t", "pi")) if isinstance(node, Scalar) else reader.expected(node, self.wants)


class NameOf(Kind):
    """The name of something declared elsewhere in the file, in one of the namespaces of spec.py."""

    def __init__(self, wants: str, *namespaces: str) -> None:
        self.wants, self.namespaces = wants, namespaces

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants)
        name = Reference(plain_name(node.text.strip()), node.where)
        reader.references.append((name, self.namespaces, self.wants))
        return name

    def schema(self) -> dict[str, Any]:
        return {"type": "string"}


def in_square_brackets(text: str, least: int = 2, most: int = 2) -> str | None:
    """The hint for a list of two or more that stands in round brackets or in none; None for all else."""
    inner = text[1:-1] if text.startswith("(") and text.endswith(")") else text
    parts = [part.strip() for part in inner.split(",")]
    fits = least <= len(parts) <= most and all(parts) and "(" not in inner
    return f"write [{', '.join(parts)}]" if fits and len(parts) > 1 and len(text) <= 40 else None


class Choice(Kind):
    """One of some words; `others`: {what others call it: the word}."""

    def __init__(self, *words: str, others: "dict[str, str] | None" = None) -> None:
        self.words, self.others = words, others or {}

    @property
    def wants(self) -> str:
        *words, last = self.words
        return ("one of " if len(words) > 1 else "") + (", ".join(words) + " or " if words else "the word ") + last

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Scalar) or node.text not in self.words:
            meant = self._meant(node.text) if isinstance(node, Scalar) else None
            return reader.expected(node, self.wants, meant and f"did you mean '{meant}'?")
        return node.text

    def _meant(self, text: str) -> str | None:
        word = self.others.get(text.lower())
        return word if word in self.words else near(text, self.words)

    def schema(self) -> dict[str, Any]:
        return {"enum": [*self.words, *(int(word) for word in self.words if word.isdecimal())]}


class WholeNumber(Kind):
    """A whole number from `least` to `most`: how many, or the number of one, or an order."""

    def __init__(self, most: int, least: int = 1) -> None:
        self.wants, self.least, self.most = f"a whole number from {least} to {most}", least, most

    def read(self, node: Any, reader: Any) -> Any:
        text = node.text.strip() if isinstance(node, Scalar) else ""
        if not (text.isascii() and text.isdigit()) or int(text) < self.least:
            return reader.expected(node, self.wants)
        if int(text) > self.most:
            return reader.report(node.where, f"{text} is too many: expected {self.wants}",
                                 f"ask for {self.most} at most")
        return int(text)

    def schema(self) -> dict[str, Any]:
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


class Flag(Choice):
    def __init__(self) -> None:
        super().__init__("true", "false")

    def read(self, node: Any, reader: Any) -> Any:
        word = super().read(node, reader)
        return None if word is None else word == "true"

    def schema(self) -> dict[str, Any]:
        return {"type": "boolean"}


class Many(NamedTuple):
    """A list of one kind; `least` and `most` bound its length; `named`: what it is, in words."""

    kind: Any
    least: int = 0
    most: int = 10000
    named: str | None = None

    @property
    def wants(self) -> str:
        return self.named or (f"a list of {self.least}" if self.least == self.most else "a list")

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Sequence) or not self.least <= len(node.items) <= self.most:
            if isinstance(node, Sequence):
                count = {0: "an empty list", 1: "one item"}.get(len(node.items), f"{len(node.items)} items")
                wants = self.wants if self.named or self.least == self.most else (
                    f"a list of {self.least} to {self.most} items")
                return reader.report(node.where, f"expected {wants}, found {count}", self._miscounted(node.items))
            text = node.text.strip() if isinstance(node, Scalar) else ""
            one = self.least <= 1 and plain_name(text).isidentifier()
            return reader.expected(node, self.wants, f"write [{text[:40]}]" if one
                                   else in_square_brackets(text, self.least, self.most))
        items = [self.kind.read(item, reader) for item in node.items]
        return None if any(item is None for item in items) else items

    def _miscounted(self, items: "list[DocumentNode]") -> str | None:
        """A hint where a comma stands for the point of a decimal, or is forgotten; or None."""
        texts = [item.text.strip() if isinstance(item, Scalar) else "" for item in items]
        if len(items) > self.most and any(one.lstrip("+-").isdigit() and other[:1].isdigit() and " " in other
                                          for one, other in pairwise(texts)):
            return "decimals are written with a point: 0.5"
        parts = texts[0].split() if len(texts) == 1 else []
        return f"put a comma between them: [{', '.join(parts)}]" if (
            1 < len(parts) == self.least and (all(part.isidentifier() for part in parts)
                                              or all(part.lstrip("-").isdigit() for part in parts))) else None

    def schema(self) -> dict[str, Any]:
        return {"type": "array", "items": self.kind.schema(), "minItems": self.least, "maxItems": self.most}


def vector(unit: str | None, wants: str, kind: type[Any] = Quantity) -> Many:
    return Many(kind(unit), 2, 2, wants)


class OneOf(NamedTuple):
    """Alternatives told apart by the node's form; `advice`: what to write for a mapping where none is wanted."""

    wants: str
    scalar: Any = None
    sequence: Any = None
    mapping: Any = None
    advice: str | None = None

    @property
    def kinds(self) -> dict[type[Any], Any]:
        """{form of a node: kind} of the forms that it may have."""
        pairs = ((Scalar, self.scalar), (Sequence, self.sequence), (Mapping, self.mapping))
        return {form: kind for form, kind in pairs if kind is not None}

    def read(self, node: Any, reader: Any) -> Any:
        kind = self.kinds.get(type(node))
        if kind is None:
            return reader.expected(node, self.wants, self.advice if isinstance(node, Mapping) else None)
        return kind.read(node, reader)

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [kind.schema() for kind in self.kinds.values()]}


ON_A_BODY = "a place on a body has a name among `points`: P: {body: rod, at: [x, y]}, and is P here"
PLACE = OneOf("a place [x, y] or the name of a point or body",
              scalar=NameOf("the name of a point or body", "points", "bodies"), sequence=vector("m", "a place [x, y]"),
              advice=ON_A_BODY)
END = OneOf("a place [x, y], the name of a point or body, or ground",
            scalar=NameOf("the name of a point or body, or ground", "points", "bodies", "ground"),
            sequence=vector("m", "a place [x, y]"), advice=ON_A_BODY)
BODY = NameOf("the name of a body", "bodies")
ENDS = Many(END, 2, 2, "two ends [A, B]")
