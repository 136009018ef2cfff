"""The frequency function of a beam under an axial force as a sum by αL and βL, its factors in front:

    2·αL²·βL² + (αL⁴ + βL⁴)·cos βL·cosh αL + αL·βL·(αL² − βL²)·sin βL·sinh αL = 0       clamped and free
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.normal_form import expanded, reduced

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.end_stiffness import WaveArguments
    from vibcli.analyses.closed_form.frequency_functions import Function
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

    Exponent = Fraction | int
    Powers = tuple[tuple[Node, Exponent], ...]      # ((letter, exponent), …)
    Polynomial = dict[tuple[int, int], Fraction]    # {(i, j): c} of αⁱβʲ
    Group = tuple[Powers, tuple[int, int, int], Fraction, dict[Any, Polynomial]]


def by_wave_numbers(found: "FrequencyEquation") -> "tuple[Node, Node]":
    """(what no letter of an attachment stands before, minus the rest), without what divides all of it."""
    parted = _groups(found, found.function)
    shared = [min(powers[k] for _, powers, *_ in parted) for k in range(3)]
    lead = min(parted, key=lambda one: (len(one[0]), [str(base.name) for base, _ in one[0]]))
    below, scale = [(base, -e) for base, e in lead[0]], lead[2]
    sides = [(found.wave_number.table.total([_product(found, one, below, shared, sign / scale) for one in parted
                                             if (one is lead) == (sign > 0)])) for sign in (1, -1)]
    return sides[0], sides[1]


def ratio(waves: "WaveArguments", above: "Function", below: "Function") -> "tuple[Node, Node]":
    """Two functions of αL and βL without what divides both; `waves`: their `second`, `wave_number` and `called`."""
    parted = [_groups(waves, function) for function in (above, below)]
    shared = [min(powers[k] for groups in parted for _, powers, *_ in groups) for k in range(3)]
    scale = parted[1][0][2]
    over, under = (waves.wave_number.table.total([_product(waves, one, [], shared, 1 / scale) for one in groups])
                   for groups in parted)
    return over, under


def _groups(waves: "FrequencyEquation | WaveArguments", function: "Function") -> "list[Group]":
    """[(what letters stand before, powers, content, what is left)]."""
    groups: dict[Powers, dict[Any, Polynomial]] = {}
    for functions, coefficient in function.items():
        for monomial, value in reduced(expanded(coefficient)).items():
            powers = dict(monomial)
            exponents = int(powers.pop(waves.second, 0)), int(powers.pop(waves.wave_number, 0))
            polynomials = groups.setdefault(tuple(powers.items()), {})
            polynomials.setdefault(functions, {})[exponents] = Fraction(value)
    return [(others, *_parted(polynomials)) for others, polynomials in groups.items()]


def _parted(polynomials: "Mapping[Any, Polynomial]") -> "tuple[tuple[int, int, int], Fraction, dict[Any, Polynomial]]":
    """((powers of αL, of βL, of αL² + βL² that divide all), their content, what is left)."""
    content = Fraction(gcd(*(c.numerator for one in polynomials.values() for c in one.values())),
                       lcm(*(c.denominator for one in polynomials.values() for c in one.values())))
    content *= -1 if min(next(iter(polynomials.values())).items(), key=lambda item: item[0])[1] < 0 else 1
    a, b = (min(powers[k] for one in polynomials.values() for powers in one) for k in (0, 1))
    rest = {names: {(i - a, j - b): c / content for (i, j), c in one.items()} for names, one in polynomials.items()}
    sums = 0
    while all((divided := {names: _divided(one) for names, one in rest.items()}).values()):
        rest, sums = divided, sums + 1
    return (a, b, sums), content, rest


def _divided(polynomial: "Polynomial") -> "Polynomial":
    """{(i, j): c} of αⁱβʲ by α² + β²; {} where that leaves a rest."""
    left, found = dict(polynomial), {}
    while left:
        (i, j), c = max(left.items())
        if i < 2:
            return {}
        found[i - 2, j] = c
        del left[i, j]
        rest = left.pop((i - 2, j + 2), 0) - c
        if rest:
            left[i - 2, j + 2] = rest
    return found


def _product(found: "FrequencyEquation | WaveArguments", parted: "Group", below: "Sequence[tuple[Node, Exponent]]",
             shared: Sequence[int], sign: "Exponent") -> "Node":
    """sign·(what stands before)·(Σ polynomial·functions)."""
    others, powers, content, rest = parted
    a, b, table = found.second, found.wave_number, found.second.table
    front = [(a, powers[0] - shared[0]), (b, powers[1] - shared[1]), (a ** 2 + b ** 2, powers[2] - shared[2])]
    total = table.total([_factored(table, a, b, polynomial) * found.called(names)
                         for names, polynomial in rest.items()])
    return table.product((table.number(sign * content), 1), *others, *below, *front, (total, 1))


def _factored(table: "Table", a: "Node", b: "Node", polynomial: "Polynomial") -> "Node":
    """Σ c·αⁱβʲ with the powers that divide it in front."""
    least = [min(powers[k] for powers in polynomial) for k in (0, 1)]
    total = table.sum(*((a ** (i - least[0]) * b ** (j - least[1]), c) for (i, j), c in sorted(polynomial.items())))
    return table.product((a, least[0]), (b, least[1]), (total, 1))
