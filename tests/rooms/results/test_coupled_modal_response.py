"""Motions in time of members with `damping:` beside dampers: against Laplace's integral in mpmath (Talbot)."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.results.coupled_modal_response import CoupledModalResponse
from vibcli.results.members_in_time import members_in_time
from vibcli.symbolic.parser import parse

BAR = """\
    parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
    bars: {rod: {length: L, E: E, A: A, rho: rho, left: LEFT, right: {c: 0.5 N*s/m}}}
    points: {mid: {body: rod, at: 0.4*L}}
    forces: {push: {at: mid, force: 1 N*(t/(1 s))^2*exp(-t/(0.5 s))}}
    initial: {rod.u': 0.2 m/s*x/L}
    damping: {proportional: [0 s^-1, 0.01 s]}
    """
ARM = """\
    parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m, k: 1000 N/m, M: 2 kg, c: 20 N*s/m}
    beams:
      arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {c: c}, attached: [{at: L, k: k, mass: M}]}
    points: {tip: {body: arm, at: L}}
    forces: {f: {at: tip, force: 10 N}}
    damping: {proportional: [3 s^-1, 0.0005 s]}
    """


def inverse(F, t, n):
    """f(t) by Talbot's contour of n places, which lies about all poles."""
    with mpmath.workdps(int(0.6 * n) + 20):
        r = mpmath.mpf(2 * n) / (5 * mpmath.mpf(t))
        total = mpmath.exp(r * t) * F(r) / 2
        for j in range(1, n):
            theta = j * mpmath.pi / n
            cot = mpmath.cot(theta)
            s = r * theta * (cot + 1j)
            total += (mpmath.exp(s * t) * F(s) * (1 + 1j * (theta + (theta * cot - 1) * cot))).real
        return float(mpmath.re(r / n * total))


def bar(s, x, held):
    """u of BAR: u = A cosh κx + B sinh κx + (1 s⁻¹) x/(5 s²), bent at the load, (1 + βs) u′ = −c s u at its end."""
    E = 1 + s / 100
    k, slope, load = s / mpmath.sqrt(E), 1 / (5 * s * s), 2 / (s + 2)**3
    D, rest = -load / (E * k), mpmath.mpf(3) / 5
    ch, sh = mpmath.cosh(k), mpmath.sinh(k)
    known = E * (slope + k * D * mpmath.cosh(k * rest)) + s / 2 * (slope + D * mpmath.sinh(k * rest))
    if held:
        A, B = 0, -known / (E * k * ch + s / 2 * sh)
    else:
        B = -slope / k
        A = -(known + B * (E * k * ch + s / 2 * sh)) / (E * k * sh + s / 2 * ch)
    u = slope * x + A * mpmath.cosh(k * x) + B * mpmath.sinh(k * x)
    return u + D * mpmath.sinh(k * (x - 1 + rest)) * (x > 1 - rest)


def arm(s, drag=0):
    """(u at the end, moment at the clamp) of ARM for a unit load, with a drag per length."""
    E, inertia = 2400 * (1 + s / 2000), s * s + 3 * s
    b = mpmath.root(-(3 * inertia + drag * s) / E, 4)
    x = b * mpmath.mpf("1.2")
    ch, sh, co, si = mpmath.cosh(x), mpmath.sinh(x), mpmath.cos(x), mpmath.sin(x)
    z = 1000 * (1 + s / 2000) + 2 * inertia + 20 * s
    one, two = E * b**3 * (sh - si) - z * (ch - co), E * b**3 * (ch + co) - z * (sh - si)
    det = (ch + co) * two - (sh + si) * one
    A, B = (sh + si) / det, -(ch + co) / det
    return A * (ch - co) + B * (sh - si), 4800 * b * b * A


def signal(text, name):
    scene = problem(text)
    response = members_in_time(scene)
    assert isinstance(response, CoupledModalResponse)
    return response.signal(with_places(parse(name), scene.spec.members))


@pytest.mark.sweep
@pytest.mark.parametrize("held", [True, False])
def test_a_bar_whose_modes_without_end_creep(held):
    found = signal(BAR.replace("LEFT", "clamped" if held else "free"), "rod.u(0.2*L)")
    for t, places in ((0.1, 120), (0.37, 160)):
        expected = inverse(lambda s: bar(s, mpmath.mpf(1) / 5, held), t, places)
        value, error = found.values(np.array([t]))[0], found.error(t)
        assert abs(value - expected) <= error < 5e-8


@pytest.mark.sweep
@pytest.mark.parametrize("drag", [0, 6, 90])
@pytest.mark.parametrize("name", ["arm.u(L)", "arm.moment(0 m)"])
def test_a_cantilever_with_a_mass_a_spring_and_a_damper_at_its_end(name, drag):
    scene = ARM.replace("10 N", "10 N*step(t)").replace("EI: EI", f"EI: EI, drag: {drag} Pa*s")
    found, moment = signal(scene, name), name != "arm.u(L)"
    size = 13.0 if moment else 2.6e-3
    for t, places in ((0.02, 120), (0.1, 200)):
        expected = inverse(lambda s: 10 * arm(s, drag)[moment] / s, t, places)
        value, error = found.values(np.array([t]))[0], found.error(t)
        assert abs(value - expected) <= error + 1e-13 * size
        assert error <= 1e-8 * size


@pytest.mark.sweep
def test_drag_in_proportion_to_mass_is_what_damping_gives():
    """Also where nothing but members has mass, and no damper stands beside them."""
    cord = ("strings: {cord: {length: 2 m, preload: 200 N, mass_per_length: 0.5 kg/m, left: clamped, right: clamped"
            "%s}}\ndamping: {proportional: [%s s^-1, 2 ms]}\ninitial: {cord.u: 1 cm*sin(pi*x/(2 m))}\n")
    times = np.array([0.0, 0.01, 0.3])
    dragged = signal(cord % (", drag: 0.4 N*s/m^2", 1), "cord.u(0.7 m)")
    given = members_in_time(problem(cord % ("", 1.8))).signal(with_places(parse("cord.u(0.7 m)"), ("cord",)))
    assert dragged.values(times) == pytest.approx(given.values(times), rel=1e-12)
    exact = 0.01 * np.sin(0.35 * np.pi) * _decayed(np.pi / 2 * 20, 1.8, 0.002, times)
    assert dragged.values(times) == pytest.approx(exact, rel=1e-12)


def _decayed(omega, alpha, beta, t):
    """One mode that is let go."""
    decay = (alpha + beta * omega**2) / 2
    turn = np.sqrt(omega**2 - decay**2)
    return np.exp(-decay * t) * (np.cos(turn * t) + decay / turn * np.sin(turn * t))


@pytest.mark.sweep
def test_a_cantilever_let_go_is_at_rest_less_what_a_step_brings():
    let_go, pushed = (signal(text, "arm.u(L)") for text in (
        ARM.rstrip(" ") + "    initial: {released: f}\n", ARM.replace("10 N", "10 N*step(t)")))
    times = np.array([0.0, 0.003, 0.02, 0.1, 0.5])
    rest = 10 / (1000 + 3 * 2400 / 1.2**3)
    assert np.abs(let_go.values(times) + pushed.values(times) - rest).max() <= 1e-10 * rest
