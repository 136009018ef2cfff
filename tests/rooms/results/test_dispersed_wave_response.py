"""Bars with drag or on a foundation in time: against their modes under a smooth window, as between fronts the sums of
these converge faster than any power of their number."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.results.dispersed_wave_response import DispersedWaveResponse
from vibcli.results.modal_response import ModalResponse
from vibcli.results.modal_signals import ModalSignal
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


def test_what_is_not_followed_goes_by_modes(monkeypatch):
    monkeypatch.setattr(ModalResponse, "limit", 0)
    moving = problem(BAR.replace("F: 1 N", "V: 1 m/s").replace("REST", "drag: 0.2 N*s/m^2") + "initial: {rod.u': V}\n")
    ramp = problem(BAR.replace("REST", "drag: 0.2 N*s/m^2") + STEP.replace("step(t)", "sin(t/(1 s))"))
    bent = problem(BAR.replace("REST", "foundation: 2 N/m^2") + STEP.replace("*step(t)", "")
                   + "initial: {released: pull}\n")
    assert isinstance(signal(bent, "rod.u(L/2)").read_at(0.3), ModalSignal)
    assert isinstance(signal(moving, "rod.u(L)").read_at(0.3), ModalSignal)
    assert isinstance(ramp.response._waves, DispersedWaveResponse)
    assert isinstance(signal(ramp, "rod.u'(L)").read_at(0.3), ModalSignal)
    assert isinstance(signal(ramp, "rod.u(L)").read_at(1e6), ModalSignal)
