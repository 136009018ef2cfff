"""The deflection of uniform pieces of members at rest, between displacements of their ends.

    N u″ = k u:             u = u₀ sinh β(l − x)/sinh βl + u_l sinh βx/sinh βl, β² = k/N; linear without a foundation
    B u⁗ − N u″ + k u = 0:  even and odd solutions about the middle; without N and k cubic (Hermite)
"""

from typing import TYPE_CHECKING, Any

from vibcli.elements.member_springs import even_solutions, odd_solutions
from vibcli.symbolic.antiderivatives import antiderivative
from vibcli.symbolic.derivatives import gradient, substitute

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
    xi = scene.table.variable("the place on a piece")
    load = _particular(scene, signal, tension, foundation, xi)
    shift = [_at(scene, load, xi, k, x) for x in (scene.table.zero, length)
             for k in range(2 if signal.member.kind.bends else 1)]
    ends = [end - part for end, part in zip(signal.ends, shift, strict=True)]
    found = _between(scene, signal, (length, tension, foundation), ends)
    return signal.factor * (found + _at(scene, load, xi, signal.order, signal.at)) + own


def _at(scene, load, xi, order, place):
    """A derivative of a function of ξ at a place."""
    for _ in range(order):
        load = gradient(load).get(xi, scene.table.zero)
    return substitute([load], {xi: place})[0]


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


def _particular(scene, signal, tension, foundation, xi):
    """One u(ξ) that the loads leave: w/k, −w ξ²/(2N), w ξ⁴/(24B) of the even ones; of others q, which stand where there
    is neither foundation nor tension of a beam, −∫∫ q/N or ∫∫∫∫ q/B."""
    bending, bends = signal.segment.stiffness, signal.member.kind.bends
    even, found = signal.weight(scene), scene.table.zero
    if not even.is_zero:
        found = even / foundation if not foundation.is_zero else -even * xi**2 / (2 * tension) if not (
            tension.is_zero) else even * xi**4 / (24 * bending)
    for load in signal.uneven(scene):
        q = substitute([load.q], {load.x: signal.left.place + xi})[0]
        for _ in range(4 if bends else 2):
            q = None if q is None else antiderivative(q, xi)
        if q is None:
            return scene.report(load.where, f"the deflection under '{load.owner}' is not found in closed form",
                                "let it be a sum of powers, sines and exponentials")
        found = found + (q / bending if bends else -q / tension)
    return found


def _given_along(scene, signal):
    """What the force or stress of a bar in the plane holds besides: its tension as drawn, and what it lengthens as it
    turns; of a beam that stretches its tension as drawn."""
    if not signal.member.lengthwise or signal.order != 1:
        return scene.table.zero
    record, first, last = signal.member.record, signal.member.stations[0], signal.member.stations[-1]
    longer = scene.table.zero
    if signal.member.turns:
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
