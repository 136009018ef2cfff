"""Signals as functions of the coordinates, and the forces in equilibrium (vibcli/language/signals.py lists them)."""

from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.base.errors import NotFixed, PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import ENERGIES, is_load
from vibcli.mechanics.energies import dissipation, kinetic, potential, potential_as_drawn
from vibcli.mechanics.equilibrium.redundant_friction import require_fixed_at_rest
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import TypeVar

    import numpy as np

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    T = TypeVar("T")

MOST_NAMED = 6      # forces that share a load


def moving(system: "MechanicalSystem", text: str, primes: int = 0) -> "Node":
    """The node of a coordinate or signal along a motion, `primes` times differentiated."""
    scene = system.scene
    if text in system.spec.coordinates:
        return scene.symbol(text, primes)
    if text in ENERGIES:
        return energy(scene, text, primes)
    name, part, *_ = signal_name(text)
    node = displacement(scene, text)
    if node is None:
        node = _along(scene, name, part)
    if node is None and name in scene.members:
        raise PhysicsError(f"'{text}' lies within what vibrates: members take part in small motions alone",
                           "write motion: small")
    if node is None:
        known = [f"{record.name}.force" for record in system.spec.connections]
        raise PhysicsError(f"'{text}' is not found along a motion of the full equations", "forces are found of springs "
                           "and dampers alone" + (", as " + " or ".join(known[:2]) if known else ""))
    for _ in range(primes):
        node = scene.rate(node)
    return node


def energy(scene: "Scene", text: str, primes: int = 0) -> "Node":
    """T, V or Φ of a scene along a motion, V counted from the drawn position; PhysicsError of T and V with members."""
    if scene.pieces and text != "Phi":
        raise PhysicsError(f"{text} is not told along a motion of members with inertia of their own",
                           "ask for displacements and forces, as in rod.u(x) or rod.force(x)")
    node = {"T": kinetic, "V": potential, "Phi": dissipation}[text](scene)
    if text == "V":
        node = node - scene.at_drawn(potential_as_drawn(scene))[0]
    for _ in range(primes):
        node = scene.rate(node)
    return node


def _along(scene: "Scene", name: str, part: str) -> "Node | None":
    """The tension or energy of a spring, the force or power of a damper or a load; None of another force."""
    if is_load(scene.spec, f"{name}.{part}"):
        terms = scene.terms_of(name, "forces")
        return scene.table.total([term.power(scene) if part == "power" else term.force(scene) for term in terms])
    if part == "force":
        return scene.force_of(name)
    nodes = []
    if part == "energy":
        nodes = [term.energy(scene) for term in scene.terms_of(name)]
    elif part == "power":
        nodes = [term.power(scene) for term in scene.terms_of(name)]
    nodes = [node for node in nodes if node is not None]
    return scene.table.total(nodes) if nodes else None


def force(configuration: "Configuration", text: str) -> float:
    """The value of a force in equilibrium."""
    name, part, *_ = signal_name(text)
    if name == "ground" or part == "energy" or is_load(configuration.spec, text):
        return _of_outputs(configuration, text)
    if name in (configuration.spec.get("springs") or {}):
        return _tension(configuration, name)
    if configuration.spec.connection(name) is not None:
        if part == "force":
            require_fixed_at_rest(configuration, name)
        configuration.at_rest  # noqa: B018 - what friction alone holds is no equilibrium without it
        return 0.0
    known = {reaction.signal: reaction.value for reaction in configuration.reactions}
    if part in ("normal", "friction"):
        normal = evaluate(list(normal_of(configuration.scene.resting, name)), Floats, configuration.at_rest)
        return float(in_contact(part, normal, [known[f"{name}.reaction.{axis}"] for axis in "xy"]))
    text = reaction_of(configuration.system, text, known)
    if known[text] is None:
        raise not_fixed(text, known)
    return known[text]


