"""Plain text in columns, at most WIDTH wide."""

import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

WIDTH = 88
JOINT = "\x1f"


def paragraph(text: Any, indent: Any = 0) -> list[str]:
    """Wrapped lines of a text; what stands between backquotes stays on one line."""
    space = " " * indent
    lines = textwrap.wrap(_joined(text), WIDTH, initial_indent=space, subsequent_indent=space, break_on_hyphens=False,
                          break_long_words=False)
    return [line.replace(JOINT, " ") for line in lines]


def _joined(text: str) -> str:
    """The text with its code, between backquotes, as one word."""
    return re.sub(r"`[^`]{1,60}`", lambda code: code.group().replace(" ", JOINT), text)


def table(rows: Iterable[Any], indent: int = 2, least: int = 0) -> list[str]:
    """Rows (term, text, …): the terms in one column, their texts wrapped one below the other in the next."""
    rows = list(rows)
    column = indent + max([least, *(len(row[0]) for row in rows)]) + 2
    lines = []
    for term, *texts in rows:
        body = [line for text in texts if text for line in paragraph(text, column)] or [""]
        lines.append((" " * indent + term).ljust(column) + body[0][column:])
        lines += body[1:]
    return [line.rstrip() for line in lines]


def listed(words: Mapping[str, str | tuple[str, ...]], indent: int = 2) -> list[str]:
    """Words separated by commas, wrapped."""
    return paragraph(", ".join(words), indent)


def blocks(*parts: Sequence[str]) -> str:
    """Blocks of lines, an empty line between them."""
    return "\n\n".join("\n".join(part) for part in parts if part)


def either(words: Sequence[str], last: str = "or") -> str:
    """`a`, `b` or `c`."""
    quoted = [f"`{word}`" for word in words]
    return quoted[0] if len(quoted) == 1 else ", ".join(quoted[:-1]) + f" {last} " + quoted[-1]


def in_short(text: str) -> str:
    """The first clause of a text, to stand in a list."""
    clause = re.split(r"[.;:] ", _joined(text))[0].rstrip(".").replace(JOINT, " ")
    return clause[0].lower() + clause[1:] if clause[1:2].islower() or clause[1:2] == " " else clause
