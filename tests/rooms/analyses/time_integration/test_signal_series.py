"""Passages and turns of a signal along the series of a motion."""

from types import SimpleNamespace

import pytest
from support.scenes import problem, value

from vibcli.analyses.time_integration.signal_series import SignalAlong
from vibcli.analyses.time_integration.taylor_march import Step

BITS = 200
LATER = """
    motion: full
    parameters: {m: 2 kg, k: 800 N/m, F: 3 N}
    bodies: {b: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, b]}}
    forces: {P: {at: b, force: F*sin(7 rad/s*(t - 0.3 s))*step(t - 0.3 s)}}
"""


def along(rows):
    """A signal in steps of a second each, from its coefficients in each."""
    one = 1 << BITS
    steps = [Step(k * one, (k + 1) * one, one, None) for k in range(len(rows))]
    march = SimpleNamespace(bits=BITS, steps=steps, reach=lambda instant: None)
    return SignalAlong(march, lambda step: rows[steps.index(step)])


@pytest.mark.parametrize("size", [1, 10**400, 10**1000], ids=["1", "1e400", "1e1000"])
def test_signals_of_any_size_turn_and_pass(size):
    """size (s − 1/4)(s − 1/2)(s − 3/4), which turns at 1/2 ± 1/√48, also where it is larger than any float."""
    signal = along([[-3 * size << BITS - 5, 11 * size << BITS - 4, -3 * size << BITS - 1, size << BITS]])
    assert [signal.time(place) / 2**BITS for place in signal.passages(0, 1 << BITS)] == pytest.approx(
        [0.25, 0.5, 0.75], rel=1e-15)
    place = signal.extreme(0, 3 << BITS - 2, 1, 20)
    assert signal.time(place) / 2**BITS == pytest.approx(0.5 - 48**-0.5, rel=1e-12)


def test_what_is_zero_throughout_passes_it_nowhere():
    """0 for a second, then s (1/2 − s)."""
    signal = along([[0, 0, 0], [0, 1 << BITS - 1, -1 << BITS]])
    assert [signal.time(place) / 2**BITS for place in signal.passages(0, 2 << BITS)] == [1.0, 1.5]


@pytest.mark.sweep
def test_rest_before_a_load_is_no_zero():
    """sin Ωt − (Ω/ω) sin ωt after 0.3 s; its roots by mpmath."""
    found = problem(LATER).with_digits(25)
    for number, instant in enumerate((0.3, 0.6980190962338, 1.1489037460048), 1):
        assert value(found, f"zero[{number}](x)") == pytest.approx(instant, rel=1e-12)
