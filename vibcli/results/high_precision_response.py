"""Where a motion starts, in more digits than floats have."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import mpmath

    from vibcli.results.problem import Problem


def start(problem: "Problem", values: "Mapping[str, mpmath.mpf]",
          rest: "Mapping[str, float | mpmath.mpf]") -> "tuple[dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
    """({coordinate: number}, {coordinate: velocity}) at t = 0."""
    if problem.configuration.preloaded is not None:
        raise PhysicsError("the equilibrium from which a force lets go is not found to more digits",
                           "give the start as values")
    return given_start(problem, values, rest)


def given_start(problem: "Problem", values: "Mapping[str, mpmath.mpf]",
                rest: "Mapping[str, mpmath.mpf]") -> "tuple[dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
    """The same, where all that is not given stands at `rest`."""
    import mpmath

    from vibcli.language.sections.initial import FIELDS
    from vibcli.language.spec import RELEASED
    from vibcli.symbolic.evaluation import evaluate, multiprecision

    if problem.spec.get(FIELDS):
        raise PhysicsError("more digits of a motion that starts with fields along members are not found",
                           "leave --digits out")
    record, scene = problem.spec.get("initial"), problem.scene
    given = {key: evaluate([scene.lower(expression)], multiprecision(), values)[0]
             for key, expression in (record.items() if record is not None else ()) if key != RELEASED}
    return ({name: given.get(name, rest[name]) for name in scene.coordinates},
            {name: given.get(name + "'", mpmath.mpf(0)) for name in scene.coordinates})
