"""The folder of a pool: packages for course systems, and the keys by which `grade` marks what these systems mark."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.homework.exports import IN_TEX
from vibcli.homework.exports.item import ExportedQuestion, item_of, picture_of, questions_of, require_own_names
from vibcli.homework.exports.setting import MATHML, TEX
from vibcli.homework.folder import INSTRUCTOR, key_files, of_instructor, require_no_leak
from vibcli.homework.leaks import text_of_columns, text_of_page
from vibcli.homework.making import MakingTask, made
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
               formats: Sequence[str], on: "Pages | Paper", tell: Callable[[float], None],
               executor: Executor | None = None) -> Iterator[tuple[str, bytes]]:
    """(path in the folder, bytes) of every file, the executor making questions and keys where one is given; Leak where
    a question would tell a key. tell(part): how far it is."""
    require_own_names([one.name for one in handouts])
    for handout in handouts:
        own = [sheet for _, sheets in assigned for sheet in sheets if sheet[0] is handout]
        for name, data in handout.document.files.items():
            require_no_leak(f"the file {name}", text_of_columns(data.decode()), own, salt)
    questions: list[ExportedQuestion] = []
    settings = [TEX] * any(name in IN_TEX for name in formats) + [MATHML] * any(name not in IN_TEX for name in formats)
    by_name = {one.name: one for one in handouts}
    for (_, sheets), (keys, found) in zip(assigned, made(_items, course, handouts, assigned, salt, on, tell, executor,
                                                         settings), strict=True):
        yield from keys
        questions += [one._replace(figure=picture_of(by_name[sheets[0][0].name])) for one in found]
    questions.sort(key=lambda one: one.by_hand)
    exports = []
    for name in formats:
        written = dict(import_module(f"vibcli.homework.exports.{name}").package(course, questions))
        yield from ((f"{INSTRUCTOR}/{name}/{path}", data) for path, data in written.items())
        exports.append(_entry(name, list(written), questions))
    yield from of_instructor(course, handouts, assigned, attempt, on, exports)


def _items(task: MakingTask, on: "Pages | Paper",
           settings: Any) -> Iterator[tuple[list[tuple[str, bytes]], list[ExportedQuestion]]]:
    """([(path, bytes)] of its key, its questions as they are set, without figures) of each item."""
    for item, given, first in task.students:
        sheets = task.sheets(given)
        shown = text_of_page(html.render(student_sheet(task.course, item, sheets), listed=False))
        require_no_leak(f"the question {item.id}", shown, sheets, task.salt)
        questions = [one.as_set(settings) for one in questions_of(task.course, *sheets[0])]
        yield list(key_files(task.sheets(first), on)), questions


def _entry(name: str, paths: list[str], questions: list[ExportedQuestion]) -> dict[str, Any]:
    """What a manifest keeps of a package: its files, and units of keys that are not those asked on paper."""
    entry: dict[str, Any] = {"format": name, "files": [f"{name}/{path}" for path in paths]}
    if name == "canvas":
        from vibcli.homework.exports.canvas import other_units

        entry["units"] = other_units(questions)
    return entry
