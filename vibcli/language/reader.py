"""The reading of a file: the diagnostics, expressions and names that it collects; records; the words of messages."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where
from vibcli.base.units import parse_unit
from vibcli.language.document.document import Mapping, Sequence
from vibcli.symbolic.parser import plain_name
from vibcli.symbolic.syntax import parts_of

if TYPE_CHECKING:
    from vibcli.language.data_columns import Columns
    from vibcli.language.document.nodes import DocumentNode, Scalar
    from vibcli.language.fields import Element

MOST_PROBLEMS = 100


def article(noun: str) -> str:
    return ("an " if noun[0] in "aeiou" else "a ") + noun


class TooManyErrors(Exception):
    """More is wrong with a file than anybody reads."""


class Reader:
    """Collects what reading a file yields beside its values: diagnostics, every reference as (Name, namespaces, what is
    wanted), and by their Scalars every expression, those that move something (a bare name there is a coordinate), those
    that load or tie it, (name, dimension) of a name that is good in one expression alone, those in which velocities
    may stand, those of quantities that are checked later, and in `along` (coordinate, unknown factor or None) of those
    measured as a coordinate is. `sound` tells
    whether the scene was read whole, apart from what is asked of it; `files`: what was read beside it; `records` and
    `members`: the names of its records and of its continuous members; `lost`: those in sections of no known name."""

    def __init__(self, files: Any = None, records: Any = (), members: Any = ()) -> None:
        self.files, self.records, self.members = {} if files is None else files, records, members
        self.diagnostics, self.references, self.named_places = [], [], []
        self.expressions, self.motions, self.loads, self.local_names, self.at_speed = {}, {}, {}, {}, set()
        self.later: set[Scalar] = set()
        self.along = {}
        self.sound = True
        self.lost: set[str] = set()

    def report(self, where: Where, message: str, hint: str | None = None) -> None:
        self.diagnostics.append(Diagnostic(where, message, hint))
        if len(self.diagnostics) == MOST_PROBLEMS:
            self.diagnostics.append(Diagnostic(where, "too many problems: reading stops here", "mend these first"))
            raise TooManyErrors

    def not_whole(self) -> None:
        """A part of the scene could not be read."""
        self.sound = False

    def measured(self, record: "Record", key: str, unit: str, said: bool = False) -> None:
        """An expression of a record has the dimension of a unit, as its other keys determine; `said`: in which it is
        asked for."""
        old = record[key]
        record[key] = Expression(old.scalar, old.tree, unit if said else old.unit, parse_unit(unit).dimension)
        for kept in (self.expressions, self.motions, self.loads):
            if old.scalar in kept:
                kept[old.scalar] = record[key]

    def name_within(self, expression: "Expression", name: str, unit: str) -> None:
        """A name that is good in an expression alone, and the unit of what it stands for."""
        self.local_names[expression.scalar] = name, parse_unit(unit).dimension

    def columns_of(self, scene: str, name: str,
                   read: "Callable[[str, str], tuple[Columns | None, tuple[str, str] | Diagnostic | None]]"
                   ) -> "tuple[Columns | None, tuple[str, str] | Diagnostic | None]":
        """The columns of a file, by `read(scene, name)` once however many cases use it."""
        if (scene, name) not in self.files:
            self.files[scene, name] = read(scene, name)
        found: tuple[Columns | None, tuple[str, str] | Diagnostic | None] = self.files[scene, name]
        return found

    def at_places(self, tree: Any) -> Any:
        """A tree with the signals of places on members, where there are any."""
        if not self.members:
            return tree
        from vibcli.language.signals_of_places import with_places

        return with_places(tree, self.members)

    def expected(self, node: Any, what: str, hint: str | None = None) -> None:
        self.report(node.where, f"expected {what}, found {_found(node)}", hint)


def _found(node: "DocumentNode") -> str:
    if isinstance(node, Mapping):
        return "a mapping" if node.entries else "an empty mapping"
    if isinstance(node, Sequence):
        return "a list" if node.items else "an empty list"
    return quoted(node.text) if node.text.strip() else "nothing"


class Expression:
    """A parsed expression with its place, its Parts, and the unit and dimension that its field wants (None: settled
    elsewhere)."""

    __slots__ = ("dimension", "parts", "scalar", "text", "tree", "unit", "where")

    def __init__(self, scalar: "Scalar", tree: Any, unit: str | None = None, dimension: Any = None) -> None:
        self.scalar, self.text, self.where = scalar, scalar.text, scalar.where
        self.tree, self.parts, self.unit, self.dimension = tree, parts_of(tree), unit, dimension

    def with_tree(self, tree: Any) -> "Expression":
        """The same with another tree."""
        return Expression(self.scalar, tree, self.unit, self.dimension)


class Reference:
    """A reference to something named elsewhere, with its place."""

    __slots__ = ("text", "where")

    def __init__(self, text: str, where: Where) -> None:
        self.text, self.where = text, where


class Record(dict[str, Any]):
    """One element as written, {key: value}: its declared kind, its name, and the place of each key, of those as well
    whose value could not be read. Two records are never equal."""

    __slots__ = ("element", "name", "places", "where")
    __eq__, __ne__, __hash__ = object.__eq__, object.__ne__, object.__hash__  # type: ignore[assignment]

    def __init__(self, element: "Element | None", name: str | None, where: Where, values: Any,
                 places: dict[str, Where]) -> None:
        super().__init__(values)
        self.element, self.name, self.where, self.places = element, name, where, places

    def __bool__(self) -> bool:
        return True

    def place(self, key: str) -> Where:
        return self.places.get(key, self.where)

    def with_values(self, values: Any) -> "Record":
        """The record with other values."""
        return Record(self.element, self.name, self.where, values, self.places)


class ByName(dict[str, Any]):
    """{name: value} as written, and the place of each name."""

    __slots__ = ("places",)

    def __init__(self, values: Any, places: "dict[str, Where]") -> None:
        super().__init__(values)
        self.places = places

    def place(self, name: str) -> Where:
        return self.places[name]


def _meant(text: str) -> str:
    """The hint for what is no name: a value that lost its colon, or the rest of a decimal with a comma."""
    name, blank, value = text.partition(" ")
    if plain_name(name).isidentifier() and value[:1].isdigit() and " " in value:
        return f"put a colon after the name: {name}: {value[:60]}"
    if blank and name.isdigit():
        return "decimals are written with a point: 0.5"
    return "a name starts with a letter, a to z or Greek, and goes on with letters, digits and _, at most 32"


def check_name(node: "Scalar", reader: Reader, forbidden: Any = ()) -> str:
    """A name chosen by the writer, Greek letters spelt out; None and a diagnostic where it is not one."""
    name = plain_name(node.text)
    if not name.isidentifier() or not name.isascii() or len(name) > 32:
        reader.report(node.where, f"{quoted(node.text)} is not a name", _meant(node.text))
        return None
    if name in forbidden:
        reader.report(node.where, f"'{node.text}' is a word of the language and cannot be a name here",
                      "choose another name")
        return None
    return name
