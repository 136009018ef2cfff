"""Laws from tables against SciPy's monotone cubics and sums of mpmath."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.kinks import kinks_of
from vibcli.symbolic.tabulated_functions import PiecewiseCubic

TABLES = {
    "rising": ([-4, -2, 0, 1, 2, 5], [-90, -40, 0, 15, 40, 41]),
    "between two points": ([-1, 2], [-3, 5]),
    "rises and falls": ([-3, -1, 2, 3, 4, 7], [4, -2, 6, 6, 1, 3]),
    "begins at zero": ([0, 1, 4, 6], [0, 2, 3, 9]),
    "ends at zero": ([-6, -3, -1, 0], [-2, -1, -1, 4]),
}


def _law(name, linear):
    u, F = TABLES[name]
    return PiecewiseCubic("s", list(map(Fraction, u)), list(map(Fraction, F)), linear)


@pytest.mark.parametrize("name", TABLES)
def test_it_is_the_monotone_cubic_of_scipy_with_its_derivatives_and_its_integral(name):
    u, F = (np.array(column, dtype=float) for column in TABLES[name])
    law, table, pchip = _law(name, False), Table(), PchipInterpolator(u, F)
    x, places = table.variable("x"), np.linspace(u[0], u[-1], 83)
    V, node = pchip.antiderivative(), law.called(-1, x)
    size = np.abs(F).max()
    expected = [V(places) - V(0.0), pchip(places), pchip(places, 1)]
    for order, wanted in enumerate(expected, -1):
        function = table.functions[node.name]
        assert function.on_arrays(places) == pytest.approx(wanted, abs=1e-13 * size)
        assert [function.at(float(place)) for place in places] == pytest.approx(wanted, abs=1e-13 * size)
        assert node is law.called(order, x)
        node = gradient(node)[x]
    assert np.isnan(function.on_arrays(np.array([u[0] - 0.1, u[-1] + 0.1]))).all()


@pytest.mark.sweep
def test_its_energy_is_the_integral_in_many_digits_and_small_where_its_argument_is():
    law, table = _law("rising", True), Table()
    x = table.variable("x")
    V, F = law.called(-1, x), law.called(0, x)
    with mpmath.workdps(50):
        for place in map(mpmath.mpf, ("-5", "-2.5", "1e-6", "4.3", "7")):
            stops = sorted({mpmath.mpf(0), place, *(u for u in TABLES["rising"][0] if 0 < u / place < 1)}, key=abs)
            wanted = mpmath.quad(lambda u: evaluate([F], multiprecision(), {"x": u})[0], stops)
            found, = evaluate([V], multiprecision(), {"x": place})
            assert abs(found - wanted) <= mpmath.mpf(10) ** -40 * abs(wanted)
            assert evaluate([V], Floats, {"x": float(place)})[0] == pytest.approx(float(wanted), rel=4e-16)


def test_its_points_are_kinks_beyond_which_each_cubic_goes_on_alone():
    law, table = _law("rising", True), Table()
    x = table.variable("x")
    F = law.called(0, x)
    assert evaluate(kinks_of([F], x), Floats, {"x": 3.0}) == [3.0 - u for u in TABLES["rising"][0]]
    function, places = table.functions[F.name], np.array([1.1, 1.9, 2.0, 2.2])
    senses = [1, 1, 1, 1, -1, -1]                      # between 1 and 2
    cubic = np.polynomial.Polynomial.fit(inside := np.linspace(1.0, 2.0, 9), function.on_arrays(inside), 3)
    assert function.on_senses((places,), senses) == pytest.approx(cubic(places), rel=1e-13)
    across = np.array([-0.5, 0.5])
    assert function.on_senses((across,), [1, 1, 1, -1, -1, -1])[1] == function.on_arrays(np.array([0.5]))[0]
