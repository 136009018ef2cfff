"""What modes left out add after steps and blows at places without mass is bounded, though the energy that these leave
to moments, rates or displacements is infinite: against residues of a beam on pins with a damper c in the middle,

    u = G(x, y) − s c G(x, ½) G(½, y)/(1 + s c G(½, ½)),     4β cos β/2 + i c (sin β/2 − cos β/2 tanh β/2) = 0, s = i β²
"""

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

from vibcli.analyses.continuous.left_out_causes import AT_ONCE, IN_FIELD, MOVED, PACE, TOO_SUDDEN, UNFIT
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.results.damped_modal_response import DampedModalResponse

BEAM = """
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned, attached: [{at: L/2, c: 0.7 N*s/m}]}}
points: {aside: {body: arm, at: 0.3*L}}
forces: {push: {at: aside, force: %s}}
"""
SHAKEN = """
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
bodies: {hand: {%s}}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: {clamped: hand}, attached: [{at: L/2, c: 0.7 N*s/m}]}}
"""
STEP, BLOW = "1 N*step(t)", "1 N*s*impulse(t)"
C, Y, MID, MANY = 0.7, 0.3, 0.5, 8_000
TIMES = np.linspace(0.0, 0.6, 17)[1:]
pytestmark = pytest.mark.usefixtures("modes_found_once")


def _roots():
    """β of the modes that move the damper."""
    b = (2 * np.arange(MANY) + 1) * np.pi + 0j
    for _ in range(30):
        sin, cos, tanh = np.sin(b / 2), np.cos(b / 2), np.tanh(b / 2)
        off = 4 * b * cos + 1j * C * (sin - cos * tanh)
        b = b - off / (4 * cos - 2 * b * sin + 0.5j * C * (cos + sin * tanh - cos * (1 - tanh**2)))
    assert (np.abs(b - (2 * np.arange(MANY) + 1) * np.pi) < 0.5).all()
    return b


def _shown(b, x, y, bent=False):
    """G, or G″ by x."""
    low, high = min(x, y), 1 - max(x, y)
    waves = np.sin(b * low) * np.sin(b * high) / np.sin(b)
    local = (np.exp(b * (low + high - 1)) * (1 - np.exp(-2 * b * low)) * (1 - np.exp(-2 * b * high))
             / (1 - np.exp(-2 * b)) / 2)
    return -(waves + local) / (2 * b) if bent else (waves - local) / (2 * b**3)


def _slope(b):
    """d/ds of 1 + s c G(½, ½)."""
    tan, tanh = np.tan(b / 2), np.tanh(b / 2)
    return 1j * C * ((tan**2 + tanh**2) / 2 / (4 * b) - (tan - tanh) / (4 * b**2)) / (2j * b)


def _summed(b, residues, t):
    return 2 * (residues * np.exp(1j * np.outer(t, b**2))).sum(axis=1).real


def _expected(x, bent, t):
    """u″ after the step, or u after the blow, of what the damper damps and of what it does not."""
    b, n = _roots(), 2 * np.pi * np.arange(1, MANY)
    own = -C * _shown(b, x, MID, bent) * _shown(b, MID, Y) / _slope(b) * (1 if bent else 1j * b**2)
    still = 2 * np.sin(n * x) * np.sin(n * Y) * n**-2.0
    if bent:
        return Y * (x - 1) + _summed(b, own, t) + (np.cos(np.outer(t, n**2)) * still).sum(axis=1)
    return _summed(b, own, t) + (np.sin(np.outer(t, n**2)) * still).sum(axis=1)


@pytest.mark.sweep
@pytest.mark.parametrize(("force", "place", "x", "bent"), [
    (STEP, FieldPoint(2, 0.0, 2), 0.5, True), (STEP, FieldPoint(2, 0.2, 2), 0.7, True),
    (BLOW, FieldPoint(1, 0.0), 0.3, False), (BLOW, FieldPoint(2, 0.1), 0.6, False)])
@pytest.mark.parametrize(("count", "share"), [(8, 8), (64, 40)])
def test_a_moment_after_a_step_and_a_displacement_after_a_blow(force, place, x, bent, count, share):
    motion, output = DampedModalResponse(problem(BEAM % force)).motion(count), LinearOutput(places={place: 1.0})
    off = np.abs(motion.values(output, TIMES) - _expected(x, bent, TIMES))
    assert not motion.is_estimated(output)
    assert off.max() <= motion.bound(output, 0.3) + 1 / MANY
    assert motion.bound(output, 0.3) <= share * off.max()


@pytest.mark.sweep
@pytest.mark.parametrize("along", [2, 3])
def test_moments_and_shears_after_a_start_in_a_field(along):
    """û = (s u₀ + c G(x, ½) π⁴/(1 + s c G(½, ½)))/(s² + π⁴) of u₀ = sin πx; u‴ by u″ left and right of x."""
    b, x, step = _roots(), 0.7, 1e-4 if along == 3 else 0.0
    text = BEAM[:BEAM.index("forces:")] + "initial: {arm.u: 1 m*sin(pi*x/L)}\n"
    motion = DampedModalResponse(problem(text)).motion(8)
    output = LinearOutput(places={FieldPoint(2, 0.2, along): 1.0})
    bent = [_summed(b, C * _shown(b, at, MID, True) * np.pi**4 / (np.pi**4 - b**4) / _slope(b), TIMES)
            for at in (x - step, x + step)]
    off = np.abs(motion.values(output, TIMES) - (bent[0] if along == 2 else (bent[1] - bent[0]) / (2 * step)))
    assert not motion.is_estimated(output)
    assert off.max() <= motion.bound(output, 0.3) <= 8 * off.max()


