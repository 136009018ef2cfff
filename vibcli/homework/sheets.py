"""Sheets as documents of reports: the student's, with the question and its values, and the key with its solution."""

from collections.abc import Sequence
from string import ascii_lowercase
from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.homework.wording import quantity_in_words
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import figure
from vibcli.report.blocks import (
    Definition,
    Definitions,
    Document,
    Name,
    Section,
    TableBlock,
    maths,
    paragraph,
    section,
)
from vibcli.report.document import Report
from vibcli.report.sections.parameters import measured

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout
    from vibcli.homework.roster import Student
    from vibcli.homework.variants import ProblemVariant
    from vibcli.results.problem import Problem

LETTERS = [f"({letter})" for letter in ascii_lowercase]
MARKED = "Only what this table asks is marked."


def student_sheet(course: "Course", student: "Student", problems: "Sequence[tuple[Handout, int]]") -> list[Document]:
    """The Documents of a student's sheet: its head, and each problem with the figure, its values and what is asked;
    problems: (problem, number of the variant), in order."""
    who = f"Sheet of {student.name} ({student.id})" if student.name else f"Sheet {student.id}"
    said = [who, *[course.course] * bool(course.course), *[f"due {course.due}"] * bool(course.due)]
    head = Document(course.title or "Homework", None, (" · ".join(said),), ())
    return [head, *(_question(number, *one) for number, one in enumerate(problems, 1))]


def _question(number: int, handout: "Handout", variant: int) -> Document:
    problem = handout.problem(variant)
    return Document(f"{number}. {handout.title}", None, Report(problem).document().question, (
        *handout.figure, *_values(problem, handout), *_asked(handout, handout.variants[variant])))


def _values(problem: "Problem", handout: "Handout") -> tuple[Section, ...]:
    """The values of the letters that the sheet shows, and the files that come with it."""
    names = set(problem.spec.parameters)
    items = [Definition((maths(Name(name)), " = " + as_printed(record["value"].text, names)), record.get("about", ""))
             for name, record in problem.spec.parameters.items()
             if name in handout.told and "value" in record and name not in problem.spec.choices]
    known = Definitions(tuple(items), "   ", not any(item.about for item in items)) if items else None
    files = list(handout.document.files)
    said = paragraph(f"With this sheet {'come' if files[1:] else 'comes'} {listed(files)}.") if files else None
    return section("Given", known, measured(problem), said)


def _asked(handout: "Handout", variant: "ProblemVariant") -> tuple[Section, ...]:
    rows = []
    for letter, key, points, one in zip(LETTERS, handout.keys, handout.points, variant.keys, strict=False):
        about, _ = quantity_in_words(handout.base.spec, key.asked.tree, key.text)
        rows.append((letter, about, key.text, as_printed(key.unit) or "–",
                     one.figures, figure(points, digits=3)))
    table = TableBlock(("", "what", "written as", "unit", "figures", "points"), tuple(rows))
    forms = dict.fromkeys(key.form for key in handout.keys if key.form)
    return section("Asked", table, *map(paragraph, [*forms, MARKED]))


def key_sheet(handout: "Handout", number: int) -> Document:
    """The key of a variant with its worked solution: right answers, how far they may be off, what mistakes give."""
    variant = handout.variants[number]
    problem = handout.problem(number)
    rows = [(letter, key.text, key.printed(problem, one.written), as_printed(key.unit) or "–", one.spread,
             figure(points, digits=3))
            for letter, key, points, one in zip(LETTERS, handout.keys, handout.points, variant.keys, strict=False)]
    return Document(f"{handout.title} — variant {number + 1}", problem.spec.get("source"),
                    Report(problem).document().question, (
        *section("Key", TableBlock(("", "quantity", "answer", "unit", "band", "points"), tuple(rows))),
        *handout.solution(number), *section("Mistakes", _mistakes(handout, variant, problem))))


def _mistakes(handout: "Handout", variant: "ProblemVariant", problem: "Problem") -> TableBlock | None:
    """What each mistake gives in the keys by their letters, None where there is none."""
    given: dict[str, dict[str, Any]] = {}
    for letter, key, one in zip(LETTERS, handout.keys, variant.keys, strict=False):
        for wrong in one.wrong:
            given.setdefault(wrong.mistake, {})[letter] = key.printed(problem, one.said(wrong.value))
    letters = [letter for letter in LETTERS if any(letter in own for own in given.values())]
    rows = [(name, *(own.get(letter, "–") for letter in letters), handout.sentences[name])
            for name, own in given.items()]
    return TableBlock(("mistake", *letters, "what to say"), tuple(rows)) if rows else None


def overview(course: "Course", handouts: "Sequence[Handout]", students: int,
             gone: "dict[str, dict[int, list[str]]]") -> Document:
    """One page on all that was handed out: the problems, how many variants each has, who got which; gone: {problem:
    {variant: students}}."""
    titles = Definitions(tuple(Definition((one.name,), one.title) for one in handouts))
    rows = [(one.name, str(one.accepted), str(len(gone[one.name])),
             str(max(map(len, gone[one.name].values()), default=0)), figure(sum(one.points)),
             ", ".join(one.rules.without) or "–") for one in handouts]
    head = "problem", "variants", "handed out", "students to one", "points", "gates off"
    table = TableBlock(head, tuple(rows))
    keys = [(one.name, key.text, as_printed(key.unit) or "–", *ends)
            for one in handouts for key, ends in zip(one.keys, one.ranges, strict=True)]
    ranges = TableBlock(("problem", "quantity", "unit", "least", "largest"), tuple(keys))
    return Document(course.title or "Homework", None, (), (
        *section("Problems", paragraph(f"{students} sheets.", hang=0), titles, table), *section("Keys", ranges)))

