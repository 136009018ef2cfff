"""Displacements of places, turns and stretches as signals (vibcli/language/signals.py lists them)."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.language.reader import Reference
from vibcli.language.signal_names import signal_name

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def displacement(scene: "Scene", text: str) -> "Node | None":
    """The node of a coordinate, or of a place, turn or stretch as displaced from where it is drawn; None of a force."""
    if text in scene.spec.coordinates:
        return scene.symbol(text)
    name, part, *_ = signal_name(text)
    if name in scene.members:
        return _on_member(scene, text)
    if part in ("x", "y", "angle") and name in scene.bodies and scene.bodies[name].frame is None:
        return _lumped(scene.bodies[name], part)
    if part in ("x", "y"):
        drawn, place, _ = scene.place(Reference(name, None))
        return place["xy".index(part)] - drawn["xy".index(part)]
    if part == "angle":
        return scene.bodies[name].frame.angle
    if part == "stretch":
        drawn, = scene.at_drawn(_stretch(scene, scene.terms_of(name, undriven=True)))
        return _stretch(scene, scene.terms_of(name)) - drawn
    return None


def _on_member(scene, text, resting=False):
    """A signal of a place on a member, or None within a piece that vibrates; `resting`: as everything is at rest."""
    from vibcli.mechanics.inputs_outputs.place_signals import place_signal
    from vibcli.mechanics.inputs_outputs.static_deflection import static_signal

    signal = signal_name(text)
    found = place_signal(scene, signal)
    if signal.part == "force" and found.member.kind.stiffness is None:
        return found.tension(scene)
    return static_signal(scene, found) if resting or found.motion is not None or found.is_light else None


def resting(scene: "Scene", text: str) -> "Node | None":
    """The same in equilibrium, in which members deflect as springs."""
    return _on_member(scene, text, resting=True) if signal_name(text).name in scene.members else displacement(
        scene, text)


def _lumped(body, part):
    """The displacement of a body without a place along its axis, or its turn about it."""
    kind, node = body.lumped
    if kind == "turn" and part != "angle":
        raise PhysicsError(f"'{body.name}' turns and has no place", f"ask for {body.name}.angle")
    if kind != "turn" and part != "x":
        raise PhysicsError(f"'{body.name}' moves along one axis and has no place: it has no {part}",
                           f"ask for {body.name}.x, or say where it is drawn with `at: [x, y]`")
    return node


def _stretch(scene, terms):
    if len(terms) == 1:
        return terms[0].s
    square = scene.table.sum(*((term.s * term.s, 1) for term in terms))   # of a spring without free length
    return scene.table.sqrt(square)
