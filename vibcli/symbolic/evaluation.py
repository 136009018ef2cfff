"""One evaluator for every kind of number: floats, NumPy arrays, mpmath, exact rationals, SymPy.

An arithmetic supplies `number(Fraction)`, `pi`, `power(base, Fraction)`, `functions` by name and `isfinite`;
sums and products use the operators of the numbers themselves.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

from vibcli.symbolic import discontinuous_functions
from vibcli.symbolic.expression_graph import evaluable
from vibcli.symbolic.floats import ELEMENTARY, sign
from vibcli.symbolic.floats import Floats as Floats
from vibcli.symbolic.rationals import HALF, ONE, bits, exact_root

if TYPE_CHECKING:
    import mpmath
    import sympy

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

OFTEN, LONGEST = 12, 20_000      # evaluations before expressions are compiled; parts of such as are not


def evaluate(nodes: "Sequence[Node]", arithmetic: Any, values: Any) -> list[Any]:
    """The values of `nodes`, given {symbol name: number}. What is evaluated again and again is compiled: the same
    operations in the same order, so the same numbers."""
    key = tuple(nodes)
    if not key:
        return []
    if arithmetic is Floats and hasattr(values, "watching"):
        found: list[Any] = values.watching(key, evaluate(key, Floats, values.plain))
        return found
    if len(key) == 1 and key[0].op == "number":
        return [arithmetic.number(key[0].coefficient)]
    programs = key[0].table.programs
    program = programs.get(key)
    if program is None:
        if key not in programs:
            programs[key] = None
            return _interpreted(key, evaluable(key), arithmetic, values)
        program = programs[key] = _Program(key)
    return program.run(arithmetic, values)


class _Program:
    """Expressions that were evaluated before: the order of their parts, how often, and functions that are compiled."""

    __slots__ = ("in_any", "in_floats", "nodes", "order", "times")

    def __init__(self, nodes: "tuple[Node, ...]") -> None:
        self.nodes, self.order, self.times = nodes, evaluable(nodes), 0
        self.in_floats: Callable[..., list[Any]] | None = None
        self.in_any: Callable[..., list[Any]] | None = None

    def run(self, arithmetic: Any, values: Any) -> list[Any]:
        function = self.in_floats if arithmetic is Floats else self.in_any
        if function is not None:
            return function(values, arithmetic)
        self.times += 1
        if self.times < OFTEN or len(self.order) > LONGEST:
            return _interpreted(self.nodes, self.order, arithmetic, values)
        self._compile(arithmetic)
        return self.run(arithmetic, values)

    def _compile(self, arithmetic: Any) -> None:
        from vibcli.symbolic import evaluation_code

        if arithmetic is Floats:
            self.in_floats = evaluation_code.in_floats(self.nodes, self.order)
        else:
            self.in_any = evaluation_code.in_any_arithmetic(self.nodes, self.order)


def _interpreted(nodes: "Sequence[Node]", order: "list[Node]", arithmetic: Any, values: Mapping[str, Any]) -> list[Any]:
    number, power, functions = arithmetic.number, arithmetic.power, arithmetic.functions
    done = {}
    for node in order:
        if node.op == "sum":
            parts = [done[part] if c == 1 else number(c) * done[part] for part, c in node.args]
            total = parts[0] + number(node.coefficient) if node.coefficient else parts[0]
            for part in parts[1:]:
                total = total + part
            done[node] = total
        elif node.op == "product":
            total = None if node.coefficient == 1 else number(node.coefficient)
            for base, exponent in node.args:
                factor = done[base] if exponent == 1 else power(done[base], exponent)
                total = factor if total is None else total * factor
            done[node] = total
        elif node.op == "symbol":
            definition = node.table.definitions.get(node)
            done[node] = values[node.name] if definition is None else arithmetic.defined(
                node.name, done[definition]) if hasattr(arithmetic, "defined") else done[definition]
        elif node.op == "number":
            done[node] = number(node.coefficient)
        elif node.op == "pi":
            done[node] = arithmetic.pi
        elif node.name in node.table.records:
            order = node.args[1].coefficient if len(node.args) > 1 else 0
            done[node] = arithmetic.record(node.name, node.table.records[node.name])(done[node.args[0]], order)
        elif node.name in node.table.functions:
            done[node] = arithmetic.called(node.table.functions[node.name])(*[done[arg] for arg in node.args])
        else:
            done[node] = functions[node.name](*[done[arg] for arg in node.args])
    return [done[node] for node in nodes]


class FunctionsWhenAsked(dict[str, Callable[..., Any]]):
    """The functions of an arithmetic over the numbers of another one, {name: function}: each is made by `make(name)`
    when it is first asked for."""

    def __init__(self, make: Callable[[str], Callable[..., Any]]) -> None:
        super().__init__()
        self._make = make

    def __missing__(self, name: str) -> Callable[..., Any]:
        found = self[name] = self._make(name)
        return found


class Rationals:
    """Exact rationals; whatever is irrational raises Irrational."""

    class Irrational(ArithmeticError):
        pass

    functions, ordered = {"abs": abs, "sign": sign, "min": min, "max": max}, True

    @property
    def pi(self) -> Fraction:
        raise self.Irrational

    number = Fraction

    @classmethod
    def record(cls, name: str, samples: Sequence[dict[str, float]]) -> None:
        raise cls.Irrational

    @classmethod
    def called(cls, function: "DefinedFunction") -> None:
        raise cls.Irrational

    @classmethod
    def power(cls, base: Fraction, exponent: Fraction | int) -> Fraction:
        if bits(base) * abs(exponent.numerator) > 10**5:
            raise cls.Irrational
        if exponent.denominator == 1:
            return Fraction(base) ** exponent.numerator
        root = exact_root(base) if exponent.denominator == 2 and base >= 0 else None
        if root is None:
            raise cls.Irrational
        return root ** exponent.numerator


def evaluate_rational(nodes: "Sequence[Node]", values: Mapping[str, Fraction]) -> list[Fraction] | None:
    """As `evaluate` in exact rationals; None where a part of it is irrational or undefined."""
    try:
        return evaluate(nodes, Rationals(), values)
    except (Rationals.Irrational, KeyError, ZeroDivisionError):
        return None


def multiprecision() -> Any:
    """mpmath numbers at the working precision of mpmath.mp."""
    import mpmath

    return _of_precision(mpmath.mp.prec)


@cache
def _of_precision(binary_digits: int) -> Any:
    """Those while mpmath.mp has so many binary digits."""
    import mpmath

    class Multiprecision:
        pi, ordered = +mpmath.mp.pi, True
        isfinite = staticmethod(mpmath.isfinite)

        record, called = staticmethod(Floats.record), staticmethod(Floats.called)

        @staticmethod
        def number(value: "Fraction | int") -> "mpmath.mpf":
            above, below = mpmath.mpf(value.numerator), value.denominator
            return above if below == 1 else above / below       # a division by 1 costs as much as any other

        @staticmethod
        def power(base: "mpmath.mpc | mpmath.mpf", exponent: "Fraction | int") -> "mpmath.mpc | mpmath.mpf":
            if exponent.denominator == 1:
                return base**exponent.numerator
            if exponent == HALF:
                return mpmath.sqrt(base)
            return mpmath.power(base, mpmath.mpf(exponent.numerator) / exponent.denominator)

        functions = {name: getattr(mpmath, name) for name in (*ELEMENTARY, "sign")}
    Multiprecision.functions.update(abs=abs, min=min, max=max, power=mpmath.power,
                                    **discontinuous_functions.on(Multiprecision.pi, mpmath.floor))
    return Multiprecision()


def sympy_arithmetic() -> Any:
    """SymPy expressions; used for closed forms and simplification only."""
    import sympy

    class Symbolic:
        pi = sympy.pi

        @staticmethod
        def number(value: "Fraction | int") -> Any:
            return sympy.Rational(value.numerator, value.denominator)

        @staticmethod
        def record(name: str, samples: Any) -> "sympy.Function":
            return sympy.Function(name, real=True)

        @staticmethod
        def called(function: "DefinedFunction") -> "sympy.Function":
            return sympy.Function(function.name, real=True)

        @staticmethod
        def power(base: Any, exponent: "Fraction | int") -> Any:
            return sympy.Pow(base, sympy.Rational(exponent.numerator, exponent.denominator))

        functions = {name: getattr(sympy, name) for name in (*ELEMENTARY, "sign")}
    Symbolic.functions.update(abs=sympy.Abs, min=sympy.Min, max=sympy.Max, power=sympy.Pow,
                              **{name: sympy.Function(name, real=True) for name in discontinuous_functions.PULSES})
    return Symbolic()


def from_sympy(table: "Table", expression: "sympy.Basic", symbols: "Mapping[sympy.Symbol, Node]") -> "Node":
    """A SymPy expression as a node; `symbols` maps SymPy symbols to nodes. ValueError where it cannot be said."""
    if expression in symbols:
        return symbols[expression]
    if expression.is_Rational:
        return table.number(Fraction(int(expression.p), int(expression.q)))
    if expression.is_Add:
        return table.sum(*((from_sympy(table, part, symbols), ONE) for part in expression.args))
    if expression.is_Mul:
        return table.product(*((from_sympy(table, part, symbols), ONE) for part in expression.args))
    if expression.is_Pow:
        base, exponent = (from_sympy(table, part, symbols) for part in expression.args)
        return table.power(base, exponent)
    if expression.is_NumberSymbol and str(expression) == "pi":
        return table.pi
    name = {"Abs": "abs", "Min": "min", "Max": "max"}.get(expression.func.__name__, expression.func.__name__)
    if name not in Floats.functions and name not in table.records and name not in table.functions:
        raise ValueError(f"no {name} here")
    return table.call(name, *(from_sympy(table, part, symbols) for part in expression.args))
