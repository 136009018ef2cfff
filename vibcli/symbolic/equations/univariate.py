"""Equations in letters, f(x) = 0: candidates for x from the polynomial that f leads to.

Denominators that hold x are cleared, a root of a sum that holds x is isolated and squared: A + B √S = 0 gives
A² − B² S = 0. Powers of one power of x are roots of degree one and two; factors of more and equations of other kinds
are left to SymPy, within so many CALLS. Clearing and squaring add roots that are none: every candidate has to be tried.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.equations.trigonometric import angles
from vibcli.symbolic.evaluation import Floats, evaluate, from_sympy, sympy_arithmetic
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import TooLong, expanded, reduced, textbook
from vibcli.symbolic.quadratic_roots import quadratic_roots
from vibcli.symbolic.radicals import root as square_root
from vibcli.symbolic.rationals import HALF, ONE, ZERO
from vibcli.symbolic.time_limit import within

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Monomial, Node

CALLS = 8_000_000
VANISHING, MOST_ROOTS, MOST_RADICALS = 1e-12, 12, 3


class Candidates(NamedTuple):
    """Tuples of expressions, one for each unknown; complete: whether every solution is among them; always: whether
    the equations hold whatever the unknowns are."""

    tuples: "list[tuple[Node, ...]]"
    complete: bool
    always: bool = False


def depends(node: "Node", symbols: "Sequence[Node]") -> bool:
    return any(part in symbols for part in reachable([node]))


def solve_equation(node: "Node", x: "Node", scene: Any, thorough: bool = False) -> "Candidates | None":
    """The Candidates for the symbol x from node = 0; None where none were found in letters. `thorough`: SymPy may try
    what is not of degree one or two."""
    terms = polynomial(node, x)
    if terms is None:
        found = _angles(node, x, scene)
        return within(CALLS, lambda: _by_sympy(node, x, scene), None) if not found and thorough else found
    terms = {e: c for e, c in terms.items() if not vanishes(c, scene.sample)}
    if not terms:
        return Candidates([], True, True)
    lowest = min(terms)
    found = [scene.table.zero] if lowest else []
    step = _common([e - lowest for e in terms if e != lowest])
    if step is None:
        return Candidates([(node,) for node in found], True)
    degree = max(int((e - lowest) / step) for e in terms)
    coefficients = [terms.get(lowest + i * step, scene.table.zero) for i in range(degree + 1)]
    powers, complete = _power_roots(coefficients[::-1], scene, thorough)
    found += [root for power in powers for root in unpowered(power, step, x, scene)]
    return Candidates([(node,) for node in found], complete) if found or complete else None


def _angles(node: "Node", x: "Node", scene: Any) -> Candidates | None:
    try:
        found = angles(reduced(expanded(_cleared(node, x))), x, lambda part: vanishes(part, scene.sample))
    except (TooLong, ZeroDivisionError):
        return None
    return Candidates([(node,) for node in found], False) if found else None


def _common(exponents: Sequence[Fraction | int]) -> Fraction | None:
    """The largest step of which all exponents are multiples; None of none."""
    if not exponents:
        return None
    below = reduce(lcm, [Fraction(e).denominator for e in exponents])
    return Fraction(reduce(gcd, [int(e * below) for e in exponents]), below)


def unpowered(power: "Node", step: Fraction, x: "Node", scene: Any) -> "list[Node]":
    """The x with x^step = power; the negative one too where x may have any sign and the step is even."""
    if step == 1:
        return [power]
    root = square_root(power, [scene.sample]) if step == 2 else scene.table.power(power, 1 / step)
    even = step.numerator % 2 == 0 and x not in scene.table.positive
    return [-root, root] if even else [root]


def _power_roots(coefficients: "list[Node]", scene: Any, thorough: bool) -> "tuple[list[Node], bool]":
    """(roots, whether they are all) of Σ cᵢ yⁱ, the coefficients from the highest down."""
    coefficients = _primitive(coefficients)
    if len(coefficients) == 2:
        return [single(-coefficients[1] / coefficients[0])], True
    if len(coefficients) == 3:
        return list(dict.fromkeys(quadratic_roots(coefficients, scene.sample))), True
    found = within(CALLS, lambda: _factored(coefficients, scene), None) if thorough else None
    return found or ([], False)


def _primitive(coefficients: "list[Node]") -> "list[Node]":
    """The coefficients divided by the powers of symbols that all their terms share."""
    try:
        monomials = [dict(monomial) for node in coefficients for monomial in expanded(node)]
    except TooLong:
        return coefficients
    shared = {atom: min(monomial.get(atom, ZERO) for monomial in monomials) for atom in monomials[0]}
    common = [(atom, -e) for atom, e in shared.items() if e]
    return [textbook(node.table.product((node, ONE), *common)) for node in coefficients] if common else coefficients


def polynomial(node: "Node", x: "Node", radicals: int = MOST_RADICALS) -> "dict[Fraction | int, Node] | None":
    """{exponent: coefficient} of a polynomial in powers of x that vanishes wherever the node does; None of none."""
    try:
        terms = reduced(expanded(_cleared(node, x)))
    except (TooLong, ZeroDivisionError):
        return None
    holding = {atom for monomial in terms for atom, _ in monomial if depends(atom, (x,))} - {x}
    if not holding:
        return _by_exponent(node.table, terms, x)
    root = next((atom for monomial in terms for atom, e in monomial if atom in holding
                 and e.denominator == 2), None)
    if root is None or not radicals:
        return None
    plain, rooted = [], []
    for monomial, value in terms.items():
        e = dict(monomial).get(root, ZERO)
        rest = tuple((atom, power - HALF if atom is root else power) for atom, power in monomial)
        whole = e.denominator == 1
        (plain if whole else rooted).append((node.table.product(*(monomial if whole else rest)), value))
    a, b = node.table.sum(*plain), node.table.sum(*rooted)
    return polynomial(a * a - b * b * root, x, radicals - 1)


def _by_exponent(table: "Table", terms: "Mapping[Monomial, Fraction | int]", x: "Node") -> "dict[Fraction | int, Node]":
    found = {}
    for monomial, value in terms.items():
        exponent = dict(monomial).get(x, ZERO)
        rest = tuple(pair for pair in monomial if pair[0] is not x)
        found.setdefault(exponent, []).append((table.product(*rest), value))
    return {exponent: textbook(table.sum(*parts)) for exponent, parts in found.items()}


def _cleared(node: "Node", x: "Node") -> "Node":
    """The numerator of a node over the denominators that hold x."""
    table, above, below = node.table, {}, {}
    for part in reachable([node]):
        args = part.args if part.op != "call" else ()
        if part is x or not any(below.get(arg) is not None for arg, _ in args):
            holds = part is x or (part.op == "call" and any(below.get(arg) is not None for arg in part.args))
            above[part], below[part] = part, {} if holds else None
        elif part.op == "sum":
            above[part], below[part] = _cleared_sum(table, part, above, below)
        else:
            above[part], below[part] = _cleared_product(table, part, above, below)
    return above[node]


def _cleared_sum(table: "Table", part: "Node", above: "Mapping[Node, Node]",
                 below: "Mapping[Node, dict[Node, Fraction | int] | None]"
                 ) -> "tuple[Node, dict[Node, Fraction | int]]":
    common = {}
    for arg, _ in part.args:
        for base, power in (below[arg] or {}).items():
            common[base] = max(power, common.get(base, ZERO))
    terms = [(table.product(*common.items()), part.coefficient)]
    for arg, c in part.args:
        own = below[arg] or {}
        rest = [(base, power - own.get(base, ZERO)) for base, power in common.items()]
        terms.append((table.product((above[arg], ONE), *rest), c))
    return table.sum(*terms), common


def _cleared_product(table: "Table", part: "Node", above: "Mapping[Node, Node]",
                     below: "Mapping[Node, dict[Node, Fraction | int] | None]"
                     ) -> "tuple[Node, dict[Node, Fraction | int]]":
    top, bottom = [(table.number(part.coefficient), ONE)], {}
    for base, e in part.args:
        own = below[base] or {}
        pairs = [(above[base], e), *((under, -power * e) for under, power in own.items())]
        for factor, power in pairs:
            if power < 0 and below[base] is not None:
                bottom[factor] = bottom.get(factor, ZERO) - power
            else:
                top.append((factor, power))
    return table.product(*top), bottom


def vanishes(node: "Node", sample: Mapping[str, float]) -> bool:
    """Is a coefficient, or a factor of it, zero at the sample values but for the rounding of its terms?"""
    if node.op == "product":
        return any(vanishes(base, sample) for base, e in node.args if e > 0)
    terms = [node.table.product((part, ONE), (node.table.number(c), ONE)) for part, c in node.args] \
        if node.op == "sum" else [node]
    values = [*evaluate(terms, Floats, sample), float(node.coefficient) if node.op == "sum" else 0.0]
    return bool(abs(sum(values)) <= VANISHING * sum(map(abs, values)))


def _symbols(scene: Any) -> "tuple[dict[str, Any], dict[Any, Node]]":
    """({name: SymPy symbol}, {SymPy symbol: node}) of the parameters."""
    import sympy

    symbols = {name: sympy.Symbol(name, real=True, positive=node in scene.table.positive or None)
               for name, node in scene.parameters.nodes.items()}
    return symbols, {symbol: scene.parameters.nodes[name] for name, symbol in symbols.items()}


def _factored(coefficients: "list[Node]", scene: Any) -> "tuple[list[Node], bool]":
    """Roots of the factors of degree one and two that SymPy finds."""
    import sympy

    symbols, back = _symbols(scene)
    y = sympy.Symbol("y_")
    whole = sympy.Poly(evaluate(coefficients, sympy_arithmetic(), symbols), y)
    found, complete = [], True
    for factor, _ in sympy.factor_list(whole.as_expr(), y)[1]:
        degree = sympy.degree(factor, y)
        if degree > 2:
            complete = False
        elif degree:
            parts = [textbook(from_sympy(scene.table, part, back)) for part in sympy.Poly(factor, y).all_coeffs()]
            roots = [single(-parts[1] / parts[0])] if degree == 1 else quadratic_roots(parts, scene.sample)
            found += list(dict.fromkeys(roots))
    return found, complete


def _by_sympy(node: "Node", x: "Node", scene: Any) -> Candidates | None:
    """Whatever SymPy's solver finds and the project's algebra can say."""
    import sympy

    symbols, back = _symbols(scene)
    whole, = evaluate([node], sympy_arithmetic(), symbols)
    try:
        found = sympy.solve(whole, symbols[x.name])
    except (NotImplementedError, ValueError, TypeError, ArithmeticError, AttributeError, RecursionError):
        return None
    nodes = []
    for solution in found[:MOST_ROOTS]:
        try:
            nodes.append(textbook(from_sympy(scene.table, solution, back)))
        except (ValueError, ZeroDivisionError, TypeError):
            continue
    return Candidates([(node,) for node in nodes if not depends(node, (x,))], False) if nodes else None
