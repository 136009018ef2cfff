"""Kinks: |u|, sign u, min and max whose argument vanishes in equilibrium leave no slope, so no small oscillations."""

from vibcli.algebra.calculus import gradient, substitute
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.expression import reachable
from vibcli.errors import PhysicsError

KINKED = ("abs", "sign", "min", "max")
SAME = 1e-9


def require_smooth(problem):
    """PhysicsError where a load, energy or constraint has a kink at the equilibrium."""
    scene = problem.scene
    if not scene.table.called.intersection(KINKED):
        return
    terms = (*scene.inertias, *scene.springs, *scene.dampers, *scene.weights)
    for node in [term.s for term in terms] + [term.weight for term in scene.forces] + list(scene.energies.values()):
        for part in (node, *gradient(node).values()):
            if _jumps(problem, part):
                raise PhysicsError("abs, sign, min or max has a kink in the equilibrium: there are no small "
                                   "oscillations about it", "the full equations are those of `vibcli equations`")


def _jumps(problem, node):
    """Has an expression two values at the equilibrium, one to each side of a vanishing argument of sign?"""
    turns = [part for part in reachable([node]) if part.name == "sign" and part.mask]
    if not turns:
        return False
    at = problem.at_rest
    sizes = evaluate([part.args[0] for part in turns], Floats, at)
    turns = [part for part, size in zip(turns, sizes, strict=True) if not abs(size) > 1e-12]
    sides = [substitute([node], dict.fromkeys(turns, problem.scene.table.number(side)))[0] for side in (-1, 1)]
    left, right = evaluate(sides, Floats, at)
    return abs(left - right) > SAME * max(abs(left), abs(right))
