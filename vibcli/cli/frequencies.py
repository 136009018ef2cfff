"""`vibcli frequencies FILE`: equilibrium, frequencies, damping, modes."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.cli.common import chosen, load, number_options, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.pictures import FILE
from vibcli.cli.reports import output_of, report_options
from vibcli.report.wanted import Wanted

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


@click.command("frequencies")
@scene_options
@report_options
@number_options
@click.option("--modes", "count", type=click.IntRange(1, 10_000), metavar="N",
              help="Only the lowest N modes; of members, which have modes without end, N where few are told.")
@click.option("--backbone", is_flag=True, help="How the frequency of free motions hangs on their amplitude, as the "
              "file asks: find: [{backbone: {of: [x], up_to: 10 cm}}].")
@click.option("--plot", is_flag=True, help="Plot the eigenvalues in the complex plane, or that curve, in the terminal.")
@click.option("--save", "saves", multiple=True, metavar="FILE", type=FILE,
              help="Write that picture (.png, .svg, .pdf).")
def command(file: str, settings: Sequence[str], case: Any, as_json: bool, patience: int, timings: bool,
            digits: int | None, normalise: str, count: int | None, backbone: bool, plot: bool,
            saves: Sequence[str], **report: Any) -> int:
    """Equilibrium, natural frequencies, damping and mode shapes."""
    if saves:
        from vibcli.cli import sampled

        sampled.refuse_targets(saves, report["force"], sampled.PICTURES)
    if plot and as_json:
        raise click.UsageError("--plot does not go with --json")
    output = output_of(file, as_json, **report)
    wanted = Wanted() if count is None else _lowest(count)
    problems = chosen(load(file, settings, patience), case)[:1 if saves else None]
    sections = ("chosen", "equilibrium", *(("backbone",) if backbone else ("frequencies", "damping", "modes")))
    return print_scenes(problems, lambda problem: sections, output, timings, digits, normalise, ("frequencies",),
                        wanted=wanted,
                        curves=lambda problem: _shown(problem, wanted, backbone, plot, saves, report["force"]))


def _lowest(count: int) -> Wanted:
    from vibcli.report.sections.shown_modes import lowest

    return Wanted(modes=lowest(count))


def _shown(problem: "Problem", wanted: Wanted, backbone: bool, plot: bool, saves: Sequence[str], force: bool) -> None:
    if not (plot or saves) or problem.work.interrupted:
        return
    from vibcli.cli.sampled import show_curves

    if backbone:
        from vibcli.report.sections.backbone import curve_figure

        figure = curve_figure(problem)
    else:
        from vibcli.report.sections.sampled_series import eigenvalue_figure

        figure = eigenvalue_figure(problem, wanted)
    show_curves(plot, saves, force, problem.spec.get("title") or "", lambda: figure)
