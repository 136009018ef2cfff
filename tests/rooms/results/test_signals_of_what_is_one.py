"""Signals that divide by a difference of what is one, or take its logarithm, are refused at their place."""

from textwrap import dedent

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import measure
from vibcli.quantities.in_letters import quantity_in_letters
from vibcli.report.sections.requested_signals import signals_asked
from vibcli.results.motion_signals import node_of
from vibcli.symbolic.parser import parse

BLOCK = dedent("""\
    parameters: {m: %s, k: %s}
    bodies: {block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, block]}}
    forces: {drive: {at: block, force: k*(1 m)*sin(3 rad/s*t)}}
    """)
SMALL = BLOCK % ("2 kg", "8 N/m")
ARM = dedent("""\
    beams: {arm: {length: 1 m, EI: 2 N*m^2, mass_per_length: 3 kg/m, left: clamped}}
    points: {tip: {body: arm, at: 1 m}}
    forces: {push: {at: tip, force: 1 N*sin(3 rad/s*t)}}
    """)
REFUSED = r"^this signal %s what is zero, or lost in rounding, all along$"
SAME = "s.stretch - x"
SCENES = [(SMALL, SAME), (SMALL + "motion: full\n", SAME), (ARM, "arm.u(1 m) - arm.u(0.99999999999999 m)")]


@pytest.mark.parametrize("text, zero", SCENES)
@pytest.mark.parametrize("signal, verb", [("1/(%s)", "divides by"), ("(%s)^(-2)", "divides by"),
                                          ("log(abs(%s)/(1 m))", "takes the logarithm of")])
def test_they_are_refused_at_their_place(text, zero, signal, verb):
    signal = signal % zero
    one = problem(text + f"find: [{{response: {{of: [{signal}], until: 1 s}}}}]\n")
    with pytest.raises(PhysicsError, match=REFUSED % verb) as refused:
        signals_asked(one)
    assert refused.value.hint == "look for a difference that vanishes"
    assert one.spec.get("find").about("response")["of"][0].where == refused.value.where is not None
    with pytest.raises(PhysicsError, match=REFUSED % verb):
        measure(one, with_places(parse(f"max({signal})"), one.spec.members))


def test_they_have_no_limit_in_letters_and_no_family_of_motions():
    letters = problem((BLOCK % ("", "")).replace("sin(3 rad/s*t)", "t/(1 s)")
                      + "dampers: {d: {c: k*(1 s), between: [ground, block]}}\n")
    with pytest.raises(PhysicsError, match=REFUSED % "divides by"):
        quantity_in_letters(letters, parse(f"final(1/({SAME}))"))
    with pytest.raises(PhysicsError, match=REFUSED % "divides by"):
        node_of(problem(SMALL), parse(f"1/({SAME})"))
