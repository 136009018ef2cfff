"""Loads along members that set in at the start and last, by travelling waves: against the waves of a rod that feels its
weight at once, and against modes within their bounds."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.results.modal_response import ModalResponse
from vibcli.results.wave_response import WaveResponse
from vibcli.symbolic.parser import parse

G, LENGTH, SPEED = 9.81, 3.0, 5000.0
ROD = """
    parameters: {L: 3 m, EA: 50 MN, mu: 2 kg/m, g: 9.81 m/s^2}
    bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped}}
    forces: {weight: {body: rod, per_length: mu*g*step(t)}}
    """
SCENES = {
    "a sine on a part of a bar with a mass and a spring": ("""
        parameters: {L: 2 m, EA: 3 MN, mu: 4 kg/m, q: 50 N/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {k: 200 kN/m},
                     attached: [{at: 1.3 m, mass: 2 kg}]}}
        forces: {w: {body: rod, per_length: q*sin(pi*x/L)*step(t), from: 0.3 m, to: 1.7 m}}
        """, 0.02, ("rod.u(0.9 m)", "rod.force(0.2 m)", "rod.force(1.5 m)")),
    "a string that starts with a field": ("""
        parameters: {L: 1 m, T: 100 N, mu: 0.02 kg/m, q: 5 N/m}
        strings: {cord: {length: L, preload: T, mass_per_length: mu, left: clamped, right: clamped}}
        forces: {w: {body: cord, per_length: q*x^2/L^2*step(t)}}
        initial: {cord.u: 1e-3*x*(L - x)/L}
        """, 0.03, ("cord.u(0.37 m)", "cord.slope(0.71 m)")),
    "a free bar": ("""
        parameters: {L: 1 m, EA: 1e5 N, mu: 2 kg/m, q: 5 N/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu}}
        forces: {w: {body: rod, per_length: q*step(t), to: L/2}}
        """, 0.02, ("rod.u(0.37 m)", "rod.force(0.71 m)")),
    "two bars and a body": ("""
        parameters: {L: 1 m, EA: 1e5 N, mu: 2 kg/m, q: 5 N/m}
        bars:
          rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {pinned: b}}
          bar: {length: L, EA: 2*EA, mass_per_length: mu, left: {pinned: b}}
        bodies: {b: {mass: 1 kg, slide: z}}
        forces: {w: {body: bar, per_length: q*(1 + x/L)*step(t)}, v: {body: rod, per_length: -2*q*step(t)}}
        """, 0.02, ("rod.u(0.37 m)", "rod.force(0.71 m)", "bar.u(0.5 m)", "bar.force(0.5 m)", "z")),
}


def values(response, signal, times):
    return np.array(response.signal(parse(signal)).values(times))


def test_a_rod_feels_its_weight():
    """u(x) = f(t) − f(t − x/c) with f = g t²/2 up to the first echo; beyond it from the static shape by images."""
    times = np.linspace(0.0, 3.9, 40) * LENGTH / SPEED
    response = problem(ROD).response
    assert isinstance(response, WaveResponse)
    for x in (0.4, 1.1, 2.9):
        u = shown(x) - (shown(x - SPEED * times) + shown(x + SPEED * times)) / 2
        np.testing.assert_allclose(values(response, f"rod.u({x} m)", times), u, rtol=0, atol=1e-14 * abs(u).max())
        force = 50e6 * (slope(x) - (slope(x - SPEED * times) + slope(x + SPEED * times)) / 2)
        np.testing.assert_allclose(values(response, f"rod.force({x} m)", times)[1:-1], force[1:-1], rtol=0,
                                   atol=1e-13 * 2 * G * LENGTH * 2)


def shown(x):
    """The shape in which the rod rests under its weight, odd about its clamp and even about its free end."""
    sign, y = image(x)
    return sign * G / SPEED**2 * (LENGTH * y - y * y / 2)


def slope(x):
    """Its derivative."""
    x = np.asarray(x, float)
    period = np.mod(x + LENGTH, 4 * LENGTH)
    _, y = image(x)
    return np.where(period < 2 * LENGTH, 1, -1) * G / SPEED**2 * (LENGTH - y)


def image(x):
    """(sign, place on the rod) that a place beyond its ends mirrors."""
    x = np.mod(np.asarray(x, float), 4 * LENGTH)
    sign, x = np.where(x < 2 * LENGTH, 1, -1), np.mod(x, 2 * LENGTH)
    return sign, np.minimum(x, 2 * LENGTH - x)


@pytest.mark.sweep
@pytest.mark.parametrize("text, until, signals", SCENES.values(), ids=SCENES)
def test_modes_agree_within_their_bounds(text, until, signals):
    one, times = problem(text), np.linspace(until / 40, until, 13)
    modes = ModalResponse(one)
    assert isinstance(one.response, WaveResponse)
    for signal in signals:
        found, other = values(one.response, signal, times), modes.signal(parse(signal))
        bounds = np.array([other.error(t) for t in times])
        assert abs(found).max() > 0 and (abs(found - other.values(times)) <= bounds).all()


@pytest.mark.parametrize("weight", ["cos(200 rad/s*t)", "step(t - 1 ms)", "ramp(t)/(1 s)"])
def test_what_varies_later_goes_by_modes(weight):
    assert isinstance(problem(ROD.replace("step(t)", weight)).response, ModalResponse)
