"""Zeros by looking, several unknowns by Newton steps, equations in letters."""

import math
from fractions import Fraction
from itertools import islice
from types import SimpleNamespace

import pytest

from vibcli.notation.scene_language import language
from vibcli.numerics.halton import halton
from vibcli.numerics.newton_systems import common_zeros
from vibcli.numerics.root_finding import holds_everywhere, longest_plateau, zeros
from vibcli.symbolic.equations.elimination import solve_equations
from vibcli.symbolic.equations.trigonometric import _linear, angles
from vibcli.symbolic.equations.univariate import polynomial, solve_equation
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.normal_form import expanded

DECADES = [10.0 ** (i / 6) for i in range(-24, 25)]
EVEN = [i / 20 for i in range(-60, 61)]


def bounded_ratio(left, right):
    """(L − R)/(|L| + |R|) of two functions, None where one is not defined."""
    def function(x):
        try:
            a, b = left(x), right(x)
        except (ValueError, ZeroDivisionError):
            return None
        return (a - b) / (abs(a) + abs(b)) if a or b else 0.0
    return function


CASES = [
    (lambda x: x**2, lambda x: 2, DECADES, [math.sqrt(2)]),
    (lambda x: (x - 3) * (x - 3.01) + 5, lambda x: 5, DECADES, [3, 3.01]),
    (lambda x: (x - 3) ** 2 + 5, lambda x: 5, DECADES, [3]),
    (lambda x: (x - 3) ** 2 + 5.001, lambda x: 5, DECADES, []),
    (lambda x: 1 / (x - 3), lambda x: 0.25, DECADES, [7]),
    (lambda x: 1 / (x - 3), lambda x: -1, DECADES, [2]),
    (lambda x: 1 / (x - 3) ** 3, lambda x: -1, DECADES, [2]),
    (lambda x: 1 if x < 2.5 else 3, lambda x: 2, DECADES, []),
    (lambda x: math.sqrt(5 - x) + 1, lambda x: 1.01, DECADES, [5 - 1e-4]),
    (lambda x: math.sqrt(x - 5) + 1, lambda x: 1.5, DECADES, [5.25]),
    (lambda x: x / (1 + x), lambda x: 1, DECADES, []),
    (lambda x: math.exp(-x) + 2, lambda x: 2, DECADES, []),
    (lambda x: math.sin(3 * x) + 2, lambda x: 2.5, EVEN, [
        root for k in range(-2, 2) for root in ((math.asin(0.5) + 2 * math.pi * k) / 3,
                                                (math.pi - math.asin(0.5) + 2 * math.pi * k) / 3) if -3 <= root <= 3]),
    (lambda x: x**3 - x + 1, lambda x: 1, EVEN, [-1, 0, 1]),
]


@pytest.mark.parametrize(("left", "right", "grid", "expected"), CASES, ids=range(len(CASES)))
def test_zeros(left, right, grid, expected):
    found, _ = zeros(bounded_ratio(left, right), grid, (False, False))
    assert found == pytest.approx(sorted(expected), rel=2e-5, abs=1e-12)


def test_simple_zeros_are_sharp():
    for power in (1, 2, 5, -3):
        found, scan = zeros(bounded_ratio(lambda x, p=power: x**p, lambda x, p=power: 7.7**p), DECADES)
        assert found == pytest.approx([7.7], rel=4e-16) and len(scan.points) < 160


@pytest.mark.parametrize("place", [-1.7321, 0.0137, 2.2])
@pytest.mark.parametrize("bend", [0.02, 0.1])
def test_what_touches_zero_but_for_its_rounding_is_a_zero(place, bend):
    for gap, count in ((0.0, 1), (1e-13, 1), (3e-10, 1), (1e-8, 0), (1e-5, 0)):
        found, _ = zeros(lambda x, gap=gap: gap + bend * (x - place) ** 2, EVEN)
        assert len(found) == count and all(abs(x - place) < 1e-6 for x in found), gap


