"""Springs: a zigzag between two ends, a spiral about a joint."""

from math import pi, tau

from vibcli.drawing.canvas.primitives import Polyline
from vibcli.drawing.layout import plane

WIDTH, COIL, LEAD, MOST = 5.0, 6.5, 7.0, 16     # half the width of a zigzag, a coil, a straight end; coils


def zigzag(start, end, drawn):
    """A spring from one place to another, with the coils and straight ends that fit the length `drawn`."""
    length, at = plane.distance(start, end), plane.along(start, end)
    coils = max(3, min(MOST, round(drawn / COIL) - 2))
    lead = min(max(LEAD, (drawn - 1.2 * COIL * MOST) / 2), 0.15 * drawn if drawn < 80 else 0.4 * drawn)
    lead = min(lead, 0.4 * length)
    step = (length - 2 * lead) / coils
    points = [start, at(lead)]
    for i in range(coils):
        points += [at(lead + (i + 0.25) * step, WIDTH), at(lead + (i + 0.75) * step, -WIDTH)]
    return [Polyline((*points, at(length - lead), end), "spring")]


def spiral(centre, from_angle, to_angle, radius=13.0):
    """A torsion spring about a joint, from its core to the two that it turns."""
    turns = tau + (to_angle - from_angle) % tau
    turns += tau * (turns < 3 * pi)
    count = 70
    points = [plane.polar(centre, 4.0 + (radius - 4.0) * i / count, from_angle + turns * i / count)
              for i in range(count + 1)]
    return [Polyline(tuple(points), "spring")]
