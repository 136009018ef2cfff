"""`vibcli variants FILE`: all candidates of a problem for homework, solved, and the gates that they pass."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.cli.common import chosen, problem_in, scene_options, settings_in, source_of
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.cli.workers import worker_options, workers

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


@click.command("variants")
@scene_options
@report_options
@click.option("--table", is_flag=True, help="List the accepted variants, with their keys.")
@click.option("--rejected", is_flag=True, help="List the rejected candidates, each with its reason.")
@click.option("--at-least", type=click.IntRange(1), metavar="N", help="Exit with 1 where fewer are accepted.")
@worker_options
def command(file: str, settings: Sequence[str], case: Any, as_json: bool, patience: int, timings: bool, table: bool,
            rejected: bool, at_least: int | None, jobs: int, cluster: str | None, **report: Any) -> int:
    """Solve all variants of a problem, as its `variants:` says, and tell which of them pass the gates.

    Exit code: 0, 1 where fewer than --at-least are accepted, 3 where a mistake of the file gives nothing, 4 where no
    variant is left: vibcli explain variants.
    """
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.parts import solve_in_parts
    from vibcli.homework.refusals import require_variants
    from vibcli.report.wanted import Wanted

    output = output_of(file, as_json, **report)
    source = source_of(file)
    given, problem = settings_in(source, settings), problem_in(source, settings, patience)
    name, problem = (None, problem) if case is None else chosen(problem, case)[0]
    if problem.spec.get("variants") is None:
        where = Where(file, 1, 1, 0)
        raise SpecError([Diagnostic(where, "this scene says nothing of variants", _instead(problem))])
    document = SceneDocument.of(source.node, source.file, case, given)
    with workers(jobs, cluster) as executor:
        found = solve_in_parts(problem, document, executor)
    sections = ("variants", *["variant_table"] * table, *["rejected_variants"] * rejected)
    code = print_scenes([(name, problem)], lambda problem: sections, output, timings, data=("variants",),
                        wanted=Wanted(variants=found))
    if not code:
        require_variants(found, document)
    return code or int(at_least is not None and len(found.accepted) < at_least)


def _instead(problem: "Problem") -> str:
    """A case that has variants, or how they are written."""
    name = next((name for name, spec in problem.spec.cases.items() if spec.get("variants") is not None), None)
    return "give values under variants: parameters" if name is None else f"ask for a case that has some: --case {name}"