@pytest.mark.parametrize("place", [-1.7321, 0.0137, 2.2, 0.0])
def test_a_change_of_sign_is_a_zero_but_for_a_jump(place):
    """What rounding leaves of sums, some 10⁻⁹ of their terms, is no jump."""
    for step, count in ((0.0, 1), (1e-12, 1), (2e-9, 1), (1e-7, 0), (1e-3, 0)):
        found, _ = zeros(lambda x, step=step: math.copysign(step, x - place) + 0.02 * (x - place), EVEN)
        assert len(found) == count and all(abs(x - place) < 1e-6 for x in found), step


@pytest.mark.parametrize("grid", [DECADES, EVEN])
@pytest.mark.parametrize("place", [0.37, 1.7321, 2.72])
def test_a_simple_pole_is_told_at_few_places(place, grid):
    def function(x):
        return None if x == place else (x - place) / (abs(x - place) + (x - place) ** 2)

    found, scan = zeros(function, grid)
    assert found == [] and sum(abs(x - place) < 5e-3 for x in scan.points) < 10


@pytest.mark.parametrize("width", [1e-2, 1e-3, 1e-4])
def test_between_heights_that_look_like_those_of_a_pole_there_may_be_a_zero(width):
    """d/(d² + w²) of d = x − p, as the real part of a lightly damped response: it turns to zero within w of p."""
    for place in (0.37, 1.7321, 2.72, -1.3):
        found, _ = zeros(lambda x, p=place: (d := x - p) / (abs(d) + (d * d + width**2) / (1e7 * width**2)), EVEN)
        assert found == [pytest.approx(place, rel=1e-12)]


@pytest.mark.parametrize("slope", [1e8, -1e8, 1e10, -1e10])
@pytest.mark.parametrize("place", [1.7321, -1.3])
def test_a_steep_zero_is_found_whichever_way_it_is_passed(place, slope):
    found, _ = zeros(lambda x: (d := slope * (x - place)) / (abs(d) + 1), EVEN)
    assert found == [pytest.approx(place, rel=1e-12)]


def test_an_end_counts_where_the_range_holds_it():
    grid = [1 + i / 10 for i in range(11)]
    function = bounded_ratio(lambda x: x, lambda x: 2)
    assert zeros(function, grid, (True, True))[0] == [2.0]
    assert zeros(function, grid, (True, False))[0] == []


def test_what_holds_everywhere_or_on_a_stretch():
    _, scan = zeros(lambda x: 0.0, DECADES)
    assert holds_everywhere(scan)
    _, scan = zeros(bounded_ratio(lambda x: max(x, 2.0), lambda x: 2), DECADES)
    low, high = longest_plateau(scan)
    assert low == DECADES[0] and 1 < high <= 2 and not holds_everywhere(scan)
    assert longest_plateau(zeros(bounded_ratio(lambda x: x, lambda x: 2), DECADES)[1]) is None


# several unknowns


def test_halton_points_are_spread_and_the_same():
    points = list(islice(halton(2), 200))
    assert points == list(islice(halton(2), 200)) and points[0] == [1 / 2, 1 / 3]
    for i in range(4):
        for j in range(4):
            assert any(i <= 4 * x < i + 1 and j <= 4 * y < j + 1 for x, y in points)


def test_common_zeros():
    """x y = 6 and x + y = 5, in logarithms: (2, 3) and (3, 2)."""
    def function(u):
        x, y = map(math.exp, u)
        return [math.log(x * y / 6), math.log((x + y) / 5)]

    found = common_zeros(function, lambda point: [6 * p - 3 for p in point], 2)
    assert sorted([round(math.exp(x), 9) for x in u] for u in found) == [[2, 3], [3, 2]]


def test_no_common_zero():
    def function(u):
        x, y = map(math.exp, u)
        return [math.log(x * y / 6), math.log((x + y) / 4)]

    assert common_zeros(function, lambda point: [6 * p - 3 for p in point], 2) == []


def test_more_conditions_than_unknowns():
    def function(u):
        return [u[0] - 1, u[1] + 2, u[0] + u[1] + 1]

    assert common_zeros(function, lambda point: point, 2) == [pytest.approx([1, -2])]


