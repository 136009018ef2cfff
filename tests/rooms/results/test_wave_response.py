"""Motions in time of scenes with bars, shafts and strings, against waves that are followed by hand."""

from textwrap import dedent

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.wave_response import WaveResponse
from vibcli.symbolic.parser import parse

UNIT = "parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}\n"
BAR = UNIT + dedent("""\
    bars:
      rod: {length: L, E: E, A: A, rho: rho, left: clamped, RIGHT}
    points: {tip: {body: rod, at: L}}
    forces: {pull: {at: tip, force: 1 N}}
    initial: {released: pull}
""")


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


def values(scene, text, times):
    return signal(scene, text).values(np.asarray(times, float))


def test_mass_equal_to_that_of_the_bar():
    scene = problem(BAR.replace("RIGHT", "attached: [{at: L, mass: rho*A*L}]"))
    assert isinstance(scene.response, WaveResponse)
    tau = np.linspace(0, 2, 101)
    assert np.abs(values(scene, "rod.u(L)", tau) - (2 - tau - np.exp(-tau))).max() <= 1e-13
    later = np.linspace(1, 3, 101)
    for text in ("rod.force(0)", "rod.stress(0)"):
        assert np.abs(values(scene, text, later) - (2 * np.exp(1 - later) - 1)).max() <= 1e-13
    assert values(scene, "rod.u'(L)", [1.0]) == pytest.approx([np.exp(-1) - 1], abs=1e-13)
    assert values(scene, "rod.force(L)*rod.u'(L)", [1.0]) == pytest.approx([np.exp(-1) * (np.exp(-1) - 1)], abs=1e-13)
    assert signal(scene, "rod.force(0)").error(3.0) < 1e-13


def at_rest(more, load):
    """A bar whose free end is pushed at t = 0."""
    return problem(UNIT + dedent(f"""\
        bars: {{rod: {{length: L, E: E, A: A, rho: rho, left: clamped{more}}}}}
        points: {{tip: {{body: rod, at: L}}}}
        forces: {{push: {{at: tip, force: {load}}}}}
        """))


@pytest.mark.sweep
def test_what_rests_at_zero_has_one_zero_as_it_leaves():
    pulse = "1 N*(step(t) - step(t - 0.3 s))"
    waves = at_rest("", pulse)
    assert signal(waves, "rod.u(L/2)").zeros(0.0, 5.0) == pytest.approx([0.5, 2.5, 4.5])
    assert signal(waves, "rod.u'(L/2)").zeros(0.0, 5.0) == pytest.approx([0.5, 1.5, 2.5, 3.5, 4.5])
    assert signal(at_rest("", "1 N*s*impulse(t)"), "rod.u(L/2)").zeros(0.0, 5.0) == pytest.approx([0.5, 2.5, 4.5])
    modes = at_rest(", drag: 1e-3 kg/m/s", pulse)
    few = ModalSignal(modes.response.motion(64), signal(modes, "rod.u(L/2)").reads)
    assert few.zeros(0.0, 2.7) == pytest.approx([0.5, 2.5], abs=1e-2)


def test_a_blow_that_is_never_swallowed_leaves_no_limit():
    tip = signal(at_rest("", "1 N*s*impulse(t)"), "rod.u(L/2)")
    with pytest.raises(PhysicsError, match="limit"):
        tip.final()
    swallowed = signal(at_rest(", right: {c: A*sqrt(E*rho)}", "1 N*s*impulse(t)"), "rod.u(L/2)")
    assert (swallowed.final(), swallowed.waves.still_from(5.0)) == (0.0, 2.0)


def test_free_end_leaves_a_rectangle():
    """The strain is 1 until the wave from the end is there, then −1, then 1 (period 4)."""
    scene = problem(BAR.replace("RIGHT", "right: free"))
    force = signal(scene, "rod.force(0.25*L)")
    assert force.values(np.array([0.7, 0.75, 1.2, 1.25, 2.7, 3.3])) == pytest.approx([1.0, 0.0, 0.0, -1.0, -1.0, 1.0],
                                                                                     abs=1e-15)
    assert force.values_before(np.array([0.75, 1.25])) == pytest.approx([1.0, 0.0], abs=1e-15)
    assert [t for t, *_ in force.leaps(4.0)] == pytest.approx([0.75, 1.25, 2.75, 3.25])
    assert force.extreme(0.0, 4.0, -1) == pytest.approx((1.25, -1.0))
    assert signal(scene, "rod.u(L)").zeros(0.0, 4.0) == pytest.approx([1.0, 3.0])
    product = signal(scene, "rod.force(0)*rod.u(L)")
    assert product.extreme(0.0, 4.0, 1) == pytest.approx((0.0, 1.0))
    assert product.zeros(0.0, 1.5) == pytest.approx([1.0])


