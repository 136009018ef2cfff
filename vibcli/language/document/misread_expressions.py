"""Expressions in flow collections that YAML cuts apart: `{omega[1]: 3}` and `{by: atan2(x, y)}`.

The slip is reported, its brackets and commas are hidden behind stand-ins of the same length, and the file is
read again: so the rest is checked, every column stays true, and the tree holds the expression as meant.
"""

from vibcli.base import decoding
from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic

_HIDE = str.maketrans(",[]{}:", "\ue000\ue001\ue002\ue003\ue004\ue005")
SHOW = {stand_in: char for char, stand_in in _HIDE.items()}
_CLOSER = {"(": ")", "[": "]", "{": "}"}
_LONGEST = 2000


def comma(source: str, start: int, file: str) -> tuple[Diagnostic, str, int] | None:
    """(diagnostic, mended source, index) for an expression at `start` that a comma has cut, or None."""
    end = _expression_end(source, start)
    if end is None or "," not in source[start:end]:
        return None
    text, inner = source[start:end], source[start + 1:end - 1]
    if text == f"({inner})" and not set(inner) & set("()[]{}"):
        written = f"[{inner}]"
        problem = Diagnostic(decoding.place(source, start, file, end - start),
                             f"expected a list in square brackets, found {quoted(text)}", f"write {written}")
        return problem, source[:start] + written + source[end:], start
    return _mended(source, start, end, file, "the comma cuts {} in two")


def bracket(source: str, start: int, file: str) -> tuple[Diagnostic, str, int] | None:
    """(diagnostic, mended source, index) for a name at `start` with a [ right after it, or None."""
    end = _expression_end(source, start)
    return None if end is None else _mended(source, start, end, file, "the brackets of {} need quotes")


def _expression_end(source: str, start: int) -> int | None:
    """The end of the expression: a comma, closing bracket, ': ' or comment outside its own brackets."""
    closers = []
    for index in range(start, min(len(source), start + _LONGEST)):
        char = source[index]
        if char in _CLOSER:
            closers.append(_CLOSER[char])
        elif closers and char == closers[-1]:
            closers.pop()
        elif char in "\r\n" or (closers and char in ")]}"):
            return None
        elif not closers and (char in ",]}" or source[index : index + 2] in (": ", ":,", ":}", ":\n", " #")):
            return start + len(source[start:index].rstrip())
    return None


def _mended(source: str, start: int, end: int, file: str, said: str) -> tuple[Diagnostic, str, int]:
    text = source[start:end].translate(SHOW)
    mark = "'" if '"' in text or "\\" in text else '"'
    problem = Diagnostic(decoding.place(source, start, file, end - start),
                         f"inside [ ] and {{ }} {said.format(quoted(text))}",
                         f"write {mark}{text}{mark}, or give it a line of its own outside the brackets")
    return problem, source[:start] + source[start:end].translate(_HIDE) + source[end:], start
