"""The scene as a figure, a mode shape on it, or either moving."""

from contextlib import suppress
from os import PathLike
from typing import TYPE_CHECKING

from vibcli.api.source import settled
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.report.sections.force_diagrams import WhichForces
    from vibcli.results.problem import Problem

SUFFIXES = (".png", ".svg", ".pdf")


class SceneDrawing(NamedTuple):
    """A figure: the strokes, areas and letters that it is made of; what it is, and what it shows, in words."""

    primitives: list[object]
    title: str = ""
    about: str = ""

    @classmethod
    def of(cls, problem: "Problem", mode: int | None = None, both: bool = False) -> "SceneDrawing":
        """The scene as drawn, with what it chooses where that is found; or the shape of a mode over it; `both`:
        displaced the other way as well, dashed."""
        if mode is None:
            from vibcli.drawing.drawing import draw

            with suppress(PhysicsError, SpecError):
                problem = settled(problem)
            return cls(draw(problem), *_words(problem))
        from vibcli.drawing import vibration
        from vibcli.drawing.symbols.mode_shape import draw as draw_mode

        problem = settled(problem)
        drawn = draw_mode(problem, mode, both)
        return cls(drawn, *_words(problem, vibration.caption(vibration.mode(problem, mode))))

    @classmethod
    def of_equivalent(cls, problem: "Problem", place: str) -> "SceneDrawing":
        """The scene with the pair that resists like the springs, and the dampers, that end at a place."""
        from vibcli.drawing.drawing import draw
        from vibcli.results.equivalent_pair import with_pair

        return cls(draw(with_pair(settled(problem), place)), *_words(problem, f"the equivalent pair at {place}"))

    @classmethod
    def of_forces(cls, problem: "Problem", which: "WhichForces") -> "SceneDrawing":
        """Diagrams of forces and moments within members, below the scene."""
        from vibcli.report.sections.force_diagrams import force_drawing

        return cls(force_drawing(settled(problem), which), *_words(problem, "forces and moments within members"))

    def data(self, kind: str = "svg") -> bytes:
        """The bytes of a png, svg or pdf."""
        if f".{kind}" not in SUFFIXES:
            raise ValueError(f"a picture is a {' or '.join(SUFFIXES)}, not a .{kind}".replace(".", ""))
        from vibcli.drawing.canvas.files import data

        return data(self.primitives, kind, self.title, self.about)

    def save(self, path: "str | PathLike[str]") -> None:
        """Write a .png, .svg or .pdf file, in the place of one that is there."""
        from pathlib import Path

        from vibcli.base.output_files import refuse_unwritable, write_whole

        path = Path(path)
        refuse_unwritable(path, SUFFIXES)
        write_whole(path, self.data(path.suffix[1:].lower()))

    def _repr_svg_(self) -> str:
        return self.data("svg").decode()


def _words(problem: "Problem", told: str = "") -> tuple[str, str]:
    """(the title of a picture of a scene, what the scene consists of)."""
    from vibcli.drawing.drawing import contents

    return ": ".join(filter(None, (problem.spec.get("title") or "A scene", told))), contents(problem.spec)


def animated(problem: "Problem", mode: int | None, title: str, kind: str) -> bytes:
    """The bytes of a gif, an svg or an html page of a mode, or of the motion in time where none is named."""
    from vibcli.drawing.animation import data, of_mode, of_response

    problem = settled(problem)
    frames = of_response(problem) if mode is None else of_mode(problem, mode)
    with problem.work.task("the picture"):
        return data(*frames, title=title, kind=kind, closed=mode is not None)
