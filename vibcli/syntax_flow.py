"""The parser's errors inside [ ] and { } in plain words."""

def _unclosed(halt, index, before=""):
    opener = halt.source[index : index + 1]
    closer = _CLOSER.get(opener, "]")
    return (halt.at(index), f"the {opener or '['} opened here is never closed{before}",
            f"write {closer} where it ends")


def _innermost(halt):
    """The index of the innermost open bracket."""
    return next((i for _, _, i in reversed(halt.tree.stack) if halt.source[i] in _CLOSER), halt.index)


def _flow(halt):
    """Inside [ ] or { }, an entry is followed by neither a comma nor the closing bracket."""
    start = halt.start if halt.start is not None else _innermost(halt)
    opener = halt.source[start : start + 1]
    closer = _CLOSER.get(opener, "]")
    if halt.at_end:
        return _unclosed(halt, start)
    opened = halt.at(start)
    if halt.char in ("]", "}"):
        return halt.here(), f"expected {closer} to close the {opener} of line {opened.line}, column {opened.column}, " \
            f"found {halt.char}", "brackets close in the reverse order of their opening"
    if halt.where.line > opened.line and _indent(halt.line()) <= _indent(halt.line(opened)):
        return _unclosed(halt, start, f" before line {halt.where.line}")
    if halt.char == ":":
        last = halt.tree.last
        text = last.value if last is not None else ""
        if " " in text:
            return (halt.here(), f"expected ',' or {closer} before the key {quoted(text.split()[-1])}",
                    "put a comma between two entries")
        return halt.here(), "found a second ':' in one entry", _QUOTE_IT
    return halt.here(), f"expected ',' or {closer} to go on, found {quoted(halt.word)}", "put a comma between two entries"


def _indent(line):
    return len(line) - len(line.lstrip())


def _content(halt):
    """A value was due and something else came."""
    if halt.at_end and halt.tree.flow:
        return _unclosed(halt, _innermost(halt))
    if halt.char in ("]", "}"):
        if not halt.tree.flow:
            opener = "[" if halt.char == "]" else "{"
            return halt.here(), f"found {halt.char} with no {opener} before it", "leave it out, or put the value in quotes"
        return _flow(halt)
    if halt.char == ",":
        return halt.here(), "expected a value before the ','", "leave one comma out"
    if halt.char == "-":
        return (halt.here(), "found a list item '- ' inside [ ] or { }",
                "part the items by commas; write a negative number without a space")
    return halt.here(), f"expected a value, {_found(halt)}", _LOOK_ABOVE
