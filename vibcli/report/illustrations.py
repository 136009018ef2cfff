"""Pictures of the scene and of its mode shapes, where they are asked for."""

from functools import partial

from vibcli.report.blocks import Picture, section

SHOWN = 6       # mode shapes


def schematic(problem, _):
    from vibcli.report.drawing.drawing import draw

    yield from section("The scene", _picture("scene", "The scene as drawn", draw(problem)))


def mode_pictures(problem, _):
    """The shapes of the lowest modes on the scene at rest."""
    if problem.symbolic:
        return
    from vibcli.report.drawing.mode_shape import draw
    from vibcli.report.drawing.vibration import caption

    moving = [mode for mode in problem.modes if not mode.rigid][:SHOWN]
    yield from section("Mode shapes on the scene at rest", *(
        _picture(f"mode-{mode.index}", caption(mode), draw(problem, mode.index)) for mode in moving))


def _picture(name, caption, primitives):
    from vibcli.report.drawing.matplotlib_canvas import picture

    return Picture(name, caption, partial(picture, primitives))
