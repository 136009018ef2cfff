"""Rest where forces jump: what a jump bears is what balance asks for, against bounded least squares of SciPy."""

import json

import mpmath
import numpy as np
import pytest
from scipy.optimize import lsq_linear
from support.motions import problem

import vibcli
from vibcli.base.errors import Kinked, PhysicsError
from vibcli.cli.program import run
from vibcli.symbolic.evaluation import multiprecision

BLOCK = """
parameters: {{m: 2 kg, F0: 10 N, k: 800 N/m, c: 1 cm, W: {load} N}}
bodies: {{block: {{mass: m, slide: x}}}}
springs: {{s: {{law: k*d + F0*sign(d - c), between: [ground, block]}}}}
forces: {{w: {{at: block, force: W}}}}
"""


@pytest.mark.parametrize(("load", "x", "force"), [
    (-3, None, None), (4, 0.01, 4), (17.5, 0.01, 17.5), (-1.9, 0.01, -1.9), (20, None, None)])
def test_a_jump_bears_what_balance_asks_for(load, x, force):
    """k c ∓ F₀ = −2 N and 18 N: between them it rests at c, beyond them at (W ± F₀)/k."""
    model = vibcli.loads(BLOCK.format(load=load))
    assert model["equilibrium[s.force]"].value == pytest.approx(load, rel=1e-14)
    place = model["equilibrium[x]"].value
    if x is None:
        assert place == pytest.approx((load - 10 * np.sign(load)) / 800, rel=1e-14)
        assert model["omega[1]"].value == pytest.approx(20)
    else:
        assert (place, force) == (pytest.approx(x, rel=1e-15), load)
        with pytest.raises(Kinked, match="a force jumps in the equilibrium"):
            model["omega[1]"]


CHAIN = """
bodies:
  a: {{mass: 1 kg, slide: x}}
  b: {{mass: 1 kg, slide: y}}
  c: {{mass: 1 kg, slide: z}}
springs:
  p: {{k: {0} N/m, between: [ground, a]}}
  q: {{k: {1} N/m, between: [a, b]}}
  r: {{k: {2} N/m, between: [b, c]}}
  s: {{law: "{3} N*sign(d)", between: [ground, a]}}
  t: {{law: "{4} N*sign(d)", between: [a, b]}}
  u: {{law: "{5} N*sign(d)", between: [ground, c]}}
forces:
  f: {{at: b, force: {6} N}}
  g: {{at: c, force: {7} N}}
"""


@pytest.mark.parametrize("seed", range(6))
def test_bodies_rest_at_some_of_the_jumps(seed):
    rng = np.random.default_rng(seed)
    k1, k2, k3 = rng.uniform(50, 400, 3).round(1)
    F, (f, g) = rng.uniform(2, 12, 3).round(2), rng.uniform(-15, 15, 2).round(2)
    K = np.array([[k1 + k2, -k2, 0], [-k2, k2 + k3, -k3], [0, -k3, k3]])
    A, loads = np.array([[1.0, 0, 0], [-1, 1, 0], [0, 0, 1]]), np.array([0, f, g])
    root = np.linalg.inv(np.linalg.cholesky(K))
    tensions = lsq_linear(root @ A.T, root @ loads, (-F, F), tol=1e-15, method="bvls").x
    q = np.linalg.solve(K, loads - A.T @ tensions)
    model = vibcli.loads(CHAIN.format(k1, k2, k3, *F, f, g))
    found = [model[f"equilibrium[{name}]"].value for name in "xyz"]
    assert found == pytest.approx(q, abs=1e-13)
    forces = [model[f"equilibrium[{name}.force]"] for name in "stu"]
    assert [force.value for force in forces] == pytest.approx(tensions, abs=1e-11)


def test_two_laws_that_jump_at_one_place_share_what_balance_leaves_open():
    model = vibcli.loads("""
bodies: {block: {mass: 2 kg, slide: x}}
springs:
  s: {law: (10 N)*sign(d), between: [ground, block]}
  z: {law: (20 N)*sign(d), between: [ground, block]}
forces: {w: {at: block, force: 14 N}}
""")
    assert model["equilibrium[x]"].value == 0
    with pytest.raises(PhysicsError, match="s and z jump at one place"):
        model["equilibrium[s.force]"]


def test_more_digits_of_a_rest_at_a_jump():
    configuration = problem(BLOCK.format(load=4).replace("c: 1 cm", "c: (1 cm)/3")).configuration
    with mpmath.workdps(40):
        arithmetic = multiprecision()
        found = configuration.equilibrium.jumps.precisely(arithmetic, configuration.numeric.values(arithmetic))
        assert abs(found["x"] - mpmath.mpf(1) / 300) < 1e-40


def test_families_about_a_rest_at_a_jump_and_its_report(tmp_path, capsys):
    """V = F₀|x| − W x: from A it falls for √(2 m A/(F₀ − W)), and comes to rest at A (F₀ − W)/(F₀ + W)."""
    path = tmp_path / "jump.yaml"
    path.write_text("""
parameters: {m: 2 kg, F0: 10 N, W: 4 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: F0*sign(d), between: [ground, block]}}
forces: {w: {at: block, force: W}}
""")
    m, F, W, A = 2, 10, 4, 0.05
    B = A * (F - W) / (F + W)
    period = 2 * ((2 * m * A / (F - W)) ** 0.5 + (2 * m * B / (F + W)) ** 0.5)
    model = vibcli.load(path)
    assert model[f"backbone[1](x)({(A + B) / 2!r} m)"].value == pytest.approx(2 * np.pi / period, rel=1e-13)
    run(["solve", str(path), "--json"])
    assert json.loads(capsys.readouterr().out)["equilibrium"]["coordinates"] == {"x": 0}
    run(["solve", str(path)])
    assert "balanced with sign x = 0.4" in capsys.readouterr().out
