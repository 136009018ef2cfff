"""Printing the results of one file: as a report in some format, or as one JSON document."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.api import reports
from vibcli.api.source import settled
from vibcli.base.errors import PhysicsError, Unknown
from vibcli.cli.common import require_quick, show_refusal, show_timings
from vibcli.cli.reports import Output, write_documents, write_text
from vibcli.report.blocks import Document, Refusal
from vibcli.report.document import title_of
from vibcli.report.formats.text import render

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.report.document import Report
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem

FLOAT_DIGITS = 12


def print_scenes(problems: "Sequence[tuple[str | None, Problem]]", sections: "Callable[[Problem], Sequence[str]]",
                 output: Output, timings: bool,
                 digits: int | None = None, normalise: str = "first", data: Sequence[str] = (), question: bool = False,
                 wanted: "Wanted | None" = None, curves: "Callable[[Problem], None] | None" = None) -> int:
    """Print the scene and its cases, or write them; `sections(problem)` names the sections of the report, `data` the
    parts of the JSON; `curves(problem)` plots and saves what belongs to each.

    A case that cannot be solved is refused on stderr and leaves the others, but where all is to be strict: exit code 4.
    """
    for _, problem in problems:
        require_quick(problem, digits)
    found: dict[str | None, Any] = {}
    solved, refused = [], False
    for case, problem in problems:
        try:
            problem = _ready(problem, question, digits, wanted, sections)
            solved.append((case, problem))
            if output.strict:
                reports.require_certified(problem, sections(problem), normalise, digits, wanted)
            if output.kind == "json":
                found[case] = reports.data(problem, data, normalise, digits, sections(problem), wanted)
                refused |= _told_unknown(problem, case, found[case], wanted)
            else:
                report = _report(problem, sections(problem), normalise, digits, output, wanted)
                found[case] = report.document(case, question)
                _print_at_once(found, case, output)
                if report.refusal and not isinstance(report.refusal, Unknown):
                    raise report.refusal
            if curves:
                curves(problem)
            if problem.work.interrupted:
                break
            if output.kind != "json" and report.refusal:
                raise report.refusal
        except PhysicsError as error:
            if output.strict or (output.kind == "json" and len(problems) == 1):
                raise
            refused = True
            show_refusal(error, problem.spec.file + (f", case {case}" if case else ""))
            found[case] = ({"error": error.message} if output.kind == "json" else
                           _refused(found.get(case), problem.spec, case, error))
    _print_all(found, output)
    if timings:
        show_timings(solved)
    return _code(problems, refused)


def _ready(problem: "Problem", thorough: bool, digits: int | None, wanted: "Wanted | None",
           sections: "Callable[[Problem], Sequence[str]]") -> "Problem":
    """The problem with what it chooses, and its motion followed to the digits that are asked for."""
    if problem.spec.choices:
        problem = _settled(problem, thorough, digits)
    return _in_series(problem, digits, wanted, sections(problem))


def _report(problem: "Problem", sections: Sequence[str], normalise: str, digits: int | None, output: Output,
            wanted: "Wanted | None") -> "Report":
    shown = reports.illustrated(sections) if output.pictures else sections
    return reports.report(problem, shown, normalise, digits, output.pictures, wanted)


def _code(problems: "Sequence[tuple[str | None, Problem]]", refused: bool) -> int:
    """The exit code."""
    if any(problem.work.interrupted for _, problem in problems):
        click.echo("interrupted", err=True)
        return 130
    return 4 if refused else 0


def _in_series(problem: "Problem", digits: int | None, wanted: "Wanted | None", sections: Sequence[str]) -> "Problem":
    """The problem with its motion of the full equations followed to the digits that are asked for; those that are asked
    for of frequencies leave one that has no more in floats."""
    if problem.spec.motion != "full" or "response" not in sections:
        return problem
    if wanted is not None and wanted.digits is not None:
        return problem.with_digits(wanted.digits)
    if digits is None:
        return problem
    finer = problem.with_digits(min(digits, FLOAT_DIGITS))      # no more of a motion are printed beside them
    try:
        finer.response.require_series()
    except PhysicsError:
        return problem
    return finer


def _told_unknown(problem: "Problem", case: str | None, data: dict[str, Any], wanted: "Wanted | None") -> bool:
    """Is a part of the motion not known? Then it is said on stderr too."""
    if not (data.get("response") or {}).get("unknown"):
        return False
    from vibcli.report.sections.response import unknown
    from vibcli.report.wanted import Wanted

    show_refusal(unknown(problem, wanted or Wanted()), problem.spec.file + (f", case {case}" if case else ""))
    return True


def _at_once(output: Output) -> bool:
    """Is each case printed as soon as it is solved?"""
    return output.kind == "text" and output.path is None and not output.strict


def _print_at_once(found: dict[str | None, Document], case: str | None, output: Output) -> None:
    if _at_once(output):
        click.echo(("\n\n" if len(found) > 1 else "") + render([found[case]]))


def _refused(document: Document | None, spec: "Spec", case: str | None, error: PhysicsError) -> Document:
    """The document of what was found, or an empty one, with the refusal."""
    document = document or Document(title_of(spec, case), None, (), ())
    return document._replace(refusal=Refusal(error.message, error.hint))


def _settled(problem: "Problem", thorough: bool, digits: int | None) -> "Problem":
    """The problem with what it chooses, known in closed form where more digits are asked for."""
    found = settled(problem, thorough)
    if digits is not None and digits > FLOAT_DIGITS and not found.choice.exact:
        raise PhysicsError(f"--digits {digits} needs a closed form of what is chosen, and none was found",
                           f"ask for at most {FLOAT_DIGITS} digits")
    return found


def _print_all(found: dict[str | None, Any], output: Output) -> None:
    """What was not printed at once."""
    if output.kind == "json":
        _print_json(found, output)
    elif not _at_once(output):
        write_documents(list(found.values()), output)


def _print_json(found: dict[str | None, dict[str, Any]], output: Output) -> None:
    import json

    first, *cases = found
    if cases:
        found[first]["cases"] = {case: found[case] for case in cases}
    write_text(json.dumps(found[first], ensure_ascii=False, allow_nan=False, indent=1), output)
