"""Energies and equations expanded about the equilibrium, against SymPy's own series of Lagrange's equations."""

import json

import pytest
import sympy
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.cli import run
from vibcli.notation.scene_language import language
from vibcli.results.expansions import expansions

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


def test_a_kink_has_no_expansion():
    text = ("parameters: {m: 2 kg, k: 30 N/m^2}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {law: k*d*abs(d), between: [ground, b]}}\nfind: [expansion]\n")
    with pytest.raises(PhysicsError, match="'s' has a kink"):
        expansions(problem(text), 4)


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
