"""V and T expanded about the equilibrium, against SymPy's derivatives of energies that are written out here."""

import random
from math import cos, factorial, hypot, pi, sin

import pytest
import sympy
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError, SpecError

PRODUCTS = ((1, 0), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (0, 3), (4, 0), (3, 1), (2, 2), (1, 3), (0, 4))


def named(powers, names="xy"):
    return "*".join(f"{name}^{n}" for name, n in zip(names, powers, strict=True) if n)


def spring_between(rng, far, angle):
    """(text of a random spring but for its ends, its energy as a function of the length)."""
    drawn, k = far, rng.uniform(50, 500)
    kind = rng.choice(("plain", "preload", "free_length", "law", "none"))
    N, free, cubic = rng.uniform(-10, 30), rng.uniform(0.5, 1.1) * drawn, rng.uniform(10, 900)
    return {
        "plain": (f"k: {k} N/m", lambda length: k * (length - drawn)**2 / 2),
        "preload": (f"k: {k} N/m, preload: {N} N", lambda length: N * length + k * (length - drawn)**2 / 2),
        "free_length": (f"k: {k} N/m, free_length: {free} m", lambda length: k * (length - free)**2 / 2),
        "law": (f"law: '{k} N/m*d + {cubic} N/m^3*d^3'",
                lambda length: k * (length - drawn)**2 / 2 + cubic * (length - drawn)**4 / 4),
        "none": (f"k: {k} N/m, free_length: 0 m", lambda length: k * length**2 / 2)}[kind]


def random_scene(seed):
    """(text, V, symbols) of a particle on springs of all kinds under a load."""
    rng = random.Random(seed)
    x, y = sympy.symbols("x y", real=True)
    V, springs = sympy.Integer(0), []
    for i in range(rng.randint(2, 5)):
        angle, far = rng.uniform(-pi, pi), rng.uniform(0.5, 2)
        ax, ay = (round(part, 3) for part in (far * cos(angle), far * sin(angle)))
        text, energy = spring_between(rng, hypot(ax, ay), angle)
        springs.append(f"  s{i}: {{{text}, between: [[{ax} m, {ay} m], p]}}\n")
        V += energy(sympy.sqrt((x - ax)**2 + (y - ay)**2))
    F = [rng.uniform(-20, 20) for _ in "xy"]
    text = ("bodies: {p: {mass: 1 kg, at: [0 m, 0 m], move: [x, y, 0]}}\nsprings:\n" + "".join(springs)
            + f"forces: {{F: {{at: p, force: ['{F[0]} N', '{F[1]} N']}}}}\n")
    return text, V, (x, y)


def wanted(V, symbols, place, powers):
    found = sympy.lambdify(symbols, sympy.diff(V, *(pair for pair in zip(symbols, powers, strict=True) if pair[1])),
                           "math")(*place)
    return found / (factorial(powers[0]) * factorial(powers[1]))


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(1))
def test_coefficients_are_derivatives_of_the_energy(seed):
    text, V, symbols = random_scene(seed)
    scene = problem(text)
    place = [value(scene, f"equilibrium[{name}]") for name in "xy"]
    for powers in PRODUCTS[seed::3]:
        assert value(scene, f"V[{named(powers)}]") == pytest.approx(wanted(V, symbols, place, powers), rel=1e-9,
                                                                    abs=1e-9)




def test_inertia_that_depends_on_the_place_is_expanded():
    scene = problem("""
        parameters: {m: 2 kg, a: 3 m^-1, k: 50 N/m}
        coordinates: {x: m}
        energies: {T: "m/2*(1 + 4*a^2*x^2)*x'^2", V: "k*x^2/2 + k*a*x^3*cos(a*x)"}
        """)
    assert value(scene, "T[x'^2]") == 1
    assert value(scene, "T[x^2*x'^2]") == pytest.approx(36, rel=1e-15)
    assert value(scene, "T[x*x'^2]") == 0
    assert value(scene, "V[x^3]") == pytest.approx(150, rel=1e-14)
    assert value(scene, "V[x^5]") == pytest.approx(-150 * 4.5, rel=1e-14)


def test_what_has_a_kink_is_refused_by_name():
    scene = problem("""
        bodies: {p: {mass: 1 kg, at: [0 m, 0 m], slide: x}}
        springs:
          stop: {law: "300 N/m*max(d, 0 m)", between: [[-1 m, 0 m], p]}
          s: {k: 20 N/m, between: [[-1 m, 0 m], p]}
        """)
    with pytest.raises(PhysicsError, match="'stop' has a kink of max in the equilibrium at x = 0"):
        value(scene, "V[x^4]")


@pytest.mark.parametrize("product", ["y", "x'", "x^9", "x^0.5", "x + 1", "2*x", "1/x"])
def test_what_is_no_product_of_coordinates_is_refused(product):
    with pytest.raises(SpecError, match=r"expected a product of order 1 to 8 of coordinates in square brackets"):
        problem("bodies: {p: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 20 N/m, between: [ground, p]}}\n"
                f'answers: {{"V[{product}]": 1}}')
