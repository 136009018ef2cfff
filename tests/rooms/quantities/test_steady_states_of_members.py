"""Steady states of members ask for no modes: D(iΩ) at the frequencies of loads tells them."""

from textwrap import dedent

import pytest
from support.scenes import problem

from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import number_of
from vibcli.symbolic.parser import parse

WAVES = dedent("""\
    parameters: {L: 1.2 m, T: 300 N, mu: 0.4 kg/m, F: 3 N, W: 7 rad/s}
    strings:
      cord: {length: L, preload: T, mass_per_length: mu, left: pinned, right: pinned}
    points: {mid: {body: cord, at: L/2}}
    forces: {f: {at: mid, force: F*cos(W*t)}}
    """)
CHAIN = dedent("""\
    parameters: {L: 2 m, mu: 3 kg/m, m: 1 kg, F: 2 N, W: 3 rad/s, g: 9.81 m/s^2}
    gravity: g
    strings: {cord: {from: [0, 0], to: [0, -L], mass_per_length: mu, left: pinned, attached: [{at: L, mass: m}]}}
    points: {mid: {body: cord, at: L/2}}
    forces: {f: {at: mid, force: [F*cos(W*t), 0]}}
    """)
BEAM = dedent("""\
    parameters: {L: 1.2 m, EI: 2.4 kN*m^2, mu: 0.4 kg/m, F: 3 N, W: 7 rad/s}
    beams:
      cord: {length: L, EI: EI, mass_per_length: mu, left: clamped, attached: [{at: L/2, c: 2 N*s/m}]}
    points: {mid: {body: cord, at: L/2}}
    forces: {f: {at: mid, force: F*cos(W*t)}}
    """)
ASKED = ("amplitude(cord.u(L))", "phase(cord.u(L/2))", "rms(cord.u(L/2))", "mean(cord.u(L/2)^2)", "period(cord.u(L/2))",
         "harmonic[1](cord.u(L/2))", "max(steady(cord.u(L/2)))", "steady(cord.u(L/2))(0.3 s)")


def number(scene, text):
    return number_of(scene, with_places(parse(text), scene.spec.members))


@pytest.mark.parametrize("scene", [WAVES, CHAIN, BEAM], ids=["waves", "chain", "beam"])
def test_no_mode_is_asked_for(scene, monkeypatch):
    def refuse(self, *asked):
        raise AssertionError(f"modes {asked} are asked for")

    monkeypatch.setattr(NaturalModes, "_found", refuse)
    one = problem(scene)
    found = [number(one, text) for text in ASKED]
    one, two, three = number(one, "amplitude(cord.u(L/2))"), found[5], found[2] * 2**0.5
    assert one == pytest.approx(two, rel=1e-12) == pytest.approx(three, rel=1e-12)
    with pytest.raises(AssertionError, match="asked"):
        number(problem(scene), "omega[1]")


def test_what_grows_has_no_steady_state():
    scene = problem(dedent("""\
        parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
        beams: {arm: {length: L, EI: EI, mass_per_length: mu, preload: -20 N, left: pinned, right: pinned}}
        points: {mid: {body: arm, at: L/2}}
        forces: {f: {at: mid, force: (1 N)*cos((2 rad/s)*t)}}
        """))
    with pytest.raises(PhysicsError, match="no steady state"):
        number(scene, "amplitude(arm.u(L/2))")


FREE = dedent("""\
    parameters: {k: 2 kN/m, m: 1 kg, L: 1 m, F: 3 N, W: 70 rad/s, A: 5 kN}
    bars:
      a: {length: L, EA: 3 kN, mass_per_length: 1 kg/m}
      b: {length: L, EA: A, mass_per_length: 1 kg/m, right: {pinned: c}}
    bodies: {c: {mass: m, slide: x}}
    points: {p: {body: a, at: L}, q: {body: b, at: 0 m}}
    springs: {s: {between: [p, q], k: k}}
    forces: {f: {at: c, force: F*(LOAD)}}
    """)


@pytest.mark.sweep
@pytest.mark.parametrize("load, damper", [("step(t)", ""), ("step(t) + cos(W*t)", "\ndampers: {d: {between: [p, q], c: "
                                          "30 N*s/m}}"), ("1 + square(W*t)", "")], ids=["step", "cosine", "square"])
def test_what_a_constant_force_drives_off_is_bent_as_it_is_drawn_along(load, damper):
    scene = problem(FREE.replace("LOAD", load).replace(", W: 70 rad/s", ", W: 70 rad/s" * ("W" in load)) + damper)
    assert number(scene, "mean(s.force)") == pytest.approx(1.0, rel=1e-11)
    assert number(scene, "mean(a.u(L) - b.u(0 m))") == pytest.approx(-1 / 2000, rel=1e-11)
    assert number(scene, "mean(2*x - 2*a.u(L))") == pytest.approx(2 * (1 / 2000 + 1.5 / 5000), rel=1e-11)
    assert number(scene, "mean(a.u'(L) - x')") == pytest.approx(0.0, abs=1e-15)
    for seen in ("a.u(L)", "x'", "x + a.u(L)"):
        with pytest.raises(PhysicsError, match="nothing holds"):
            number(scene, f"mean({seen})")
    if damper:
        square = number(scene, "rms(a.u(L) - b.u(0 m))")**2
        assert number(scene, "mean((a.u(L) - b.u(0 m))^2)") == pytest.approx(square, rel=1e-11)
        with pytest.raises(PhysicsError, match="does not cancel"):
            number(scene, "mean(x*a.u(L))")
        assert number(scene, "max(steady(s.force))") > 1
        assert number(scene, "rms(s.force)") == pytest.approx(2000 * number(scene, "rms(a.u(L) - b.u(0 m))"), rel=1e-10)


def test_the_mean_of_what_loads_keep_still_is_that():
    scene = problem(FREE.replace("LOAD", "step(t)").replace(", W: 70 rad/s", ""))
    for which in ("mean", "rms", "max"):
        assert number(scene, f"{which}(steady(s.force))") == pytest.approx(1.0, rel=1e-11)
