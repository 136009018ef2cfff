"""Values of quantities and of expressions of them: the arguments of a quantity first, then the quantity itself."""

from collections.abc import Callable, Mapping
from math import inf, isfinite, tau
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from vibcli.base.errors import Diagnostic, NotInLetters, PhysicsError, SpecError
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.quantity import about_which, absolute, declared, is_choice
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in, number_in
from vibcli.symbolic.semantics import lower, lower_measured
from vibcli.symbolic.syntax import ExpressionError, QuantityRef, parts_of

if TYPE_CHECKING:

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef


SLACK = 2.0     # of what is known to first order
VANISHING = "mind the signs under roots, and what may vanish"
GUARD = 15      # digits beyond those asked, for what cancels in an expression
NODES: "WeakKeyDictionary[Scene, dict[Any, Node]]" = WeakKeyDictionary()    # of expressions that were asked of a scene


def measure(problem: "Problem", tree: QuantityRef) -> tuple[Any, float]:
    """(value, relative error bound) of a quantity tree; what has no arguments is found once."""
    if tree.args:
        return _found(problem, tree)
    if tree.text not in problem.measured:
        problem.measured[tree.text] = _found(problem, tree)
    return problem.measured[tree.text]


def _found(problem: "Problem", tree: QuantityRef) -> tuple[Any, float]:
    if not tree.args and is_choice(problem.spec, tree) and problem.choice is not None:
        value = problem.choice.value(tree.head, number := int(tree.indices[0]))
        return value, problem.choice.error(tree.head, number) / abs(value) if value else 0.0
    quantity = declared(tree)
    if not tree.args and not quantity.several:
        return quantity.value(problem, tree, [])
    tree, number = about_which(tree)
    if number is not None:
        from vibcli.quantities.equilibrium import about

        problem = about(problem, int(number))
    kinds = zip(quantity.args, tree.args, strict=not quantity.optional)
    return quantity.value(problem, tree, [_argument(problem, kind, arg) for kind, arg in kinds])


def _argument(problem: "Problem", kind: str, arg: Any) -> Any:
    """The value of an argument that is a number, of a complex one with its error; None of what is a function."""
    if kind == "complex":
        return measure(problem, arg)
    return number_of(problem, arg) if kind in ("time", "Omega", "amplitude") else None


def value_of(problem: "Problem", expression: "Expression") -> tuple[float, float]:
    """(value, the largest relative error bound of its quantities) of an expression of parameters and quantities."""
    if isinstance(expression.tree, QuantityRef):
        value, error = measure(problem, expression.tree)
        return _real(value, expression, isfinite), error
    values, worst = dict(problem.numeric.floats), 0.0
    for quantity in expression.parts.quantities:
        values[quantity.text], error = measure(problem, quantity)
        worst = max(worst, error)
    return _real(evaluated(problem, expression, values), expression, isfinite), worst


def bounded(problem: "Problem", expression: "Expression") -> tuple[float, float]:
    """(value, absolute error bound) of an expression, with the rounding of its own sums; in numbers of mpmath where the
    problem is asked for digits."""
    if problem.digits is None:
        return _bounded(problem, expression, RunningErrors(Floats), problem.numeric.rounded)
    import mpmath

    with mpmath.workdps(problem.digits + GUARD):
        arithmetic = RunningErrors(multiprecision(), mpmath.mp.eps)
        return _bounded(problem, expression, arithmetic, problem.numeric.values(arithmetic))


def _bounded(problem: "Problem", expression: "Expression", arithmetic: RunningErrors,
             values: Mapping[str, Rounded]) -> tuple[float, float]:
    if isinstance(expression.tree, QuantityRef):
        found = _rounded(problem, expression.tree, arithmetic)
    else:
        found = _evaluated(problem, expression, arithmetic, dict(values))
    error = error_in(found)
    return _real(number_in(found), expression, arithmetic.inner.isfinite), error if error >= 0 else inf


def _evaluated(problem: "Problem", expression: "Expression", arithmetic: RunningErrors,
               values: dict[str, Rounded]) -> Rounded:
    """An expression in numbers with bounds, the parameters being `values`."""
    searched = problem.choice.conditions if problem.choice is not None and not problem.choice.exact else ()
    for name in searched:
        found = number_in(values[name])
        values[name] = Rounded(found, problem.choice.error(name), arithmetic.unit)
    for quantity in expression.parts.quantities:
        values[quantity.text] = _rounded(problem, quantity, arithmetic)
    node = lowered(expression, problem.scene.table, _symbols(problem.scene))
    total: Rounded = evaluate([node], arithmetic, values)[0]
    return total


