"""`vibcli solve FILE`: the whole solution."""

from collections.abc import Sequence
from functools import partial
from typing import Any

import click

from vibcli.cli.common import accuracy_option, chosen, integrated, load, number_options, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import SCENE, output_of, report_options
from vibcli.report.formats import FORMATS


@click.command("solve")
@scene_options
@partial(report_options, formats=(*FORMATS, SCENE), more=" scene: the file itself with the results as its answers.")
@number_options
@accuracy_option
@click.option("--insight", is_flag=True, help="Also whose energy each mode has, what its frequency depends on, and "
              "estimates of the lowest one.")
@click.option("--steps", is_flag=True, help="Line by line instead: coordinates, energies of each body, spring and "
              "damper, rest, Lagrange's equations, frequencies, motion, forces.")
def command(file: str, settings: Sequence[str], case: str | None, as_json: bool, patience: int, timings: bool,
            digits: int | None, normalise: str, accuracy: float | None, insight: bool, steps: bool,
            **report: Any) -> int:
    """The solution of a scene: equilibrium, energies, equations of motion, frequencies, damping, modes; or what `find`
    in the file asks, responses too."""
    from vibcli.api.reports import STEPS, solution

    output = output_of(file, as_json, **report)
    problems = integrated(chosen(load(file, settings, patience), case), accuracy)
    sections, data = (lambda problem: solution(problem, insight)), ("equations", "frequencies", "equilibria")
    if steps:
        _require_told(insight, normalise, as_json, digits)
        sections, data = (lambda problem: STEPS), ()
    if output.kind == SCENE:
        _require_of_file(settings, steps, normalise, timings)
        from vibcli.cli.answered import print_answered

        return print_answered(file, problems, sections, output, digits)
    if accuracy and not any("response" in sections(problem) for _, problem in problems):
        raise click.UsageError("--accuracy is for motions in time, and none is asked for: find: [response]")
    return print_scenes(problems, sections, output, timings, digits, normalise, data, question=True)


def _require_of_file(settings: Sequence[str], steps: bool, normalise: str, timings: bool) -> None:
    """UsageError of what is asked beside the file with its answers, in which it would not stand."""
    for asked, option in ((settings, "--set"), (steps, "--steps"), (normalise != "first", "--normalise"),
                          (timings, "--timings")):
        if asked:
            raise click.UsageError(f"--format {SCENE} and {option} exclude each other: answers are those of the file")


def _require_told(insight: bool, normalise: str, as_json: bool, digits: int | None) -> None:
    """UsageError of what is asked beside the lines of a worked solution, which do not tell it."""
    for asked, option in ((insight, "--insight"), (normalise != "first", "--normalise"),
                          (as_json and digits is not None, "--digits with --json")):
        if asked:
            raise click.UsageError(f"--steps and {option} exclude each other")
