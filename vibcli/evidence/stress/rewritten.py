"""A scene written otherwise: numbers of its document replaced, elements in another order, springs in two."""

import re
from collections.abc import Callable, Iterator
from decimal import Context, Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.units import UNITS
from vibcli.evidence.stress.read_again import replaced
from vibcli.language.document.nodes import Mapping, Scalar, Sequence
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError, Number, parts_of

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import SyntaxTree

TOLD = ("title", "source", "question", "about", "hint", "tags")     # keys of words
OF_ELEMENTS = ("bodies", "springs", "dampers", "forces")
EXACTLY = Context(prec=400)
PARTS = ("series", "parallel")                      # of a spring or damper, what it consists of
HALVED = ("k", "law", "torsion", *PARTS, "preload")     # of a spring, what two in parallel share
AN_EQUATION = "y = 2*x"
EXPONENT = re.compile(r"(?<![^\W\d])[\d.][eE]$")
WORDS = ("static", "true", "false")
TABLE = "table"                                     # of a law, its points
Change = Callable[[Number, str], str | None]        # a number of a text, and the text: what stands for its figures


def with_numbers(node: Any, change: Change) -> Any:
    """The node of a document with each number of its expressions replaced."""
    if isinstance(node, Scalar):
        return _rewritten(node, change)
    if isinstance(node, Sequence):
        found = Sequence(node.where)
        found.items.extend(with_numbers(item, change) for item in node.items)
        return found
    entries = {}
    for key, value in node.entries.values():
        key = _rewritten(key, change)
        entries[key.text] = key, value if key.text in TOLD else with_numbers(value, change)
    return Mapping(node.where, entries)


def _rewritten(scalar: Scalar, change: Change) -> Scalar:
    text, moved = scalar.text, []
    for number in _numbers(text):
        end = number.units[0].start if number.units else number.end
        told = change(number, text)
        if told is not None:
            moved.append((number.start, end, told + " " * bool(number.units)))
    for start, end, told in sorted(moved, reverse=True):
        text = text[:start] + told + text[end:]
    return Scalar(text, scalar.where, scalar.quoted) if moved else scalar


def _numbers(text: str) -> Iterator[Number]:
    """The numbers of an expression or equation, those in arguments of quantities included; none of what is neither."""
    pending = _trees(text) if any(letter.isdigit() for letter in text) else []
    while pending:
        parts = parts_of(pending.pop())
        yield from parts.numbers
        pending += [arg for quantity in parts.quantities for arg in quantity.args]


def _trees(text: str) -> "list[SyntaxTree]":
    try:
        return [parse(text, AN_EQUATION if "=" in text else None)]
    except ExpressionError:
        return []


def scaled(length: int = 0, mass: int = 0, time: int = 0) -> Change:
    """Numbers with units in which lengths, masses and times are 4^… as large."""
    def change(number: Number, _: str) -> str | None:
        power = Fraction(0)
        for unit, exponent, *_more in number.units:
            dimension = UNITS[unit].dimension
            power += exponent * sum(step * dimension.get(base, 0) for base, step in
                                    (("m", length), ("kg", mass), ("s", time)))
        return decimal_of(number.value * power_of_two(power)) if power else None
    return change


def power_of_two(of_four: Fraction) -> Fraction:
    """4^x; PhysicsError where that is no power of two."""
    if (2 * of_four).denominator != 1:
        raise PhysicsError("a unit under a root leaves no power of two")
    return Fraction(2) ** int(2 * of_four)


def decimal_of(number: Fraction) -> str:
    """A number that a decimal holds, exactly."""
    return str(EXACTLY.divide(Decimal(number.numerator), Decimal(number.denominator))).replace("E+", "e").replace(
        "E", "e")


def reordered(top: Mapping) -> Mapping:
    """The elements of each kind from the last to the first."""
    entries = dict(top.entries)
    for kind in OF_ELEMENTS:
        if kind in entries and isinstance(entries[kind][1], Mapping):
            key, found = entries[kind]
            entries[kind] = key, Mapping(found.where, dict(reversed(found.entries.items())))
    return Mapping(top.where, entries)


def in_parallel(top: Mapping) -> Mapping:
    """Each spring as two of half its stiffness, the first of which has its name."""
    entries = dict(top.entries)
    key, springs = entries.get("springs", (None, None))
    if not isinstance(springs, Mapping):
        raise PhysicsError("there are no springs")
    both = {}
    for name, (of_name, record) in springs.entries.items():
        half = _half(record)
        twin = f"{name}_twin"
        both[name] = of_name, half
        both[twin] = Scalar(twin, of_name.where), half
    entries["springs"] = key, Mapping(springs.where, both)
    return Mapping(top.where, entries)


def _half(record: Any) -> Mapping:
    if not isinstance(record, Mapping) or not any(word in record.entries for word in HALVED[:-1]):
        raise PhysicsError("not all springs are given by a stiffness or a law")
    return Mapping(record.where, {word: (key, _halved(value) if word in HALVED else value)
                                  for word, (key, value) in record.entries.items()})


def _halved(value: Any) -> Any:
    """An expression, the forces of a table that the scene holds, or parts."""
    if isinstance(value, Scalar):
        return value if value.text in WORDS else Scalar(f"({value.text})/2", value.where, True)
    if isinstance(value, Mapping):
        return replaced(value, TABLE, _halved)
    found = Sequence(value.where)
    found.items.extend(_half(part) if isinstance(part, Mapping) else _lower(part) for part in value.items)
    return found


def _lower(point: Sequence) -> Sequence:
    """A point of a table at half its force."""
    found = Sequence(point.where)
    argument, force = point.items
    found.items.extend((argument, with_numbers(force, lambda number, _: decimal_of(number.value / 2))))
    return found


def opposite(text: str) -> str:
    """A sum with the other sign, of as many summands: those of a load are steady or in time one by one."""
    found, depth, start = [""], 0, 0
    for place, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        before = text[:place].rstrip()
        if letter in "+-" and not depth and before and before[-1] not in "*/^,+-·" and not EXPONENT.search(
                text[:place]):
            found[-1] += f"({text[start:place].strip()})"
            found.append("+" if letter == "-" else "-")
            start = place + 1
    found[-1] += f"({text[start:].strip()})"
    return "-" + " ".join(found)
