"""Nodes: one object for equal expressions, exact folding within bounds, substitution, exact arithmetic."""

from fractions import Fraction

import mpmath
import pytest
from support.scenes import number, problem
from support.trees import new_table, trees, values

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, Rationals, evaluate, evaluate_rational
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.parser import parse
from vibcli.symbolic.rationals import BITS, bits
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import ExpressionError, Number, whole_literal


@pytest.fixture
def table():
    return new_table()


def leaves(table):
    return [table.variable("x"), table.variable("y"), table.parameter("m"), table.parameter("k")]


def test_equal_expressions_are_one_object(table):
    x, y, m, k = leaves(table)
    assert x + y is y + x
    assert x * m is m * x
    assert (x + y) + m is x + (y + m)
    assert (x * y) * m is x * (y * m)
    assert x - x is table.zero
    assert x / x is table.one
    assert 2 * x + 3 * x is 5 * x
    assert -(x * -1) is x
    assert x * x is x**2
    assert m**Fraction(1, 2) * m**Fraction(1, 2) is m
    assert table.call("sin", x + y) is table.call("sin", y + x)
    assert 2 * (x + y) is 2 * x + 2 * y
    assert (x + y) / 2 + (x - y) / 2 is x
    assert k * (x - y) is not k * (y - x)


@pytest.mark.parametrize("i", range(30))
def test_rebuilding_gives_the_same_object(i):
    for expression, _ in trees(10, f"rebuilt {i}"):
        node = expression.node
        table = node.table
        count = len(table)
        for part in reachable([node]):
            if part.op == "sum":
                again = table.sum((table.number(part.coefficient), Fraction(1)), *reversed(part.args))
            elif part.op == "product":
                again = table.product((table.number(part.coefficient), Fraction(1)), *reversed(part.args))
            else:
                continue
            assert again is part
        assert len(table) <= count + len(reachable([node]))


SIXTHS = ("0", "1/4", "3/4", "1", "3/4", "1/4")       # sin² of multiples of π/6


@pytest.mark.parametrize("n", range(-25, 26))
def test_sines_of_multiples_of_a_sixth(table, n):
    """Exact: the square is the rational number that it is, the sign that of the float."""
    for name, m in (("sin", n), ("cos", n + 3)):
        node = table.call(name, table.pi * n / 6)
        assert node * node is table.number(Fraction(SIXTHS[m % 6]))
        assert evaluate([node], Floats, {})[0] == pytest.approx(exact_value(name, n, 6), rel=1e-15, abs=1e-25)


@pytest.mark.parametrize("n", [-5, -3, -1, 1, 3, 5, 7, 9])
def test_sines_of_odd_quarters(table, n):
    for name in ("sin", "cos"):
        node = table.call(name, table.pi * n / 4)
        assert not any(part.op == "call" for part in reachable([node]))
        assert evaluate([node], Floats, {})[0] == pytest.approx(exact_value(name, n, 4), rel=1e-15)


def exact_value(name, n, parts):
    with mpmath.workdps(40):
        return float(getattr(mpmath, name)(mpmath.pi * n / parts))


@pytest.mark.parametrize("n, d", [(1, 5), (1, 7), (3, 8), (1, 12)])
def test_other_sines_stay(table, n, d):
    assert table.call("sin", table.pi * n / d).op == "call"


def test_values_that_fold(table):
    zero, one = table.zero, table.one
    assert table.call("cos", zero) is one
    assert table.call("exp", zero) is one
    assert table.call("log", one) is zero
    assert table.call("sign", zero) is zero
    for x in (Fraction(1, 10), 7, Fraction(-3, 2)):
        assert table.call("sign", table.number(x)) is table.number(1 if x > 0 else -1)
    assert table.call("sin", -table.variable("x")) is -table.call("sin", table.variable("x"))
    assert table.call("cos", -table.variable("x")) is table.call("cos", table.variable("x"))
    assert table.call("acos", zero).op == "call"
    assert table.call("log", table.number(2)).op == "call"


