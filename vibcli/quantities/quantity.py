"""A quantity of the language, as the file of its family declares it.

Reading a scene loads declarations alone: what values are found by is imported where they are found.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from importlib import import_module
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.quantities import FAMILIES, FORMS
from vibcli.symbolic.parser import IN_TWO_BRACKETS
from vibcli.symbolic.syntax import NameRef, QuantityRef, Sum, parts_of

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ALL = "all of them: vibcli explain quantities"
ROUNDING = 1e-14        # relative, of what is evaluated in floats
EXACT = "small", "waves", "modes", "parts", "steady"      # motions whose numbers carry bounds of their own
ERROR = 1e-12           # of what is read off linear motions and frequency responses
SIGNAL = "signal"       # the unit of a number of a signal: that of the signal
NUMBER, COMPLEX, PERIOD, COUNT, TRUTH = "number", "complex", "period", "count", "truth"     # kinds of values
OF_SIGNAL, FUNCTION, EQUATION = "signal", "function", "equation"        # a signal again; of coordinates and velocities
LEAPING, OF_STATE = (COUNT, TRUTH), (FUNCTION, EQUATION)
_ARGUMENTS = {"signal": "{x}", "time": "2 s", "amplitude": "10 cm", "deflection": "2 cm", "Omega": "5 Hz",
              "response": "frf[{x}, {F}]", "complex": "frf[{x}, {F}](5 Hz)"}


def as_asked(problem: "Problem", x: Any) -> Any:
    """A real number as it is handed on: a float, one of mpmath's where the problem is asked for digits."""
    return in_floats(problem, x) if problem.digits is None else x


def in_floats(problem: "Problem", x: Any) -> Any:
    """A float; of many scenes an array of them."""
    return x if problem.many else float(x)


def full_turn(problem: "Problem") -> Any:
    """2π, likewise."""
    if problem.digits is None:
        return tau
    import mpmath

    return 2 * mpmath.pi


def rounded(problem: "Problem", error: Any) -> Any:
    """A relative bound and the rounding of one more quotient."""
    return error + 2.0**-52 if problem.digits is None else error


def unit(problem: "Problem") -> float:
    """The rounding of the numbers in which a problem is asked."""
    from vibcli.symbolic.running_errors import UNIT

    return UNIT if problem.digits is None else 10.0**-problem.digits


def measured(found: Any, least: float = 0.0) -> tuple[Any, float]:
    """(value, relative error bound) of a number with its bound; at least so much."""
    from vibcli.symbolic.running_errors import error_in, number_in

    value, error = number_in(found), error_in(found)
    return value, max(least, float(error / abs(value))) if value else ROUNDING


class ErrorOfZero(float):
    """What stands for the relative bound of a number that is found as 0 and may be off by `absolute`."""

    __slots__ = ("absolute",)
    absolute: float

    def __new__(cls, absolute: float) -> "ErrorOfZero":
        made = super().__new__(cls, 1.0 if absolute else ROUNDING)
        made.absolute = absolute
        return made


def absolute(value: Any, error: Any) -> Any:
    """The absolute bound of a number, given its relative one."""
    if isinstance(error, ErrorOfZero):
        return error.absolute
    return error * abs(value) if value else 0.0


def counted(count: int, noun: str) -> str:
    """A number of things in words: one mode, 2 modes."""
    return f"one {noun}" if count == 1 else f"{count} {noun}s"


class Declaration(NamedTuple):
    """`unit`: of the value; None where `dimension(spec, tree)` gives its dimension, or any fits.
    `value(problem, tree, args)`: (value, relative error bound), given the numbers of its arguments (None of a signal or
    a whole response); `symbolic(problem, tree)`: its expression in the letters of a scene, NotInLetters where it is
    found in numbers; `size(problem, tree)`: the largest value of its kind, what its rounding is measured by.
    `indices`, `args`: the kinds of what stands in square and in round brackets, these left out perhaps where
    `optional`, and of those `spare` at the end; `several`: a last index of its own says of which equilibrium;
    `at_once`: may `value` be asked of many scenes at once (quantities/at_once.py)?"""

    about: str
    unit: str | None = None
    value: Callable[..., tuple[Any, Any]] | None = None
    indices: tuple[str, ...] = ()
    args: tuple[str, ...] = ()
    components: tuple[str, ...] = ("",)
    dimension: "Callable[[Spec, QuantityRef], Mapping[str, Fraction | int] | None] | None" = None
    size: "Callable[[Problem, QuantityRef], float] | None" = None
    symbolic: "Callable[[Problem, QuantityRef], Node] | None" = None
    kind: str = NUMBER
    optional: bool = False
    several: bool = False
    spare: int = 0
    at_once: bool = False

    @property
    def own_unit(self) -> str | None:
        """The unit of its values; None where its indices or arguments settle it."""
        return None if self.unit == SIGNAL else self.unit

    @property
    def is_rate(self) -> bool:
        """Is it an angular frequency or a rate of growth, for which a number of cycles may be mistaken?"""
        return self.unit in ("rad/s", "1/s") and not self.args and self.kind != COMPLEX

    @property
    def topic(self) -> str | None:
        """The topic of the manual that tells more, if there is one."""
        if not self.args or self.args[0] == "time":
            return None
        return "response" if self.args[0] == "signal" else "frequency_response"


