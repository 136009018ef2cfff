"""Random expressions, built at once as nodes, as SymPy expressions and as functions of mpmath."""

import random
from fractions import Fraction

import mpmath
import sympy

from vibcli.symbolic.expression import Table

NAMES = ("x", "y", "x'", "m", "k")
SYMBOLS = {name: sympy.Symbol(name.replace("'", "1"), positive=True if name in ("m", "k") else None, real=True)
           for name in NAMES}
UNARY = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "abs")
BINARY = ("atan2", "min", "max")
CONSTANTS = tuple(map(Fraction, ("0", "1", "-1", "2", "-3", "1/2", "5/3", "-7/4", "1e-3", "12")))


class Tree:
    """One expression three times: `node`, `sympy`, and `at(values)` with mpmath numbers by name."""

    def __init__(self, node, expression, at):
        self.node, self.sympy, self.at = node, expression, at


def new_table():
    table = Table()
    for name in NAMES:
        table.parameter(name) if name in ("m", "k") else table.variable(name)
    return table


def symbol(table, name):
    return table.parameter(name) if name in ("m", "k") else table.variable(name)


def leaf(table, generator):
    if generator.random() < 0.3:
        value = generator.choice(CONSTANTS)
        return Tree(table.number(value), sympy.Rational(value.numerator, value.denominator),
                    lambda values: mpmath.mpf(value.numerator) / value.denominator)
    if generator.random() < 0.08:
        return Tree(table.pi, sympy.pi, lambda values: +mpmath.pi)
    name = generator.choice(NAMES)
    return Tree(symbol(table, name), SYMBOLS[name], lambda values: values[name])


def tree(table, generator, depth, functions=UNARY + BINARY):
    """A random expression of at most so many levels."""
    if depth == 0 or generator.random() < 0.1:
        return leaf(table, generator)
    kind = generator.choice(("sum", "difference", "product", "quotient", "power", "root", "call", "call"))
    if kind == "call":
        return call(table, generator, depth, functions)
    a = tree(table, generator, depth - 1, functions)
    if kind in ("power", "root"):
        exponent = generator.choice((2, 3, -1, -2)) if kind == "power" else Fraction(1, 2)
        return power(a, exponent)
    return combined(kind, a, tree(table, generator, depth - 1, functions))


def combined(kind, a, b):
    if kind == "sum":
        return Tree(a.node + b.node, a.sympy + b.sympy, lambda values: a.at(values) + b.at(values))
    if kind == "difference":
        return Tree(a.node - b.node, a.sympy - b.sympy, lambda values: a.at(values) - b.at(values))
    if kind == "product" or b.node.is_zero:
        return Tree(a.node * b.node, a.sympy * b.sympy, lambda values: a.at(values) * b.at(values))
    return Tree(a.node / b.node, a.sympy / b.sympy, lambda values: a.at(values) / b.at(values))


def power(a, exponent):
    if a.node.is_zero and exponent < 0:
        return a
    if exponent == Fraction(1, 2):
        return Tree(a.node.table.sqrt(a.node), sympy.sqrt(a.sympy), lambda values: checked(mpmath.sqrt(a.at(values))))
    return Tree(a.node**exponent, a.sympy**exponent, lambda values: a.at(values) ** exponent)


SYMPY_NAMES = {"abs": sympy.Abs, "min": sympy.Min, "max": sympy.Max}
MPMATH_NAMES = {"abs": abs, "min": min, "max": max}


def call(table, generator, depth, functions):
    name = generator.choice(functions)
    args = [tree(table, generator, depth - 1, functions) for _ in range(2 if name in BINARY else 1)]
    theirs, numeric = SYMPY_NAMES.get(name) or getattr(sympy, name), MPMATH_NAMES.get(name) or getattr(mpmath, name)
    return Tree(table.call(name, *(arg.node for arg in args)), theirs(*(arg.sympy for arg in args)),
                lambda values: checked(numeric(*(arg.at(values) for arg in args))))


def checked(value):
    """The value where it is real; ValueError for others, as of the root of a negative number."""
    if isinstance(value, mpmath.mpc):
        raise ValueError("not real")
    return value


def values(generator):
    """Random values by name: parameters positive."""
    return {name: generator.uniform(0.3, 2.5) if name in ("m", "k") else generator.uniform(-1.4, 1.4) for name in NAMES}


def real(value):
    """A real finite mpmath number as it is, None for others."""
    return value if isinstance(value, (mpmath.mpf, int)) and mpmath.isfinite(value) else None


def trees(count, seed, depth=4, functions=UNARY + BINARY):
    """`count` random trees, each on a table of its own, with the generator that goes on."""
    for i in range(count):
        generator = random.Random(f"{seed} {i}")
        try:
            yield tree(new_table(), generator, generator.randint(1, depth), functions), generator
        except (ZeroDivisionError, ValueError, TypeError):     # the latter two of SymPy: not comparable
            continue
