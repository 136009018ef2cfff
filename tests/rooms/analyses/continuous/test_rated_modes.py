"""Damped modes of members that are damped as a whole, against λ² + c λ + ω² = 0."""

import cmath

import pytest
from support.scenes import problem

SCENE = """
parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
damping: {DAMPING}
"""


def of(damping):
    return problem(SCENE.replace("{DAMPING}", damping))


@pytest.mark.parametrize(("damping", "c"), [
    ("{modal: [2 %, 3 %]}", lambda i, omega: 2 * (0.02 if i == 1 else 0.03) * omega),
    ("{modal: 150 %}", lambda i, omega: 3 * omega),
    ("{proportional: [4 s^-1, 1e-3 s]}", lambda i, omega: 4 + 1e-3 * omega**2)])
def test_eigenvalues(damping, c):
    modal = of(damping).modal
    for mode in modal.modes.first(6):
        own = sorted((one.eigenvalue for one in modal.damped.numbered(mode.index, mode.index)), key=abs)
        half, omega = c(mode.index, mode.omega) / 2, mode.omega
        root = cmath.sqrt(half**2 - omega**2)
        wanted = [root - half] if root.imag else [omega**2 / (-half - root), -half - root]
        assert own == pytest.approx(wanted, rel=1e-12)


def test_a_series_goes_through_its_modes():
    modal = of("{caughey: {1: 1 %, 2: 2 %, 3: 8 %}}").modal
    assert [mode.zeta for mode in modal.damped.first(4)] == pytest.approx([0.01, 0.02, 0.08, 0.327191915588], rel=1e-11)


def test_more_digits():
    modal = of("{modal: 2 %}").modal
    assert abs(modal.damped_to(30).first(1)[0].eigenvalue.real + modal.modes_to(30).first(1)[0].omega / 50) < 1e-28


def test_what_nothing_holds_has_two_eigenvalues():
    modal = problem(SCENE.replace(", left: clamped", "").replace("{DAMPING}", "{proportional: [4 s^-1, 1e-3 s]}")).modal
    assert [mode.eigenvalue for mode in modal.damped.first(2)] == [0, -4, 0, -4]


def test_what_grows_has_two_eigenvalues():
    modal = problem(SCENE.replace("left: clamped", "left: pinned, right: pinned, preload: -pi^2*EI/L^2*1.5")
                    .replace("{DAMPING}", "{proportional: [4 s^-1, 1e-3 s]}")).modal
    g = modal.modes.first(1)[0].growth_rate
    half = (4 - 1e-3 * g**2) / 2
    root = cmath.sqrt(half**2 + g**2)
    assert [mode.eigenvalue for mode in modal.damped.first(1)] == pytest.approx([root - half, -root - half], rel=1e-12)


def test_they_are_listed():
    """Of these no argument principle is asked."""
    modes = of("{modal: 2 %}").modal.damped
    assert modes.proof(modes.first(3)) is None
