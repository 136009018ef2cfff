"""YAML events to a tree of nodes, each with its place; whatever a scene file does not use is a diagnostic."""

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from yaml import events

from vibcli.base import decoding
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where
from vibcli.language.document.nodes import Mapping, Scalar, Sequence

MAX_DEPTH = 32
TOO_DEEP = f"nested more than {MAX_DEPTH} deep", "a scene needs about eight levels"
MAX_NODES = 200_000
MAX_TEXT = 4096
MAX_PROBLEMS = 100
MAX_TRIES = 50  # unbalanced parentheses in flow collections that are looked at for a comma

_BREAK = "[\r\n]"  # patterns are compiled where a file needs them: that costs more than reading most scenes
_PROPERTY = r"\s*([!&][^\s,\[\]{}]*)"
_ESCAPE = r"(?s)\\(?:x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|.)"


if TYPE_CHECKING:
    from typing import Protocol

    from vibcli.language.document.nodes import DocumentNode

    class SourceMark(Protocol):
        """A place in the source, counted from 0; each of YAML's two parsers has a class of its own for it."""

        index: int
        line: int
        column: int


class Stopped(Exception):
    """Reading cannot go on; the reason is among the problems."""


class Slipped(Exception):
    """An expression that a flow collection has cut: carries (diagnostic, mended source, index)."""


_place = tuple.__new__  # twice as fast as Where(…), and a file has thousands
_DROPPED = Scalar("", None)  # stands as the key of an entry that was refused: its value is read and left out


