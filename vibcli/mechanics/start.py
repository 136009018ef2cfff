"""Where a motion starts: the values of `initial`, else at rest in the equilibrium without loads that depend on time."""

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.elements.initial import RELEASED
from vibcli.errors import PhysicsError


def given_start(problem):
    """{coordinate, or velocity x': value} of `initial`, and of the equilibrium under a force that lets go."""
    record = problem.spec.get("initial")
    found = dict(problem.before.equilibrium.values) if problem.before is not None else {}
    for key, expression in record.values.items() if record is not None else ():
        if key == RELEASED:
            continue
        if key.rstrip("'") not in problem.scene.coordinates:
            raise PhysicsError(f"'{key}' follows from the other coordinates by the constraints", "start "
                               + " or ".join(f"'{other}'" for other in problem.scene.coordinates[:3]),
                               record.place(key))
        found[key], = evaluate([problem.scene.lower(expression)], Floats, problem.floats)
    return found


def start(problem):
    """({coordinate: value}, {coordinate: velocity}) at t = 0 of the independent coordinates."""
    given, names = problem.given_start, problem.scene.coordinates
    rest = given if all(name in given for name in names) else problem.equilibrium.values
    return ({name: given.get(name, rest[name]) for name in names},
            {name: given.get(name + "'", 0.0) for name in names})
