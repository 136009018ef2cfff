"""Motions in time of members with dampers by damped modes: against waves, modes by themselves, Laplace's integral."""

from math import factorial

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

from vibcli.analyses.continuous import damped_series
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.results import damped_modal_response
from vibcli.results.damped_modal_response import DampedModalResponse
from vibcli.results.modal_response import ModalResponse
from vibcli.results.wave_response import WaveResponse
from vibcli.symbolic.parser import parse

TIMES = np.array([0.03, 0.37, 1.93, 4.1])
BEAM = "parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}\nbeams:\n  arm: {length: L, EI: EI, mass_per_length: mu, %s}\n"
TIP = BEAM % "left: clamped, right: {c: 0.7 N*s/m}" + "points: {tip: {body: arm, at: L}}\n"
pytestmark = pytest.mark.usefixtures("modes_found_once")


def signal(response, scene, text):
    return response(scene).signal(with_places(parse(text), scene.spec.members))


def compared(text, name, other, near):
    scene = problem(text)
    expected, found = signal(other, scene, name).values(TIMES), signal(DampedModalResponse, scene, name)
    off, size = np.abs(found.values(TIMES) - expected), np.abs(expected).max()
    assert off.max() <= near * size
    assert (off <= [found.error(t) + 1e-13 * size for t in TIMES]).all()


BARS = {"damped at its end": """\
    parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
    bars: {rod: {length: L, E: E, A: A, rho: rho, left: clamped, right: {c: 0.5 N*s/m}}}
    points: {mid: {body: rod, at: 0.4*L}}
    forces: {push: {at: mid, force: 1 N*(t/(1 s))^2*exp(-t/(0.5 s))}}
    initial: {rod.u': 0.2 m/s*x/L}
    """, "free": """\
    parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
    bars: {rod: {length: L, E: E, A: A, rho: rho, attached: [{at: 0, mass: 0.5 kg}, {at: L, c: 2.5 N*s/m}]}}
    points: {mid: {body: rod, at: 0.4*L}}
    forces: {push: {at: mid, force: 1 N*sin(3 rad/s*t)}}
    initial: {rod.u': 0.2 m/s*x/L}
    """}


@pytest.mark.sweep
@pytest.mark.parametrize("kind", BARS)
def test_damped_modes_agree_with_waves(kind, monkeypatch):
    monkeypatch.setattr(damped_modal_response, "MANY", 300)
    compared(BARS[kind], "rod.u(0.2*L)", WaveResponse, 3e-5)


@pytest.mark.sweep
def test_a_string_on_a_shaken_hand_agrees_with_waves(monkeypatch):
    monkeypatch.setattr(damped_modal_response, "MANY", 300)
    compared("""\
        parameters: {L: 3 m, N: 90 N, mu: 0.1 kg/m}
        bodies: {hand: {slide: 2 cm*sin(4 rad/s*t)}}
        strings: {cord: {length: L, preload: N, mass_per_length: mu, left: {clamped: hand}, right: {c: 1 N*s/m}}}
        """, "cord.u(L/3)", WaveResponse, 1e-5)


@pytest.mark.sweep
def test_drag_that_damps_each_mode_by_itself():
    compared(BEAM % "drag: 3 N*s/m^2, left: pinned, right: pinned" + "initial: {arm.u: 2 mm*sin(pi*x/L)^3}\n",
             "arm.u(0.3*L)", ModalResponse, 1e-12)


def transfer(s, c):
    """u/F at the end of a cantilever with a damper there."""
    b = (-s * s + 0j)**0.25
    ch, sh, co, si = np.cosh(b), np.sinh(b), np.cos(b), np.sin(b)
    own = (si * ch - co * sh) / (b**3 * (1 + co * ch))
    return own / (1 + c * s * own)


@pytest.mark.sweep
def test_a_smooth_push_at_a_damper_by_the_integral_of_bromwich():
    found = signal(DampedModalResponse, problem(TIP + "forces: {pull: {at: tip, force: 1 N*(t/(1 s))^6*exp(-4*t/(1 s))}"
                                                      "}\n"), "arm.u(L)")
    step = np.pi / 16
    s = 6.0 + 1j * np.arange(-3000.0, 3000.0, step)
    image = transfer(s, 0.7) * factorial(6) / (s + 4)**7
    expected = [np.real(image @ np.exp(s * t)) * step / (2 * np.pi) for t in TIMES[:3]]
    assert np.abs(found.values(TIMES[:3]) - expected).max() <= 1e-12 * max(expected)
    assert max(found.error(t) for t in TIMES) <= 1e-11 * max(expected)
    _bears_no_moment(found)


