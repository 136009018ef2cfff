"""Coefficients at rest that are long: they have a letter each, which is told with what it stands for."""

from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.notation.units_in_sums import dimension_of
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    from vibcli.base.units import Dimension
    from vibcli.report.steps.small import AboutRest
    from vibcli.symbolic.node import Node

READABLE, ROOTED, LONG = 8, 20, 50      # letters, up to which one stands itself: at a searched place, with roots, else
SHOWN, FORCE = 40, 50                   # letters of what a letter, or a force, is, up to which it is written out


def is_long(node: "Node", searched: bool) -> bool:
    """Has an expression at rest so many letters that it gets one of its own?"""
    return letters(node) > (READABLE if searched else ROOTED if _has_roots(node) else LONG)


def _has_roots(node: "Node") -> bool:
    """Does a root of a sum stand in an expression? It comes again in all that follows, and does not cancel there."""
    return any(part.op == "product" and any(base.op == "sum" and e.denominator == 2 for base, e in part.args)
               for part in reachable([node]))


def is_told_by_number(node: "Node", value: float | None, most: int = SHOWN) -> bool:
    """Is an expression with this value a number, or too long to be written out?"""
    return value is not None and (is_number(node) or letters(node) > most)


class LetteredCoefficients:
    """The letters of a problem about its rest; `searched`: did a search find the place?"""

    def __init__(self, about: "AboutRest", sheet: WorkedSolution, searched: bool) -> None:
        self.about, self.sheet, self.searched = about, sheet, searched
        self.known: dict[Node, Node] = {}
        self._dimensions: dict[str, Dimension | None] = {}

    def letter_for(self, node: "Node") -> "Node":
        """The letter of an expression with a number, ± that of one that is ± the same; a new one is told."""
        for other, letter in self.known.items():
            for sign in (1, -1):
                if is_zero(node.table.sum((node, 1), (other, -sign))):
                    return node.table.scaled(letter, sign)
        name, value = self.sheet.letter(f"b{len(self.known) + 1}"), self.about.value(node)
        shown: list[Any] = [] if is_told_by_number(node, value) else [" = ", node]
        head = "with " if self.searched else "for short:  " if shown else "coefficients at rest:  "
        self._dimensions[name] = dimension_of(node, self._dimension)
        unit = units.text(self._dimensions[name] or units.NONE)
        shown += [] if value is None else number(value, unit)
        self.sheet.write(*([] if self.sheet.opened else [Words(head)]), Name(name), *shown, settles=name, node=node,
                         value=value, unit=unit, opens=True)
        self.known[node] = node.table.parameter(name, positive=False)
        self.about.know(self.known[node], value)
        return self.known[node]

    def _dimension(self, name: str) -> "Dimension | None":
        """That of a letter of the scene, of a place or of one of its own."""
        if name in self._dimensions:
            return self._dimensions[name]
        q = next((q for q, at in self.about.place.items() if getattr(at, "name", None) == name), None)
        return self.about.table.dimension(name) if q is None else self.about.problem.system.dimension(q.name)
