"""Heavy beams that start in the shape in which they rest, or a known field away from it."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

HEAVY = """
parameters: {L: 2 m, EI: 1 kN*m^2, mu: 3 kg/m, a: {value: 0.02 m^-1, unused: allowed}, g: %s m/s^2}
gravity: g
beams: {b: {from: [0, 0], to: [L, 0], EI: EI, mass_per_length: mu, %s}}
initial: {b.u: %s}
"""
CANTILEVER = "left: clamped", "-mu*g*(x^4 - 4*L*x^3 + 6*L^2*x^2)/(24*EI)", "a*x^2"
CLAMPED = "left: clamped, right: clamped", "-mu*g*x^2*(L - x)^2/(24*EI)", "a*x^2*(L - x)^2/L^2"
PINNED = "left: pinned, right: pinned", "-mu*g*x*(x^3 - 2*L*x^2 + L^3)/(24*EI)", "a*x*(x^3 - 2*L*x^2 + L^3)/L^2"
BEAMS = pytest.mark.parametrize(("ends", "rest", "moved"), [CANTILEVER, CLAMPED, PINNED])
TIMES = np.array([0.0, 0.003, 0.11, 0.7])


def values(ends, start, signal, gravity="9.81"):
    scene = problem(HEAVY % (gravity, ends, start))
    found = scene.response.signal(with_places(parse(signal), scene.spec.members))
    return found.values(TIMES)


def at(x, field, g=9.81):
    return eval(field.replace("^", "**"), {"x": x, "L": 2.0, "mu": 3.0, "g": g, "EI": 1e3, "a": 0.02})


@BEAMS
def test_what_starts_as_it_rests_stays(ends, rest, moved):
    assert values(ends, rest, "b.u(1.1 m)") == pytest.approx(at(1.1, rest), rel=1e-12)
    assert values(ends, rest, "b.u'(1.1 m)") == pytest.approx(0.0, abs=1e-12)


@pytest.mark.sweep
@BEAMS
def test_it_moves_about_its_rest_as_a_beam_without_weight(ends, rest, moved):
    heavy = values(ends, f"{rest} + {moved}", "b.u(1.1 m)")
    light = values(ends, moved, "b.u(1.1 m)", "0")
    assert heavy[0] == pytest.approx(at(1.1, rest) + at(1.1, moved), rel=1e-9)
    assert np.ptp(light) > 0.005
    assert heavy - at(1.1, rest) == pytest.approx(light, abs=2e-10 * abs(light).max())
