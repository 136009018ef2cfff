"""What is given beside the scene, as text: values, cases, signals, sizes. ValueError: what is wrong with it."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Where
from vibcli.base.spelling import nearest
from vibcli.language.document.nodes import Mapping, Scalar
from vibcli.language.reader import Expression
from vibcli.symbolic.parser import parse
from vibcli.symbolic.parser import plain_name as plain_name
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


def said(hint: str | None) -> str:
    """A hint behind a message, if there is one."""
    return f"; {hint}" if hint else ""


def case(problem: "Problem", name: str) -> "Problem":
    """The Problem of a case of the file."""
    if name not in problem.spec.cases:
        raise ValueError(f"the file has no case '{name}'" + said(nearest(name, problem.spec.cases)))
    return problem.case(name)


def parameters_of(node: Mapping) -> set[str]:
    """The names in a document to which values can be given."""
    sections = [node.entries[key][1] for key in ("parameters", "choose") if key in node.entries]
    return {plain_name(key) for section in sections if isinstance(section, Mapping) for key in section.entries}


def setting(name: str, text: str, known: set[str], option: str) -> dict[str, tuple[object, Scalar]]:
    """{parameter: (syntax tree, text with its place)} of a value that a parameter is given, as `--set` takes it."""
    name = plain_name(name.strip())
    if name not in known:
        raise ValueError(f"the file has no parameter '{name}'" + said(nearest(name, known)))
    return {name: parsed(text.strip(), f"{option} {name}")}


def parsed(text: str, option: str) -> tuple[object, Scalar]:
    """(syntax tree, text with its place) of an expression."""
    try:
        return parse(text), Scalar(text, Where(option, 1, 1, len(text)), False, 0)
    except ExpressionError as error:
        raise ValueError(error.message + (f" ({error.hint})" if error.hint else "")) from None


def accuracy(text: str) -> float:
    """How accurately motions are to be integrated."""
    from vibcli.language.accuracy import accuracy as asked

    return asked(text)


def expression(text: str, option: str) -> Expression:
    """A signal or quantity as an Expression."""
    tree, scalar = parsed(text, option)
    return Expression(scalar, tree)


def size(text: str, unit: str, wants: str, exact: bool = False) -> Any:
    """A positive quantity in SI units; a bare number is one of `unit`, cycles are 2π. `exact`: as a Fraction, where it
    may be zero."""
    from math import tau

    from vibcli.base.units import parse_unit
    from vibcli.symbolic.semantics import literal_unit
    from vibcli.symbolic.syntax import whole_literal

    try:
        literal = whole_literal(parse(text))
    except ExpressionError as error:
        raise ValueError(error.message) from None
    found = literal_unit(literal.units if literal and literal.units else parse(f"1 {unit}").units)
    if not literal or not (literal.value > 0 or exact) or text.lstrip().startswith("-") or (
            found.dimension != parse_unit(unit).dimension):
        raise ValueError(f"expected {wants}")
    if exact:
        return literal.value * found.value     # of times, which have no roots
    return found.in_si(literal.value) * (tau if found.cycles else 1)
