"""`vibcli draw FILE`: the scene as a figure."""

import click

from vibcli.cli.common import load
from vibcli.cli.pictures import moving, one, picture_options, target, write

SUFFIXES = (".png", ".svg", ".pdf")


@click.command("draw")
@picture_options(SUFFIXES)
@click.option("--mode", "index", type=click.IntRange(1), metavar="I",
              help="The shape of mode I over the scene at rest.")
@click.option("--both", is_flag=True, help="With --mode: displaced the other way as well, dashed.")
def command(file, settings, case, output, force, patience, index, both):
    """The scene as a textbook figure, or a mode shape on it: png, svg or pdf by the suffix of the file."""
    if both and index is None:
        raise click.UsageError("--both belongs to --mode")
    problem = one(load(file, settings, patience), case)
    path = target(file, output, SUFFIXES, force, case, f"mode{index}" if index else None)
    from vibcli.drawing.canvas.matplotlib_canvas import picture

    write(path, picture(_primitives(problem, index, both), path.suffix[1:].lower()), force)


def _primitives(problem, index, both):
    if index is None:
        from vibcli.drawing.drawing import draw

        return draw(problem)
    from vibcli.drawing.symbols.mode_shape import draw

    return draw(moving(problem), index, both)
