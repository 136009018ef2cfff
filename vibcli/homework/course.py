"""What is handed out: a problem file, a folder of them, or a set.yaml that names some."""

import os
from typing import TYPE_CHECKING

from vibcli.base.enumeration import amount
from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import nearest
from vibcli.homework import SET
from vibcli.language.document.document import Mapping, read_file
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Text, WholeNumber
from vibcli.language.reader import Reader

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.language.reader import Record

SUFFIXES = (".yaml", ".yml")
PROBLEM = Element(
    "problem", "A problem of a set, or some of a folder.",
    {
        "file": Field(Text(), "its scene file, or a folder of them, by the way from the set", required=True),
        "case": Field(Text(), "this case of the file"),
        "points": Field(WholeNumber(1000), "how many points it gives, shared out as its quantities' are; the sum of "
                                           "those unless given"),
        "pick": Field(WholeNumber(100), "of a folder: how many problems each student gets; all unless given"),
    },
    short="file",
)
ELEMENT = Element(
    "set", "A set of problems: what `vibcli homework` hands out together.",
    {
        "title": Field(Text(), "what stands at the top of each sheet"),
        "course": Field(Text(), "the course, in a line"),
        "due": Field(Text(), "until when, in words"),
        "problems": Field(Many(PROBLEM, 1, 50), "its problems, in order", required=True),
    },
)


class CourseProblem(NamedTuple):
    """A problem of a course: its name, stable and of its own; its file, a case of that or None; its points, None where
    its quantities say; where a set names the case."""

    name: str
    path: str
    case: str | None = None
    points: int | None = None
    where: Where | None = None


class CoursePart(NamedTuple):
    """Problems of which each student gets so many."""

    problems: tuple[CourseProblem, ...]
    pick: int


class Course(NamedTuple):
    """title, course, due: what sheets say at their top, '' of nothing; parts in order."""

    title: str
    course: str
    due: str
    parts: tuple[CoursePart, ...]

    @property
    def problems(self) -> list[CourseProblem]:
        return [problem for part in self.parts for problem in part.problems]


def course_of(path: str) -> Course:
    """The Course of a problem file, a folder or a set; FileNotFoundError where there is none, SpecError where it is
    none."""
    if os.path.isdir(path):
        inside = os.path.join(path, SET)
        return course_of(inside) if os.path.exists(inside) else Course("", "", "", (_folder(path, None, "", None),))
    if os.path.basename(path) != SET:
        return Course("", "", "", (CoursePart((CourseProblem(_stem(path), path),), 1),))
    node, diagnostics, _ = read_file(path)
    reader = Reader()
    record = ELEMENT.read(node, reader) if isinstance(node, Mapping) else None
    if diagnostics or reader.diagnostics or record is None:
        raise SpecError([*diagnostics, *reader.diagnostics] or [Diagnostic(Where(path, 1, 1, 0), "expected a set")])
    parts = tuple(_part(path, one) for one in record["problems"])
    _require_names(parts, record)
    return Course(*(record.get(key, "").strip() for key in ("title", "course", "due")), parts)


def _part(path: str, record: "Record") -> CoursePart:
    """The CoursePart that an entry of a set names."""
    name, folder = record["file"].strip(), os.path.dirname(path)
    full = os.path.normpath(os.path.join(folder, name))
    where = record.place("file")
    if os.path.isabs(name):
        raise SpecError([Diagnostic(where, "a problem is named by its way from the set", "write as in ../lever.yaml")])
    points = record.get("points")
    if os.path.isdir(full):
        found = _folder(full, record.get("pick"), name, points)
        if found.pick > len(found.problems):
            count = amount(len(found.problems), "problem")
            said = f"each is to get {found.pick}, and this folder has {count}"
            raise SpecError([Diagnostic(record.place("pick"), said, f"pick at most {len(found.problems)}")])
        return found
    if "pick" in record:
        raise SpecError([Diagnostic(record.place("pick"), "'pick' is for a folder of problems", "leave it out")])
    if not os.path.exists(full):
        beside = os.listdir(os.path.dirname(full)) if os.path.isdir(os.path.dirname(full)) else []
        hint = nearest(os.path.basename(name), beside) if beside else None
        raise SpecError([Diagnostic(where, f"there is no file '{name}'", hint)])
    case = record.get("case")
    label = _stem(full) + (f"-{_safe(case)}" if case else "")
    return CoursePart((CourseProblem(label, full, case, points, record.place("case") if case else None),), 1)


def _folder(path: str, pick: int | None, name: str, points: int | None) -> CoursePart:
    """The CoursePart of a folder: its scene files, sorted."""
    files = sorted(one for one in os.listdir(path) if one.endswith(SUFFIXES) and one != SET)
    if not files:
        raise SpecError([Diagnostic(Where(path, 1, 1, 0), "there is no scene file in this folder")])
    problems = tuple(CourseProblem(_stem(one), os.path.join(path, one), None, points) for one in files)
    return CoursePart(problems, len(problems) if pick is None else pick)


def _require_names(parts: "Sequence[CoursePart]", record: "Record") -> None:
    """No two problems of one name, by which manifests and marks tell them apart; nor of two that many file systems take
    for one."""
    seen: dict[str, CourseProblem] = {}
    for part, one in zip(parts, record["problems"], strict=True):
        for problem in part.problems:
            known = seen.setdefault(problem.name.casefold(), problem)
            if known is not problem:
                said = f"the problem '{problem.name}' stands twice" if known.name == problem.name else (
                    f"the problems '{known.name}' and '{problem.name}' differ in capitals alone")
                raise SpecError([Diagnostic(one.place("file"), said, "give one of the files another name")])


def _stem(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]


def _safe(text: str) -> str:
    return "".join(c if c.isalnum() else "-" for c in text.strip())
