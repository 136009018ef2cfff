"""`vibcli equations FILE`: energies and equations of motion."""

from collections.abc import Sequence
from typing import Any

import click

from vibcli.cli.common import chosen, load, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options


@click.command("equations")
@scene_options
@report_options
def command(file: str, settings: Sequence[Any], case: Any, as_json: bool, patience: int, timings: bool,
            **report: Any) -> int:
    """Energies and equations of motion, full and for small oscillations."""
    from vibcli.api.reports import derivation

    output = output_of(file, as_json, **report)
    problems = chosen(load(file, settings, patience), case)
    return print_scenes(problems, derivation, output, timings, data=("equations",))
