"""The frames of a mode, or of any motion given in time, as a GIF, an SVG or a page."""

from collections.abc import Callable, Sequence
from math import ceil, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.drawing.canvas.primitives import Primitive, extent
from vibcli.drawing.layout import compose, lettering
from vibcli.drawing.member_motion import MemberMotion
from vibcli.drawing.symbols import mode_shape, path
from vibcli.drawing.vibration import Vibration, caption, magnification, mode, phases, response

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.results.problem import Problem

FRAMES, PACE = 36, 45               # of one period; milliseconds
PERIODS, SEEN, MOST = 8, 12, 240    # of the slowest mode; frames in a period of the fastest; frames
BELOW = 24.0        # the drawing: the words


def of_mode(problem: Any, index: int, normalise: str = "first") -> tuple[list[list[Any]], str, list[str]]:
    """(frames, caption, names of the frames) of one period of a mode."""
    found = mode(problem, index)
    stage = compose.Scenery(problem.scene)
    vibration = Vibration(problem, index, stage, normalise)
    angles, still = phases(FRAMES), path.draw(stage)
    frames = _drawn(problem, FRAMES, lambda i: still + mode_shape.frame(
        stage, vibration.at(angles[i]), vibration.unit, vibration.room, vibration.bends(angles[i])))
    return frames, caption(found), [f"{i / FRAMES:.2f} T" for i in range(FRAMES)]


def of_response(problem: Any) -> tuple[list[list[Any]], str, list[str]]:
    """The same of the motion that the scene asks for: a few of the slowest periods unless it is said until when."""
    import numpy as np

    from vibcli.language.parameters import require_values
    from vibcli.symbolic.parser import parse

    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, "the picture of a motion in time")
    if not problem.scene.bodies and not problem.scene.members:
        raise PhysicsError("this scene has no bodies, so its motion cannot be drawn",
                           "`vibcli response --plot` shows it over time")
    times = np.linspace(0.0, *_span(problem, problem.response.known))
    if problem.scene.members:
        return _with_members(problem, times)
    names = problem.scene.coordinates
    values = [problem.response.signal(parse(name)).values(times).tolist() for name in names]
    return of_positions(problem, [dict(zip(names, one, strict=True)) for one in zip(*values, strict=True)],
                         times.tolist())


def at_instant(problem: Any, instant: float) -> list[Any]:
    """The frame of a scene with members at an instant of its motion in time."""
    import numpy as np

    return _with_members(problem, np.array([instant]))[0][0]


def _with_members(problem: "Problem", times: "np.ndarray") -> "tuple[list[list[Primitive]], str, list[str]]":
    """The same of a scene with members, which are bent as the signals of their places tell."""
    from vibcli.symbolic.syntax import NameRef

    def values(name: str) -> "list[float]":
        found: list[float] = problem.response.signal(NameRef(0, len(name), name, 0)).values(times).tolist()
        return found

    stage = compose.Scenery(problem.scene)
    told = problem.scene.coordinates
    parts = [values(name) for name in told]
    base = problem.configuration.equilibrium.values
    positions = [{**base, **{name: part[i] for name, part in zip(told, parts, strict=True)}}
                 for i in range(len(times))]
    motion = MemberMotion(problem, stage, positions, values, response)
    if len(times) > 1 and motion.rests and not problem.scene.driven:
        raise _at_rest()
    words = f"{times[0]:.4g} s to {times[-1]:.4g} s" + (f", displacements × {motion.factor:.3g}"
                                                        if motion.placed else "")
    frames = _drawn(problem, len(times), lambda i: mode_shape.frame(stage, motion.sketches[i], motion.unit, motion.room,
                                                                    motion.bends(i)))
    return frames, words, [f"{t:.4g} s" for t in times.tolist()]


def of_positions(problem: Any, positions: Sequence[dict[str, float]],
                 times: Sequence[float]) -> tuple[list[list[Any]], str, list[str]]:
    """The same of a motion given as {coordinate: value} at each of the times in seconds.

    What could not be seen, and is not driven, is magnified.
    """
    stage = compose.Scenery(problem.scene)
    sketches, unit, room = response(stage, positions, times)
    if all(one == positions[0] for one in positions) and not problem.scene.driven:
        raise _at_rest()
    middle = _middle(problem, stage, positions)
    factor = 1.0 if problem.scene.driven else magnification(stage, stage.at(middle), sketches)
    if factor > 1:
        positions = [{name: middle[name] + factor * (x - middle[name]) for name, x in one.items()} for one in positions]
        sketches, unit, room = response(stage, positions, times)
    stage.sketch.numbers["magnified"] = factor
    words = f"{times[0]:.4g} s to {times[-1]:.4g} s" + (f", displacements × {factor:g}" if factor > 1 else "")
    still = path.draw(stage)
    frames = _drawn(problem, len(times), lambda i: still + mode_shape.frame(stage, sketches[i], unit, room))
    return frames, words, [f"{t:.4g} s" for t in times]


def _at_rest() -> PhysicsError:
    return PhysicsError("this scene stays at rest", "say under `initial` how it starts, or give it a load")


def _middle(problem: "Problem", stage: "Scenery", positions: Sequence[dict[str, float]]) -> dict[str, float]:
    """The position about which a motion is magnified: its mean, of what has gaps that from which these count."""
    if any("gap" in record for record in problem.scene.spec.connections):
        return {name: stage.sketch.values[name] for name in positions[0]}
    return {name: sum(one[name] for one in positions) / len(positions) for name in positions[0]}


def _drawn(problem: "Problem", count: int,
           frame: Callable[..., Any]) -> "list[list[Primitive]]":
    """frame(i) of each frame; a terminal is told how far they have come."""
    found = []
    with problem.work.task("the frames") as task:
        for i in range(count):
            found.append(frame(i))
            task.step(len(found) / count)
    return found


def _span(problem: "Problem", until: float) -> tuple[float, int]:
    """(the end, the number of frames): some periods of the slowest mode, each of the fastest seen in some frames."""
    speeds = [float(mode.omega) for mode in _modes(problem) if mode.omega]
    if not speeds:
        return until, MOST
    if problem.end is None:
        until = min(until, PERIODS * tau / min(speeds))
    return until, max(FRAMES, min(MOST, ceil(SEEN * until * max(speeds) / tau)))


def _modes(problem: "Problem") -> "Sequence[Mode]":
    try:
        found: list[Mode] = problem.modal.modes.shown()
        return found
    except PhysicsError:
        return ()


def data(frames: Sequence[list[Any]], words: str, names: Sequence[str], title: str, kind: str,
         milliseconds: int = PACE, closed: bool = False) -> bytes:
    """The bytes of an animation as gif, svg or html; closed: does its first frame follow the last?"""
    if kind == "gif":
        from vibcli.drawing.canvas.pillow_canvas import gif

        return gif(frames, words, milliseconds)
    from vibcli.drawing.canvas.svg_motion import moving

    if kind == "svg":
        return moving(captioned(frames, words), title or words, words if title else "", milliseconds, closed)
    from vibcli.drawing.canvas.page import page

    svg = moving(frames, title, words, milliseconds, closed, rests=False)
    return page(svg, title, words, names, milliseconds).encode()


def captioned(frames: Sequence[list[Any]], words: str) -> list[list[Any]]:
    """The frames with words below them."""
    boxes = [extent(frame) for frame in frames]
    below = lettering.text(lettering.words(words), min(box[0] for box in boxes), min(box[1] for box in boxes) - BELOW)
    return [[*frame, below] for frame in frames]
