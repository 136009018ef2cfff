"""Energies and equations expanded about the equilibrium, against SymPy's own series of Lagrange's equations."""

import json

import pytest
import sympy
from support.scenes import problem, value
from support.truncated_series import FIELD, Taylor

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.notation.scene_language import language
from vibcli.quantities.quantity import declared
from vibcli.results.expansions import expansions
from vibcli.symbolic.parser import parse

PENDULUM_ON_CART = """
parameters: {M: 3 kg, m: 1 kg, L: 0.5 m, g: 9.81 m/s^2, k: 80 N/m}
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], move: [x, 0, 0]}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, free_length: 1 m, between: [[-1 m, 0], cart]}}
find: [expansion]
"""


def by_sympy(order):
    """{coordinate: {powers of x, phi, x', phi', x'', phi'': factor}} of the pendulum on a cart."""
    M, m, L, g, k = 3, 1, 0.5, 9.81, 80
    x, phi, v, w, a, b, e = sympy.symbols("x phi v w a b e")
    T = M * v**2 / 2 + m * (v**2 + 2 * L * v * w * sympy.cos(phi) + L**2 * w**2) / 2
    V = k * x**2 / 2 - m * g * L * sympy.cos(phi)
    found = {}
    for name, q, rate in (("x", x, v), ("phi", phi, w)):
        p = sympy.diff(T, rate)
        full = sum(sympy.diff(p, s) * r for s, r in ((x, v), (phi, w), (v, a), (w, b))) - sympy.diff(T - V, q)
        scaled = sympy.series(full.subs({s: e * s for s in (x, phi, v, w, a, b)}, simultaneous=True), e, 0,
                              order + 1).removeO()
        found[name] = {powers: float(c) for powers, c in sympy.Poly(
            scaled.subs(e, 1), x, phi, v, w, a, b).terms()}
    return found


@pytest.mark.sweep
def test_equations_of_a_pendulum_on_a_cart_are_those_of_sympy():
    *_, numbers = expansions(problem(PENDULUM_ON_CART), 6)
    for name, found in zip(("x", "phi"), numbers.equations, strict=True):
        expected = by_sympy(5)[name]
        assert found.keys() == expected.keys()
        assert all(found[powers] == pytest.approx(c, rel=1e-12) for powers, c in expected.items())


def test_loads_that_work_along_a_curve_stand_in_the_equations():
    """A bob under its weight and a steady force F across: V = −R L cos ξ with R² = (mg)² + F² about its rest."""
    *_, found = expansions(problem(
        "parameters: {m: 2 kg, L: 0.3 m, g: 9.81 m/s^2, F: 3 N}\ngravity: g\n"
        "bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}\n"
        "forces: {f: {at: bob, force: [F, 0]}}\nfind: [expansion]\n"), 4)
    R = 0.3 * ((2 * 9.81)**2 + 9)**0.5
    equation, = found.equations
    assert equation == {(0, 0, 1): pytest.approx(0.18, rel=1e-13), (1, 0, 0): pytest.approx(R, rel=1e-13),
                        (3, 0, 0): pytest.approx(-R / 6, rel=1e-13)}


def test_a_taut_spring_square_to_the_motion_in_letters(capsys, tmp_path):
    """Kovacić & Radomirović 2018, 9.5: N/l is added to the linear and (k − N/l)/(2 l²) to the cubic factor."""
    text = ("parameters: {m: , k: , N: , L: }\nbodies: {slider: {mass: m, at: [0, 0], move: [x, 0, 0]}}\n"
            "springs: {s: {k: k, preload: N, between: [[0, L], slider]}}\nfind: [expansion]\n")
    found, = expansions(problem(text), 4)
    k, N, L = sympy.symbols("k N L")
    values = {powers: sympy.sympify(language(node).replace("^", "**"), locals={"N": N})
              for powers, node in found.equations[0].items()}
    assert sympy.simplify(values[1, 0, 0] - N / L) == 0
    assert sympy.simplify(values[3, 0, 0] - (k - N / L) / (2 * L**2)) == 0
    file = tmp_path / "scene.yaml"
    file.write_text(text, encoding="utf-8")
    assert run(["solve", "--json", str(file)]) == 0
    data = json.loads(capsys.readouterr().out)["expansion"]
    assert data["order"] == 4 and [one["product"] for one in data["V"]] == ["x^2", "x^4"]
    assert run(["solve", str(file)]) == 0
    out = capsys.readouterr().out
    assert "s:  x²/(2·L)" in out and "Kinetic energy, to order 4" in out


