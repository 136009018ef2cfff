"""The law of a spring or damper as a whole: its force at a deflection, `law[s](D)`, and the coefficients of its series,
`law[s, d^3]`."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.quantities.index_kinds import power_of_deflection
from vibcli.quantities.quantity import Declaration, measured, unit
from vibcli.quantities.signal_dimensions import deflection_dimension, output_dimension

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.mechanics.characteristics import ForceLaw
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import Rounded, RunningErrors
    from vibcli.symbolic.syntax import QuantityRef


def _characteristic(problem: "Problem", tree: "QuantityRef") -> "ForceLaw":
    from vibcli.mechanics.characteristics import characteristic

    return characteristic(problem.scene, tree.indices[0])


def _numbers(problem: "Problem") -> "tuple[RunningErrors, dict[str, Rounded]]":
    """(arithmetic of numbers with bounds, {parameter: number})."""
    from vibcli.symbolic.evaluation import Floats, multiprecision
    from vibcli.symbolic.running_errors import RunningErrors

    inner = Floats if problem.digits is None else multiprecision()
    arithmetic = RunningErrors(inner, unit(problem))
    return arithmetic, problem.numeric.values(arithmetic)


def _in_digits(problem: "Problem", find: "Callable[..., Rounded]") -> tuple[float, float]:
    """What is found, in as many digits as the problem is asked for."""
    if problem.digits is None:
        return measured(find())
    import mpmath

    with mpmath.workdps(problem.digits + 15):
        return measured(find(), 10.0**-problem.digits)


def _force(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    from vibcli.quantities.expression import argument_in
    from vibcli.symbolic.running_errors import number_in

    law = _characteristic(problem, tree)

    def find() -> "Rounded":
        arithmetic, values = _numbers(problem)
        force: Rounded = law.at(arithmetic, values, argument_in(problem, tree.args[0], arithmetic, values))
        if not abs(number_in(force)) < float("inf"):
            ending = problem.scene.endings(problem.numeric.floats)
            raise PhysicsError(f"'{tree.indices[0]}' has no force at this deflection: " + (
                ending.what if ending else "its law is not defined there"),
                ending.hint if ending else "look for roots of what becomes negative")
        return force
    return _in_digits(problem, find)


def _force_in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.quantities.expression import argument_in_letters
    from vibcli.symbolic.expression_graph import called_functions

    found = _characteristic(problem, tree).in_letters(argument_in_letters(problem, tree.args[0]))
    if called_functions([found]):
        raise NotInLetters("this force, of parts in series or from a table, is found in numbers",
                           "give the parameters values with --set")
    return found


def _coefficient(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    law, (_, n) = _characteristic(problem, tree), power_of_deflection(tree.indices[1])
    return _in_digits(problem, lambda: law.coefficient(n, *_numbers(problem)))


def _coefficient_in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    return _characteristic(problem, tree).coefficient_in_letters(power_of_deflection(tree.indices[1])[1])


def _force_dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    return output_dimension(spec, tree.indices[0] + ".force")


def _dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    """Force over the power of the deflection."""
    return units.times(_force_dimension(spec, tree), deflection_dimension(spec, tree.indices[0]),
                       -power_of_deflection(tree.indices[1])[1])


QUANTITIES = {
    "law": Declaration(
        "factor of a power of the deflection d, of a damper of its rate v, in the series about d = 0 of the force of a "
        "spring or damper, of parts in series as one; without a power `law[s](2 cm)` is the force at a deflection",
        None, _coefficient, ("spring or damper", "power"), dimension=_dimension, symbolic=_coefficient_in_letters),
    "law()": Declaration(
        "force of a spring or damper at a deflection, of a damper at a rate of it, counted from where it is undeformed",
        None, _force, ("spring or damper",), ("deflection",), dimension=_force_dimension, symbolic=_force_in_letters),
}
