"""The worked solution: numbered lines from the figure to what is asked."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.report import blocks
from vibcli.report.blocks import Section, Words, line, section
from vibcli.report.keys import Key
from vibcli.report.steps.one_degree import OneDegree
from vibcli.report.steps.several_degrees import SeveralDegrees
from vibcli.report.steps.small_oscillations import Derivation
from vibcli.report.steps.step import WorkedLine, WorkedSolution

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def worked(problem: "Problem") -> list[WorkedLine]:
    """The steps of small oscillations."""
    sheet = WorkedSolution([*problem.spec.parameters, *problem.spec.coordinates, *problem.scene.coordinates])
    derivation = Derivation(problem, sheet)
    found = derivation.equations()
    if len(problem.scene.q) == 1:
        OneDegree(problem, derivation.about, sheet, found).write()
    else:
        SeveralDegrees(problem, derivation.about, sheet, found).write()
    return sheet.steps


def steps(problem: "Problem", _: "Report") -> Iterator[Section]:
    found = worked(problem)
    digits = len(str(len(found)))
    yield from section("Steps to the small oscillations", blocks.equations(
        line(Words(f"{one.number:\u00a0>{digits}}\u00a0\u00a0"), *one.parts, hang=digits + 2) for one in found))


def _data(problem):
    from vibcli.notation.latex import latex
    from vibcli.notation.plain import plain
    from vibcli.notation.scene_language import language
    from vibcli.report.formats.formula import formula

    return [KEY.row(one.number, one.settles, list(one.uses), formula(one.parts, plain).strip().replace("\u00a0", " "),
                    formula(one.parts, latex), one.node and language(one.node), one.value, one.unit or None)
            for one in worked(problem)]


KEY = Key("steps", "the worked solution, a list, one entry to each line", _data, each=(
    Key("number", "of the line"),
    Key("settles", "the quantity or letter that it tells, empty of words alone"),
    Key("uses", "numbers of the lines that it follows from"),
    Key("text", "what it says"),
    Key("latex", "the same in LaTeX"),
    Key("expression", "what it settles in the language of scenes, with the new letters of the lines; null of words"),
    Key("value", "that in SI units; null in letters"),
    Key("unit", "of the value; null of a pure number and where it is not told")))
