"""What damped modes left out add is bounded by their energy: against what motions begin with, against many more modes
and travelling waves, and the energies of modes against their fields."""

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

from vibcli.analyses.continuous.damped_energies import energies
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.language.signals_of_places import with_places
from vibcli.results.damped_modal_response import DampedModalResponse
from vibcli.results.wave_response import WaveResponse
from vibcli.results.without_bound import without_bound
from vibcli.symbolic.parser import parse

BEAM = """
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, ENDS, attached: [{at: L/2, c: DAMPER}MORE]}}
points: {aside: {body: arm, at: 0.3*L}, mid: {body: arm, at: L/2}}
""".replace("MORE", "%s")
STEP = "forces: {push: {at: aside, force: 1 N*step(t)}}"
PINNED = BEAM.replace("ENDS", "left: pinned, right: pinned") % "" + "%s"
COMMON = PINNED.replace("DAMPER", "0.7 N*s/m")
SHAKEN = "bodies: {hand: {slide: SLIDE}}" + BEAM.replace("ENDS", "left: {ENDS: hand}, right: pinned").replace(
    "DAMPER", "0.7 N*s/m") % ""
ASIDE, TURN, MID, BETWEEN = FieldPoint(1, 0.0), FieldPoint(1, 0.0, 1), FieldPoint(2, 0.0), FieldPoint(2, 0.2)
MOMENT, SHEAR, RATE = FieldPoint(2, 0.0, 2), FieldPoint(2, 0.1, 3), FieldPoint(1, 0.0, 0, 1)
SCENES = {
    "step": (COMMON % STEP, {ASIDE: 0, MID: 0, TURN: 0}),
    "half a sine": (COMMON % "forces: {push: {at: aside, force: 1 N*sin(pi*t/(0.3 s))*step(0.3 s - t)}}",
                    {ASIDE: 0, TURN: 0}),
    "at resonance, hardly damped at a node": (
        PINNED.replace("DAMPER", "1e-8 N*s/m") % "forces: {push: {at: aside, force: 1 N*cos(4*pi^2*t/(1 s))}}",
        {ASIDE: 0, MID: 0}),
    "loads along it": (COMMON % """
forces: {push: {body: arm, per_length: 1 N/m*x/L*step(t), to: 0.3*L}, pull: {at: aside, force: 1 N*step(t - 0.1 s)},
         shove: {body: arm, per_length: 1 N/m*sin(pi*x/L)*cos(20*t/(1 s)), to: 0.3*L}}""", {ASIDE: 0, MID: 0, TURN: 0}),
    "a blow along a part": (COMMON % "forces: {push: {body: arm, per_length: 1 N*s/m*impulse(t), to: 0.3*L}}",
                            {ASIDE: 0, MID: 0}),
    "dragged": (COMMON.replace("mass", "drag: 3 N*s/m^2, mass", 1) %
                "forces: {push: {at: aside, force: 1 N*step(t) + 1 N*cos(20*t/(1 s))}}", {ASIDE: 0, MID: 0}),
    "let go": (COMMON % "forces: {push: {at: aside, force: 1 N}}\ninitial: {released: push}",
               {ASIDE: 0.3**2 * 0.7**2 / 3}),
    "thrown in a field": (COMMON % "initial: {arm.u': 1 mm/s*x*(L - x)/L^2}",
                          {ASIDE: 0, MID: 0, MOMENT: 0, RATE: 1e-3 * 0.3 * 0.7}),
    "bent as its first mode is": (COMMON % "initial: {arm.u: 1 mm*sin(pi*x/L)}",
                                  {MOMENT: -1e-3 * np.pi**2, RATE: 0, SHEAR: 1e-3 * np.pi**3 * np.sin(0.1 * np.pi)}),
    "bent in a field": (COMMON % "initial: {arm.u: 1 mm*(x/L)^2*(1 - x/L)^2}", {ASIDE: 1e-3 * 0.3**2 * 0.7**2}),
    "shaken from a velocity on": (SHAKEN.replace("SLIDE", "1 cm*sin(9*t/(1 s))").replace("ENDS", "pinned"),
                                  {ASIDE: 0, MID: 0, TURN: 0}),
    "shaken for a while, beside loads along it": (
        SHAKEN.replace("SLIDE", "1 m/s*(ramp(t) - ramp(t - 0.1 s))").replace("ENDS", "clamped").replace(
            "mass", "drag: 3 N*s/m^2, mass", 1)
        + "forces: {push: {body: arm, per_length: 1 N/m*x/L*step(t), to: 0.3*L}}", {ASIDE: 0, BETWEEN: 0, TURN: 0}),
    "a blow and a step on a mass that nothing holds": (
        BEAM.replace("ENDS", "left: free").replace("DAMPER", "0.7 N*s/m") % ", {at: 0.3*L, mass: 0.5 kg}"
        + "bodies: {hit: {mass: 0.5 kg, slide: y}}\nsprings: {tie: {k: 9 N/m, between: [hit, mid]}}\n"
        + "forces: {push: {at: aside, force: 1 N*s*impulse(t) + 9 N*step(t)}}", {ASIDE: 0, BETWEEN: 0}),
}
RAMP = "forces: {push: {at: aside, force: 1 N*(ramp(t) - ramp(t - 0.2 s))/(0.2 s)}}"
UNEVEN = "segments: [{length: 0.6*L, drag: 3 N*s/m^2}, {length: 0.4*L, drag: DRAG}]"
SCENES |= {
    "dragged unevenly": (COMMON.replace("length: L", UNEVEN).replace("DRAG", "1 N*s/m^2") % STEP,
                         {ASIDE: 0, MID: 0, TURN: 0, MOMENT: 0, RATE: 0}),
    "dragged on a part, loaded along it": (
        PINNED.replace("length: L", UNEVEN).replace("DRAG", "0 N*s/m^2").replace("c: DAMPER", "k: 2 N/m") %
        "forces: {push: {body: arm, per_length: 1 N/m*x/L*step(t), to: 0.45*L}}",
        {ASIDE: 0, MID: 0, MOMENT: 0, RATE: 0}),
    "dragged beside a mass": (PINNED.replace("mass", "drag: 3 N*s/m^2, mass", 1).replace("c: DAMPER", "mass: 0.5 kg")
                              % STEP, {ASIDE: 0, MID: 0}),
    "creeping": (PINNED.replace("length: L", UNEVEN.replace("drag: 3", "drag: 60")).replace(
        "DRAG", "1 N*s/m^2").replace("DAMPER", "1 N*s/m") % RAMP, {ASIDE: 0, MID: 0, MOMENT: 0}),
    "along a mast": ("""
parameters: {L: 1 m, mu: 1 kg/m, g: 9.81 m/s^2, EI: 20 N*m^2}
gravity: g
beams: {arm: {from: [0, 0], to: [0, L], EI: EI, mass_per_length: mu, left: clamped, right: {c: 0.7 N*s/m}}}
forces: {push: {body: arm, per_length: 1 N/m*x/L*step(t), to: 0.45*L}}""",
                     {FieldPoint(0, 0.2): 0, FieldPoint(1, 0.2, 2): 0}),
    "a ramp": (COMMON % RAMP, {ASIDE: 0, MOMENT: 0, SHEAR: 0, RATE: 0, FieldPoint(0, 0.2, 3): 0}),
    "as smooth as a rate of moments wants it": (
        COMMON % "forces: {push: {at: aside, force: 1 N*(1 - cos(30*t/(1 s)))}}",
        {MOMENT: 0, FieldPoint(1, 0.0, 2, 1): 0, FieldPoint(1, 0.0, 0, 2): 0}),
    "thrown with a drag that differs": (
        COMMON.replace("length: L", UNEVEN).replace("DRAG", "1 N*s/m^2") % "initial: {arm.u': 1 mm/s*x*(L - x)/L^2}",
        {ASIDE: 0, MID: 0, MOMENT: 0}),
}
FEW, MORE = 8, 24
TIMES = np.linspace(0.0, 0.6, 25)
pytestmark = pytest.mark.usefixtures("modes_found_once")


