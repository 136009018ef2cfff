"""Equations of motion as they come from the energies, where springs with lengths of their own make them long."""

import random
from pathlib import Path

import pytest
from support.scenes import kept_problem_of

from vibcli.notation.plain import plain
from vibcli.report.document import Report
from vibcli.report.sections.equations_of_motion import equations
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import Node

PROBLEMS = Path(__file__).parents[3] / "problems"


def told(scene):
    """(the left sides of the full equations as nodes, {length: its root} of the energies and these)."""
    report = Report(scene)
    report.add("energies")
    section = next(one for one in equations(scene, report) if one.title == "Equations of motion")
    sides = [[part for part in line.parts if isinstance(part, Node)] for line in section.blocks[0].lines]
    roots = {symbol: square.table.sqrt(square) for square, symbol in report.roots.items()}
    return [left for left, *_ in sides], roots


@pytest.mark.parametrize(("name", "most"), [
    ("9_equivalents_and_corrections/corner_of_a_plate_on_springs", (170, 170, 400)),
    ("1_statics_and_energy/bar_on_two_springs", (110, 115, 210)),
    ("3_free_undamped/inverted_pendulum_between_springs", None)])
def test_equations_are_told_as_springs_make_them_and_are_those_of_the_engine(name, most):
    """Short, and at random states of the values of what is multiplied out."""
    scene = kept_problem_of(PROBLEMS / f"{name}.yaml")
    lines, roots = told(scene)
    if most:
        assert all(len(plain(line)) <= size for line, size in zip(lines, most, strict=True))
    draw, names = random.Random(5), [*scene.scene.coordinates]
    for _ in range(3):
        at = {**scene.numeric.floats, **{name + dots: draw.uniform(-0.1, 0.1) for name in names
                                         for dots in ("", "'", "''")}}
        found = evaluate(substitute(lines, roots), Floats, at)
        full = evaluate(scene.symbolic.equations.full, Floats, at)
        assert found == pytest.approx(full, rel=1e-9, abs=1e-9 * max(map(abs, full)))


def test_forces_of_constraints_stand_over_one_denominator():
    """Of a rod whose ends slide in a bowl of the radius √(a² + d²): its normal there, not each of its terms."""
    scene = kept_problem_of(PROBLEMS / "3_free_undamped/rod_in_bowl_with_end_masses.yaml")
    lines, _ = told(scene)
    text = plain(lines[1]).replace("\u00a0", " ")
    assert "(x − a·cos φ)·λ_left_end/√(a² + d²)" in text and text.count("√(a² + d²)") == 2
