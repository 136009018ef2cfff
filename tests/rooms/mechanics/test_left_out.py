"""What small oscillations leave out of loads in time and driven displacements is told, and is what the full equations
have beside C q̇ + K q."""

import json
from fractions import Fraction
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem

import vibcli
from vibcli.cli.program import run
from vibcli.mechanics.lagrange import equation_of
from vibcli.results.problem import Problem
from vibcli.scene.displacements import Displacements, stays_bounded
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

ROOT = Path(__file__).parents[3]
FILES = [path for folder in (ROOT / "problems", ROOT / "tests" / "trials", Path(vibcli.__file__).parent / "examples")
         for path in sorted(folder.rglob("*.yaml")) if path.name != "set.yaml"]
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


SHAKEN_BASE = """
parameters: {m: 2 kg, k: 800 N/m, c: {value: 3 N*s/m, unused: allowed}, Y: 0.02 m, W: 5 rad/s}
bodies:
  base: {slide: {along: [ALONG], by: Y*(cos(W*t) + 0.4*sin(3*W*t))}, at: [1 m, 1 m]}
  b: {mass: m, at: [0 m, 0 m], slide: {along: [1, 0], by: x}}
springs: {s: {k: k, between: [base, b]}, r: {k: k, between: [[-1 m, 0 m], b]}}
"""
ARM = """
parameters: {m: 2 kg, k: 800 N/m, A: 0.1, W: 5 rad/s, g: 9.81 m/s^2}
gravity: g
points: {P: {body: arm, at: [0.3 m, 0 m]}, Q: {body: b, at: [0.6 m, -0.4 m]}}
bodies:
  arm: {pin: {at: [0 m, 0 m], by: A*sin(W*t)}, at: [0 m, 0 m]}
  b: {mass: m, at: [0.4 m, -0.5 m], inertia: 0.1 kg*m^2, move: [x, y, phi]}
"""
SHAKEN = {
    "a spring across": (SHAKEN_BASE.replace("ALONG", "0, 1"), True),
    "a spring along": (SHAKEN_BASE.replace("ALONG", "1, 1"), True),
    "straight springs": (SHAKEN_BASE.replace("ALONG", "1, 0").replace("[1 m, 1 m]", "[1 m, 0 m]"), False),
    "a damper across": (SHAKEN_BASE.replace("ALONG", "0.6, 0.8") + "dampers: {d: {c: c, between: [base, b]}}\n",
                        True),
    "under a load in time": (SHAKEN_BASE.replace("ALONG", "0, 1") + "forces: {F: {at: b, force: [3 N*cos(2 rad/s*t), "
                             "0 N]}}\n", True),
    "displaced": (SHAKEN_BASE.replace("ALONG", "0, 1") + "dampers: {d: {c: c, between: [base, b]}}\n"
                  "forces: {F: {at: b, force: [90 N, 0 N]}}\n", True),
    "an arm that rocks": (ARM + "springs: {s: {k: k, between: [P, b]}, r: {k: 300 N/m, between: [[1 m, 0.2 m], b]}, "
                          "t: {torsion: 5 N*m, between: [arm, b]}}\n"
                          "dampers: {d: {c: 4 N*s/m, between: [P, b]}}\n", True),
    "a preload": ("""
parameters: {m: 2 kg, Y: 0.01 m, W: 5 rad/s, g: 9.81 m/s^2}
gravity: g
bodies:
  c: {at: [0.4 m, 0.3 m], slide: {along: [1, 0], by: Y*cos(W*t)}}
  b: {mass: m, at: [0.1 m, 0 m], pin: {at: [0 m, 0 m], by: phi}}
springs: {t: {k: 200 N/m, preload: static, between: [c, b]}}
""", True),
    "in a turning frame": ("""
parameters: {m: 2 kg, Y: 0.01 m, W: 5 rad/s, V: 2 rad/s}
bodies:
  arm: {pin: {at: [0 m, 0 m], by: V*t}, at: [0 m, 0 m]}
  c: {at: [0.4 m, 0.3 m], slide: {along: [0, 1], by: Y*cos(W*t), carrier: arm}}
  b: {mass: m, at: [0.1 m, 0 m], slide: {along: [1, 0], by: x, carrier: arm}}
springs: {t: {k: 200 N/m, between: [c, b]}}
""", True),
    "a load on an arm that rocks": (ARM.replace("0.1, W", "0.1, K: 30 N/m, W") + """
springs:
  s: {k: k, between: [P, b]}
  r: {k: 300 N/m, between: [[1 m, 0.2 m], b]}
  t: {torsion: 5 N*m, between: [arm, b]}
forces:
  F: {at: Q, force: [5 N + K*x - (2 N*s/m)*x', 2 N], carrier: arm}
  G: {at: Q, force: [0 N, 3 N*cos(2 rad/s*t)]}
  M: {body: b, moment: (2 N*m)*phi}
""", True),
    "through a constraint": ("""
parameters: {m: 2 kg, A: 0.1, W: 5 rad/s, k: 50 N*m}
bodies:
  arm: {inertia: 0.01 kg*m^2, mass: 0.001 kg, pin: {at: [0 m, 0 m], by: a}, at: [0 m, 0 m]}
  b: {mass: m, at: [0.4 m, -0.5 m], pin: {at: [0 m, 0 m], by: phi}}
constraints: {c: a = A*sin(W*t)}
springs: {t: {torsion: k, between: [arm, b]}}
forces: {F: {at: b, force: [5 N, 0], carrier: arm}}
""", True),
    "through a loop": ("""
parameters: {W: 3 rad/s, A: 0.1}
points: {P: {body: crank, at: [0.3 m, 0.3 m]}, E: {body: rod, at: [1 m, 0]}}
bodies:
  crank: {mass: 0.001 kg, inertia: 0.02 kg*m^2, at: [0, 0], pin: A*cos(W*t)}
  rod: {mass: 0, inertia: 0, at: [0.3 m, 0.3 m], pin: {at: P, by: psi}}
  piston: {at: [1 m, 0], slide: x}
  bob: {mass: 1 kg, at: [2 m, 1 m], slide: {along: [0, 1], by: y}}
constraints: {c: {join: [E, piston]}}
springs:
  s: {k: 30 N/m, between: [piston, bob]}
  r: {k: 20 N/m, free_length: 0.7 m, between: [bob, [2 m, 2 m]]}
dampers: {d: {c: 3 N*s/m, between: [piston, bob]}}
""", True),
}
SMALL = 1e-4


