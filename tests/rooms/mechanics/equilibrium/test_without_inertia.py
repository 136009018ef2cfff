"""Scenes without inertia have equilibria, stable or not by the signs of K; only what vibrates is refused."""

import json

import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.cli.program import run

POST = """
points: {A: {body: b, at: [0, L]}}
bodies: {b: {at: [0, 0], pin: {at: [0, 0], by: f}}}
springs: {s: {torsion: kt, between: [ground, b]}}
forces: {p: {at: A, force: [0, -W]}}
"""
NUMBERS = "parameters: {L: 0.5 m, W: 10 N, kt: 6 N*m}" + POST
LETTERS = "parameters: {L: {unit: m}, W: {unit: N}, kt: {unit: N*m}}" + POST


@pytest.mark.parametrize("text", [NUMBERS, LETTERS])
def test_solve_ends_well_and_frequencies_do_not(text, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    assert run(["solve", str(path)]) == 0
    out = capsys.readouterr().out
    assert "none: nothing in the scene has inertia" in out and "Equations of motion" in out
    assert run(["solve", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["equilibrium"]["stable"] is (True if text is NUMBERS else None)
    assert run(["frequencies", str(path)]) == 4
    assert "nothing can vibrate" in capsys.readouterr().err


@pytest.mark.parametrize("seed", range(6))
def test_stable_by_the_signs_of_K(seed):
    """V = ½ qᵀ A q of random symmetric A, in coordinates of unlike size."""
    A = np.random.default_rng(seed).normal(size=(3, 3)) + 1.5 * np.eye(3)
    A = A + A.T
    V = " + ".join(f"({float(A[i, j]) / 2!r})*({10**i})*q{i}*({10**j})*q{j}" for i in range(3) for j in range(3))
    found = problem(f"parameters: {{E: 1 J}}\ncoordinates: [q0, q1, q2]\nenergies:\n  V: E*({V})\n")
    assert value(found, "stable") is bool(np.linalg.eigvalsh(A)[0] > 0)


def scene_of(**matrices):
    """The Problem of matrices given outright; what is not symmetric in K as loads."""
    matrices["K"] = np.array(matrices["K"])
    n, pushed = len(matrices["K"]), np.triu(matrices["K"] - matrices["K"].T, 1)
    matrices["K"] = np.tril(matrices["K"]) + np.tril(matrices["K"], -1).T
    loads = ", ".join(f"f{i}{j}: {{coordinate: q{i}, value: {-float(pushed[i, j])!r}*q{j}}}"
                      for i, j in np.argwhere(pushed).tolist())

    def rows(A):
        return "[" + ", ".join("[" + ", ".join(map(repr, map(float, row))) + "]" for row in A) + "]"

    written = ", ".join(f"{name}: {rows(A)}" for name, A in matrices.items())
    return problem(f"coordinates: [{', '.join(f'q{i}' for i in range(n))}]\nmatrices: {{{written}}}\n"
                   + f"forces: {{{loads}}}\n" * bool(loads))


def with_a_little(M, C, K):
    """max Re λ of the scene once everything has a little mass and damping."""
    n = len(K)
    M, C = M + 1e-9 * np.eye(n), C + 1e-4 * np.eye(n)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    return np.linalg.eigvals(A).real.max()


@pytest.mark.parametrize("seed", range(40))
def test_stable_as_with_a_little_mass_and_damping(seed):
    """Random K, of which some coordinates have inertia, some dampers, some neither; of some seeds no potential."""
    random = np.random.default_rng(seed)
    n = 3
    K = random.normal(size=(n, n))
    K = K + K.T + 2.0 * (seed % 3) * np.eye(n)
    M = np.diag(random.uniform(1, 2, n) * (random.uniform(size=n) < 0.4))
    root = random.normal(size=(n, n)) * (random.uniform(size=n) < 0.6)[:, None]
    C = root @ root.T
    if seed % 4 == 3:
        moved = np.diag(M) + np.diag(C) > 0
        K = K + np.triu(np.outer(moved, moved) * random.normal(size=(n, n)), 1)
    wanted = bool(with_a_little(M, C, K) < 0)
    assert value(scene_of(M=M, C=C, K=K), "stable") is wanted


@pytest.mark.parametrize(("V", "kind"), [
    ("E*x^4", "held"), ("-E*x^4", "falling"), ("E*x^3", "falling"), ("E*(x^2 + y^4)", "held"),
    ("E*((y - x^2)^2 - x^4/2)", "falling"), ("E*((y - x^2)^2 + x^4/2)", "held"), ("E*((y - x^2)^2)", "neutral"),
    ("E*(x^4 + y^4 - 3*x^2*y^2)", "falling"), ("E*(x^4 + y^4 - x^2*y^2)", "held"), ("E*(x^2 - y^2)", "unstable"),
    ("E*(x^2 + y^2)", "stable")])
@pytest.mark.parametrize("what", ["", "Phi: c/2*(x'^2 + y'^2)", "T: J/2*(x'^2 + y'^2)", "T: J/2*x'^2",
                                  "Phi: c/2*x'^2"])
def test_beyond_the_linear_terms(V, kind, what):
    """The same potential with nothing, dampers, masses or some of them; valleys may be bent, and lie between axes."""
    names = "x, y" if "y" in V else "x"
    what = what if "y" in V else what.replace(" + y'^2", "")
    given = "E: 3 J" + ", J: 2 kg*m^2" * ("T" in what) + ", c: 1 N*m*s" * ("Phi" in what)
    found = problem(f"parameters: {{{given}}}\ncoordinates: [{names}]\nenergies: {{V: \"{V}\""
                    + f", {what}" * bool(what) + "}\n")
    assert found.modal.stability.kind == kind
    assert value(found, "stable") is (kind not in ("falling", "unstable"))


def test_loads_without_a_potential_on_what_has_no_inertia():
    """Ziegler's column of light bars: masses or dampers decide; with dampers the roots of C s + K do."""
    from vibcli.base.errors import PhysicsError

    bare = scene_of(K=[[5.0, 5.0], [-10.0, 10.0]])
    with pytest.raises(PhysicsError, match="masses or dampers would decide"):
        value(bare, "stable")
    assert value(scene_of(K=[[5.0, 5.0], [10.0, -10.0]]), "stable") is False        # det K < 0
    damped = [[[5.0, -3.0], [-3.0, 3.0]], [[5.0, 5.0], [-10.0, 10.0]]]
    assert value(scene_of(C=damped[0], K=damped[1]), "stable") is bool(
        np.linalg.eigvals(-np.linalg.solve(*map(np.array, damped))).real.max() < 0)
