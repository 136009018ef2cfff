"""Errors of YAML's parser in plain words.

Six slips have words of their own: tabs, colons, indentation, brackets and quotes that are not closed, values that start
with a character of YAML's. Of all others the parser's own words are said.
"""

import re
from typing import TYPE_CHECKING

from vibcli.base import decoding
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, Where
from vibcli.language.document import misread_expressions
from vibcli.language.document.nodes import Scalar, Sequence
from vibcli.language.document.tree_builder import TOO_DEEP

if TYPE_CHECKING:
    from vibcli.language.document.tree_builder import Tree

LOOK_ABOVE = "compare the indentation, quotes and brackets with the lines above"
QUOTE_IT = "put the whole value in quotes"
KEY_VALUE = "write key: value, with a colon and a space after the key"
CLOSER = {"[": "]", "{": "}"}

_WORD = re.compile(r"[^\s,\[\]{}:'\"]+|.", re.DOTALL)
_KEY = re.compile(r"\s*+(?:[?-]\s++)*+([^\s#:][^:]*+):(?:\s|\Z)")  # possessive: takes linear time
_ENTRY = re.compile(r"[a-z_]+: \S")
_LONGEST = 300  # characters of a hint that quotes the file


class Halt:
    """The place where the parser stopped: `index`, `where`, and the `char` and `word` there; `start`, the index of what
    it could not finish, such as an opening quote."""

    def __init__(self, error: Exception, tree: "Tree") -> None:
        mark, start = getattr(error, "problem_mark", None), getattr(error, "context_mark", None)
        self.problem, self.context = getattr(error, "problem", None) or str(error), getattr(error, "context", None)
        self.tree, self.file = tree, tree.file
        self.source = tree.source.translate(tree.hidden) if tree.hidden else tree.source
        self.index = min(mark.index, len(self.source)) if mark else 0
        self.start = start.index if start else self.index
        self.where = self.at(self.index)
        self.char = self.source[self.index : self.index + 1]
        self.word = _WORD.match(self.source, self.index)[0] if self.char else ""

    def at(self, index: int, width: int = 1) -> Where:
        return decoding.place(self.source, index, self.file, width)

    def here(self) -> Where:
        """The place of the word at which the parser stopped."""
        return self.where._replace(width=max(1, len(self.word)))

    def before(self) -> str:
        """The text of the line up to where the parser stopped."""
        return self.source[self.index - self.where.column + 1 : self.index]

    def line(self, where: Where | None = None) -> str:
        """The text of the line of a place."""
        return decoding.split(self.source)[(where or self.where).line - 1]


def slip(error: Exception, tree: "Tree") -> tuple[Diagnostic, str, int] | None:
    """A bracket inside a flow collection that belongs to a name (see misread_expressions.py), or None."""
    mark, last = getattr(error, "problem_mark", None), tree.last
    if mark is None or last is None or last.style or "',' or " not in str(error):
        return None
    if tree.source[mark.index : mark.index + 1] != "[" or last.end_mark.index != mark.index:
        return None
    return misread_expressions.bracket(tree.source, last.start_mark.index, tree.file)


def explained(error: Exception, tree: "Tree") -> Diagnostic:
    """The diagnostic for an error of the YAML parser."""
    halt = Halt(error, tree)
    said = f"{halt.context} {halt.problem}"
    explain = next((explain for words, explain in _EXPLAINED if words in said), None)
    words = f"{halt.problem} {halt.context}" if halt.context else halt.problem
    return Diagnostic(*((explain and explain(halt)) or (halt.here(), f"this is no YAML: {words}", LOOK_ABOVE)))


def not_a_mapping(node: Scalar | Sequence, source: str) -> Diagnostic:
    """The diagnostic for a file whose top level is a list or a text."""
    expected = "expected keys such as 'bodies:' at the top level"
    if isinstance(node, Sequence):
        return Diagnostic(node.where, f"{expected}, found a list", "write a key, and the list under it")
    line = decoding.split(source)[node.where.line - 1]
    return Diagnostic(node.where, f"{expected}, found {quoted(node.text)}", _key_value(line))


def _key_value(line: str) -> str:
    """The hint for a line that should have been `key: value`."""
    name, colon, value = line.partition(":")
    if colon and value.strip() and not value.startswith(" "):
        return f"put a space after the colon, {name.strip()}: {value.strip()}"[:_LONGEST]
    return KEY_VALUE


def _tab(halt: Halt) -> tuple[Where, str, str]:
    index = halt.source.find("\t", halt.index - halt.where.column + 1)
    what = "in the indentation" if not halt.before().strip() else "between the words"
    return halt.at(max(index, 0)), f"found a tab {what}, expected spaces", "replace each tab by spaces"


def _start(halt: Halt) -> tuple[Where, str, str]:
    """A tab, or a character with which no value can start."""
    if halt.char == "\t":
        return _tab(halt)
    at = halt.start if "scanning an a" in (halt.context or "") else halt.index
    return halt.at(at), f"no value can start with {quoted(halt.source[at : at + 1])}", QUOTE_IT


