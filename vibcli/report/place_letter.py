"""The place along members is x in what is printed, or another letter where a coordinate or parameter has that name."""

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Factor, Words
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.node import Node

if TYPE_CHECKING:
    from vibcli.report.blocks import Line
    from vibcli.scene.scene import Scene

LETTERS = "x", "ξ", "s", "χ"
WRITTEN = {"ξ": "xi", "χ": "chi"}
PLACE = re.compile(r"x(?!p\()")         # within formulas, but for exp(
WORD = re.compile(r"(?<![^\W\d])x(?= = | counts|, counted)|(?<=an element d)x\b")     # within words: the place


def place_letter(scene: "Scene") -> str:
    """The first that no coordinate or parameter has."""
    taken = {*scene.coordinates, *scene.parameters.nodes}
    return next((one for one in LETTERS if one not in taken and WRITTEN.get(one) not in taken), "x")


def by_letter(parts: Sequence[Any], letter: str) -> tuple:
    """Parts of a formula in which the place is x, by its letter."""
    return tuple(parts) if letter == "x" else tuple(_by_letter(part, letter) for part in parts)


def words_by_letter(text: str, letter: str) -> str:
    """Words that speak of the place x."""
    return WORD.sub(letter, text)


def lines_by_letter(lines: "Sequence[Line]", letter: str) -> "list[Line]":
    """Lines, and what stands before each."""
    return [one._replace(parts=by_letter(one.parts, letter), label=by_letter(one.label, letter)) for one in lines]


def _by_letter(part, letter):
    if type(part) is str:
        return PLACE.sub(letter, part)
    if isinstance(part, Words):
        return Words(words_by_letter(part.text, letter))
    if isinstance(part, Factor):
        return Factor(_by_letter(part.node, letter))
    if isinstance(part, Node):
        table = part.table
        return substitute([part], {table.parameter(wave + "x"): table.parameter(wave + letter) for wave in "αβ"})[0]
    return part
