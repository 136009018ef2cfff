"""From the bytes of a scene file to its text: UTF-8, without characters that could steer a terminal or a reader."""

import re
from functools import cache
from typing import Any

from vibcli.base.errors import Diagnostic, Where

MAX_BYTES = 2**20
MAX_SHOWN = 20  # odd characters are named one by one up to here

BIDI = "\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069"
INVISIBLE = "\xad\u200b\u2028\u2029\u2060-\u2065\u206a-\u206f\ufeff\ufff9-\ufffb\U000e0000-\U000e007f"
CONTROL = "\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff"
STAND_IN = "\ufffd"  # takes the place of a forbidden character, so that reading goes on with all columns kept


@cache
def forbidden() -> re.Pattern[str]:
    """Matches one character that no file may have; compiled where a text holds what does not print."""
    return re.compile(f"[{CONTROL}{BIDI}{INVISIBLE}]")


def prints(text: str) -> bool:
    """Whether all of the text prints but its tabs and line breaks, so that nothing in it is forbidden."""
    return text.replace("\n", "").replace("\t", "").replace("\r", "").isprintable()


def decode(data: bytes, file: str) -> tuple[str, list[Any]]:
    """The text of the bytes, or None where they are not text, and the diagnostics so far."""
    if len(data) > MAX_BYTES:
        return None, [too_long(file)]     # who read them may have stopped there
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return None, [Diagnostic(Where(file, 1, 1), "the file is written in UTF-16, expected UTF-8",
                                 "save it as UTF-8 in the editor")]
    if b"\0" in data:
        where = _place_of_byte(data, data.index(0), file)
        return None, [Diagnostic(where, "found a NUL byte: this is not a text file",
                                 "give a scene written as plain text in UTF-8")]
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return None, [_not_utf8(data, error.start, file)]
    return _without_forbidden(text.removeprefix("\ufeff"), file)


def lines(data: bytes) -> list[str]:
    """The source lines for display, whatever the bytes are; line and column agree with every diagnostic."""
    return split(data[:MAX_BYTES].decode("utf-8", "replace").removeprefix("\ufeff"))


def split(text: str) -> list[str]:
    """The lines of a text, at the breaks that YAML counts."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def place(text: Any, index: int, file: str, width: int = 1) -> Where:
    """The line and column of a character of the text."""
    line = 1 + text.count("\n", 0, index) + text.count("\r", 0, index) - text.count("\r\n", 0, index)
    start = 1 + max(text.rfind("\n", 0, index), text.rfind("\r", 0, index))
    return Where(file, line, index - start + 1, width)


def cleaned(text: str) -> str:
    """The text with a stand-in for every control, bidirectional and invisible character; lines stay."""
    return (text if prints(text) else forbidden().sub(STAND_IN, text)).replace("\r", STAND_IN)


def on_one_line(text: str) -> str:
    """The same with its white space as single spaces, where no line is to be broken as it is."""
    return re.sub(r"[^\S\N{NO-BREAK SPACE}]+", " ", cleaned(text))


def too_long(file: str, size: int | None = None) -> Diagnostic:
    """What is said of a file of more bytes than a scene may have; size: how many, where that is known."""
    held = f"more than {MAX_BYTES} bytes" if size is None else f"{size} bytes, expected at most {MAX_BYTES}"
    return Diagnostic(Where(file, 1, 1, 0), f"the file holds {held}",
                      "a scene takes a few kilobytes: is this the right file?")


def name_of(char: str) -> str:
    """The kind and number of a forbidden character, for a message."""
    kinds = (("bidirectional", BIDI), ("invisible", INVISIBLE))
    kind = next((kind for kind, members in kinds if re.match(f"[{members}]", char)), "control")
    return f"the {kind} character U+{ord(char):04X}"


def _place_of_byte(data: bytes, index: int, file: str) -> Where:
    text = data[:index].decode("utf-8", "replace").removeprefix("\ufeff")
    return place(text, len(text), file)


def _not_utf8(data: bytes, index: int, file: str) -> Diagnostic:
    guess = data[index : index + 1].decode("latin-1")
    looks = f" (in Latin-1 it would be '{guess}')" if guess.isprintable() else ""
    return Diagnostic(_place_of_byte(data, index, file),
                      f"the byte 0x{data[index]:02x} is not UTF-8{looks}",
                      "save the file as UTF-8 in the editor")


def _without_forbidden(text: str, file: str) -> tuple[str, list[Diagnostic]]:
    problems = []
    for found in () if prints(text) else forbidden().finditer(text):
        where = place(text, found.start(), file)
        if len(problems) == MAX_SHOWN:
            problems.append(Diagnostic(where, "more characters of this kind: reading stops here",
                                       "is this a text file?"))
            return None, problems
        problems.append(Diagnostic(where, f"found {name_of(found[0])}", "delete it"))
    if problems:
        text = forbidden().sub(STAND_IN, text)
    lone = re.search("\r(?!\n)", text) if "\r" in text else None
    if lone:
        problems.append(Diagnostic(place(text, lone.start(), file),
                                   "found a carriage return that no line feed follows",
                                   "save the file with line ends LF or CRLF"))
    return text, problems
