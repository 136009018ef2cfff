"""Forces and moments within members along each, at rest: piece by piece, since they may jump between.

Within a piece the deflection is that between its ends under its weight and loads.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.member_signals import PARTS, STRETCHING
from vibcli.mechanics.smooth_forms import smooth_form
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.graded_rest import bent_at_rest
from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm, loaded_fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.stretches import CurveStretch
from vibcli.symbolic.antiderivatives import antiderivative
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.smooth_panels import NotSmooth

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.scene import Scene

UNITS = {"force": "N", "shear": "N", "moment": "N·m"}


class InternalForce(NamedTuple):
    """A force or moment along a member, `part` of its signals, in Stretches from its left end to its right one;
    `error(place)` bounds how far a value there may be off."""

    member: str
    part: str
    stretches: list[CurveStretch]
    error: Callable = lambda place: 0.0

    @property
    def unit(self) -> str:
        return UNITS[self.part]

    @property
    def largest(self) -> float:
        """The largest of its absolute values that are shown."""
        return max(float(np.abs(stretch.points()[1]).max()) for stretch in self.stretches)


def forces_within(scene: "Scene") -> "list[tuple[str, Member, str]]":
    """(name, Member, part) of all forces and moments within members, as signals name them."""
    return [(name, member, part) for name, member in scene.members.items() if member.turns or not member.lengthwise
            for part in UNITS if part in PARTS[member.kind.name + "s"] or (member.stretching and part in STRETCHING)]


def forces_at_rest(configuration: "Configuration") -> list[InternalForce]:
    """Those of all members in equilibrium."""
    scene = configuration.scene.resting
    return [InternalForce(name, part, _stretches(configuration, scene, member, part))
            for name, member, part in forces_within(scene)]


def _stretches(configuration, scene, member, part):
    xi = scene.table.variable("the place on a piece of a member")
    found = []
    for signal in member.signals_along(scene, part, xi):
        start, end = evaluate([signal.left.place, signal.right.place], Floats, configuration.at_rest)
        found.append(CurveStretch(start, end, _from(start, _along(configuration, scene, signal, part, xi))))
    return found


def _from(start, along):
    """What counts places from there, for places that count from the left end of the member."""
    return lambda places: along(np.asarray(places) - start)


def _along(configuration, scene, signal: "PlaceSignal", part: str, xi: Any):
    """The signal as a function of places on its piece, counted from there."""
    tension, gradient = signal.tension(scene)
    if part == "force" and signal.segment.stiffness is None:
        return _of_node(tension + gradient * xi, xi, configuration.at_rest)
    graded = signal.member.kind.bends and not gradient.is_zero
    if graded or (signal.uneven(scene) and not signal.member.lengthwise):
        return _under_uneven(configuration, scene, signal)
    if signal.uneven(scene) and not all(_is_closed(signal, load) for load in signal.uneven(scene)):
        raise PhysicsError(f"the forces within '{signal.member.name}' along it under such a load are not found",
                           f"ask for them at places, as in equilibrium[{signal.member.name}.{part}(0 m)]")
    return _of_node(signal.static(scene), xi, configuration.at_rest)


def _is_closed(signal, load):
    """Is a load integrated twice in letters?"""
    once = None if not signal.segment.foundation.is_zero else antiderivative(load.q, load.x)
    return once is not None and antiderivative(once, load.x) is not None


def _under_uneven(configuration, scene, signal):
    """Of a piece under loads that vary along it, or whose tension does so."""
    zero, of = scene.table.zero, signal.piece(scene)
    bending = of.bending if of.bends else zero
    numbers = evaluate([of.length, bending, of.tension, of.gradient, zero, zero, of.foundation, signal.factor,
                        *signal.ends], Floats, configuration.at_rest)
    piece, factor, ends = Piece(*numbers[:7]), numbers[7], np.array(numbers[8:])
    forms = _loads(configuration, scene, signal)
    if of.graded and (bent := bent_at_rest(piece, ends, forms)) is not None:
        return lambda places: factor * bent(places, signal.order)

    def at(places):
        found = fields(piece, piece.foundation, ends, places)[..., signal.order]
        held = [sum(loaded_fields(piece, piece.foundation, form, x)[..., signal.order] for form in forms)
                for x in places.tolist()]
        return factor * (found + np.array(held))
    return at


def _loads(configuration, scene, signal):
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


def _of_node(node, xi, values):
    return lambda places: np.array([evaluate([node], Floats, {**values, xi.name: x})[0] for x in places.tolist()])
