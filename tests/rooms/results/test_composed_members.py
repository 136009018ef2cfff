"""Functions of signals of members in time: extremes, their instants and bounds against exact motions."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.results.modal_response import ModalResponse
from vibcli.symbolic.parser import parse

ROD = """\
    parameters: {L: 1 m}
    bars:
      rod: {length: L, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, attached: [{at: L, mass: 1 kg}]}
    points: {tip: {body: rod, at: L}}
    forces: {push: {at: tip, force: 1 N*%s}}
    find: [{response: {until: 5 s}}]
    """
SIGNALS = "abs(rod.u(L))", "rod.u(L)*rod.u(L/2)", "max(rod.u(L), rod.u(L/3) + 0.3 m)"


def signal(response, text):
    return response.signal(with_places(parse(text), response.problem.spec.members))


@pytest.fixture(scope="module")
def struck():
    return problem(ROD % "cos(3 rad/s*t)")


@pytest.fixture(scope="module")
def by_modes(struck):
    return by_few(ModalResponse(struck))


def by_few(response):
    response.most = 64
    response.alone = response.motion(64)
    return response


@pytest.mark.sweep
@pytest.mark.parametrize("text", SIGNALS)
def test_extremes_by_waves_and_by_modes_agree_within_their_bounds(struck, by_modes, text):
    modal, waves = signal(by_modes, text), signal(struck.response, text)
    for sense in (1, -1):
        (t, value), (instant, exact) = modal.extreme(0.0, 2.0, sense), waves.extreme(0.0, 2.0, sense)
        bound = modal.error_of_extreme(0.0, 2.0, (t, value), sense)
        assert abs(value - exact) <= bound + 1e-13
        assert bound < 1e-2
        grid = np.linspace(0.0, 2.0, 20_001)
        assert (sense * waves.values(grid)).max() <= sense * exact + 1e-12
        near = np.abs(grid - instant) < 2e-3
        assert (sense * waves.values(grid[near])).max() == pytest.approx(sense * exact, abs=1e-4)
        if sense > 0 or "abs" not in text:      # it is zero more than once
            assert abs(t - instant) <= modal.error_of_time(t) + waves.error_of_time(instant)


@pytest.mark.sweep
def test_where_a_function_of_waves_bends_it_is_divided_at_once():
    fast = problem(ROD % "sin(40 rad/s*t)").response
    up, down = (signal(fast, "rod.u(L)").extreme(0.0, 5.0, sense)[1] for sense in (1, -1))
    assert signal(fast, "abs(rod.u(L))").extreme(0.0, 5.0, 1)[1] == pytest.approx(max(up, -down), rel=1e-12)


def test_the_instant_at_which_two_waves_meet_is_as_uncertain_as_they_are(struck):
    class Off:
        """x and y that meet at t = 1 s with slopes ±1, known to 1e-6."""

        signals = ()

        def values(self, times):
            return np.minimum(times, 2 - times)

        def error(self, t):
            return 1e-6

    from vibcli.results.composed_errors import at_pace

    assert 1e-6 <= at_pace(Off(), 1.0, 1, 1.0) <= 1e-5


@pytest.mark.sweep
def test_moments_after_a_jump_are_bounded_wherever_they_are_largest(monkeypatch):
    monkeypatch.setattr(ModalResponse, "limit", 64)
    scene = by_few(problem("""\
        parameters: {L: 1 m}
        beams: {arm: {length: L, EI: 1 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
        points: {tip: {body: arm, at: L}}
        forces: {push: {at: tip, force: 1 N*step(t)}}
        """).response)
    plain, size = signal(scene, "arm.moment(0 m)"), signal(scene, "abs(arm.moment(0 m))")
    top, value = size.extreme(0.0, 1.5, 1)
    bound = size.error_of_extreme(0.0, 1.5, (top, value), 1)
    t, exact = plain.extreme(0.0, 1.5, 1)
    low = plain.extreme(0.0, 1.5, -1)
    exact = max(exact, -low[1])
    assert abs(value - exact) <= bound
    assert bound >= size.error(top) > 0
    beside = t if exact == plain.values(np.array([t]))[0] else low[0]
    assert size.error_of_time(top) >= 0.5 * plain.error_of_time(beside)


def test_steady_states_stand_beside_waves(struck):
    steady = signal(struck.response, "steady(rod.u(L))").extreme(0.0, 2.0, 1)[1]
    assert signal(struck.response, "abs(steady(rod.u(L)))").extreme(0.0, 2.2, 1)[1] == pytest.approx(steady, rel=1e-9)
    both = signal(struck.response, "abs(rod.u(L) - steady(rod.u(L)))")
    at = np.array([0.3, 1.4])
    parts = [signal(struck.response, name).values(at) for name in ("rod.u(L)", "steady(rod.u(L))")]
    np.testing.assert_allclose(both.values(at), np.abs(parts[0] - parts[1]), rtol=1e-12)
    assert both.extreme(0.0, 2.0, 1)[1] >= both.values(np.linspace(0.0, 2.0, 999)).max() - 1e-12


def test_instants_at_the_start_of_a_steady_state(struck):
    size = signal(struck.response, "abs(steady(rod.u(L)))")
    assert size.error_of_time(0.0) == 0.0
    assert 0 < size.error_of_time(size.extreme(0.5, 1.5, 1)[0]) < 1e-6
