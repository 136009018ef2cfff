"""`vibcli animate FILE`: a mode in motion."""

import click

from vibcli.cli.common import load
from vibcli.cli.pictures import moving, one, picture_options, target, write

SUFFIXES = (".gif", ".html")


@click.command("animate")
@picture_options(SUFFIXES)
@click.option("--mode", "index", type=click.IntRange(1), metavar="I", default=1,
              help="Which mode (default: 1), by ascending frequency.")
def command(file, settings, case, output, force, index):
    """A mode shape in motion: an animated gif, or an html page with play, pause and a slider, complete in itself."""
    problem = one(load(file, settings), case)
    path = target(file, output, SUFFIXES, force, case, f"mode{index}")
    from vibcli.report.drawing.animation import data, of_mode

    title = problem.spec.get("title") or path.stem
    write(path, data(*of_mode(moving(problem), index), title=title, kind=path.suffix[1:].lower()))
