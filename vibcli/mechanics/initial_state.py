"""Where a motion starts: the values of `initial`, else at rest in the equilibrium without loads that depend on time."""

from math import isfinite

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.language.sections.initial import RELEASED
from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.transfer_between_tables import copied


def given_start(problem):
    """{coordinate, or velocity x': value} of `initial`, and of the equilibrium under a force that lets go."""
    record = problem.spec.get("initial")
    found = dict(at_rest(problem.before)) if problem.before is not None else {}
    for key, expression in record.items() if record is not None else ():
        if key == RELEASED:
            continue
        if key.rstrip("'") not in problem.scene.coordinates:
            raise PhysicsError(f"'{key}' follows from the other coordinates by the constraints", "start "
                               + " or ".join(f"'{other}'" for other in problem.scene.coordinates[:3]),
                               record.place(key))
        found[key], = evaluate([problem.scene.lower(expression)], Floats, problem.floats)
        if not isfinite(found[key]):
            raise PhysicsError(f"the start of '{key}' is no real number", "give another value under `initial:`",
                               expression.where)
    return found


def start(problem):
    """({coordinate: value}, {coordinate: velocity}) at t = 0 of the independent coordinates."""
    given, names = problem.given_start, problem.scene.coordinates
    rest = given if all(name in given for name in names) else at_rest(problem)
    return ({name: given.get(name, rest[name]) for name in names},
            {name: given.get(name + "'", 0.0) for name in names})


def at_rest(problem):
    """{coordinate: value} where a motion starts at rest: in the equilibrium without friction; where none is reached, as
    drawn, if friction holds the scene there."""
    from vibcli.mechanics.equilibrium.dry_friction import holds

    try:
        return problem.equilibrium.values
    except PhysicsError as error:
        if problem.sticking is None:
            raise
        if not holds(problem, problem.sticking, problem.drawn_floats):
            raise PhysicsError(f"without friction {error.message}; friction does not hold it as drawn either",
                               "give the start of every coordinate under `initial`: "
                               + ", ".join(problem.scene.coordinates), error.where) from None
        return problem.drawn_floats


def start_in_letters(problem):
    """[deviation from the equilibrium, velocity] of the one coordinate at t = 0; None where the file gives none."""
    record, (name,) = problem.spec.get("initial"), problem.scene.coordinates
    if record is None:
        return None
    held = equilibrium_in_letters(problem.before) if problem.before is not None else {}
    if any(key != RELEASED and key.rstrip("'") != name for key in record):
        raise NotInLetters("this start is found in numbers", "give the parameters values with --set")
    rest = equilibrium_in_letters(problem)[name]
    place, speed = (problem.scene.lower(record[key]) if key in record else None for key in (name, name + "'"))
    if place is None:
        place = copied([held[name]], problem.scene.table)[0] if held else rest
    return [textbook(place - rest), problem.scene.table.zero if speed is None else speed]
