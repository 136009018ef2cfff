"""Loads along light members that vary in time: the motion is that of the force which does the same work."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

SCENE = """\
parameters: {{L: 2 m, EI: 1 kN*m^2, M: 4 kg, q0: 30 N/m, W: 5 rad/s}}
beams: {{wing: {{length: L, EI: EI, left: clamped, attached: [{{at: L, mass: M}}]}}}}
forces: {{wind: {{body: wing, per_length: {load}}}}}
"""
LOADS = {
    "q0*sin(pi*x/L)*cos(W*t)": lambda x: 30 * mpmath.sin(mpmath.pi * x / 2),
    "q0*(1 - (x/L)^2)*cos(W*t), from: L/4, to: L/2": lambda x: 30 * (1 - x**2 / 4) if 0.5 <= x <= 1 else 0,
    "q0*cos(W*t)": lambda x: 30,
    "q0*(exp(-x/L)*cos(W*t) + x/L*cos(W*t))": lambda x: 30 * (mpmath.exp(-x / 2) + x / 2),
}


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


@pytest.mark.parametrize("load", LOADS)
def test_the_end_moves_as_by_the_force_of_the_same_work(load):
    """M ü + 3EI/L³ u = ∫ q N dx, N the deflection by a force at the end, 1 there."""
    moved = mpmath.quad(lambda x: LOADS[load](x) * (6 * x**2 - x**3) / 16, [0, 0.5, 1, 2])
    k, times = 3 * 1000 / 8, np.array([0.0, 0.2, 1.3, 4.0])
    u = float(moved) / (k - 4 * 25) * (np.cos(5 * times) - np.cos(np.sqrt(k / 4) * times))
    found = signal(problem(SCENE.format(load=load)), "wing.u(L)").values(times)
    assert np.abs(found - u).max() <= 1e-12 * np.abs(u).max()


def test_what_it_leaves_between_stations_is_refused():
    """A moment holds what the load itself bends; at rest there is none."""
    scene = problem(SCENE.format(load="q0*sin(pi*x/L)*cos(W*t)"))
    with pytest.raises(PhysicsError, match="where 'wind' varies in time is not found"):
        signal(scene, "wing.moment(0 m)").values(np.array([1.0]))
