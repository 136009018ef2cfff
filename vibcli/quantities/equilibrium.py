"""Quantities of equilibria: where they are, how many there are, whether they are stable."""

from vibcli.base.errors import PhysicsError
from vibcli.language.signals import coordinate_name
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.mechanics.signals import force
from vibcli.quantities.quantity import ROUNDING
from vibcli.symbolic.evaluation import Floats, evaluate


def about(problem, number):
    """The problem about one of all its equilibria."""
    if number > count(problem):
        raise PhysicsError(f"there is no equilibrium {number}: {count(problem) or 'none'} "
                           f"{'is' if count(problem) < 2 else 'are'} found within the bounds",
                           "ask for one of these, or give bounds as in find: {equilibria: all, within: …}")
    return problem.about_each[number - 1]


def count(problem):
    """How many equilibria are found; refused where the search could not be finished."""
    found = problem.equilibria
    if found.cut:
        raise PhysicsError("the search for all equilibria was cut short: their number is not known",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    if found.missed:
        raise PhysicsError(f"more equilibria exist than the {len(found.items)} that were found: by the forces on the "
                           f"bounds their indices sum to {found.indices.degree}, not {found.indices.sum}",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    return len(found.items)


def _equilibrium(problem, indices, attribute):
    signal = coordinate_name(problem.spec, indices[0]) or indices[0]
    node = displacement(problem.scene.resting, signal)
    if node is None:
        return force(problem.configuration, signal), ROUNDING
    return evaluate([node], Floats, problem.configuration.at_rest)[0], ROUNDING


def is_stable(problem):
    """Does nothing grow about the equilibrium? Motion that costs no energy counts as stable."""
    from vibcli.analyses.modal.stability import stability

    return stability(problem.modal).stable


def _stable(problem, indices, attribute):
    return is_stable(problem), 0.0


VALUES = {"equilibrium": _equilibrium, "stable": _stable,
          "equilibria": lambda problem, indices, attribute: (count(problem), 0.0)}
