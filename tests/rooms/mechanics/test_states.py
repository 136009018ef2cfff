"""Energies and inertia along a motion, by their own expressions and by the signals of the elements."""

import pytest
from support.scenes import problem, value

OSCILLATOR = """
    parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m, x0: 2 cm}
    bodies: {b: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, b]}}
    dampers: {d: {c: c, between: [ground, b]}}
    initial: {x: x0}
    find: [{response: {until: 1 s}}]
"""
PENDULUM = """
    parameters: {M: 3 kg, m: 2 kg, L: 1 m, g: 9.81 m/s^2}
    gravity: g
    bodies:
      cart: {mass: M, at: [0, 0], slide: x}
      bob:  {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
    initial: {x: 0, phi: 1 rad}
    motion: full
    find: [{response: {until: 1 s}}]
"""


@pytest.mark.parametrize("motion", ["small", "full"])
def test_energies_of_a_damped_oscillator(motion):
    found = problem(OSCILLATOR + f"    motion: {motion}\n")
    assert value(found, "V(0 s)") == pytest.approx(800 * 0.02**2 / 2, rel=1e-14)
    assert value(found, "T(0 s)") == pytest.approx(0, abs=1e-15)
    for t in ("0.1 s", "0.37 s"):
        assert value(found, f"(T - m*x'^2/2)({t})") == pytest.approx(0, abs=1e-14)
        assert value(found, f"(V - s.energy)({t})") == pytest.approx(0, abs=1e-14)
        assert value(found, f"(2*Phi - d.power)({t})") == pytest.approx(0, abs=1e-13)
    assert value(found, "max(T)") < value(found, "max(V)")


def test_inertia_and_energy_of_a_wide_swing():
    from math import cos

    found = problem(PENDULUM)
    assert value(found, "M[x,phi](0 s)") == pytest.approx(2 * cos(1), rel=1e-14)
    assert value(found, "M[x,phi]") == pytest.approx(2, rel=1e-14)
    total = value(found, "V(0 s)")
    assert total == pytest.approx(2 * 9.81 * (1 - cos(1)), rel=1e-14)
    assert value(found, "(T + V)(0.8 s)") == pytest.approx(total, rel=1e-12)
