"""The scene as a mistake takes it: a part merged over its document, in which None takes a key out."""

from typing import TYPE_CHECKING

from vibcli.language.document.mapping import document_of
from vibcli.language.document.nodes import Mapping

if TYPE_CHECKING:
    from vibcli.homework.mistakes.mistake import Part


def changed(root: Mapping, part: "Part") -> tuple[Mapping, Mapping]:
    """(the document without what the part takes out, the rest of the part as a document)."""
    return _without(root, part), document_of(_kept(part))[0]


def _without(node: Mapping, part: "Part") -> Mapping:
    entries = {}
    for key, (name, value) in node.entries.items():
        change = part.get(key, part)
        if change is None:
            continue
        inner = isinstance(change, dict) and change is not part and isinstance(value, Mapping)
        entries[key] = name, _without(value, change) if inner else value
    return Mapping(node.where, entries)


def _kept(part: "Part") -> "Part":
    return {key: _kept(value) if isinstance(value, dict) else value for key, value in part.items() if value is not None}