def one(problem: "Problem", tree: QuantityRef) -> float:
    """The size of an angle or a ratio."""
    return 1.0


def about_which(tree: QuantityRef) -> tuple[QuantityRef, str | None]:
    """(the tree without the index of an equilibrium, that index or None)."""
    quantity = declared(tree)
    if quantity.several and tree.alone and len(tree.indices) > len(quantity.indices) - quantity.spare:
        return tree._replace(indices=tree.indices[:-1], alone=False), tree.indices[-1]
    return tree, None


def named(form: str) -> Declaration:
    """The Declaration of a word, or of one of its forms; None where there is none."""
    family = FAMILIES.get(form) or FORMS.get(form)
    found: Declaration = None if family is None else import_module(f"vibcli.quantities.{family}").QUANTITIES[form]
    return found


def declared(tree: QuantityRef) -> Declaration:
    """The Declaration of a tree; None where there is none."""
    return _of_form(tree.head, bool(tree.indices), bool(tree.args),
                    tuple(arg.head for arg in tree.args if isinstance(arg, QuantityRef)))


@lru_cache(maxsize=1000)
def _of_form(head: str, indexed: bool, called: bool, within: tuple[str, ...]) -> Declaration:
    forms = [head + "[]" * indexed, head + "()" * called, *(f"{head}({arg})" for arg in within)]
    return named(next((form for form in forms if form in FORMS), head))


def quantity_of(spec: "Spec", tree: Any) -> Declaration | None:
    """The Declaration that a tree asks for; None of an expression of some, and of a chosen parameter."""
    return declared(tree) if isinstance(tree, QuantityRef) and not is_choice(spec, tree) else None


def asked_in(tree: Any) -> "Sequence[QuantityRef]":
    """The quantities that a tree asks for."""
    return parts_of(tree).quantities


def kind_of(spec: "Spec", tree: NameRef | QuantityRef | Sum) -> str | None:
    """The kind of the quantity that a tree asks for; None as above."""
    quantity = quantity_of(spec, tree)
    return None if quantity is None else quantity.kind


def parts_that_cancel(tree: QuantityRef) -> list[QuantityRef]:
    """The quantity, and of a sum of signals that of each: where they cancel the sum is small beside them."""
    if not tree.args or not isinstance(tree.args[0], Sum):
        return [tree]
    terms = [term for _, term in tree.args[0].parts if parts_of(term).names]
    return [tree, *(tree._replace(args=(term, *tree.args[1:])) for term in terms)]


def is_bare(name: str) -> bool:
    """Is this a quantity without index and argument, such as rayleigh or T?"""
    quantity = named(name) if name in FAMILIES else None
    return quantity is not None and not quantity.indices and not quantity.args


def usage(head: str, spec: "Spec | None" = None) -> str:
    """How a quantity is written, with indices and arguments that stand for any, or that a scene has."""
    return usage_of(head, named(head), spec)


def usage_of(head: str, quantity: Declaration, spec: "Spec | None" = None) -> str:
    from vibcli.quantities.index_kinds import INDICES

    def sample(kind: str) -> str:
        return next(iter(INDICES[kind].names(spec, "") if spec is not None else ()), INDICES[kind].sample)

    indices = ", ".join(map(sample, quantity.indices))
    args = [_ARGUMENTS[kind].format(x=sample("output"), F=sample("input")) for kind in quantity.args]
    args = (")(" if head in IN_TWO_BRACKETS else ", ").join(args)
    return head + (f"[{indices}]" if indices else "") + (f"({args})" if args else "") + (
        f".{quantity.components[0]}" if quantity.components[0] else "")


def is_choice(spec: "Spec", tree: QuantityRef | NameRef) -> bool:
    """Does a tree ask for a chosen parameter: c, or its second solution c[2]?"""
    choices = spec.get("choose") or ()
    if isinstance(tree, NameRef):
        return tree.name in choices and not tree.primes
    indices = tree.indices
    return tree.head in choices and len(indices) == 1 and indices[0].isdecimal() and (
        tree.head not in FAMILIES or len(named(tree.head).indices) != 1)
