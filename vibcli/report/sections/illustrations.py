"""Pictures of the scene and of its mode shapes, where they are asked for."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Picture, Section, section

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SHOWN = 6       # mode shapes


def schematic(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.drawing.drawing import draw

    yield from section("The scene", _picture("scene", "The scene as drawn", draw(problem)))


def mode_pictures(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The shapes of the lowest modes on the scene at rest."""
    if problem.numeric.has_free_symbols:
        return
    from vibcli.drawing.symbols.mode_shape import draw
    from vibcli.drawing.vibration import caption
    from vibcli.report.sections.shown_modes import shown

    moving = [mode for mode in shown(problem, report.wanted) if not mode.rigid][:SHOWN]
    yield from section("Mode shapes on the scene at rest", *(
        _picture(f"mode-{mode.index}", caption(mode), draw(problem, mode.index, normalise=report.normalise))._replace(
            animated=partial(_moving, problem, mode.index, report.normalise)) for mode in moving))


def _moving(problem, index, normalise):
    """The bytes of a GIF of a mode."""
    from vibcli.drawing.animation import data, of_mode

    return data(*of_mode(problem, index, normalise), title="", kind="gif")


def plot(name: str, caption: str, figure: Any):
    """A Picture of a Figure."""
    from vibcli.plots.picture import picture

    return Picture(name, caption, partial(picture, figure))


def _picture(name, caption, primitives):
    from vibcli.drawing.canvas.matplotlib_canvas import picture

    return Picture(name, caption, partial(picture, primitives))
