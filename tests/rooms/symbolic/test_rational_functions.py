"""Nodes as quotients of polynomials: each polynomial is factored once, what is given up is tried again."""

from support.trees import new_table, symbol

from vibcli.symbolic import rational_functions
from vibcli.symbolic.rational_functions import Quotients


def counted(monkeypatch, results):
    """[polynomial factored]; a result that is False gives a factorisation up."""
    asked, within = [], rational_functions.within

    def counting(calls, work, otherwise):
        asked.append(work)
        return within(calls, work, otherwise) if results.pop(0) else otherwise

    monkeypatch.setattr(rational_functions, "within", counting)
    return asked


def difference_of_squares():
    table = new_table()
    m, k = symbol(table, "m"), symbol(table, "k")
    quotients = Quotients(table, [m, k])
    return quotients, quotients(m * m - k * k).numer


def test_a_polynomial_is_factored_once(monkeypatch):
    quotients, polynomial = difference_of_squares()
    asked = counted(monkeypatch, [True, True])
    value, factors = quotients.factors(polynomial)
    assert value == 1 and len(factors) == 2 and all(power == 1 for _, power in factors)
    assert factors[0][0] * factors[1][0] == polynomial
    assert quotients.factors(polynomial * 1) == (value, factors) and len(asked) == 1
    assert quotients.factors(polynomial * 2)[0] == 2 and len(asked) == 2


def test_what_was_given_up_is_tried_again(monkeypatch):
    quotients, polynomial = difference_of_squares()
    counted(monkeypatch, [False, True])
    assert quotients.factors(polynomial)[1] == [(polynomial, 1)]
    assert len(quotients.factors(polynomial)[1]) == 2
