"""A frequency function in the form that textbooks give it: tan βL = …, cos βL·cosh βL = −1, or a sum that is zero.

    S sin βL + C cos βL = 0:   sin βL = 0,   cos βL = 0,   (βL)ⁿ·tan βL = −C/S·(βL)ⁿ
    one beam:                  cos βL·cosh βL = −c₀/c₁,   sin βL = 0 (sinh βL is not),   tan βL = r·tanh βL
    under an axial force:      these, and sums by αL and βL
"""

from collections.abc import Collection
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.free_letters import ARGUMENTS, free_letters, in_order
from vibcli.analyses.closed_form.two_wave_numbers import by_wave_numbers
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.normal_form import expanded, factors_of, reduced

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

ONE, BOTH, SINES, UNEQUAL, SWAPPED = (), ((0, "cos", "cosh"),), ((0, "sin", "sinh"),), ((0, "cos", "sinh"),), (
    (0, "cosh", "sin"),)
SMALL = 1000        # numbers that stand as fractions
LONGEST = 32        # products that are printed


def sides(found: "FrequencyEquation") -> "tuple[Node, Node]":
    """The left and the right side of a FrequencyEquation."""
    if len(found.pieces) == 1:
        if found.second is not None and set(found.function) not in ({SINES}, {BOTH}, {UNEQUAL, SWAPPED}):
            return by_wave_numbers(found)
        one = (_of_second_order if found.order == 2 else _of_fourth_order)(found)
        if one is not None:
            return one
    return _as_sum(found)


def is_short(found: "FrequencyEquation") -> bool:
    """Has it so few products that it is printed?"""
    together = () if found.second is None else (found.second, found.wave_number)
    return sum(len({tuple(pair for pair in monomial if pair[0] not in together)
                    for monomial in reduced(expanded(node))}) for node in found.function.values()) <= LONGEST


def met(found: "FrequencyEquation") -> bool:
    """Is it of two bars, shafts or strings that more than one simple thing acts on, so that their dynamic stiffnesses
    tell it better?"""
    acting = [Z for end in found.impedances for Z in end if Z is not None and not Z.is_zero]
    return len(found.pieces) > 1 and found.order == 2 and (len(acting) > 1 or bool(found.letters))


def by_letters(found: "FrequencyEquation",
               taken: "Collection[str]") -> "tuple[FrequencyEquation, list[tuple[Node, Node]]]":
    """Several pieces with letters θ₁, θ₂, that are not `taken`, for the arguments of their functions, and what all
    letters are that stand in the equation: [(letter, argument or impedance)]."""
    x, arguments = found.wave_number, found.arguments
    others = [one for one in dict.fromkeys(arguments) if one is not x]
    letters = map(x.table.parameter, free_letters({*taken, x.name}, ARGUMENTS, len(others)))
    named = dict(zip(others, letters, strict=True))
    in_order(*named.values())
    return found._replace(arguments=[named.get(one, one) for one in arguments]), [
        *((letter, argument) for argument, letter in named.items()), *found.named]


def _of_second_order(found: "FrequencyEquation") -> "tuple[Node, Node]":
    table, x, function = found.wave_number.table, found.wave_number, found.function
    sine, cosine = function.get(((0, "sin"),)), function.get(((0, "cos"),))
    for name, other in (("sin", cosine), ("cos", sine)):
        if other is None:
            return table.call(name, x), table.zero
    ratio = _quotient(-cosine, sine)
    power = dict(ratio.args).get(x, 0) if ratio.op == "product" else 0
    if power < 0:
        return x ** -power * table.call("tan", x), ratio * x ** -power
    return table.call("tan", x), ratio


def _of_fourth_order(found: "FrequencyEquation") -> "tuple[Node, Node] | None":
    table, x, function = found.wave_number.table, found.wave_number, found.function
    kinds = set(function)
    if kinds == {SINES}:
        return table.call("sin", x), table.zero
    if kinds == {BOTH}:
        return table.call("cos", x), table.zero
    if kinds == {ONE, BOTH}:
        return found.called(BOTH), _quotient(-function[ONE], function[BOTH])
    if kinds == {UNEQUAL, SWAPPED}:
        return table.call("tan", x), _quotient(-function[UNEQUAL], function[SWAPPED]) * table.call(
            "tanh", found.second or x)
    return None


def _as_sum(found: "FrequencyEquation") -> "tuple[Node, Node]":
    """The sum by powers of βL and of letters: that of the lowest power on the left, the others on the right."""
    table, x, groups = found.wave_number.table, found.wave_number, {}
    for functions, coefficient in found.function.items():
        for monomial, value in reduced(expanded(coefficient)).items():
            groups.setdefault(monomial, {})[functions] = value
    sums: dict[tuple[tuple[Node, Fraction | int], ...], tuple[Node, Fraction]] = {}
    for monomial, terms in groups.items():
        total = table.sum(*((found.called(functions), value) for functions, value in terms.items()))
        if not total.is_zero:
            sums[monomial] = content(total)
    lead = min(sums, key=lambda monomial: (sum(base in found.letters for base, _ in monomial),
                                           dict(monomial).get(x, 0), len(monomial)))
    left, _ = sums[lead]
    scale = table.total([_monomial(table, one, number) for one, (total, number) in sums.items() if total is left])
    return left, table.total([-single(_monomial(table, monomial, number) / scale) * total
                              for monomial, (total, number) in sums.items() if total is not left])


def _monomial(table: "Table", factors: "tuple[tuple[Node, Fraction | int], ...]", number: Fraction) -> "Node":
    return table.product((table.number(number), 1), *factors)


def content(total: "Node") -> "tuple[Node, Fraction]":
    """(total/c, c), whose first coefficient is positive and all of a sum are whole without a common factor."""
    if total.op != "sum" and total.op != "product":
        return total, Fraction(1)
    values = [Fraction(c) for _, c in total.args] if total.op == "sum" else [Fraction(total.coefficient)]
    values += [Fraction(total.coefficient)] if total.op == "sum" and total.coefficient else []
    size = Fraction(gcd(*(one.numerator for one in values)), lcm(*(one.denominator for one in values)))
    size = -size if values[0] < 0 else size
    return total.table.scaled(total, 1 / size), size


def quotient(node: "Node") -> "tuple[Node, Node]":
    """(numerator, denominator) of a product; a number that is no small fraction stands above."""
    table, factors = node.table, node.args if node.op == "product" else ((node, 1),)
    value = Fraction(node.coefficient if node.op == "product" else 1)
    below = value.denominator if is_small(value) else 1
    return (table.product((table.number(value * below), 1), *((base, e) for base, e in factors if e > 0)),
            table.product((table.number(below), 1), *((base, -e) for base, e in factors if e < 0)))


def is_small(value: Fraction) -> bool:
    """Does a number stand as a fraction in a formula of letters?"""
    return max(abs(value.numerator), value.denominator) <= SMALL


def _quotient(above: "Node", below: "Node") -> "Node":
    """The quotient with common factors cancelled."""
    found = single(above / below)
    return found.table.product(*factors_of(found.table, reduced(expanded(found))))
