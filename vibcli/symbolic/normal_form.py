"""Expanded form: expressions as polynomials in their atoms, brought into the shape a textbook prints.

The rules are few: expand, sin² + cos² = 1, the addition theorems for products of sines and cosines, and common
factors taken out. Work is bounded; what grows beyond MOST terms is left as it is.
"""

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations
from math import gcd
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import cofunction, content_of, remembered, times
from vibcli.symbolic.rationals import HALF, ONE, ZERO, exact, exact_root

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Monomial, Node, Terms

MOST, SQUARES = 300, (3, 6, 10)     # terms; of squares of sums of two, three and four


class TooLong(ArithmeticError):
    """More terms than are worked with."""


def expanded(node: "Node", kept: "Collection[Node] | None" = None) -> "Terms":
    """{monomial: coefficient}, a monomial being a tuple of (atom, exponent) in the order of the atoms' indices. Sums
    that stand in a denominator are atoms, above as well as below the line, so that they cancel."""
    kept = _denominators(node) if kept is None else kept
    if node.op == "number":
        return {(): node.coefficient} if node.coefficient else {}
    if node.op == "sum":
        found: Terms = {(): node.coefficient} if node.coefficient else {}
        for part, c in node.args:
            for monomial, value in expanded(part, kept).items():
                add(found, monomial, c * value)
        return found
    if node.op == "product":
        product: Terms = {(): node.coefficient}
        for base, exponent in node.args:
            product = multiplied(product, _expanded_power(base, exponent, kept))
        return product
    return {((node, ONE),): ONE}


def _denominators(node: "Node") -> "set[Node]":
    """The sums of parameters in denominators below a node, which stay whole."""
    return {base for part in reachable([node]) if part.op == "product" for base, e in part.args
            if base.op == "sum" and e < 0 and e.denominator == 1 and not base.mask}


def _expanded_power(base: "Node", exponent: Fraction | int, kept: "Collection[Node]") -> "Terms":
    if base.op == "sum" and base not in kept:
        if exponent.denominator == 1 and 0 < exponent <= 6:
            return reduce(multiplied, [expanded(base, kept)] * int(exponent))
        base = textbook(base)
        if base.op != "sum":
            return expanded(base.table.power(base, exponent), kept)
    return {((base, exponent),): ONE}


def add(found: Any, monomial: Any, value: Any) -> None:
    total = found.get(monomial, ZERO) + value
    if total:
        found[monomial] = total
    else:
        found.pop(monomial, None)
    if len(found) > MOST:
        raise TooLong


def multiplied(left: "Mapping[Monomial, Any]", right: "Mapping[Monomial, Any]") -> "Terms":
    found = {}
    if len(left) * len(right) > 20 * MOST:
        raise TooLong
    folds = any(atom.op in ("number", "product") for terms in (left, right) for monomial in terms
                for atom, _ in monomial)
    for a, x in left.items():
        for b, y in right.items():
            monomial, value = times(a, b), x * y
            if folds and any(atom.op in ("number", "product") and e.denominator == 1 for atom, e in monomial):
                product = monomial[0][0].table.product(*monomial)  # a number too long to fold stays an atom
                parts = {monomial: product.coefficient} if product.args == monomial else expanded(product, ())
                for part, c in parts.items():
                    add(found, part, c * value)
            else:
                add(found, monomial, value)
    return found


def reduced(terms: "Terms") -> "Terms":
    """The same polynomial with the trigonometric identities applied wherever they shorten it."""
    changed = True
    while changed:
        changed = False
        for monomial in list(terms):
            if monomial in terms and _shorten(terms, monomial):
                changed = True
    return terms


def _shorten(terms: "Terms", monomial: "Monomial") -> bool:
    """Apply one identity that starts from `monomial`; True if one was found."""
    sines = [(atom, e) for atom, e in monomial if atom.name in ("sin", "cos") and e >= 1 and e.denominator == 1]
    return any((e >= 2 and _square(terms, monomial, atom)) or (e >= 4 and _fourth_power(terms, monomial, atom))
               for atom, e in sines) or any(
        a.args != b.args and _addition(terms, monomial, a, b) for (a, _), (b, _) in combinations(sines, 2))


