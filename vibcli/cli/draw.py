"""`vibcli draw FILE`: the scene as a figure."""

import click

from vibcli.cli.common import load
from vibcli.cli.pictures import one, picture_options, target, write

SUFFIXES = (".png", ".svg", ".pdf")


@click.command("draw")
@picture_options(SUFFIXES)
def command(file, settings, case, output, force):
    """The scene as a textbook figure: png, svg or pdf by the suffix of the file."""
    problem = one(load(file, settings), case)
    path = target(file, output, SUFFIXES, force, case)
    from vibcli.report.drawing.drawing import draw
    from vibcli.report.drawing.matplotlib_canvas import picture

    write(path, picture(draw(problem), path.suffix[1:].lower()))
