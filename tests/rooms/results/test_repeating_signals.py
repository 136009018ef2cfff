"""Steady states of members under square waves, against sums of harmonics and of modes."""

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

import vibcli
from vibcli.base.errors import PhysicsError
from vibcli.check.verdicts import check
from vibcli.results import modal_response
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.repeating_signal import RepeatingSignal
from vibcli.results.signal import Signal

BAR = """
    parameters: {{L: 1 m, EA: 2e6 N, mu: 2 kg/m, F0: 100 N, Om: 2000 rad/s}}
    bars: {{rod: {{length: L, EA: EA, mass_per_length: mu, left: clamped{}}}}}
    points: {{tip: {{body: rod, at: L}}}}
    forces: {{F: {{at: tip, force: F0*square(Om*t)}}}}
"""
BEAM = """
    parameters: {L: 1 m, EI: 200 N*m^2, mu: 2 kg/m, F0: 100 N, Om: 20 rad/s}
    beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
    points: {tip: {body: b, at: L}}
    damping: {modal: 25 %}
    forces: {F: {at: tip, force: F0*square(Om*t)}}
"""


@pytest.mark.sweep
def test_a_bar_with_an_end_damper():
    """u = Σ Im H(inΩ) 4F₀/(πn) e^{inΩt}, 1/H = EA k cot kL + iωc."""
    model = vibcli.loads(BAR.format(", attached: [{at: L, c: 1700 N*s/m}]"))
    n = np.arange(1, 60_001, 2)
    w = 2000.0 * n
    k = w / 1000.0
    H = 1 / (2e6 * k / np.tan(k) + 1j * w * 1700.0) * 400 / np.pi / n

    def u(t):
        return float(np.imag(np.sum(H * np.exp(1j * w * t))))

    for t in (0.4e-3, 1e-3, 2.9e-3):
        known = model[f"steady(rod.u(L))({t!r} s)"]
        assert known.value == pytest.approx(u(t), rel=1e-6) and known.error < 1e-11 * 5e-5
    late = vibcli.loads(BAR.format(", attached: [{at: L, c: 1700 N*s/m}]").replace("(Om*t)", "(Om*t)*step(t - 60 ms)"))
    assert late["steady(rod.u(L))(1 ms)"].value == pytest.approx(u(1e-3), rel=1e-6)     # behind 19 periods without it
    top, when = model["max(steady(rod.u(L)))"].value, model["argmax(steady(rod.u(L)))"].value
    assert top == pytest.approx(u(when), rel=1e-5) and top >= max(u(t) for t in np.linspace(0, np.pi / 1000, 40)) - 1e-9
    assert model["amplitude(rod.u(L))"].value == pytest.approx(top, rel=1e-10)
    assert model["period(steady(rod.u(L)))"].value == pytest.approx(np.pi / 1000, rel=1e-15)
    assert model["mean(steady(rod.u(L)))"].value == model["mean(rod.u(L))"].value == 0
    low, high = (model[f"{what}(steady(rod.force(0 m)))"].value for what in ("min", "max"))
    assert low == pytest.approx(-high, rel=1e-9)


@pytest.mark.sweep
def test_a_beam_whose_modes_are_damped():
    """qᵢ = q₀ + Re A e^{λt} over half a period, qᵢ(t + T/2) = −qᵢ(t); u(L) = Σ φᵢ(L) qᵢ."""
    model, half = vibcli.loads(BEAM), np.pi / 20
    roots = [brentq(lambda x: np.cos(x) + 1 / np.cosh(x), (i + 0.5) * np.pi - 0.5, (i + 0.5) * np.pi + 0.5, xtol=1e-15)
             for i in range(200)]

    def u(t):
        found = 0.0
        for x in roots:
            omega, static = 10 * x**2, 400 / (2 * (10 * x**2) ** 2)
            rate = omega * complex(-0.25, np.sqrt(1 - 0.25**2))
            B = 1j / rate
            found = found + static + np.real(B * (-2 * static / B.real) / (1 + np.exp(rate * half)) * np.exp(rate * t))
        return found

    known = model["steady(b.u(L))(0.1 s)"]
    assert known.value == pytest.approx(u(0.1), rel=1e-8) and known.error < 1e-9
    times = np.linspace(0, half, 4001)
    assert model["max(steady(b.u(L)))"].value == pytest.approx(u(times).max(), rel=1e-6)


