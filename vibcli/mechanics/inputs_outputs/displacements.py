"""Displacements of places, turns and stretches as signals (vibcli/language/signals.py lists them)."""

from typing import TYPE_CHECKING

from vibcli.base.diagnostics import distinct_figures
from vibcli.base.errors import PhysicsError
from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression, Reference
from vibcli.language.signal_names import LEFT_OF, SignalName, signal_name
from vibcli.scene.energy_terms import Spring
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.elements.place_signals import PlaceSignal
    from vibcli.elements.rigid_body import Body
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def displacement(scene: "Scene", text: str) -> "Node | None":
    """The node of a coordinate, or of a place, turn or stretch as displaced from where it is drawn, or of a
    deflection; None of a force."""
    if text in scene.spec.coordinates:
        return scene.symbol(text)
    name, part, *_ = signal_name(text)
    if name in scene.members:
        return _on_member(scene, text)
    if name in (scene.spec.get("member_points") or {}):
        return _of_point(scene, name, part)
    if part in ("x", "y", "angle") and name in scene.bodies and scene.bodies[name].frame is None:
        return _lumped(scene.bodies[name], part)
    if part in ("x", "y"):
        drawn, place, _ = scene.place(Reference(name, None))
        return place["xy".index(part)] - drawn["xy".index(part)]
    if part == "angle":
        return scene.bodies[name].frame.angle
    if part.partition(".")[0] == "stretch":
        drawn, = scene.at_drawn(_stretch(scene, name, part, undriven=True))
        return _stretch(scene, name, part) - drawn
    if part == "deflection":
        return _deflection(scene, name)
    return None


def _of_point(scene: "Scene", name: str, part: str) -> "Node":
    """The displacement x or y of a point on a member in the plane."""
    record = scene.spec.get("member_points")[name]
    member = scene.members[record["body"].text]
    station = member.nearest(scene, scene.lower(record["at"]))
    return member.line.displaced(station.along, station.u)["xy".index(part)]


def signal_of_place(scene: "Scene", signal: SignalName) -> "PlaceSignal":
    """The PlaceSignal of a name; PhysicsError where its place is not on the member."""
    member = scene.members[signal.name]
    if not signal.place:
        raise PhysicsError(f"'{signal.text}' needs a place on '{member.name}'", "places count from its left end")
    text = signal.place.removesuffix(LEFT_OF)
    place = scene.lower(Expression(Scalar(text, None), parse(text)))
    found = member.signal(scene, signal, place, before=signal.place.endswith(LEFT_OF))
    if found is None and signal.kind == "oscillator":
        raise PhysicsError(f"no {signal.part} is attached at '{signal.place}' to '{member.name}'",
                           f"ask for {next(name for name in scene.hidden if signal_name(name)[:2] == signal[:2])}")
    if found is None:
        x, length = distinct_figures(scene.number(place), scene.number(member.length))
        raise PhysicsError(f"'{signal.place}' is {x} m along '{member.name}', which is {length} m long",
                           "places count from its left end")
    return found


def _on_member(scene: "Scene", text: str, resting: bool = False) -> "Node | None":
    """A signal of a place on a member, or None within a piece that vibrates; `resting`: as everything is at rest."""
    signal = signal_name(text)
    found = signal_of_place(scene, signal)
    if signal.part == "force" and found.member.kind.stiffness is None:
        tension, gradient = found.tension(scene)
        return tension + gradient * found.at
    if not (resting or found.motion is not None or found.is_light):
        return None
    if not resting and found.motion is None and found.in_time(scene):
        raise PhysicsError(f"what '{text}' is where '{found.in_time(scene)[0].owner}' varies in time is not found",
                           f"ask for the motion of '{signal.name}' where something is attached")
    return found.static(scene)


def resting(scene: "Scene", text: str) -> "Node | None":
    """The same in equilibrium, in which members deflect as springs."""
    if signal_name(text).name not in scene.members:
        return displacement(scene, text)
    known = scene.displaced_at_rest
    if text not in known:
        known[text] = _on_member(scene, text, resting=True)
    return known[text]


def _lumped(body: "Body", part: str) -> "Node":
    """The displacement of a body without a place along its axis, or its turn about it."""
    kind, node = body.lumped
    if kind == "turn" and part != "angle":
        raise PhysicsError(f"'{body.name}' turns and has no place", f"ask for {body.name}.angle")
    if kind != "turn" and part != "x":
        raise PhysicsError(f"'{body.name}' moves along one axis and has no place: it has no {part}",
                           f"ask for {body.name}.x, or say where it is drawn with `at: [x, y]`")
    return node


def _deflection(scene: "Scene", name: str) -> "Node":
    """The stretch of a spring from its undeformed state: of a linear one N/k as drawn and what came since."""
    terms = scene.terms_of(name)
    if len(terms) == 1 and isinstance(terms[0], Spring):
        if terms[0].weight.is_zero:
            raise PhysicsError(f"'{terms[0].owner}' has no stiffness: nothing tells where it is undeformed",
                               f"ask for {terms[0].owner}.stretch")
        return terms[0].s + terms[0].offset / terms[0].weight
    return _stretch(scene, name, "stretch")


def _stretch(scene: "Scene", name: str, part: str, undriven: bool = False) -> "Node":
    path = signal_name(f"{name}.{part}").axis
    if path:
        inner = scene.undriven("inner_stretches") if undriven else scene.inner_stretches
        found = next((term.s for term in inner if (term.owner, term.path) == (name, path)), None)
        if found is None:
            raise PhysicsError(f"the parts of '{name}' have no stretch of their own: it has no free length",
                               f"ask for {name}.stretch")
        return found
    lengths: list[Node] = [term.s for term in scene.terms_of(name, undriven=undriven)]
    if len(lengths) == 1:
        return lengths[0]
    square = scene.table.sum(*((s * s, 1) for s in lengths))   # of a spring without free length
    return scene.table.sqrt(square)