def test_a_place_that_is_not_defined_is_no_start():
    assert common_zeros(lambda u: [u[0] - 0.9, u[1]] if u[0] > 0.7 else None, lambda p: p, 2) == [
        pytest.approx([0.9, 0])]


# letters


@pytest.fixture
def letters():
    """A table with parameters a, b, c, x, y, positive all but z, and what solvers ask of a scene."""
    table = Table()
    nodes = {name: table.parameter(name, name != "z") for name in "abcxyz"}
    sample = dict(zip("abcxyz", (1.3, 0.7, 2.1, 0.9, 1.7, 1.1), strict=True))
    table.sample = sample
    scene = SimpleNamespace(table=table, sample=sample, parameters=SimpleNamespace(nodes=nodes))
    return SimpleNamespace(scene=scene, **nodes, sqrt=table.sqrt, call=table.call)


def solved(node, x, scene, thorough=False):
    found = solve_equation(node, x, scene, thorough)
    return found and ([language(node) for node, in found.tuples], found.complete)


def test_equations_of_one_unknown(letters):
    a, b, c, x = letters.a, letters.b, letters.c, letters.x
    assert solved(a * x - b, x, letters.scene) == (["b/a"], True)
    assert solved(a / (x + b) - c, x, letters.scene) == (["(a - b*c)/c"], True)
    assert solved(letters.sqrt(a * x) - b, x, letters.scene) == (["b^2/a"], True)
    assert solved(letters.sqrt(x + a) - b, x, letters.scene)[0] == ["b^2 - a"]
    assert solved(x ** 4 - a, x, letters.scene) == (["sqrt(sqrt(a))"], True)
    assert solved(letters.z ** 2 - a * a, letters.z, letters.scene) == (["-a", "a"], True)
    assert len(solved(x * x - (a + b) * x + a * b, x, letters.scene)[0]) == 2
    assert solve_equation(x - x + a - a, x, letters.scene).always


def test_every_candidate_solves_its_equation(letters):
    a, b, c, x = letters.a, letters.b, letters.c, letters.x
    swept = 0
    for node in (a * x * x - (2 * a + 3 * b + c) * x + b, 1 / (x + a) + 1 / (x + b) - 1 / c,
                 x / letters.sqrt(x * x + a) - b, (x - a) * (x - 2 * b),
                 letters.call("sin", x) * a - letters.call("cos", x) * b,
                 a * letters.call("sin", x) + b * letters.call("cos", x) - c / 3):
        found = solve_equation(node, x, letters.scene)
        misfits = []
        for root, in found.tuples:
            value, = evaluate([root], Floats, letters.scene.sample)
            misfits.append(abs(evaluate([node], Floats, {**letters.scene.sample, "x": value})[0]))
            swept += misfits[-1] < 1e-9
        assert misfits and min(misfits) < 1e-9
    assert swept >= 9


@pytest.mark.parametrize("a", [0, 2, -3])
@pytest.mark.parametrize("b", [0, 1, -4])
@pytest.mark.parametrize("c", [0, "0.3", "-0.8"])
def test_angles_from_minus_half_a_turn_to_a_turn(a, b, c):
    """a sin x + b cos x + c (|a| + |b|) = 0: all of them, and nothing else."""
    if not (a or b):
        return
    table, c = Table(), Fraction(c) * (abs(a) + abs(b)) / 2
    found = evaluate(_linear(*(table.number(value) for value in (a, b, c))), Floats, {})
    middle, half = math.atan2(a, b), math.acos(-c / math.hypot(a, b))
    wanted = [x for i in range(-3, 4) for x in (middle + half + 2 * math.pi * i, middle - half + 2 * math.pi * i)
              if -math.pi - 1e-9 <= x < 2 * math.pi - 1e-9]
    assert all(any(abs(x - y) < 1e-12 for y in found) for x in wanted) and len(wanted) >= 2
    assert all(abs(a * math.sin(x) + b * math.cos(x) + c) < 1e-12 for x in found)


