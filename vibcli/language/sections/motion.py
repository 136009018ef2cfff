"""What motions in time are: small, full, or those of equations that are expanded to the third order."""

from typing import Any

from vibcli.language.document.document import Scalar
from vibcli.language.kinds import Choice, Kind, OneOf
from vibcli.language.spec import EXPANDED

_WANTS = "{order: 3}"


class _Order(Kind):
    wants = _WANTS

    def read(self, node: Any, reader: Any):
        value = node.entries["order"][1] if set(node.entries) == {"order"} else None
        if not isinstance(value, Scalar) or value.text != "3":
            return reader.expected(node, _WANTS, "equations are expanded to the third order alone")
        return EXPANDED

    def schema(self):
        return {"type": "object", "properties": {"order": {"const": 3}}, "required": ["order"],
                "additionalProperties": False}


_WORDS = Choice("small", "full")
KIND = OneOf(f"{_WORDS.wants} or {_WANTS}", scalar=_WORDS, mapping=_Order())