def lacking(found, parts):
    """(i, j, q or v): [∂(full equation)ᵢ/∂qⱼ or q̇ⱼ at rest in the equilibrium − Kᵢⱼ or (C + G)ᵢⱼ at some instants], to
    first order in what is driven: of `parts`, the scenes with SMALL and −SMALL times the displacements, their mean and
    half their difference over SMALL."""
    scene, (_, C, G, K) = found.scene, found.configuration.linear_system.matrices()
    weights = (1.0,) if len(parts) == 1 else (0.5 + 0.5 / SMALL, 0.5 - 0.5 / SMALL)
    for i in range(len(scene.q)):
        for j in range(len(scene.q)):
            for matrices, kind in (((K,), "q"), ((C, G), "v")):
                known = sum(float(matrix.get((i, j), 0.0)) for matrix in matrices)
                yield (i, j, kind), [sum(w * slope(part, i, j, kind, at(found, part, t)) for w, part in
                                         zip(weights, parts, strict=True)) - known for t in INSTANTS]


def slope(scene, i, j, kind, values):
    left = equation_of(scene, i)
    return evaluate([gradient(left).get(getattr(scene, kind)[j], scene.table.zero)], Floats, values)[0]


def at(found, scene, t):
    """Everything at rest in the equilibrium at an instant, with the loops closed."""
    at = found.configuration
    values = {**at.at_rest, **at.dependent_values, **dict.fromkeys((a.name for a in scene.a), 0.0)}
    now = {**values, scene.time.name: t}
    return now if scene.loops is None else scene.loops.followed({**values, scene.time.name: 0.0}, now) or now


def told(found, i, j, kind):
    scene = found.scene
    left_out, zero = found.symbolic.equations.left_out, scene.table.zero
    by = gradient(left_out.get(i, zero)).get(getattr(scene, kind)[j], zero)
    return [evaluate([by], Floats, {**found.configuration.at_rest, scene.time.name: t})[0] for t in INSTANTS]


