"""What small oscillations leave out of loads in time is told, and is what the full equations have beside K q."""

import json
from pathlib import Path

import pytest
from scenes import problem

import vibcli
from vibcli.algebra.calculus import gradient
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.cli import run
from vibcli.document import read
from vibcli.problem import Problem
from vibcli.spec import read_spec

HERE = Path(__file__).parent
FILES = [path for folder in (HERE.parent / "problems", HERE / "trials", Path(vibcli.__file__).parent / "examples")
         for path in sorted(folder.rglob("*.yaml"))]
INSTANTS = (0.0, 0.31, 1.7)
BOB = """
parameters: {m: 2 kg, g: 9.81 m/s^2, L: 1 m}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
"""
TWO = """
parameters: {m: 2 kg, g: 9.81 m/s^2, L: 1 m}
gravity: g
points: {P: {body: upper, at: [0, -L]}}
bodies:
  upper: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}
  lower: {mass: m, at: [0.2*L, -2*L], pin: {at: P, by: r}}
"""
SCENES = {
    "upwards": (BOB + "forces: {F: {at: bob, force: [0, 3 N*cos(2 rad/s*t)]}}\n", True),
    "with a constant": (BOB + "forces: {F: {at: bob, force: [0, 3 N*(1 - cos(2 rad/s*t))]}}\n", True),
    "beside a constant load": (BOB + "forces: {F: {at: bob, force: [2 N, 3 N*cos(2 rad/s*t)]}}\n", True),
    "sideways": (BOB + "forces: {F: {at: bob, force: [3 N*cos(2 rad/s*t), 0]}}\n", False),
    "sideways, displaced": (BOB + "forces: {F: {at: bob, force: [3 N*cos(2 rad/s*t) , 0]}, C: {at: bob, "
                            "force: [4 N, 0]}}\n", True),
    "a moment": (BOB + "forces: {F: {body: bob, moment: (3 N*m)*cos(2 rad/s*t)}}\n", False),
    "constant": (BOB + "forces: {F: {at: bob, force: [0, 3 N]}}\n", False),
    "on two": (TWO + "forces: {F: {at: lower, force: [1 N*sin(t*3 rad/s), 3 N*cos(2 rad/s*t)]}}\n", True),
}


def lacking(found):
    """{(i, j): [∂(full equation)ᵢ/∂qⱼ at rest in the equilibrium − Kᵢⱼ at some instants]}."""
    scene, K = found.scene, found.elements.matrices()[3]
    left, values = found.equations.full, {**found.at_rest, **dict.fromkeys((a.name for a in scene.a), 0.0)}
    for i in range(len(scene.q)):
        for j, q in enumerate(scene.q):
            slope = gradient(left[i]).get(q, scene.table.zero)
            yield (i, j), [evaluate([slope], Floats, {**values, scene.time.name: t})[0] - float(K.get((i, j), 0.0))
                           for t in INSTANTS]


def told(found, i, j):
    scene = found.scene
    slope = gradient(found.equations.left_out.get(i, scene.table.zero)).get(scene.q[j], scene.table.zero)
    return [evaluate([slope], Floats, {**found.at_rest, scene.time.name: t})[0] for t in INSTANTS]


def compare(found):
    K = found.elements.matrices()[3]
    largest = max(map(abs, map(float, K.values())), default=1.0)
    for (i, j), wanted in lacking(found):
        assert told(found, i, j) == pytest.approx(wanted, rel=1e-9, abs=1e-9 * largest), (i, j)


@pytest.mark.parametrize("name", SCENES)
def test_what_is_told_is_what_the_full_equation_has(name, tmp_path, capsys):
    text, any_left = SCENES[name]
    found = problem(text)
    compare(found)
    assert bool(found.equations.left_out) == any_left
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    assert run(["equations", str(path)]) == 0
    assert ("left out of the left side" in capsys.readouterr().out) == any_left
    assert run(["equations", str(path), "--json"]) == 0
    entries = json.loads(capsys.readouterr().out)["equations"]
    assert any(entry["left_out"] for entry in entries) == any_left


def test_in_letters():
    found = problem(BOB.replace("2 kg", "").replace("L: 1 m", "L: , F0: , W: ") + "forces: {F: {at: bob, force: [0, "
                    "F0*cos(W*t)]}}\n")
    scene = found.scene
    values = {"L": 2.0, "F0": 3.0, "W": 5.0, "m": 1.0, "t": 0.3, "phi": 1.0}
    node = found.equations.left_out[0]
    from math import cos

    assert evaluate([node], Floats, {**values, scene.time.name: 0.3})[0] == pytest.approx(-3 * 2 * cos(1.5))


def test_all_problems():
    """Loads in time alone: where places are driven too, small oscillations leave out more."""
    some = 0
    for path in FILES:
        text = path.read_bytes()
        if b"t" not in text or b"forces:" not in text:
            continue
        node, diagnostics = read(text, str(path))
        found = Problem(read_spec(node, str(path), diagnostics))
        if found.symbolic or not found.scene.timed or found.loose is not found.scene or found.scene.driven:
            continue
        if found.equations.refusal or not found.equations.full:
            assert not found.equations.left_out
            continue
        some += 1
        compare(found)
    assert some > 10
