"""How a scene rests: coordinates, places, stretches, forces and energies of springs, reactions in an equilibrium."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.static_positions import equations, true_position
from vibcli.evidence.subject import Subject, of_number
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import CONTACT, is_reaction
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.signals import in_contact, normal_of, reaction_of
from vibcli.quantities import equilibrium
from vibcli.quantities.quantity import about_which, counted, declared
from vibcli.results.random_states import reach
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.evidence.reference.static_positions import StaticEquations
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

NOTHING = 1e-6      # of a reach: what is nearer to zero is measured by that


def at_rest(problem: "Problem", tree: QuantityRef) -> Subject:
    """A coordinate or signal in equilibrium; the others begin half a reach away, that of random states, from there."""
    asked, number = about_which(tree)
    one = problem if number is None else equilibrium.about(problem, int(number))
    text = problem.spec.coordinate_name(asked.indices[0]) or asked.indices[0]
    static = equations(one.configuration)
    node = _of_springs(one, static.scene, text)
    if node is None and not is_reaction(problem.spec, text):
        raise PhysicsError("of what rests a reference is found of places, stretches, of forces and energies of springs "
                           "and of forces in constraints and supports")
    if node is None:
        static = equations(one.configuration, released=True)
        node = _reaction(one, static, text)
    node, = substitute([node], static.still)
    size = declared(asked).size(one, asked)
    true = true_position(one, static, node, size)
    scale = max(abs(float(true.values[0])), NOTHING * size) or 1.0
    moving = static.scene.q[:len(static.scene.q) - len(static.scene.released)]
    start = [x + 0.5 * reach(one, q.name) for x, q in zip(static.near, moving, strict=False)]

    return of_number("static position", one, tree, f"at rest, {counted(len(static.names), 'equation')}", true,
                     (static, node, start + static.near[len(start):]), scale,
                     lambda: problem.about(Configuration(problem.numeric)))


def _of_springs(problem: "Problem", scene: "Scene", text: str) -> "Node | None":
    """The expression of a coordinate, place, turn or stretch, or of a force or energy of springs; None of another."""
    node, (name, part, *_) = equilibrium.at_rest(problem, scene, text), signal_name(text)
    if node is None and part == "energy":
        energies = [term.energy(scene) for term in scene.terms_of(name)]
        return scene.table.total(energies) if energies and None not in energies else None
    return node


def _reaction(problem: "Problem", static: "StaticEquations", text: str) -> Any:
    """That of a force in a constraint or support."""
    name, part, *_ = signal_name(text)
    if part in CONTACT:
        reaction = [static.forces[f"{name}.reaction.{axis}"] for axis in "xy"]
        return in_contact(part, normal_of(static.scene, name), reaction)
    return static.forces[reaction_of(problem.system, text, static.forces)]
