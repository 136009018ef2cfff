"""Motions of equations expanded to the third order, against elliptic functions and energies."""

import mpmath
import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError, SpecError

BEAD = """
parameters: {{m: 2 kg, k: 300 N/m, g3: 500 N/m^3, l: 0.5 m, N: 20 N, A: 0.2 m}}
bodies: {{p: {{mass: m, at: [0, 0], slide: x}}}}
springs:
  along: {{law: "k*d + g3*d^3", between: [[-l, 0], p]}}
  above: {{k: k, preload: N, between: [[0, l], p]}}
  below: {{k: k, preload: N, between: [[0, -l], p]}}
initial: {{x: A}}
motion: {motion}
"""


def test_bead_between_springs_is_a_duffing_oscillator():
    m, k, g3, length, N, A = 2, 300, 500, 0.5, 20, 0.2
    linear, cubic = k + 2 * N / length, g3 + (k - N / length) / length**2
    omega = mpmath.sqrt((linear + cubic * A**2) / m)
    modulus = cubic * A**2 / (2 * (linear + cubic * A**2))
    scene = problem(BEAD.format(motion="{order: 3}"))
    assert value(scene, "period(x)") == pytest.approx(float(4 * mpmath.ellipk(modulus) / omega), rel=1e-14)
    assert value(scene, "x(1 s)") == pytest.approx(float(A * mpmath.ellipfun("cn", omega, m=modulus)), rel=1e-9)
    full = problem(BEAD.format(motion="full"))
    assert value(full, "period(x)") != pytest.approx(value(scene, "period(x)"), rel=1e-5)
    assert value(full, "period(x)") == pytest.approx(value(scene, "period(x)"), rel=5e-3)


def test_loads_that_follow_the_motion_are_expanded_too():
    text = """
    parameters: {{m: 1 kg, k: 9 N/m, F: 2 N, b: 1 m}}
    bodies: {{p: {{mass: m, at: [0 m, 0 m], slide: x}}}}
    springs: {{s: {{k: k, between: [[-1 m, 0 m], p]}}}}
    forces: {{F: {{at: p, force: ["{F}", 0 N]}}}}
    initial: {{x: 0.4 m}}
    motion: {motion}
    """
    expanded = problem(text.format(F="F*(sin(x/b) - x/b)", motion="{order: 3}"))
    written_out = problem(text.format(F="-F*(x/b)^3/6", motion="full"))
    assert value(expanded, "x(2 s)") == pytest.approx(value(written_out, "x(2 s)"), rel=1e-10)


def test_other_orders_are_refused():
    with pytest.raises(SpecError, match="expanded to the third order alone"):
        problem(BEAD.format(motion="{order: 5}"))


def test_energies_along_the_motion_are_refused():
    with pytest.raises(PhysicsError, match="energies along a motion of the expanded equations are not told"):
        value(problem(BEAD.format(motion="{order: 3}")), "V(1 s)")
