"""Numbers as they are printed."""

from fractions import Fraction

from vibcli.notation.numbers import plainly, rounded_up, supported
from vibcli.notation.plain import plain
from vibcli.symbolic.expression import Table


def test_bounds_are_printed_rounded_up():
    assert rounded_up(1.11e-16) == 2e-16
    assert rounded_up(9.01e-5) == 1e-4
    assert rounded_up(1.01, digits=2) == 1.1
    assert rounded_up(9.91e3, digits=2) == 1e4
    assert [rounded_up(x) for x in (2e-16, 0.5, 0.0, float("inf"))] == [2e-16, 0.5, 0.0, float("inf")]
    assert supported(1.0, 10.2) == "0 ± 2e1"


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
