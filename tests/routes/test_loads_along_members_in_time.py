"""Motions under loads along members beside the sums of closed-form modes."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

TIMES = np.array([0.0, 0.007, 0.03, 0.055, 0.2])


def values(text, signal, times=TIMES):
    scene = problem(text)
    found = scene.response.signal(with_places(parse(signal), scene.spec.members))
    return found.values(times)


@pytest.mark.sweep
def test_a_gust_on_a_part_of_a_beam():
    """q (1 − x/L) on L/4 … L, from 0 to 40 ms."""
    text = """
        parameters: {L: 2 m, EI: 2400 N*m^2, mu: 3 kg/m, q: 7 N/m}
        beams: {wing: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned}}
        forces: {gust: {body: wing, per_length: q*(1 - x/L)*(step(t) - step(t - 0.04 s)), from: L/4}}
    """

    exact, after = 0.0, np.maximum(TIMES - 0.04, 0)
    for b in np.arange(1, 400) * np.pi / 2:
        omega, share = np.sqrt(800) * b**2, 7 * (0.75 * np.cos(0.5 * b) / b + np.sin(0.5 * b) / (2 * b**2))
        exact = exact + share / 3 * np.sin(0.7 * b) * (np.cos(omega * after) - np.cos(omega * TIMES)) / omega**2
    found = values(text, "wing.u(0.7 m)")
    assert np.abs(found - exact).max() <= 1e-9 * np.abs(exact).max()


@pytest.mark.sweep
@pytest.mark.parametrize("damped", ["damping: {modal: 3 %}", "damping: {proportional: [0.5 s^-1, 2e-5 s]}", ""])
def test_a_sine_that_travels_over_a_beam(damped):
    """q sin(πx/L − Ωt) on pins, beside the same by two loads that stand."""
    text = """
        parameters: {{L: 2 m, EI: 2400 N*m^2, mu: 3 kg/m, q: 7 N/m, W: 40 rad/s}}
        beams: {{wing: {{length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned}}}}
        forces: {{{}}}
        {}
    """
    one = values(text.format("a: {body: wing, per_length: q*sin(pi*x/L - W*t)}", damped), "wing.u(L/2)")
    two = values(text.format("a: {body: wing, per_length: q*sin(pi*x/L)*cos(W*t)}, "
                             "b: {body: wing, per_length: -q*cos(pi*x/L)*sin(W*t)}", damped), "wing.u(L/2)")
    assert one == pytest.approx(two, abs=1e-13 * np.abs(two).max())
    if not damped:
        omega = (np.pi / 2)**2 * np.sqrt(800)
        exact = 7 / 3 * (np.cos(40 * TIMES) - np.cos(omega * TIMES)) / (omega**2 - 1600)
        alone = values(text.format("a: {body: wing, per_length: q*sin(pi*x/L)*cos(W*t)}", ""), "wing.u(L/2)")
        assert alone == pytest.approx(exact, abs=1e-11 * np.abs(exact).max())
