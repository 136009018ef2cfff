"""Fields u(x) and u̇(x) of members that are no sums of powers, exponentials and sines, as polynomials on panels.

What is said to rounding is the highest derivative that the equation of the member holds, u″ or u⁗: u is its integral,
so that forces that the field needs are as exact as itself.
"""

from math import factorial
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.mechanics.smooth_forms import legendre_powers
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.smooth_panels import intervals, panels

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node


def smooth_field(nodes: "Mapping[int, Node]", x: "Node", end: "Node", values: "Mapping[str, float]",
                 orders: "Sequence[int]") -> Forcing:
    """{channel: function} from x = 0 to an end, of each channel the derivative that is said; values: {name: number} of
    all symbols but x. NotSmooth where it jumps at a place that is not found, or is infinite."""
    rows = {channel: _slopes(node, x, orders[channel]) for channel, node in nodes.items()}
    said, found = [row[-1] for row in rows.values()], []
    for low, high in intervals([*nodes.values(), *said], x, (x.table.zero, end), values):
        a, b = evaluate([low, high], Floats, values)
        for panel in panels(lambda place: evaluate(said, Floats, {**values, x.name: place}), (a, b), broken=False):
            start, length = a + (b - a) * float(panel.a), (b - a) * float(panel.b - panel.a)
            waves = [Wave(channel, c, k, 0j) for channel, row in rows.items()
                     for k, c in enumerate(_powers(row, x, start, length, values)) if c]
            found.append(Segment(start, tuple(waves)))
    return Forcing(len(orders), found)


def _slopes(node: "Node", x: "Node", order: int) -> "list[Node]":
    found = [node]
    for _ in range(order):
        found.append(gradient(found[-1]).get(x, x.table.zero))
    return found


def _powers(row: "Sequence[Node]", x: "Node", start: float, length: float,
            values: "Mapping[str, float]") -> list[float]:
    """Coefficients of powers of the distance from the start of a panel."""
    highest = legendre_powers(row[-1], x, (start, start + length), values)
    return integrated(evaluate(row[:-1], Floats, {**values, x.name: start + length / 2}), highest, length)


def integrated(given: "Sequence[float]", highest: "Sequence[float]", length: float) -> list[float]:
    """Coefficients of powers of the distance from the start of a panel, of a function with derivatives `given` in its
    middle and the next one in powers of −1 … 1."""
    half, order = length / 2, len(given)
    about = [c * half**k / factorial(k) for k, c in enumerate(given)]
    about += [c * half**order * factorial(k) / factorial(k + order) for k, c in enumerate(highest)]
    moved = np.asarray(np.polynomial.Polynomial(about)(np.polynomial.Polynomial([-1.0, 2.0])).coef, float)
    return cast("list[float]", (moved / length ** np.arange(len(moved))).tolist())
