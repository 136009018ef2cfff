"""Numbers that carry a bound of their error: never exceeded, against 60 digits at the values that floats stand for."""

import random

import mpmath
import pytest
from support.trees import NAMES, new_table, trees

from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in, number_in


@pytest.mark.sweep
@pytest.mark.parametrize("size", [0.0, 1e-15, 1e-9, 1e-5])
def test_the_bound_is_never_exceeded(size):
    draw, checked = random.Random(f"running {size}"), 0
    for expression, _ in trees(150, f"running {size}"):
        at = {name: draw.uniform(0.2, 3) * draw.choice([1, 1 if name in "mk" else -1]) for name in NAMES}
        moved = {name: x * (1 + draw.uniform(-1, 1) * size) for name, x in at.items()}
        bounded = {name: Rounded(moved[name], abs(moved[name]) * size * 1.001) for name in at}
        found, = evaluate([expression.node], RunningErrors(Floats), bounded)
        value, error = number_in(found), error_in(found)
        with mpmath.workdps(60):
            try:
                exact, = evaluate([expression.node], multiprecision(), {n: mpmath.mpf(x) for n, x in at.items()})
            except (ArithmeticError, AttributeError, TypeError, ValueError):      # beyond what is real
                continue
            if not isinstance(exact, mpmath.mpf) or not mpmath.isfinite(exact) or not error < abs(value) / 100:
                continue
            off = abs(exact - value)
        assert off <= (1.001 if size < 1e-6 else 1.2) * error, expression.sympy
        checked += 1
    assert checked > 60


def test_what_cancels_is_seen():
    table = new_table()
    x, y = table.variable("x"), table.variable("y")
    found, = evaluate([x * x - y * y], RunningErrors(Floats), {"x": 1e8 + 1, "y": 1e8})
    assert error_in(found) >= 1
    assert abs(number_in(found) - 200000001) <= error_in(found)


def test_a_jump_within_its_error_has_no_bound():
    table = new_table()
    node = table.call("sign", table.variable("x"))
    assert error_in(evaluate([node], RunningErrors(Floats), {"x": Rounded(1e-9, 1e-8)})[0]) == float("inf")
    assert error_in(evaluate([node], RunningErrors(Floats), {"x": Rounded(1e-9, 1e-10)})[0]) < 1e-15


@pytest.mark.parametrize("node, error", [
    (lambda t, x, y: t.call("max", x, y), 1e-3), (lambda t, x, y: t.call("min", x, y), 1e3),
    (lambda t, x, y: t.call("max", t.number(1), y + t.number(9e5)), 1e3), (lambda t, x, y: t.call("ramp", y), 0)])
def test_what_a_maximum_does_not_reach_is_not_felt(node, error):
    table = new_table()
    found, = evaluate([node(table, table.variable("x"), table.variable("y"))], RunningErrors(Floats),
                      {"x": Rounded(1.0, 1e-3), "y": Rounded(-9e5, 1e3)})
    assert error_in(found) == pytest.approx(error, rel=1e-6)
