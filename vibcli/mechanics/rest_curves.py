"""What is at rest along members in numbers: piece by piece, since it may jump between.

Within a piece the deflection is that between its ends under its weight and loads.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.inputs_outputs.displacements import resting, signal_of_place
from vibcli.mechanics.smooth_forms import smooth_form
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.graded_rest import bent_at_rest
from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm, loaded_fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.stretches import CurveStretch, kept
from vibcli.symbolic.antiderivatives import antiderivative
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.smooth_panels import NotSmooth

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.elements.member_loads import SpreadLoad
    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class ShapeAtRest(NamedTuple):
    """A Piece, bent(places, order): u or a derivative of it below the order of the piece, None where an end that
    nothing pulls is no station, and the LoadForms on it."""

    piece: Piece
    bent: "Callable[[np.ndarray, int], np.ndarray] | None"
    forms: list[LoadForm]

    def highest(self, x: float) -> float:
        """u″ of what does not bend, u⁗ of a beam, by its equation."""
        piece, tension = self.piece, self.piece.tension + self.piece.gradient * x
        load = sum(float(one.at(x, arithmetic_of(0.0))) for form in self.forms for one in form.stretches
                   if one.start <= x <= one.end)
        felt = [-piece.foundation, piece.gradient, tension][:piece.order]
        load += sum(factor * float(self.bent(np.array([x]), order)[0]) for order, factor in enumerate(felt) if factor)
        found: float = -load / tension if piece.order == 2 else load / piece.bending
        return found


def value_at_rest(configuration: "Configuration", text: str) -> float:
    """A signal in equilibrium; within beams whose tension varies by one deflection of each piece, which is kept."""
    scene = configuration.scene.resting
    if signal_name(text).name in scene.members:
        found = signal_of_place(scene, signal_name(text))
        graded = found.motion is None and found.member.kind.bends and found.piece(scene).graded
        if graded and not (found.member.lengthwise or found.factor.is_zero):
            key = found.member.name, found.number
            if key not in configuration.bent_pieces:
                configuration.bent_pieces[key] = _bent(configuration, scene, found)
            factor, at = evaluate([found.factor, found.at], Floats, configuration.at_rest)
            return float(factor * configuration.bent_pieces[key](np.array([at]), found.order)[0])
    result: float = evaluate([resting(scene, text)], Floats, configuration.at_rest)[0]
    return result


def curves_at_rest(configuration: "Configuration", member: "Member", part: str) -> list[CurveStretch]:
    """A part of the signals of a member all along it."""
    scene = configuration.scene.resting
    xi = scene.table.variable("the place on a piece of a member")
    found = []
    for signal in member.signals_along(scene, part, xi):
        start, end = evaluate([signal.left.place, signal.right.place], Floats, configuration.at_rest)
        found.append(CurveStretch(start, end, _from(start, _along(configuration, scene, signal, part, xi))))
    return found


def _from(start: float, along: Callable[..., np.ndarray]) -> Callable[[np.ndarray], np.ndarray]:
    """What counts places from there, for places that count from the left end of the member."""
    return kept(lambda places: along(places - start))


def _along(configuration: "Configuration", scene: "Scene", signal: "PlaceSignal", part: str,
           xi: Any) -> Callable[..., np.ndarray]:
    """The signal as a function of places on its piece, counted from there."""
    tension, gradient = signal.tension(scene)
    if part == "force" and signal.segment.stiffness is None:
        return _of_node(tension + gradient * xi, xi, configuration.at_rest)
    graded = signal.member.kind.bends and not gradient.is_zero
    if graded or (signal.uneven(scene) and not signal.member.lengthwise):
        bent, factor = _bent(configuration, scene, signal), evaluate([signal.factor], Floats, configuration.at_rest)[0]
        return lambda places: factor * bent(places, signal.order)
    if signal.uneven(scene) and not all(_is_closed(signal, load) for load in signal.uneven(scene)):
        raise PhysicsError(f"the forces within '{signal.member.name}' along it under such a load are not found",
                           f"ask for them at places, as in equilibrium[{signal.member.name}.{part}(0 m)]")
    return _of_node(signal.static(scene), xi, configuration.at_rest)


def _is_closed(signal: "PlaceSignal", load: "SpreadLoad") -> bool:
    """Is a load integrated twice in letters?"""
    once = None if not signal.segment.foundation.is_zero else antiderivative(load.q, load.x)
    return once is not None and antiderivative(once, load.x) is not None


def _bent(configuration: "Configuration", scene: "Scene",
          signal: "PlaceSignal") -> "Callable[[np.ndarray, int], np.ndarray]":
    """(places, order) → u of a piece, or a derivative, under loads that vary along it, or whose tension does so."""
    zero, of = scene.table.zero, signal.piece(scene)
    bending = of.bending if of.bends else zero
    numbers = evaluate([of.length, bending, of.tension, of.gradient, zero, zero, of.foundation, *signal.ends], Floats,
                       configuration.at_rest)
    piece, ends = Piece(*numbers[:7]), np.array(numbers[7:])
    forms = _loads(configuration, scene, signal)
    if of.graded and (bent := bent_at_rest(piece, ends, forms)) is not None:
        return bent

    def at(places: np.ndarray, order: int) -> np.ndarray:
        found = fields(piece, piece.foundation, ends, places)[..., order]
        held = [sum(loaded_fields(piece, piece.foundation, form, x)[..., order] for form in forms)
                for x in places.tolist()]
        result: np.ndarray = found + np.array(held)
        return result
    return at


def shape_at_rest(configuration: "Configuration", text: str) -> "ShapeAtRest":
    """That of the piece on which the place of a signal lies."""
    scene = configuration.scene.resting
    signal = signal_of_place(scene, signal_name(text))
    zero, of = scene.table.zero, signal.piece(scene)
    numbers = evaluate([of.length, of.bending if of.bends else zero, of.tension, of.gradient, zero, zero,
                        of.foundation], Floats, configuration.at_rest)
    bent = _bent(configuration, scene, signal) if None not in signal.ends else None
    return ShapeAtRest(Piece(*numbers), bent, _loads(configuration, scene, signal))


def _loads(configuration: "Configuration", scene: "Scene", signal: "PlaceSignal") -> list[LoadForm]:
    """The LoadForms of a piece, that of what is even first."""
    zero, values, length = scene.table.zero, configuration.at_rest, signal.length
    end, even = evaluate([length, signal.weight(scene)], Floats, values)
    forms = [LoadForm((LoadStretch(0.0, end, 0.0, (LoadTerm(even, 0, 0.0),)),))]
    for load in signal.uneven(scene):
        q, = substitute([load.q], {load.x: signal.left.place + load.x})
        try:
            forms.append(smooth_form(q, load.x, (zero, length), values, Floats))
        except NotSmooth as error:
            raise PhysicsError(f"'{load.owner}' {error.message} of a piece", error.hint) from None
    return forms


def _of_node(node: "Node", xi: "Node", values: Mapping[str, float]) -> Callable[..., np.ndarray]:
    return lambda places: np.array([evaluate([node], Floats, {**values, xi.name: x})[0] for x in places.tolist()])
