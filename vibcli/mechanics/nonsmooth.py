"""Kinks: |u|, sign u, min and max whose argument vanishes in equilibrium leave no slope, so no small oscillations."""

from collections.abc import Iterator
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
    if any(jumps(configuration, part) for part in _that_must_not_jump(scene)):
        raise Kinked("abs, sign, min, max, step or ramp has a kink in the equilibrium: there are no small "
                     "oscillations about it", HINT)


def _that_must_not_jump(scene: "Scene") -> "Iterator[Node]":
    """What small oscillations are made of: energies to their second slopes, loads and places of bodies to their
    first, of ½ c ṡ² the products of the slopes of s, so that s = |u| is as good as u."""
    for term in scene.inertias:
        yield from (term.s, *gradient(term.s).values())
    for term in scene.dampers:
        slopes = list(gradient(term.s).values())
        yield from (term.s, *(one * other for i, one in enumerate(slopes) for other in slopes[:i + 1]))
    for energy in (*scene.energies.values(), *(spring.potential(scene) for spring in scene.springs),
                   *(weight.potential(scene) for weight in scene.weights)):
        slopes = list(gradient(energy).values())
        yield from (energy, *slopes, *(second for slope in slopes for second in gradient(slope).values()))
    for load in scene.forces:
        yield from (load.weight, *gradient(load.weight).values())


def require_unheld(system: "MechanicalSystem") -> None:
    """Kinked where dry friction holds the scene at rest."""
    if system.sticking is not None:
        raise Kinked("dry friction has a kink at rest: there are no small oscillations", HINT)


def jumps(configuration: "Configuration", node: "Node") -> bool:
    """Has an expression two values at the equilibrium, one to each side of a vanishing argument of sign or step, or
    another between them?"""
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
        left, right, between = evaluate([*sides, node], Floats, at)
    except ZeroDivisionError:
        return True         # one of them has no bound
    return bool(max(abs(left - right), abs(left - between)) > SAME * max(map(abs, (left, right, between))))


def without_slope(form: "Linearisation", scene: "Scene") -> NoReturn:
    """Refuse small oscillations where a force or its slope is infinite as drawn, as of ∛d at d = 0, or that of a
    displacement divides by zero; ZeroDivisionError where the energies themselves are not defined there."""
    from vibcli.mechanics.energies import kinetic, potential

    energies = substitute([kinetic(scene), potential(scene)], scene.drawn_position)
    if any(part.name == "log" and part.args[0].is_zero for part in reachable(energies)):
        raise ZeroDivisionError
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
