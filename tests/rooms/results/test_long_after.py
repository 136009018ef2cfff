"""What members come to long after their loads: against waves that are followed by hand and sums over modes whose
frequencies other roots give."""

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

from vibcli.api.values import quantity_value
from vibcli.base.errors import PhysicsError

BAR = """\
    parameters: {L: 1 m, EA: 100 N, mu: 1 kg/m, F: 5 N}
    bars: {rod: {length: L, EA: EA, mass_per_length: mu, %s}}
    points: {tip: {body: rod, at: L}}
    forces: {load: {at: tip, force: %s}}
    """
STEP = "F*step(t - 0.1 s)"
BEAM = BAR.replace("bars", "beams").replace("EA: EA", "EI: EI").replace("EA: 100 N", "EI: 100 N*m^2")


def asked(scene, text):
    found = quantity_value(scene, text)
    return float(found.value), float(found.error)


def compared(scene, exact, near=1e-14):
    for text, value in exact.items():
        found, error = asked(scene, text)
        assert abs(found - value) <= near * abs(value) + error, text
        assert error <= 2e-11 * max(abs(found), 1.0), text


def test_a_bar_repeats_itself_after_four_ways():
    """u of its end is a triangle between 0 and 2 F L/EA, the force at the clamp leaps between 0 and 2 F."""
    compared(problem(BAR % ("left: clamped", STEP)), {
        "mean(rod.u(L))": 0.05, "amplitude(rod.u(L))": 0.05, "period(rod.u(L))": 0.4,
        "rms(rod.u(L))": 0.05 * (4 / 3) ** 0.5, "mean(rod.force(0 m))": 5.0, "rms(rod.force(0 m))": 50**0.5,
        "rms(rod.u(L) - rod.u(L))": 0.0})


@pytest.mark.sweep
def test_a_pulse_runs_to_and_fro_in_a_free_bar():
    """Of 0.07 s each way through 0.3 m the 0.01 s are nothing in which both are there."""
    scene = problem(BAR.replace(", %s}", "}") % "F*(step(t) - step(t - 0.07 s))")
    compared(scene, {"rms(rod.force(0.3 m))": 5 * 0.6**0.5, "amplitude(rod.force(0.3 m))": 5.0,
                     "mean(rod.u'(L))": 0.35})
    for text, refusal in (("mean(rod.u(L))", "moves on without end"), ("final(rod.u'(L))", "does not die out")):
        with pytest.raises(PhysicsError, match=refusal):
            asked(scene, text)


def test_what_is_infinite_for_an_instant_has_no_mean_square():
    """A blow on what has no mass runs to and fro as a leap, whose slope is 0 but for instants."""
    scene = problem(BAR % ("left: clamped", "F*impulse(t)*(1 s)"))
    compared(scene, {"mean(rod.force(L/2))": 0.0})
    with pytest.raises(PhysicsError, match="infinite for an instant"):
        asked(scene, "rms(rod.force(L/2))")


@pytest.mark.sweep
def test_what_nothing_holds_may_come_to_stand_elsewhere():
    """F for 1 s and −F for 1 s more move a free bar of 1 kg by F T²/m; one let go at rest stays where it is."""
    loads = "F*(step(t) - 2*step(t - 1 s) + step(t - 2 s))"
    compared(problem(BAR.replace(", %s}", "}") % loads), {"mean(rod.u(0.3 m))": 5.0})
    stretched = BAR.replace(", %s}", "}") % "0*F" + "initial: {rod.u: 0.01*x}\n"
    compared(problem(stretched), {"mean(rod.u(L))": 0.005, "mean(rod.u(0.2 m))": 0.005})


@pytest.mark.sweep
def test_what_nothing_holds_carries_its_load_in_the_mean():
    """A free bar pulled by F at its end is pulled by F x/L at x; what does not see it move on has a mean too, as beside
    another that flies away; a free beam pushed in its middle bends by F L/8 there."""
    scene = problem(BAR.replace(", %s}", "}") % STEP)
    compared(scene, {"mean(rod.force(0.3 m))": 1.5, "rms(rod.force(L/2))": 12.5**0.5}, 1e-13)
    compared(scene, {"abs(frf[rod.force(0.3 m), load](0 Hz))": 0.3}, 1e-13)
    with pytest.raises(PhysicsError, match="a steady input drives a motion that nothing holds"):
        asked(scene, "abs(frf[rod.u(0.3 m), load](0 Hz))")
    compared(scene, {"mean(rod.u(L) - rod.u(0 m))": 0.025}, 1e-13)
    with pytest.raises(PhysicsError, match="nothing holds"):
        asked(scene, "mean(rod.u(L))")
    pulse = problem(BAR.replace(", %s}", "}") % "F*(step(t) - step(t - 0.07 s))")
    compared(pulse, {"mean(rod.u(L) - rod.u(0 m))": 0.0})
    balanced = problem(BAR.replace(", %s}", "}").replace("at: L}}", "at: L}, root: {body: rod, at: 0 m}}").replace(
        "%s}}", "%s}, back: {at: root, force: -%s}}") % (STEP, STEP))
    compared(balanced, {"mean(rod.u(L) - rod.u(0 m))": 0.05})
    other = "rod: {length: L, EA: EA, mass_per_length: mu, left: clamped}, other: {length: 0.6*L, EA: EA, " \
        "mass_per_length: mu}"
    beside = problem(BAR.replace("rod: {length: L, EA: EA, mass_per_length: mu, %s}", other) % STEP)
    compared(beside, {"mean(rod.u(L))": 0.05, "amplitude(rod.u(L))": 0.05})
    compared(beside, {"mean(other.u(L/5))": 0.0})
    beam = problem((BEAM.replace(", %s}", "}") % STEP).replace("at: L}", "at: L/2}"))
    compared(beam, {"mean(rod.moment(L/2))": -0.625}, 1e-13)


