"""Polynomials over sums of which some stand in denominators and others under roots."""

from fractions import Fraction

import pytest
from support.trees import new_table, symbol

from vibcli.notation.plain import plain
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.rationals import HALF

PARAMETERS, VARIABLES = ("m", "k"), ("x", "y")


@pytest.mark.parametrize("names", [PARAMETERS, VARIABLES])
def test_roots_of_a_sum_that_stands_in_a_denominator_remain(names):
    table = new_table()
    a, b = (symbol(table, name) for name in names)
    root = (a + b) ** HALF
    for node in (b / (a + b) + root, (a * a - b * b) / (a + b) + root - a + b + 1, b / (a + b) + root ** -3,
                 1 / (a + b) ** 2 + b * root / (a + b)):
        for write in (single, textbook):
            found = evaluate([write(node), node], Floats, dict(zip(names, (3.0, 1.5), strict=True)))
            assert abs(found[0] - found[1]) < 1e-14


@pytest.mark.parametrize("names", [PARAMETERS, VARIABLES])
def test_what_is_zero_without_its_root_is_not_zero(names):
    """(a² − b²)/(a + b) − a + b is 0: √(a + b) − 1 is what is left, which would vanish if the root were one."""
    table = new_table()
    a, b = (symbol(table, name) for name in names)
    assert is_zero((a * a - b * b) / (a + b) - a + b)
    assert not is_zero((a * a - b * b) / (a + b) - a + b + (a + b) ** HALF - 1)


@pytest.mark.parametrize(("values", "written"), [
    ({"R": 0.6, "r": 0.1}, "(R − r) + (R − r)²"), ({"R": 0.1, "r": 0.6}, "(r − R) + (r − R)²")])
def test_a_square_is_of_the_difference_that_stands_beside_it(values, written):
    table = Table()
    m, R, r = (table.parameter(name) for name in ("m", "R", "r"))
    table.resample({"m": 1.0, **values})
    difference, square = (plain(m * part) for part in (R - r, (R - r) ** 2))
    assert f"{difference.removeprefix('−').removeprefix('m·')} + {square.removeprefix('m·')}" == written


def test_a_square_has_its_number_before_it():
    """3 m (R − r)²/4, not 3 m ((R − r)/2)²; (R/3 + r)² stays, whose terms share no denominator."""
    table = Table()
    m, R, r = (table.parameter(name) for name in ("m", "R", "r"))
    assert textbook(m * (R - r) ** 2 / 2 + m * (R - r) ** 2 / 4).coefficient == Fraction(3, 4)
    assert plain(textbook(3 * m * (r * r - 2 * r * R + R * R) / 4)) == "3·m·(R − r)²/4"
    assert plain(textbook(3 * m * (r * r - 2 * r * R + R * R) / 2)) == "3·m·(R − r)²/2"     # whose half is no square
    assert plain(textbook(m * (9 * r * r + 6 * r * R + R * R) / 9)) == "m·(R/3 + r)²"


def test_what_cancels_by_one_denominator_is_zero_over_the_next():
    table = new_table()
    a, b, c, d = (table.parameter(name) for name in "abcd")
    assert textbook((a * a - b * b) / ((a + b) * (c + d)) + (b - a) / (c + d)).is_zero


def test_the_turn_of_no_height_over_squares_is_zero():
    """Not that over a letter, which may have been found negative."""
    table = new_table()
    a, b = (table.parameter(name) for name in "ab")
    turn = {node: table.call("atan2", table.zero, node) for node in (
        a * a + (a - b) ** 2, a * a, table.number(2), a, a * a + b, table.number(-1), -a * a)}
    assert [node for node, found in turn.items() if found.is_zero] == list(turn)[:3]
