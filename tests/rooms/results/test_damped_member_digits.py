"""More digits of responses of members with proportional damping, against closed forms at σ² = (s² + αs)/(1 + βs)."""

import numpy as np
import pytest
from mpmath import cos, cosh, mp, mpc, mpf, sin, sinh
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.results.precise_member_response import PreciseMemberCurve

SCENE = """
parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
bodies: {base: {slide: 1 mm*sin(80 rad/s*t)}}
beams:
  mast: {length: L, EI: EI, mass_per_length: mu, left: {clamped: base}}
  arm: {length: L, EI: EI, mass_per_length: mu, left: clamped}
points: {tip: {body: arm, at: L}}
forces: {push: {at: tip, force: 3 N*cos(80 rad/s*t)}}
damping: {DAMPING}
"""


def curve(damping, signal, driver):
    return PreciseMemberCurve(problem(SCENE.replace("{DAMPING}", damping)), signal, driver)


def test_closed_forms():
    with mp.workdps(40):
        s = mpc(0, 80)
        slope = 1 + s / 1000
        k = (-3 * (s * s + 4 * s) / slope / 2400) ** mpf("0.25")
        z = k * mpf("1.2")
        below = 1 + cos(z) * cosh(z)
        tip = (sin(z) * cosh(z) - cos(z) * sinh(z)) / (2400 * k**3 * below * slope)
        for signal, driver, exact in (("arm.u(L)", "push", tip), ("arm.u'(L)", "push", s * tip),
                                      ("arm.moment(0 m)", "push", (sin(z) + sinh(z)) / (k * below * slope)),
                                      ("mast.u(L)", "base", (cos(z) + cosh(z)) / below)):
            found, = curve("{proportional: [4 s^-1, 1e-3 s]}", signal, driver).at(mpf(80))
            assert abs(found - exact) <= mpf(10) ** -30 * abs(exact)


def test_beside_a_damper():
    """EI u‴(L) (1 + βs) = c s u(L) − F and u″(L) = 0 of u = A (cosh kx − cos kx) + B (sinh kx − sin kx)."""
    scene = SCENE.replace("left: clamped}", "left: clamped, right: {c: 20 N*s/m}}")
    scene = problem(scene.replace("{DAMPING}", "{proportional: [4 s^-1, 1e-3 s]}"))
    with mp.workdps(40):
        s = mpc(0, 80)
        slope = 1 + s / 1000
        k = (-3 * (s * s + 4 * s) / slope / 2400) ** mpf("0.25")
        z, EI = k * mpf("1.2"), 2400 * k**3 * slope
        A, B = mp.lu_solve(
            mp.matrix([[cosh(z) + cos(z), sinh(z) + sin(z)],
                       [EI * (sinh(z) - sin(z)) - 20 * s * (cosh(z) - cos(z)),
                        EI * (cosh(z) + cos(z)) - 20 * s * (sinh(z) - sin(z))]]), mp.matrix([0, -1]))
        tip = A * (cosh(z) - cos(z)) + B * (sinh(z) - sin(z))
        for signal, exact in (("arm.u(L)", tip), ("arm.moment(0 m)", 2 * 2400 * k**2 * A),
                              ("arm.shear(0 m)", 2 * 2400 * k**3 * B)):
            found, = PreciseMemberCurve(scene, signal, "push").at(mpf(80))
            assert abs(found - exact) <= mpf(10) ** -30 * abs(exact)


def test_of_ratios_they_are_refused():
    with pytest.raises(PhysicsError, match="`proportional` alone"):
        curve("{modal: 2 %}", "arm.u(L)", "push")


@pytest.mark.sweep
def test_at_no_frequency_nothing_is_found():
    transfer = problem(SCENE.replace("{DAMPING}", "{modal: 1.2}")).frequency_response("arm.u(L)", "push").transfer
    assert [len(part) for part in transfer.at(np.zeros(0), True)] == [0, 0, 0]
