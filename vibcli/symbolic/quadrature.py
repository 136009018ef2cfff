"""∫ f dx between places in letters, as a sum of values of f: right to more digits than doubles have, by rules on panels
on which f is smooth."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.smooth_panels import intervals, panels

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node


class WeightedPlace(NamedTuple):
    """A place of a rule, and its weight."""

    place: "Node"
    weight: "Node"


def rule_for(parts: "Sequence[Node]", x: "Node", ends: "tuple[Node, Node]", values: "Mapping[str, float]",
             longest: float) -> list[WeightedPlace]:
    """∫ f g dx = Σ weight f g for each of `parts`, f(x), and any smooth g that grows or turns by no more than some e⁸
    over the length `longest`; values: {name: number} of all symbols but x. NotSmooth where there is none."""
    found = []
    for low, high in intervals(parts, x, ends, values):
        first, last = evaluate([low, high], Floats, values)
        for panel in panels(lambda place: evaluate(parts, Floats, {**values, x.name: place}), (first, last),
                            longest / (last - first)):
            found += [WeightedPlace(low + (high - low) * r, (high - low) * w) for r, w in panel.points]
    return found


def weighed(part: "Node", x: "Node", rule: "Sequence[WeightedPlace]", shape: "Sequence[Node]") -> "Node":
    """Σ weight·f(place)·shape, `shape` being given at the places."""
    values = [substitute([part], {x: one.place})[0] * one.weight for one in rule]
    return part.table.total([value * there for value, there in zip(values, shape, strict=True)])
