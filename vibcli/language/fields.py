"""Fields of elements: what may stand where. One declaration gives the reading, the messages, manual and schema."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import near, nearest
from vibcli.language.document.document import Mapping, Scalar
from vibcli.language.reader import Record, article

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.language.reader import Reader


class Field(NamedTuple):
    """A key of an element: its kind and what it means, in a few words."""

    kind: Any
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
    exclusive: tuple[tuple[str, ...], ...] = ()
    needs: tuple[tuple[str, ...], ...] = ()
    settle: "Callable[[Record, Reader], None] | None" = None
    example: str | None = None
    instead: dict[str, str] = {}
    signals: dict[str, tuple[str, str]] = {}

    @property
    def wants(self) -> str:
        keys = ", ".join(list(self.fields)[:5]) + (", …" if len(self.fields) > 5 else "")
        if self.short is not None:
            return f"{self.fields[self.short].kind.wants}, or a mapping {{{keys}}}"
        return f"{article(self.name)} as a mapping {{{keys}}}"

    def read(self, node: "DocumentNode", reader: "Reader", name: str | None = None,
             where: "Where | None" = None) -> "Record | None":
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

    def _rules(self, reader: "Reader", where: "Where", keys: "dict[str, Where]") -> None:
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

    def schema(self) -> dict[str, Any]:
        mapping = {"type": "object", "additionalProperties": False, "properties": {
            key: {**field.kind.schema(), "description": field.about} for key, field in self.fields.items()}}
        required = [key for key, field in self.fields.items() if field.required]
        if required:
            mapping["required"] = required
        if self.short is None:
            return mapping
        return {"anyOf": [self.fields[self.short].kind.schema(), mapping]}
