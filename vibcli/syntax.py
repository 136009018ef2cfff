"""What YAML's parser says when it gives up, in plain words: where the slip is, what was expected, what to write."""

import re

from vibcli import decoding, slips
from vibcli.diagnostics import quoted
from vibcli.errors import Diagnostic
from vibcli.tree import Sequence

_WORD = re.compile(r"[^\s,\[\]{}:'\"]+|.", re.DOTALL)
_ODD_SPACE = re.compile("[\xa0\u1680\u2000-\u200a\u202f\u205f\u3000]")
_KEY = re.compile(r"[\s?-]*([^\s#][^:]*):(?:\s+|\Z)")
_CLOSER = {"[": "]", "{": "}"}


def slip(error, tree):
    """A bracket inside a flow collection that belongs to a name (see slips.py), or None."""
    mark, last = getattr(error, "problem_mark", None), tree.last
    if mark is None or last is None or last.style or "',' or " not in str(error):
        return None
    if tree.source[mark.index : mark.index + 1] != "[" or last.end_mark.index != mark.index:
        return None
    return slips.bracket(tree.source, last.start_mark.index, tree.file)


def explained(error, tree):
    """The diagnostic for an error of the YAML parser."""
    halt = Halt(error, tree)
    for words, explain in _EXPLAINED:
        if words in halt.problem:
            where, message, hint = explain(halt)
            break
    else:
        where, message, hint = halt.here(), f"cannot read on here: {_found(halt)}", _LOOK_ABOVE
    return Diagnostic(where, message, _odd_space(halt.line(where)) or hint)


def not_a_mapping(node, source):
    """The diagnostic for a file whose top level is a list or a text."""
    if isinstance(node, Sequence):
        return Diagnostic(node.where, "expected keys such as bodies: at the top level, found a list",
                          "write a key before it, and the list under the key")
    line = decoding.split(source)[node.where.line - 1]
    return Diagnostic(node.where, f"expected keys such as bodies: at the top level, found {quoted(node.text)}",
                      _odd_space(line) or _missing_colon(line))


_LOOK_ABOVE = "compare the indentation, quotes and brackets with the lines above"
_QUOTE_IT = "put the whole value in quotes"


def _odd_space(line):
    found = _ODD_SPACE.search(line)
    if not found:
        return None
    return f"column {found.start() + 1} of line holds U+{ord(found[0]):04X}, not a plain space: replace it"


def _found(halt):
    return "the file ends" if halt.at_end else f"found {quoted(halt.word)}"


def _missing_colon(line):
    name, colon, value = line.partition(":")
    if colon and value.strip() and not value.startswith(" "):
        return f"put a space after the colon: {name.strip()}: {value.strip()}"[:200]
    return "write key: value, with a colon and a space after the key"


def _tab(halt):
    index = halt.index
    if halt.char != "\t":
        index = halt.source.find("\t", index - halt.where.column + 1)
    return halt.at(max(index, 0)), "found a tab in the indentation, expected spaces", "replace each tab by spaces"


def _start(halt):
    if halt.char == "\t":
        return _tab(halt)
    return (halt.here(), f"no value can start with {quoted(halt.char)}",
            "put the value in quotes if the character is meant")


def _quote(halt):
    start = halt.start if halt.start is not None else halt.index
    mark = halt.source[start : start + 1]
    if mark == "'":
        return (halt.at(start), "the quote ' opened here is never closed",
                "write ' where it ends; to use ' inside, double it or quote with \"")
    return halt.at(start), f"the quote {mark} opened here is never closed", f"write {mark} where it ends"


def _escape(halt):
    index = halt.source.rfind("\\", 0, halt.index + 1)
    text = halt.source[max(index, 0) : index + 2]
    return (halt.at(max(index, 0), 2), f"{quoted(text)} is not an escape that double quotes know",
            "use single quotes, in which \\ is an ordinary character, or write \\\\")


