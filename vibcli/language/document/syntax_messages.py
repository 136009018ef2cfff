"""What YAML's parser says when it gives up, in plain words: the place, what was expected, what to write."""

import re

from vibcli.base import decoding
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic
from vibcli.language.document import flow_messages, misread_expressions
from vibcli.language.document.nodes import Sequence
from vibcli.language.document.parser_stop import LOOK_ABOVE, QUOTE_IT, Halt

_ODD_SPACE = re.compile("[\xa0\u1680\u2000-\u200a\u202f\u205f\u3000]")
_KEY = re.compile(r"\s*+(?:[?-]\s++)*+([^\s#:][^:]*+):(?:\s|\Z)")  # possessive: takes linear time
_LONGEST = 300  # characters of a hint that quotes the file


def slip(error, tree):
    """A bracket inside a flow collection that belongs to a name (see slips.py), or None."""
    mark, last = getattr(error, "problem_mark", None), tree.last
    if mark is None or last is None or last.style or "',' or " not in str(error):
        return None
    if tree.source[mark.index : mark.index + 1] != "[" or last.end_mark.index != mark.index:
        return None
    return misread_expressions.bracket(tree.source, last.start_mark.index, tree.file)


def explained(error, tree):
    """The diagnostic for an error of the YAML parser."""
    halt = Halt(error, tree)
    explain = next((explain for words, explain in _EXPLAINED if words in halt.problem), _unknown)
    where, message, hint = explain(halt)
    return Diagnostic(where, message, _odd_space(halt.line(where)) or hint)


def not_a_mapping(node, source):
    """The diagnostic for a file whose top level is a list or a text."""
    expected = "expected keys such as 'bodies:' at the top level"
    if isinstance(node, Sequence):
        return Diagnostic(node.where, f"{expected}, found a list", "write a key, and the list under it")
    line = decoding.split(source)[node.where.line - 1]
    hint = _odd_space(line) or _key_value(line)
    return Diagnostic(node.where, f"{expected}, found {quoted(node.text)}", hint)


def _odd_space(line):
    """The hint for a line with a space that looks plain and is not."""
    found = _ODD_SPACE.search(line)
    return found and f"replace U+{ord(found[0]):04X} in column {found.start() + 1} by a plain space"


def _key_value(line):
    """The hint for a line that should have been `key: value`."""
    name, colon, value = line.partition(":")
    if colon and value.strip() and not value.startswith(" "):
        return f"put a space after the colon, {name.strip()}: {value.strip()}"[:_LONGEST]
    return "write key: value, with a colon and a space after the key"


def _unknown(halt):
    return halt.here(), f"this cannot be read on: {halt.found()}", LOOK_ABOVE


def _tab(halt):
    index = halt.source.find("\t", halt.index - halt.where.column + 1)
    what = "in the indentation" if not halt.before().strip() else "between the words"
    return halt.at(max(index, 0)), f"found a tab {what}, expected spaces", "replace each tab by spaces"


def _start(halt):
    if halt.char == "\t":
        return _tab(halt)
    return (halt.here()._replace(width=1), f"no value can start with {quoted(halt.char)}",
            "put the value in quotes if the character is meant")


def _quote(halt):
    mark = halt.source[halt.start : halt.start + 1]
    hint = f"write {mark} where it ends"
    if mark == "'":
        hint += "; a text that holds ' goes in double quotes"
    return halt.at(halt.start), f"the quote {mark} opened here is never closed", hint


def _escape(halt):
    index = max(0, halt.source.rfind("\\", 0, halt.index + 1))
    text = re.compile(r"\\(?:[xuU][0-9a-fA-F]{0,8}|.)?").match(halt.source, index)
    text = text[0] if text else halt.char
    return (halt.at(index, max(1, len(text))), f"{quoted(text)} stands for no character in double quotes",
            "use single quotes, in which \\ is an ordinary character, or write \\\\")


def _colon(halt):
    """A ': ' where no key can be."""
    before, last = halt.before(), halt.tree.last
    key = _KEY.match(before)
    if key:
        value = (before[key.end() :] + halt.line()[len(before) :]).split(" #")[0].strip()
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


