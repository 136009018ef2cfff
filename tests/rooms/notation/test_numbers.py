"""Numbers as they are printed."""

from fractions import Fraction
from math import inf, isclose

import pytest

from vibcli.notation.numbers import figure, plainly, rounded_up, supported, with_bound, with_minus
from vibcli.notation.plain import plain
from vibcli.symbolic.contents import without_contents
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table


def test_bounds_are_printed_rounded_up():
    assert rounded_up(1.11e-16) == 2e-16
    assert rounded_up(9.01e-5) == 1e-4
    assert rounded_up(1.01, digits=2) == 1.1
    assert rounded_up(9.91e3, digits=2) == 1e4
    assert [rounded_up(x) for x in (2e-16, 0.5, 0.0, float("inf"))] == [2e-16, 0.5, 0.0, float("inf")]
    assert supported(1.0, 10.2) == "0 ± 2e1"


def test_what_is_lost_in_its_error_is_zero_beside_what_shows_so_many_digits():
    """1 m to six digits tells no 0.4 µm; where it does, or nothing is known to be beside it, the bound stands."""
    assert [supported(2e-7, 2e-7, beside=x) for x in (1.0, 0.1, 0.0, inf)] == ["0", *["0 ± 4e-7"] * 3]
    assert supported(2e-7, 2e-7, 12, beside=1.0) == "0 ± 4e-7" and supported(2e-7, 1e-9, beside=1.0) == "2e-7?"


def test_a_share_is_printed_without_an_exponent():
    """100 %, not 1e2 %; as digits allow."""
    assert [plainly(x) for x in (99.6, 100.0, 286.4, 1e5, 0.0123, 2.71e-5)] == ["100", "100", "290", "100000", "0.012",
                                                                               "2.7e-5"]
    assert plainly(2.5e7) == "2.5e7"


def test_a_length_written_as_a_decimal_is_added_as_one():
    """L + 0.3 of lengths 0.3 m in a scene; 1/2 and 2/3 of sums without tenths stay."""
    table = Table()
    L, x = table.parameter("L"), table.parameter("x")
    assert plain(L + Fraction(3, 10)) == "L + 0.3"
    assert plain((L + Fraction(3, 10)) * (L + x)) == "(L + 0.3)·(L + x)"
    assert plain(x * x - x * Fraction(6, 5) + Fraction(1, 4)) == "x² − 6·x/5 + 0.25"
    assert plain(L + Fraction(1, 2)) == "L + 1/2" and plain(L - Fraction(2, 3)) == "L − 2/3"


def test_fractions_stay_where_their_decimals_are_longer():
    """π d⁴/64 and x/384 as books have them; 0.18 and 0.3333 of a file as they were written; nothing of large terms."""
    table = Table()
    d, x = table.parameter("d"), table.parameter("x")
    assert plain(table.pi * d**4 * Fraction(1, 64)) == "π·d⁴/64"
    assert plain(x * Fraction(5, 384)) == "5·x/384" and plain(x * Fraction(1, 81)) == "x/81"
    assert plain(x * Fraction(9, 50)) == "0.18·x" and plain(x * Fraction(3333, 10000)) == "0.3333·x"
    assert plain(x * Fraction(1, 1003)) == "0.000997008973081·x"


def test_exponents_and_signs_are_written_alike():
    table = Table()
    x = table.parameter("x")
    assert figure(-1.5e-07) == "-1.5e-7" and with_minus(-1.5e-07) == "−1.5e-7" and with_minus(2e12) == "2e12"
    assert plain(x * Fraction(1, 10**12)) == "1e-12·x" and plain(x + Fraction(-1, 10**12)) == "x − 1e-12"
    assert plain(table.number(-Fraction(1, 10**7))) == "−1e-7" and plain(x * 10**20) == "1e20·x"
    assert plain.notation(" = -0.25 m, 3e-5, a-1, (-6.3°)") == " = −0.25 m, 3e-5, a-1, (−6.3°)"


def test_contents_are_taken_out_of_sums():
    """(2x + 4y) z/2 is (x + 2y) z, nothing is multiplied out, and values stay."""
    table = Table()
    x, y, z = map(table.parameter, "xyz")
    node = (x * 2 + y * 4) * z / 2 + (x * 3 + y * 3)**2 / (x * 2 + z * 2)
    assert plain(without_contents(node)) == "9·(x + y)²/(2·(x + z)) + z·(x + 2·y)"
    root = table.sqrt(x * 2 + y * 2) * (x * Fraction(1, 2) + y * Fraction(1, 2))
    for one in (node, root, x, table.call("sin", x * 2 + y * 2) * (x * 2 + y * 2)):
        values = {"x": 0.7, "y": 1.3, "z": 2.1}
        assert isclose(*evaluate([one, without_contents(one)], Floats, values), rel_tol=1e-14)


@pytest.mark.parametrize(("value", "error", "text"), [
    (17.12123888, 2.04e-3, "17.121 ± 0.003"), (-0.0123456, 3e-9, "-0.0123456 ± 3e-9"), (20.0, 0.01, "20 ± 0.01"),
    (1.23456e-7, 1e-8, "1.2e-7 ± 2e-8"), (9.996, 0.02, "10 ± 0.03"), (3.0, 2.0, "0 ± 5")])
def test_a_number_and_how_far_it_may_be_off(value, error, text):
    """What is written and its bound hold all that the value and its own bound do: 17.1 ± 0.003 did not."""
    assert with_bound(value, error) == text
