"""`vibcli draw FILE`: the scene as a figure."""

from collections.abc import Sequence
from typing import Any

import click

from vibcli.cli.common import load
from vibcli.cli.pictures import one, picture_options, target, write

SUFFIXES = (".png", ".svg", ".pdf")


@click.command("draw")
@picture_options(SUFFIXES)
@click.option("--mode", "index", type=click.IntRange(1), metavar="I",
              help="The shape of mode I over the scene at rest.")
@click.option("--both", is_flag=True, help="With --mode: displaced the other way as well, dashed.")
def command(file: str, settings: Sequence[Any], case: str | None, output: str | None, force: bool, patience: int,
            index: int | None, both: bool) -> None:
    """The scene as a textbook figure, or a mode shape on it: png, svg or pdf by the suffix of the file."""
    if both and index is None:
        raise click.UsageError("--both belongs to --mode")
    problem = one(load(file, settings, patience), case)
    path = target(file, output, SUFFIXES, force, case, f"mode{index}" if index else None)
    from vibcli.api.pictures import SceneDrawing

    write(path, SceneDrawing.of(problem, index, both).data(path.suffix[1:].lower()), force)
