"""The check of one file, found as data: nothing is printed here."""

import os
from collections.abc import Sequence
from functools import partial
from time import process_time
from typing import TYPE_CHECKING

import click

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError, Where
from vibcli.base.rules import DIFFERS, DOUBTFUL, INVALID, UNCERTAIN, UNSOLVED
from vibcli.cli.checking.found import CheckedAnswer, CheckedFile, Trouble
from vibcli.cli.common import fault, forget, known_mistake, problem_in, shown_lines, source_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.api.source import SceneSource
    from vibcli.check.verdicts import Verdict
    from vibcli.results.problem import Problem


def checked_file(file: str, settings: Sequence[str] = (), patience: int = 1, data: bytes | None = None) -> CheckedFile:
    """What the check of a file found, or of bytes that stand for it. A fault of ours is told and leaves others."""
    start = process_time()
    try:
        found = _checked(file, settings, patience, data)
    except (click.ClickException, click.Abort):
        raise
    except Exception as error:
        if os.environ.get("VIBCLI_TRACEBACK"):
            raise
        found = CheckedFile(file, 101, True, fault=fault(error))
    finally:
        forget(file)
    return found._replace(seconds=process_time() - start)


def not_checked(file: str, error: PhysicsError) -> CheckedFile:
    """What stands for a file of which nothing is found."""
    return CheckedFile(file, 4, True, (), [_trouble(UNSOLVED, error, file)])


def _checked(file: str, settings: Sequence[str], patience: int, data: bytes | None) -> CheckedFile:
    verdicts, troubles, doubts, code = [], [], [], 0
    try:
        problem, source = _problem(file, settings, patience, data)
        doubts = [_trouble(DOUBTFUL, one, file) for one in problem.spec.remarks]
        if any(spec.answers for spec in (problem.spec, *problem.spec.cases.values())):
            from vibcli.check.verdicts import check

            verdicts = check(problem, partial(known_mistake, source.node))
            troubles = [_trouble(UNCERTAIN if uncertain else UNSOLVED, refusal, file, True)
                        for refusal, uncertain in _once([v for v in verdicts if v.refusal])]
            code = 4 if troubles else int(any(not v.agrees for v in verdicts))
        else:
            _settle(problem)
    except SpecError as error:
        code, troubles = 3, [_trouble(INVALID, one, file) for one in error.diagnostics]
    except PhysicsError as error:
        code, troubles = 4, [_trouble(UNSOLVED, error, file)]
    failed = code == 3 or (code == 4 and (not verdicts or any(v.refusal and v.agrees is False for v in verdicts)))
    return CheckedFile(file, code, failed, [_answer(verdict) for verdict in verdicts], doubts + troubles)


def _problem(file: str, settings: Sequence[str], patience: int,
             data: bytes | None) -> "tuple[Problem, SceneSource]":
    if data is not None:
        from vibcli.api.source import bytes_source

        source = bytes_source(data, file)
    else:
        try:
            source = source_of(file)
        except click.UsageError:        # the others are checked all the same
            why = "it is a link that leads nowhere" if os.path.islink(file) else "it was there when the folder was read"
            raise SpecError([Diagnostic(Where(file, 1, 1, 0), "there is no file of this name", why)]) from None
    return problem_in(source, settings, patience), source


def _once(verdicts: "Sequence[Verdict]") -> "Iterator[tuple[PhysicsError, bool]]":
    """(refusal, is it of what is uncertain?): each of one place once, with the number of answers that it keeps from
    being found."""
    same: dict[tuple[str, str | None, Where | None], list[Verdict]] = {}
    for verdict in verdicts:
        refusal = verdict.refusal
        same.setdefault((refusal.message, refusal.hint, refusal.where), []).append(verdict)
    for (message, hint, where), those in same.items():
        told = f"{message} (so of {len(those)} answers)" if len(those) > 1 else message
        yield PhysicsError(told, hint, where), all(verdict.agrees is None for verdict in those)


def _settle(problem: "Problem") -> None:
    """Refused where the scene or a case of it cannot be drawn, or what it chooses cannot be found."""
    from vibcli.api.source import settled

    problem.draw()
    for part in (problem, *map(problem.case, problem.spec.cases)):
        settled(part)


def _trouble(rule: str, error: Diagnostic | PhysicsError, file: str, of_answers: bool = False) -> Trouble:
    where = error.where or (Where(file, 1, 1, 0) if rule != INVALID else None)
    place = None if where is None else (where.file, where.line, where.column, where.width)
    lines = shown_lines(where) if where is not None and where.width else ()
    source = lines[where.line - 1] if where is not None and 1 <= where.line <= len(lines) else None
    return Trouble(rule, error.message, error.hint, place, source, of_answers)


def _answer(verdict: "Verdict") -> CheckedAnswer:
    where, asked = verdict.answer.expected.where, verdict.answer.asked.text
    rule = "" if verdict.agrees else UNCERTAIN if verdict.agrees is None else UNSOLVED if verdict.refusal else DIFFERS
    data = {"answer": asked, "case": verdict.case, "line": where.line, "column": where.column,
            "agrees": verdict.agrees, "expected": verdict.expected, "found": verdict.found, "error": verdict.error,
            "estimated": verdict.estimated, "remark": verdict.remark}
    name = (f"{verdict.case}: " if verdict.case else "") + asked
    return CheckedAnswer(data, rule, (where.line, where.column, where.width), name, _said(verdict), verdict.estimated)


def _said(verdict: "Verdict") -> str:
    """What was expected and what was found, and what there is to say of it."""
    if verdict.agrees:
        return ""
    if verdict.agrees is None:
        return f"uncertain: expected {verdict.answer.expected.text}, {verdict.remark}"
    values = []
    if verdict.expected is not None:
        values.append("expected {}, found {}".format(*(verdict.digits or _values(verdict))))
    return " ".join(values + [f"({verdict.remark})"] * bool(verdict.remark))


def _values(verdict: "Verdict") -> list[str]:
    """Expected and found, to the digits in which they differ, or with the bound of what is found where it knows few."""
    values = verdict.expected, verdict.found
    if any(isinstance(value, bool) for value in values):
        return ["true" if value else "false" for value in values]
    digits = next((n for n in range(9, 17) if len({f"{value:.{n}g}" for value in values}) > 1), 17)
    expected, found = (f"{value:.{digits}g}" for value in values)
    return [expected, verdict.known or found]