def _no_colon(halt, first=None):
    """A line that should have been `key: value`."""
    first = first or halt.at(halt.start)
    text = halt.line(first)[first.column - 1 :].rstrip()
    found = quoted(text) if len(text) < 1000 else "a text too long for a key"
    return first._replace(width=max(1, len(text))), f"expected key: value, found {found}", _key_value(text)


def _item(halt):
    key = _KEY.match(halt.before())
    if not key:
        return halt.here(), "found a list item '- ' where no list can start", LOOK_ABOVE
    return (halt.here(), f"found a list item '- ' on the line of the key {quoted(key[1])}",
            "start the list on the next line, or write [a, b]; write a negative number without a space")


def _question(halt):
    return halt.here(), "no value can start with '? '", "put the value in quotes if the character is meant"


def _block(halt):
    """What follows an entry belongs neither to it nor to the mapping or list around it."""
    before, last = halt.before().rstrip(), halt.tree.last
    in_list = "'-' indicator" in halt.problem or "collection" in halt.problem
    if halt.char in ("]", "}"):
        return flow_messages.stray_bracket(halt)
    if before[-1:] in ("'", '"') and last is not None and last.start_mark.line < halt.where.line - 1:
        return (halt.at(last.start_mark.index), f"the quote {before[-1]} opened here is closed only in "
                f"line {halt.where.line}", f"write {before[-1]} where it ends")
    if before:
        after = "the closing quote" if before[-1] in "'\"" else quoted(before[-1])
        hint = "put the whole value in double quotes" if before[-1] == "'" else QUOTE_IT
        return halt.here(), f"expected the end of the line after {after}, found {quoted(halt.word)}", hint
    if in_list:
        return (halt.here(), f"expected another list item '- ', found {quoted(halt.word)}",
                "indent what belongs to the item above deeper, a new key less")
    if halt.char == ":":
        return halt.here(), "found ':' without a key before it", "write key: value"
    if halt.char == "-":
        return halt.here(), "found a list item '- ' among keys", "put the list under a key of its own"
    return (halt.here(), f"the indentation of {quoted(halt.word)} fits none of the lines above",
            "start it in the same column as the entries it belongs with")


def _tag(halt):
    index = max(0, halt.source.find("!", halt.start))
    text = re.compile(r"\S*").match(halt.source, index)[0]
    return (halt.at(index, max(1, len(text))), f"found the tag {quoted(text)}, which scenes do not use",
            "leave it out; a text that starts with ! needs quotes")


def _name_due(halt):
    mark = quoted(halt.source[halt.start : halt.start + 1])
    return halt.at(halt.start), f"no value can start with {mark}", QUOTE_IT


def _directive(halt):
    return halt.at(halt.start), "found a '%' directive, which scenes do not use", "leave the line out"


def _tight_colon(halt):
    return halt.here(), "expected a space after the ':'", "put a space after the colon"


def _block_text(halt):
    mark = quoted(halt.source[halt.start : halt.start + 1])
    return (halt.at(halt.start), f"expected the end of the line after {mark}",
            "put the text on the lines below, indented, or in quotes")


def _after_end(halt):
    return halt.here(), f"expected the end of the scene, {halt.found()}", "give each scene its own file"


_EXPLAINED = (  # words of libyaml and of the pure Python parser, the more specific ones first
    ("tab character", _tab),
    ("found character '\\t'", _start),
    ("cannot start any token", _start),
    ("',' or ", flow_messages.no_comma),
    ("expected node content", flow_messages.no_value),
    ("expected the node content", flow_messages.no_value),
    ("unknown escape", _escape),
    ("hexdecimal", _escape),
    ("hexadecimal", _escape),
    ("Unicode character escape", _escape),
    ("a quoted scalar", _quote),
    ("mapping values are not allowed", _colon),
    ("sequence entries are not allowed", _item),
    ("mapping keys are not allowed", _question),
    ("could not find expected ':'", _no_colon),
    ("unexpected ':'", _tight_colon),
    ("an anchor", _name_due),
    ("an alias", _name_due),
    ("directive", _directive),
    ("YAML document", _directive),
    ("a tag", _tag),
    ("tag handle", _tag),
    ("a block scalar", _block_text),
    ("document start", _after_end),
    ("expected key", _block),
    ("'-' indicator", _block),
    ("block end", _block),
)