def test_roots(table):
    x, _, m, k = leaves(table)
    assert table.sqrt(table.number(Fraction(9, 4))) is table.number(Fraction(3, 2))
    assert table.sqrt(m * m) is m
    assert table.sqrt(m**2 * k**4 * 9) is 3 * m * k**2
    assert table.sqrt(table.number(2)) * table.sqrt(table.number(2)) is table.number(2)
    assert table.sqrt(table.number(8)).op != "number"
    loose = table.parameter("a", positive=False)
    for u in (loose, x):
        root = table.sqrt(u * u)
        for value in (-1.5, 1.5):
            assert evaluate([root], Floats, {u.name: value})[0] == 1.5


def test_powers_and_digits_are_bounded(table):
    big = table.number(10) ** 500
    assert big.op == "product" and big.args[0][1] == 500
    tower = table.number(9) ** (table.number(9) ** table.number(9))
    assert bits_of(tower) <= 4 * BITS
    ladder = table.number(3)
    for _ in range(30):
        ladder = ladder * ladder
    assert bits_of(ladder) <= 4 * BITS
    total = table.zero
    for p in (10**40 + 1, 10**45 + 3, 10**50 + 7, 10**42 + 9):
        total = total + table.number(Fraction(1, p))
    assert bits_of(total) <= 4 * BITS
    assert evaluate([total], Floats, {})[0] == pytest.approx(1e-40 + 1e-45 + 1e-50 + 1e-42)


def bits_of(node):
    return max(bits(part.coefficient) for part in reachable([node]))


def test_division_by_zero(table):
    x = table.variable("x")
    with pytest.raises(ZeroDivisionError):
        x / table.zero
    with pytest.raises(ZeroDivisionError):
        table.zero**-2
    with pytest.raises(ZeroDivisionError):
        x / (x - x)


@pytest.mark.parametrize("i", range(12))
def test_substitution_is_evaluation_at_another_place(i):
    for expression, generator in trees(15, f"substituted {i}"):
        node, table = expression.node, expression.node.table
        point = values(generator)
        inner = table.variable("y") * table.variable("y") / 4 + Fraction(1, 3)
        try:
            moved, = substitute([node], {table.variable("x"): inner})
        except ZeroDivisionError:
            continue
        there = point | {"x": point["y"] ** 2 / 4 + 1 / 3}
        a, b = evaluate([moved], Floats, point)[0], evaluate([node], Floats, there)[0]
        assert (a != a and b != b) or a == pytest.approx(b, rel=1e-7, abs=1e-7) or abs(b) > 1e6
        assert not any(part is table.variable("x") for part in reachable([moved]))


def test_substitution_leaves_the_rest(table):
    x, y, m, _ = leaves(table)
    node = table.call("sin", m * y) + m
    assert substitute([node, x], {x: table.zero}) == [node, table.zero]
    both = substitute([x + y], {x: y, y: x})[0]
    assert both is x + y


def test_exact_rationals(table):
    x, y, m, k = leaves(table)
    node = (x + y) ** 3 / (m * m) + table.sqrt(k)
    given = {"x": Fraction(1, 3), "y": Fraction(1, 6), "m": Fraction(3), "k": Fraction(4, 9)}
    assert evaluate_rational([node], given) == [Fraction(1, 72) + Fraction(2, 3)]
    assert evaluate_rational([table.sqrt(k)], {"k": Fraction(2)}) is None
    assert evaluate_rational([table.call("sin", x)], {"x": Fraction(1)}) is None
    assert evaluate_rational([1 / x], {"x": Fraction(0)}) is None
    assert evaluate_rational([table.pi], {}) is None
    with pytest.raises(Rationals.Irrational):
        evaluate([table.pi * m], Rationals(), {"m": Fraction(1)})


def test_what_is_not_real_is_nan(table):
    x = table.variable("x")
    for node, value in ((table.sqrt(x), -1.0), (table.call("log", x), -1.0), (1 / x, 0.0), (table.call("exp", x), 1e6),
                        (x ** Fraction(1, 3), -8.0), (table.call("asin", x), 1.5)):
        assert evaluate([node], Floats, {"x": value})[0] != evaluate([node], Floats, {"x": value})[0]


