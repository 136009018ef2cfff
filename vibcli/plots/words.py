"""Texts on plots: what prints, how wide it is, its cells in a terminal."""

import unicodedata


def printable(text: str) -> str:
    """The text on one line, without characters that do not print or turn the direction of writing."""
    text = " ".join(str(text).split())
    return "".join(letter for letter in text if unicodedata.category(letter)[0] != "C")


def cells(text: str) -> list[str]:
    """The text column by column: a letter with its combining dots; a wide letter and an empty cell."""
    found = []
    for letter in text:
        if unicodedata.combining(letter) and found:
            found[-1] += letter
        else:
            found += [letter, ""] if unicodedata.east_asian_width(letter) in "WF" else [letter]
    return found


def width(text: str) -> int:
    """Columns of a text in a terminal."""
    return len(cells(text))


def shortened(text: str, columns: int) -> str:
    """At most so many columns, the end cut off as …"""
    found = cells(text)
    if len(found) <= columns:
        return text
    kept = found[:max(columns - 1, 0)]
    if kept and found[len(kept)] == "":
        kept.pop()
    return "".join(kept) + "…" * (columns > 0)


def with_its_unit(label: str, columns: int) -> str:
    """A label "name [unit]" of at most so many columns; where it is longer the unit stands in a line of its own."""
    name, _, unit = label.rpartition(" [")
    return shortened(label, columns) if width(label) <= columns or not name else f"{shortened(name, columns)}\n[{unit}"