@pytest.mark.sweep
def test_what_nothing_holds_swings_about_its_mean():
    """A free shaft with a damper at its end under a couple at its start, whose start leaves it turned aside: the wave
    eˢᵗ is thrown back by R = (Z − c)/(Z + c), Z = √(GIo J), H(s) = (1 + R e^{−2sL/c₀})/(sZ (1 − R e^{−2sL/c₀}))."""
    model = vibcli.loads("""
        shafts: {line: {length: 1 m, GIo: 100 N*m^2, inertia_per_length: 0.5 kg*m, attached: [{at: 1 m, c: 6 N*m*s}]}}
        points: {end: {body: line, at: 0 m}}
        forces: {T: {at: end, moment: 5 N*m*square(4 rad/s*t)}}
    """)
    s, Z = 4j * np.arange(1, 40_001, 2), np.sqrt(50.0)
    back = (Z - 6) / (Z + 6) * np.exp(-2 * s * np.sqrt(0.5 / 100))
    H = (1 + back) / (1 - back) / (s * Z) * 5 * 16 / (np.pi * s)

    def phi(t):
        return float(np.real(np.sum(H * np.exp(s * t))))

    known = {asked: model[asked] for asked in (
        "steady(line.phi(0 m))(0.3 s)", "max(steady(line.phi(0 m)))", "min(steady(line.phi(0 m)))")}
    value, top, bottom = (found.value for found in known.values())
    assert value == pytest.approx(phi(0.3), rel=1e-6) and all(found.error < 1e-9 for found in known.values())
    assert bottom == pytest.approx(-top, abs=1e-9) and top >= max(map(phi, np.linspace(0, np.pi / 2, 50)))
    assert model["mean(steady(line.phi(0 m)))"].value == 0


@pytest.mark.sweep
def test_a_damper_within_what_nothing_holds():
    """A free shaft with a damper at d, by modes: Y = Z tanh(s(L − d)/c₀) + c is thrown back to the couple at its start,
    H(s) = (Z + Y tanh(sd/c₀))/(sZ (Y + Z tanh(sd/c₀))). The mean of modes is known no better than they are, so that
    extremes are read of no more of them than instants."""
    model = vibcli.loads("""
        shafts: {line: {length: 1 m, GIo: 100 N*m^2, inertia_per_length: 0.5 kg*m, attached: [{at: 0.4 m, c: 3 N*m*s}]}}
        points: {end: {body: line, at: 0 m}}
        forces: {T: {at: end, moment: 5 N*m*square(4 rad/s*t)}}
    """)
    s, Z = 4j * np.arange(1, 40_001, 2), np.sqrt(50.0)
    inner, outer = (np.tanh(s * length * np.sqrt(0.5 / 100)) for length in (0.4, 0.6))
    Y = Z * outer + 3
    H = (Z + Y * inner) / (s * Z * (Y + Z * inner)) * 5 * 16 / (np.pi * s)

    def phi(t):
        return float(np.real(np.sum(H * np.exp(s * t))))

    top, when, at = (model[asked] for asked in (
        "max(steady(line.phi(0 m)))", "argmax(steady(line.phi(0 m)))", "steady(line.phi(0 m))(0.3 s)"))
    assert abs(at.value - phi(0.3)) <= at.error < 1e-3 and abs(top.value - phi(when.value)) <= top.error < 1e-3
    assert top.value + top.error >= max(map(phi, np.linspace(0, np.pi / 2, 400)))


