"""`vibcli animate FILE`: a mode, or the motion in time, moving."""

from collections.abc import Sequence
from typing import Any

import click

from vibcli.cli.common import accuracy_option, integrated, load
from vibcli.cli.pictures import one, picture_options, target, write

SUFFIXES = (".gif", ".svg", ".html")


@click.command("animate")
@picture_options(SUFFIXES)
@click.option("--mode", "index", type=click.IntRange(1), metavar="I",
              help="Which mode, by ascending frequency (1 unless given).")
@click.option("--response", is_flag=True, help="The motion in time instead of a mode.")
@click.option("--until", metavar="TIME", help="With --response: its end, as 2 (seconds) or '500 ms'.")
@accuracy_option
def command(file: str, settings: Sequence[Any], case: Any, output: str | None, force: bool, patience: int,
            index: int | None, response: bool, until: str | None, accuracy: float | None) -> None:
    """A mode shape or the motion in time, moving: a gif, an svg, or an html page with play, pause and a slider."""
    if response and index is not None:
        raise click.UsageError("--response and --mode exclude each other")
    if until is not None and not response:
        raise click.UsageError("--until belongs to --response")
    if accuracy is not None and not response:
        raise click.UsageError("--accuracy belongs to --response")
    (_, problem), = integrated([(None, one(load(file, settings, patience), case))], accuracy)
    path = target(file, output, SUFFIXES, force, case, "response" if response else f"mode{index or 1}")
    if until is not None:
        from vibcli.cli.response import ending

        (_, problem), = ending([(None, problem)], until)
    from vibcli.api.pictures import animated

    title = problem.spec.get("title") or path.stem
    write(path, animated(problem, None if response else index or 1, title, path.suffix[1:].lower()), force)
