"""Frequency responses to loads along members, beside general solutions of the differential equation in mpmath."""

import math

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.frequency_response import member_poles_and_zeros
from vibcli.analyses.frequency_response.evaluate import frf, sloped
from vibcli.results.precise_member_response import PreciseMemberCurve

SIMPLE = """
    parameters: {{L: 2 m, EI: 2400 N*m^2, mu: 3 kg/m, k: 500 N/m^2, T: 300 N, c: {drag}}}
    beams: {{wing: {{length: L, EI: EI, mass_per_length: mu, foundation: k, preload: T, drag: c, left: pinned,
            right: pinned{parts}}}}}
    forces: {{wind: {{body: wing, per_length: -7 N/m*sin(3*pi*x/L)*cos(20 rad/s*t)}}}}
"""
CANTILEVER = """
    parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m, a: 0.5 m}
    beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
    forces: {drive: {body: arm, per_length: 5 N/m*(x/L)^2*cos(30 rad/s*t), from: a}}
"""
HELD = 4.730040744862704**2 * math.sqrt(2400 / 3) / 4       # of the beam with both ends clamped
OMEGA = np.array([0.0, 3.0, 69.0, 250.0, HELD, 628.5, 3e3, 4e4])


def curve(text, signal, driver):
    return problem(text).frequency_response(signal, driver).transfer


@pytest.mark.sweep
@pytest.mark.parametrize("drag", [0.0, 4.0])
@pytest.mark.parametrize("parts", ["", ", attached: [{at: 0.3 m, k: 0 N/m}, {at: 1.1 m, k: 0 N/m}]"])
def test_a_sine_on_pins_leaves_a_sine(drag, parts):
    """H = −sin(3πx/L)/(EI b⁴ + T b² + k + iΩc − μΩ²), b = 3π/L, within the bound and to ten digits."""
    text, b = SIMPLE.format(drag=f"{drag} N*s/m^2", parts=parts), 3 * math.pi / 2
    exact = -1 / (2400 * b**4 + 300 * b**2 + 500 + 1j * OMEGA * drag - 3 * OMEGA**2)
    for signal, factor in (("wing.u(0.7 m)", math.sin(0.7 * b)), ("wing.slope(L)", b * math.cos(2 * b)),
                           ("wing.moment(1.1 m)", -2400 * b**2 * math.sin(1.1 * b)),
                           ("wing.shear(0 m)", -2400 * b**3)):
        found = curve(text, signal, "wind")
        H = frf(found, OMEGA)
        bounds = np.array([found.error(at) for at in OMEGA])
        assert (np.abs(H - factor * exact) <= bounds).all()
        assert (np.abs(H - factor * exact) <= 1e-9 * np.abs(factor * exact)).all()
        slope = sloped(found, OMEGA[1:4])[1]
        assert slope == pytest.approx(factor * exact[1:4]**2 * (drag + 6j * OMEGA[1:4]), rel=1e-7)


def loaded(Omega, number=complex):
    """u(L) and the moment at the clamp of the cantilever under (x/L)² on a … L, from general solutions."""
    with mpmath.workdps(50):
        L, a, EI, mu = (mpmath.mpf(x) for x in ("1.2", "0.5", "2400", "3"))
        kappa = -mu * mpmath.mpf(Omega) ** 2
        waves = [(-kappa / EI) ** mpmath.mpf("0.25") * turn for turn in (1, -1, 1j, -1j)]

        def row(x, order):
            return [wave**order * mpmath.exp(wave * x) for wave in waves]

        def own(x, order):          # of κ w = x²/L², whose fourth derivative is zero
            return [x**2, 2 * x, 2, 0][order] / (L**2 * kappa)

        nothing = [0] * 4
        rows = [(row(0, k) + nothing, 0) for k in (0, 1)]
        rows += [(row(a, k) + [-v for v in row(a, k)], own(a, k)) for k in range(4)]
        rows += [(nothing + row(L, k), -own(L, k)) for k in (2, 3)]
        found = mpmath.lu_solve(mpmath.matrix([r for r, _ in rows]), mpmath.matrix([v for _, v in rows]))
        return [number(sum(v * c for v, c in zip(row(L, 0), found[4:], strict=True)) + own(L, 0)),
                number(EI * sum(v * c for v, c in zip(row(0, 2), found[:4], strict=True)))]