def _square(terms: "Terms", monomial: "Monomial", atom: "Node") -> bool:
    """c·R·f² + c·R·g² = c·R for f, g = sin u, cos u; and c·R − c·R·f² = c·R·g²."""
    value = terms[monomial]
    rest = times(monomial, ((atom, 2),), -1)
    partner = times(rest, ((cofunction(atom), 2),))
    for other, left, c in ((partner, rest, value), (rest, partner, -value)):
        if terms.get(other) == c:
            _move(terms, (monomial, other), left, c)
            return True
    return False


def _fourth_power(terms: "Terms", monomial: "Monomial", atom: "Node") -> bool:
    """c·R·f⁴ + 2·c·R·f²·g² + c·R·g⁴ = c·R for f, g = sin u, cos u."""
    value, other = terms[monomial], cofunction(atom)
    rest = times(monomial, ((atom, 4),), -1)
    mixed, last = (times(rest, factors) for factors in (((atom, 2), (other, 2)), ((other, 4),)))
    if terms.get(mixed) != 2 * value or terms.get(last) != value:
        return False
    _move(terms, (monomial, mixed, last), rest, value)
    return True


def _addition(terms: "Terms", monomial: "Monomial", a: "Node", b: "Node") -> bool:
    """cos a cos b ± sin a sin b = cos(a ∓ b) and sin a cos b ± cos a sin b = sin(a ± b)."""
    table, value = a.table, terms[monomial]
    rest = times(monomial, ((a, ONE), (b, ONE)), -1)
    partner = times(rest, ((cofunction(a), ONE), (cofunction(b), ONE)))
    other = terms.get(partner)
    if other is None or abs(other) != abs(value):
        return False
    u, w = a.args[0], b.args[0]
    if a.name == b.name:
        cosine, sine = (value, other) if a.name == "cos" else (other, value)
        new, factor = table.call("cos", u - w if sine == cosine else u + w), cosine
    else:
        sine_first = value if a.name == "sin" else other
        cosine_first = other if a.name == "sin" else value
        new, factor = table.call("sin", u + w if sine_first == cosine_first else u - w), sine_first
    polynomial = multiplied({rest: ONE}, expanded(new))
    del terms[monomial], terms[partner]
    for extra, c in polynomial.items():
        add(terms, extra, c * factor)
    return True


def _move(terms: "Terms", old: "tuple[Monomial, ...]", new: "Monomial", value: Fraction | int) -> None:
    for monomial in old:
        del terms[monomial]
    add(terms, new, value)


@remembered
def is_zero(node: "Node") -> bool:
    """Is the expression zero by expansion and the identities? False where that does not show it."""
    try:
        return node.is_zero or not _numerator(expanded(node))
    except (TooLong, ZeroDivisionError):
        return False


def _numerator(terms: "Terms") -> "Terms":
    """The polynomial times the sums that it is divided by: zero if and only if the quotient is."""
    lowest = {}
    for monomial in terms:
        for atom, e in monomial:
            if atom.op == "sum" and e.denominator == 1:
                lowest[atom] = min(lowest.get(atom, ZERO), e)
    return cleared(terms, tuple((atom, -e) for atom, e in lowest.items()))


def cleared(terms: "Mapping[Monomial, Fraction | int]", below: Any) -> dict[Any, Any]:
    """The polynomial times a denominator ((atom, exponent), …); sums of it expanded where their exponent is whole, as
    far as they stand above by whole powers."""
    found = {}
    whole = {atom for atom, e in below if atom.op == "sum" and e.denominator == 1}
    for monomial, value in terms.items():
        above = times(monomial, below)
        often = {atom: max(int(e), 0) for atom, e in above if atom in whole}
        product = {times(above, tuple(often.items()), -1): value}
        for atom, count in often.items():
            product = reduce(multiplied, [expanded(atom, ())] * count, product)
        for part, c in product.items():
            add(found, part, c)
    return reduced(found)


@remembered
def textbook(node: "Node") -> "Node":
    """The expression expanded, collected by its variable parts, each coefficient with common factors taken out."""
    try:
        return collected(node.table, reduced(expanded(_unnested(node))))
    except (TooLong, ZeroDivisionError):
        return node


def _unnested(node: "Node") -> "Node":
    """The node with 1/(a/b + 1) written as b/(a + b), and 1/((a − b)² + 2ab) as 1/(a² + b²)."""
    table, simpler = node.table, {}
    for base in sorted(_denominators(node), key=lambda base: base.index):
        shorter = table.product(*factors_of(table, reduced(expanded(base, ()))))
        if shorter is not base:
            simpler[base] = shorter
    return substitute([node], simpler)[0] if simpler else node