def _quote(halt: Halt) -> tuple[Where, str, str] | None:
    mark = halt.source[halt.start : halt.start + 1]
    if mark not in ("'", '"'):
        return None
    return halt.at(halt.start), f"the quote {mark} opened here is never closed", f"write {mark} where it ends"


def _colon(halt: Halt) -> tuple[Where, str, str]:
    """A ': ' where no key can be."""
    before, last = halt.before(), halt.tree.last
    key = _KEY.match(before)
    if key:
        value = (before[key.end() :] + halt.line()[len(before) :]).split(" #")[0].strip()
        name, brace, first = key[1].partition("{")
        if brace and name.strip().isidentifier():
            place = halt.at(halt.index - len(before) + before.index(brace))
            return (place, f"expected a ':' after {quoted(name.strip())}",
                    f"write {name.strip()}: {{{first}: {value}"[:_LONGEST])
        if before[:1].isspace() and _ENTRY.match(value):
            return (halt.here(), f"found a second ':' in the line of the key {quoted(key[1])}",
                    f"put braces around its keys, {key[1]}: {{{value}}}"[:_LONGEST])
        mark = "'" if '"' in value or "\\" in value else '"'
        hint = QUOTE_IT if mark in value else f"{QUOTE_IT}, {key[1]}: {mark}{value}{mark}"
        return halt.here(), f"found a second ':' in the line of the key {quoted(key[1])}", hint[:_LONGEST]
    if last is None or not last.start_mark.line < last.end_mark.line == halt.where.line - 1:
        return halt.here(), "found a ':' where no key can stand", QUOTE_IT
    first = halt.at(last.start_mark.index)
    if not _KEY.match(halt.line(first)[: first.column - 1]):
        return _no_colon(halt, first)
    width = max(1, len(before.strip()))
    return (halt.at(halt.index - width, width),
            f"indented deeper than line {first.line}, whose key has a value already",
            f"start it in the same column as the key of line {first.line}")


def _no_colon(halt: Halt, first: Where | None = None) -> tuple[Where, str, str]:
    """A line that should have been `key: value`."""
    first = first or halt.at(halt.start)
    text = halt.line(first)[first.column - 1 :].rstrip()
    found = quoted(text) if len(text) < 1000 else "a text too long for a key"
    return first._replace(width=max(1, len(text))), f"expected key: value, found {found}", _key_value(text)


def _tight_colon(halt: Halt) -> tuple[Where, str, str]:
    return halt.here(), "expected a space after the ':'", "put a space after the colon"


def _bracket(halt: Halt) -> tuple[Where, str, str] | None:
    """An entry of [ ] or { } that neither a comma nor the closing bracket follows."""
    tree, source = halt.tree, halt.source
    start = next((i for _, _, i in reversed(tree.stack) if source[i] in CLOSER), None) if tree.flow else None
    if start is None or halt.char in ("]", "}"):
        return None
    opened, opener = halt.at(start), source[start]
    at_end = not source[halt.index :].strip()
    if at_end or (halt.where.line > opened.line and _indent(halt.line()) <= _indent(halt.line(opened))):
        before = "" if at_end else f" before line {halt.where.line}"
        message = f"the '{opener}' opened here is never closed{before}"
        return opened, message, f"write '{CLOSER[opener]}' where it ends"
    if "',' or " not in halt.problem:
        return None
    return (halt.here(), f"expected ',' or '{CLOSER[opener]}' after this entry, found {quoted(halt.word)}",
            "put a comma between two entries")


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())


def _indentation(halt: Halt) -> tuple[Where, str, str] | None:
    """A line that belongs neither to the entry before it nor to the mapping or list around it."""
    before, last = halt.before().rstrip(), halt.tree.last
    if before[-1:] in ("'", '"') and last is not None and last.start_mark.line < halt.where.line - 1:
        return (halt.at(last.start_mark.index), f"the quote {before[-1]} opened here is closed only in "
                f"line {halt.where.line}", f"write {before[-1]} where it ends")
    if before[-1:] in ("'", '"'):
        hint = "put the whole value in double quotes" if before[-1] == "'" else QUOTE_IT
        return halt.here(), f"expected the end of the line after the closing quote, found {quoted(halt.word)}", hint
    if before or halt.char in ("]", "}", ":", "-"):
        return None
    return (halt.here(), f"the indentation of {quoted(halt.word)} fits none of the lines above",
            "start it in the same column as the entries it belongs with")


_EXPLAINED = (  # words of libyaml and of the pure Python parser, the more specific ones first
    ("maximum nesting depth", lambda halt: (halt.here(), *TOO_DEEP)),
    ("tab character", _tab),
    ("cannot start any token", _start),
    ("scanning an anchor", _start),
    ("scanning an alias", _start),
    ("',' or ", _bracket),
    ("expected node content", _bracket),
    ("expected the node content", _bracket),
    ("unexpected end of stream", _quote),
    ("unexpected document", _quote),
    ("mapping values are not allowed", _colon),
    ("could not find expected ':'", _no_colon),
    ("unexpected ':'", _tight_colon),
    ("expected key", _indentation),
    ("'-' indicator", _indentation),
    ("block end", _indentation),
)
