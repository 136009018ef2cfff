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
    """The signal as a function of the coordinates, everything being at rest, under a tension that does not vary."""
    if signal.motion is not None:
        return signal.motion
    tension, own = signal.tension(scene)[0], _given_along(scene, signal)
    foundation, length = signal.segment.foundation, signal.length
    load = _particular(scene, signal, tension, foundation)
    shift = [_derivative(scene, load, k, x) for x in (scene.table.zero, length)
             for k in range(2 if signal.member.kind.bends else 1)]
    ends = [end - part for end, part in zip(signal.ends, shift, strict=True)]
    found = _between(scene, signal, (length, tension, foundation), ends)
    return signal.factor * (found + _derivative(scene, load, signal.order, signal.at)) + own


def _between(scene, signal, piece, ends):
    """The derivative of u that the ends alone leave."""
    length, tension, foundation = piece
    bends = signal.member.kind.bends
    if foundation.is_zero and (not bends or tension.is_zero):
        shapes = (_cubic if bends else _linear)(scene, length)
        return scene.table.total([_derivative(scene, shape, signal.order, signal.at) * end
                                  for shape, end in zip(shapes, ends, strict=True)])
    if bends:
        return _across(scene, signal, piece, ends)
    return _along(scene, signal, scene.table.sqrt(foundation / tension), length, ends)


def _particular(scene, signal, tension, foundation):
    """Powers of x in one u that the weight w leaves: w/k, −w x²/(2N), w x⁴/(24B)."""
    zero, load = scene.table.zero, signal.weight(scene)
    if load.is_zero:
        return []
    if not foundation.is_zero:
        return [load / foundation]
    if not tension.is_zero:
        return [zero, zero, -load / (2 * tension)]
    return [zero, zero, zero, zero, load / (24 * signal.segment.stiffness)]


def _given_along(scene, signal):
    """What the force or stress of a bar in the plane holds besides: its tension as drawn, and what it lengthens as it
    turns."""
    if not signal.member.turns or signal.order != 1:
        return scene.table.zero
    record, first, last = signal.member.record, signal.member.stations[0], signal.member.stations[-1]
    apart = signal.member.length + (last.along - first.along)
    longer = (scene.distance(apart, last.u - first.u) - apart) / signal.member.length
    preload = scene.lower(record["preload"]) if "preload" in record else scene.table.zero
    return signal.factor * (longer + preload / signal.segment.stiffness)


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
