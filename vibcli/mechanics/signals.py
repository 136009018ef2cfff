"""Signals as functions of the coordinates, and the forces in equilibrium (vibcli/language/signals.py lists them)."""

from vibcli.base.errors import NotFixed, PhysicsError
from vibcli.language.signals import ENERGIES
from vibcli.mechanics.energies import dissipation, kinetic, potential, potential_as_drawn
from vibcli.mechanics.equilibrium.redundant_friction import require_fixed_at_rest
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import ONE


def moving(system, text, primes=0):
    """The node of a coordinate or signal along a motion, `primes` times differentiated."""
    scene = system.scene
    if text in system.spec.coordinates:
        return scene.symbol(text, primes)
    if text in ENERGIES:
        return energy(scene, text, primes)
    name, _, part = text.partition(".")
    node = displacement(scene, text)
    if node is None:
        node = _along(scene, name, part)
    if node is None:
        known = [f"{record.name}.force" for record in system.spec.connections]
        raise PhysicsError(f"'{text}' is not found along a motion of the full equations", "forces are found of springs "
                           "and dampers alone" + (", as " + " or ".join(known[:2]) if known else ""))
    for _ in range(primes):
        node = scene.rate(node)
    return node


def energy(scene, text, primes=0):
    """T, V or Φ of a scene along a motion, V counted from the drawn position."""
    node = {"T": kinetic, "V": potential, "Phi": dissipation}[text](scene)
    if text == "V":
        node = node - scene.at_drawn(potential_as_drawn(scene))[0]
    for _ in range(primes):
        node = scene.rate(node)
    return node


def _along(scene, name, part):
    """The tension or energy of a spring, the force or power of a damper; None of another force."""
    if part == "force":
        return scene.force_of(name)
    nodes = []
    if part == "energy":
        nodes = [term.energy(scene) for term in scene.terms_of(name)]
    elif part == "power":
        nodes = [term.power(scene) for term in scene.terms_of(name)]
    nodes = [(node, ONE) for node in nodes if node is not None]
    return scene.table.sum(*nodes) if nodes else None


def force(configuration, text):
    """The value of a force in equilibrium."""
    name, _, part = text.partition(".")
    if name == "ground" or part == "energy":
        return _of_outputs(configuration, text)
    if name in (configuration.spec.get("springs") or {}):
        return _tension(configuration, name)
    if configuration.spec.connection(name) is not None:
        if part == "force":
            require_fixed_at_rest(configuration, name)
        _require_equilibrium(configuration)
        return 0.0
    known = {reaction.signal: reaction for reaction in configuration.reactions}
    if part in ("normal", "friction"):
        return _contact(configuration, name, part, known)
    if name in (configuration.spec.get("points") or {}) and not part.startswith("drive"):
        text = f"{pinned_at(configuration.system, name)}.{part}"
    found = known.get(text)
    if found is None:
        pieces = [signal for signal in known if signal.startswith(text + ".")]
        raise PhysicsError(f"this scene has no force '{text}'", "ask for " + " or ".join(pieces) if pieces else
                           "see `find: [reactions]` for those that it has")
    if found.value is None:
        raise NotFixed(text)
    return found.value


def _require_equilibrium(configuration):
    """PhysicsError where the forces balance nowhere: what friction alone holds is no equilibrium without it."""
    return configuration.at_rest


def _of_outputs(configuration, text):
    from vibcli.mechanics.inputs_outputs.outputs import is_quadratic, linear_row, squares

    if is_quadratic(text):
        return sum(weight * row.constant**2 for weight, row in squares(configuration, text))
    return linear_row(configuration, text).constant


def _tension(configuration, name):
    scene = configuration.scene.resting
    values = evaluate([term.force(scene) for term in scene.terms_of(name)], Floats, configuration.at_rest)
    return values[0] if len(values) == 1 else sum(value * value for value in values) ** 0.5


def pinned_at(system, point):
    """The one body pinned at a named point."""
    found = [name for name, record in (system.spec.get("bodies") or {}).items()
             if getattr((record.get("pin") or {}).get("at"), "text", None) == point]
    if len(found) != 1:
        what = "no body is" if not found else "several bodies are"
        raise PhysicsError(f"{what} pinned at '{point}'", "ask for the reaction of a body, as in rod.reaction.x")
    return found[0]


def _contact(configuration, name, part, known):
    """The reaction of a body on a surface along its normal, or along its tangent."""
    body = configuration.scene.resting.bodies[name]
    if body.normal is None:
        raise PhysicsError(f"'{name}' rolls or slides on no surface", "ask for its reaction, as in rod.reaction.x")
    nx, ny = evaluate(list(body.normal), Floats, configuration.at_rest)
    x, y = (known[f"{name}.reaction.{axis}"].value for axis in "xy")
    return x * nx + y * ny if part == "normal" else x * ny - y * nx
