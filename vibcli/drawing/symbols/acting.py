"""What a load is worth when it acts: at the first instant and rate at which it is not zero, its blows as large as their
impulses."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING

from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.symbolic.node import Node

INSTANTS, LATER, LEAST = (0.0, 1e-6, 0.37, 1.13, 2.71), 1e-6, 1e-12


class _Blows(Floats):
    """Floats, an impulse being 1 where it acts."""

    functions = {**Floats.functions, "impulse": lambda u, order=0: float(abs(u) < LATER**2)}


def values(nodes: "Sequence[Node]", sketch: "Sketch",
           places: Sequence[Mapping[str, float]] = ({},)) -> list[list[float]]:
    """[the values of the nodes] at each of the places; zeros of what never acts."""
    for instant in (*INSTANTS, *_begins(nodes, sketch)):
        found = [_at(instant, nodes, sketch, place) for place in places]
        if LEAST < max(abs(value) for one in found for value in one) < float("inf"):
            return found
    return [[0.0] * len(nodes) for _ in places]


def _at(instant: float, nodes: "Sequence[Node]", sketch: "Sketch", place: Mapping[str, float]) -> list[float]:
    """The values of some nodes at an instant; at all but the first each coordinate has the rate 1."""
    rate = float(bool(instant))
    known = {**sketch.values, **place, sketch.scene.time.name: instant}
    return evaluate(nodes, _Blows, defaultdict(lambda: rate, known))


def _begins(nodes: "Sequence[Node]", sketch: "Sketch") -> list[float]:
    """When pulses of the nodes begin, and just after, in order; their arguments are linear in the time."""
    found = set()
    for call in reachable(nodes):
        if call.op == "call" and call.name in PULSES and call.args[0].mask == sketch.scene.time.mask:
            (start,), (later,) = (_at(instant, call.args[:1], sketch, {}) for instant in (0.0, 1.0))
            if later != start and isfinite(when := start / (start - later)) and when > 0:
                found |= {when, when * (1 + LATER)}
    return sorted(found)
