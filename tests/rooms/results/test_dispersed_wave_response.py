"""Bars with drag or on a foundation in time: against their modes under a smooth window, as between fronts the sums of
these converge faster than any power of their number."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import measure
from vibcli.results.dispersed_wave_response import DispersedWaveResponse
from vibcli.results.modal_response import ModalResponse
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.wave_signals import DispersedSignal
from vibcli.symbolic.parser import parse

BAR = """
parameters: {L: 1 m, F: 1 N}
bars:
  rod: {length: L, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, REST}
points: {tip: {body: rod, at: L}}
"""
STEP = "forces: {pull: {at: tip, force: F*step(t)}}\n"
COUNT = 4000


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


def by_modes(x, t, c, k, along, held=1.0):
    """u or EA u′ after a step of F at the tip, or, held = 0, let go from there: Σ φ(x) φ(L)/ω² η beside statics."""
    w, share = (np.arange(1, COUNT + 1) - 0.5) * np.pi, (np.arange(COUNT) + 0.5) / COUNT
    window = 0.5 * (1 - np.tanh(np.tan(np.pi * (np.clip(share, 0.2, 1 - 1e-9) - 0.6) / 0.81)))
    root = np.sqrt(w**2 + k - c * c / 4 + 0j)
    free = (np.exp(-c * t / 2) * (np.cos(root * t) + c / 2 * np.sin(root * t) / root)).real / (w**2 + k)
    shape = 2 * np.sin(w) * (w * np.cos(w * x) if along else np.sin(w * x))
    q = np.sqrt(k) or 1e-9
    still = np.cosh(q * x) / np.cosh(q) if along else np.sinh(q * x) / (q * np.cosh(q))
    return held * still + (1 - 2 * held) * (shape * free * window)[::-1].sum()


@pytest.mark.sweep
@pytest.mark.parametrize(("c", "k"), [(0.2, 0.0), (2.0, 1.0), (0.0, 30.0)])
def test_a_bar_after_a_step(c, k):
    rest = ", ".join([f"drag: {c} N*s/m^2"] * bool(c) + [f"foundation: {k} N/m^2"] * bool(k))
    scene = problem(BAR.replace("REST", rest) + STEP)
    for x in (0.0, 0.3):
        for along, name in ((0, "u"), (1, "force")):
            for t in (0.43, 4.17) if x or along else ():
                found = signal(scene, f"rod.{name}({x}*L)").read_at(t)
                off = abs(found.values(np.array([t]))[0] - by_modes(x, t, c, k, along))
                assert off <= found.error(t) + 1e-13
                assert found.error(t) <= (3e-10 if along else 1e-11)


def test_one_let_go():
    scene = problem(BAR.replace("REST", "drag: 0.7 N*s/m^2") + STEP.replace("*step(t)", "")
                    + "initial: {released: pull}\n")
    for name, x, along in (("rod.u(0.3*L)", 0.3, 0), ("rod.force(0 m)", 0.0, 1)):
        found = signal(scene, name).read_at(1.5)
        off = abs(found.values(np.array([1.5]))[0] - by_modes(x, 1.5, 0.7, 0.0, along, held=0.0))
        assert off <= found.error(1.5) + 1e-13 <= 1e-10


@pytest.mark.sweep
def test_fronts_stay_sharp_and_fade():
    """e^{−ct/2μ} of what they were; behind them the force still grows."""
    found = signal(problem(BAR.replace("REST", "drag: 0.2 N*s/m^2") + STEP + "find: [{response: {until: 2.5 s}}]\n"),
                   "rod.force(0 m)")
    (t, before, after), = found.leaps(2.5)
    assert (t, before) == (1.0, 0.0)
    assert after == pytest.approx(2 * np.exp(-0.1), rel=1e-14)
    t, top = found.extreme(0.0, 2.5, 1)
    assert t == 2.5
    assert top == pytest.approx(by_modes(0.0, 2.5, 0.2, 0.0, 1), rel=1e-12)
    assert found.error_of_extreme(0.0, 2.5, (t, top), 1) <= 1e-10


STEPPED = """
parameters: {L: 1 m, F: 1 N, a: 1 mm}
bodies: {base: {slide: MOVED}}
bars:
  rod: {left: {clamped: base}, mass_per_length: 1 kg/m, drag: 0.4 N*s/m^2, foundation: 1 N/m^2, segments: [
    {length: 0.4*L, EA: 1 N}, {length: 0.6*L, EA: 3 N, mass_per_length: 2 kg/m, drag: 0.8 N*s/m^2,
     foundation: 2 N/m^2}]}
points: {tip: {body: rod, at: L}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("moved", "rest"), [
    ("a*sin(2 rad/s*t)", ""), ("0*a", "forces: {blow: {body: rod, per_length: 1 N/m*x/L*cos(3 rad/s*t)}}\n"),
    ("0*a", "forces: {pull: {at: tip, force: F*(step(t - 0.2 s) - step(t - 0.5 s))*exp(-t/(1 s))}}\n"),
    ("0*a", "initial: {rod.u: 5*a*sin(2*x/L)}\n")])
