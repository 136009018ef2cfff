"""The frames of a mode, or of any motion given in time, as a GIF or a page."""

from vibcli.report.drawing import compose, mode_shape
from vibcli.report.drawing.vibration import Vibration, caption, mode, phases, response

FRAMES, PACE = 36, 45       # of one period; milliseconds


def of_mode(problem, index):
    """(frames, caption, names of the frames) of one period of a mode."""
    found = mode(problem, index)
    stage = compose.Stage(problem.scene)
    vibration = Vibration(problem, index, stage)
    frames = [mode_shape.frame(stage, vibration.at(theta), vibration.unit) for theta in phases(FRAMES)]
    return frames, caption(found), [f"{i / FRAMES:.2f} T" for i in range(FRAMES)]


def of_motion(problem, position, times):
    """The same of a motion: `position(t)` gives {coordinate: value}, at each of the times in seconds."""
    stage = compose.Stage(problem.scene)
    sketches, unit = response(stage, map(position, times))
    return [mode_shape.frame(stage, sketch, unit) for sketch in sketches], "", [f"{t:.4g} s" for t in times]


def data(frames, words, names, title, kind, milliseconds=PACE):
    """The bytes of an animation as gif or html."""
    if kind == "gif":
        from vibcli.report.drawing.pillow_canvas import gif

        return gif(frames, words, milliseconds)
    from vibcli.report.drawing.page import page

    return page(frames, title, words, names, milliseconds).encode()