def _second_colon(halt):
    """A ': ' where no key can be."""
    before, last = halt.before(), halt.tree.last
    key = _KEY.match(before)
    if key:
        value = (before[key.end() :] + halt.line()[len(before) :]).split(" #")[0].strip()
        mark = "'" if '"' in value or "\\" in value else '"'
        hint = f"put the value in quotes, {key[1]}: {mark}{value}{mark}" if mark not in value else _QUOTE_IT
        return halt.here(), f"found a second ':' in one line, after {quoted(key[1] + ':')}", hint[:300]
    if last is not None and last.start_mark.line < last.end_mark.line == halt.where.line - 1:
        first = halt.at(last.start_mark.index)
        line = halt.line(first)
        if not _KEY.match(line[: first.column - 1]):
            return first._replace(width=len(line[first.column - 1 :].rstrip()) or 1), \
                f"expected key: value, found {quoted(line.strip())}", _missing_colon(line)
        return (halt.at(last.end_mark.index - len(before.strip()), len(before.strip()) or 1),
                f"indented deeper than line {first.line}, whose key has a value already",
                f"indent it as line {first.line}, or leave that value out")
    return halt.here(), "found a ':' where no key can stand", _QUOTE_IT


def _item(halt):
    key = _KEY.match(halt.before())
    if key:
        return (halt.here(), f"found a list item '- ' on the line of the key {quoted(key[1])}",
                "start the list on the next line, or write [a, b]; write a negative number without a space")
    return halt.here(), "found a list item '- ' where no list can start", _LOOK_ABOVE


def _question(halt):
    return halt.here(), "no value can start with '? '", "put the value in quotes if the character is meant"


def _colon(halt):
    start = halt.start if halt.start is not None else halt.index
    first = halt.at(start)
    text = halt.line(first)[first.column - 1 :].rstrip()
    if len(text) > 1000:
        return first, "expected key: value, found a text too long for a key", _missing_colon(text)
    return (first._replace(width=max(1, len(text))), f"expected key: value, found {quoted(text)}",
            _missing_colon(text))


def _block(halt):
    """A block mapping or list is followed by something that belongs to neither."""
    before = halt.before().rstrip()
    if before and before[-1] in "'\"]}":
        return (halt.here(), f"expected the line to end after {before[-1]}, found {quoted(halt.word)}", _QUOTE_IT)
    if halt.char in ("]", "}"):
        return _content(halt)
    if not before and halt.char == "-" and "'-' indicator" not in halt.problem and "collection" not in halt.problem:
        return halt.here(), "found a list item '- ' among keys", "a list stands under a key, a mapping holds key: value"
    if not before and ("'-' indicator" in halt.problem or "collection" in halt.problem):
        return (halt.here(), f"expected another list item '- ' or a new key further left, found {quoted(halt.word)}",
                "a list holds nothing but '- ' items: indent what belongs to the item above deeper")
    if not before:
        return (halt.here(), f"the indentation of {quoted(halt.word)} fits none of the lines above",
                "start it in the same column as the entries it belongs with")
    return halt.here(), f"expected the end of the value, found {quoted(halt.word)}", _QUOTE_IT


def _anchor(halt):
    start = halt.start if halt.start is not None else halt.index
    return halt.at(start), f"no value can start with {quoted(halt.source[start : start + 1])}", _QUOTE_IT


def _tag(halt):
    start = halt.start if halt.start is not None else halt.index
    index = halt.source.find("!", start)
    text = re.match(r"\S*", halt.source[index:])[0] if index >= 0 else "!"
    return (halt.at(max(index, start), max(1, len(text))), f"found the tag {quoted(text)}, which scenes do not use",
            "leave it out; a text that starts with ! needs quotes")


def _directive(halt):
    start = halt.start if halt.start is not None else halt.index
    return halt.at(start), "found a '%' directive, which scenes do not use", "leave the line out"


def _close_colon(halt):
    return halt.here(), "no space after the ':'", "put a space after the colon"


def _block_text(halt):
    start = halt.start if halt.start is not None else halt.index
    return (halt.at(start), f"expected the end of the line after {halt.source[start : start + 1]}",
            "put the text on the lines below, indented, or in quotes")


def _after_end(halt):
    return halt.here(), f"expected one scene, {_found(halt)} after its end", "give each scene its own file"


_EXPLAINED = (  # words of libyaml and of the pure Python parser, the more specific ones first
    ("tab character", _tab),
    ("found character '\\t'", _tab),
    ("cannot start any token", _start),
    ("',' or ", _flow),
    ("expected node content", _content),
    ("expected the node content", _content),
    ("unknown escape", _escape),
    ("hexdecimal", _escape),
    ("hexadecimal", _escape),
    ("Unicode character escape", _escape),
    ("a quoted scalar", _quote),
    ("mapping values are not allowed", _second_colon),
    ("sequence entries are not allowed", _item),
    ("mapping keys are not allowed", _question),
    ("could not find expected ':'", _colon),
    ("unexpected ':'", _close_colon),
    ("an anchor", _anchor),
    ("an alias", _anchor),
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
