"""`vibcli frequencies FILE`: equilibrium, frequencies, damping, modes."""

import click

from vibcli.cli.common import chosen, load, number_options, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options


@click.command("frequencies")
@scene_options
@report_options
@number_options
def command(file, settings, case, as_json, timings, digits, normalise, **report):
    """Equilibrium, natural frequencies, damping and mode shapes."""
    output = output_of(file, as_json, **report)
    problems = chosen(load(file, settings), case)
    return print_scenes(problems, lambda problem: ("chosen", "equilibrium", "frequencies", "damping",
                                                              "modes"),
                        output, timings, digits, normalise, ("frequencies",))
