"""The worked solution: numbered lines from the figure to what is asked."""

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report import blocks
from vibcli.report.blocks import Section, Words, line, paragraph, section
from vibcli.report.keys import Key

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem


BARE = re.compile(r"(?<![\w.^√])(\d+\.\d+|\d{3,})·(?!i\b)[^\W\d]")        # halves and thirds have no unit
PUT_IN = re.compile("to order|expanded")        # what lines settle in which numbers stand for letters
SI = "Numbers that stand beside letters without a unit are in SI units."


def steps(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.report.steps.worked import worked

    yield from section_of(worked(problem))


def _has_bare_numbers(found: "Sequence[WorkedLine]") -> bool:
    """Do numbers stand beside letters whose units are not told, those of letters that they are put in for?"""
    from vibcli.notation.plain import plain
    from vibcli.report.formats.formula import formula

    lines = [one for one in found if PUT_IN.search(one.settles)]
    return any(BARE.search(formula([part for part in one.parts if not isinstance(part, blocks.WithNumbers)], plain))
               for one in lines)


def section_of(found: "Sequence[WorkedLine]") -> tuple[Section, ...]:
    """The lines of a scene as a section, and below them what numbers without units are in."""
    told: dict[Any, Any] = {}
    for one in found:
        if one.number not in told:
            told[one.number] = one.parts
        elif one.parts:
            told[one.number] = [*told[one.number], Words(",  "), *one.parts]
    digits = len(str(len(told)))
    heads = {number: Words(f"{number:\u00a0>{digits}}\u00a0\u00a0") for number in told}
    lines = blocks.equations(line(heads[number], *parts, hang=digits + 2) for number, parts in told.items())
    return section("Steps", lines, paragraph(SI) if _has_bare_numbers(found) else None)


def _data(problem: "Problem") -> list[dict[str, Any]]:
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
