"""Families of scenes that one knob makes ever harder: no error exceeds its bound, and one that did would be seen."""

from functools import cache
from importlib import import_module
from math import inf

import pytest

from vibcli.base.errors import PhysicsError
from vibcli.evidence.stress import claims, point, shaken, supported, sweep, told
from vibcli.evidence.stress.claims import Claim
from vibcli.evidence.stress.families import FAMILIES
from vibcli.evidence.stress.figures import figures
from vibcli.evidence.stress.point import BROKEN, ESCALATED, HELD, REFUSED, UNKNOWN, measured
from vibcli.evidence.stress.read_again import read_again
from vibcli.evidence.stress.watched import scene_problem
from vibcli.language.document.mapping import document_of

LONG = ("two_pendulums", "wide_swing")
kept = cache(measured)      # points that several tests look at


def family(name):
    return import_module(f"vibcli.evidence.stress.families.{name}").FAMILY


@pytest.mark.parametrize("name", FAMILIES)
def test_the_ends_of_a_family_are_held(name):
    values = family(name).values[:3:2] if name == "two_pendulums" else family(name).values
    found = [kept(family(name), knob) for knob in (values[0], values[len(values) // 2], values[-1])]
    assert all(one.verdict in (HELD, ESCALATED) and one.error <= one.bound for one in found)
    assert max(one.bound for one in found) <= (1e-4 if name in LONG else 1e-10)


@pytest.mark.sweep
def test_all_families_are_held_and_few_bounds_are_idle(monkeypatch):
    monkeypatch.setattr(sweep, "measured", kept)
    counts = sweep.counts(sweep.solved(name for name in FAMILIES if name != "two_pendulums"))
    total = sum(counts.values()) - counts["idle"]
    assert total >= 190 and BROKEN not in counts and UNKNOWN not in counts and REFUSED not in counts
    assert counts["idle"] <= 0.05 * total and counts[ESCALATED] >= 50


@pytest.mark.sweep
@pytest.mark.parametrize(("name", "knob", "least"), [
    ("stiffness_ratio", "1e16", 0.1), ("damping_ratio", "1e8", 0.1), ("buckling", "1e-14", 1e-3),
    ("detuning", "1e-12", 1e-6), ("gyroscopic", "1e8", 1e-3), ("double_eigenvalue", "0", 1e-10)])
def test_the_plain_method_loses_its_digits_where_ours_holds(name, knob, least):
    found = kept(family(name), knob)
    assert found.plain > least and found.error <= found.bound < 2e-12


def test_a_bound_that_is_too_small_is_broken_and_one_that_is_too_large_idle(monkeypatch):
    plain = claims.measure
    monkeypatch.setattr(claims, "measure", lambda *args: (plain(*args)[0], 1e-20))
    assert measured(family("long_times"), "1e4").verdict == BROKEN
    monkeypatch.setattr(claims, "measure", lambda *args: (plain(*args)[0], 1e-3))
    found = measured(family("long_times"), "1e4")
    assert found.verdict == HELD and found.idle


def test_a_mode_that_is_lost_is_broken(monkeypatch):
    monkeypatch.setattr(point, "claims", lambda problem, subject: claims._beside(
        [(complex(0, mode.omega), mode.error) for mode in problem.modal.modes][1:], subject.true))
    assert measured(family("stiffness_ratio"), "1e2").verdict == BROKEN


def test_what_is_no_number_is_worst_and_broken(monkeypatch):
    assert max(Claim(2.0, 1.0), Claim(float("nan"), 1.0), key=Claim.ratio).bound == 1.0
    monkeypatch.setattr(point, "claims", lambda *_: [Claim(0.0, 1.0), Claim(float("nan"), 1.0)])
    assert measured(family("mass_ratio"), "1e0").verdict == BROKEN


def test_a_refusal_is_told_with_its_reason(monkeypatch):
    def refuse(*_):
        raise PhysicsError("no answer")

    monkeypatch.setattr(point, "claims", refuse)
    found = measured(family("mass_ratio"), "1e0")
    assert (found.verdict, found.why, found.error) == (REFUSED, "no answer", None)


def test_why_the_plain_method_has_no_answer_is_told():
    def refuse(_):
        raise ValueError("no such matrix")

    one = family("mass_ratio")._replace(plain=refuse)
    found = measured(one, "1e0")
    assert (found.verdict, found.plain, found.plain_why) == (HELD, inf, "ValueError: no such matrix")
    said = told.section(sweep.FamilyPoints("mass_ratio", one, [found, found._replace(knob="1e1")]))
    assert "plain at 1e0, 1e1: ValueError: no such matrix" in str(said)


def test_more_digits_are_seen_to_be_taken():
    for knob, taken in (("1e-1", False), ("1e-9", True)):
        problem, more = scene_problem(family("close_modes").scene(knob))
        claims.measure(problem, problem.spec.answers[0].asked.tree)
        assert more() == taken


SCENE = {"parameters": {"m": "2.00 kg", "k": "800 N/m", "c": "8 N*s/m", "a": "1.25 cm"},
         "bodies": {"one": {"mass": "m", "slide": "x"}, "two": {"mass": "2*m", "slide": "y"}},
         "springs": {"s": {"k": "k", "between": ["ground", "one"]}, "t": {"k": "k", "between": ["one", "two"]}},
         "dampers": {"d": {"c": "c", "between": ["ground", "one"]}}, "initial": {"x": "a"},
         "answers": {"omega[1]": "1 rad/s", "x(1 s)": "1 cm", "stable": "true", "T": "m*x'^2/2 + m*y'^2"}}


def test_a_scene_that_is_shaken_keeps_every_bit_of_its_modes():
    found = list(shaken.shaken(scene_problem(SCENE)[0]))
    assert [one.verdict for one in found] == [shaken.EQUAL] * 7 and {one.compared for one in found} == {4}


@pytest.mark.sweep
def test_of_many_coordinates_they_stay_within_their_bounds():
    found = list(shaken.shaken(scene_problem(family("many_coordinates").scene("50"))[0]))
    assert [one.verdict for one in found[:4]] == [shaken.EQUAL] * 4
    assert {one.verdict for one in found} == {shaken.EQUAL, shaken.WITHIN} and max(one.apart for one in found) <= 1


@pytest.mark.parametrize("law", [
    shaken.Rewriting("a wrong rate", shaken._weighed(1, 2, 4), 3, True),
    shaken.Rewriting("another mass", shaken._weighed(2, 1, 1), 1, False),
    shaken.Rewriting("a spring lost", lambda elements: elements.with_parts(
        springs=elements.springs[1:], rational_rows=None), 1, False)])
def test_a_law_that_does_not_hold_is_broken(law, monkeypatch):
    monkeypatch.setattr(shaken, "LAWS", (law,))
    one, = shaken.shaken(scene_problem(SCENE)[0])
    assert one.verdict == shaken.BROKEN


def scene_read_again(scene):
    """(problem, top of its document, what makes the scene of a document that is changed)."""
    top, remade = read_again(document_of(scene)[0], "scene", {}, None)
    return remade(lambda same: same), top, remade


def test_digits_that_the_data_support():
    """ω ~ √(k/m): half of 0.005/2 and of 0.5/800; x ~ a besides."""
    omega, x = supported.supported(*scene_read_again(SCENE))
    assert omega.asked == "omega[1]" and omega.parameter == "m"
    assert 10**-omega.digits == pytest.approx(0.5 * 0.005 / 2 + 0.5 * 0.5 / 800, rel=2e-3)
    assert x.digits < omega.digits


def test_rounding_takes_no_digits():
    """ω√(m/k) = 1, whatever m and k are."""
    scene = {"parameters": {"m": "2.17 kg", "k": "811 N/m"}, "bodies": {"b": {"mass": "m", "slide": "x"}},
             "springs": {"s": {"k": "k", "between": ["ground", "b"]}},
             "answers": {"omega[1]*sqrt(m/k)": "1", "omega[1]^2 - k/m": "0 rad^2/s^2"}}
    assert [one.digits for one in supported.supported(*scene_read_again(scene))] == [None, None]


def test_figures_that_stand_in_elements_are_moved_too():
    """ω = √(k/m) of m = 4.00 kg: half of 0.005/4; what is drawn takes nothing; those of answers are no data."""
    scene = {"bodies": {"b": {"mass": "4.00 kg", "slide": {"by": "x"}, "at": ["0.125 m", "0 m"]}},
             "springs": {"s": {"k": "80 N/m", "between": [["0 m", "0 m"], "b"]}},
             "answers": {"omega[1]": "4.472 rad/s"}}
    omega, = supported.supported(*scene_read_again(scene))
    assert omega.parameter == "4.00 of bodies.b" and 10**-omega.digits == pytest.approx(0.005 / 8, rel=2e-3)
    assert [one.told for one in figures(document_of(scene)[0])] == ["4.00 of bodies.b", "0.125 of bodies.b"]


def test_figures_of_conditions_are_data_and_those_that_hold_each_other_are_told():
    """m = k/ω² of ω = 9.05 rad/s; p = 0.105 rad as drawn stands twice."""
    scene = {"bodies": {"b": {"mass": "m", "slide": "x"}},
             "springs": {"s": {"k": "80 N/m", "between": ["ground", "b"]}},
             "choose": {"m": "omega[1] = 9.05 rad/s"}, "answers": {"m": "0.977 kg"}}
    mass, = supported.supported(*scene_read_again(scene))
    assert mass.parameter == "9.05 of choose.m" and 10**-mass.digits == pytest.approx(2 * 0.005 / 9.05, rel=2e-3)
    scene = {"coordinates": {"p": "a turn", "q": {"about": "another", "drawn": "0.105 rad"}},
             "bodies": {"a": {"inertia": "0.35 kg*m^2", "turn": "p"}, "b": {"inertia": "2 kg*m^2", "turn": "q"}},
             "springs": {"s": {"torsion": "91.5 N*m", "between": ["ground", "a"]}},
             "constraints": {"gear": {"equation": "q = 2*p + 0.105 rad"}}, "answers": {"omega[1]": "3.31 rad/s"}}
    omega, = supported.supported(*scene_read_again(scene))
    assert omega.held == ("0.105 of coordinates.q", "0.105 of constraints.gear")
    assert omega.parameter == "91.5 of springs.s"
    said = str(told.scene_sections([], [omega], {})[1])
    assert "Not moved, since nothing fits together with it alone: 0.105 of coordinates.q and 0.105 of cons" in said


def test_data_of_few_digits_are_exact():
    exact = {**SCENE, "parameters": {"m": "2 kg", "k": "0.8 N/mm", "c": "8 N*s/m", "a": "1 cm"}}
    assert [one.digits for one in supported.supported(*scene_read_again(exact))] == [None, None]