def test_errors_of_extremes_are_asked_for_as_the_signal_told_them():
    """Within a period times round otherwise than late in the motion, where the signal knows its extremes."""
    class Late(Signal):
        told = 25.3 + 1e-15, 0.1

        def extreme(self, start, end, sense):
            return self.told

        def error_of_extreme(self, start, end, top, sense):
            return 1e-9 if top == self.told else 1.0

    late = RepeatingSignal(Late(), 1.0, 25.0, 0.0, 0.7)
    assert late.error_of_extreme(0.0, 1.0, late.extreme(0.0, 1.0, 1), 1) == 1e-9
    assert (25.0 + (Late.told[0] - 25.0), (Late.told[1] - 0.7) + 0.7) != Late.told


@pytest.mark.sweep
def test_what_never_dies_out_is_refused_by_name():
    model = vibcli.loads(BAR.format(""))
    with pytest.raises(PhysicsError, match="never die out") as refused:
        model["max(steady(rod.u(L)))"]
    assert "harmonic" in refused.value.hint
    assert model["harmonic[1](rod.u(L))"].value > 0
    with pytest.raises(PhysicsError, match="never die out") as refused:
        model["rms(rod.u(L))"]
    assert "max(steady" not in refused.value.hint


def test_a_mode_that_hardly_dies_out_is_named_before_all_periods_are_followed(monkeypatch):
    followed, values = [], ModalSignal.values
    monkeypatch.setattr(modal_response, "MOST", {True: 128, False: 128})
    monkeypatch.setattr(ModalSignal, "values", lambda self, times: followed.append(max(times)) or values(self, times))
    slow = vibcli.loads(BEAM.replace("25 %", "[25 %, 1e-6, 25 %]"))
    with pytest.raises(PhysicsError, match=r"2048 periods of this load, that of 220\.3\d rad/s least of all"):
        slow["amplitude(b.u(L))"]
    assert max(followed) < 20 * 2 * np.pi / 20


@pytest.mark.sweep
def test_what_nothing_damps_is_kept_up_where_its_period_fits_with_that_of_the_load():
    """T = 3/4 of that of a clamped bar: u = Σ 4F₀/(πn) tan kL/(EA k) sin nΩt, N = EA u′, each over the odd n."""
    model = vibcli.loads(BAR.format("").replace("Om: 2000", "Om: pi/3*2000"))
    n = np.arange(1, 60_001, 2)
    k = n * np.pi * 2 / 3
    X = 400 / np.pi / n * np.tan(k) / k / 2e6
    Omega = np.pi * 2000 / 3
    for t in (0.2e-3, 0.9e-3, 2.1e-3):
        assert model[f"steady(rod.u(L))({t!r} s)"].value == pytest.approx(np.sum(X * np.sin(n * Omega * t)), abs=2e-9)
    top, force = model["amplitude(rod.u(L))"], model["rms(rod.force(0 m))"]
    along = X @ np.sin(np.outer(n, Omega * np.linspace(0, 3e-3, 61)))
    assert top.value == pytest.approx(np.abs(along).max(), abs=2e-9)
    assert model["rms(rod.u(L))"].value == pytest.approx((X @ X / 2) ** 0.5, rel=1e-12)
    assert force.value == pytest.approx((((400 / np.pi / n / np.cos(k)) ** 2).sum() / 2) ** 0.5, rel=1e-5)
    assert top.error < 1e-11 * top.value and force.error < 1e-11 * force.value
    for period in (1.0, 2.0):       # of the first mode: of odd harmonics that of the second case meets none
        model = vibcli.loads(BAR.format("").replace("Om: 2000", f"Om: pi/{period}*500"))
        with pytest.raises(PhysicsError, match="mode 1 is not damped"):
            model["amplitude(rod.u(L))"]