@pytest.mark.sweep
def test_bar_of_two_sections_between_driven_base_and_free_end():
    """Base 0.01 m·sin 2t: behind the step of section the wave is 2Z₁/(Z₁ + Z₂) of what arrives."""
    scene = problem(UNIT + dedent("""\
        bodies: {base: {slide: 0.01 m*sin(2 s^-1*t)}}
        bars:
          rod:
            segments: [{length: L, A: A}, {length: L, A: 3*A}]
            E: E
            rho: rho
            left: {clamped: base}
    """))
    times = np.array([0.5, 1.2, 1.9, 2.5])
    run = 0.01 * np.sin(2 * np.maximum(times - 1, 0)) * 2 / 4
    assert values(scene, "rod.u(L)", times[:3]) == pytest.approx(run[:3], abs=1e-16)
    assert values(scene, "rod.u(2*L)", times) == pytest.approx(
        0.01 * np.where(times > 2, np.sin(2 * (times - 2)), 0), abs=1e-16)
    assert values(scene, "rod.u(0)", times) == pytest.approx(0.01 * np.sin(2 * times), abs=1e-16)


@pytest.mark.sweep
def test_shaft_that_carries_discs_and_an_oscillator_keeps_its_angular_momentum():
    scene = problem("""\
        parameters: {L: 1 m, M: 5 N*m, T: 0.5 s}
        bodies: {disc: {inertia: 2 kg*m^2, turn: phi}}
        shafts:
          line: {length: L, GIo: 4 N*m^2, inertia_per_length: 1 kg*m, left: {clamped: disc}, attached: [
            {at: L/3, oscillator: {inertia: 0.4 kg*m^2, torsion: 30 N*m, c: 0.2 N*m*s}}, {at: L, inertia: 1 kg*m^2}]}
        forces: {drive: {body: disc, moment: M*(1 - step(t - T))}}
        """)
    t = 3.7
    x, w = np.polynomial.legendre.leggauss(200)
    places = (x + 1) / 2
    along = sum(weight / 2 * values(scene, f"line.phi'({place:.17g} m)", [t])[0]
                for place, weight in zip(places, w, strict=True))
    lumped = (2 * values(scene, "phi'", [t])[0] + values(scene, "line.phi'(L)", [t])[0]
              + 0.4 * scene.response.alone.march.coordinates[scene.scene.coordinates.index(
                  "line.oscillator(L/3)")].at(np.array([t]), 1)[0])
    assert along + lumped == pytest.approx(5 * 0.5, rel=1e-5)


def test_beams_are_not_followed_by_waves():
    scene = problem("""\
        beams: {wing: {length: 1 m, EI: 1 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
        find: [{response: {of: [wing.u(1 m)], until: 1 s}}]
        """)
    assert not isinstance(scene.response, WaveResponse)
    with pytest.raises(NotByWaves, match="beams disperse"):
        WaveResponse(scene).alone  # noqa: B018


def test_a_blow_on_what_has_no_mass_makes_slopes_infinite():
    scene = problem("""\
        parameters: {L: 1 m, p: 1 N*s}
        strings: {cord: {length: L, preload: 1 N, mass_per_length: 1 kg/m, left: clamped, right: clamped}}
        points: {mid: {body: cord, at: L/2}}
        forces: {blow: {at: mid, force: p*impulse(t)}}
        """)
    assert values(scene, "cord.u(L/4)", [0.2, 0.3, 0.7, 0.8]) == pytest.approx([0.0, 0.5, 0.5, 0.0], abs=1e-15)
    assert values(scene, "cord.slope(0)", [0.2, 0.7]) == pytest.approx([0.0, 0.0], abs=1e-15)
    with pytest.raises(PhysicsError, match=r"infinite for an instant, at t = 0\.5 s"):
        signal(scene, "cord.slope(0)").extreme(0.0, 2.0, 1)
    with pytest.raises(PhysicsError, match="infinite for an instant"):
        signal(scene, "cord.slope(0)").error(0.5)
    with pytest.raises(PhysicsError, match="infinite for an instant"):
        signal(scene, "cord.slope(0)").sampled(np.linspace(0, 1, 4))


