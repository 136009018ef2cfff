"""Generalised coordinates: their order, what each measures, and its value in the drawn position."""

from typing import Any

from vibcli.language.document.document import Mapping, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Kind, Quantity, Text
from vibcli.language.reader import Record, check_name

ELEMENT = Element(
    "coordinate",
    "The generalised coordinates in the order wanted, with a word on what each measures. Without this section they "
    "are taken from the motions, in file order. A coordinate is zero as drawn unless `drawn` says otherwise.",
    {
        "about": Field(Text(), "what it measures"),
        "drawn": Field(Quantity(), "its value in the drawn position"),
    },
    short="about",
    example="double_pendulum",
)
ABOUT = ELEMENT.about


class Coordinates(Kind):
    wants = "a list of names, or a mapping from names to what they measure"

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Sequence):
            entries = [(item, None) for item in node.items]
        elif isinstance(node, Mapping):
            entries = list(node.entries.values())
        else:
            return reader.expected(node, self.wants)
        records = {}
        for key, value in entries:
            if not hasattr(key, "text"):
                reader.expected(key, "the name of a coordinate")
                continue
            name = check_name(key, reader, ("t", "pi"))
            if name in records:
                reader.report(key.where, f"the coordinate '{name}' stands twice", "leave one of the two out")
            elif name is not None:
                empty = value is None or (hasattr(value, "text") and not value.text)
                record = Record(ELEMENT, name, key.where, {}, {}) if empty else ELEMENT.read(
                    value, reader, name, key.where)
                if record is not None:
                    records[name] = record
        return records

    def schema(self) -> dict[str, Any]:
        return {"anyOf": [{"type": "array", "items": {"type": "string"}},
                          {"type": "object", "additionalProperties": {"anyOf": [{"type": "null"}, ELEMENT.schema()]}}]}


KIND = Coordinates()