@pytest.mark.sweep
def test_a_load_on_a_part_of_a_cantilever():
    for index, signal in enumerate(("arm.u(L)", "arm.moment(0 m)")):
        found = curve(CANTILEVER, signal, "drive")
        Omega = np.array([2.0, 60.0, 430.0, 439.4, 9e3])
        exact = np.array([loaded(at)[index] for at in Omega])
        assert (np.abs(frf(found, Omega) - exact) <= [found.error(at) for at in Omega]).all()
        assert frf(found, Omega) == pytest.approx(exact, rel=1e-9)
        for zero in found.zeros(100.0, 400.0).imag if index else ():
            near = [loaded(zero * (1 + side))[index].real for side in (-1e-7, 1e-7)]
            assert near[0] * near[1] < 0


@pytest.mark.sweep
def test_zeros_are_looked_for_in_a_few_intervals_at_a_time(monkeypatch):
    """Of many poles no more points are kept than of a few."""
    at_once = curve(CANTILEVER, "arm.moment(0 m)", "drive").zeros(0.0, 1e4)
    asked = []
    enclosed = member_poles_and_zeros.enclosed
    monkeypatch.setattr(member_poles_and_zeros, "TOGETHER", 2)
    monkeypatch.setattr(member_poles_and_zeros, "enclosed",
                        lambda response, a, b: asked.append(len(a)) or enclosed(response, a, b))
    assert (curve(CANTILEVER, "arm.moment(0 m)", "drive").zeros(0.0, 1e4) == at_once).all()
    assert len(at_once) > 2 and len(asked) > 2 and max(asked) == 2


@pytest.mark.sweep
def test_more_digits():
    scene = problem(CANTILEVER)
    with mpmath.workdps(40):
        for index, signal in enumerate(("arm.u(L)", "arm.moment(0 m)")):
            found, = PreciseMemberCurve(scene, signal, "drive").at(mpmath.mpf(430))
            assert abs(found / loaded(430, mpmath.mpmathify)[index] - 1) < 1e-34


def test_a_load_along_a_light_piece_is_an_input_too():
    """M Ω² of the mass at the end beside the spring 3EI/L³, and the work of (x/L)² on its deflection."""
    text = """
        parameters: {L: 2 m, EI: 1 kN*m^2, M: 4 kg}
        beams: {wing: {length: L, EI: EI, left: clamped, attached: [{at: L, mass: M}]}}
        forces: {wind: {body: wing, per_length: 3 N/m*(x/L)^2*cos(5 rad/s*t)}}
    """
    work = float(mpmath.quad(lambda x: x**2 / 4 * (6 * x**2 - x**3) / 16, [0, 2]))
    found = curve(text, "wing.u(L)", "wind")
    assert frf(found, np.array([7.0])) == pytest.approx(work / (375 - 4 * 49), rel=1e-12)


@pytest.mark.sweep
@pytest.mark.parametrize("inertia", ["", ", mass_per_length: 3 kg/m"])
def test_a_steady_load_is_an_input_of_its_form(inertia):
    """Along what vibrates and what is light, even and uneven: as what varies in its place; at rest ∫ f (6x² − x³) dx
    over 6 EI."""
    text = """
        beams: {wing: {left: clamped, segments: [{length: 1 m, EI: 1 kN*m^2%s}, {length: 1 m, EI: 1 kN*m^2}],
                attached: [{at: 2 m, mass: 4 kg}]}}
        forces: {wind: {body: wing, per_length: 3 N/m%s}}
    """
    Omega = np.array([0.0, 7.0])
    for form, at_rest in (("", 12 / 6000), ("*(x/(2 m))^2", (6.4 - 16 / 9) / 4000)):
        steady, varying, both = (frf(curve(text % (inertia, form + load), "wing.u(2 m)", "wind"), Omega)
                                 for load in ("", "*cos(5 rad/s*t)", " + 2 N/m*cos(5 rad/s*t)" + form))
        assert steady.tolist() == pytest.approx(varying.tolist(), rel=1e-12)
        assert both.tolist() == pytest.approx(varying.tolist(), rel=1e-12)
        assert steady[0] == pytest.approx(at_rest, rel=1e-12)
