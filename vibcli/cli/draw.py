"""`vibcli draw FILE`: the scene as a figure."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from vibcli.cli.common import load
from vibcli.cli.pictures import one, picture_options, target, write

if TYPE_CHECKING:
    from collections.abc import Mapping

SUFFIXES = (".png", ".svg", ".pdf")


@click.command("draw")
@picture_options(SUFFIXES)
@click.option("--mode", "index", type=click.IntRange(1), metavar="I",
              help="The shape of mode I over the scene at rest.")
@click.option("--both", is_flag=True, help="With --mode: displaced the other way as well, dashed.")
@click.option("--equivalent", "place", metavar="P", help="The perpendicular pair of springs, and of dampers, that "
              "resists like those that end at the body or point P, in their stead.")
@click.option("--diagrams", is_flag=True, help="Forces and moments within members along each, below the scene: in "
              "equilibrium, with --mode those of a mode.")
@click.option("--at", "instant", metavar="TIME", help="With --diagrams: those of the motion at this instant, as 2.5 or "
              "'40 ms'.")
@click.option("--amplitudes", is_flag=True, help="With --diagrams: amplitudes of the steady state.")
@click.option("--plot", is_flag=True, help="With --diagrams: in the terminal; a file is written where -o names one.")
def command(file: str, settings: Sequence[Any], case: str | None, output: str | None, force: bool, patience: int,
            index: int | None, both: bool, place: str | None, diagrams: bool, instant: str | None, amplitudes: bool,
            plot: bool) -> None:
    """The scene as a textbook figure, a mode shape on it, or diagrams of the forces and moments within its members:
    png, svg or pdf by the suffix of the file."""
    _refuse(index, both, place, diagrams, {"--at": instant, "--amplitudes": amplitudes, "--plot": plot})
    at = None if instant is None else _instant(instant)
    problem = one(load(file, settings, patience), case)
    path = None if plot and output is None else target(file, output, SUFFIXES, force, case, "diagrams" * diagrams,
                                                       f"mode{index}" if index else None,
                                                       place and f"equivalent_{place}")
    from vibcli.api.pictures import SceneDrawing

    if place is not None:
        write(path, SceneDrawing.of_equivalent(problem, place).data(path.suffix[1:].lower()), force)
        return
    if not diagrams:
        write(path, SceneDrawing.of(problem, index, both).data(path.suffix[1:].lower()), force)
        return
    from vibcli.api.source import settled
    from vibcli.report.sections.force_diagrams import WhichForces, force_figure

    problem, which = settled(problem), WhichForces(index, at, amplitudes)
    if path is not None:
        write(path, SceneDrawing.of_forces(problem, which).data(path.suffix[1:].lower()), force)
    if plot:
        from vibcli.cli.sampled import show_curves

        show_curves(True, (), force, "", lambda: force_figure(problem, which))


def _instant(text: str) -> float:
    """A time [s] given on the command line."""
    from vibcli.cli.sampled import INSTANT, size

    return float(size(text, "--at", "s", INSTANT, exact=True))


def _refuse(index: int | None, both: bool, place: str | None, diagrams: bool,
            further: "Mapping[str, str | bool | None]") -> None:
    """A usage error where options do not go together."""
    if place is not None and (index is not None or both or diagrams):
        raise click.UsageError("--equivalent stands alone")
    if both and (index is None or diagrams):
        raise click.UsageError("--both does not go with --diagrams" if diagrams else "--both belongs to --mode")
    idle = next((option for option, given in further.items() if given), None)
    if idle and not diagrams:
        raise click.UsageError(f"{idle} belongs to --diagrams")
    if (index is not None) + bool(further["--at"]) + bool(further["--amplitudes"]) > 1:
        raise click.UsageError("--mode, --at and --amplitudes exclude each other")
