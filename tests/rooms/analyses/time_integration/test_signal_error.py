"""How far numbers of a full motion may be off is told: instants, periods, what data leave, and where digits run out."""

import math

import numpy as np
import pytest
from support.motions import AT_THE_TOP, PENDULUM, duffing_period, problem

from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.analyses.time_integration.level_crossings import extreme
from vibcli.analyses.time_integration.rounded_data import DIRECTIONS, STEP, ChangeOfData
from vibcli.api.values import given_expression
from vibcli.plots.response import of_response
from vibcli.quantities.expression import measure

CUBIC = """motion: full
parameters: {m: 1.1 kg, k: 30.3 N/m, k3: 70.7 N/m^3}
bodies: {b: {mass: m, slide: x}}
springs: {s: {law: k*d + k3*d^3, between: [ground, b]}}
initial: {x: 0.3 m}
find: [{response: {until: 7 s}}]
"""


def measured(one, text):
    return measure(one, given_expression(text, "it").tree)


def test_a_period_that_is_searched_and_a_passage_are_as_near_as_they_say():
    one = problem(CUBIC)
    true = float(duffing_period((30.3 / 1.1) ** 0.5, 70.7 / 1.1, 0.3))
    period, error = measured(one, "period(x')")
    assert abs(period / true - 1) <= error < 1e-10
    passage, error = measured(one, "zero[5](x)")
    assert abs(passage / (true * 9 / 4) - 1) <= error < 1e-10
    instant, error = measured(one, "argmin(x)")
    assert abs((instant / true) % 1 - 0.5) * true / instant <= error < 1e-7


@pytest.mark.parametrize("seed", range(DIRECTIONS))
def test_data_that_are_exact_are_not_changed(seed):
    """Binary fractions, beside decimals next to them."""
    change = ChangeOfData(seed)
    assert [change(x) for x in (0.5, 9.8125, -9e5)] == [0.5, 9.8125, -9e5]
    assert all(0 < abs(change(x) / x - 1) < 2 * STEP for x in (0.50001, 9.81, -9.1e-5))


def test_only_what_parts_exponentially_is_told_to_do_so():
    top = problem(AT_THE_TOP)
    found = known_motion(top.configuration, 30.0, top.initial.given)
    assert found.shared.folding == pytest.approx(1 / math.sqrt(9.81), rel=0.1)
    swinging = problem("motion: full\n" + PENDULUM + "initial: {phi: 1}\n")
    found = known_motion(swinging.configuration, 200.0, swinging.initial.given)
    assert found.end == 200.0 and found.shared.folding is None


def test_a_plot_goes_on_beyond_what_is_known_and_marks_it():
    panel, = of_response([0.0, 1.0, 2.0], [("x", "m", [0.0, 1.0, 0.0])], until=9.0).panels
    assert panel.marks[0].at == 2.0 and panel.x_range == (0.0, 2.5) and "known up to 2 s" in panel.marks[0].label
    panel, = of_response([0.0, 1.0, 2.0], [("x", "m", [0.0, 1.0, 0.0])], until=2.0).panels
    assert not panel.marks and panel.x_range is None


def test_an_extreme_is_where_the_rate_vanishes_and_not_at_the_end_of_a_window_next_to_it():
    one = problem(CUBIC)
    found = one.response.trajectory(7.0)
    edge = found.windows[3].start

    def parabola(times):
        return -(np.asarray(times) - edge - 1e-8) ** 2

    assert extreme(found, parabola, 0.0, 7.0, 1)[0] == pytest.approx(edge + 1e-8, abs=1e-12)


def test_a_root_that_touches_zero_has_an_error_though_it_has_no_value_beside_the_motion():
    one = problem(CUBIC)
    value, error = measured(one, "acos(x/(0.3 m))(0.01 s)")
    assert 0 < value < 0.2 and error < 1e-9
    value, error = measured(one, "sqrt(x'^2)(0.2 s)")
    assert value > 0 and error < 1e-9
