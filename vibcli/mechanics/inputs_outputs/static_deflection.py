"""The deflection of pieces of members at rest, between displacements of their ends.

Without tension and foundation it is cubic (Hermite), of bars, shafts and strings linear.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.mechanics.inputs_outputs.place_signals import PlaceSignal
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def static_signal(scene: "Scene", signal: "PlaceSignal") -> "Node":
    """The signal as a function of the coordinates, everything being at rest."""
    if signal.motion is not None:
        return signal.motion
    bent = signal.member.kind.bends and "preload" in signal.member.record
    if bent or not signal.segment.foundation.is_zero:
        raise PhysicsError(f"how '{signal.member.name}' deflects at rest between its stations is not found where it is "
                           + ("under tension" if bent else "on a foundation"),
                           "ask for a place where something is attached")
    length, ends = signal.right.place - signal.left.place, [*signal.left.motions, *signal.right.motions]
    shapes = (_cubic if signal.member.kind.bends else _linear)(scene, length)
    total = scene.table.zero
    for coefficients, end in zip(shapes, ends, strict=True):
        total = total + _derivative(scene, coefficients, signal.order, signal.at) * end
    return signal.factor * total


def _linear(scene: Any, length: "Node"):
    """Powers of x in the shapes of u₀ and u_l."""
    zero, one = scene.table.zero, scene.table.one
    return [[one, -1 / length], [zero, 1 / length]]


def _cubic(scene, length):
    """Those of u₀, θ₀, u_l, θ_l."""
    zero, one = scene.table.zero, scene.table.one
    return [[one, zero, -3 / length**2, 2 / length**3], [zero, one, -2 / length, 1 / length**2],
            [zero, zero, 3 / length**2, -2 / length**3], [zero, zero, -1 / length, 1 / length**2]]


def _derivative(scene, coefficients, order, x):
    """Of Σ cₖ xᵏ."""
    total, power = scene.table.zero, scene.table.one
    for k in range(order, len(coefficients)):
        factor = 1
        for i in range(order):
            factor *= k - i
        total, power = total + factor * coefficients[k] * power, power * x
    return total