def _rounded(problem: "Problem", quantity: QuantityRef, arithmetic: RunningErrors) -> Rounded:
    value, error = measure(problem, quantity)
    return Rounded(value, absolute(value, error) + _searched(problem, quantity, value), arithmetic.unit)


def _searched(problem: "Problem", quantity: QuantityRef, value: complex) -> float:
    """By how much the errors of the numbers that were searched for may move a quantity, to first order."""
    if problem.choice is None or is_choice(problem.spec, quantity):
        return 0.0
    total = 0.0
    for error, moves in problem.choice.moved():
        slopes = [abs((there - value) / move.by) for move in moves
                  if (there := _measured_there(move.problem.until(problem.end), quantity)) is not None]
        total += SLACK * error * (max(slopes, default=inf) if error else 0.0)
    return total


def _measured_there(problem: "Problem", quantity: QuantityRef) -> Any:
    """A quantity of another scene; None where there is none."""
    try:
        return measure(problem, quantity)[0]
    except (SpecError, PhysicsError, ArithmeticError):
        return None


def _real(value: float, expression: "Expression", finite: Callable[..., bool]) -> float:
    """The value; refused where it is complex, be its imaginary part 0, or not finite."""
    is_complex = isinstance(value, complex) or hasattr(value, "_mpc_")
    if is_complex and finite(abs(value)):
        raise PhysicsError("this is complex: it is compared by its parts", "ask for re, im, abs or arg of it",
                           expression.where)
    if is_complex or not finite(value):
        raise PhysicsError("this is not a finite real number", VANISHING, expression.where)
    return value


def evaluated(problem: "Problem", expression: "Expression", values: Mapping[str, float]) -> float:
    """An expression, given {parameter, or quantity as it is written: value}."""
    found: float = evaluate([lowered_in(problem.scene, expression)], Floats, values)[0]
    return found


def lowered_in(scene: "Scene", expression: "Expression") -> "Node":
    """The node of an expression in the letters of a scene, each quantity being one."""
    known = NODES.setdefault(scene, {})
    node = known.get(expression.tree)
    if node is None:
        node = known[expression.tree] = lowered(expression, scene.table, _symbols(scene))
    return node


def argument_in(problem: "Problem", tree: Any, arithmetic: Any, values: Mapping[str, Any]) -> Any:
    """The value of an argument in an arithmetic of numbers with bounds."""
    values = dict(values)
    for quantity in parts_of(tree).quantities:
        value, error = measure(problem, quantity)
        values[quantity.text] = Rounded(value, absolute(value, error), arithmetic.unit)
    return evaluate([lower(tree, problem.scene.table, _symbols(problem.scene))], arithmetic, values)[0]


def argument_in_letters(problem: "Problem", tree: Any) -> "Node":
    """The same in letters."""
    if parts_of(tree).quantities:
        raise NotInLetters("what is asked at another quantity is found in numbers",
                           "give the parameters values with --set")
    return lower_measured(tree, problem.scene.table, _symbols(problem.scene))


def _symbols(scene: "Scene") -> "Callable[[str, int, NameRef | QuantityRef], Node]":
    """Gives the node of a parameter, or of a quantity as it is written."""
    def symbol(name: str, primes: int, part: "NameRef | QuantityRef") -> "Node":
        if isinstance(part, QuantityRef):
            return scene.table.parameter(name, positive=False)
        return scene.parameters.nodes[name]

    return symbol


def lowered(expression: "Expression", table: "Table", symbol: "Callable[..., Node]") -> "Node":
    """The node of a parsed expression; SpecError where it divides by zero."""
    try:
        return lower(expression.tree, table, symbol)
    except ExpressionError as error:
        place = expression.scalar.place(error.offset, error.width)
        raise SpecError([Diagnostic(place, error.message, error.hint)]) from None


def number_of(problem: "Problem", tree: Any) -> float:
    """The value of an argument: an instant or an angular frequency; cycles count as 2π. Refused where it is complex or
    not finite."""
    values = dict(problem.numeric.floats)
    for quantity in parts_of(tree).quantities:
        values[quantity.text] = measure(problem, quantity)[0]
    value = evaluate([lower(tree, problem.scene.table, _symbols(problem.scene))], Floats, values)[0]
    if isinstance(value, complex) or not isfinite(value):
        raise PhysicsError("its argument is not a finite real number", VANISHING)
    found: float = value * tau if counts_cycles(problem.spec, tree) else value
    return found
