"""`vibcli check PATH…`: the answers in problem files against the results."""

import os
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import click

from vibcli.api.source import settled
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.common import (
    _sources,
    color_option,
    patience_option,
    problem_in,
    show_diagnostics,
    show_fault,
    show_refusal,
    source_of,
)
from vibcli.homework import SET

GRAVEST = (101, 3, 4, 1, 0)


class CheckedFile(NamedTuple):
    """What is known of a file that was checked: its exit code, could it not be checked? and the data of its answers."""

    file: str
    code: int
    failed: bool
    answers: list


@click.command("check")
@click.argument("paths", nargs=-1, required=True, type=click.Path())
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Give a parameter another value, in every file: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--json", "as_json", is_flag=True, help="Verdicts as JSON.")
@click.option("--quiet", "-q", is_flag=True, help="Print only what does not agree.")
@click.option("--jobs", "-j", type=click.IntRange(1, 256), default=1, metavar="N",
              help="Check N files at a time, in processes of their own.")
@patience_option
@color_option
def command(paths: Sequence[str], settings: Sequence[Any], as_json: bool, quiet: bool, jobs: int,
            patience: int) -> int:
    """Compare the answers in scene files (and in folders of them) with the results.

    Exit code: 0 all agree, 1 an answer differs, 3 a file is invalid, 4 a scene cannot be solved or whether an answer
    agrees is uncertain (of several the gravest of 3, 4, 1), 5 no answer was found to check, 130 interrupted: what was
    found by then is told.
    """
    files = [file for path in paths for file in _files(path)]
    tell, found, interrupted = None if as_json else partial(_print, quiet=quiet), [], False
    try:
        for one in _each(files, jobs, tell, settings, patience):
            found.append(one)
    except KeyboardInterrupt:
        interrupted = True
    if as_json:
        import json

        data = [{"file": one.file, "exit_code": one.code, "answers": list(one.answers)} for one in found]
        click.echo(json.dumps(data, ensure_ascii=False, allow_nan=False, indent=1))
    else:
        click.echo(_summary(found))
    if interrupted:
        raise KeyboardInterrupt
    code = next(code for code in GRAVEST if code in {0, *(one.code for one in found)})
    return 5 if code == 0 and not any(answer["agrees"] for one in found for answer in one.answers) else code


def _each(files, jobs, tell, settings, patience):
    """The CheckedFile of each file, in their order, printed."""
    if jobs > 1 and len(files) > 1:
        from vibcli.cli.jobs import in_processes

        yield from in_processes(partial(checked_file, tell=tell, settings=settings, patience=patience), files,
                                min(jobs, len(files)))
        return
    for file in files:
        yield checked_file(file, tell, settings, patience)


def checked_file(file: str, tell: Callable | None, settings: Sequence[str], patience: int) -> CheckedFile:
    """What the check of a file found; `tell` prints it. A fault of ours is told and leaves the other files."""
    try:
        code, verdicts = _check_file(file, settings, patience)
    except (click.ClickException, click.Abort):
        raise
    except Exception as error:
        click.echo(f"{file}:", err=True)
        show_fault(error)
        if os.environ.get("VIBCLI_TRACEBACK"):
            raise
        code, verdicts = 101, []
    failed = _failed(code, verdicts)
    if tell:
        tell(file, verdicts, failed=failed)
    return CheckedFile(file, code, failed, [_data(verdict) for verdict in verdicts])


def _failed(code, verdicts):
    """Is a file invalid, or could an answer not be found? What is uncertain was."""
    return code in (3, 101) or (code == 4 and (not verdicts or any(v.refusal and v.agrees is False for v in verdicts)))


def _files(path):
    """A file itself, or all .yaml and .yml files below a folder, sorted; sets name problems, and are none."""
    if not os.path.isdir(path):
        if not os.path.exists(path):
            raise click.UsageError(f"there is no file or folder '{path}'")
        return [path]
    found = []
    for folder, folders, names in os.walk(path):
        folders.sort()
        found += [os.path.join(folder, name) for name in sorted(names)
                  if name.endswith((".yaml", ".yml")) and name != SET]
    return found


