"""Members that start with a field beside a steady load that is uneven along them: against waves by d'Alembert and sums
over the modes of a cantilever by quadrature."""

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse

SCENE = """\
    parameters: {L: 1 m, stiff: 100 %s, mu: 1 kg/m, q: 50 N/m, a: 0.01 m}
    %s: {m: {length: L, %s: stiff, mass_per_length: mu, left: clamped%s}}
    forces: {load: {body: m, per_length: %s}}
    initial: {m.u: a*%s}
    """


def compared(scene, text, times, expected, near):
    found = scene.response.signal(with_places(parse(text), scene.spec.members))
    off, size = np.abs(found.values(np.array(times)) - expected), np.abs(expected).max()
    assert off.max() <= near * size
    assert (off <= [found.error(t) + 1e-15 * size for t in times]).all()


def test_a_bar_stretched_beside_a_load_that_swells():
    """u − u_r runs to and fro with 10 m/s, odd about the clamp and even about the end; u_r = q/(π² EA) sin πx + q x/(π
    EA)."""
    scene = problem(SCENE % ("N", "bars", "EA", "", "q*sin(pi*x/L)", "x/L"))

    def rest(x):
        return 0.5 * (np.sin(np.pi * x) / np.pi**2 + x / np.pi)

    def away(x):
        x = (x + 1) % 4 - 1
        x, sign = np.where(x > 1, 2 - x, x), 1.0
        return sign * (0.01 * x - np.sign(x) * rest(np.abs(x)))

    def slope(x):
        x = np.abs((x + 1) % 4 - 1)
        sign = np.where(x > 1, -1.0, 1.0)
        x = np.where(x > 1, 2 - x, x)
        return sign * (0.01 - 0.5 * (np.cos(np.pi * x) / np.pi + 1 / np.pi))

    times = np.array([0.0, 0.013, 0.12, 0.237, 0.71])
    compared(scene, "m.u(0.3 m)", times, rest(0.3) + (away(0.3 - 10 * times) + away(0.3 + 10 * times)) / 2, 1e-13)
    strain = 0.5 * (np.cos(0.3 * np.pi) + 1) / np.pi + (slope(0.3 - 10 * times) + slope(0.3 + 10 * times)) / 2
    compared(scene, "m.force(0.3 m)", times, 100 * strain, 1e-12)


@pytest.mark.sweep
def test_a_cantilever_bent_beside_a_load_that_swells():
    """u = u_r + Σ φ ⟨φ, u₀ − u_r⟩ cos ωt, ⟨φ, u_r⟩ = ∫ φ q dx/(μ ω²)."""
    scene = problem(SCENE % ("N*m^2", "beams", "EI", "", "q*sin(pi*x/L)", "(x/L)^2*(6 - 4*x/L + (x/L)^2)/3"))
    at, weights = np.polynomial.legendre.leggauss(500)
    x, weights = (at + 1) / 2, weights / 2
    load, start, times = 50 * np.sin(np.pi * x), 0.01 * x**2 * (6 - 4 * x + x**2) / 3, np.array([0.0, 0.01, 0.1, 0.37])
    found = weights @ (load * x**2 * (3 - x)) / 600      # at rest
    for k in range(120):
        b = brentq(lambda b: np.cos(b) + 1 / np.cosh(b), (k + 0.3) * np.pi, (k + 0.7) * np.pi, xtol=1e-15)
        # of unit ∫ φ²: cosh − cos − s (sinh − sin), without what cancels
        s = (np.sinh(b) - np.sin(b)) / (np.cosh(b) + np.cos(b))
        top = (np.exp(-b) + np.cos(b) + np.sin(b)) / (1 + np.exp(-2 * b) + 2 * np.exp(-b) * np.cos(b))
        grown = top * np.exp(b * (x - 1))
        phi = grown + np.exp(-b * x) * (1 + s) / 2 - np.cos(b * x) + s * np.sin(b * x)
        share = weights @ (phi * (start - load / (100 * b**4)))
        found = found + 2 * np.sign(phi[-1]) * share * np.cos(10 * b**2 * times)
    compared(scene, "m.u(L)", times, found, 2e-9)


@pytest.mark.sweep
def test_what_rests_in_no_polynomial_starts_as_is_said():
    scene = problem((SCENE % ("N*m^2", "beams", "EI", ", preload: 300 N, foundation: 500 N/m^2", "q*exp(x/L)",
                              "(x/L)^2*(6 - 4*x/L + (x/L)^2)/3")).replace("/L)}", "/L), from: 0.3 m}"))
    compared(scene, "m.u(0.7 m)", [0.0], np.array([0.01 * 0.49 * (6 - 2.8 + 0.49) / 3]), 1e-10)


@pytest.mark.sweep
def test_a_bar_under_a_load_with_corners_on_a_part_of_it():
    """EA u_r″ = −q |sin 2πx| from x = 1/4 on."""
    text = SCENE % ("N", "bars", "EA", "", "q*abs(sin(2*pi*x/L))", "x/L")
    scene = problem(text.replace("/L))}", "/L)), from: L/4}"))

    def rest(x):
        one, other = np.clip(x, 0.25, 0.5) - 0.25, np.maximum(x, 0.5) - 0.5
        two_pi = 2 * np.pi
        return 0.5 / two_pi * (3 * np.minimum(x, 0.25) + 3 * one - (1 - np.cos(two_pi * one)) / two_pi + other
                               + np.sin(two_pi * other) / two_pi)

    def away(x):
        x = (x + 1) % 4 - 1
        x = np.where(x > 1, 2 - x, x)
        return np.sign(x) * (0.01 * np.abs(x) - rest(np.abs(x)))

    times = np.array([0.0, 0.013, 0.12, 0.237, 0.71])
    compared(scene, "m.u(0.3 m)", times, rest(0.3) + (away(0.3 - 10 * times) + away(0.3 + 10 * times)) / 2, 1e-13)


@pytest.mark.sweep
def test_a_load_that_turns_sharply_is_refused_by_name():
    scene = problem(SCENE % ("N*m^2", "beams", "EI", "", "q*sqrt(x/L)", "(x/L)^2"))
    with pytest.raises(PhysicsError, match="each of a few parts"):
        scene.response.signal(with_places(parse("m.u(L)"), scene.spec.members)).values(np.zeros(1))
