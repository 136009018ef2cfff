"""How ω of families of several degrees begins to hang on the amplitude: against the equations of motion by Lindstedt's
method, closed forms, and the families themselves."""

import numpy as np
import pytest
from scipy.linalg import eigh
from support.motions import problem

from vibcli import loads
from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run

MASSES, LAWS = (2.0, 1.3, 0.8), ((80, 90, 500), (50, -140, 900), (70, 60, 300), (90, -30, 700))
CHAIN = "bodies:\n" + "".join(f"  b{i}: {{mass: {m} kg, slide: x{i}}}\n" for i, m in enumerate(MASSES)) + \
    "springs:\n" + "".join(
        f"  s{i}: {{law: ({k} N/m)*d + ({a} N/m^2)*d^2 + ({b} N/m^3)*d^3, between: [{left}, {right}]}}\n"
        for i, ((k, a, b), left, right) in enumerate(zip(LAWS, ("ground", "b0", "b1", "b2"),
                                                         ("b0", "b1", "b2", "ground"), strict=True)))
PENDULUMS = """
gravity: 9.81 m/s^2
bodies:
  a: {mass: 2 kg, at: [0, -0.8 m], pin: {at: [0, 0], by: phi}}
  b: {mass: 1.2 kg, at: [0.3 m, -1.4 m], pin: {at: [0, -0.8 m], by: psi, carrier: a}}
springs: {s: {law: (20 N/m)*d + (70 N/m^2)*d^2, between: [[1 m, -0.8 m], a]}}
"""
PAIR = """
parameters: {m: 1 kg, k: 5 N/m, b: 2 N/m^3, c: 1.3 N/m, f: 1.5 N/m^3}
bodies: {left: {mass: m, slide: x}, right: {mass: m, slide: y}}
springs:
  s: {law: k*d + b*d^3, between: [ground, left]}
  t: {law: c*d + f*d^3, between: [left, right]}
  u: {law: k*d + b*d^3, between: [ground, right]}
"""


def lindstedt(number, coordinate):
    """κ of the chain by its equations: q = a φ cos θ + a² (c₀ + c₂ cos 2θ), and no secular terms at a³."""
    strains = -np.diff(np.eye(5), axis=0)[:, 1:-1]
    k, a, b = np.array(LAWS, float).T
    M, K = np.diag(MASSES), strains.T * k @ strains
    squares, shapes = eigh(K, M)
    square, phi = squares[number], shapes[:, number]

    def bent(one, other):
        return strains.T @ (a * (strains @ one) * (strains @ other))

    still = -0.5 * np.linalg.solve(K, bent(phi, phi))
    double = -0.5 * np.linalg.solve(K - 4 * square * M, bent(phi, phi))
    secular = 2 * bent(phi, still) + bent(phi, double) + 0.75 * strains.T @ (b * (strains @ phi) ** 3)
    return phi @ secular / (2 * square * phi[coordinate] ** 2)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_chain_with_quadratic_and_cubic_springs(number):
    model = loads(CHAIN)
    for coordinate in (0, 2):
        found, exact = model[f"backbone[{number + 1}, x{coordinate}^2]"], lindstedt(number, coordinate)
        assert abs(found.value - exact) <= found.error + 1e-13 * abs(exact)
        assert found.error < 1e-11 * abs(exact)


@pytest.mark.parametrize("number", [1, 2])
def test_uneven_inertia_against_the_family_extrapolated(number):
    of = problem(PENDULUMS).free_motions
    found = of.kappa(number, "phi", None, 0.0)
    points = of.curve(number, given_expression("phi", "it").tree, [0.002, 0.004, 0.008]).points
    small = float(of.several.equations.omegas[number - 1])
    one, two, three = [(point.omega / small - 1) / point.amplitude**2 for point in points]
    one, two = (4 * one - two) / 3, (4 * two - three) / 3
    assert found.value == pytest.approx((16 * one - two) / 15, rel=1e-7)
    assert found.error < 1e-11 * abs(found.value)


def test_blocks_on_straight_lines():
    assert loads(PAIR)["backbone[1, x^2]"].value == pytest.approx(3 * 2 / (8 * 5), rel=1e-13)
    assert loads(PAIR)["backbone[2, y^2]"].value == pytest.approx(3 * (2 + 8 * 1.5) / (8 * 7.6), rel=1e-13)


@pytest.mark.parametrize(("text", "what", "told"), [
    (PAIR, "backbone[3, x^2]", "2 families"),
    (PAIR.replace("c: 1.3 N/m", "c: 1e-9 N/m"), "backbone[1, x^2]", "internal resonance 1:1"),
    (PAIR.replace("c: 1.3 N/m", "c: 7.5 N/m"), "backbone[1, x^2]", "1:2: mode 2 has 2 times the frequency of mode 1"),
    (PAIR.replace("c: 1.3 N/m", "c: 20 N/m"), "backbone[1, x^2]", "internal resonance 1:3"),
    (PAIR.replace("c*d + f*d^3", "c*d + f*d^3 + (1 N/m)*abs(d)"), "backbone[1, x^2]", "'t' has a kink of abs"),
    (PAIR.replace("slide: y}}", "slide: y}, third: {mass: 2*m, slide: z}}") +
     "  v: {law: k*d + b*d^3, between: [ground, third]}\n", "backbone[2, z^2]", "does not move in small motions"),
])
def test_what_has_no_such_factor_is_refused(text, what, told):
    with pytest.raises(PhysicsError, match=told):
        loads(text)[what]


def test_the_report_tells_it_beside_the_table(tmp_path, capsys):
    file = tmp_path / "pair.yaml"
    file.write_text(PAIR.replace("c: 1.3 N/m", "c: 18 N/m") + "find: [{backbone: {of: [x], up_to: 1 cm}}]\n")
    assert run(["frequencies", str(file), "--backbone"]) == 0
    out = capsys.readouterr().out
    assert "κ = 0.15 1/m²" in out and "ω₁(1 + κA²)" in out
    assert "Mode 2 has nearly 3 times the frequency of mode 1" in out
    assert run(["frequencies", str(file), "--backbone", "--json"]) == 0
    assert '"kappa": 0.15' in capsys.readouterr().out


def test_a_factor_that_is_zero_in_letters_is_told_once(tmp_path, capsys):
    file = tmp_path / "play.yaml"
    file.write_text("parameters: {m: 2 kg, k: 300 N/m, e: 1 cm}\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}, stop: {k: 9*k, gap: e, between: [ground, b]}}\n"
                    "find: [{backbone: {of: [x], up_to: 3 cm}}]\n")
    assert run(["solve", str(file)]) == 0
    assert "  κ = 0 1/m²\n" in capsys.readouterr().out + "\n"
