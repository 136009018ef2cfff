"""Several equations in letters for several unknowns: one unknown after the other is eliminated.

An equation that is linear in (a power of) an unknown expresses it by the others; put into the other equations that
gives one unknown less. Where the slope of the linear equation may vanish together with its rest, solutions are lost.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import isclose
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.equations.univariate import Candidates, depends, polynomial, solve_equation, unpowered, vanishes
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import ONE, ZERO

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def solve_equations(nodes: "Sequence[Node]", unknowns: "Sequence[Node]", scene: Any,
                    thorough: bool = False) -> Candidates:
    """The Candidates for `unknowns` (symbol nodes) from nodes = 0; None where none were found in letters. One unknown
    from an equation that is linear in a power of it, the others from the equations that are left; of two the other one
    is eliminated as well, where that gives the first in a shorter form. `thorough`: SymPy may try what is not of degree
    one or two."""
    if len(unknowns) == 1:
        relevant = next((node for node in nodes if depends(node, unknowns)), None)
        return None if relevant is None else solve_equation(relevant, unknowns[0], scene, thorough)
    first = _linear(nodes, unknowns, unknowns, scene)
    found = first and _without(first, nodes, unknowns, scene, thorough)
    if not found or len(unknowns) > 2:
        return found
    second = _linear(nodes, unknowns, [x for x in unknowns if x is not first[1]], scene)
    other = second and _without(second, nodes, unknowns, scene, False)
    return found if not other else found._replace(tuples=[_shorter(pair, other.tuples, scene) for pair in found.tuples])


def _shorter(pair: "tuple[Node, ...]", others: "Sequence[tuple[Node, ...]]", scene: Any) -> "tuple[Node, ...]":
    """Each expression of a solution in the shorter of two forms that agree at the sample."""
    values = evaluate(pair, Floats, scene.sample)
    for other in others:
        pairs = zip(values, evaluate(other, Floats, scene.sample), strict=True)
        if all(isclose(x, y, rel_tol=1e-9) for x, y in pairs):
            return tuple(min(forms, key=lambda node: len(reachable([node]))) for forms in zip(pair, other, strict=True))
    return pair


def _without(eliminated: "tuple[int, Node, Fraction, Node, Node]", nodes: "Sequence[Node]", unknowns: "Sequence[Node]",
             scene: Any, thorough: bool) -> Candidates | None:
    """The Candidates when an unknown is expressed by the others as `eliminated` says."""
    i, x, power, slope, rest = eliminated
    others = [unknown for unknown in unknowns if unknown is not x]
    expressed = unpowered(single(-rest / slope), power, x, scene)
    complete, found = not depends(slope, others) or _never_both(slope, rest, others, scene), []
    for expression in expressed:
        left = [_resultant(node, x, power, slope, rest) or substitute([node], {x: expression})[0]
                for j, node in enumerate(nodes) if j != i]
        inner = solve_equations(left, others, scene, thorough)
        if inner is None or inner.always:
            return None
        complete &= inner.complete
        for values in inner.tuples:
            known = dict(zip(others, values, strict=True))
            try:
                known[x] = textbook(substitute([expression], known)[0])
            except ZeroDivisionError:
                continue
            found.append(tuple(known[unknown] for unknown in unknowns))
    return Candidates(found, complete) if found or complete else None


def _resultant(node: "Node", x: "Node", power: Fraction, slope: "Node", rest: "Node") -> "Node | None":
    """Σ cⱼ (−rest)ʲ slopeᵈ⁻ʲ of a polynomial Σ cⱼ xʲ, free of x where slope·x + rest = 0; None of other equations."""
    terms = polynomial(node, x) if power == 1 and depends(node, (x,)) else None
    if terms is None or not all(e.denominator == 1 for e in terms):
        return None
    degree = int(max(terms))
    return node.table.sum(*((c * (-rest) ** e * slope ** (degree - e), ONE) for e, c in terms.items()))


def _linear(nodes: "Sequence[Node]", unknowns: "Sequence[Node]", eligible: "Sequence[Node]",
            scene: Any) -> "tuple[int, Node, Fraction, Node, Node] | None":
    """(number of the equation, unknown, power, slope, rest) of slope·x^power + rest = 0, the slope free of all
    unknowns where there is such a choice; None of none."""
    best = None
    for i, node in enumerate(nodes):
        for x in eligible:
            terms = polynomial(node, x) if depends(node, (x,)) else None
            terms = {e: c for e, c in (terms or {}).items() if not vanishes(c, scene.sample)}
            if len(terms) == 2 and ZERO in terms:
                power = max(terms)
                free = not depends(terms[power], unknowns)
                if best is None or (free and not best[0]):
                    best = free, (i, x, Fraction(power), terms[power], terms[ZERO])
    return best and best[1]


def _never_both(slope: "Node", rest: "Node", others: "Sequence[Node]", scene: "Scene") -> bool:
    """Can slope and rest of a linear equation not vanish together, where any x would solve it?"""
    if len(others) > 1:
        return False
    common = solve_equation(slope, others[0], scene, False)
    if common is None or not common.complete:
        return False
    for value, in common.tuples:
        at, = substitute([rest], {others[0]: value})
        if vanishes(at, scene.sample):
            return False
    return True