def compare(found, parts):
    _, C, G, K = found.configuration.linear_system.matrices()
    largest = max((abs(float(x)) for matrix in (C, G, K) for x in matrix.values()), default=1.0)
    tolerance = 1e-9 if len(parts) == 1 else 1e-6
    for (i, j, kind), wanted in lacking(found, parts):
        ours = told(found, i, j, kind)
        assert ours == pytest.approx(wanted, rel=tolerance, abs=tolerance * largest), (found.spec.file, i, j, kind)


def parts_of(found, monkeypatch):
    """The scene; or where displacements are driven to and fro, those with SMALL and −SMALL times them."""
    if found.scene.resting is found.scene:
        return [found.scene]
    whole = Displacements.driven_by
    scenes = []
    for factor in (SMALL, -SMALL):
        def scaled(self, node, name, drive=None, factor=factor):
            small = stays_bounded(node, self.time, self.expressions.sample)
            return whole(self, node * self.table.number(Fraction(factor)) if small else node, name, drive)

        with monkeypatch.context() as patched:
            patched.setattr(Displacements, "driven_by", scaled)
            scenes.append(Problem(found.spec).scene)
    return scenes


@pytest.mark.sweep
@pytest.mark.parametrize("name", [*SCENES, *SHAKEN])
def test_what_is_told_is_what_the_full_equation_has(name, tmp_path, capsys, monkeypatch):
    text, any_left = {**SCENES, **SHAKEN}[name]
    found = problem(text)
    compare(found, parts_of(found, monkeypatch))
    assert bool(found.symbolic.equations.left_out) == any_left
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    for command in ("equations", "response"):
        assert run([command, str(path)]) == 0
        assert ("left out of the left side" in capsys.readouterr().out) == any_left
    assert run(["equations", str(path), "--json"]) == 0
    entries = json.loads(capsys.readouterr().out)["equations"]
    assert any(entry["left_out"] for entry in entries) == any_left


def test_in_letters():
    found = problem(BOB.replace("2 kg", "").replace("L: 1 m", "L: , F0: , W: ") + "forces: {F: {at: bob, force: [0, "
                    "F0*cos(W*t)]}}\n")
    scene = found.scene
    values = {"L": 2.0, "F0": 3.0, "W": 5.0, "m": 1.0, "t": 0.3, "phi": 1.0}
    node = found.symbolic.equations.left_out[0]
    from math import cos

    assert evaluate([node], Floats, {**values, scene.time.name: 0.3})[0] == pytest.approx(-3 * 2 * cos(1.5))


def test_driven_displacements_in_letters():
    """By hand: l = √((h − x)² + (h + u)²), k (h√2 − l) ∂l/∂x and c l̇ ∂l/∂x."""
    text = SHAKEN_BASE.replace("ALONG", "0, 1").replace("1 m", "h").replace("k: 800 N/m", "k: , h: ")
    found = problem(text.replace("Y: 0.02 m", "Y: ") + "dampers: {d: {c: c, between: [base, b]}}\n")
    values = {"k": 7.0, "h": 2.0, "c": 3.0, "Y": 0.3, "W": 5.0, "m": 1.0, found.scene.time.name: 0.0, "x": 1.0, "x'": 0}
    assert evaluate([found.symbolic.equations.left_out[0]], Floats, values)[0] == pytest.approx(-7 * 0.3 / (4 * 2))
    values |= {"x": 0.0, "x'": 1.0}
    assert evaluate([found.symbolic.equations.left_out[0]], Floats, values)[0] == pytest.approx(-3 * 0.3 / (2 * 2))


@pytest.mark.sweep
def test_all_problems(monkeypatch):
    some = driven = 0
    for path in FILES:
        text = path.read_bytes()
        if b"t" not in text or not (b"forces:" in text or b"cos" in text or b"sin" in text):
            continue
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or not found.scene.timed or "damping" in found.spec.sections:
            continue        # full equations leave the damping of the whole scene out
        if found.symbolic.equations.refusal or not found.symbolic.equations.full:
            assert not found.symbolic.equations.left_out
            continue
        some += 1
        parts = parts_of(found, monkeypatch)
        driven += len(parts) > 1
        compare(found, parts)
    assert some > 20 and driven > 8