PLUCKED = """\
    parameters: {L: 1 m, N: 100 N, mu: 10 g/m, h: 3 mm, a: 0.3 m}
    strings: {cord: {length: L, preload: N, mass_per_length: mu, left: clamped, right: clamped}}
    initial: {cord.u: "h*min(x/a, (L - x)/(L - a))"}
    """


def test_string_that_is_plucked_where_nothing_stands():
    scene, c = problem(PLUCKED), 100.0
    times = np.linspace(0, 0.05, 200)

    def odd(x):
        x = np.mod(x + 1, 2) - 1
        return 0.003 * np.sign(x) * np.minimum(np.abs(x) / 0.3, (1 - np.abs(x)) / 0.7)

    for text, x in (("cord.u(L/2)", 0.5), ("cord.u(0.9*L)", 0.9)):
        assert np.abs(values(scene, text, times) - (odd(x - c * times) + odd(x + c * times)) / 2).max() < 1e-16
    assert signal(scene, "cord.slope(0)").leaps(0.02) == [
        pytest.approx((0.003, 0.01, -0.003 / 0.7)), pytest.approx((0.017, -0.003 / 0.7, 0.01))]
    instants = scene.response.instants([signal(scene, "cord.slope(0)")], 3)
    assert signal(scene, "cord.slope(0)").sampled(instants)[1:3] == pytest.approx([0.01, -0.003 / 0.7])


@pytest.mark.sweep
def test_the_earliest_of_equal_extremes_counts():
    assert signal(problem(PLUCKED), "cord.u(L/2)").extreme(0.0, 1.0, -1) == pytest.approx((0.008, -0.003 * 5 / 7))


def test_fields_on_segments_start_from_the_equilibrium_and_carry_what_is_attached():
    scene = problem("""\
        parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3, F: 2 N}
        bars:
          rod: {segments: [{length: L/2}, {length: L/2}], E: E, A: A, rho: rho, left: clamped, attached: [
            {at: L, mass: rho*A*L}]}
        points: {tip: {body: rod, at: L}}
        forces: {held: {at: tip, force: F}}
        initial: {rod.u: 3*x}
        """)
    tau = np.linspace(0, 2, 21)
    assert values(scene, "rod.u(L)", tau) == pytest.approx(2 + (2 - tau - np.exp(-tau)), abs=1e-13)
    assert values(scene, "rod.force(0)", [0.5, 1.5]) == pytest.approx([3.0, 2 + 2 * np.exp(-0.5) - 1], abs=1e-13)
    thrown = problem("""\
        bars: {rod: {length: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3, left: clamped}}
        initial: {rod.u': -1 m/s}
        """)
    assert values(thrown, "rod.force(0)", [0.0, 1.9, 2.1]) == pytest.approx([-1.0, -1.0, 1.0])


def test_an_oscillator_starts_with_the_field_where_it_hangs():
    """What moves alike keeps moving alike, two oscillators at one place too; each spring starts as long as at rest."""
    one = "{at: L/3, oscillator: {mass: 2 kg, k: 3 N/m}}"
    scene = problem(UNIT + f"bars: {{rod: {{length: L, E: E, A: A, rho: rho, attached: [{one}, {one}]}}}}\n"
                    "initial: {rod.u: 2 mm, rod.u': 3 mm/s}\n")
    for text in ("rod.u(L)", "rod.oscillator(L/3)", "rod.oscillator.2(L/3)"):
        assert values(scene, text, [0.0, 1.7]) == pytest.approx([2e-3, 2e-3 + 1.7 * 3e-3], rel=1e-13), text
    hung = problem("gravity: 9.81 m/s^2\nbeams: {b: {from: [0 m, 0 m], to: [1 m, 0 m], EI: 90 N*m^2, left: clamped, "
                   f"mass_per_length: 1 kg/m, attached: [{one.replace('L/3', '1 m')}]}}}}\n"
                   "initial: {b.u: 1 mm*x^2/(1 m)^2}")
    start, _ = hung.initial.start
    assert start["b.u(1 m)"] == pytest.approx(1e-3) and start["b.oscillator(1 m)"] == pytest.approx(1e-3 - 2 * 9.81 / 3)


