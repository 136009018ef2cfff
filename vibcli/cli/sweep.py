"""`vibcli sweep FILE --over 'k=400 N/m .. 1.2 kN/m' --of 'omega[1]'`: quantities over one or two parameters."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.cli.common import accuracy_option, chosen, integrated, load, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.cli.sampled import asked, curve_options, refuse_targets, show_curves

if TYPE_CHECKING:
    from vibcli.plots.figure import Figure
    from vibcli.quantities.sweep import Sweep
    from vibcli.results.problem import Problem

POINTS, ALONG_TWO, MOST = 51, 21, 100_000


@click.command("sweep")
@scene_options
@report_options
@click.option("--over", "ranges", multiple=True, required=True, metavar="NAME=LOW .. HIGH", help="A parameter and its "
              "range, 'k=400 N/m .. 1.2 kN/m'; twice for the grid of two.")
@click.option("--of", "quantities", multiple=True, metavar="QUANTITY", help="What: omega[1], zeta[2], max(x), or an "
              "expression of some; may be given several times. The natural frequencies unless given.")
@click.option("--points", type=click.IntRange(2, MOST), metavar="N", help=f"How many values: {POINTS}, along each of "
              f"two parameters {ALONG_TWO}, unless given.")
@click.option("--log", "by_ratio", is_flag=True, help="Space the values by one ratio.")
@accuracy_option
@curve_options
def command(file: str, settings: Sequence[str], case: Any, as_json: bool, patience: int, timings: bool,
            ranges: Sequence[str], quantities: Sequence[str], points: int | None, by_ratio: bool,
            accuracy: float | None, plot: bool, saves: Sequence[str], **report: Any) -> int:
    """Quantities over one or two parameters: tables, curves, contours, Campbell diagrams.

    The scene is derived once; natural modes are followed by their shapes: vibcli explain sweep.
    """
    from vibcli.report.wanted import Wanted

    refuse_targets(saves, report["force"])
    if plot and as_json:
        raise click.UsageError("--plot does not go with --json: save the numbers with --save FILE")
    if len(ranges) > 2:
        raise click.UsageError("--over is given more than twice: sweep over one or two parameters, and --set others")
    output = output_of(file, as_json, **report)
    (name, problem), *_ = integrated(chosen(load(file, settings, patience), case), accuracy)
    points = points or (POINTS if len(ranges) < 2 else ALONG_TWO)
    found = _found(problem, ranges, quantities, points, by_ratio, settings)
    return print_scenes([(name, problem)], lambda problem: ("sweep",), output, timings, data=("sweep",),
                        wanted=Wanted(sweep=found), curves=lambda problem: _shown(found, plot, saves, report["force"]))


def _found(problem: "Problem", ranges: Sequence[str], quantities: Sequence[str], points: int, by_ratio: bool,
           settings: Sequence[str]) -> "Sweep":
    from vibcli.api.axis import axis
    from vibcli.api.given import plain_name
    from vibcli.api.sweep import sweep

    axes = []
    for text in ranges:
        try:
            axes.append(axis(problem.spec, text, points, by_ratio))
        except ValueError as error:
            raise click.UsageError(f"--over {text}: {error}") from None
    for option in settings:
        if (name := plain_name(option.partition("=")[0].strip())) in {axis.name for axis in axes}:
            raise click.UsageError(f"--set {option}: '{name}' is swept over and takes the values of its range")
    try:
        return sweep(problem, axes, [asked(text, "--of") for text in quantities])
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def _shown(found: "Sweep", plot: bool, saves: Sequence[str], force: bool) -> None:
    if not (plot or saves) or not found.done:
        return
    from vibcli.report.sections.sweep import sweep_columns

    show_curves(plot, saves, force, found.problem.spec.get("title") or "", lambda: _figure(found),
                lambda: sweep_columns(found))


def _figure(found: "Sweep") -> "Figure":
    from vibcli.report.sections.swept_curves import sweep_figure

    return sweep_figure(found)
