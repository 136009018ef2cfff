"""Static positions to many digits beside closed forms, and SciPy's roots of the same forces."""

from pathlib import Path

import mpmath
import pytest
from support.references import CLOSED_LOOP
from support.scenes import problem

from vibcli.api.source import file_source, problem_of
from vibcli.base.errors import PhysicsError
from vibcli.evidence.asked import subjects
from vibcli.evidence.compared import evidence, in_numbers
from vibcli.evidence.methods import ours, static_positions
from vibcli.evidence.subject import Deadline
from vibcli.evidence.subjects.static_positions import at_rest

PROBLEMS = Path(__file__).parents[3] / "problems"
HUNG = """
parameters: {m: 2 kg, k: 800 N/m, g: 9.81 m/s^2, M: 3 N*m, L: 0.5 m}
gravity: g
bodies:
  a: {mass: m, slide: {by: y, along: [0, 1]}, at: [0, 0]}
  rod: {shape: rod, mass: m, from: [1 m, 0], to: [1 m, -L], pin: {at: [1 m, 0], by: phi}}
springs: {s: {k: k, between: [[0, 1 m], a]}}
forces: {drive: {body: rod, moment: M}, shake: {at: a, force: [0, (5 N)*(1 - cos(9*t/(1 s)))]}}
answers: {"equilibrium[y]": 0, "equilibrium[phi]": 0, "equilibrium[s.force]": 0, "equilibrium[s.energy]": 0,
  "equilibrium[rod.reaction.y]": 0, "equilibrium[rod.reaction.x]": 0}
"""
LOOP = CLOSED_LOOP + """answers: {"equilibrium[phi]": 0, "equilibrium[pin.force.x]": 0, "equilibrium[pin.force.y]": 0,
  "equilibrium[left.reaction.y]": 0}
"""
ON_A_SLOPE = """
parameters: {m: 6 kg, R: 0.2 m, g: 10 m/s^2, k: 900 N/m}
gravity: g
surfaces: {slope: {line: [[0, 0], [4 m, 3 m]]}}
bodies:
  disc: {shape: disc, mass: m, radius: R, at: [2 m - 3/5*R, 3/2*(1 m) + 4/5*R], roll: {surface: slope, travel: x}}
springs: {s: {k: k, between: [disc, [4 m - 3/5*R, 3 m + 4/5*R]], preload: static}}
answers: {"equilibrium[disc.normal]": 48 N, "equilibrium[disc.friction]": 0, "equilibrium[ground.force.x]": 0}
"""
LOCKED = """
parameters: {a: 2 m, W: 30 N}
points: {A: [0, 0], B: [2*a, 0], C: {body: left, at: [a, a]}, D: {body: right, at: [a, a]}}
bodies:
  left: {mass: 1 kg, at: [0, a], pin: {at: A, by: phi}}
  right: {mass: 1 kg, at: [2*a, a], pin: {at: B, by: psi}}
constraints: {C: {join: [C, D]}}
forces: {wind: {at: C, force: [W, 0]}}
find: [reactions]
answers: {"equilibrium[A.reaction.x]": 0, "equilibrium[B.reaction.x]": 0, "equilibrium[B.reaction.y]": 0}
"""
PROPPED = """
parameters: {a: 2 m, m: 3 kg, g: 10 m/s^2}
gravity: g
bodies: {bar: {shape: rod, mass: m, from: [0, 0], to: [2*a, 0], pin: {at: [0, 0], by: phi}}}
points: {B: {body: bar, at: [a, 0]}, C: {body: bar, at: [2*a, 0]}}
constraints: {one: {link: [B, [a, a]]}, other: {link: [C, [2*a, a]]}}
find: [reactions]
answers: {"equilibrium[one.force]": 0}
"""


def asked(text):
    one = problem(text)
    return one, [answer.asked.tree for answer in one.spec.answers]


