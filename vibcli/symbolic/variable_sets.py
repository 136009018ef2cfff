"""Sets of variables of which there are very many: room is taken for those alone that a set holds.

In any mix with ints that hold a bit for each of the first variables they have `&`, `|`, `~`, `==` and a truth value.
"""

from collections.abc import Iterable
from typing import Any


class VariableSet:
    """bits: an int of the first variables, negative of a complement; others: the numbers beyond these that are in it,
    of a complement those that are not."""

    __slots__ = ("bits", "others")

    def __init__(self, bits: int, others: frozenset[int]) -> None:
        self.bits, self.others = bits, others

    def __and__(self, other: Any) -> "VariableSet | int":
        bits, others = _parts(other)
        if self.bits >= 0:
            found = self.others & others if bits >= 0 else self.others - others
        else:
            found = others - self.others if bits >= 0 else self.others | others
        return _joined(self.bits & bits, found)

    def __or__(self, other: Any) -> "VariableSet | int":
        bits, others = _parts(other)
        if self.bits >= 0 and bits >= 0:
            return VariableSet(self.bits | bits, self.others | others)
        found: VariableSet | int = ~(~self & ~other)
        return found

    def __invert__(self) -> "VariableSet":
        return VariableSet(~self.bits, self.others)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, VariableSet) and (self.bits, self.others) == (other.bits, other.others)

    def __hash__(self) -> int:
        return hash((self.bits, self.others))

    __rand__, __ror__ = __and__, __or__

    @property
    def first(self) -> int:
        """The lowest number in it, counted from 1."""
        return (self.bits & -self.bits).bit_length() or min(self.others) + 1


def union_of(sets: "Iterable[VariableSet | int]") -> VariableSet:
    """All that are in any of these sets, one of which is no int and none a complement: where others add nothing,
    itself."""
    distinct = list({id(one): one for one in sets if one}.values())
    wide = [one for one in distinct if isinstance(one, VariableSet)]
    if len(distinct) == 1:
        return wide[0]
    bits = 0
    for one in distinct:
        bits |= one if isinstance(one, int) else one.bits
    return VariableSet(bits, frozenset[int]().union(*(one.others for one in wide)))


def _parts(variables: int | VariableSet) -> tuple[int, frozenset[int]]:
    return (variables, frozenset()) if isinstance(variables, int) else (variables.bits, variables.others)


def _joined(bits: int, others: frozenset[int]) -> int | VariableSet:
    return VariableSet(bits, others) if others else bits
