"""Long work: how much a piece of it may take, and how far it has come.

Work is counted in steps (windows of an integration, evaluations of a condition, places at which forces are looked at),
never in seconds: every machine answers and refuses the same. What is done within a task counts for those around it.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from math import inf
from typing import Any

from vibcli.base.errors import PhysicsError

_innermost: "ContextVar[Task | None]" = ContextVar("the task that is under way", default=None)


def counted(steps: float) -> None:
    """Steps of the task that is under way, where there is one: for what is far below whoever knows of tasks."""
    task = _innermost.get()
    if task is not None:
        task.step(None, steps)


@contextmanager
def uncounted() -> Iterator[None]:
    """What is `counted` within is no step of the task around it: a small part of its work, in steps of another size."""
    before = _innermost.set(None)
    try:
        yield
    finally:
        _innermost.reset(before)


def under_way() -> "Task":
    """The task that is under way; None where there is none."""
    return _innermost.get()


class Spent(Exception):
    """A task has reached its limit. No PhysicsError: a search that takes those of single places for an answer must not
    take this one. Where its task ends it becomes one, if nobody has kept what was found."""

    def __init__(self, task: "Task") -> None:
        super().__init__(task.what)
        self.task = task


class Work:
    """patience: the factor of all limits; cut: was a closed form given up at its limit? interrupted: was it, what was
    found being kept? tell(what, part, bounded): shows on a terminal how far the outermost task has come, what=None that
    it has ended."""

    __slots__ = ("cut", "interrupted", "open", "patience", "tell")

    def __init__(self, patience: int = 1, tell: Any = None) -> None:
        self.patience, self.tell, self.open = patience, tell, []
        self.cut = self.interrupted = False

    @contextmanager
    def task(self, what: str, limit: float = inf, refusal: Callable[..., Any] | None = None) -> "Iterator[Task]":
        """A Task: with work.task("the search for k", 20_000) as task: … task.step(). Beyond the limit the PhysicsError
        `refusal(task)`, or that of the task."""
        task = Task(self, what, limit * self.patience)
        self.open.append(task)
        before = _innermost.set(task)
        try:
            yield task
        except Spent as spent:
            if spent.task is not task:
                raise
            raise (refusal or Task.refusal)(task) from None
        finally:
            _innermost.reset(before)
            self.open.remove(task)
            if self.tell is not None and not self.open:
                self.tell(None, 1.0, False)

    def give_up_closed_form(self) -> None:
        """A closed form is given up at its limit."""
        self.cut = True

    def interrupt(self) -> None:
        """It is interrupted, and goes on with what was found."""
        self.interrupted = True

    def step(self, steps: int = 1) -> None:
        """Steps of the innermost task, where there is one."""
        if self.open:
            self.open[-1].step(None, steps)


class Task:
    """steps: how many were done, of `limit` that are allowed; part: of all that is to be done, where it is known."""

    steps: float
    part: float | None

    __slots__ = ("limit", "part", "steps", "what", "work")

    def __init__(self, work: Work, what: str, limit: float) -> None:
        self.work, self.what, self.limit, self.steps, self.part = work, what, limit, 0, None

    def step(self, part: float | None = None, steps: float = 1) -> None:
        """So many steps more, `part` (0 to 1) of all that is to be done being done where that is known. Spent where
        this task or one around it comes beyond its limit."""
        for task in self.work.open:
            task.count(steps)
            if task is self:
                break
        self.tell(part)

    def count(self, steps: float) -> None:
        """So many steps more, of this task alone."""
        self.steps += steps
        if self.steps > self.limit:
            raise Spent(self)

    @contextmanager
    def kept(self) -> Iterator[None]:
        """with task.kept(): … ends where this task comes to its limit; what was found by then is kept."""
        try:
            yield
        except Spent as spent:
            if spent.task is not self:
                raise

    def tell(self, part: float | None = None) -> None:
        """Show how far it has come."""
        tell = self.work.tell
        if tell is not None:
            outer = self.work.open[0]
            if outer is self and part is not None:
                self.part = part
            known = outer.part is not None
            tell(outer.what, outer.part if known else outer.steps / outer.limit, known)

    def refusal(self) -> PhysicsError:
        """The refusal where the limit is reached."""
        return PhysicsError(f"{self.what} is given up after {self.limit:.0f} steps", self.hint())

    def hint(self) -> str:
        return f"--patience {10 * self.work.patience:.0f} allows ten times as many"


def longer(work: Work) -> str:
    """The hint by which a search for a closed form that was given up goes on."""
    return f"--patience {10 * work.patience} lets computer algebra go on for ten times as long"