@pytest.mark.sweep
def test_deep_expressions_do_not_recurse():
    table = Table()
    x = table.variable("x")
    node = x
    for _ in range(5000):
        node = table.call("sin", node + 1)
    assert abs(evaluate([node], Floats, {"x": 0.3})[0]) <= 1
    assert substitute([node], {x: table.zero})[0] is not node
    assert not is_zero(x)


@pytest.mark.parametrize("text, expected", [
    ("2^3^2", 512), ("-2^2", -4), ("2^-1", 0.5), ("6/2/3", 1), ("6/2*3", 9), ("1 - 2 - 3", -4), ("-(1 - 2)", 1),
    ("2*(-3)", -6), ("sqrt(16)^(1/2)", 2), ("3·2", 6), ("+4", 4), ("1e3", 1000), ("-1^2*3", -3),
    ("min(2, 3) + max(2, 3)", 5), ("2**3", 8), ("sign(-2)*abs(-3)", -3), ("atan2(0, -1)/pi", 1)])
def test_precedence(text, expected):
    assert float(number(parse(text), {})) == expected
    table = Table()
    assert evaluate([lower(parse(text), table, None)], Floats, {})[0] == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("text, expected", [
    ("3 mm", "3/1000"), ("2.5 kN/m", "2500"), ("1 N*s/m", "1"), ("7 g/cm^3", "7000"), ("72 km/s", "72000"),
    ("5 µm", "1/200000"),
    ("10 %", "1/10"), ("0.1", "1/10")])
def test_literals_are_exact(text, expected):
    assert lower(parse(text), Table(), None).coefficient == Fraction(expected)


def test_numbers_that_grow_without_end_cost_nothing():
    """Huge powers, and parameters that double their digits at each step."""
    lines = ["  p0: 1.000000001", "  q0: 1.000000003", "  h: 10^100/10^97"]
    for i in range(30):
        lines += [f"  p{i + 1}: p{i}*q{i}", f"  q{i + 1}: q{i}*p{i}*1.000000001"]
    scene = problem("parameters:\n" + "\n".join(lines) + "\nbodies: {b: {mass: 2, slide: x}}\n"
                    "springs: {s: {k: h*p30/q30, between: [ground, b]}}\n")
    assert scene.numeric.floats["h"] * 1.0 == 1000.0
    floats = scene.numeric.floats
    assert scene.modal.modes[0].omega ** 2 == pytest.approx(500 * floats["p30"] / floats["q30"])
    assert max(bits(number) for number in scene.numeric.rational.values()) < 10**4


@pytest.mark.parametrize(("written", "most", "words"), [
    (lambda n: "+".join(["1"] * n), 400, "400 terms"), (lambda n: "*".join(["1"] * n), 400, "400 factors"),
    (lambda n: "(" * n + "1" + ")" * n, 64, "64 levels"), (lambda n: "sin(" * n + "0" + ")" * n, 64, "64 levels"),
    (lambda n: "^".join(["1"] * (n + 2)), 64, "64 powers"), (lambda n: " " * (n - 1) + "1", 2000, "2000")])
def test_an_expression_is_read_up_to_the_limit_that_is_told_beyond_it(written, most, words):
    parse(written(most))
    with pytest.raises(ExpressionError) as refused:
        parse(written(most + 1))
    assert words in refused.value.message


@pytest.mark.parametrize(("text", "one"), [("5", True), ("-5 m", True), ("+3 N/m", True), ("1.5e3 s^-1", True),
                                           ("5 m + 3 m", False), ("-2 - 3", False), ("2*3", False), ("-x", False),
                                           ("x + 2", False), ("2^2", False), ("-(2 m)", True), ("sin(1)", False)])
def test_one_literal_is_told_from_a_sum(text, one):
    found = whole_literal(parse(text))
    assert isinstance(found, Number) == one
