"""Linear functions y = constant + q·δ + v·δ̇ + a·δ̈ + what depends on the time, of coordinates and inputs."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class LinearFunction(NamedTuple):
    """Coefficients {i: number} of the deviations, their rates and accelerations; `time`: [(factor, node of t)]."""

    constant: float
    time: "list[tuple[Any, Node]]"
    q: dict[int, Any]
    v: dict[int, Any]
    a: dict[int, Any]


def combined(pairs: Any) -> LinearFunction:
    """Σ factor·row of (factor, row) pairs."""
    constant, time, totals = 0.0, [], ({}, {}, {})
    for factor, row in pairs:
        constant += factor * row.constant
        time += [(factor * weight, node) for weight, node in row.time]
        for total, part in zip(totals, (row.q, row.v, row.a), strict=True):
            for i, x in part.items():
                total[i] = total.get(i, 0.0) + factor * x
    return LinearFunction(constant, time, *totals)


def rate(row: LinearFunction, scene: "Scene") -> LinearFunction:
    """ẏ; PhysicsError where it would need a third derivative."""
    if row.a:
        raise PhysicsError("the rate of a force of inertia is no function of places, velocities and accelerations",
                           "ask for the force itself")
    return LinearFunction(0.0, [(weight, scene.rate(node)) for weight, node in row.time], {}, row.q, row.v)


def product(one: LinearFunction, two: LinearFunction) -> LinearFunction:
    """one·two to first order."""
    if one.time and two.time:
        raise PhysicsError("a product of two driven quantities is not linear", "ask for each of them")
    return combined([(two.constant, one), (one.constant, two)])._replace(constant=one.constant * two.constant)
