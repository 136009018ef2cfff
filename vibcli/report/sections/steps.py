"""The worked solution: numbered lines from the figure to what is asked."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.report import blocks
from vibcli.report.blocks import Section, Words, line, section
from vibcli.report.keys import Key

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem


def steps(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.report.steps.worked import worked

    yield from section_of(worked(problem))


def section_of(found: "Sequence[WorkedLine]") -> tuple[Section, ...]:
    """The lines as a section."""
    told: dict = {}
    for one in found:
        if one.number not in told:
            told[one.number] = one.parts
        elif one.parts:
            told[one.number] = [*told[one.number], Words(",  "), *one.parts]
    digits = len(str(len(told)))
    heads = {number: Words(f"{number:\u00a0>{digits}}\u00a0\u00a0") for number in told}
    return section("Steps", blocks.equations(
        line(heads[number], *parts, hang=digits + 2) for number, parts in told.items()))


def _data(problem):
    from vibcli.notation.latex import in_one_line
    from vibcli.notation.plain import plain
    from vibcli.notation.scene_language import language
    from vibcli.report.formats.formula import formula
    from vibcli.report.steps.worked import worked

    return [KEY.row(one.number, one.settles, list(one.uses), formula(one.parts, plain).strip().replace("\u00a0", " "),
                    formula(one.parts, in_one_line), one.node and language(one.node), one.value, one.unit or None)
            for one in worked(problem)]


KEY = Key("steps", "with --steps alone: the worked solution, a list, an entry to each thing that a line settles",
          _data, each=(
    Key("number", "of the line; several entries of one line have the same"),
    Key("settles", "the quantity or letter that it tells, empty of words alone"),
    Key("uses", "numbers of the lines that it follows from"),
    Key("text", "what it says"),
    Key("latex", "the same in LaTeX"),
    Key("expression", "what it settles in the language of scenes, with the new letters of the lines; null of words"),
    Key("value", "that in SI units; null in letters"),
    Key("unit", "of the value; null of a pure number and where it is not told")))