OBLIQUE = """
parameters: {m: 2 kg, k: 300 N/m, b: 400 N/m^2, c: 900 N/m^3, N: 9 N, g: 9.81 m/s^2}
gravity: g
bodies: {p: {mass: m, at: [0, 0], move: [x, y, 0]}}
springs:
  s: {law: "k*d + b*d^2 + c*d^3", between: [[-0.4 m, 0.3 m], p]}
  t: {k: k, preload: N, between: [[0.5 m, 0.2 m], p]}
  u: {k: 2*k, free_length: 0 m, between: [[0.1 m, -0.3 m], p]}
"""


def shares_by_sympy(rest):
    """{spring: ({powers: coefficient} of the material, of the geometry)} of the scene above by SymPy's series."""
    taylor, third = Taylor("xy", 4), FIELD(1) / 3
    energies = {"s": [0, 0, 150, 400 * third, 225], "t": [0, 9, 150, 0, 0], "u": [0, 0, 300, 0, 0]}
    ends = {"s": ("-0.4", "0.3", "0.5"), "t": ("0.5", "0.2", FIELD(0.29)**FIELD(0.5)), "u": ("0.1", "-0.3", 0)}
    found = {}
    for name, numbers in ends.items():
        px, py, free = (FIELD(sympy.Float(one, 50)) for one in numbers)
        dx, dy = (taylor.moving(i) + FIELD(rest[i]) - p for i, p in enumerate((px, py)))
        d = taylor.root(dx**2 + dy**2) - free
        material, whole = (taylor.composed(energies[name], each) for each in (taylor.first(d), d))
        found[name] = taylor.terms(material, 1e-12), taylor.terms(whole - material, 1e-12)
    return found


def test_what_springs_store_by_their_material_and_by_their_geometry_is_told_apart():
    scene = problem(OBLIQUE)
    *_, found = expansions(scene, 4)
    expected = shares_by_sympy([scene.configuration.equilibrium.values[name] for name in "xy"])
    for name, parts in expected.items():
        for shares, terms in zip(found.springs[name], parts, strict=True):
            assert shares == {powers: pytest.approx(c, rel=1e-10) for powers, c in terms.items()}
        for product, powers in (("y", (0, 2)), ("x*y^2", (2, 2))):
            assert value(scene, f"stiffness_correction[{name}, {product}]") == pytest.approx(
                2 * parts[1].get(powers, 0.0), rel=1e-10, abs=1e-9)


@pytest.mark.sweep
def test_shares_of_springs_are_data_and_a_refusal_tells_why(capsys, tmp_path):
    file = tmp_path / "scene.yaml"
    file.write_text(OBLIQUE + "dampers: {d: {c: 2 N*s/m, between: [[0, 1 m], p]}}\nfind: [expansion]\n",
                    encoding="utf-8")
    assert run(["solve", "--json", str(file)]) == 0
    data = json.loads(capsys.readouterr().out)["expansion"]
    assert data["left_out"] == ["dampers"] and data["reason"] is None
    assert [one["spring"] for one in data["springs"]] == ["s", "t", "u"]
    V = {one["product"]: one["factor"] for one in data["V"]}
    parts = [{one["product"]: one["factor"] for one in data["springs"][i][part]} for i in range(3)
             for part in ("material", "geometric")]
    assert V["x^3"] == pytest.approx(sum(part.get("x^3", 0.0) for part in parts), rel=1e-12)
    assert run(["solve", str(file)]) == 0
    assert "Energy of springs by their geometry (the rest), to order 4" in capsys.readouterr().out
    file.write_text("parameters: {m: 2 kg, k: 30 N/m^2}\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {law: k*d*abs(d), between: [ground, b]}}\nfind: [expansion]\n", encoding="utf-8")
    assert run(["solve", "--json", str(file)]) == 0
    data = json.loads(capsys.readouterr().out)["expansion"]
    assert data["V"] is None and data["reason"].startswith("'s' has a kink")


