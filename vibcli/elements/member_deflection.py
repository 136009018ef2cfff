"""The deflection of uniform pieces of members at rest, between displacements of their ends.

    N u″ = k u:             u = u₀ sinh β(l − x)/sinh βl + u_l sinh βx/sinh βl, β² = k/N; linear without a foundation
    B u⁗ − N u″ + k u = 0:  even and odd solutions about the middle; without N and k cubic (Hermite)
"""

from typing import TYPE_CHECKING, Any

from vibcli.elements.member_springs import even_solutions, odd_solutions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def static_signal(scene: "Scene", signal: "PlaceSignal") -> "Node":
    """The signal as a function of the coordinates, everything being at rest."""
    if signal.motion is not None:
        return signal.motion
    length, ends = signal.right.place - signal.left.place, [*signal.left.motions, *signal.right.motions]
    tension, foundation = signal.tension(scene), signal.segment.foundation
    bends = signal.member.kind.bends
    if foundation.is_zero and (not bends or tension.is_zero):
        shapes = (_cubic if bends else _linear)(scene, length)
        found = scene.table.total([_derivative(scene, shape, signal.order, signal.at) * end
                                   for shape, end in zip(shapes, ends, strict=True)])
    elif bends:
        found = _across(scene, signal, (length, tension, foundation), ends)
    else:
        found = _along(scene, signal, scene.table.sqrt(foundation / tension), length, ends)
    return signal.factor * found


def _linear(scene: Any, length: "Node") -> "list[list[Node]]":
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


def _along(scene, signal, beta, length, ends):
    """u or u′ of a piece of order 2 on a foundation."""
    call, whole = scene.table.call, scene.table.call("sinh", beta * length)
    rest = length - signal.at
    if signal.order == 0:
        return (ends[0] * call("sinh", beta * rest) + ends[1] * call("sinh", beta * signal.at)) / whole
    return beta * (ends[1] * call("cosh", beta * signal.at) - ends[0] * call("cosh", beta * rest)) / whole


def _across(scene: "Scene", signal: "PlaceSignal", piece: "tuple[Node, Node, Node]", ends: "Sequence[Node]") -> "Node":
    """A derivative of the deflection of a beam under tension or on a foundation, {u₀, θ₀, u_l, θ_l} its ends."""
    length, tension, foundation = piece
    first, turned, last, turned_last = ends
    total = scene.table.zero
    for solutions, value, slope in ((even_solutions, (last + first) / 2, (turned_last - turned) / 2),
                                    (odd_solutions, (last - first) / 2, (turned_last + turned) / 2)):
        of = signal.segment.stiffness, tension, foundation
        (u, u1, *_), (w, w1, *_) = solutions(scene, length / 2, *of)
        one, two = (found[signal.order] for found in solutions(scene, signal.at - length / 2, *of))
        total = total + ((value * w1 - slope * w) * one + (slope * u - value * u1) * two) / (u * w1 - w * u1)
    return total
