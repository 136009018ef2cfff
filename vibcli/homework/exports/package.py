"""The folder of a pool: packages for course systems, and the keys by which `grade` marks what these systems mark."""

from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.homework.exports.item import ExportedQuestion, item_of, questions_of
from vibcli.homework.folder import INSTRUCTOR, of_instructor, require_no_leak
from vibcli.homework.leaks import text_of_columns, text_of_page
from vibcli.homework.roster import Student
from vibcli.homework.sheets import student_sheet
from vibcli.report.formats import html

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout
    from vibcli.homework.manifest import Assigned
    from vibcli.homework.paper import Pages, Paper


def of_pool(handout: "Handout", numbers: Sequence[int]) -> "Assigned":
    """Each variant as the sheet of its item, whose name is the id that `grade` takes."""
    return [(Student(item_of(handout.name, number)), [(handout, number)]) for number in numbers]


def pool_files(course: "Course", handouts: "Sequence[Handout]", assigned: "Assigned", attempt: int, salt: str,
               formats: Sequence[str], on: "Pages | Paper",
               tell: Callable[[float], None]) -> Iterator[tuple[str, bytes]]:
    """(path in the folder, bytes) of every file; Leak where a question would tell a key. tell(part): how far it is."""
    for handout in handouts:
        own = [sheet for _, sheets in assigned for sheet in sheets if sheet[0] is handout]
        for name, data in handout.document.files.items():
            require_no_leak(f"the file {name}", text_of_columns(data.decode()), own, salt)
    questions: list[ExportedQuestion] = []
    for number, (student, sheets) in enumerate(assigned, 1):
        shown = text_of_page(html.render(student_sheet(course, student, sheets), listed=False))
        require_no_leak(f"the question {student.id}", shown, sheets, salt)
        questions += questions_of(course, *sheets[0])
        tell(0.5 * number / len(assigned))
    questions.sort(key=lambda one: one.by_hand)
    exports = []
    for name in formats:
        written = dict(import_module(f"vibcli.homework.exports.{name}").package(course, questions))
        yield from ((f"{INSTRUCTOR}/{name}/{path}", data) for path, data in written.items())
        exports.append(_entry(name, list(written), questions))
    yield from of_instructor(course, handouts, assigned, attempt, on, tell, exports)


def _entry(name, paths, questions) -> dict[str, Any]:
    """What a manifest keeps of a package: its files, and units of keys that are not those asked on paper."""
    entry = {"format": name, "files": [f"{name}/{path}" for path in paths]}
    if name == "canvas":
        from vibcli.homework.exports.canvas import other_units

        entry["units"] = other_units(questions)
    return entry