@pytest.mark.sweep
def test_corrections_in_letters():
    """Kovacić & Radomirović 2018, 9.5: δ₁ = cos a, δ₂ = sin²a/2l, δ₃ = −cos a sin²a/2l² of an oblique spring."""
    text = ("parameters: {m: {unit: kg}, k: {unit: N/m}, b: {unit: N/m^2}, c: {unit: N/m^3}, l: {unit: m}, a: "
            "{unit: rad}}\nbodies: {p: {mass: m, at: [0, 0], slide: x}}\nsprings: "
            "{s: {law: k*d + b*d^2 + c*d^3, between: [['-l*cos(a)', 'l*sin(a)'], p]}}\n")
    k, b, length, a = sympy.symbols("k b l a")
    d1, d2, d3 = sympy.cos(a), sympy.sin(a)**2 / (2 * length), -sympy.cos(a) * sympy.sin(a)**2 / (2 * length**2)
    expected = [0, 3 * k * d1 * d2, 4 * (k * (d1 * d3 + d2**2 / 2) + b * d1**2 * d2)]
    for n, form in enumerate(expected, 1):
        tree = parse(f"stiffness_correction[s, x^{n}]")
        node = declared(tree).symbolic(problem(text), tree)
        found = sympy.sympify(language(node).replace("^", "**"), locals={"a": a})
        assert sympy.simplify(found - form) == 0


def test_a_correction_at_a_kink_is_refused():
    text = ("parameters: {m: 2 kg, k: 30 N/m^2}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {law: k*d*abs(d), between: [ground, b]}}\n")
    with pytest.raises(PhysicsError, match="'s' has a kink"):
        value(problem(text), "stiffness_correction[s, x^3]")


def test_a_kink_has_no_expansion():
    text = ("parameters: {m: 2 kg, k: 30 N/m^2}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {law: k*d*abs(d), between: [ground, b]}}\nfind: [expansion]\n")
    with pytest.raises(PhysicsError, match="'s' has a kink"):
        expansions(problem(text), 4)


@pytest.mark.sweep
@pytest.mark.parametrize("length", ["1e-4", "1", "1e4"])
def test_no_term_of_a_deflection_is_lost_by_the_size_of_a_scene(length):
    """√((l − x)² + l²) of a spring at 45°."""
    *_, found = expansions(problem(
        f"parameters: {{m: 2 kg, k: 300 N/m, l: {length} m}}\nbodies: {{p: {{mass: m, at: [0, 0], move: [x, 0, 0]}}}}\n"
        "springs:\n  left: {k: k, between: [[-l, l], p]}\n  right: {k: k, between: [[l, l], p]}\n"
        "find: [{expansion: 6}]\n"), 6)
    x, size = sympy.symbols("x"), sympy.Float(length, 30)
    exact = sympy.series(sympy.sqrt((size - x)**2 + size**2), x, 0, 6).removeO()
    expected = {(n,): float(exact.coeff(x, n)) for n in range(1, 6) if abs(exact.coeff(x, n)) > 1e-25 * size**(1 - n)}
    assert found.deflections["right"].keys() == expected.keys()
    assert all(found.deflections["right"][n] == pytest.approx(c, rel=1e-12, abs=0.0) for n, c in expected.items())
