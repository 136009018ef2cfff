"""Values of quantities and of expressions of them: the arguments of a quantity first, then its family."""

from importlib import import_module
from math import isfinite, tau

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.quantities import FAMILIES
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.quantity import ASKED, IN_FREQUENCY, OF_VALUES, ROUNDING, SEVERAL, declared, is_choice
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import ExpressionError
from vibcli.symbolic.semantics import lower, quantities_in
from vibcli.symbolic.syntax import QuantityRef

IN_GRAPHS = ("peak", "antiresonance", "half_power", "fixed_point", "quality")   # read off a whole response


def measure(problem, tree):
    """(value, relative error bound) of a quantity tree."""
    head, indices, attribute = tree.head, tree.indices, tree.component
    if tree.args or head in IN_FREQUENCY:
        return _with_arguments(problem, tree)
    if is_choice(problem.spec, tree) and problem.choice is not None:
        return problem.choice.value(head, int(indices[0])), ROUNDING
    if head in SEVERAL and len(indices) > len(ASKED[head].indices):
        from vibcli.quantities.equilibrium import about

        problem, indices = about(problem, int(indices[-1])), indices[:-1]
    return family(head).VALUES[head](problem, indices, attribute)


def family(head):
    """The module of the family to which a quantity belongs."""
    return import_module(f"vibcli.quantities.{FAMILIES[head]}")


def _with_arguments(problem, tree):
    """The arguments that are numbers first, then the family."""
    head, args = tree.head, tree.args
    of_frf = bool(args) and isinstance(args[0], QuantityRef) and args[0].head in ("frf", *OF_VALUES)
    if head in IN_FREQUENCY or of_frf:
        from vibcli.quantities.frequency_response import VALUES

        complex_part = head in (*OF_VALUES, "phase")
        return VALUES[head](problem, tree, [measure(problem, arg) if complex_part else
                                            None if head in IN_GRAPHS else number_of(problem, arg) for arg in args])
    from vibcli.quantities.response import measure_response

    kinds = declared(tree).args
    return measure_response(problem, tree, [number_of(problem, arg) if kind == "time" else None
                                            for kind, arg in zip(kinds, args, strict=True)])


def value_of(problem, expression):
    """(value, relative error bound) of an expression of parameters and quantities."""
    values, worst = dict(problem.numeric.floats), 0.0
    for quantity in quantities_in(expression.tree):
        values[quantity.text], error = measure(problem, quantity)
        worst = max(worst, error)
    value = evaluated(problem, expression, values)
    if isinstance(value, complex) or not isfinite(value):
        if isinstance(value, complex) and isfinite(abs(value)):
            raise PhysicsError("this is complex: it is compared by its parts", "ask for re, im, abs or arg of it",
                               expression.where)
        raise PhysicsError("this is not a finite real number", "mind the signs under roots, and what may vanish",
                           expression.where)
    return value, worst


def evaluated(problem, expression, values):
    """An expression, given {parameter, or quantity as it is written: value}."""
    scene = problem.scene
    table = scene.table

    def symbol(name, primes, part):
        return table.parameter(name, positive=False) if isinstance(part, QuantityRef) else scene.parameters.nodes[name]

    return evaluate([lowered(expression, table, symbol)], Floats, values)[0]


def lowered(expression, table, symbol):
    """The node of a parsed expression; SpecError where it divides by zero."""
    try:
        return lower(expression.tree, table, symbol)
    except ExpressionError as error:
        place = expression.scalar.place(error.offset, error.width)
        raise SpecError([Diagnostic(place, error.message, error.hint)]) from None


def number_of(problem, tree):
    """The value of an argument: an instant or an angular frequency; cycles count as 2π."""
    values = dict(problem.numeric.floats)
    for quantity in quantities_in(tree):
        values[quantity.text] = measure(problem, quantity)[0]
    table = problem.scene.table

    def symbol(name, primes, part):
        if isinstance(part, QuantityRef):
            return table.parameter(name, positive=False)
        return problem.scene.parameters.nodes[name]

    value = evaluate([lower(tree, table, symbol)], Floats, values)[0]
    return value * tau if counts_cycles(problem.spec, tree) else value
