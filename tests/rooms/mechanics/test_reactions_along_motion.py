"""Reactions along a motion: reduced as a textbook writes them, and the numbers of the forces at states of motion."""

import random
from pathlib import Path

import numpy as np
import pytest
from support.scenes import kept_problem_of, problem

from vibcli.api.reports import report
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.forces_along_motion import ForcesAlong
from vibcli.mechanics.inputs_outputs.reactions_along_motion import along_the_motion
from vibcli.mechanics.lagrange import equation_of
from vibcli.notation.plain import plain
from vibcli.report.blocks import Document
from vibcli.report.formats.text import render
from vibcli.symbolic.evaluation import Floats, evaluate

FILES = sorted((Path(__file__).parents[3] / "problems").glob("*/*.yaml"))
INCLINE = """
parameters: {m1: {value: 2 kg}, m2: {value: 1 kg}, J: {value: 0.1 kg*m^2}, r: {value: 0.1 m}, alpha: {value: 0.5},
             a: {value: 2 m}, k: {value: 90 N/m}, g: {value: 9.81 m/s^2}}
gravity: g
bodies:
  block: {mass: m1, at: [-a*cos(alpha), -a*sin(alpha)], slide: {along: [cos(alpha), sin(alpha)], by: s}}
  pulley: {inertia: J, at: [r*sin(alpha), -r*cos(alpha)], pin: {by: phi}}
  load: {mass: m2, at: [r*sin(alpha) + r, -2*a], slide: {along: [0, -1], by: y}}
constraints: {rope: {rope: [block, {over: pulley, radius: r}, load]}}
springs: {under: {k: k, between: [[r*sin(alpha) + r, -3*a], load], preload: static}}
"""


def test_a_block_on_an_incline_held_by_a_load_over_a_pulley():
    """N = m g cos α, upwards and in its parts, whatever it does."""
    formulas = along_the_motion(problem(INCLINE).numeric)
    found = {signal: plain(node).replace("\u00a0", " ") for signal, node in formulas.items()}
    assert found["block.normal"] == "m₁·g·cos α"
    assert found["block.reaction.x"] == "−m₁·g·cos α·sin α" and found["block.reaction.y"] == "m₁·g·cos² α"
    assert not any("λ" in text for text in found.values())
    assert found["pulley.reaction.x"] == "m₁·cos α·s̈ + m₁·g·cos α·sin α"


def test_its_contact_force_is_told_along_the_normal_where_it_is_let_go():
    falls = problem("\n".join(line for line in INCLINE.splitlines() if "springs" not in line).replace(
        "k: {value: 90 N/m}, ", ""))
    section = [one for one in report(falls, ["accelerations"]).sections if one.title == "Forces then"]
    told = render([Document("", None, (), tuple(section))]).replace("\u00a0", " ")
    assert "block.normal = m₁·g·cos α = 17.2182 N" in told


def moving(found, draw):
    """{name: value} of the coordinates, their rates and the time at a state of motion; None where none is found."""
    scene, floats = found.numeric.scene, found.numeric.floats
    at = {scene.time.name: 0.0}
    for q, v in zip(scene.q, scene.v, strict=True):
        size = scene.unit_of(q.name)
        at |= {q.name: scene.number(q) + 0.05 * draw.uniform(-1, 1) * size, v.name: 0.3 * draw.uniform(-1, 1) * size}
    left = [equation_of(scene, i) for i in range(len(scene.q))]
    names = [a.name for a in scene.a]

    def residual(a):
        return np.array(evaluate(left, Floats, {**floats, **at, **dict(zip(names, a, strict=True))}))

    still = residual(np.zeros(len(names)))
    masses = np.array([residual(row) - still for row in np.eye(len(names))]).T
    if not np.isfinite(masses).all() or np.linalg.cond(masses) > 1e8:
        return None
    at |= dict(zip(names, np.linalg.solve(masses, -still), strict=True))
    known = {**floats, **at}
    every = {name + "'" * order: scene.symbol(name, order) for name in found.spec.coordinates for order in range(3)}
    return at | dict(zip(every, evaluate(list(every.values()), Floats, known), strict=True))


def agree(found, draw):
    """How many reactions of a scene are the numbers of the forces at a state of motion."""
    formulas = along_the_motion(found.numeric)
    state = moving(found, draw) if formulas else None
    if state is None or any("λ" in plain(node) for node in formulas.values()):
        return 0
    values = {**found.numeric.floats, **state}
    told = dict(zip(formulas, evaluate(list(formulas.values()), Floats, values), strict=True))
    arrays = {name: np.array([value]) for name, value in values.items()}
    forces = ForcesAlong(found.numeric).values(list(told), arrays)
    size = max(abs(float(value[0])) for value in forces.values())
    for signal, value in told.items():
        assert value == pytest.approx(float(forces[signal][0]), rel=1e-9, abs=1e-9 * size), signal
    return len(told)


@pytest.mark.sweep
def test_of_all_problems():
    draw, counts = random.Random(7), [agree(problem(INCLINE), random.Random(3))]
    for path in FILES:
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or found.spec.choices or found.scene.pieces or (
                found.scene.held or found.scene.loops is not None):
            continue
        try:
            counts.append(agree(found, draw))
        except PhysicsError:
            continue
    assert counts[0] == 5 and sum(map(bool, counts)) > 20
