"""A frequency function in the form that textbooks give it: tan βL = …, cos βL·cosh βL = −1, or a sum that is zero.

    S sin βL + C cos βL = 0:   sin βL = 0,   cos βL = 0,   (βL)ⁿ·tan βL = −C/S·(βL)ⁿ
    one beam:                  cos βL·cosh βL = −c₀/c₁,   sin βL = 0 (sinh βL is not),   tan βL = r·tanh βL
"""

from collections.abc import Container
from typing import TYPE_CHECKING

from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.normal_form import expanded, factors_of, reduced

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.node import Node

ONE, BOTH, SINES, UNEQUAL, SWAPPED = (), ((0, "cos", "cosh"),), ((0, "sin", "sinh"),), ((0, "cos", "sinh"),), (
    (0, "cosh", "sin"),)
LETTERS = ("theta", "eta", "kappa", "chi", "zeta")


def sides(found: "FrequencyEquation") -> "tuple[Node, Node]":
    """The left and the right side of a FrequencyEquation."""
    if len(found.pieces) == 1:
        one = (_of_second_order if found.order == 2 else _of_fourth_order)(found)
        if one is not None:
            return one
    return _as_sum(found)


def by_letters(found: "FrequencyEquation", taken: "Container[str]") -> "tuple[FrequencyEquation, list]":
    """Several pieces with letters θ₁, θ₂, that are not `taken`, for the arguments of their functions, and what these
    are: [(letter, argument)]; nothing of one piece."""
    table, arguments = found.wave_number.table, found.arguments
    letter = next(one for one in LETTERS if not any(f"{one}{n + 1}" in taken for n in range(len(arguments))))
    letters = [table.parameter(f"{letter}{n + 1}") for n in range(len(arguments))] if len(arguments) > 1 else arguments
    told = zip(letters, arguments, strict=True) if letters is not arguments else ()
    return found._replace(arguments=letters), list(told)


def _of_second_order(found):
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


def _of_fourth_order(found):
    table, x, function = found.wave_number.table, found.wave_number, found.function
    kinds = set(function)
    if kinds == {SINES}:
        return table.call("sin", x), table.zero
    if kinds == {BOTH}:
        return table.call("cos", x), table.zero
    if kinds == {ONE, BOTH}:
        return _product(table, BOTH, [x]), _quotient(-function[ONE], function[BOTH])
    if kinds == {UNEQUAL, SWAPPED}:
        return table.call("tan", x), _quotient(-function[UNEQUAL], function[SWAPPED]) * table.call("tanh", x)
    return None


def _as_sum(found):
    """The sum by powers of βL and of letters: that of the lowest power on the left, the others on the right."""
    table, x, groups = found.wave_number.table, found.wave_number, {}
    for functions, coefficient in found.function.items():
        for monomial, value in reduced(expanded(coefficient)).items():
            groups.setdefault(monomial, {})[functions] = value
    lead = min(groups, key=lambda monomial: (dict(monomial).get(x, 0), len(monomial)))
    scale = next(iter(groups[lead].values()))
    sums = {table.product(*monomial, *((base, -e) for base, e in lead)): table.sum(
        *((_product(table, functions, found.arguments), value / scale) for functions, value in terms.items()))
        for monomial, terms in groups.items()}
    left = sums.pop(table.one)
    return left, table.total([-(factor * terms) for factor, terms in sums.items()])


def _product(table, functions, arguments):
    return table.product(*((table.call(name, arguments[piece]), 1) for piece, *names in functions for name in names))


def _quotient(above, below):
    """The quotient with common factors cancelled."""
    found = single(above / below)
    return found.table.product(*factors_of(found.table, reduced(expanded(found))))
