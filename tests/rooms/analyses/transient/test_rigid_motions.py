"""What moves freely beside dampers, where ratios and slopes round K: λ = 0 is told as such, by e^{At} of SciPy."""

import numpy as np
import pytest
from scipy.linalg import expm, qr
from support.scenes import problem

from vibcli.analyses.transient.complex_modes import general
from vibcli.analyses.transient.rigid_motions import _places, exact, freed
from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

GEARS = """
    parameters: {J1: 0.02, J2: 0.05, J3: 0.08, J4: 0.4, k1: 400, k2: 900, r1: 0.04, r2: 0.1, r3: 0.05, r4: 0.15, T: 8}
    bodies:
      motor: {inertia: J1, turn: a}
      pinion: {turn: p}
      lay: {inertia: J2, turn: q}
      wheel: {inertia: J3, turn: r}
      load: {inertia: J4, turn: b}
    springs:
      s1: {torsion: k1, between: [motor, pinion]}
      s2: {torsion: k2, between: [wheel, load]}
    dampers:
      d: {torsion: 0.6, between: [ENDS]}
    constraints:
      g1: {gear: [pinion, lay], radii: [r1, r2]}
      g2: {gear: [lay, wheel], radii: [r3, r4]}
    forces:
      drive: {body: motor, moment: "LOAD"}
"""
N, AT = 0.04 / 0.1 * 0.05 / 0.15, 0.7


def value_of(found, text):
    """A quantity of a Problem."""
    return float(measure(found, parse(text))[0])


def train(ends, light=False):
    """(M, C, K) of (a, p, b); of (a, b) where the wheels between have no inertia."""
    M = np.diag([0.02, 0.05 * 0.16 + 0.08 * N**2, 0.4])
    rows = {"ground, load": [0, 0, 1], "motor, pinion": [-1, 1, 0], "wheel, load": [0, -N, 1]}
    C = 0.6 * np.outer(rows[ends], rows[ends])
    K = sum(k * np.outer(row, row) for k, row in ((400, [-1, 1, 0]), (900, [0, -N, 1])))
    if light:
        T = np.linalg.solve(np.atleast_2d(K[1, 1]), -K[1:2, [0, 2]])
        T = np.array([[1, 0], T[0], [0, 1]])
        M[1, 1] = 0.0
        return *(T.T @ matrix @ T for matrix in (M, C, K)), T
    return M, C, K, np.eye(3)


def under_step(M, C, K, T):
    """(q, q̇) of (a, p, b) at AT under 8 N·m on a."""
    n, inverse = len(M), np.linalg.inv(M)
    A = np.block([[np.zeros((n, n)), np.eye(n), np.zeros((n, 1))],
                  [-inverse @ K, -inverse @ C, inverse[:, :1] * 8.0], [np.zeros((1, 2 * n + 1))]])
    state = expm(A * AT)[:-1, -1]
    return T @ state[:n], T @ state[n:]


@pytest.mark.parametrize("ends, light", [("ground, load", False), ("motor, pinion", False), ("wheel, load", False),
                                         ("ground, load", True)])
def test_a_geared_train_that_turns_freely_is_moved(ends, light):
    text = GEARS.replace("ENDS", ends).replace("LOAD", "T*step(t)")
    found = problem(text.replace("J2: 0.05, J3: 0.08", "J2: 0, J3: 0") if light else text)
    q, v = under_step(*train(ends, light))
    read = {name: value_of(found, f"{name}({AT})") for name in ("a", "b", "b'", "s2.force")}
    expected = {"a": q[0], "b": q[2], "b'": v[2], "s2.force": 900 * (q[2] - N * q[1])}
    assert read == pytest.approx(expected, rel=1e-9)
    with pytest.raises(PhysicsError, match="nothing holds"):
        value_of(found, "steady(a)(1)")


def test_its_speed_settles_and_its_shafts_carry_what_the_load_takes():
    found = problem(GEARS.replace("ENDS", "ground, load").replace("LOAD", "T*step(t)"))
    assert value_of(found, "final(b')") == pytest.approx(8 / N / 0.6, rel=1e-6)
    assert value_of(found, "final(s2.force)") == pytest.approx(-8 / N, rel=1e-6)


@pytest.mark.parametrize("ends", ["motor, pinion", "wheel, load"])
def test_it_has_a_steady_state_where_only_its_shafts_are_damped(ends):
    found = problem(GEARS.replace("ENDS", ends).replace("LOAD", "T*sin(20*t)"))
    M, C, K, _ = train(ends)
    X = np.linalg.solve(K - 400 * M + 20j * C, [8, 0, 0])
    for signal, value in (("a", X[0]), ("b", X[2]), ("s2.force", 900 * (X[2] - N * X[1]))):
        assert value_of(found, f"amplitude({signal})") == pytest.approx(abs(value), rel=1e-9)


def loose_pair(dice, grounded):
    """Two masses in the plane with an oblique spring and a damper between them, one perhaps damped along one oblique
    direction to the ground: three motions are free."""
    u, w, g = dice.normal(size=(3, 2))
    s, d, e = np.concatenate([-u, u]), np.concatenate([-w, w]), np.concatenate([g, 0 * g])
    M = np.diag([1.3, 1.3, 0.7, 0.7])
    K, C = 57.0 * np.outer(s, s), 3.0 * np.outer(d, d) + (2.0 * np.outer(e, e) if grounded else 0.0)
    return M, C, K, np.linalg.svd(s[None])[2][1:].T


@pytest.mark.parametrize("grounded, zeros", [(False, 5), (True, 4)])
def test_as_many_eigenvalues_vanish_as_motions_are_free_and_undamped(grounded, zeros):
    M, C, K, rigid = loose_pair(np.random.default_rng(7), grounded)
    blocks = general(M, C, K, rigid)
    assert exact(blocks) == zeros == freed(M, C, K, rigid).zeros
    assert all(node.real <= 0 for block in blocks for node in block.nodes)
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    q, v = np.arange(1.0, 5.0), np.arange(4.0, 0.0, -1.0)
    moved = sum((block.X @ expm(block.B * AT) @ (block.P @ q + block.R @ v)).real for block in blocks)
    np.testing.assert_allclose(moved, (expm(A * AT) @ np.concatenate([q, v]))[:n], rtol=1e-11)


def test_motions_of_others_are_not_looked_at_twice():
    M, C, K, _ = loose_pair(np.random.default_rng(7), True)
    assert freed(M, C, K, np.zeros((4, 1))) is None


def test_places_are_the_pivots_of_qr():
    for seed in range(6):
        columns = np.random.default_rng(seed).normal(size=(9, 1 + seed % 4))
        pivots = qr(columns.T, mode="r", pivoting=True)[1]
        assert _places(columns) == pivots[:columns.shape[1]].tolist()


def test_of_rows_alike_but_for_rounding_the_first_is_a_place():
    rng = np.random.default_rng(3)
    for _ in range(20):
        assert _places(np.ones((7, 1)) * (1 + 1e-15 * rng.normal(size=(7, 1)))) == [0]
