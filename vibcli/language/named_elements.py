"""Elements by name: those that have a file of their own, and mappings from names that the writer chooses."""

from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.document.document import Mapping
from vibcli.language.fields import Element
from vibcli.language.reader import ByName, check_name

if TYPE_CHECKING:
    from types import ModuleType

    from vibcli.base.errors import Where


@cache
def load(name: Any, room: str = "elements") -> "ModuleType":
    """The module of an element or a section, vibcli/ROOM/NAME.py."""
    return import_module(f"vibcli.{room}.{name}")


class Lazy(NamedTuple):
    """An element or section by its room and the name of its file, imported when a scene first uses it."""

    name: str
    room: str = "elements"

    @property
    def module(self) -> "ModuleType":
        return load(self.name, self.room)

    def __getattr__(self, attribute: str) -> Any:
        return getattr(self.module.ELEMENT, attribute)

    def read(self, node: Any, reader: Any, *named: "str | Where") -> Any:
        return self.module.ELEMENT.read(node, reader, *named)


class LazyKind(NamedTuple):
    """A kind of value by its room, the name of its file and its own there, imported when a scene first uses it."""

    name: str
    room: str
    what: str = "KIND"

    @property
    def opened(self) -> Any:
        """The kind itself."""
        return getattr(load(self.name, self.room), self.what)

    def __getattr__(self, attribute: str) -> Any:
        return getattr(self.opened, attribute)

    def read(self, node: Any, reader: Any) -> Any:
        return self.opened.read(node, reader)


class Named(NamedTuple):
    """A mapping from names, chosen by the writer, to elements of one kind."""

    kind: Any
    wants: str
    forbidden: tuple[str, ...] = ()

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        records, places = {}, {}
        for key, (key_node, value_node) in node.entries.items():
            name = check_name(key_node, reader, self.forbidden)
            if name is None:
                continue
            if name in records:
                reader.report(key_node.where, f"'{key}' is the same name as one before it",
                              "Greek letters are names like those that spell them: φ is phi")
                continue
            record = (self.kind.read(value_node, reader, name, key_node.where) if isinstance(self.kind, (Element, Lazy))
                      else self.kind.read(value_node, reader))
            if record is not None:
                records[name], places[name] = record, key_node.where
        return ByName(records, places)

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": self.kind.schema()}
