"""Pictures of the scene and of its mode shapes, where they are asked for."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Picture, Section, paragraph, section

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SHOWN, DIAGRAMS = 6, 3       # mode shapes; of them with forces and moments


def schematic(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.drawing.drawing import contents, draw

    yield from section("Figure", drawing("scene", "The scene as drawn", draw(problem), contents(problem.spec)))


def lettering(problem: "Problem") -> list[str]:
    """The texts that stand in the schematic."""
    from vibcli.drawing.drawing import draw

    return ["".join(run.text for run in getattr(primitive, "runs", ())) for primitive in draw(problem)]


def mode_pictures(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The shapes of the lowest modes on the scene at rest; none of one that is given by energies or matrices alone."""
    if not (problem.scene.bodies or problem.scene.members):
        return
    title = "Mode shapes on the scene at rest"
    if problem.numeric.has_free_symbols:
        named = ", ".join(problem.scene.parameters.free)
        yield from section(title, paragraph(f"not drawn: these parameters have no values: {named}"))
        return
    from vibcli.drawing.symbols.mode_shape import draw
    from vibcli.drawing.vibration import caption
    from vibcli.report.sections.shown_modes import shown

    moving = [mode for mode in shown(problem, report.wanted) if not mode.rigid][:SHOWN]
    pictures: list[Picture] = []
    for mode in moving:
        drawn = draw(problem, mode.index, normalise=report.normalise)[:-1]     # its caption stands below it
        pictures.append(drawing(f"mode-{mode.index}", caption(mode), drawn)._replace(
            animated=partial(_moving, problem, mode.index, report.normalise)))
        if len(pictures) < 2 * DIAGRAMS:
            pictures += _forces_of(problem, mode, report.normalise)
    yield from section(title, *pictures)


def _forces_of(problem: "Problem", mode: Any, normalise: str) -> list[Picture]:
    """A Picture of the forces and moments within members in a mode; none without them."""
    if not problem.scene.members:
        return []
    from vibcli.drawing.member_diagrams import draw
    from vibcli.results.internal_forces import forces_of_mode

    try:
        drawn = draw(problem.scene, forces_of_mode(problem, mode.index, normalise), ())
    except PhysicsError:
        return []
    return [drawing(f"mode-{mode.index}-forces", f"forces and moments within members in mode {mode.index}", drawn)]


def _moving(problem: "Problem", index: int, normalise: str) -> bytes:
    """The bytes of an SVG of a mode that moves."""
    from vibcli.drawing.animation import PACE, of_mode
    from vibcli.drawing.canvas.svg_motion import moving

    frames, words, _ = of_mode(problem, index, normalise)
    return moving(frames, words, milliseconds=PACE, closed=True)


def plot(name: str, caption: str, figure: Any) -> Picture:
    """A Picture of a Figure, in the width of a column."""
    from vibcli.plots.picture import picture
    from vibcli.plots.style import COLUMN

    return Picture(name, caption, partial(picture, figure, inches=COLUMN))


def drawing(name: str, caption: str, primitives: Any, about: str = "") -> Picture:
    """A Picture of what is drawn."""
    from vibcli.drawing.canvas.files import data

    return Picture(name, caption, partial(data, primitives, title=caption, about=about), about=about)