def reaction_error(configuration: "Configuration", text: str) -> float:
    """What the force of a constraint or support in equilibrium is off by at most."""
    errors, (name, part, *_) = configuration.reaction_errors, signal_name(text)
    if part in ("normal", "friction"):
        return sum(errors[f"{name}.reaction.{axis}"] for axis in "xy")
    return errors[reaction_of(configuration.system, text, errors)]


def not_fixed(text: str, known: "Mapping[str, Any]") -> NotFixed:
    """The refusal of a force in equilibrium that is one of those without value among {signal: value}, which share."""
    others = [signal for signal, value in known.items() if value is None and signal != text]
    verb = "shares" if len(others) == 1 else "share"
    shared = f": {listed(others[:MOST_NAMED])} {verb} the load with it" if others else ""
    return NotFixed(text, "the scene is supported by more than it needs" + shared,
                    "take one of these supports out, or let one give: a spring in its place")


def _of_outputs(configuration: "Configuration", text: str) -> float:
    from vibcli.mechanics.inputs_outputs.outputs import is_quadratic, linear_row, products

    if is_quadratic(text):
        return sum(weight * one.constant * two.constant for weight, (one, two) in products(configuration, text))
    return linear_row(configuration, text).constant


def _tension(configuration: "Configuration", name: str) -> float:
    scene = configuration.scene.resting
    values = evaluate([term.force(scene) for term in scene.terms_of(name)], Floats, configuration.at_rest)
    return float(values[0] if len(values) == 1 else sum(value * value for value in values) ** 0.5)


def reaction_of(system: "MechanicalSystem", text: str, known: Any) -> str:
    """The name of a force in a constraint or support among those `known`; at a point, that of the body pinned there."""
    name, part, *_ = signal_name(text)
    if name in (system.spec.get("points") or {}) and not part.startswith("drive"):
        text = f"{_pinned_at(system, name)}.{part}"
    if text not in known:
        pieces = [signal for signal in known if signal.startswith(text + ".")]
        raise PhysicsError(f"this scene has no force '{text}'", "ask for " + " or ".join(pieces) if pieces else
                           "see `find: [reactions]` for those that it has")
    return text


def require_fixed(text: str, value: "T | None") -> "T":
    """The value of a force in motion; PhysicsError where it is None."""
    if value is None:
        raise PhysicsError(f"rigid bodies alone do not fix '{text}': the scene is supported by more than it needs",
                           "take a redundant support out")
    return value


def _pinned_at(system: "MechanicalSystem", point: str) -> str:
    """The one body pinned or clamped at a named point."""
    found = [name for name, record in (system.spec.get("bodies") or {}).items()
             if any(getattr((record.get(key) or {}).get("at"), "text", None) == point for key in ("pin", "clamp"))]
    if len(found) != 1:
        what = "no body is" if not found else "several bodies are"
        raise PhysicsError(f"{what} pinned or clamped at '{point}'",
                           "ask for the reaction of a body, as in rod.reaction.x")
    return str(found[0])


def normal_of(scene: "Scene", name: str) -> "tuple[Node, Node]":
    """The normal of the surface on which a body rolls or slides."""
    normal = scene.bodies[name].normal
    if normal is None and scene.bodies[name].touched:
        raise PhysicsError(f"what each of its two surfaces exerts on '{name}' is not told apart",
                           "give it a coordinate, as in `roll: {between: …, turn: phi}`, or ask for its reaction")
    if normal is None:
        raise PhysicsError(f"'{name}' rolls or slides on no surface", "ask for its reaction, as in rod.reaction.x")
    return normal


def in_contact(part: str, normal: Any, reaction: Any) -> "float | np.ndarray":
    """The `normal` or `friction` part of the reaction (x, y) of a surface."""
    (nx, ny), (x, y) = normal, reaction
    found: float | np.ndarray = x * nx + y * ny if part == "normal" else x * ny - y * nx
    return found
