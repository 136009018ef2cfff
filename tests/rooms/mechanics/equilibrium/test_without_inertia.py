"""Scenes without inertia have equilibria, stable or not by the signs of K; only what vibrates is refused."""

import json

import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.cli import run

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
