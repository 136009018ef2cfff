"""Static positions to many digits beside closed forms, and SciPy's roots of the same forces."""

from pathlib import Path

import mpmath
import pytest
from support.scenes import problem

from vibcli.api.source import file_source, problem_of
from vibcli.base.errors import PhysicsError
from vibcli.evidence.asked import subjects
from vibcli.evidence.compared import in_numbers
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
forces: {drive: {body: rod, moment: M}}
answers: {"equilibrium[y]": 0, "equilibrium[phi]": 0, "equilibrium[s.force]": 0}
"""
LOOP = """
parameters: {a: 0.3 m, m: 2 kg, k: 800 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  left: {shape: rod, mass: m, from: [0, 0], to: [a, a], pin: {at: [0, 0], by: phi}}
  right: {shape: rod, mass: m, from: [a, a], to: [2*a, 0], pin: {at: [a, a], carrier: left, by: psi}}
  block: {mass: m, at: [2*a, 0], slide: {along: [1, 0], by: x}}
points: {foot: {body: right, at: [2*a, 0]}}
constraints: {pin: {join: [foot, block]}}
springs: {s: {k: k, between: [block, [1 m, 0]]}}
answers: {"equilibrium[phi]": 0, "equilibrium[pin.force.x]": 0}
"""


def asked(text):
    one = problem(text)
    return one, [answer.asked.tree for answer in one.spec.answers]


def test_true_positions_beside_closed_forms():
    one, trees = asked(HUNG)
    found = [at_rest(one, tree) for tree in trees]
    with mpmath.workdps(60):
        weight = 2 * mpmath.mpf("9.81")
        closed = [-weight / 800, mpmath.asin(3 / (weight / 4)), weight]
        assert all(abs(each.true.values[0] - x) < 1e-45 for each, x in zip(found, closed, strict=True))
    for each in found:
        (own,), others = ours.attempts(each), list(static_positions.attempts(each))
        answer = own.run(Deadline(60))
        assert each.error(answer.values, each.true) <= answer.bound < 1e-11
        errors = {(run.method, run.setting): each.error(run.run(Deadline(60)).values, each.true) for run in others}
        assert max(error for (_, setting), error in errors.items() if setting == "1e-12") < 1e-10
    assert {one.kind for one in subjects(one, [answer.asked for answer in one.spec.answers])} == {"static position"}


def test_a_closed_loop_beside_the_balance_of_its_energy():
    """V = 2 m g a√2 sin(β)/2 + k s²/2 with both rods at β to the level and the block at 2 a√2 cos β."""
    one, (phi, pin) = asked(LOOP)
    found = at_rest(one, phi)
    with mpmath.workdps(60):
        a, m, k, g = mpmath.mpf("0.3"), 2, 800, mpmath.mpf("9.81")
        length, free = a * mpmath.sqrt(2), 1 - 2 * a
        beta = mpmath.findroot(lambda b: m * g * length * mpmath.cos(b) - 2 * k * length * mpmath.sin(b) * (
            free - 1 + 2 * length * mpmath.cos(b)), mpmath.pi / 4)
        assert abs(found.true.values[0] - (beta - mpmath.pi / 4)) < 1e-45
    with pytest.raises(PhysicsError, match="places, stretches and forces of springs alone"):
        at_rest(one, pin)


@pytest.mark.parametrize(("file", "said"), [
    ("motor_on_inclined_mounts", "where what loads vary about rests"),
    ("carriage_in_a_detent", "where forces jump"),
    ("platform_on_three_rods", "static preloads in closed loops")])
def test_what_has_no_reference(file, said):
    one, _ = in_numbers(problem_of(file_source(str(next(PROBLEMS.glob(f"*/{file}.yaml"))))))
    tree = next(part for answer in one.spec.answers for part in answer.asked.parts.quantities
                if part.head == "equilibrium")
    with pytest.raises(PhysicsError, match=said):
        at_rest(one, tree)
