"""Texts in notation, as blocks hold them beside expressions: ω_d = ω·√(1 − ζ²), read for a typeset notation."""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.notation.radicals import closing

if TYPE_CHECKING:
    from vibcli.notation.typeset import Stacked

_SIGNAL = r"[A-Za-z]\w*\.[A-Za-z]\w*\([^()]*\)"         # of a member at a place: arm.u(L), whose force is Q_arm.u(L)
_TOKEN = re.compile(
    r"(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)|(?P<signal>(?!Q_)" + _SIGNAL + r")|(?P<letter>[α-ωΑ-ΡΤ-Ω∂ℓ]|[A-Za-z]+)"
    r"(?:_(?P<word>" + _SIGNAL + r"|[A-Za-z0-9_α-ωΑ-Ω]+[₀-₉]*)|(?P<digits>[₀-₉]+(?:,[₀-₉]+)*))?|(?P<root>√)"
    r"|(?P<gap>\s+)|(?P<operator>.)", re.DOTALL)
_RAISED = re.compile("[⁰¹²³⁴-⁹⁻]+")
_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "01234567890123456789-")
FUNCTIONS = {"sin", "cos", "tan", "exp"}
_RELATION = re.compile(r"\s*([+−=<>≤≥∓±])\s*")


_NEGATIVE = re.compile(r"^[−-](?=[\w.])|(?<=[=<>≤≥(])\s*[−-](?=[\w.])")        # where nothing is taken from
SIGN = "\x00"               # stands for it while the text is read


def read(text: str, write: "Stacked") -> str:
    """The text in a notation, which has the hooks of Stacked."""
    signed = _NEGATIVE.sub(SIGN, re.sub(r"\s*([=<>≤≥])\s*", r"\1", text))
    return write.beside(*_read(_RELATION.sub(r"\1", signed), write))


def _read(text: str, write: "Stacked") -> Iterator[str]:
    at = 0
    while at < len(text):
        found, at = _one(text, at, write)
        if raised := _RAISED.match(text, at):
            found, at = write.power(found, write.numeral(raised.group().translate(_DIGITS))), raised.end()
        elif text.startswith("^", at):
            power, at = _argument(text, at + 1, write)
            found = write.power(found, power)
        yield found


def _one(text: str, at: int, write: "Stacked") -> tuple[str, int]:
    """(what stands at a place, the place after it)."""
    token = _TOKEN.match(text, at)
    kind, at = token.lastgroup, token.end()
    if token["operator"] == SIGN:
        return write.signed(True, "", first=True), at
    if token["number"]:
        return write.numeral(token["number"]), at
    if token["signal"]:
        return write.words(token["signal"]), at
    if token["letter"] in FUNCTIONS:
        return write.functional(token["letter"]), at
    if token["letter"]:
        return write.lettered(token["letter"], token["word"] or (token["digits"] or "").translate(_DIGITS), ""), at
    if kind == "root":
        found, at = _argument(text, at, write)
        return write.sqrt(found), at
    if token["operator"] == "(" and (end := closing(text, at - 1)) is not None:
        return write.flat(read(text[at:end], write)), end + 1
    return (write.gap(len(token["gap"])) if kind == "gap" else write.operator(token["operator"])), at


def _argument(text: str, at: int, write: "Stacked") -> tuple[str, int]:
    """The content of the brackets that open at a place, or the one piece there."""
    end = closing(text, at)
    if end is not None:
        return read(text[at + 1:end], write), end + 1
    return _one(text, at, write) if at < len(text) else ("", at)
