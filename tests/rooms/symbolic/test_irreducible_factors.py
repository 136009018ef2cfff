"""Irreducible factors are those of SymPy, in its order, with its signs."""

import random

import pytest
from sympy import QQ
from sympy.polys.rings import PolyElement, PolyRing

from vibcli.symbolic.irreducible_factors import irreducible_factors

RING = PolyRing("a,b,c,d", QQ, "lex")
a, b, c, d = RING.gens


def polynomial(draw, degree):
    """A sum of a few terms."""
    terms = {tuple(draw.choice([0, 0, draw.randint(0, degree)]) for _ in RING.gens):
             QQ(draw.choice([-3, -1, 1, 2, 6]), draw.choice([1, 1, 2, 9])) for _ in range(draw.randint(1, 4))}
    return RING.from_dict(terms)


@pytest.mark.parametrize("seed", range(4))
def test_products_of_random_polynomials(seed):
    draw = random.Random(seed)
    for _ in range(15):
        whole = RING(QQ(draw.choice([-4, 1, 5]), 7))
        for _ in range(draw.randint(1, 3)):
            whole *= polynomial(draw, draw.choice([1, 1, 2, 3])) ** draw.choice([1, 1, 2])
        assert irreducible_factors(whole) == whole.factor_list()


@pytest.mark.parametrize("whole", [RING(0), RING(QQ(-3, 4)), -a, -2 * a**2 * b, 4 * a**2 - 9 * b**2, a**2 - 2 * b**2,
                                   (a**2 + b**2) ** 2 * (a - c), a**2 * d**2 - b**2 * c**2, (a**2 - b) * (a**2 + b),
                                   (a**2 + a * b + b**2) * (a**2 - a * b + b**2), a**4 + 4 * b**4, a**4 + b**4])
def test_squares_and_what_only_seems_irreducible(whole):
    assert irreducible_factors(whole) == whole.factor_list()


def test_a_letter_in_first_or_second_degree_needs_no_search(monkeypatch):
    whole = [5 * (a * d - b * c) * (c**2 + d**2) * b, (a**2 + b**2 - 3 * c**2 * d**2) * (a**2 - b**2 * c**2 + d**2)]
    expected = [one.factor_list() for one in whole]
    monkeypatch.delattr(PolyElement, "factor_list")
    assert irreducible_factors(whole[0]) == expected[0]
    with pytest.raises(AttributeError):     # of fourth degree in each letter
        irreducible_factors(whole[1])
