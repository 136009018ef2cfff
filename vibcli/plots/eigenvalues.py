"""Eigenvalues in the complex plane, with rays of constant damping ratio ζ = −Re λ/|λ|."""

import math
from collections.abc import Sequence

from vibcli.plots.figure import Curve, Figure, Panel
from vibcli.plots.prefixes import labelled, largest, readable

_RATIOS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9)
_MOST_RAYS = 5
_ROUND_FROM = 0.4      # width to height from which both axes have one scale


def argand(eigenvalues: Sequence[complex], labels: Sequence[str], title: str) -> Figure:
    """Eigenvalues [1/s] as crosses with their labels; both axes have one scale where that can be read."""
    factor, unit = readable(largest(eigenvalues), "1/s")
    points = [(value.real * factor, value.imag * factor) for value in eigenvalues]
    left, right = (1.1 * max((sign * x for x, _ in points), default=0.0) for sign in (-1, 1))
    high = 1.1 * max((abs(y) for _, y in points), default=0.0)
    left, right = max(left, 0.1 * right), max(right, 0.1 * left)
    crosses = Curve("", tuple(x for x, _ in points), tuple(y for _, y in points), "markers", tuple(labels))
    panel = Panel(labelled("Re λ", unit), labelled("Im λ", unit.replace("1/s", "rad/s")),
                  curves=(*_rays(left, high), crosses),
                  equal=left + right > _ROUND_FROM * 2 * high, x_range=(-left, right) if left + right > 0 else None)
    return Figure(title, (panel,))


def _rays(left: float, high: float) -> list[Curve]:
    """Rays of constant ζ from the origin to the ends of the plot, those that are neither steep nor flat in it."""
    if not (left > 0 and high > 0):
        return []
    slopes = {zeta: math.sqrt((1 - zeta) * (1 + zeta)) / zeta for zeta in _RATIOS}
    shown = [zeta for zeta, slope in slopes.items() if 0.15 < slope * left / high < 12]
    step = -(-len(shown) // _MOST_RAYS) or 1
    rays = []
    for zeta in shown[::step]:
        x = -min(left, high / slopes[zeta])
        y = -x * slopes[zeta]
        rays += [Curve("", (0.0, x), (0.0, y), "guide", ("", f"ζ = {zeta:g}")),
                 Curve("", (0.0, x), (0.0, -y), "guide")]
    return rays
