"""`vibcli frf FILE`: frequency responses."""

import click

from vibcli.cli.common import chosen, load, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.cli.sampled import asked, curve_options, plot_width, refuse_targets, save_to, size


@click.command("frf")
@scene_options
@report_options
@click.option("--of", "signals", multiple=True, metavar="SIGNAL", help="Of what: x, x', P.y, ground.force; the "
              "coordinates unless given, here or by `find` of the file.")
@click.option("--to", "driver", metavar="INPUT", help="To a unit of what: a force, a driven point, or a coordinate for "
              "the generalised force on it.")
@click.option("--from", "low", metavar="FREQUENCY", help="The lowest frequency, as 10 (rad/s) or '2 Hz'.")
@click.option("--up-to", "high", metavar="FREQUENCY", help="The highest frequency.")
@click.option("--nyquist", is_flag=True, help="Draw the response in the complex plane.")
@curve_options
def command(file, settings, case, as_json, timings, signals, driver, low, high, nyquist, plot, saves, **report):
    """Frequency responses: amplitude and phase lag, peaks, antiresonances, half-power points."""
    from vibcli.report.wanted import Wanted

    refuse_targets(saves, report["force"])
    output = output_of(file, as_json, **report)
    problems = chosen(load(file, settings), case)
    ends = [text and size(text, option, "rad/s", "a frequency, as in 10 or '2 Hz'")
            for text, option in ((low, "--from"), (high, "--up-to"))]
    if None not in ends and not ends[0] < ends[1]:
        raise click.UsageError(f"--from {low} is not below --up-to {high}")
    wanted = Wanted(tuple(asked(text, "--of") for text in signals), driver and asked(driver, "--to"), "sine", *ends)
    code = print_scenes(problems, lambda problem: ("chosen", "frequency_response"), output, timings,
                        data=("frequency_response",), wanted=wanted)
    if code == 0 and (plot or saves):
        for _, problem in problems if case is None and not saves else problems[:1]:
            _shown(problem, wanted, nyquist, plot, saves)
    return code


def _shown(problem, wanted, nyquist, plot, saves):
    from vibcli.report.series import frequency_columns, frequency_figure, sampled_curves

    curves = sampled_curves(problem, wanted)
    if plot:
        from vibcli.report.plots.braille import braille

        click.echo("\n" + braille(frequency_figure(problem, curves, nyquist), width=plot_width()))
    for path in saves:
        save_to(path, problem, lambda: frequency_figure(problem, curves, nyquist), lambda: frequency_columns(curves))
