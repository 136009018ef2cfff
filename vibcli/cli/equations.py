"""`vibcli equations FILE`: energies and equations of motion."""

import click

from vibcli.cli.common import chosen, load, scene_options
from vibcli.cli.output import print_scenes


@click.command("equations")
@scene_options
def command(file, settings, case, as_json, timings):
    """Energies and equations of motion, full and for small oscillations."""
    problems = chosen(load(file, settings), case)
    return print_scenes(problems, lambda problem: ("chosen", "coordinates", "energies", "equations"), as_json,
                        timings, data=("equations",))
