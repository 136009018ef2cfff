"""The folder of what is handed out: student/ and instructor/, written whole or not at all."""

import csv
import io
import json
import os
import shutil
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import PhysicsError
from vibcli.homework.leaks import leak, text_of_columns, text_of_page
from vibcli.homework.making import MakingTask, made
from vibcli.homework.manifest import Assigned, manifest
from vibcli.homework.sheets import key_sheet, overview, student_sheet
from vibcli.homework.tables import as_text
from vibcli.report.formats import html

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout
    from vibcli.homework.paper import Pages, Paper

STUDENT, INSTRUCTOR = "student", "instructor"


class Leak(PhysicsError):
    """A student's file would tell a key."""


def files(course: "Course", handouts: "Sequence[Handout]", assigned: Assigned, attempt: int, salt: str,
          on: "Pages | Paper", tell: Callable[[float], None],
          executor: Executor | None = None) -> Iterator[tuple[str, bytes]]:
    """(path in the folder, bytes) of every file, made by the executor where one is given; Leak where a student's file
    would tell a key. tell(part): how far it is."""
    yield from _beside(handouts, assigned, salt, on)
    for found in made(_sheets, course, handouts, assigned, salt, on, tell, executor):
        yield from found
    yield from of_instructor(course, handouts, assigned, attempt, on)


def _sheets(task: MakingTask, on: "Pages | Paper") -> Iterator[list[tuple[str, bytes]]]:
    """[(path, bytes)] of the sheet of each student, and of the keys of what nobody before it got."""
    for student, given, first in task.students:
        sheets = task.sheets(given)
        documents = student_sheet(task.course, student, sheets)
        shown = text_of_page(html.render(documents, listed=False))
        require_no_leak(f"the sheet of {student.id}", shown, sheets, task.salt)
        yield [(f"{STUDENT}/{student.id}{on.suffix}", on.data(documents)), *key_files(task.sheets(first), on)]


def key_files(sheets: "Sequence[tuple[Handout, int]]", on: "Pages | Paper") -> Iterator[tuple[str, bytes]]:
    """(path, bytes) of the keys of variants."""
    for handout, number in sheets:
        yield f"{INSTRUCTOR}/keys/{handout.name}-{number + 1}{on.suffix}", on.data([key_sheet(handout, number)])


def of_instructor(course: "Course", handouts: "Sequence[Handout]", assigned: Assigned, attempt: int,
                  on: "Pages | Paper", exports: Sequence[Any] = ()) -> Iterator[tuple[str, bytes]]:
    """(path in the folder, bytes) of what is for who marks, beside the keys; exports: what the manifest keeps of
    packages."""
    gone: dict[str, dict[int, list[str]]] = {one.name: {} for one in handouts}
    for student, sheets in assigned:
        for handout, variant in sheets:
            gone[handout.name].setdefault(variant, []).append(student.id)
    yield f"{INSTRUCTOR}/overview{on.suffix}", on.data([overview(course, handouts, len(assigned), gone)])
    yield f"{INSTRUCTOR}/keys.csv", _table(assigned)
    yield f"{INSTRUCTOR}/manifest.json", _json(manifest(course, handouts, assigned, attempt, exports))


def _beside(handouts: "Sequence[Handout]", assigned: Assigned, salt: str,
            on: "Pages | Paper") -> Iterator[tuple[str, bytes]]:
    """The files that go out with the sheets of problems that take numbers from them, under their own names."""
    taken: dict[str, bytes | None] = {f"{student.id}{on.suffix}": None for student, _ in assigned}
    for handout in handouts:
        sheets = [one for _, theirs in assigned for one in theirs if one[0] is handout]
        for name, data in handout.document.files.items():
            if taken.get(name, data) != data:
                raise PhysicsError(f"{handout.name} takes numbers from {quoted(name)}, and another file with this name "
                                   "is handed out", "give it another name")
            require_no_leak(f"the file {name}", text_of_columns(data.decode()), sheets, salt)
            if name not in taken:
                yield f"{STUDENT}/{name}", data
            taken[name] = data


