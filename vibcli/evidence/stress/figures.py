"""The figures of a scene file, wherever they stand, and the file with one moved by half a unit of its last digit."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.written_digits import SHORT, digits_written, half_a_unit
from vibcli.evidence.stress.read_again import VALUE, replaced
from vibcli.evidence.stress.rewritten import TOLD, decimal_of, with_numbers
from vibcli.language.document.nodes import Mapping
from vibcli.symbolic.syntax import Number

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Scalar

NOT_DATA = (*TOLD, "answers", "find", "cases", "variants", "mistakes")


class GivenFigure(NamedTuple):
    """The number of so many within an entry of a section; `told`: the name of a parameter, or the number as written and
    what it belongs to; change(top of the document): of that with the figure half a unit of its last digit larger."""

    told: str
    change: Callable[[Mapping], Mapping]


def figures(top: Mapping) -> Iterator[GivenFigure]:
    """Those written with three digits or more: fewer are exact."""
    for section, (_, node) in top.entries.items():
        if section in NOT_DATA:
            continue
        for name in node.entries if isinstance(node, Mapping) else (None,):
            yield from _of_entry(section, name, node if name is None else node.entries[name][1])


def _of_entry(section: str, name: str, node: "Mapping | Scalar") -> Iterator[GivenFigure]:
    found: list[str] = []
    with_numbers(_data(section, node), lambda number, text: found.append(_written(number, text)))
    for place, text in enumerate(found):
        if digits_written(text) >= SHORT:
            of = ".".join(filter(None, (section, name)))
            told = name if section == "parameters" else f"{text} of {of}"
            yield GivenFigure(told, partial(_moved, section=section, name=name, place=place))


def _data(section: str, node: "Mapping | Scalar") -> "Mapping | Scalar":
    """Of a parameter its value alone: ranges and words stand beside it."""
    if section == "parameters" and isinstance(node, Mapping):
        return node.entries[VALUE][1] if VALUE in node.entries else Mapping(node.where)
    return node


def _written(number: Number, text: str) -> str:
    return text[number.start:number.units[0].start if number.units else number.end].strip()


def _moved(top: Mapping, section: str, name: str | None, place: int) -> Mapping:
    """The document with a figure moved."""
    counted = iter(range(10**6))

    def change(number: Number, text: str) -> str | None:
        if next(counted) != place:
            return None
        return decimal_of(number.value + Fraction(repr(half_a_unit(_written(number, text)))))

    def moved(node: Any) -> Any:
        if section == "parameters" and isinstance(node, Mapping):
            return replaced(node, VALUE, lambda value: with_numbers(value, change))
        return with_numbers(node, change)

    return replaced(top, section, moved if name is None else lambda node: replaced(node, name, moved))
