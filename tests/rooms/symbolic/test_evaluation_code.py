"""Compiled expressions have the values of the interpreter, to the last bit and to the last NaN."""

import random
from fractions import Fraction

import mpmath
import pytest

from vibcli.symbolic import evaluation, evaluation_code
from vibcli.symbolic.dual_numbers import Dual, Duals
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.evaluation_code import in_any_arithmetic, in_floats
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import evaluable

FUNCTIONS = ("sin", "cos", "tan", "asin", "atan", "exp", "log", "tanh", "abs", "sign", "step", "ramp")


def drawn(table, symbols, generator, depth):
    """A random expression."""
    if depth == 0:
        return generator.choice([*symbols, table.pi, table.number(Fraction(generator.randint(-9, 9), 7))])
    a, b = (drawn(table, symbols, generator, depth - 1) for _ in range(2))
    kind = generator.randrange(6)
    if kind < 2:
        return a + table.scaled(b, Fraction(generator.randint(-20, 20), 3))
    if kind < 4:
        return a * b
    if kind == 4:
        return table.call(generator.choice(FUNCTIONS), a)
    return table.power(a, table.number(Fraction(generator.choice([-2, -1, 2, 3, 5]), generator.choice([1, 2]))))


def bits(values):
    return [float(value).hex() for value in values]


def compiled(nodes):
    function = in_floats(nodes, evaluable(nodes))
    return lambda values: function(values, Floats)


def outcome(function, *args):
    """All digits of the values, or the name of what is raised."""
    try:
        return list(map(repr, function(*args)))
    except TypeError as error:      # complex numbers have no order
        return repr(error)


def interpreted(nodes, arithmetic, values):
    return evaluation._interpreted(nodes, evaluable(nodes), arithmetic, values)


@pytest.mark.parametrize("seed", range(40))
def test_random_expressions(seed):
    generator, table = random.Random(seed), Table()
    symbols = [table.parameter(name) for name in "abc"] + [table.variable("x")]
    nodes = []
    while len(nodes) < 12:
        try:
            nodes.append(drawn(table, symbols, generator, 4))
        except ZeroDivisionError:
            continue
    function = compiled(nodes)
    for size in (1.0, 1e-9, 1e120):
        values = {name: size * generator.uniform(-2, 2) for name in "abcx"}
        assert bits(function(values)) == bits(interpreted(nodes, Floats, values))


@pytest.mark.parametrize("seed", range(40))
def test_random_expressions_in_other_arithmetics(seed):
    generator, table = random.Random(seed), Table()
    symbols = [table.parameter(name) for name in "abc"] + [table.variable("x")]
    nodes = []
    while len(nodes) < 8:
        try:
            nodes.append(drawn(table, symbols, generator, 3))
        except ZeroDivisionError:
            continue
    function, plain = in_any_arithmetic(nodes, evaluable(nodes)), in_floats(nodes, evaluable(nodes))
    floats = {name: generator.uniform(0.1, 2) for name in "abcx"}
    assert bits(function(floats, Floats)) == bits(plain(floats, Floats))
    with mpmath.workdps(30):
        values = {name: mpmath.mpf(value) for name, value in floats.items()}
        assert outcome(function, values, multiprecision()) == outcome(
            lambda *args: interpreted(nodes, *reversed(args)), values, multiprecision())
    values = {**floats, "x": Dual(floats["x"], 1.0)}
    found, expected = function(values, Duals(Floats)), interpreted(nodes, Duals(Floats), values)
    for one, other in zip(found, expected, strict=True):
        assert bits([getattr(one, "value", one), getattr(one, "slope", 0.0)]) == bits(
            [getattr(other, "value", other), getattr(other, "slope", 0.0)])


def test_what_is_evaluated_again_and_again_is_compiled_once(monkeypatch):
    """Each kind of arithmetic has its own function; before and after that the values are the same."""
    made = []
    for name in ("in_floats", "in_any_arithmetic"):
        real = getattr(evaluation_code, name)
        monkeypatch.setattr(evaluation_code, name, lambda *args, real=real, name=name: made.append(name) or real(*args))
    table = Table()
    x = table.variable("x")
    nodes = [table.call("sin", x) * x + x**3, table.sqrt(x)]
    floats = {tuple(bits(evaluate(nodes, Floats, {"x": 0.7}))) for _ in range(3 * evaluation.OFTEN)}
    with mpmath.workdps(30):
        precise = {tuple(map(repr, evaluate(nodes, multiprecision(), {"x": mpmath.mpf("0.7")})))
                   for _ in range(3 * evaluation.OFTEN)}
    assert len(floats) == len(precise) == 1
    assert made == ["in_floats", "in_any_arithmetic"]


def test_a_table_that_grows_changes_no_value():
    table = Table()
    x = table.variable("x")
    node = table.defined("of_x", table.call("cos", x) + x) * x
    before = bits(evaluate([node], Floats, {"x": 0.3}))
    for i in range(2 * evaluation.OFTEN):
        table.defined(f"later{i}", node + x**i)
        table.resample({"x": float(-i)})
        assert bits(evaluate([node], Floats, {"x": 0.3})) == before


def test_long_sums_and_symbols_that_stand_for_others():
    table = Table()
    symbols = [table.parameter(f"p{i}") for i in range(700)]
    total = table.sum(*((symbol, Fraction(i + 1, 3)) for i, symbol in enumerate(symbols)))
    product = table.product(*((symbol, Fraction(1)) for symbol in symbols))
    named = table.defined("long", total * symbols[0])
    nodes = [named + symbols[1], product, table.zero, table.pi]
    values = {f"p{i}": 1.0 + i / 1000 for i in range(700)}
    assert bits(compiled(nodes)(values)) == bits(interpreted(nodes, Floats, values))


def test_no_text_of_a_file_gets_into_the_source():
    table = Table()
    name = "x'); import os  #"
    assert compiled([table.parameter(name) + table.one])({name: 2.0}) == [3.0]
