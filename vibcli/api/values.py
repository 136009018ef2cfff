"""A quantity asked for by its text: its value with unit and error bound, or its expression in letters."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.api import given
from vibcli.api.expressions import SymbolicExpression
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.reader import Reader
from vibcli.quantities import FAMILIES
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import evaluated, measure, value_of
from vibcli.quantities.quantity import ERROR, OF_STATE, ROUNDING, absolute, declared, kind_of
from vibcli.reader.answer_check import check_question
from vibcli.symbolic.syntax import QuantityRef, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem


class QuantityValue(NamedTuple):
    """value: in SI units, complex or a truth value where the quantity is one, None where it is an expression; error: an
    absolute bound of it in `unit`; expression: of the letters of the scene, or of its coordinates and velocities."""

    text: str
    value: float | complex | bool | None
    unit: str
    error: float
    expression: SymbolicExpression | None = None

    def __float__(self) -> float:
        if self.value is None:
            raise TypeError(f"'{self.text}' is an expression: {self.expression}")
        return float(self.value)  # type: ignore[arg-type]


def quantity_value(problem: "Problem", text: str) -> QuantityValue:
    """What a scene answers to a quantity, or to an expression of some."""
    asked = quantity_asked(problem.spec, text)
    tree, unit = asked.tree, unit_of(problem.spec, asked)
    of_state = kind_of(problem.spec, tree) in OF_STATE
    if problem.numeric.has_free_symbols or of_state:
        from vibcli.quantities.letters import expression_in_letters, state_function

        node = state_function(problem, tree) if of_state else expression_in_letters(problem, asked)
        return QuantityValue(text, None, unit, 0.0, SymbolicExpression(node, tuple(problem.scene.coordinates)))
    value, error = bounded(problem, asked)
    return QuantityValue(text, value, unit, error)


def quantity_asked(spec: "Spec", text: str) -> "Expression":
    """The text as a quantity of this scene; SpecError where it is none."""
    return checked_quantity(spec, given_expression(text, "the quantity"))


def checked_quantity(spec: "Spec", asked: "Expression") -> "Expression":
    """The same of an Expression."""
    reader = Reader(members=spec.members)
    asked = asked.with_tree(reader.at_places(asked.tree))
    asked = check_question(spec, reader, asked)
    if reader.diagnostics:
        raise SpecError(reader.diagnostics)
    return asked


def given_expression(text: str, place: str) -> "Expression":
    """A signal or quantity given as text; SpecError where it cannot be read."""
    try:
        return given.expression(text, place)
    except ValueError as error:
        raise SpecError([Diagnostic(Where(f"{place} {text}", 1, 1, 0), str(error))]) from None


def bounded(problem: "Problem", asked: "Expression") -> tuple[float | complex | bool, float]:
    """(value, absolute error bound) of an expression; to first order in the errors of its quantities."""
    tree = asked.tree
    if isinstance(tree, QuantityRef):
        return _measured(problem, tree)
    value, _ = value_of(problem, asked)
    found = {part.text: _measured(problem, part) for part in parts_of(tree).quantities}
    values = problem.numeric.floats | {text: number for text, (number, _) in found.items()}
    error = ROUNDING * abs(value)
    for text, (number, doubt) in found.items():
        for step in (doubt, 1j * doubt) if isinstance(number, complex) else (doubt,):
            moved = (evaluated(problem, asked, values | {text: number + sign * step}) for sign in (-1, 1))
            error += max(abs(there - value) for there in moved)
    return float(value), float(error)


def _measured(problem: "Problem", tree: QuantityRef) -> tuple[Any, float]:
    value, relative = measure(problem, tree)
    if isinstance(value, bool):
        return value, 0.0
    value = complex(value) if isinstance(value, complex) else float(value)
    off = float(absolute(value, relative))
    return value, off if value else max(off, _rounding(problem, tree))


def _rounding(problem: "Problem", tree: QuantityRef) -> float:
    """What a number of a motion that is found in closed form may be off where it is zero: by the size of its signal."""
    if not tree.args or FAMILIES.get(tree.head) in ("frequency_response", "laws") or (
            problem.response_of(tree).KIND == "full"):
        return 0.0
    with suppress(PhysicsError):
        return ERROR * float(declared(tree).size(problem, tree))
    return 0.0
