"""Compiled floats are those of the interpreter, to the last bit and to the last NaN."""

import random
from fractions import Fraction

import pytest

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.float_code import compiled

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
        assert bits(function(values)) == bits(evaluate(nodes, Floats, values))


def test_long_sums_and_symbols_that_stand_for_others():
    table = Table()
    symbols = [table.parameter(f"p{i}") for i in range(700)]
    total = table.sum(*((symbol, Fraction(i + 1, 3)) for i, symbol in enumerate(symbols)))
    product = table.product(*((symbol, Fraction(1)) for symbol in symbols))
    named = table.defined("long", total * symbols[0])
    nodes = [named + symbols[1], product, table.zero, table.pi]
    values = {f"p{i}": 1.0 + i / 1000 for i in range(700)}
    assert bits(compiled(nodes)(values)) == bits(evaluate(nodes, Floats, values))


def test_no_text_of_a_file_gets_into_the_source():
    table = Table()
    name = "x'); import os  #"
    assert compiled([table.parameter(name) + table.one])({name: 2.0}) == (3.0,)