@pytest.mark.sweep
@pytest.mark.parametrize(("rate", "start"), [("0.7 m/s", 0.7), ("0.7 m/s*(1 - x/L)", 0.7), ("0 m/s", 0.0)])
def test_a_field_beside_a_support_that_the_time_moves(rate, start):
    """EA (u0' + v0/c - g'/c) at the support until its waves are back; where it starts at the field no displacement
    leaps, whatever rounding adds up to."""
    scene = problem(f"""
        parameters: {{L: 2 m, EA: 1 MN, mu: 4 kg/m, a: 1 mm, W: 700 rad/s}}
        bodies: {{base: {{mass: 8 kg, slide: a*sin(W*t)}}}}
        bars: {{rod: {{length: L, EA: EA, mass_per_length: mu, left: {{clamped: base}}}}}}
        initial: {{rod.u: a*(x/L)^2, rod.u': {rate}}}
    """)
    t, c = np.array([0.0, 1e-3, 3.9e-3]), 500.0
    v0 = start * (1 - c * t / 2 if "x" in rate else 1)
    wanted = 1e6 * (2e-3 * c * t / 4 + v0 / c - 0.7 * np.cos(700 * t) / c)
    assert np.abs(values(scene, "rod.force(0)", t) - wanted).max() <= 1e-9
    with pytest.raises(PhysicsError, match="held at 0 m, where this field"):
        values(problem(dedent("""
            parameters: {a: 1 mm}
            bodies: {base: {mass: 8 kg, slide: a*sin(7 rad/s*t)}}
            bars: {rod: {length: 2 m, EA: 1 MN, mass_per_length: 4 kg/m, left: {clamped: base}}}
            initial: {rod.u: a}
        """)), "rod.u(2 m)", t)


def test_a_matched_damper_ends_the_motion():
    scene = problem(BAR.replace("RIGHT", "right: {c: A*sqrt(E*rho)}"))
    assert scene.response.alone.still_from(5.0) == 2.0
    force = signal(scene, "rod.force(L/4)")
    assert (force.before(1.25), force.before(1.0)) == (pytest.approx(0.5), None)
    assert not force.values(np.array([1.25, 1.7, 4.9])).any()
    assert problem(BAR.replace("RIGHT", "right: {c: 2*A*sqrt(E*rho)}")).response.alone.still_from(5.0) == np.inf
    beside = BAR.replace("RIGHT}", "right: {c: A*sqrt(E*rho)}}\n  still: {length: 4*L, E: E, A: A, rho: rho}")
    assert problem(beside).response.alone.still_from(5.0) == 2.0


def test_what_never_moves_is_still_from_the_start():
    scene = problem(UNIT + "bars: {rod: {length: L, E: E, A: A, rho: rho}}\n")
    assert scene.response.alone.still_from(5.0) == 0.0


@pytest.mark.sweep
def test_a_value_behind_too_many_fronts_is_found_by_modes():
    """Far beyond the end that is asked for; β tan β = 1, u(L) = Σ EA a/L sin²β/(m ω²) cos ωt, ω = βc₀/L."""
    scene = problem("""\
        parameters: {L: 1 m, EA: 2 MN, mu: 2 kg/m, M: 2 kg, a: 1 mm}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, attached: [{at: L, mass: M}]}}
        initial: {rod.u: a*x/L}
        find: [{response: {until: 5 ms}}]
        """)
    beta = [brentq(lambda b: b * np.sin(b) - np.cos(b), n * np.pi, (n + 0.5) * np.pi, xtol=1e-15) for n in range(400)]
    beta = np.array(beta)
    m = 1 - np.sin(2 * beta) / (2 * beta) + 2 * np.sin(beta) ** 2
    share = 2e6 * 1e-3 * np.sin(beta) ** 2 / (m * (1e3 * beta) ** 2)
    known = signal(scene, "rod.u(L)").read_at(15.0)
    assert known.values(np.array([15.0])) == pytest.approx(share @ np.cos(15e3 * beta), abs=2e-11)
    assert known.error(15.0) < 1e-9 and known.KIND != signal(scene, "rod.u(L)").KIND
