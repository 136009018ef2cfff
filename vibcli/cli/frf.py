"""`vibcli frf FILE`: frequency responses."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.cli.common import chosen, load, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.cli.sampled import asked, cases_to_show, curve_options, refuse_targets, require_curves, show_curves, size

if TYPE_CHECKING:
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem


@click.command("frf")
@scene_options
@report_options
@click.option("--of", "signals", multiple=True, metavar="SIGNAL", help="Of what: x, x', P.y, ground.force; may be "
              "given several times. The coordinates unless given, here or by `find` of the file.")
@click.option("--to", "driver", metavar="INPUT", help="To a unit of what: a force, a driven point, or a coordinate for "
              "the generalised force on it. The first of these unless given, here or by `find` of the file.")
@click.option("--from", "low", metavar="FREQUENCY", help="Where plots and saved numbers begin, as 10 (rad/s) or "
              "'2 Hz'.")
@click.option("--up-to", "high", metavar="FREQUENCY", help="Where they end.")
@click.option("--nyquist", is_flag=True, help="Plot the response in the complex plane.")
@curve_options
def command(file: str, settings: Sequence[Any], case: Any, as_json: bool, patience: int, timings: bool, signals: Any,
            driver: Any, low: str | None, high: str | None, nyquist: bool, plot: bool, saves: Sequence[str],
            **report: Any) -> int:
    """Frequency responses: amplitude and phase lag, peaks, antiresonances, half-power points; plotted, or saved.

    Each is that of a signal to one unit of an input: vibcli explain frf.
    """
    from vibcli.report.wanted import Wanted

    refuse_targets(saves, report["force"])
    require_curves(plot, saves, as_json, {"--nyquist": nyquist, "--from": low, "--up-to": high})
    output = output_of(file, as_json, **report)
    problems = cases_to_show(chosen(load(file, settings, patience), case), saves)
    first, last = (size(text, option, "rad/s", "a frequency, as in 10 or '2 Hz'") if text else None
                   for text, option in ((low, "--from"), (high, "--up-to")))
    if None not in (first, last) and not first < last:
        raise click.UsageError(f"--from {low} is not below --up-to {high}")
    wanted = Wanted(tuple(asked(text, "--of") for text in signals), driver and asked(driver, "--to"), "sine", first,
                    last)
    return print_scenes(problems, lambda problem: ("chosen", "frequency_response"), output, timings,
                        data=("frequency_response",), wanted=wanted,
                        curves=lambda problem: _shown(problem, wanted, nyquist, plot, saves, report["force"]))


def _shown(problem: "Problem", wanted: "Wanted", nyquist: bool, plot: bool, saves: Sequence[str], force: bool) -> None:
    if not (plot or saves):
        return
    from vibcli.report.sections.sampled_series import frequency_columns, frequency_figure, sampled_curves

    curves = sampled_curves(problem, wanted)
    show_curves(plot, saves, force, problem.spec.get("title") or "",
                lambda: frequency_figure(problem, curves, nyquist), lambda: frequency_columns(curves))
