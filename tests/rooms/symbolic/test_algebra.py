"""The algebra against mpmath and SymPy: values, derivatives, normal forms, notation."""

import random
from fractions import Fraction

import mpmath
import pytest
import sympy
from support.scenes import number
from support.trees import NAMES, SYMBOLS, new_table, real, symbol, trees, values

from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, from_sympy, multiprecision, sympy_arithmetic
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import expanded, is_zero, textbook
from vibcli.symbolic.parser import parse
from vibcli.symbolic.radicals import root, without_bars
from vibcli.symbolic.semantics import lower

SMOOTH = ("sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "exp")
MECHANICAL = ("sin", "cos")
BATCHES = range(8)
DIGITS = 60



def derivative(node, variable):
    return gradient(node).get(variable, node.table.zero)


def hessian(node):
    """{(a, b): second derivative}, both triangles."""
    return {(a, b): second for a, first in gradient(node).items() for b, second in gradient(first).items()}


@pytest.fixture(autouse=True)
def sixty_digits():
    with mpmath.workdps(DIGITS):
        yield


def precise(node, point):
    return evaluate([node], multiprecision(), {name: mpmath.mpf(value) for name, value in point.items()})[0]


def close(a, b, rtol=1e-25):
    """Two mpmath numbers to far beyond floats; sums that cancel are allowed an absolute remainder."""
    return abs(a - b) <= rtol * (1 + abs(a) + abs(b))


def reference(expression, generator):
    """(point, value) of a tree where it is real, of moderate size and not lost by cancellation, else None."""
    point = values(generator)
    value = plainly(expression, point)
    if value is None or abs(value) > 1e8:
        return None
    with mpmath.workdps(2 * DIGITS):
        exact = plainly(expression, point)
    return (point, value) if exact is not None and close(exact, value, mpmath.mpf(10) ** -35) else None


def plainly(expression, point):
    """The value of a tree by mpmath alone, None where it is not real."""
    try:
        return real(expression.at({name: mpmath.mpf(x) for name, x in point.items()}))
    except (ZeroDivisionError, ValueError, TypeError, OverflowError):
        return None


def references(batch, count=60, depth=4, functions=None):
    found = []
    more = {"functions": functions} if functions else {}
    for expression, generator in trees(count, batch, depth, **more):
        for _ in range(3):
            pair = reference(expression, generator)
            if pair:
                found.append((expression, *pair))
                break
    assert len(found) > count // 3
    return found


@pytest.mark.sweep
@pytest.mark.parametrize("batch", BATCHES)
def test_values_in_many_digits(batch):
    for expression, point, value in references(batch):
        ours = precise(expression.node, point)
        assert close(ours, value), expression.node


@pytest.mark.parametrize("batch", BATCHES)
def test_values_in_floats(batch):
    """Floats differ by rounding, amplified at most as a 17-digit evaluation of the same tree is."""
    for expression, point, value in references(batch):
        ours = evaluate([expression.node], Floats, point)[0]
        assert condition(expression, point, value) > 1e6 or abs(ours - float(value)) <= 1e-8 * (1 + abs(float(value)))


def condition(expression, point, value):
    """How much a tree amplifies relative changes of 1e-15 in its data, roughly."""
    nudged = {name: mpmath.mpf(x) * (1 + mpmath.mpf(10) ** -15 * i) for i, (name, x) in enumerate(point.items(), 1)}
    other = plainly(expression, nudged)
    return mpmath.inf if other is None else abs(other - value) / 10**-15


@pytest.mark.parametrize("batch", BATCHES)
def test_to_sympy_and_back(batch):
    arithmetic = sympy_arithmetic()
    for expression, point, value in references(batch, 25, 3):
        table = expression.node.table
        theirs = evaluate([expression.node], arithmetic, SYMBOLS)[0]
        ours = theirs.evalf(30, subs={SYMBOLS[name]: sympy.Float(x, 40) for name, x in point.items()})
        if ours.is_number and ours.is_real:
            assert close(mpmath.mpf(str(ours)), value, 1e-20)
        try:
            back = from_sympy(table, theirs, {SYMBOLS[name]: node_of(table, name) for name in NAMES})
        except ValueError:
            continue
        assert close(precise(back, point), value)


def node_of(table, name):
    return table.parameter(name) if name in ("m", "k") else table.variable(name)


@pytest.mark.parametrize("batch", BATCHES)
def test_derivatives_against_sympy(batch):
    for expression, point, _ in references(batch, 25, 3, SMOOTH):
        table = expression.node.table
        exact = {SYMBOLS[name]: sympy.Float(x, 40) for name, x in point.items()}
        for name in ("x", "y", "x'"):
            theirs = sympy.diff(expression.sympy, SYMBOLS[name]).subs(exact).evalf(30)
            ours = precise(derivative(expression.node, table.variable(name)), point)
            if theirs.is_Float and mpmath.isfinite(mpmath.mpf(str(theirs))) and abs(theirs) < 1e6:
                assert close(ours, mpmath.mpf(str(theirs)), 1e-17), (expression.sympy, name)


@pytest.mark.parametrize("batch", BATCHES)
def test_derivatives_against_differences(batch):
    """All functions, those with kinks included: a central difference in 40 digits."""
    for expression, point, _ in references(batch, 40, 3):
        table = expression.node.table
        for name in ("x", "y"):
            ours = real(precise(derivative(expression.node, table.variable(name)), point))
            theirs = difference(expression, point, name)
            if ours is not None and theirs is not None and abs(ours) < 1e5:
                assert close(ours, theirs, 1e-9), (expression.sympy, name)


def difference(expression, point, name):
    step = mpmath.mpf(10) ** -12
    exact = {key: mpmath.mpf(x) for key, x in point.items()}
    ends = [plainly(expression, {**exact, name: exact[name] + d}) for d in (step, -step)]
    return None if None in ends else (ends[0] - ends[1]) / (2 * step)


@pytest.mark.parametrize("batch", BATCHES)
def test_hessian_is_symmetric_and_differentiates_the_gradient(batch):
    for expression, point, _ in references(batch, 25, 3, SMOOTH):
        second = hessian(expression.node)
        for (a, b), node in second.items():
            ours, mirrored = (real(precise(n, point)) for n in (node, second.get((b, a), node.table.zero)))
            if ours is not None and abs(ours) < 1e8:
                assert close(ours, mirrored)
                assert derivative(gradient(expression.node)[a], b) is node


def test_gradient_leaves_out_what_does_not_matter():
    table = new_table()
    x, y, m = table.variable("x"), table.variable("y"), table.parameter("m")
    assert set(gradient(m * x + m)) == {x}
    assert gradient(m) == {}
    assert derivative(m * x, y).is_zero
    assert not (m * m).mask and (m * x).mask


# normal forms

@pytest.mark.parametrize("batch", BATCHES)
@pytest.mark.parametrize("functions", [SMOOTH, MECHANICAL], ids=["smooth", "sine"])
def test_textbook_form_keeps_the_value(batch, functions):
    for expression, point, value in references(batch, 40, 4, functions):
        assert close(precise(textbook(expression.node), point), value), expression.node


@pytest.mark.parametrize("batch", BATCHES)
def test_textbook_form_of_products_of_sines(batch):
    """Sums of products of sines and cosines of sums: where the addition theorems act."""
    generator = random.Random(f"sines {batch}")
    for _ in range(40):
        table = new_table()
        x, y = table.variable("x"), table.variable("y")
        angles = [x, y, x - y, x + y, 2 * x, x - table.pi / 6, y + table.parameter("m")]
        node = table.zero
        for _ in range(generator.randint(2, 6)):
            term = table.number(generator.choice((-2, -1, -1, 1, 1, 2)))
            for _ in range(generator.randint(1, 3)):
                call = table.call(generator.choice(MECHANICAL), generator.choice(angles))
                term = term * call ** generator.choice((1, 1, 2, 3))
            node = node + term * generator.choice((table.one, table.parameter("k")))
        point = values(generator)
        assert close(precise(textbook(node), point), precise(node, point)), node
        assert not is_zero(node) or abs(precise(node, point)) < 1e-30


@pytest.mark.parametrize("batch", BATCHES)
def test_zero_is_never_claimed_wrongly(batch):
    for expression, point, value in references(batch, 60, 4):
        for node, size in ((expression.node, value), (expression.node - 1, value - 1),
                           (expression.node - expression.node * Fraction(10**6 + 1, 10**6), value / 10**6)):
            if is_zero(node):
                assert abs(size) < 1e-25
                assert abs(precise(node, point)) < 1e-25


@pytest.mark.parametrize("batch", BATCHES)
def test_zero_is_found_where_expansion_shows_it(batch):
    generator = random.Random(f"zeros {batch}")
    for _ in range(20):
        table = new_table()
        a, b, c = (polynomial(table, generator) for _ in range(3))
        assert is_zero((a + b) ** 2 - a * a - 2 * a * b - b * b)
        assert is_zero(a * (b - c) - a * b + a * c)


def polynomial(table, generator):
    """A random polynomial of symbols, sines and cosines."""
    atoms = [node_of(table, name) for name in NAMES]
    atoms += [table.call(generator.choice(MECHANICAL), generator.choice(atoms[:2]) * generator.choice((1, 2)))
              for _ in range(2)]
    total = table.number(generator.choice((0, 1, Fraction(-1, 2))))
    for _ in range(generator.randint(1, 3)):
        total = total + generator.choice(atoms) * generator.choice(atoms) * generator.choice((1, -3, Fraction(2, 3)))
    return total


ROOTS = {"a number": "2", "a parameter": "m", "a sum": "m + k", "a quotient": "m/k", "a square": "x^2", "a sum of "
                                                            "squares":
         "x^2 + y^2"}


@pytest.mark.parametrize("inner", ROOTS.values(), ids=ROOTS.keys())
def test_roots_multiply_to_what_stands_under_them(inner):
    table = new_table()
    x, u = table.variable("x"), read(table, inner)
    root = table.sqrt(u)
    assert is_zero((x + root) * (x - root) - x * x + u)
    assert is_zero((x + root) ** 2 - x * x - 2 * x * root - u)


def test_equal_roots_of_numbers_cancel():
    table = Table()
    assert is_zero(table.sqrt(table.number(8)) - 2 * table.sqrt(table.number(2)))
    assert is_zero(table.call("sin", table.pi / 3) - table.sqrt(table.number(3)) / 2)
    assert is_zero(table.number(2) ** Fraction(-1, 2) - table.sqrt(table.number(2)) / 2)


def read(table, text):
    return lower(parse(text), table, lambda name, primes, _: node_of(table, name + "'" * primes))


def test_identities_that_are_shown():
    table = new_table()
    x, y = table.variable("x"), table.variable("y")
    sin, cos = (lambda u: table.call("sin", u)), (lambda u: table.call("cos", u))
    assert is_zero(sin(x) ** 2 + cos(x) ** 2 - 1)
    assert is_zero(3 * cos(x)**4 + 6 * cos(x)**2 * sin(x)**2 + 3 * sin(x)**4 - 3)
    assert not is_zero(cos(x)**4 + cos(x)**2 * sin(x)**2 + sin(x)**4 - 1)
    assert is_zero(cos(x) * cos(y) + sin(x) * sin(y) - cos(x - y))
    assert is_zero(sin(x) * cos(y) + cos(x) * sin(y) - sin(x + y))
    assert is_zero(cos(x) * cos(y) - sin(x) * sin(y) - cos(x + y))
    assert is_zero(sin(x) * cos(y) - cos(x) * sin(y) - sin(x - y))
    assert not is_zero(sin(x) ** 2 - cos(x) ** 2)
    assert not is_zero(sin(x) * cos(y) + cos(x) * sin(y) - sin(x - y))


def test_expansion_is_bounded():
    table = Table()
    names = [table.parameter(f"p{i}") for i in range(40)]
    long = table.one
    for start in range(0, 40, 4):
        long = long * (names[start] + names[start + 1] + names[start + 2] + names[start + 3])
    assert textbook(long) is long
    assert not is_zero(long)
    with pytest.raises(ArithmeticError):
        expanded(long)


# notation and parsing

@pytest.mark.parametrize("batch", BATCHES)
def test_language_is_read_back(batch):
    for expression, point, value in references(batch, 80, 4):
        text = language(expression.node)
        if len(text) < 1500:
            back = parse(text)
            assert close(mpmath.mpf(number(back, point_of(point), mpmath)), value), text
            assert close(precise(read(expression.node.table, text), point), value), text


def point_of(point):
    return {name: mpmath.mpf(value) for name, value in point.items()}


def test_functions_of_numbers_too_long_to_multiply_out():
    table = Table()
    for name, sign in (("sin", -1), ("cos", 1), ("abs", 1), ("tan", -1)):
        tiny = table.number(Fraction(-8.361089130433666e-199))
        value, opposite = evaluate([table.call(name, tiny), table.call(name, -tiny)], Floats, {})
        assert value == pytest.approx(sign * opposite, abs=0)


@pytest.mark.parametrize("seed", range(20))
def test_the_root_of_a_square_that_is_multiplied_out_has_no_root(seed):
    """Of scale · (sum of letters)², and of that times a product²; a sum that is no square stays under its root."""
    generator, table = random.Random(seed), new_table()
    m, k, x, y = (symbol(table, name) for name in ("m", "k", "x", "y"))
    parts = [table.scaled(part, Fraction(generator.randint(1, 6))) for part in generator.sample((m, k, x, y), 3)]
    base = sum(parts[1:], parts[0])
    point = {"m": 1.3, "k": 0.7, "x": 0.9, "y": 0.4, "x'": 1.0}
    for factor, size in ((table.one, 1), (table.number(Fraction(9, 4)), 1.5), (m * m, 1.3), (k * k * x * x, 0.63)):
        square = table.sum(*((factor * a * b, 1) for a in parts for b in parts))
        found, value = root(square, [point]), evaluate([base], Floats, point)[0]
        assert evaluate([found], Floats, point)[0] == pytest.approx(size * value, rel=1e-12)
        assert all(e.denominator == 1 for part in reachable([found]) if part.op == "product" for _, e in part.args)
        under = root(table.sum(*((factor * a, 1) for a in parts)), [point])
        assert evaluate([under], Floats, point)[0] == pytest.approx(size * value**0.5, rel=1e-12)


def test_what_is_divided_by_a_long_fraction_is_read_back():
    table = Table()
    long = Fraction(7**70, 3**150)
    text = language(table.parameter("x") / table.number(long))
    assert number(parse(text), {"x": 1.0}) == pytest.approx(float(1 / long), rel=1e-12)


def test_roots_of_squares_have_the_sign_of_all_angles():
    """√(sin² b) is |sin b| where b is free, ±sin b where it is given; a length minus a length has the sign it has."""
    table = Table()
    b, R, r = (table.parameter(name) for name in ("b", "R", "r"))
    free = [{"b": x, "R": 2 + x, "r": x} for x in (0.4, 0.7, 1.1)]
    sine = table.call("sin", b)
    assert root(sine * sine * R, free) is table.call("abs", sine) * table.sqrt(R)
    assert root(sine * sine * R, [{"b": 4.0, "R": 1.0}]) is -sine * table.sqrt(R)
    assert root((R - r) ** 2, free) is R - r
    assert root((r - R) ** 2 * sine**4, free) is (R - r) * sine**2
    assert root((2 + sine) ** 2, free) is 2 + sine
    assert table.call("sign", R) is table.one and table.call("sign", -R) is -table.one


def test_bars_of_what_has_one_sign_are_left_out():
    table = Table()
    b, L = table.parameter("b"), table.parameter("L")
    u = L - table.call("sin", b)
    node = b / table.sqrt(u * u) + table.call("abs", -u)
    values = {"b": 0.3, "L": 2.0}
    assert without_bars(node, [values]) is b / u + u
    values["L"] = 0.1
    assert without_bars(node, [values]) is -b / u - u


def test_roots_of_squares_of_letters_of_any_sign_keep_their_bars():
    """Where these are positive at all samples, too; of those with a number it has its sign."""
    table = Table()
    a, b = table.parameter("a", False), table.parameter("b")
    node = table.sqrt((a * b) ** 2)
    assert without_bars(node, [{"a": 1.0, "b": 2.0}, {"a": 2.0, "b": 1.0}]) is table.call("abs", a * b)
    assert without_bars(node, [{"a": -1.0, "b": 2.0}]) is -(a * b)


@pytest.mark.parametrize(("text", "short"), [
    ("(x*R*m*g*(R + r)/2 + r^2*m*g/2*x - R^2*m*g/2*x)/(R + r)", "x*m*g*r/2"),
    ("k*x - g*(r^2*m + r^2*k - R^2*m - R^2*k)*x/(2*(R + r))", "k*x - g*(r*m + r*k - R*m - R*k)*x/2"),
    ("x*(R*(R + r)/2 + r*(R + r) - 3*R^2/8 - 5*R*r/4 - r^2)*m + x'/(R + r)", "x*m*R*(R/8 + r/4) + x'/(R + r)"),
    ("x*m/(R + r) + x'*k/(R + r)", "x*m/(R + r) + x'*k/(R + r)")])
def test_sums_of_parameters_below_a_line_cancel(text, short):
    """Where they go into what stands above, and leave no brackets in other terms."""
    table = Table()
    names = {name: table.parameter(name) for name in "mgkRr"} | {"x": table.variable("x"), "x'": table.variable("x'")}

    def node(typed):
        return lower(parse(typed), table, lambda name, primes, _: names[name + "'" * primes])

    assert plain(textbook(node(text))) == plain(textbook(node(short)))
    assert plain(textbook(node(text))).count("(") <= short.count("(")
