"""Functions that a table defines, by those of parts in series: values, slopes of all orders, errors, other tables."""

import mpmath
import numpy as np
import pytest

from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.dual_numbers import Dual, Duals
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.interval_arithmetic import Intervals, exact
from vibcli.symbolic.running_errors import Rounded, RunningErrors
from vibcli.symbolic.series_of_laws import PartLaw, SeriesOfLaws
from vibcli.symbolic.transfer_between_tables import copied

VALUES = {"x": 0.3, "k1": 2.0, "k2": 1.0, "g": 5.0}
NAMES = "k1", "k2", "g"


@pytest.fixture
def scene():
    """(table, x, V, F) of a linear spring in series with one of Duffing."""
    table = Table()
    x, d = table.variable("x"), table.variable("d")
    k1, k2, g = symbols = [table.parameter(name) for name in NAMES]
    laws = [PartLaw(law, from_zero(law, d)) for law in (k1 * d, k2 * d + g * d**3)]
    V = SeriesOfLaws("s", laws, d, symbols, symbols).called("energy", x, symbols)
    return table, x, V, gradient(V)[x]


def _force(x, k1, k2, g):
    """F by the root of k₂ d + g d³ = k₁ (x − d), in mpmath."""
    roots = mpmath.polyroots([g, 0, k1 + k2, -k1 * x], maxsteps=200, extraprec=400)
    return k1 * (x - next(root.real for root in roots if abs(root.imag) < mpmath.mpf(10) ** -30))


def _at(node, **changed):
    values = {name: mpmath.mpf(value) for name, value in {**VALUES, **changed}.items()}
    return evaluate([node], multiprecision(), values)[0]


@pytest.mark.sweep
def test_force_and_slopes_of_all_orders(scene):
    _, x, V, node = scene
    with mpmath.workdps(40):
        k = [mpmath.mpf(VALUES[name]) for name in NAMES]
        for order in range(4):
            expected = mpmath.diff(lambda u: _force(u, *k), mpmath.mpf(VALUES["x"]), order)
            assert mpmath.almosteq(_at(node), expected, 1e-25 if order < 2 else 1e-15)
            assert float(evaluate([node], Floats, VALUES)[0]) == pytest.approx(float(expected), rel=1e-14)
            node = gradient(node)[x]
        energy = mpmath.quad(lambda u: _force(u, *k), [0, mpmath.mpf(VALUES["x"])])
        assert mpmath.almosteq(_at(V), energy, 1e-20)


@pytest.mark.parametrize("name", NAMES)
def test_slopes_by_parameters(scene, name):
    _, x, V, force = scene
    for node in (V, force, gradient(force)[x]):
        with mpmath.workdps(40):
            expected = float(mpmath.diff(lambda p, node=node: _at(node, **{name: p}), VALUES[name]))
        found, = evaluate([node], Duals(Floats), {**VALUES, name: Dual(VALUES[name], 1.0)})
        assert found.slope == pytest.approx(expected, rel=1e-12)


def test_arrays_agree_with_numbers(scene):
    places = np.linspace(-2, 2, 41)
    found, = evaluate([scene[3]], Arrays, {**VALUES, "x": places})
    assert found == pytest.approx([evaluate([scene[3]], Floats, {**VALUES, "x": float(u)})[0] for u in places],
                                  rel=1e-15)
    assert found[20] == 0.0


def test_errors_are_carried(scene):
    moved = {name: Rounded(value * (1 + 1e-9), 1.1e-9 * value) for name, value in VALUES.items()}
    found, = evaluate([scene[3]], RunningErrors(Floats), moved)
    away = abs(found.value - evaluate([scene[3]], Floats, VALUES)[0])
    assert 1e-10 * found.value < away < found.error < 1e-8


def test_at_rest_in_letters(scene):
    table, x, V, force = scene
    k1, k2 = table.parameter("k1"), table.parameter("k2")
    assert substitute([V, force, gradient(force)[x]], {x: table.zero}) == [
        table.zero, table.zero, 1 / (1 / k1 + 1 / k2)]


def test_another_table_knows_them(scene):
    there = Table()
    force, = copied([scene[3]], there)
    assert evaluate([gradient(force)[there.variable("x")]], Floats, VALUES) == evaluate(
        [gradient(scene[3])[scene[1]]], Floats, VALUES)


def test_what_does_not_rise_has_no_value(scene):
    assert np.isnan(evaluate([scene[3]], Floats, {**VALUES, "g": -5.0})[0])


def test_no_bounds_on_intervals(scene):
    with pytest.raises(KeyError):
        evaluate([scene[3]], Intervals, {name: exact(value) for name, value in VALUES.items()})


def test_very_small_and_unlike_deflections(scene):
    for size in (1e-200, 1e-30, 1e6):
        found, = evaluate([scene[3]], Floats, {**VALUES, "x": size})
        with mpmath.workdps(60):
            expected = float(_force(mpmath.mpf(size), *(mpmath.mpf(VALUES[name]) for name in NAMES)))
        assert found == pytest.approx(expected, rel=1e-15)


@pytest.mark.sweep
def test_forces_that_floats_cannot_hold_on_the_way():
    table = Table()
    d, D = table.variable("d"), table.variable("D")
    laws = [PartLaw(law, from_zero(law, d)) for law in (d**3, d**5)]
    force = SeriesOfLaws("s", laws, d, []).called("force", D, [])
    found, = evaluate([force], Arrays, {"D": np.array([1e-70, 1e-105])})
    assert found == pytest.approx([1e-350, 0.0], abs=1e-300)
    inner = force.table.call("s.1", D), force.table.call("s.2", D)
    first, second = evaluate(inner, Floats, {"D": 1e-70})
    assert second == pytest.approx(1e-70, rel=1e-15)
    assert first == pytest.approx(1e-70 ** (5 / 3), rel=1e-13)