@pytest.mark.sweep
@pytest.mark.parametrize("kind", SCENES)
def test_what_is_left_out_is_bounded_and_not_by_far_more_than_it_is(kind):
    text, begins = SCENES[kind]
    scene = problem(text)
    response = DampedModalResponse(scene)
    few, more = response.motion(FEW), response.motion(MORE)
    for place, begin in begins.items():
        output = LinearOutput(places={place: 1.0})
        assert not few.is_estimated(output)
        off = np.abs(few.values(output, TIMES) - more.values(output, TIMES))
        off[0] = abs(few.values(output, [0.0])[0] - begin)
        left = np.array([few.bound(output, t) for t in TIMES])
        assert (off <= left + more.bound(output, TIMES[-1]) * (TIMES > 0) + 1e-15).all()
        assert left.max() <= 100 * off.max()


@pytest.mark.sweep
def test_a_damped_bar_is_as_far_from_its_waves_as_is_told():
    scene = problem("""
parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
bars: {rod: {length: L, E: E, A: A, rho: rho, left: clamped, right: {c: 0.5 N*s/m}}}
points: {end: {body: rod, at: L}}
forces: {push: {at: end, force: 1 N*step(t)}}
""")
    motion, output = DampedModalResponse(scene).motion(64), LinearOutput(places={FieldPoint(0, 0.2): 1.0})
    waves = WaveResponse(scene).signal(with_places(parse("rod.u(0.2*L)"), scene.spec.members))
    off = np.abs(motion.values(output, TIMES * 7) - waves.values(TIMES * 7))
    assert off.max() <= motion.bound(output, 4.2) <= 10 * off.max()


