"""Shapes of modes of lumped coordinates: the amplitude of each as a bar, a line through them."""

from vibcli.plots.figure import Curve, Figure, Panel


def mode_bars(coordinates, shapes, labels, title="", note=""):
    """A panel for each mode: `shapes`, real amplitudes in the order of the coordinates; `labels`: ω₁ = 3.2 rad/s."""
    places = tuple(range(1, len(coordinates) + 1))
    names = tuple(zip(places, coordinates, strict=True))
    scale = 1.1 * max((abs(value) for shape in shapes for value in shape), default=0.0) or 1.0
    panels = []
    for shape, label in zip(shapes, labels, strict=True):
        shape = tuple(map(float, shape))
        panels.append(Panel(label, "", "", tall=0.5, names=names, y_range=(-scale, scale), curves=(
            Curve("", places, shape, "guide"), Curve("", places, shape, "stem"))))
    return Figure(title, tuple(panels), note)
