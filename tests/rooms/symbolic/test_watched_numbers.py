"""Decisions by numbers hold at other values where each comes out the same there."""

import math

import pytest

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.watched_numbers import Decisions

VALUES = {"a": 3.0, "b": 1.0, "c": 2.0}


@pytest.fixture
def scene():
    table, decisions = Table(), Decisions()
    return [table.parameter(name) for name in VALUES], decisions, decisions.watched(VALUES)


def hold(decisions, **values):
    return decisions.hold(VALUES, {**VALUES, **values})


def test_numbers_are_those_of_floats(scene):
    (a, b, c), _, watched = scene
    found = evaluate([a - b, a * c, a.table.sqrt(a + b)], Floats, watched)
    assert [float(x) for x in found] == [2.0, 6.0, 2.0]
    assert float(abs(-found[0] + 1) / 2 - 3 * found[1] ** 2 + found[0] % 2) == 0.5 - 108
    assert float(1 / found[0]) == 0.5 and float(2 ** found[0]) == 4.0 and float(+found[0] // 3) == 0.0
    assert f"{found[0]:.1f}" == "2.0" and repr(found[0]) == "2.0" and int(found[0]) == 2 and round(found[1]) == 6
    assert math.sqrt(found[2]) == math.sqrt(2.0) and hash(found[0]) == hash(2.0)


@pytest.mark.parametrize(("decide", "same", "other"), [
    (lambda x, y: x < y, {"a": 2.5}, {"a": 5.5}), (lambda x, y: max(x, y), {"c": 1.5}, {"c": 0.5}),
    (lambda x, y: 1 if x else 0, {"a": 2.5}, {"a": 1.0}), (lambda x, y: abs(x - y) <= 1e-9, {"c": 3.0}, {"c": 1.0}),
    (lambda x, y: math.sin(y), {"a": 7.0}, {"c": 2.5}), (lambda x, y: int(x), {"c": 7.0}, {"b": 0.5}),
    (lambda x, y: sorted([y, x]), {"c": 3.0}, {"c": 0.1}), (lambda x, y: x == 2, {"c": 9.0}, {"a": 3.5})])
def test_a_decision(scene, decide, same, other):
    """x = a − b is 2, y = 2 c is 4."""
    (a, b, c), decisions, watched = scene
    decide(*evaluate([a - b, 2 * c], Floats, watched))
    assert hold(decisions) and hold(decisions, **same)
    assert not hold(decisions, **other)


def test_the_parameters_themselves_are_watched(scene):
    _, decisions, watched = scene
    assert {**watched, "t": 0.0}["a"] > 2.5
    assert hold(decisions, a=2.6, b=100.0) and not hold(decisions, a=2.4)
    assert not hold(decisions, b=-1.0)      # a parameter keeps its sign, whatever was decided


def test_what_no_formula_tells_holds_nowhere(scene):
    _, decisions, watched = scene
    with pytest.raises(ZeroDivisionError):
        watched["a"] / (watched["b"] - 1)
    assert decisions.lost and not hold(decisions)


def test_what_has_no_value_elsewhere_does_not_hold(scene):
    _, decisions, watched = scene
    assert 1 / watched["b"] is not None
    assert hold(decisions, b=5.0) and not hold(decisions, b=0.0)
