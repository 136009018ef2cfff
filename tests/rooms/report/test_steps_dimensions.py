"""Lines of worked solutions are homogeneous: with other units of mass, length and time both sides of each equality are
as much greater as what they measure, and what a line settles as the unit that it has."""

import math
from pathlib import Path

import numpy as np
import pytest
from support.scenes import kept_problem_of, problem
from support.worked_lines import InOtherUnits

from vibcli.base.errors import PhysicsError
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.sections.steps import section_of
from vibcli.report.steps.worked import worked
from vibcli.symbolic.rationals import fraction_of

PROBLEMS = sorted(Path("problems").glob("[1-9]_*/*.yaml"))
LONG = {"ladder_on_tie_rod"}        # with ratios such as 15 to 16, which might have units
BAR = """
parameters: {L: 2 m, EA: 3 MN, mu: 2 kg/m, M: 5 kg}
bars: {b: {length: L, EA: EA, mass_per_length: mu, left: clamped, attached: [{mass: M, at: L}]}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_lines_of_problems_are_homogeneous_and_none_says_what_another_one_does(path):
    found = kept_problem_of(path)
    try:
        lines = worked(found)
    except PhysicsError as refusal:
        pytest.skip(refusal.message)
    (block, *_), = (section.blocks for section in section_of(lines))
    printed = [formula(line.parts[1:], plain) for line in block.lines]      # without the numbers
    assert len(set(printed)) == len(printed) > 0
    if found.spec.choices or found.spec.get("matrices"):
        pytest.skip("its parameters are chosen, or its matrices given as numbers")
    if found.scene.table.records or path.stem in LONG:
        pytest.skip("numbers of the file, in SI units, stand beside its letters")
    if any(base.startswith("?") for name in found.spec.parameters for base in found.spec.dimensions.of(name)):
        pytest.skip("letters of any dimension")
    assert not InOtherUnits(found, lines).wrong


def test_a_line_without_its_unit_and_one_of_other_terms_are_found():
    scene = problem(BAR)
    lines = worked(scene)
    assert not InOtherUnits(scene, lines).wrong and sum(one.value is not None for one in lines) >= 3
    at, wave = next((i, one) for i, one in enumerate(lines) if one.settles == "omega[1]")
    for other in (wave._replace(unit=""), wave._replace(node=wave.node + 1, value=wave.value + 1)):
        assert math.isfinite(other.value) and InOtherUnits(scene, [*lines[:at], other, *lines[at + 1:]]).wrong


LINE = """
parameters: {J: 3 kg*m^2, k: 500 N*m, c: 2 N*m*s, M0: 7 N*m}
bodies: {a: {inertia: J, turn: x}, b: {inertia: 2*J, turn: y}, e: {inertia: J, turn: z}}
springs: {s: {torsion: k, between: [a, b]}, r: {torsion: 2*k, between: [b, e]}, g: {torsion: k, between: [ground, a]}}
dampers: {d: {torsion: c, between: [ground, e]}}
forces: {drive: {body: a, moment: M0*sin(t*9 rad/s)}}
answers: {"abs(frf[z, drive](2 Hz))": 0 rad/N/m, "abs(frf[y, drive](20 rad/s))": 0 rad/N/m}
"""


def test_a_frequency_in_numbers_has_a_letter_and_its_unit():
    """|H| by the determinants is that of NumPy."""
    scene = problem(LINE)
    lines = worked(scene)
    frequencies = [line for line in lines if line.letter.startswith("Omega") and line.unit == "rad/s"]
    assert [line.value for line in frequencies] == [pytest.approx(4 * math.pi), 20.0]
    assert len({line.letter for line in frequencies}) == 2 and not InOtherUnits(scene, lines).wrong
    told = {line.settles: line for line in lines}
    for asked, at, row in (("abs(frf[z, drive](2 Hz))", 4 * math.pi, 2), ("abs(frf[y, drive](20 rad/s))", 20, 1)):
        Z = np.array([[1000, -500, 0], [-500, 1500, -1000], [0, -1000, 1000 + 2j * at]]) - at**2 * np.diag([3, 6, 3])
        assert told[asked].value == pytest.approx(abs(np.linalg.inv(Z)[row, 0]), rel=1e-9)
        assert told[asked].node is not None
    at = lines.index(frequencies[0])
    bare = frequencies[0]._replace(node=scene.scene.table.number(fraction_of(4 * math.pi)))
    assert InOtherUnits(scene, [*lines[:at], bare, *lines[at + 1:]]).wrong