def test_a_stepped_bar_moves_as_its_modes_do(moved, rest):
    text = STEPPED.replace("MOVED", moved) + rest
    scene = problem(text.replace("F: 1 N, ", "") if "F*" not in text else text)
    for name in ("rod.u(0.3*L)", "rod.u(L)"):
        found = signal(scene, name)
        exact = found.read_at(1.37)
        off = np.abs(exact.values(np.array([1.37])) - found.values(np.array([1.37])))
        assert exact.error(1.37) < 1e-4 * found.error(1.37)
        assert off <= found.error(1.37) < 1e-2


@pytest.mark.sweep
def test_what_is_not_followed_goes_by_modes(monkeypatch):
    monkeypatch.setattr(ModalResponse, "limit", 0)
    ramp = problem(BAR.replace("REST", "drag: 0.2 N*s/m^2") + STEP.replace("step(t)", "sin(t/(1 s))"))
    bent = problem(BAR.replace("REST", "foundation: 2 N/m^2") + STEP.replace("*step(t)", "")
                   + "initial: {released: pull}\n")
    assert isinstance(signal(bent, "rod.u(L/2)").read_at(0.3), ModalSignal)
    assert isinstance(ramp.response._waves, DispersedWaveResponse)
    assert isinstance(signal(ramp, "rod.u''(L)").read_at(0.3), ModalSignal)
    assert isinstance(signal(ramp, "rod.u(L)").read_at(1e6), ModalSignal)


def fading(t, late, c, k):
    """e^{−pT} of p² = s² + cs + k behind its front, over p, and the rate of that, in time (Doetsch 1974), T = late."""
    delta, square = mpmath.mpf(c) / 2, mpmath.mpf(c)**2 / 4 - k
    if t <= late:
        return mpmath.zeros(1, 3)
    z, faded = mpmath.sqrt(square * (t * t - late * late)), mpmath.exp(-delta * t)
    bent = square * (mpmath.besseli(1, z) / z if z else 0.5)
    found = faded * mpmath.besseli(0, z)
    return mpmath.matrix([[(faded * late * bent).real, found.real, (faded * t * bent - delta * found).real]])


def after_blow(x, t, c, k):
    """(EA u′, u, u̇) at x after a unit blow at the tip, both ways of all waves."""
    signs = mpmath.diag([1, -1, -1])
    return sum(((-1)**n * (fading(t, 2 * n + 1 - x, c, k) + fading(t, 2 * n + 1 + x, c, k) * signs)
                for n in range(int(t) + 1)), mpmath.zeros(1, 3))


def started(t, c, k):
    """(u, u̇) at the tip after a start with a velocity of 1 everywhere, (1 − 1/cosh p)/p²."""
    found = []
    for rate in range(2):
        parts = [(2 if late else 1) * (-1)**((late + 1) // 2) * (
            mpmath.quad(lambda T: fading(t, T, c, k)[1 + rate], [late, t]) + rate * mpmath.exp(-c * t / 2))  # noqa: B023
            for late in [0, *range(1, int(t) + 1, 2)]]
        found.append(sum(parts))
    return found


def compared(scene, text, t, value):
    found = signal(scene, text).read_at(t)
    assert isinstance(found, DispersedSignal)
    assert abs(found.values(np.array([t]))[0] - float(value)) <= found.error(t) + 1e-15 <= 1e-10


@pytest.mark.sweep
@pytest.mark.parametrize(("c", "k"), [(2.0, 1.0), (0.4, 5.0)])
def test_rates_blows_and_starts_with_a_velocity(c, k):
    bar, t = BAR.replace("REST", f"drag: {c} N*s/m^2, foundation: {k} N/m^2"), mpmath.mpf("1.7")
    force, place, rate = after_blow(mpmath.mpf("0.3"), t, c, k)
    step = problem(bar + STEP)
    compared(step, "rod.u'(0.3*L)", 1.7, place)
    compared(step, "rod.u'(L)", 1.7, after_blow(1, t, c, k)[1])
    blow = problem(bar + STEP.replace("step(t)", "impulse(t/(1 s))"))
    compared(blow, "rod.u(0.3*L)", 1.7, place)
    compared(blow, "rod.force(0.3*L)", 1.7, force)
    compared(blow, "rod.u'(0.3*L)", 1.7, rate)
    moving = problem(bar.replace("F: 1 N", "V: 1 m/s") + "initial: {rod.u': V}\n")
    place, rate = started(t, c, k)
    compared(moving, "rod.u(L)", 1.7, place)
    compared(moving, "rod.u'(L)", 1.7, rate)


@pytest.mark.sweep
def test_extremes_are_read_of_waves_where_modes_leave_them_open():
    scene = problem(BAR.replace("REST", "drag: 0.2 N*s/m^2") + STEP + "find: [{response: {until: 5 s}}]\n")
    top, error = measure(scene, with_places(parse("max(rod.u(L))"), scene.spec.members))
    expected = mpmath.quad(lambda t: after_blow(1, t, 0.2, 0.0)[1], [0, 2])
    assert abs(top - float(expected)) <= error * top <= 1e-12
    at, error = measure(scene, with_places(parse("argmax(rod.u(L))"), scene.spec.members))
    assert abs(at - 2) <= error * at <= 1e-11