@pytest.mark.sweep
def test_a_bar_with_a_mass_has_no_common_period():
    """βL tan βL = μL/m, a = 2 F sin²βL/(EA β (βL + sin βL cos βL))."""
    scene = problem(BAR % ("left: clamped, attached: [{at: L, mass: 0.7 kg}]", STEP))
    beta = np.array([brentq(lambda b: b * np.sin(b) - np.cos(b) / 0.7, k * np.pi, (k + 0.5) * np.pi, xtol=1e-14)
                     for k in range(300)])
    sizes = 2 * 0.05 * np.sin(beta) ** 2 / (beta * (beta + np.sin(beta) * np.cos(beta)))
    assert sizes.sum() == pytest.approx(0.05, rel=1e-5)
    compared(scene, {"mean(rod.u(L))": 0.05, "rms(rod.u(L))": (0.05**2 + (sizes**2).sum() / 2) ** 0.5}, 1e-11)
    for least in (scene, problem(BAR % ("left: clamped, attached: [{at: L, mass: 1e-4 kg}]", STEP))):
        with pytest.raises(PhysicsError, match="no common period"):
            asked(least, "amplitude(rod.u(L))")
    with pytest.raises(PhysicsError, match="does not die out"):
        asked(scene, "final(rod.u(L))")


def test_a_beam_swings_about_its_deflection():
    """Each mode of a cantilever by a = 4 F/(μ L ω²)."""
    roots = np.array([brentq(lambda b: np.cos(b) + 1 / np.cosh(b), (k + 0.3) * np.pi, (k + 0.7) * np.pi, xtol=1e-14)
                      for k in range(30)])
    square = ((4 * 5 / (100 * roots**4)) ** 2).sum() / 2
    compared(problem(BEAM % ("left: clamped", STEP)), {
        "mean(rod.u(L))": 1 / 60, "rms(rod.u(L))": (1 / 3600 + square) ** 0.5, "mean(rod.moment(0 m))": 5.0}, 1e-13)


@pytest.mark.sweep
@pytest.mark.parametrize("scene", [BAR % ("left: clamped, right: {c: 7 N*s/m}", STEP),
                                   BAR % ("left: clamped, drag: 3 N*s/m^2", STEP),
                                   BAR % ("left: clamped", STEP) + "damping: {modal: 2 %}\n"])
def test_what_is_damped_comes_to_the_static_deflection(scene):
    found = problem(scene)
    compared(found, {"final(rod.u(L))": 0.05, "final(rod.u(L) - 3*rod.u(L/2))": -0.025, "final(rod.force(0 m))": 5.0,
                     "final(rod.u(L)*rod.force(0 m))": 0.25})
    with pytest.raises(PhysicsError, match="comes to rest"):
        asked(found, "mean(rod.u(L))")


@pytest.mark.sweep
def test_what_a_damper_in_a_node_does_not_see_vibrates_on():
    """Of a bar between walls every other mode has a node in the middle."""
    scene = problem((BAR % ("left: clamped, right: clamped, attached: [{at: L/2, c: 17 N*s/m}]", STEP)).replace(
        "at: L}}", "at: L/4}}"))
    compared(scene, {"final(rod.u(L/2))": 1 / 160, "mean(rod.u(L/4))": 3 / 320})
    with pytest.raises(PhysicsError, match="does not die out"):
        asked(scene, "final(rod.u(L/4))")
    with pytest.raises(PhysicsError, match="some of what vibrates dies out"):
        asked(scene, "rms(rod.u(L/4))")


@pytest.mark.sweep
def test_what_nothing_moves_any_more_has_a_limit():
    """A pulse as long as a wave needs there and back leaves a bar at rest, as no load does."""
    compared(problem(BAR % ("left: clamped", "F*(step(t) - step(t - 0.4 s))")), {"final(rod.u(L))": 0.0})
    compared(problem(BAR % ("left: clamped", "0*F")), {"final(rod.u(L/2))": 0.0})


@pytest.mark.sweep
def test_what_grows_has_neither_limit_nor_mean():
    scene = problem(BAR % ("left: clamped, right: {c: -3 N*s/m}", STEP))
    for text in ("final(rod.u(L))", "mean(rod.u(L))"):
        with pytest.raises(PhysicsError, match="grows without end"):
            asked(scene, text)
    far_up = "left: clamped, right: {c: 1 N*s/m}, attached: [{at: L/100, c: -1.2 N*s/m}]"     # mode 50
    with pytest.raises(PhysicsError, match="a damper drives"):
        asked(problem(BAR % (far_up, STEP)), "mean(rod.u(L))")
    scene = problem(BEAM % ("left: clamped, preload: -250 N", STEP))
    with pytest.raises(PhysicsError, match="free motion grows"):
        asked(scene, "mean(rod.u(L))")


@pytest.mark.sweep
def test_what_dies_out_ever_more_slowly_is_not_said_to_vibrate_on():
    """A dashpot at a body damps every mode of the bar that it ends, those far up hardly."""
    scene = problem("""\
        bodies: {c: {mass: 1 kg, slide: x}}
        bars: {rod: {length: 1 m, EA: 5 kN, mass_per_length: 1 kg/m, left: clamped, right: {pinned: c}}}
        dampers: {d: {between: [ground, c], c: 30 N*s/m}}
        forces: {f: {at: c, force: 1 N*step(t)}}
        """)
    with pytest.raises(PhysicsError, match="whether it has a limit is not told"):
        asked(scene, "final(x)")
