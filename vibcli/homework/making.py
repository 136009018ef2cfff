"""Sheets, keys and questions of those who get them, made here or by the workers of an executor: what comes is the same
in the same order.
"""

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.parts import even_size
from vibcli.homework.roster import Student

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout
    from vibcli.homework.manifest import Assigned
    from vibcli.homework.paper import Pages, Paper

SIZE = 25       # students of a task, at most: each task reads its problems anew and draws their figures


class StudentTask(NamedTuple):
    """A student with what it gets, (problem, number of the variant) in order; first: of these what nobody before it
    got, of which the keys are made too."""

    student: Student
    given: list[tuple[str, int]]
    first: list[tuple[str, int]]


class MakingTask(NamedTuple):
    """What some students get; handouts: {name: Handout} of their problems; salt: what no text may tell."""

    course: "Course"
    handouts: "dict[str, Handout]"
    students: list[StudentTask]
    salt: str

    def sheets(self, given: Sequence[tuple[str, int]]) -> "list[tuple[Handout, int]]":
        """(problem, number of the variant) of what somebody gets."""
        return [(self.handouts[name], number) for name, number in given]

    def part(self, start: int, size: int) -> "MakingTask":
        """So many of the students from a number on, with no more of the problems than they get."""
        students = self.students[start:start + size]
        numbers: dict[str, set[int]] = {}
        for name, number in (pair for one in students for pair in one.given):
            numbers.setdefault(name, set()).add(number)
        return self._replace(students=students, handouts={name: self.handouts[name].only(those)
                                                          for name, those in numbers.items()})


def made(work: Callable[..., Iterator[Any]], course: "Course", handouts: "Sequence[Handout]", assigned: "Assigned",
         salt: str, on: Any, tell: Callable[[float], None], executor: Executor | None, *more: Any) -> Iterator[Any]:
    """What work(MakingTask, on, *more) gives for each student, in their order; on: the paper; tell(part): how far it
    is."""
    taken: set[tuple[str, int]] = set()
    students = []
    for student, sheets in assigned:
        given = [(handout.name, number) for handout, number in sheets]
        students.append(StudentTask(student, given, [one for one in given if one not in taken]))
        taken.update(given)
    task = MakingTask(course, {one.name: one for one in handouts}, students, salt)
    each = work(task, on, *more) if executor is None else _by_workers(executor, work, task, type(on), more)
    for number, found in enumerate(each, 1):
        yield found
        tell(number / len(students))


def _by_workers(executor: Executor, work: Callable[..., Iterator[Any]], task: MakingTask, kind: "type[Pages | Paper]",
                more: tuple[Any, ...]) -> Iterator[Any]:
    size = even_size(len(task.students), SIZE)
    pending = deque(executor.submit(_made, work, task.part(start, size), kind, more)
                    for start in range(0, len(task.students), size))
    while pending:
        yield from pending.popleft().result()


def _made(work: Callable[..., Iterator[Any]], task: MakingTask, kind: "type[Pages | Paper]",
          more: tuple[Any, ...]) -> list[Any]:
    return list(work(task, kind(), *more))
