"""Kinks: |u|, sign u, min and max whose argument vanishes in equilibrium leave no slope, so no small oscillations."""

from typing import TYPE_CHECKING, NoReturn

from vibcli.base.errors import Kinked
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SIDES = {"sign": (-1, 1), "step": (0, 1)}     # values on both sides of a vanishing argument
KINKED = ("abs", "min", "max", "ramp", *SIDES)
SAME = 1e-9
HINT = "the full equations are those of `vibcli equations`, their motion that of motion: full"


def require_smooth(configuration: "Configuration") -> None:
    """Kinked where a load, energy or constraint has a kink at the equilibrium, or dry friction holds the scene."""
    scene = configuration.scene.resting
    if not scene.table.called.intersection(KINKED):
        return
    require_unheld(configuration.system)
    if configuration.equilibrium.jumps is not None:
        raise Kinked("a force jumps in the equilibrium and holds the scene there as hard as it has to: there are no "
                     "small oscillations about it", HINT)
    terms = (*scene.inertias, *scene.springs, *scene.dampers, *scene.weights)
    V = scene.energies["V"]
    bends = [second for slope in gradient(V).values() for second in gradient(slope).values()]
    for node in [term.s for term in terms] + [term.weight for term in scene.forces] + list(scene.energies.values()):
        for part in (node, *gradient(node).values(), *(bends if node is V else ())):
            if jumps(configuration, part):
                raise Kinked("abs, sign, min, max, step or ramp has a kink in the equilibrium: there are no small "
                             "oscillations about it", HINT)


def require_unheld(system: "MechanicalSystem") -> None:
    """Kinked where dry friction holds the scene at rest."""
    if system.sticking is not None:
        raise Kinked("dry friction has a kink at rest: there are no small oscillations", HINT)


def jumps(configuration: "Configuration", node: "Node") -> bool:
    """Has an expression two values at the equilibrium, one to each side of a vanishing argument of sign or step?"""
    time = configuration.scene.time.mask
    turns = [part for part in reachable([node]) if part.name in SIDES and part.mask & ~time]
    if not turns:
        return False
    at = configuration.at_rest
    sizes = evaluate([part.args[0] for part in turns], Floats, at)
    turns = [part for part, size in zip(turns, sizes, strict=True) if not abs(size) > 1e-12]
    number = configuration.scene.table.number
    try:
        sides = [substitute([node], {part: number(SIDES[part.name][side]) for part in turns})[0] for side in (0, 1)]
        left, right = evaluate(sides, Floats, at)
    except ZeroDivisionError:
        return True         # one of them has no bound
    return abs(left - right) > SAME * max(abs(left), abs(right))


def without_slope(form: "Linearisation", scene: "Scene") -> NoReturn:
    """Refuse small oscillations where the slope of a force is infinite as drawn, as of ∛d at d = 0, or that of a
    displacement divides by zero, as of √(u²) at u = 0; ZeroDivisionError where the energies themselves are not defined
    there."""
    from vibcli.mechanics.energies import kinetic, potential

    V = potential(scene)
    substitute([kinetic(scene), V, *gradient(V).values()], scene.drawn_position)
    residual_as_drawn(form, scene)
    raise Kinked("the slope of a force is infinite as drawn: there are no small oscillations about that", HINT)


def residual_as_drawn(form: "Linearisation", scene: "Scene") -> "list[list[Node]]":
    """The terms of each condition of equilibrium as drawn; Kinked where they divide by zero there."""
    from vibcli.mechanics.linearisation import residual_terms

    try:
        return [substitute(terms, scene.drawn_position) for terms in residual_terms(form)]
    except ZeroDivisionError:
        raise Kinked("a force, or the slope of a displacement, divides by zero as drawn: there are no small "
                     "oscillations about that", HINT) from None
