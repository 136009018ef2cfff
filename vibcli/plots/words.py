"""Texts on plots: what prints, how wide it is, its cells in a terminal, its letters in ASCII."""

import unicodedata

_ASCII = {"−": "-", "·": "*", "°": "deg", "–": "-", "—": "-", "…": "~", "×": "x", "√": "sqrt", "∠": "angle ",
          "┤": "+", "┬": "+", "│": "|", "─": "-", "└": "+", "┊": ":", "┈": "-", "µ": "u", "′": "'", "″": "''",
          "∞": "inf", "≤": "<=", "≥": ">=", "≈": "~", "\u0307": "'", "\u0308": "''", "‖": "||", "⁻": "-"}


def printable(text):
    """The text on one line, without characters that do not print or turn the direction of writing."""
    text = " ".join(str(text).split())
    return "".join(letter for letter in text if unicodedata.category(letter)[0] != "C")


def cells(text):
    """The text column by column: a letter with its combining dots; a wide letter and an empty cell."""
    found = []
    for letter in text:
        if unicodedata.combining(letter) and found:
            found[-1] += letter
        else:
            found += [letter, ""] if unicodedata.east_asian_width(letter) in "WF" else [letter]
    return found


def width(text):
    """Columns of a text in a terminal."""
    return len(cells(text))


def shortened(text, columns):
    """At most so many columns, the end cut off as …"""
    found = cells(text)
    if len(found) <= columns:
        return text
    kept = found[:max(columns - 1, 0)]
    if kept and found[len(kept)] == "":
        kept.pop()
    return "".join(kept) + "…" * (columns > 0)


def ascii_text(text):
    """Ω₁² [rad/s] as Omega1^2 [rad/s]."""
    found, raised = [], False
    for letter in unicodedata.normalize("NFC", text):
        plain = _in_ascii(letter)
        above = "<super>" in unicodedata.decomposition(letter)
        found.append("^" + plain if above and not raised else plain)
        raised = above
    return "".join(found)


def _in_ascii(letter):
    if letter.isascii():
        return letter
    if letter in _ASCII:
        return _ASCII[letter]
    name = unicodedata.name(letter, "")
    if name.startswith("GREEK") and " LETTER " in name:
        word = name.partition(" LETTER ")[2].split(" WITH ")[0].lower()
        word = "lambda" if word == "lamda" else word
        return word.capitalize() if "CAPITAL" in name else word
    return "".join(_ASCII.get(part, part if part.isascii() else "?") if part != letter else "?"
                   for part in unicodedata.normalize("NFKD", letter))