@pytest.mark.parametrize(("i", "j"), [(1, 0), (0, 1), (2, 1), (1, 1), (0, 3)])
@pytest.mark.parametrize("rest", [(0, 0, 1), (2, 0, 0), (2, -3, 0), (0, 4, 1), (3, 0, -2)])
def test_angles_where_sines_and_cosines_are_common_factors(i, j, rest):
    """sinⁱ x cosʲ x (a sin x + b cos x + c) = 0: all of them."""
    table = Table()
    x = table.variable("x")
    sine, cosine = table.call("sin", x), table.call("cos", x)
    node = sine**i * cosine**j * (rest[0] * sine + rest[1] * cosine + rest[2])
    found = evaluate(angles(expanded(node), x, lambda part: part.is_zero), Floats, {})
    grid = [-math.pi + 3 * math.pi * k / 64 for k in range(64)]
    wanted = [k * math.pi for k in (-1, 0, 1)] * bool(i) + [(k - 0.5) * math.pi for k in (0, 1, 2)] * bool(j)
    wanted += [x for x in zeros(lambda x: evaluate([node], Floats, {"x": x})[0] / 10, grid)[0] if x < 6.28]
    assert all(any(abs(x - y) < 1e-3 for y in found) for x in wanted)
    assert all(abs(evaluate([node], Floats, {"x": y})[0]) < 1e-12 for y in found)


def test_higher_degrees_are_factored_by_sympy_alone(letters):
    a, b, x = letters.a, letters.b, letters.x
    node = (x - a) * (x * x - b) * (x - 3 * b)
    assert solve_equation(node, x, letters.scene) is None
    found, complete = solved(node, x, letters.scene, thorough=True)
    assert {"a", "3*b", "sqrt(b)"} <= set(found) and complete


def test_what_has_no_polynomial(letters):
    assert polynomial(letters.call("exp", letters.x) - letters.a, letters.x) is None
    assert solve_equation(letters.call("exp", letters.x) - letters.a, letters.x, letters.scene) is None
    assert solved(letters.call("exp", letters.x) - letters.a, letters.x, letters.scene, True) == (["log(a)"], False)


def test_two_unknowns(letters):
    a, b, x, y = letters.a, letters.b, letters.x, letters.y
    found = solve_equations([x + y - a - b, x * y - a * b], [x, y], letters.scene)
    pairs = [tuple(round(v, 12) for v in evaluate(pair, Floats, letters.scene.sample)) for pair in found.tuples]
    assert sorted(pairs) == [(0.7, 1.3), (1.3, 0.7)] and found.complete
    linear = solve_equations([a * x + b * y - 1, x - y], [x, y], letters.scene)
    assert [[language(node) for node in pair] for pair in linear.tuples] == [["1/(a + b)", "1/(a + b)"]]


@pytest.mark.parametrize("one", range(6))
@pytest.mark.parametrize("other", range(6))
def test_two_equations_keep_the_solution_they_were_made_of(letters, one, other):
    """f(x, y) = f(a, b) of both: (a, b) is among what is found."""
    a, b, x, y = letters.a, letters.b, letters.x, letters.y
    forms = (lambda u, v: u + v, lambda u, v: u * v, lambda u, v: u * u + v, lambda u, v: u * u + u + v * v + 3 * v,
             lambda u, v: u * u + u * v, lambda u, v: v * v - 2 * v + u * u)
    nodes = [forms[k](x, y) - forms[k](a, b) for k in (one, other)]
    found = solve_equations(nodes, [x, y], letters.scene)
    if one != other and found is not None:
        values = [evaluate(pair, Floats, letters.scene.sample) for pair in found.tuples]
        assert any(pair == pytest.approx([1.3, 0.7]) for pair in values)


def test_places_beside_a_zero_are_no_plateau():
    grid = [-1.0, -1e-13, 0.0, 1e-13, 1.0]
    found, scan = zeros(lambda x: x / (1 + abs(x)), grid)
    assert found == [0.0] and longest_plateau(scan) is None
    flat = zeros(lambda x: 0.0 if abs(x) < 1e-12 else x / (1 + abs(x)) - 1e-3, grid)[1]
    assert longest_plateau(flat) == (-1e-13, 1e-13)
