"""A mapping of Python as the document that its text would be: the path of keys stands for the place."""

from collections.abc import Mapping as PythonMapping
from collections.abc import Sequence as PythonSequence
from numbers import Integral, Real
from typing import Any

from vibcli.base.decoding import forbidden, name_of
from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.language.document.nodes import Mapping, Scalar, Sequence
from vibcli.language.document.tree_builder import MAX_DEPTH, MAX_TEXT

MAX_VALUES = 5_000_000


def document_of(scene: PythonMapping[Any, Any]) -> tuple[Mapping, list[Diagnostic]]:
    """(top of the document, what in it no scene file could hold)."""
    reading = _Reading()
    return reading.mapping(scene, "", 0), reading.diagnostics


def text_of(value: object) -> str | None:
    """A number, truth value or text as a scene file writes it; None of anything else."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    return repr(float(value)) if isinstance(value, Real) else None


class _Reading:
    def __init__(self) -> None:
        self.diagnostics, self.count = [], 0

    def _place(self, path: str, depth: int) -> Where:
        """The place of a value: its number keeps diagnostics in the order of the mapping."""
        self.count += 1
        where = Where(path or "the scene", self.count, 1, 0)
        if depth > MAX_DEPTH or self.count > MAX_VALUES:
            much = f"nested more than {MAX_DEPTH} deep" if depth > MAX_DEPTH else f"more than {MAX_VALUES} values"
            raise SpecError([*self.diagnostics, Diagnostic(where, much, "a scene needs about eight levels")])
        return where

    def _node(self, value: object, path: str, depth: int) -> Scalar | Mapping | Sequence:
        if isinstance(value, PythonMapping):
            return self.mapping(value, path, depth)
        if hasattr(value, "tolist"):        # an array or number of NumPy
            value = value.tolist()
        if isinstance(value, PythonSequence) and not isinstance(value, (str, bytes, bytearray)):
            found = Sequence(self._place(path, depth))
            found.items.extend(self._node(item, f"{path}[{i}]", depth + 1) for i, item in enumerate(value))
            return found
        where = self._place(path, depth)
        text = text_of(value)
        if text is None:
            self._report(where, f"expected a text, number, list or mapping, found {type(value).__name__}")
        return Scalar(self._plain(text or "", where), where)

    def mapping(self, value: PythonMapping[Any, Any], path: str, depth: int) -> Mapping:
        found = Mapping(self._place(path, depth))
        for key, inner in value.items():
            text = text_of(key)
            here = f"{path}.{text}".lstrip(".").replace("/", "·")      # no part of a path to a file
            where = self._place(here, depth)
            if not text:
                self._report(where, f"expected a name as key, found {key!r:.40}")
                continue
            node = self._node(inner, here, depth + 1)
            text = self._plain(text, where)
            if text in found.entries:
                self._report(where, f"the key '{text}' stands twice")
            found.entries[text] = (Scalar(text, where), node)
        return found

    def _plain(self, text: str, where: Where) -> str:
        """The text, as far as a scene file could hold it."""
        wrong = forbidden().search(text)
        if wrong:
            self._report(where, f"found {name_of(wrong[0])}", "delete it")
        if len(text) > MAX_TEXT:
            self._report(where, f"expected at most {MAX_TEXT} characters, found {len(text)}", "shorten it")
        return forbidden().sub("\ufffd", text[:MAX_TEXT])

    def _report(self, where: Where, message: str, hint: str | None = None) -> None:
        self.diagnostics.append(Diagnostic(where, message, hint))
