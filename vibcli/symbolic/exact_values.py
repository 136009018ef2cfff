"""Values of functions that are exact: sin 0, cos(π/6), |a| of a positive a; and f(−u) by parity.

What begins at t = 0 has not begun in the drawn position: step(0) and a record at its start fold to 0, and square(0) to
the mean of its jump.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.symbolic.rationals import HALF, ONE, ZERO

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

_EXACT = {"sin": (0, 0), "cos": (0, 1), "tan": (0, 0), "asin": (0, 0), "atan": (0, 0), "sinh": (0, 0), "cosh": (0, 1),
          "tanh": (0, 0), "exp": (0, 1), "log": (1, 0), "abs": (0, 0),
          "square": (0, 0), "sawtooth": (0, -1)}
_ODD = {"sin", "tan", "asin", "atan", "sinh", "tanh", "sign"}
_EVEN = {"cos", "cosh", "abs"}
_STARTS = ("step", "ramp", "impulse")
_SQUARED_SINES: dict[Fraction | int, Fraction | int] = {
    ZERO: ZERO, Fraction(1, 12): Fraction(1, 4), Fraction(1, 8): HALF, Fraction(1, 6): Fraction(3, 4),
    Fraction(1, 4): ONE}


def folded(table: "Table", name: str, args: "Sequence[Node]") -> "Node | None":
    """The simpler node that name(args) equals exactly, or None."""
    value = _EXACT.get(name)
    if value is not None and args[0].op == "number" and args[0].coefficient == value[0] and len(args) == 1:
        return table.number(value[1])
    if name == "power" and args[0].is_zero:
        return _power_of_zero(table, args[1])
    if name == "sign" and args[0].op == "number":
        return table.number((args[0].coefficient > 0) - (args[0].coefficient < 0))
    if name == "sign" and table.is_positive(args[0]):
        return table.one
    if name == "atan2" and args[0].is_zero and _adds_squares(args[1]):
        return table.zero
    if name in _STARTS and args[0].op == "number":
        begun = args[0].coefficient > 0
        return {"step": table.one, "ramp": args[0]}.get(name, table.zero) if begun else table.zero
    if name in ("max", "min") and all(arg.op == "number" for arg in args):
        return table.number({"max": max, "min": min}[name](arg.coefficient for arg in args))
    if name in table.records and args[0].is_zero and table.records[name].times[0] >= 0:
        return table.zero
    if name in table.functions:
        return table.functions[name].folded(table, args)
    if name in _ODD and _turns_positive(args[0]):
        return -table.call(name, -args[0])
    if name in _EVEN and _turns_positive(args[0]):
        return table.call(name, -args[0])
    if name in ("sin", "cos"):
        return _at_multiple_of_pi(table, name, args[0])
    return args[0] if name == "abs" and table.is_positive(args[0]) else None


def _adds_squares(node: "Node") -> bool:
    """Is it a sum of squares?"""
    if node.op == "sum":
        return node.coefficient >= 0 and all(c > 0 and _adds_squares(part) for part, c in node.args)
    even = node.op == "product" and all(e % 2 == 0 for _, e in node.args)
    return node.coefficient >= 0 and (even or node.op == "number")


def _power_of_zero(table: "Table", exponent: "Node") -> "Node | None":
    """0ⁿ, by the sign that n has at the sample values."""
    if exponent.mask or (table.sample is None and exponent.op != "number"):
        return None
    from vibcli.symbolic.evaluation import Floats, evaluate

    try:
        n, = evaluate([exponent], Floats, table.sample or {})
    except KeyError:        # a symbol that is no parameter of the scene
        return None
    if n < 0:
        raise ZeroDivisionError("division by zero")
    return table.zero if n else table.one


def _at_multiple_of_pi(table: "Table", name: str, angle: "Node") -> "Node | None":
    """sin or cos of a multiple of π/6 or π/4, of another of π that of an angle below π/2; None of other angles."""
    if angle is not table.pi and not (angle.op == "product" and angle.args == ((table.pi, ONE),)):
        return None
    quarter = Fraction(1, 4) if name == "cos" else ZERO
    turns = (angle.coefficient * HALF + quarter) % 1
    sign = -ONE if turns > HALF else ONE
    turns = min(turns % HALF, HALF - turns % HALF)
    square = _SQUARED_SINES.get(turns)
    if square is not None:
        return table.scaled(table.sqrt(table.number(square)), sign)
    small = 2 * abs(turns - quarter)
    return None if small == angle.coefficient else table.scaled(table.call(name, table.pi * small), sign)


def _is_negative(node: "Node") -> bool:
    """Is -node the shorter way to write it? Only a matter of form."""
    if node.op == "sum":
        return all(c < 0 for _, c in node.args) and node.coefficient <= 0
    return node.coefficient < 0


def _turns_positive(node: "Node") -> bool:
    """Is it negative, its opposite not? A number too long to be multiplied out is negative under either sign."""
    return _is_negative(node) and not _is_negative(-node)