CRITICAL = 1.6572548969298002       # N s/m at which λ = −3.7325751437 is double: 1/transfer and its slope are 0 there


@pytest.mark.sweep
@pytest.mark.parametrize("aside", [0.0, 1e-12, *(pytest.param(a, marks=pytest.mark.sweep)
                                               for a in (-1e-12, 1e-8, -1e-6, 1e-4, -1e-4, 1e-3, -1e-3, 3e-3))])
def test_at_and_beside_critical_damping(aside):
    """Against the integral of Bromwich; at 12 s, of residues, where the load is e^{−10t}, less than the circle about
    both λ brings before it has died out."""
    c = CRITICAL * (1 + aside)
    found = signal(DampedModalResponse, problem(TIP.replace("0.7", f"{c!r}") + "forces: {pull: {at: tip, force: 1 N*"
                                                "(t/(1 s))^6*exp(-10*t/(1 s))}}\n"), "arm.u(L)")
    step = np.pi / 16
    s = 6.0 + 1j * np.arange(-3000.0, 3000.0, step)
    image = transfer(s, c) * factorial(6) / (s + 10)**7
    expected = np.array([np.real(image @ np.exp(s * t)) * step / (2 * np.pi) for t in TIMES[:3]])
    off = np.abs(found.values(TIMES[:3]) - expected)
    assert (off <= [found.error(t) + 1e-15 * max(expected) * np.exp(6 * t) for t in TIMES[:3]]).all()
    assert max(found.error(t) for t in TIMES) <= 1e-6 * max(expected)
    if aside == 0:
        assert abs(found.values(np.array([12.0]))[0] - 3.68714665e-21) <= 1e-29