@pytest.mark.sweep
def test_a_free_vibration_far_up_that_fits_into_the_period_is_met():
    """Two bars, 3 : 5 in pitch, repeat themselves in 11/2 periods of the load: mode 17 of both, the 11th of the one,
    stays in the mean of 11."""
    both = ", right: clamped}, other: {length: 3*L/5, EA: EA, mass_per_length: mu, left: clamped, right: clamped"
    bars = BAR.format(both).replace("Om: 2000", "Om: 11/3*pi*1000").replace("at: L}", "at: L/2}")
    with pytest.raises(PhysicsError, match="mode 17 is not damped"):
        vibcli.loads(bars)["amplitude(rod.u(L/2))"]


def test_what_grows_repeats_nothing():
    with pytest.raises(PhysicsError, match="never die out"):
        vibcli.loads(BAR.format(", attached: [{at: L, k: -3e6 N/m}]"))["amplitude(rod.u(L))"]


@pytest.mark.sweep
def test_what_is_not_damped_and_fits_into_the_period_is_refused():
    """Damped at the node of mode 2, which swings for ever with half the period of the load."""
    bar = BAR.format(", right: clamped, attached: [{at: L/2, c: 1000 N*s/m}]").replace("at: L}", "at: L/4}")
    model = vibcli.loads(bar.replace("Om: 2000", "Om: pi*1000").replace("Om*t", "Om*t + pi/2"))
    with pytest.raises(PhysicsError, match="mode 2 is not seen to be damped"):
        model["max(steady(rod.u(L/4)))"]
    assert model["harmonic[1](rod.u(L/4))"].value > 0


@pytest.mark.sweep
def test_what_a_damper_swallows_is_damped():
    """c = √(EA μ): u̇(L) = F₀/(2c) (s(t) − s(t − 2L/c₀)), no free vibration at all."""
    model = vibcli.loads(BAR.format(", attached: [{at: L, c: 2000 N*s/m}]"))
    assert model["max(steady(rod.u'(L)))"].value == pytest.approx(0.05, rel=1e-12)
    assert model["steady(rod.u'(L))(0.5 ms)"].value == pytest.approx(0.05, rel=1e-12)
    assert model["steady(rod.u'(L))(0.4 ms)"].value == pytest.approx(0.0, abs=1e-12)
    rest = 2e-3 - np.pi / 2000      # in which u̇ is 0 in each half period
    rising = np.pi / 2000 - rest
    assert model["rms(steady(rod.u(L)))"].value == pytest.approx(
        0.05 * rising / 2 * ((rest + rising / 3) / (rest + rising)) ** 0.5, rel=1e-12)
    with pytest.raises(PhysicsError, match="one at a time") as refused:
        model["phase(rod.u(L))"]
    assert "max(steady(rod.u(L)))" in refused.value.hint and "amplitude(rod.u(L))" in refused.value.hint


@pytest.mark.sweep
def test_a_load_that_jumps_very_often_is_refused_before_it_is_followed():
    bar = BAR.format(", attached: [{at: L, c: 1000 N*s/m}]")
    with pytest.raises(PhysicsError, match="too often"):
        vibcli.loads(bar.replace("square(Om*t)", "square(Om*t) + F0*sin(1234 rad/s*t)"))["max(steady(rod.u(L)))"]


def test_a_harmonic_that_no_load_has_is_nothing_beside_the_first():
    scene = problem(BAR.format("") + "    answers: {'harmonic[2](rod.u(L))': 0 m, 'harmonic[1](rod.u(L))': 0 m}\n")
    assert [verdict.agrees for verdict in check(scene)] == [True, False]


def test_the_mean_square_of_what_dies_out_next_to_a_front():
    """e^{−t/ε} from each period on, as a force beside a small mass: ε/2 of the period, within a bound that is near."""
    class Layer(Signal):
        def values(self, times):
            return np.exp(-(np.asarray(times) % 1.0) / 1e-4)

        def error(self, t):
            return 0.0

    square, error = RepeatingSignal(Layer(), 1.0, 0.0, 0.0).mean_square(0.0)
    assert abs(square - 5e-5) <= error <= 1e-12 * 5e-5