def _check_file(file, settings, patience):
    """(exit code, verdicts) of one file; what is wrong with it goes to stderr."""
    try:
        source = source_of(file)
        problem = problem_in(source, settings, patience)
        if not any(spec.answers for spec in (problem.spec, *problem.spec.cases.values())):
            _settle(problem)
            return 0, []
        from vibcli.check.verdicts import check

        verdicts = check(problem, source.node)
        refused = [v for v in verdicts if v.refusal]
        for refusal in _once([v.refusal for v in refused]):
            show_refusal(refusal, file)
    except SpecError as error:
        show_diagnostics(error.diagnostics)
        return 3, []
    except PhysicsError as error:
        show_refusal(error, file)
        return 4, []
    finally:
        _sources.pop(file, None)
    return 4 if refused else int(any(not v.agrees for v in verdicts)), verdicts


def _once(refusals):
    """Each refusal of one place once, with the number of answers that it keeps from being found."""
    same: dict = {}
    for refusal in refusals:
        same.setdefault((refusal.message, refusal.hint, refusal.where), []).append(refusal)
    for (message, hint, where), those in same.items():
        yield PhysicsError(f"{message} (so of {len(those)} answers)" if len(those) > 1 else message, hint, where)


def _settle(problem):
    """Refused where the scene or a case of it cannot be drawn, or what it chooses cannot be found."""
    problem.draw()
    for part in (problem, *map(problem.case, problem.spec.cases)):
        settled(part)


def _name(verdict):
    return (f"{verdict.case}: " if verdict.case else "") + verdict.answer.asked.text


def _print(file, verdicts, quiet, failed):
    shown = [v for v in verdicts if not (quiet and v.agrees)]
    if not shown and quiet:
        return
    click.echo(file + ("" if verdicts else "  (not checked)" if failed else "  (no answers)"))
    for verdict in shown:
        if verdict.agrees:
            click.echo("  " + click.style("✓", fg="green") + f" {_name(verdict)}{_estimate(verdict)}")
            continue
        where = verdict.answer.expected.where
        click.echo(f"  {_mark(verdict)} {_name(verdict)}:{_said(verdict)}{_estimate(verdict)}  [line {where.line}]")


def _estimate(verdict):
    return "  (its error is estimated)" if verdict.estimated else ""


def _mark(verdict):
    return click.style("?", fg="yellow") if verdict.agrees is None else click.style("✗", fg="red")


def _said(verdict):
    """What was expected and what was found, and what there is to say of it."""
    if verdict.agrees is None:
        return f" uncertain: expected {verdict.answer.expected.text}, {verdict.remark}"
    values = ""
    if verdict.expected is not None:
        values = " expected {}, found {}".format(*(verdict.digits or _values(verdict.expected, verdict.found)))
    return values + (f" ({verdict.remark})" if verdict.remark else "")


def _values(*values):
    """Two values, to the digits in which they differ."""
    if any(isinstance(value, bool) for value in values):
        return ["true" if value else "false" for value in values]
    digits = next((n for n in range(9, 17) if len({f"{value:.{n}g}" for value in values}) > 1), 17)
    return [f"{value:.{digits}g}" for value in values]


def _data(verdict):
    return {"answer": verdict.answer.asked.text, "case": verdict.case, "line": verdict.answer.expected.where.line,
            "agrees": verdict.agrees, "expected": verdict.expected, "found": verdict.found, "error": verdict.error,
            "estimated": verdict.estimated, "remark": verdict.remark}


def _summary(found):
    agreed = [answer["agrees"] for one in found for answer in one.answers]
    agree, differ, uncertain = (sum(one is value for one in agreed) for value in (True, False, None))
    failed = sum(one.failed for one in found)
    parts = [f"{_count(agree, 'answer')} agree" + "s" * (agree == 1)]
    if differ:
        parts.append(f"{differ} differ" + "s" * (differ == 1))
    if uncertain:
        parts.append(f"{uncertain} {'is' if uncertain == 1 else 'are'} uncertain")
    if failed:
        parts.append(f"{_count(failed, 'file')} could not be checked")
    return f"{', '.join(parts)} in {_count(len(found), 'file')}"


def _count(number, what):
    return f"{number} {what}" + ("" if number == 1 else "s")
