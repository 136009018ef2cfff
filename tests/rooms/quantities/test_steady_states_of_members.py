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