def collected(table: "Table", terms: "Mapping[Monomial, Fraction | int]") -> "Node":
    """A polynomial as a node: Σ (factored coefficient of parameters)·(part that holds variables)."""
    groups = {}
    for monomial, value in terms.items():
        variable = tuple(pair for pair in monomial if pair[0].mask)
        fixed = tuple(pair for pair in monomial if not pair[0].mask)
        groups.setdefault(variable, {})[fixed] = value
    parts = [table.product(*factors_of(table, _whole(fixed)), *variable) for variable, fixed in groups.items()]
    return table.sum(*((part, ONE) for part in parts))


def _whole(terms: "Terms") -> "Terms":
    """A polynomial of parameters without the sums that it is divided by, where they go into it."""
    for total in dict.fromkeys(atom for monomial in terms for atom, e in monomial
                               if atom.op == "sum" and e.denominator == 1 and not atom.mask):
        from vibcli.symbolic.exact_division import without

        terms = without(total, terms, cleared, expanded)
    return terms


def factors_of(table: "Table", terms: Any) -> "Monomial":
    """A polynomial as factors: its content — rational factor and common monomial — and what is left in brackets."""
    if not (monomials := list(terms)):
        return ((table.zero, ONE),)
    if len(monomials) == 1:
        return ((table.number(terms[monomials[0]]), ONE), *monomials[0])
    scale = _scale(list(terms.values()))
    content = content_of(monomials, with_units=abs(scale) != 1)
    inner = {times(monomial, content, -1): exact(value / scale) for monomial, value in terms.items()}
    for lead in dict.fromkeys((ONE, next(map(abs, inner.values())))) if len(inner) in SQUARES else ():
        if (root := square_root({monomial: exact(value / lead) for monomial, value in inner.items()})) is not None:
            common = abs(_scale(list(root.values())))       # the half of ((R − r)/2)²
            node = _node(table, reduced({monomial: exact(value / common) for monomial, value in root.items()}))
            return ((table.number(exact(scale * lead * common**2)), ONE), (node, 2), *content)
    return ((table.number(scale), ONE), (_node(table, inner), ONE), *content)


def _node(table: "Table", terms: "Mapping[Monomial, Fraction | int]") -> "Node":
    return table.sum(*((table.product(*monomial), value) for monomial, value in terms.items()))


def _scale(values: Sequence[Fraction | int]) -> Fraction:
    """The rational factor to take out: the common divisor, over the denominator where all share it."""
    below = {v.denominator for v in values}
    scale = Fraction(reduce(gcd, [v.numerator for v in values]), below.pop() if len(below) == 1 else 1)
    return -scale if all(v < 0 for v in values) else scale


def square_root(terms: Any) -> "Terms | None":
    """The polynomial whose square this is (up to sign), None where there is none of two to four terms."""
    squares = {monomial: exact_root(value) for monomial, value in terms.items()
               if all(e.denominator == 1 and e.numerator % 2 == 0 for _, e in monomial) and value > 0}
    roots = [(tuple((atom, e.numerator // 2) for atom, e in monomial), exact(value))
             for monomial, value in squares.items() if value]
    k = len(roots)
    if len(terms) not in SQUARES or len(terms) != k * (k + 1) // 2:
        return None
    for signs in range(2 ** (k - 1)):
        candidate = {monomial: -value if signs >> i & 1 else value
                     for i, (monomial, value) in enumerate(roots[::-1])}
        if multiplied(candidate, candidate) == terms:
            return candidate if candidate[roots[0][0]] > 0 else {m: -v for m, v in candidate.items()}
    return None


def root_of_square(node: "Node") -> "Node | None":
    """√node up to sign as a node where that needs no root, else None."""
    try:
        terms = reduced(expanded(node))
    except (TooLong, ZeroDivisionError):
        return None
    if len(terms) == 1:
        (monomial, value), = terms.items()
        root = exact_root(value) if value > 0 else None
        if root is None or any((e * HALF).denominator > 1 for _, e in monomial):
            return None
        return node.table.product((node.table.number(root), ONE), *((atom, e * HALF) for atom, e in monomial))
    return _node(node.table, root) if (root := square_root(terms)) is not None else None