PAIR = """\
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams:
  a: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {c: %r N*s/m}}
  b: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {c: %r N*s/m}}
points: {one: {body: a, at: L}, two: {body: b, at: L}}
springs: {tie: {between: [one, two], k: %r N/m}}
forces: {pull: {at: one, force: 1 N*(t/(1 s))^6*exp(-10*t/(1 s))}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("k", [1e-15, 1e-12, 1e-11, 1e-10, 1e-9, 1e-7, 1e-5, 1e-4])
@pytest.mark.parametrize("name, sign", [("a.u(L)", 1), ("b.u(L)", -1)])
def test_two_critically_damped_members_that_are_tied_weakly(k, name, sign, monkeypatch):
    """Both ends together bear half the load beside no spring, against each other beside 2 k."""
    monkeypatch.setattr(damped_modal_response, "MANY", 60)
    found = signal(DampedModalResponse, problem(PAIR % (CRITICAL, CRITICAL, k)), name)
    step = np.pi / 16
    s = 6.0 + 1j * np.arange(-3000.0, 3000.0, step)
    load = factorial(6) / (s + 10)**7 / 2
    own = transfer(s, CRITICAL)
    apart = own / (1 + 2 * k * own)
    expected = np.array([np.real((own + sign * apart) * load @ np.exp(s * t)) * step / (2 * np.pi) for t in TIMES[:3]])
    off, bounds = np.abs(found.values(TIMES[:3]) - expected), np.array([found.error(t) for t in TIMES[:3]])
    size = np.abs(np.real(own * load @ np.exp(s * TIMES[1]))) * step / np.pi
    assert (off <= bounds + 1e-12 * size).all() and not found.is_estimated
    assert bounds.max() <= 1e-4 * size


@pytest.mark.sweep
@pytest.mark.parametrize("c", ["0.05", "2"])
def test_what_rounds_at_a_free_end_is_within_what_modes_lose(c):
    text = TIP.replace("0.7", c) + "forces: {pull: {at: tip, force: 1 N*exp(-t/(1 s))}}\n"
    modes = signal(DampedModalResponse, problem(text), "arm.u(L)").modal.modes
    end = LinearOutput(places={FieldPoint(0, 1.0, 2): 1.0})
    assert (2 * np.abs(modes.rows(end)[0][0]) <= modes.lost_rows(end)[0]).all()


def test_loads_beside_modes_that_creep_as_slowly():
    """By Bromwich's integral: the series of their derivatives over powers of the first ω that is left out, and of 2ζ/ω,
    left what floats hold, and the refusal asked for a load that rises within a time."""
    text = BEAM % "left: clamped" + "damping: {proportional: [3.7 s^-1, 0.05 s]}\npoints: {tip: {body: arm, at: L}}\n"
    load = "forces: {pull: {at: tip, force: 1 N*(t/(1 s))^4*exp(-5*t/(1 s))}}\n"
    found = signal(ModalResponse, problem(text + load), "arm.u(L)")
    step = np.pi / 16
    s = 1.0 + 1j * np.arange(-800.0, 800.0, step)
    slope = 1 + 0.05 * s
    image = transfer(np.sqrt((s * s + 3.7 * s) / slope), 0.0) / slope * factorial(4) / (s + 5)**5
    for t in (0.8, 2.5):
        expected = np.real(image @ np.exp(s * t)) * step / (2 * np.pi)
        assert found.values(np.array([t]))[0] == pytest.approx(expected, rel=1e-9)
        assert found.error(t) <= 1e-10 * expected


def _bears_no_moment(found):
    """The end: in modes but for what their λ round, times how often waves turn along the beam."""
    end = found.asked[0].signal(with_places(parse("arm.moment(L)"), ["arm"]))
    assert not end.values(TIMES).any() and not max(end.error(t) for t in TIMES)
    modes = found.modal.modes
    for x, is_end in ((1.0, True), (0.95, False)):
        output = LinearOutput(places={FieldPoint(0, x, 2): 1.0})
        assert ((np.abs(modes.rows(output)[0][0]) <= modes.lost_rows(output)[0]) == is_end).all()


@pytest.mark.sweep
def test_a_cantilever_let_go_at_its_damper():
    """u at rest is F/3 less what a step brings; its mean with a smooth weight by the same integral."""
    found = signal(DampedModalResponse, problem(TIP + "forces: {pull: {at: tip, force: 1 N}}\n"
                                                      "initial: {released: pull}\n"), "arm.u(L)")
    assert abs(found.values(np.array([0.0]))[0] - 1 / 3) <= found.error(0.0) <= 1e-10
    s = 2.0 + 1j * np.arange(-300.0, 300.0, np.pi / 12)
    t, fine = (np.linspace(0.0, 2.0, n + 1) for n in (4000, 20_000))
    felt = np.exp(np.outer(s, t)) @ (t * (2 - t))**6 / 2000
    expected = np.real(((1 / 3 - transfer(s, 0.7)) / s) @ felt) / 24
    assert found.values(fine) @ (fine * (2 - fine))**6 / 10_000 == pytest.approx(expected, abs=1e-11)
    time, lowest = found.extreme(0.0, 3.0, -1)
    assert lowest == pytest.approx(found.values(np.linspace(time - 1e-3, time + 1e-3, 1001)).min(), abs=1e-12)


@pytest.mark.sweep
def test_two_members_alike_have_each_damped_mode_twice(monkeypatch):
    monkeypatch.setattr(damped_modal_response, "MANY", 300)
    leg = BEAM.replace("arm", "leg").split("beams:\n")[1] % "left: clamped, right: {c: 0.7 N*s/m}"
    start = "initial: {arm.u: 1 mm*(x/L)^2}\n"
    one = signal(DampedModalResponse, problem(TIP + start), "arm.u(L)")
    two = problem(TIP.replace("points", leg + "points") + start)
    for name, expected in (("arm.u(L)", one.values(TIMES)), ("leg.u(L)", 0.0)):
        found = signal(DampedModalResponse, two, name)
        off = np.abs(found.values(TIMES) - expected)
        assert off.max() <= 1e-9 and (off <= [found.error(t) + one.error(t) for t in TIMES]).all()


def test_what_lets_no_wave_come_back_is_told():
    scene = problem("""\
        parameters: {L: 1 m, N: 4 N, mu: 1 kg/m}
        strings: {cord: {length: L, preload: N, mass_per_length: mu, drag: 0.1 N*s/m^2, left: clamped,
                         right: {c: 2 N*s/m}}}
        initial: {cord.u: 1 mm*sin(pi*x/L/2)}
        """)
    with pytest.raises(PhysicsError, match="no wave comes back"):
        signal(lambda one: one.response, scene, "cord.u(L)").values(TIMES)


@pytest.mark.sweep
def test_modes_that_are_not_found_leave_those_found_as_they_are(monkeypatch):
    """Of a bar with a damper at its end λ = (−½ ln((1 + r)/(1 − r)) ± i (n − ½) π) c₀/L."""
    found = damped_series.damped_series

    def no_more_than_64(known, count):
        if count > 64:
            raise PhysicsError("too many", "ask for fewer")
        return found(known, count)

    monkeypatch.setattr(damped_series, "damped_series", no_more_than_64)
    scene = problem(BARS["damped at its end"])
    rates = DampedModalResponse(scene).alone.modes.basis.rates
    assert len(rates) == 64
    assert rates[-1] == pytest.approx(complex(-np.log(3) / 2, 63.5 * np.pi))
