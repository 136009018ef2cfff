"""Finite elements of members in time, as ours are compared with: beside closed forms, which they come nearer to with
more elements, modes and steps."""

import math
from itertools import pairwise

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.evidence import meshed_members
from vibcli.evidence.meshed_members import members_in_time
from vibcli.evidence.methods import elements_in_time
from vibcli.evidence.reference import member_poles
from vibcli.evidence.reference.settled import TrueValues, relative_error
from vibcli.evidence.subject import Deadline, Subject

BEAM = """
beams: {bridge: {length: 3 m, EI: 40 kN*m^2, mass_per_length: 12 kg/m, left: pinned, right: pinned%s}}
points: {middle: {body: bridge, at: 1.5 m}}
%s
find: [{response: {of: [bridge.u(1.5 m)], until: 200 ms}}]
"""
BAR = """
bodies: {wall: {mass: 1 kg, slide: (1 mm)*sin((450 rad/s)*t)^2}}
bars: {rod: {length: 1 m, EA: 1 MN, mass_per_length: 4 kg/m, left: {clamped: wall}}}
find: [{response: {of: [rod.u(0.5 m)], until: 7 ms}}]
"""
FIELD = "initial: {bridge.u: '(1 mm)*sin(pi*x/(3 m))'}"
SPREAD = "forces: {snow: {body: bridge, per_length: 240 N/m*sin(pi*x/(3 m))*cos((50 rad/s)*t)}}"
OMEGA = (math.pi / 3) ** 2 * math.sqrt(40000 / 12)


def turned(t, rate=0.0):
    """cos ω t of the first mode, as drag damps it."""
    slow = math.sqrt(OMEGA**2 - rate**2)
    return math.exp(-rate * t) * (math.cos(slow * t) + rate / slow * math.sin(slow * t))


def pushed(t):
    """Under the load along it, which has the shape of the first mode."""
    return 20 / (OMEGA**2 - 2500) * (math.cos(50 * t) - math.cos(OMEGA * t))


@pytest.fixture
def coarse(monkeypatch):
    """Few elements, which show as much."""
    for module, name, value in ((elements_in_time, "DIVISIONS", (2, 4, 8)), (elements_in_time, "FINEST", 8),
                                (elements_in_time, "STEPPED", (8,)), (elements_in_time, "STEPS", (100, 1000)),
                                (elements_in_time, "FEW", (1, 4)), (elements_in_time, "SAMPLES", 401),
                                (member_poles, "BLOCK", 4), (meshed_members, "DIGITS", 30)):
        monkeypatch.setattr(module, name, value)


def test_one_element_between_two_supports_has_no_answer_and_says_so(coarse, monkeypatch):
    monkeypatch.setattr(elements_in_time, "DIVISIONS", (1,))
    monkeypatch.setattr(elements_in_time, "STEPPED", (1,))
    monkeypatch.setattr(elements_in_time, "FINEST", 1)
    asked = members_in_time(problem("""
        strings: {s: {length: 1 m, preload: 80 N, mass_per_length: 5 g/m, left: clamped, right: clamped}}
        initial: {s.u: "(1 mm)*sin(pi*x/(1 m))"}
        find: [{response: {of: [s.u(0.5 m)], until: 7 ms}}]
        """), "s.u(0.5 m)", 0.007, "value")
    runs = list(elements_in_time.attempts(Subject("member motion", "", "", None, None, None, asked, None)))
    assert len(runs) == 5
    for one in runs:
        with pytest.raises(PhysicsError, match="no displacement is free"):
            one.run(Deadline(math.inf))


def errors(text, name, until, feature, exact):
    """{method: [error of each setting]}"""
    true = TrueValues([mpmath.mpf(exact)], 16, 16, 16)
    subject = Subject("member motion", "", "", None, true, None, members_in_time(problem(text), name, until, feature),
                      None)
    found = {}
    for one in elements_in_time.attempts(subject):
        found.setdefault(one.method, []).append(relative_error(one.run(Deadline(math.inf)).values, true))
    return list(found.values())


@pytest.mark.sweep
@pytest.mark.parametrize(("more", "rest", "name", "exact"), [
    ("", FIELD, "bridge.u(1.5 m)", turned(0.07) / 1000),
    ("", FIELD, "bridge.moment(1.5 m)", -40 * turned(0.07) * (math.pi / 3) ** 2),
    (", drag: 60 N*s/m^2", FIELD, "bridge.u(0.75 m)", turned(0.07, 2.5) / 1000 / math.sqrt(2)),
    ("", FIELD + "\ndamping: {proportional: [5 s^-1, 0 s]}", "bridge.u(1.5 m)", turned(0.07, 2.5) / 1000),
    ("", SPREAD, "bridge.u(1.5 m)", pushed(0.07))])
def test_of_beams(coarse, more, rest, name, exact):
    """Cubics are off by the fourth power of their length, their bending by its square, Newmark's steps by their
    square."""
    elements, few, (slow, fine) = errors(BEAM % (more, rest), name, 0.07, "value", exact)
    falls = 3 if "moment" in name else 10
    assert all(two < one / falls for one, two in pairwise(elements)) and elements[-1] < 2e-2 / falls
    assert abs(fine - elements[-1]) < abs(slow - elements[-1]) / 30 and max(few) < 3e-2




def test_of_a_bar_on_a_wall_that_moves(coarse):
    """What comes from the wall is there after l/c = 2 ms: until the wave is back from the end it is what the wall
    was."""
    elements, *_ = errors(BAR, "rod.u(0.5 m)", 0.0025, "max", 1e-3 * math.sin(450 * 0.0015) ** 2)
    assert elements[-1] < elements[0] / 4 < 2e-2


def test_a_wall_that_jumps_is_no_load():
    members = members_in_time(problem(BAR.replace("sin((450 rad/s)*t)^2", "step(t - 1 ms)")), "rod.u(0.5 m)", 0.002,
                              "value").members
    assert meshed_members.in_motion(members, 2) is None
