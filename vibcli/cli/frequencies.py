"""`vibcli frequencies FILE`: equilibrium, frequencies, damping, modes."""

import click

from vibcli.cli.common import chosen, load, number_options, scene_options
from vibcli.cli.output import print_scenes


@click.command("frequencies")
@scene_options
@number_options
def command(file, settings, case, as_json, timings, digits, normalise):
    """Equilibrium, natural frequencies, damping and mode shapes."""
    problems = chosen(load(file, settings), case)
    return print_scenes(problems, lambda problem: ("chosen", "equilibrium", "frequencies", "damping",
                                                              "modes"),
                        as_json, timings, digits, normalise, ("frequencies",))