def require_no_leak(what: str, text: str, sheets: Sequence[Any], salt: str) -> None:
    """Leak where a text that students see tells a key, the salt or a comment; what: whose text, in words."""
    keys = [key for handout, variant in sheets for key in handout.variants[variant].keys]
    hidden = [comment for handout, _ in sheets for comment in handout.comments]
    found = leak(text, [key.value for key in keys if key.value is not None], [salt, *hidden],
                 [text for key in keys for text in key.hidden])
    if found is not None:
        raise Leak(f"{what} would tell {found}", "nothing was written; take it out of the question or of the figure, "
                   "or vary the parameters otherwise")


def _table(assigned: Assigned) -> bytes:
    """keys.csv."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["id", "problem", "variant", "quantity", "key", "unit", "figures", "band", "points"])
    for student, sheets in assigned:
        for handout, variant in sheets:
            for key, points, one in zip(handout.keys, handout.points, handout.variants[variant].keys, strict=True):
                rows.writerow([student.id, handout.name, variant + 1, key.text, as_text(one.written), key.unit,
                               one.figures, "" if one.band is None else f"{one.band.width:.3g}", f"{points:g}"])
    return text.getvalue().encode()


def _json(data: Any) -> bytes:
    return (json.dumps(data, ensure_ascii=False, allow_nan=False, indent=1) + "\n").encode()


def write_folder(path: Path, found: Iterator[tuple[str, bytes]], force: bool) -> int:
    """Write files to a folder that is new or empty, or replaced where that is forced: beside it first, so that nothing
    is left of what fails. Gives their number."""
    refuse_folder(path, force)
    beside, before = (path.with_name(f".{path.name[:64]}.{os.urandom(8).hex()}") for _ in range(2))
    count = 0
    try:
        for name, data in found:
            target = beside / name
            if not target.resolve().is_relative_to(beside.resolve()):
                raise PhysicsError(f"{quoted(name)} leads out of the folder", "nothing was written")
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
            count += 1
        if path.exists():
            os.replace(path, before)
        os.replace(beside, path)
    except OSError as error:
        raise _unwritable(path, error) from None
    finally:
        if before.exists() and not path.exists():
            os.replace(before, path)
        for folder in (beside, before):
            shutil.rmtree(folder, ignore_errors=True)
    return count


def refuse_folder(path: Path, force: bool) -> None:
    """A refusal, before anything is computed, of a folder that cannot be written."""
    try:
        _refuse_place(path, force)
    except (OSError, ValueError) as error:      # as of a name that is too long
        raise _unwritable(path, error) from None


def _unwritable(path: Path, error: Exception) -> PhysicsError:
    return PhysicsError(f"{path} cannot be written: {getattr(error, 'strerror', None) or error}", "name another folder")


def _refuse_place(path: Path, force: bool) -> None:
    if path.is_symlink():
        raise PhysicsError(f"{path} is a link, and nothing is written through links", "name the folder it leads to")
    if path.exists() and not path.is_dir():
        raise PhysicsError(f"{path} is no folder", "name a new folder, or an empty one")
    if path.exists() and any(path.iterdir()) and not (force and _is_ours(path)):
        raise PhysicsError(f"{path} is not empty", "it holds other files: name another folder" if force else
                           "name a new folder, or an empty one")
    if _runs_in(path):
        raise PhysicsError("the folder in which the command runs is not replaced", "name a folder in it")
    if not path.absolute().parent.is_dir():
        raise PhysicsError(f"there is no folder {path.parent}", "make it, or name another one")
    if not os.access(path.parent if str(path.parent) else ".", os.W_OK | os.X_OK):
        raise PhysicsError(f"the folder {path.parent} may not be written to", "name another one")


def _is_ours(path: Path) -> bool:
    """Does a folder hold what was written for homework alone? Nothing else is ever taken away."""
    return {one.name for one in path.iterdir()} <= {STUDENT, INSTRUCTOR}


def _runs_in(folder: Path) -> bool:
    try:
        return folder.resolve() == Path.cwd()
    except OSError as error:        # the folder in which the command runs is gone
        raise PhysicsError(f"{folder} cannot be found: {error.strerror}", "name a folder that is there") from None
