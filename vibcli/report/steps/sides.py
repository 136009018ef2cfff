"""A length by the sides of its right-angled triangle, ℓ = √((h + L sin φ)² + L² (1 − cos φ)²)."""

from typing import TYPE_CHECKING, Any

from vibcli.report.steps.small import AboutRest
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def by_sides(about: AboutRest, s: "Node", plainly: "Node") -> "Node":
    """A function of the coordinates, these counted from rest, with each √(Δx² + Δy²) by Δx and Δy; what it is
    multiplied out, where that is no longer."""
    moved = {q: about.place[q] + q for q in about.scene.q if not about.place[q].is_zero}
    s = substitute([s], moved)[0] if moved else s
    squares = {base: _squares(base) for part in reachable([s]) if part.op == "product"
               for base, e in part.args if e == HALF and _has_sides(base)}
    if not squares:
        return plainly
    found, = substitute([s], squares)
    return found if letters(found) < letters(plainly) else plainly


def _has_sides(base: "Node") -> Any:
    return base.op == "sum" and base.mask and not base.coefficient and len(base.args) == 2 and all(
        c == 1 and term.op == "product" and term.coefficient == 1 and [e for _, e in term.args] == [2]
        for term, c in base.args)


def _squares(base: "Node") -> "Node":
    return base.table.total([textbook(term.args[0][0]) ** 2 for term, _ in base.args])
