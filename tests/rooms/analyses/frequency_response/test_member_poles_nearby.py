"""Frequency responses next to poles, against transfer matrices of the same beam in mpmath: to a few roundings
times the condition of the matrix that is solved."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.frequency_response import member_marks
from vibcli.analyses.frequency_response.evaluate import frf

STEPPED = """
    beams:
      arm:
        mass_per_length: 2 kg/m
        left: clamped
        segments: [{length: 0.5 m, EI: 100 N*m^2}, {length: 0.5 m, EI: 50 N*m^2}]
        attached: [{at: 0.25 m, mass: 0.25 kg}, {at: 0.75 m, k: 100 N/m}, {at: 1 m, mass: 0.125 kg}%s]
    points: {tip: {body: arm, at: 1 m}}
    forces: {drive: {at: tip, force: 1 N*sin(3 rad/s*t)}}
"""
EPS = 2.0**-52


def along(bending, s, length):
    """(u, u′, EI u″, EI u‴) from one end of a piece to the other, by the four waves e^{βx}."""
    beta = (-2 * s * s / bending) ** mpmath.mpf("0.25")
    waves = [beta * mpmath.mpc(0, 1)**k for k in range(4)]
    at = mpmath.matrix([[w**i * (bending if i > 1 else 1) for w in waves] for i in range(4)])
    return at * mpmath.diag([mpmath.exp(w * length) for w in waves]) * mpmath.inverse(at)


def tip(s, c):
    """u of the tip for a unit force there. What is attached turns EI u‴: by k u + c u̇ + m ü."""
    def attached(k):
        found = mpmath.eye(4)
        found[3, 0] = -k
        return found

    quarter = mpmath.mpf("0.25")
    whole = along(50, s, quarter) * attached(100 + c * s) * along(50, s, quarter) * along(
        100, s, quarter) * attached(s * s / 4) * along(100, s, quarter)
    moment, shear = whole[2, 2:4], whole[3, 2:4]
    across = whole[0, 2:4]
    ends = mpmath.matrix([[moment[0], moment[1]], [shear[0] - s * s / 8 * across[0], shear[1] - s * s / 8 * across[1]]])
    first = mpmath.lu_solve(ends, mpmath.matrix([0, -1]))
    return across[0] * first[0] + across[1] * first[1]


def rounded(transfer, Omega):
    """What the last digits of D and x make of H where it is driven, |c|ᵀ |D⁻¹| |D| |x| (Skeel)."""
    system = transfer.system
    D = np.moveaxis(system.matrix.at(1j * Omega).D[np.ix_(system.free, system.free)], -1, 0)
    row = np.array([system.output.rows[0].get(i, 0.0) for i in system.free])
    inverse = np.linalg.inv(D)
    return np.einsum("i,kij,kjl,kl->k", np.abs(row), np.abs(inverse), np.abs(D), np.abs(inverse @ row))


@pytest.mark.sweep
@pytest.mark.parametrize("c", [0, 2**-20, 3])
def test_stepped_beam_with_attachments(c):
    scene = problem(STEPPED % (f", {{at: 0.75 m, c: {c} N*s/m}}" if c else ""))
    poles = [float(mode.omega) for mode in scene.modal.modes.first(4)]
    beside = [pole * (1 + away) for pole in poles for away in (1e-9, -3e-10, 1e-5)]
    asked = np.array([*np.geomspace(1, 2e4, 12), *beside])
    transfer = scene.frequency_response("arm.u(1 m)", "drive").transfer
    found, felt = frf(transfer, asked), rounded(transfer, asked)
    with mpmath.workdps(60):
        for Omega, value, size in zip(asked, found, felt, strict=True):
            assert abs(value - tip(mpmath.mpc(0, Omega), c)) <= 4 * EPS * size, Omega


@pytest.mark.sweep
@pytest.mark.parametrize("k", ["1e-11", "1e-7", "0.001", "40"])
def test_modes_next_to_each_other(k):
    """Two cantilevers whose tips a spring ties: H = (G + 1/(1/G + 2k))/2, G that of one alone."""
    beam = "{length: 1 m, EI: 50 N*m^2, mass_per_length: 2 kg/m, left: clamped}"
    scene = problem(f"""
        beams: {{one: {beam}, two: {beam}}}
        points: {{p: {{body: one, at: 1 m}}, q: {{body: two, at: 1 m}}}}
        springs: {{tie: {{k: {k} N/m, between: [p, q]}}}}
        forces: {{drive: {{at: p, force: 1 N*sin(3 rad/s*t)}}}}
    """)
    poles = [float(mode.omega) for mode in scene.modal.modes.first(4)]
    asked = np.array([pole * (1 + away) for pole in poles for away in (1e-9, -3e-10, 1e-10, -1e-5, 0.1)])
    transfer = scene.frequency_response("one.u(1 m)", "drive").transfer
    found, felt = frf(transfer, asked), rounded(transfer, asked)
    with mpmath.workdps(60):
        for Omega, value, size in zip(asked, found, felt, strict=True):
            whole = along(50, mpmath.mpc(0, Omega), mpmath.mpf(1))
            first = mpmath.lu_solve(whole[2:4, 2:4], mpmath.matrix([0, -1]))
            alone = whole[0, 2] * first[0] + whole[0, 3] * first[1]
            assert abs(value - (alone + 1 / (1 / alone + 2 * mpmath.mpf(k))) / 2) <= 10 * EPS * size, Omega


@pytest.mark.sweep
def test_poles_of_a_scene_are_found_once_for_all_that_it_answers(monkeypatch):
    def transfer(scene, signal):
        return scene.frequency_response(signal, "drive").transfer

    one, searched = problem(STEPPED % ", {at: 0.5 m, c: 2 N*s/m}"), []
    find = member_marks.poles
    monkeypatch.setattr(member_marks, "poles", lambda *given: searched.append(given) or find(*given))
    responses = [transfer(one, signal) for signal in ("arm.u(1 m)", "arm.moment(0 m)", "arm.slope(0.6 m)'")]
    assert len({tuple(response.poles(0.0, 50.0)) for response in responses}) == 1 == len(searched)
    stronger = transfer(problem(STEPPED % ", {at: 0.5 m, c: 4 N*s/m}"), "arm.u(1 m)")
    between = responses[0].with_damper(stronger, 0.5).poles(0.0, 50.0).real / responses[0].poles(0.0, 50.0).real
    assert len(searched) == 2 and between == pytest.approx(1.5, rel=0.01)
