"""`vibcli check PATH…`: the answers in problem files against the results."""

import os
from collections.abc import Sequence
from typing import Any

import click

from vibcli.api.source import settled
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.common import _sources, color_option, load, patience_option, show_diagnostics, show_refusal

GRAVEST = (3, 4, 1, 0)


@click.command("check")
@click.argument("paths", nargs=-1, required=True, type=click.Path())
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="Give a parameter another value, in every file: k=500 in the file's unit, or 'k=0.5 N/mm'.")
@click.option("--json", "as_json", is_flag=True, help="Verdicts as JSON.")
@click.option("--quiet", "-q", is_flag=True, help="Print only what does not agree.")
@patience_option
@color_option
def command(paths: Sequence[str], settings: Sequence[Any], as_json: bool, quiet: bool, patience: int) -> int:
    """Compare the answers in scene files (and in folders of them) with the results.

    Exit code: 0 all agree, 1 an answer differs, 3 a file is invalid, 4 a scene cannot be solved or whether an answer
    agrees is uncertain (of several the gravest of 3, 4, 1), 5 no answer was found to check.
    """
    files = [file for path in paths for file in _files(path)]
    counts = {"agree": 0, "differ": 0, "uncertain": 0, "files": 0, "failed": 0}
    codes, data = [0], []
    for file in files:
        code, verdicts = _check_file(file, settings, patience)
        codes.append(code)
        counts["files"] += 1
        counts["failed"] += _failed(code, verdicts)
        for name, agrees in (("agree", True), ("differ", False), ("uncertain", None)):
            counts[name] += sum(v.agrees is agrees for v in verdicts)
        if as_json:
            data.append({"file": file, "exit_code": code, "answers": [_data(v) for v in verdicts]})
        else:
            _print(file, verdicts, quiet, _failed(code, verdicts))
    if as_json:
        import json

        click.echo(json.dumps(data, ensure_ascii=False, allow_nan=False, indent=1))
    else:
        click.echo(_summary(counts))
    code = next(code for code in GRAVEST if code in codes)
    return 5 if code == 0 and not counts["agree"] else code


def _failed(code, verdicts):
    """Is a file invalid, or could an answer not be found? What is uncertain was."""
    return code == 3 or (code == 4 and (not verdicts or any(v.refusal and v.agrees is False for v in verdicts)))


def _files(path):
    """A file itself, or all .yaml and .yml files below a folder, sorted."""
    if not os.path.isdir(path):
        if not os.path.exists(path):
            raise click.UsageError(f"there is no file or folder '{path}'")
        return [path]
    found = []
    for folder, folders, names in os.walk(path):
        folders.sort()
        found += [os.path.join(folder, name) for name in sorted(names) if name.endswith((".yaml", ".yml"))]
    return found


def _check_file(file, settings, patience):
    """(exit code, verdicts) of one file; what is wrong with it goes to stderr."""
    try:
        problem = load(file, settings, patience)
        if not any(spec.answers for spec in (problem.spec, *problem.spec.cases.values())):
            _settle(problem)
            return 0, []
        from vibcli.check.verdicts import check

        verdicts = check(problem)
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


def _summary(counts):
    parts = [f"{_count(counts['agree'], 'answer')} agree" + "s" * (counts["agree"] == 1)]
    if counts["differ"]:
        parts.append(f"{counts['differ']} differ" + "s" * (counts["differ"] == 1))
    if counts["uncertain"]:
        parts.append(f"{counts['uncertain']} {'is' if counts['uncertain'] == 1 else 'are'} uncertain")
    if counts["failed"]:
        parts.append(f"{_count(counts['failed'], 'file')} could not be checked")
    return f"{', '.join(parts)} in {_count(counts['files'], 'file')}"


def _count(number, what):
    return f"{number} {what}" + ("" if number == 1 else "s")