@pytest.mark.sweep
def test_what_energies_do_not_bound_is_refused_with_a_reason():
    """As an acceleration after a step is; it ended in a TypeError."""
    motion = DampedModalResponse(problem(SCENES["step"][0])).motion(FEW)
    refusal = without_bound(motion, LinearOutput(places={FieldPoint(2, 0.0, 0, 2): 1.0}), 0.3)
    assert "too slowly or too unevenly" in refusal.message and "rise within a time" in refusal.hint


DRAGS = {"none": "", "even": "drag: 3 N*s/m^2, ", "on a part": "drag: 3 N*s/m^2, ", "overdamped": "drag: 40 N*s/m^2, "}


@pytest.mark.parametrize(("c", "drag"), [("0.7 N*s/m", "none"), ("1e-8 N*s/m", "none"), ("1e-8 N*s/m", "even"),
                                         ("1e-8 N*s/m", "on a part"), ("0.7 N*s/m", "overdamped")])
def test_energies_of_modes_are_those_of_their_fields(c, drag):
    text = PINNED.replace("DAMPER", c).replace("mass", DRAGS[drag] + "mass", 1)
    if drag == "on a part":
        text = text.replace("length: L, EI: EI, drag: 3 N*s/m^2",
                            "segments: [{length: 0.6*L, drag: 3 N*s/m^2}, {length: 0.4*L, drag: 1 N*s/m^2}], EI: EI")
    modes = DampedModalResponse(problem(text % STEP)).motion(FEW).modes
    left, N, basis = modes.disturbed(()).energy, len(modes.states.rates), modes.basis
    rates = modes.states.rates + left.fading
    nodes, weights = np.polynomial.legendre.leggauss(48)
    K, M, C = np.zeros((2, N, N), complex), np.zeros((2, N, N), complex), np.zeros((2, N, N), complex)
    for side in range(2):
        other = basis.shapes.conj() if side else basis.shapes
        C[side] = other.T @ left.transfer.matrix.polynomial[1] @ basis.shapes
    for number, one in enumerate(basis.placed):
        x, w = one.piece.length * (1 + nodes) / 2, one.piece.length * weights / 2
        bent, moved = (basis.field(number, x, along) for along in (2, 0))
        for side in range(2):
            first = [part.conj() if side else part for part in (bent, moved)]
            K[side] += np.einsum("x,xi,xj->ij", w, first[0], bent)
            own = np.einsum("x,xi,xj->ij", w, first[1], moved)
            M[side], C[side] = M[side] + own, C[side] + one.piece.drag * own
    K += left.fading**2 * M - left.fading * C
    expected = (K[0] + np.outer(rates, rates) * M[0], K[1] + np.outer(rates.conj(), rates) * M[1])
    swings, own = left._modes(np.zeros((N, 0)), {}, np.arange(N))
    A = np.concatenate([np.eye(N), 1j * np.eye(N)], axis=1)
    found, off = energies(swings, A, swings, A, own, left._dragged.drags)
    wanted = (A.T @ expected[0] @ A + A.conj().T @ expected[1] @ A).real / 2
    assert (np.abs(found - wanted) <= off + 1e-12 * np.abs(wanted).max()).all()
    assert np.abs(off).max() <= 1e-6 * np.abs(wanted).max()


@pytest.mark.sweep
def test_what_is_left_out_fades_as_drag_of_all_does():
    motion = DampedModalResponse(problem(SCENES["dragged unevenly"][0])).motion(FEW)
    output = LinearOutput(places={ASIDE: 1.0})
    early, late = (motion.bound(output, t) for t in (1.0, 3.0))
    assert late == pytest.approx(early * np.exp(-0.5 * 2), rel=1e-12)      # δ = c/2μ of the least drag