class Tree:
    """The tree as it grows, the open collections on an explicit stack."""

    key: Any
    parent: Any
    root: Mapping | Scalar | Sequence | None
    last: events.ScalarEvent | None

    __slots__ = ("count", "file", "flow", "hidden", "key", "last", "parent", "problems", "root", "source",
                 "stack", "started", "tries")

    def __init__(self, source: str, file: str, hidden: dict[int, int] | None = None) -> None:
        """`hidden` maps back the characters that stand for hidden commas and brackets (see slips.py)."""
        self.source, self.file, self.hidden = source, file, hidden
        self.stack, self.problems = [], []
        self.parent = self.key = None
        self.root = self.last = None
        self.started = False
        self.count = self.flow = self.tries = 0

    def grow(self, next_event: Callable[[], events.Event]) -> None:
        """Take every event of the first document; stops at the top of a second one."""
        while True:
            event = next_event()
            kind = event.__class__
            if kind is events.ScalarEvent:
                self._scalar(event)
            elif kind is events.MappingStartEvent:
                self._open(event, Mapping)
            elif kind is events.SequenceStartEvent:
                self._open(event, Sequence)
            elif kind is events.MappingEndEvent or kind is events.SequenceEndEvent:
                self._close(event)
            elif kind is events.AliasEvent:
                self._alias(event)
            elif kind is events.DocumentStartEvent:
                if self._second(event):
                    return
            elif kind is events.StreamEndEvent:
                return

    def report(self, where: Where, message: str, hint: str | None = None) -> None:
        self.problems.append(Diagnostic(where, message, hint))
        if len(self.problems) >= MAX_PROBLEMS:
            message = "too many problems: reading stops here"
            self.problems.append(Diagnostic(where, message, "mend these first"))
            raise Stopped

    def _scalar(self, event: events.ScalarEvent) -> None:
        mark, end, text = event.start_mark, event.end_mark, event.value
        line, column = mark.line, mark.column
        width = end.column - column
        usual = 0 < width == len(text) <= MAX_TEXT and line == end.line and not self.hidden
        if not usual or (self.flow and "(" in text):
            self._unusual_scalar(event, mark, end)
            return
        self.last = event  # plain text on one line, without tag or anchor: those would have made it wider
        self._add(Scalar(text, _place(Where, (self.file, line + 1, column + 1, width)), False, 0))

    def _unusual_scalar(self, event: events.ScalarEvent, mark: "SourceMark", end: "SourceMark") -> None:
        text, style = event.value, event.style
        where, inset = self._extent(mark, end, len(text), style)
        if text:
            self.last = event
            if len(text) > MAX_TEXT:
                self.report(where, f"expected at most {MAX_TEXT} characters, found {len(text)}", "shorten it")
                text = text[:MAX_TEXT]
            if self.flow and not style and text.count("(") > text.count(")"):
                self._comma(mark.index)
            if style == '"' and inset is None and not decoding.prints(text) and (
                    decoding.forbidden().search(text)):
                text = self._escapes(mark, end, text)
            if self.hidden:
                text = text.translate(self.hidden)
        if event.anchor is not None or event.tag is not None:
            self._properties(event)
        self._add(Scalar(text, where, bool(style), inset))

    def _extent(self, mark: "SourceMark", end: "SourceMark", length: int, style: str) -> tuple[Where, int | None]:
        """The place of a scalar, and its text's offset from there if the file holds it letter by letter."""
        inset = None
        if mark.index >= len(self.source):  # the parser starts a new line at the end of a file that has none
            return decoding.place(self.source, len(self.source), self.file), inset
        if mark.line == end.line:
            width = end.column - mark.column
            if width == length:
                inset = 0
            elif width == length + 2 and (style == '"' or style == "'"):
                inset = 1
        elif style == "|" or style == ">":
            width = 1
        else:
            stop = re.compile(_BREAK).search(self.source, mark.index)
            width = len(self.source[mark.index : stop.start() if stop else None].rstrip())
        return Where(self.file, mark.line + 1, mark.column + 1, width or 1), inset

    def _open(self, event: events.CollectionStartEvent, kind: type[Mapping | Sequence]) -> None:
        mark = event.start_mark
        where = _place(Where, (self.file, mark.line + 1, mark.column + 1, 1))
        if event.anchor is not None or event.tag is not None:
            self._properties(event)
        if len(self.stack) >= MAX_DEPTH:
            self.report(where, *TOO_DEEP)
            raise Stopped
        node = kind(where)
        self._add(node)
        self.stack.append((self.parent, self.key, mark.index))
        self.parent, self.key = node, None
        if event.flow_style:
            self.flow += 1

    def _close(self, event: events.CollectionEndEvent) -> None:
        node = self.parent
        self.parent, self.key, _ = self.stack.pop()
        if self.flow:
            self.flow -= 1
            mark, where = event.end_mark, node.where
            if mark.line + 1 == where.line:
                node.widen(max(1, mark.column + 1 - where.column))

    def _add(self, node: Mapping | Scalar | Sequence | None) -> None:
        """Put a node where the parser stands: the top, the next item, the next key or its value."""
        self.count += 1
        if self.count > MAX_NODES and node is not None:
            self.report(node.where, f"more than {MAX_NODES} values in one file", "is this the right file?")
            raise Stopped
        parent = self.parent
        if parent is None:
            self.root = node
        elif parent.__class__ is Sequence:
            if node is not None:
                parent.items.append(node)
        elif self.key is None:
            if node.__class__ is Scalar and node.text.isidentifier() and node.text not in parent.entries:
                self.key = node
            else:
                self.key = self._key(node, parent.entries)
        else:
            key, self.key = self.key, None
            if key is not _DROPPED and node is not None:
                parent.entries[key.text] = (key, node)

    def _key(self, node: Mapping | Scalar | Sequence | None,
             entries: "dict[str, tuple[Scalar, DocumentNode]]") -> Scalar:
        """The node as a key, or _DROPPED with a report where it cannot be one."""
        if node.__class__ is not Scalar:
            if node is not None:
                what = "a mapping" if node.__class__ is Mapping else "a list"
                self.report(node.where, f"expected a name as key, found {what}",
                            "a text that starts with [ or { needs quotes")
            return _DROPPED
        text = node.text
        if text in entries:
            first = entries[text][0].where.line
            self.report(node.where, f"the key {quoted(text)} is written twice, first in line {first}",
                        "keep one of the two, or rename one")
        elif not text and not node.quoted:
            self.report(node.where, "found ':' without a key before it", "write key: value")
        elif text == "<<" and not node.quoted:
            self.report(node.where, "found the merge key '<<', which scenes do not use",
                        "write the entries out where they are needed")
        elif "\n" in text:
            self.report(node.where, "a key that goes over several lines", "write the key on one line")
        elif ":" in text and not node.quoted:
            name, _, value = text.partition(":")
            self.report(node.where, f"no space after the ':' in {quoted(text)}",
                        f"write {name}: {value.strip()}"[:200] if name else "write key: value")
        else:
            return node
        return _DROPPED

    def _alias(self, event: events.AliasEvent) -> None:
        mark, end = event.start_mark, event.end_mark
        text = self.source[mark.index : end.index]
        self.report(Where(self.file, mark.line + 1, mark.column + 1, max(1, len(text))),
                    f"found the alias {quoted(text)}, which scenes do not use",
                    "write the value out; a text that starts with * needs quotes")
        self._add(None)

    def _properties(self, event: events.NodeEvent) -> None:
        """Report the tag and the anchor that stand before a node."""
        index = event.start_mark.index
        for _ in range((event.tag is not None) + (event.anchor is not None)):
            found = re.compile(_PROPERTY).match(self.source, index)
            if not found:
                break
            index, text = found.end(), found[1]
            where = decoding.place(self.source, found.start(1), self.file, len(text))
            kind = "tag" if text[0] == "!" else "anchor"
            self.report(where, f"found the {kind} {quoted(text)}, which scenes do not use",
                        f"leave it out; a text that starts with {text[0]} needs quotes")

    def _escapes(self, mark: "SourceMark", end: "SourceMark", text: str) -> str:
        """Report characters that stand in double quotes as escapes but may not stand in a file."""
        for found in re.compile(_ESCAPE).finditer(self.source, mark.index, end.index):
            char = _meant(found[0])
            if char and decoding.forbidden().match(char):
                where = decoding.place(self.source, found.start(), self.file, len(found[0]))
                self.report(where, f"the escape {quoted(found[0])} is {decoding.name_of(char)}", "delete it")
        return decoding.forbidden().sub(decoding.STAND_IN, text)

    def _comma(self, index: int) -> None:
        """Look whether the parenthesis left open in a flow scalar was cut by a comma."""
        from vibcli.language.document import misread_expressions

        self.tries += 1
        slip = self.tries <= MAX_TRIES and misread_expressions.comma(self.source, index, self.file)
        if slip:
            raise Slipped(*slip)

    def _second(self, event: events.DocumentStartEvent) -> bool:
        """Is this document one too many?"""
        where = Where(self.file, event.start_mark.line + 1, event.start_mark.column + 1)
        if event.version or event.tags:
            self.report(where, "found a '%' directive, which scenes do not use", "leave the line out")
        if self.started:
            self.report(where._replace(width=3), "found a second document in the file, expected one scene",
                        "give each scene its own file, or use 'cases'")
            return True
        self.started = True
        return False


def _meant(escape: str) -> str | None:
    """The character that a double-quoted escape means, None for those that are plain."""
    if escape[1] in "xuU" and len(escape) > 2:
        code = int(escape[2:], 16)
        return chr(code) if code < 0x110000 else None
    return {"0": "\0", "a": "\a", "b": "\b", "v": "\v", "f": "\f", "e": "\x1b", "N": "\x85", "L": "\u2028",
            "P": "\u2029"}.get(escape[1])
