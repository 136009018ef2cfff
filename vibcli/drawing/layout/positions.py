"""The symbols of a scene in a position, and what stays together in all of them."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene


def values_at(scene: "Scene", position: Mapping[str, float] | None = None, time: float = 0.0) -> dict[str, float]:
    """{symbol: number} with `position` ({coordinate: number}), the dependent coordinates included; None where the
    loops of the scene cannot follow."""
    values = scene.drawn_values
    target = {**values, **(position or {}), scene.time.name: time}
    if scene.loops is not None and (position or time):
        target = scene.loops.followed(values, target)
        if target is None:
            return None
    nodes = scene.dependent
    return {**target, **dict(zip(nodes, evaluate(list(nodes.values()), Floats, target), strict=True))}
