"""What motions in time are: small, full, or those of equations that are expanded to the third order; how accurately
they are integrated."""

from typing import Any

from vibcli.language.accuracy import accuracy
from vibcli.language.document.document import Scalar
from vibcli.language.kinds import Choice, Kind, OneOf
from vibcli.language.spec import EXPANDED, Integrated

_WANTS = "{accuracy: 1e-6} or {order: 3}"


class _Mapping(Kind):
    wants = _WANTS

    def read(self, node: Any, reader: Any) -> Any:
        found = {key: value for key, (_, value) in node.entries.items()}
        if not found or set(found) - {"order", "accuracy"}:
            return reader.expected(node, _WANTS)
        kind, asked = "full", None
        if "order" in found:
            kind = EXPANDED
            if not isinstance(found["order"], Scalar) or found["order"].text != "3":
                return reader.expected(node, "{order: 3}", "equations are expanded to the third order alone")
        if "accuracy" in found:
            text = found["accuracy"]
            try:
                asked = accuracy(text.text if isinstance(text, Scalar) else "")
            except ValueError as error:
                message, _, hint = str(error).partition("; ")
                return reader.expected(text, message.removeprefix("expected "), hint or None)
        return Integrated(kind, asked)

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "properties": {"order": {"const": 3}, "accuracy": {"type": ["string", "number"]}},
                "minProperties": 1, "additionalProperties": False}


_WORDS = Choice("small", "full")
KIND = OneOf(f"small, full, {_WANTS}", scalar=_WORDS, mapping=_Mapping())
