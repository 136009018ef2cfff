"""Signals of places on members at rest, under loads and between displacements of the ends of uniform pieces."""

from typing import TYPE_CHECKING

from vibcli.elements.loaded_rest import held_deflection
from vibcli.elements.rest_shapes import deflection
from vibcli.symbolic.antiderivatives import antiderivative
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.smooth_panels import NotSmooth

if TYPE_CHECKING:
    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.elements.rest_shapes import RestPiece
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def static_signal(scene: "Scene", signal: "PlaceSignal") -> "Node":
    """The signal as a function of the coordinates, everything being at rest."""
    if signal.motion is not None:
        return signal.motion
    own, piece = _given_along(scene, signal), signal.piece(scene)
    if piece.graded:
        return signal.factor * (_graded(scene, signal, piece) + _held(scene, signal, piece))
    if None in signal.ends:
        return signal.factor * _slack(scene, signal, piece)
    xi = scene.table.variable("the place on a piece")
    load, held = _particular(scene, signal, piece, xi)
    shift = [_at(scene, load, xi, k, x) for x in (scene.table.zero, signal.length)
             for k in range(2 if piece.bends else 1)]
    ends = [end - part for end, part in zip(signal.ends, shift, strict=True)]
    found = deflection(scene, piece, signal.at, signal.order, ends)
    return signal.factor * (found + held + _at(scene, load, xi, signal.order, signal.at)) + own


def _slack(scene: "Scene", signal: "PlaceSignal", piece: "RestPiece") -> "Node":
    """Of a string that bears no tension at one end, (N u′)′ = −q with N = 0 there: u′ = −q/N′ all along."""
    slope = -signal.weight(scene) / piece.gradient
    left, right = signal.ends
    u = left + slope * signal.at if right is None else right - slope * (piece.length - signal.at)
    return (u, slope)[signal.order] if signal.order < 2 else scene.table.zero


def _graded(scene: "Scene", signal: "PlaceSignal", piece: "RestPiece") -> "Node":
    """Of a beam under a tension that varies along it."""
    from vibcli.elements.graded_beam import graded_beam, plainly

    shares = plainly(scene, lambda: graded_beam(scene, *piece.numbers).shares(
        signal.order, signal.at, f"{signal.member.name}.{signal.number + 1}"))
    return scene.table.total([share * part for share, part in zip(shares, [*signal.ends, signal.weight(scene)],
                                                                  strict=True)])


def _held(scene: "Scene", signal: "PlaceSignal", piece: "RestPiece") -> "Node":
    """What uneven loads leave between held ends."""
    xi, found = scene.table.variable("the place on a piece"), scene.table.zero
    for load in signal.uneven(scene):
        q, = substitute([load.q], {load.x: signal.left.place + xi})
        try:
            found = found + held_deflection(scene, piece, q, xi, signal.at, signal.order)
        except NotSmooth as error:
            scene.report(load.where, f"'{load.owner}' {error.message}", error.hint)
    return found


def _at(scene: "Scene", load: "Node", xi: "Node", order: int, place: "Node") -> "Node":
    """A derivative of a function of ξ at a place."""
    for _ in range(order):
        load = gradient(load).get(xi, scene.table.zero)
    return substitute([load], {xi: place})[0]


def _particular(scene: "Scene", signal: "PlaceSignal", piece: "RestPiece", xi: "Node") -> "tuple[Node, Node]":
    """One u(ξ) that the loads leave: w/k, −w ξ²/(2N), w ξ⁴/(24B) of the even ones, −∫∫ q/N or ∫∫∫∫ q/B where there is
    neither foundation nor tension of a beam; and the part of the signal that others leave between held ends."""
    even, found, held = signal.weight(scene), scene.table.zero, scene.table.zero
    if not even.is_zero and not piece.foundation.is_zero:
        found = even / piece.foundation
    elif not (even.is_zero or piece.gradient.is_zero):
        held = held_deflection(scene, piece, even, xi, signal.at, signal.order)
    elif not even.is_zero:
        found = even * xi**4 / (24 * piece.bending) if piece.tension.is_zero else -even * xi**2 / (2 * piece.tension)
    for load in signal.uneven(scene):
        q, = substitute([load.q], {load.x: signal.left.place + xi})
        integral = q if piece.plain else None
        for _ in range(4 if piece.bends else 2):
            integral = None if integral is None else antiderivative(integral, xi)
        if integral is not None:
            found = found + (integral / piece.bending if piece.bends else -integral / piece.tension)
            continue
        try:
            held = held + held_deflection(scene, piece, q, xi, signal.at, signal.order)
        except NotSmooth as error:
            scene.report(load.where, f"'{load.owner}' {error.message}", error.hint)
    return found, held


def _given_along(scene: "Scene", signal: "PlaceSignal") -> "Node":
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