@pytest.mark.sweep
def test_true_positions_beside_closed_forms():
    one, trees = asked(HUNG)
    found = [at_rest(one, tree) for tree in trees]
    with mpmath.workdps(60):
        weight = 2 * mpmath.mpf("9.81")
        closed = [-weight / 800, mpmath.asin(3 / (weight / 4)), weight, weight**2 / 1600, weight, 0]
        assert all(abs(each.true.values[0] - x) < 1e-45 for each, x in zip(found, closed, strict=True))
    for each in found:
        (own,), others = ours.attempts(each), list(static_positions.attempts(each))
        answer = own.run(Deadline(60))
        assert each.error(answer.values, each.true) <= answer.bound < 1e-11
        errors = {(run.method, run.setting): each.error(run.run(Deadline(60)).values, each.true) for run in others}
        assert max(error for (_, setting), error in errors.items() if setting == "1e-12") < 1e-10
    assert {one.kind for one in subjects(one, [answer.asked for answer in one.spec.answers])} == {"static position"}


@pytest.mark.sweep
def test_a_closed_loop_beside_the_balance_of_its_energy():
    """V = 2 m g a√2 sin(β)/2 + k s²/2 with both rods at β to the level and the block at 2 a√2 cos β."""
    one, (phi, *forces) = asked(LOOP)
    found = at_rest(one, phi)
    with mpmath.workdps(60):
        a, m, k, g = mpmath.mpf("0.3"), 2, 800, mpmath.mpf("9.81")
        length, free = a * mpmath.sqrt(2), 1 - 2 * a
        beta = mpmath.findroot(lambda b: m * g * length * mpmath.cos(b) - 2 * k * length * mpmath.sin(b) * (
            free - 1 + 2 * length * mpmath.cos(b)), mpmath.pi / 4)
        assert abs(found.true.values[0] - (beta - mpmath.pi / 4)) < 1e-45
        balanced = [k * (free - 1 + 2 * length * mpmath.cos(beta)), -m * g, m * g]
        found = [at_rest(one, tree).true.values[0] for tree in forces]
        assert all(abs(x - y) < 1e-45 for x, y in zip(found, balanced, strict=True))


@pytest.mark.parametrize(("text", "balanced"), [(ON_A_SLOPE, [48, 0]), (LOCKED, [-15, -15, 15])])
def test_reactions_beside_their_balance(text, balanced):
    one, trees = asked(text)
    for tree, wanted in zip(trees, balanced, strict=False):
        found = at_rest(one, tree)
        (own,), others = ours.attempts(found), list(static_positions.attempts(found))
        answer = own.run(Deadline(60))
        assert abs(found.true.values[0] - wanted) < 1e-45
        assert found.error(answer.values, found.true) <= answer.bound < 1e-11
        assert min(found.error(run.run(Deadline(60)).values, found.true) for run in others) < 1e-11


@pytest.mark.sweep
def test_static_preloads_of_closed_loops_hold_the_drawn_position():
    one, _ = in_numbers(problem_of(file_source(str(PROBLEMS / "3_free_undamped" / "governor_linkage_at_rest.yaml"))))
    tree = next(part for answer in one.spec.answers for part in answer.asked.parts.quantities
                if part.head == "equilibrium")
    assert abs(at_rest(one, tree).true.values[0]) < 1e-45


@pytest.mark.sweep
def test_what_is_known_of_a_scene_that_is_locked():
    one, _ = asked(LOCKED)
    found = evidence(one, [], 1, 0.1)
    stages = {stage.stage: stage for stage in found.stages}
    assert not found.left_out and {each.subject.kind for each in found.compared} == {"static position"}
    assert stages["equilibrium"].taken and "locks the scene" in stages["modes"].why


def test_a_support_too_many():
    one, (tree,) = asked(PROPPED)
    with pytest.raises(PhysicsError, match="supported by more than it needs"):
        at_rest(one, tree)


def test_what_has_no_reference():
    one, _ = in_numbers(problem_of(file_source(str(next(PROBLEMS.glob("*/carriage_in_a_detent.yaml"))))))
    tree = next(part for answer in one.spec.answers for part in answer.asked.parts.quantities
                if part.head == "equilibrium")
    with pytest.raises(PhysicsError, match="where forces jump"):
        at_rest(one, tree)
    one, (*_, ground) = asked(ON_A_SLOPE)
    with pytest.raises(PhysicsError, match="and of forces in constraints and supports"):
        at_rest(one, ground)
