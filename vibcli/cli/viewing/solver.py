"""A process that solves scenes for the page, so that the server answers, and an interrupt ends it, whatever it does."""

import signal
from collections.abc import Sequence
from multiprocessing import get_context, resource_tracker
from typing import TYPE_CHECKING

from vibcli.api.source import SceneSource, bytes_source, settled
from vibcli.base.diagnostics import render
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.cli.common import chosen, problem_in
from vibcli.cli.processes import end_with_parent, interrupts_held

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.context import SpawnProcess

    from vibcli.base.errors import Where
    from vibcli.report.blocks import Document
    from vibcli.results.problem import Problem


class Job(NamedTuple):
    """A scene, or a case of it, as the bytes of a file; `number`: which article of the page it is."""

    data: bytes
    file: str
    settings: tuple[str, ...]
    case: str | None
    number: int
    patience: int


class Solver:
    """The process, started when there is something to do and kept; what it does can be broken off."""

    process: "SpawnProcess | None"
    ours: "Connection | None"

    def __init__(self) -> None:
        self.process, self.ours, self.busy = None, None, False

    def start(self, job: Job) -> None:
        if self.process is None or not self.process.is_alive():
            context = get_context("spawn")      # no thread of the server lives on in a copy
            resource_tracker.ensure_running()   # it lets interrupts through when it begins
            self.ours, theirs = context.Pipe()
            process = context.Process(target=_serve, args=(theirs,), daemon=True)
            with interrupts_held():
                process.start()
                self.process = process
            theirs.close()
        self.ours.send(job)
        self.busy = True

    def found(self, seconds: float) -> tuple[str, list[str]] | None:
        """(HTML, errors) of the job, waited for so long; None where it is not ready."""
        try:
            if not self.ours.poll(seconds):
                return None
            self.busy = False
            told_of: tuple[str, list[str]] = self.ours.recv()
            return told_of
        except (EOFError, OSError):
            self.stop()
            return "", ["vibcli: the process that solves has ended; edit the file to try again"]

    def stop(self) -> None:
        """End the process, whatever it does."""
        if self.process is not None:
            self.process.kill()
            self.process.join()
            self.ours.close()
        self.process, self.busy = None, False


def _serve(connection: "Connection") -> None:
    """Solve job by job until the other end is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)       # one from the terminal reaches all; the first process ends us
    end_with_parent()
    while True:
        try:
            connection.send(solved(connection.recv()))
        except (EOFError, OSError):
            return


def solved(job: Job) -> tuple[str, list[str]]:
    """(the report with its pictures as HTML, what there is to say of it beside)."""
    source = bytes_source(job.data, job.file)
    try:
        (_, problem), = chosen(problem_in(source, job.settings, job.patience), job.case)[:1]
        document, error = _document(problem, job.case)
        wrong = [] if error is None else error.diagnostics
        from vibcli.report.formats.html import article

        return article(job.number, document), told((*problem.spec.remarks, *wrong), source)
    except SpecError as error:
        return "", told(error.diagnostics, source)
    except PhysicsError as error:
        return "", told(error.diagnostics, source)
    except Exception as error:
        return "", [f"vibcli: an error of its own: {type(error).__name__}: {str(error)[:200]}"]


def _document(problem: "Problem", case: str | None) -> "tuple[Document, PhysicsError | None]":
    """(the Document, the refusal where something is not found)."""
    from vibcli.api.reports import illustrated, report, solution
    from vibcli.report.blocks import Document, Refusal
    from vibcli.report.document import title_of

    try:
        problem = settled(problem, thorough=True)
        made = report(problem, illustrated(solution(problem)), pictures=True)
        document, refusal = made.document(case), made.refusal
    except PhysicsError as error:
        document, refusal = Document(title_of(problem.spec, case), None, (), ()), error
    if refusal is None:
        return document, None
    return document._replace(refusal=Refusal(refusal.message, refusal.hint)), refusal if refusal.where else None


def told(diagnostics: Sequence[Diagnostic], source: SceneSource) -> list[str]:
    """Diagnostics as texts, each with its line and a caret."""
    from vibcli.api.source import shown_lines

    def lines(where: "Where | None") -> Sequence[str]:
        return source.lines if where is None or where.file == source.file else shown_lines(where.file)

    return [render(one, lines(one.where)) for one in diagnostics]
