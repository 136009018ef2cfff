"""The YAML parser's errors inside [ ] and { } in plain words: (place, message, hint) of a Halt."""

from vibcli.base.diagnostics import quoted
from vibcli.language.document.parser_stop import CLOSER, LOOK_ABOVE, QUOTE_IT

_COMMA = "put a comma between two entries"


def no_comma(halt):
    """An entry is followed by neither a comma nor the closing bracket."""
    start = halt.start if halt.source[halt.start : halt.start + 1] in CLOSER else halt.bracket()
    closer = CLOSER.get(halt.source[start : start + 1], "]")
    opened = halt.at(start)
    if halt.at_end:
        return _unclosed(halt, start)
    if halt.char in ("]", "}"):
        return _crossed(halt, opened, closer)
    if halt.where.line > opened.line and _indent(halt.line()) <= _indent(halt.line(opened)):
        return _unclosed(halt, start, f" before line {halt.where.line}")
    if halt.char == ":":
        return _second_colon(halt, closer)
    return halt.here(), f"expected ',' or '{closer}' after this entry, found {quoted(halt.word)}", _COMMA


def no_value(halt):
    """A value was due and something else came."""
    if halt.at_end and halt.tree.flow:
        return _unclosed(halt, halt.bracket())
    if halt.char in ("]", "}"):
        return stray_bracket(halt)
    if halt.char == ",":
        return halt.here(), "expected a value before the ','", "leave one comma out"
    if halt.char == "-":
        return (halt.here(), "found a list item '- ' inside [ ] or { }",
                "part the items by commas; write a negative number without a space")
    return halt.here(), f"expected a value, {halt.found()}", LOOK_ABOVE


def stray_bracket(halt):
    """A closing bracket that closes nothing, or not what is open."""
    if halt.tree.flow:
        start = halt.bracket()
        return _crossed(halt, halt.at(start), CLOSER.get(halt.source[start], "]"))
    opener = "[" if halt.char == "]" else "{"
    return (halt.here(), f"found '{halt.char}' with no '{opener}' before it",
            "leave it out; a text that holds it needs quotes")


def _unclosed(halt, start, before=""):
    opener = halt.source[start : start + 1]
    return (halt.at(start), f"the '{opener}' opened here is never closed{before}",
            f"write '{CLOSER.get(opener, ']')}' where it ends")


def _crossed(halt, opened, closer):
    opener = "[" if closer == "]" else "{"
    place = f"line {opened.line}, column {opened.column}"
    return (halt.here(), f"expected '{closer}' to close the '{opener}' of {place}, found '{halt.char}'",
            "brackets close in the reverse order of their opening")


def _second_colon(halt, closer):
    last = halt.tree.last
    words = last.value.split() if last is not None and not last.style else []
    if len(words) < 2:
        return halt.here(), "found a second ':' in one entry", QUOTE_IT
    where = halt.at(max(0, halt.index - len(words[-1])), len(words[-1]))
    return where, f"expected ',' or '{closer}' before the key {quoted(words[-1])}", _COMMA


def _indent(line):
    return len(line) - len(line.lstrip())