@pytest.mark.sweep
def test_a_field_that_does_not_fit_an_end_leaves_moments_estimated():
    text = BEAM[:BEAM.index("forces:")] + "initial: {arm.u: 1 m*x*(L - x)/L^2}\n"
    motion, output = DampedModalResponse(problem(text)).motion(8), LinearOutput(places={FieldPoint(1, 0.2, 2): 1.0})
    assert motion.is_estimated(output) and motion.modes.disturbed(motion.forcing.pieces).reason(output) == UNFIT


@pytest.mark.sweep
def test_shears_after_steps_and_slopes_after_blows_are_estimated():
    motions = [DampedModalResponse(problem(BEAM % force)).motion(8) for force in (STEP, BLOW)]
    for motion, place in zip(motions, (FieldPoint(2, 0.1, 3), FieldPoint(2, 0.1, 1)), strict=True):
        output = LinearOutput(places={place: 1.0})
        assert motion.is_estimated(output) and motion.modes.disturbed(motion.forcing.pieces).reason(output) == AT_ONCE


@pytest.mark.sweep
def test_displacements_after_a_clamp_turns_at_once_are_bounded_and_forces_are_not():
    motion = DampedModalResponse(problem(SHAKEN % "turn: 0.01*step(t)")).motion(8)
    more = DampedModalResponse(problem(SHAKEN % "turn: 0.01*step(t)")).motion(64)
    moved, bent = LinearOutput(places={FieldPoint(1, 0.3): 1.0}), LinearOutput(places={FieldPoint(1, 0.3, 2): 1.0})
    off = np.abs(motion.values(moved, TIMES) - more.values(moved, TIMES))
    assert not motion.is_estimated(moved) and off.max() <= motion.bound(moved, 0.3) + more.bound(moved, 0.3)
    assert motion.bound(moved, 0.3) <= 20 * off.max()
    assert motion.is_estimated(bent) and motion.modes.disturbed(motion.forcing.pieces).reason(bent) == MOVED


@pytest.mark.sweep
def test_a_driven_end_that_jumps_is_estimated():
    pinned = SHAKEN.replace("clamped: hand", "pinned: hand").replace("attached", "right: pinned, attached")
    motion = DampedModalResponse(problem(pinned % "slide: 1 cm*step(t)")).motion(8)
    output = LinearOutput(places={FieldPoint(1, 0.3): 1.0})
    assert motion.is_estimated(output) and motion.modes.disturbed(motion.forcing.pieces).reason(output) == MOVED


FITS, UNFITTING = "1 m*sin(pi*x/L)", "1 m*x*(L - x)/L^2"
SUDDEN, SMOOTH = "1 N*step(t)", "1 N*(t/(1 s))^4"
SHEAR, MOMENT = FieldPoint(2, 0.1, 3), FieldPoint(2, 0.1, 2)


@pytest.mark.parametrize(("force", "field", "place", "reason"), [
    (SUDDEN, None, SHEAR, AT_ONCE), (SMOOTH, UNFITTING, SHEAR, UNFIT),
    (SUDDEN, UNFITTING, SHEAR, f"{UNFIT}, and {AT_ONCE}"),
    (SUDDEN, FITS, SHEAR, AT_ONCE), (SUDDEN, UNFITTING, MOMENT, UNFIT), (SMOOTH, FITS, SHEAR, None),
    ("1 N*s*impulse(t)", UNFITTING, MOMENT, f"{UNFIT}, and {AT_ONCE}"),
    (SMOOTH, FITS, MOMENT._replace(rates=1), IN_FIELD),
    (SUDDEN, FITS, MOMENT._replace(rates=1), f"{IN_FIELD}, and {AT_ONCE}"),
    ("1 N*sin(800*t/(1 s))", UNFITTING, MOMENT, f"{UNFIT}, and {PACE}")])
def test_each_cause_alone_and_both_together_are_told(force, field, place, reason):
    start = "" if field is None else f"initial: {{arm.u: {field}}}\n"
    assert told(BEAM % force + start, place) == reason


def told(text, read):
    output = read if isinstance(read, LinearOutput) else LinearOutput(places={read: 1.0})
    motion = DampedModalResponse(problem(text)).motion(8)
    return motion.modes.disturbed(motion.forcing.pieces).reason(output) if motion.is_estimated(output) else None


@pytest.mark.parametrize(("drive", "force", "reason"), [
    ("0.01*step(t)", "0 N", MOVED), ("0.01*(1 - cos(9*t/(1 s)))^3", "1 N*s*impulse(t)", AT_ONCE),
    ("0.01*step(t)", "1 N*s*impulse(t)", f"{MOVED}, and {AT_ONCE}"), ("0.01*(1 - cos(9*t/(1 s)))^3", "0 N", None)])
def test_a_clamp_that_turns_at_once_and_a_blow(drive, force, reason):
    text = SHAKEN % f"turn: {drive}" + "points: {aside: {body: arm, at: L/4}}\n"
    assert told(text + f"forces: {{push: {{at: aside, force: {force}}}}}\n", FieldPoint(2, 0.3, 2)) == reason


@pytest.mark.parametrize(("force", "reason"), [(STEP, None), (BLOW, TOO_SUDDEN)])
def test_a_blow_on_a_mass_is_too_sudden_for_its_acceleration(force, reason):
    text = BEAM.replace("attached: [", "attached: [{at: 0.3*L, mass: 1 kg}, ") % force
    assert told(text, LinearOutput(a={1: 1.0})) == reason
