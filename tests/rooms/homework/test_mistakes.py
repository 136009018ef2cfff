"""Each mistake of the catalogue against its closed form, by the quantity that it is made of."""

from functools import partial
from math import pi, sqrt
from pathlib import Path

import pytest

import vibcli.homework.mistakes
from vibcli.api.source import problem_of, text_source
from vibcli.api.values import quantity_asked
from vibcli.base.work import Work
from vibcli.check.verdicts import check
from vibcli.cli.common import known_mistake
from vibcli.cli.program import run
from vibcli.homework.mistakes import FORMULA, MISTAKES, MODEL, READING, known
from vibcli.homework.mistakes.known import by_kind, of_catalogue
from vibcli.homework.mistakes.springs import lever_ratio
from vibcli.inverse import settled
from vibcli.language import data_columns
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import value_of

OSCILLATOR = """
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m, F: 10 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {d: {c: c, between: [ground, block]}}
forces: {pull: {at: block, force: F*sin(30 rad/s*t)}}
"""
FREE = OSCILLATOR.replace(", F: 10 N", "").partition("forces")[0] + "initial: {x: 1 cm}\n"
TWO = """
parameters: {k: 800 N/m}
bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 1 kg, slide: y}}
springs: {s: {k: k, stretch: x}, t: {k: k, stretch: y - x}}
"""
ROD = """
gravity: 9.81 m/s^2
parameters: {m: 3 kg, L: 0.8 m}
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
"""
DISC = """
gravity: 9.81 m/s^2
bodies: {disc: {shape: disc, mass: 3 kg, radius: 0.2 m, at: [0, -0.5 m], pin: {at: [0, 0], by: phi}}}
"""
ROLLER = """
surfaces: {floor: {line: [[-1 m, 0], [1 m, 0]]}}
bodies: {disc: {shape: disc, mass: 2 kg, radius: 0.1 m, at: [0, 0.1 m], roll: {surface: floor, travel: x}}}
springs: {s: {k: 300 N/m, between: [[-0.5 m, 0.1 m], disc]}}
"""
DRUM = """
bodies:
  drum: {shape: disc, mass: 4 kg, radius: 0.2 m, at: [0, 0], pin: {at: [0, 0], by: phi}}
  load: {mass: 1 kg, slide: {by: 0.2 m*phi}, at: [0.2 m, -1 m]}
springs: {s: {k: 500 N/m, stretch: 0.2 m*phi}}
"""
PLANK = """
bodies:
  plank: {shape: rod, mass: 3 kg, from: [-1 m, 0], to: [1 m, 0], pin: {at: [0, 0], by: phi}}
  load: {mass: 0.5 kg, at: [1 m, 0], weld: plank}
springs: {s: {torsion: 100 N*m, between: [ground, plank]}}
"""
PAIR = """
parameters: {k1: 300 N/m, k2: 600 N/m}
bodies: {block: {mass: 2 kg, at: [0, 0], slide: x}}
springs: {s: {k: k1, between: [[-1 m, 0], block]}, t: {k: k2, between: [[-1 m, 0], block]}}
"""
ROW = """
parameters: {k1: 300 N/m, k2: 600 N/m}
bodies: {block: {mass: 2 kg, slide: x}}
springs: {s: {series: [{k: k1}, {k: k2}], between: [ground, block]}}
"""
LEVER = """
parameters: {a: 0.4 m}
bodies: {bar: {shape: rod, mass: 3 kg, from: [0, 0], to: [1 m, 0], pin: {at: [0, 0], by: phi}}}
springs: {s: {k: 900 N/m, stretch: a*phi}}
"""
TAUT = """
bodies: {bead: {mass: 0.1 kg, at: [0, 0], slide: {by: y, along: [0, 1]}}}
springs:
  left: {k: 100 N/m, between: [[-1 m, 0], bead], preload: 40 N}
  right: {k: 100 N/m, between: [[1 m, 0], bead], preload: 40 N}
"""
MOUNTS = """
parameters: {k: 300 N/m, a: 30 deg, R: 1 m}
bodies: {bead: {mass: 2 kg, at: [0, 0], move: [x, y, 0]}}
springs:
  s: {k: k, between: [[R*cos(a), R*sin(a)], bead]}
  t: {k: k, between: [[R*cos(a), -R*sin(a)], bead]}
"""


SLOPE = """
gravity: 10 m/s^2
parameters: {k: 1 kN/m, a: 30 deg}
bodies: {block: {mass: 2 kg, at: [0, 0], slide: {along: [-cos(a), -sin(a)], by: x}}}
springs: {s: {k: k, stretch: x}}
"""


def wrong(scene, text):
    """{name of a mistake: what it gives} for a quantity of a scene."""
    source = text_source(scene)
    problem = settled(problem_of(source))
    asked = quantity_asked(problem.spec, text)
    right, found = float(value_of(problem, asked)[0]), {}
    for one in of_catalogue(problem, source.node, [asked]):
        try:
            scene = one.problem or problem
            value = one.wrong(asked, unit_of(problem.spec, asked), right,
                              lambda expression, scene=scene: float(value_of(scene, expression)[0]))
        except vibcli.base.errors.PhysicsError:
            continue
        if value is not None:
            found[one.name] = value
    return found


RATE, ZETA = sqrt(800 / 2 - 2**2), 8 / (2 * sqrt(1600))


@pytest.mark.parametrize("scene, asked, expected", [
    (OSCILLATOR, "omega_d[1]", {"cycles for radians": RATE / (2 * pi), "revolutions for radians": RATE * 30 / pi,
                                "period for frequency": 2 * pi / RATE, "natural for damped": 20.0,
                                "root forgotten": RATE**2, "half the frequency": RATE / 2,
                                "twice the frequency": 2 * RATE, "sign": -RATE}),
    (OSCILLATOR, "frequency[1]", {"radians for cycles": 20.0, "period for frequency": pi / 10}),
    (OSCILLATOR, "period[1]", {"frequency for period": 10 / pi, "damped for natural": 2 * pi / RATE,
                               "one over rate": 0.05}),
    (OSCILLATOR, "omega[1]", {"damped for natural": RATE}),
    (OSCILLATOR, "zeta[1]", {"twice the damping": 2 * ZETA, "half the damping": ZETA / 2}),
    (OSCILLATOR, "amplitude(x)", {"thousand too many": 1e4 / sqrt((800 - 1800)**2 + 240**2),
                                  "damper forgotten (d)": 0.01,
                                  "peak to peak": 20 / sqrt((800 - 1800)**2 + 240**2),
                                  "rms for amplitude": 10 / sqrt(2 * ((800 - 1800)**2 + 240**2))}),
    (OSCILLATOR, "rms(x)", {"amplitude for rms": 10 / sqrt((800 - 1800)**2 + 240**2)}),
    (FREE, "decrement(x)", {"ratio for decrement": 2 * pi * ZETA}),
    (OSCILLATOR, "peak[1](frf[x, pull]).Omega", {"natural for resonance": 20.0}),
    (OSCILLATOR, "transmissibility[ground.force, pull](30 rad/s)",
     {"force without damper": 800 / sqrt((800 - 1800)**2 + 240**2)}),
    (ROD, "omega[1]", {"inertia about centre (rod)": sqrt(9.81 * 0.4 / (0.64 / 12)),
                       "particle for body (rod)": sqrt(9.81 / 0.4)}),
    (DISC, "omega[1]", {"diameter for radius (disc)": sqrt(9.81 * 0.5 / (0.25 + 0.08)),
                        "inertia about centre (disc)": sqrt(9.81 * 0.5 / 0.02)}),
    (ROLLER, "omega[1]", {"rolling without rotation (disc)": sqrt(150), "diameter for radius (disc)": sqrt(300 / 6)}),
    (DRUM, "omega[1]", {"wheel without inertia (drum)": sqrt(500), "diameter for radius (drum)": sqrt(500 / 9)}),
    (PLANK, "omega[1]", {"particle for body (plank)": sqrt(200)}),
    (PAIR, "omega[1]", {"series for parallel (s, t)": 10.0}),
    (ROW, "omega[1]", {"parallel for series (s)": sqrt(450)}),
    (LEVER, "omega[1]", {"lever ratio once (s)": sqrt(900 * 0.4)}),
    (LEVER.replace("a*phi", "-a*phi"), "omega[1]", {"lever ratio once (s)": sqrt(900 * 0.4)}),
    (TAUT, "omega[1]", {"preload forgotten (left)": sqrt(400)}),
    (MOUNTS, "omega[2]", {"sign of an angle (a of s)": sqrt(300), "sign of an angle (a of t)": sqrt(300)}),
    (TWO, "omega[1]", {"coordinate held (x)": sqrt(800), "coordinate held (y)": sqrt(800)}),
])
def test_what_mistakes_lead_to(scene, asked, expected):
    found = wrong(scene, asked)
    assert {name: found.get(name) for name in expected} == {
        name: pytest.approx(value, rel=1e-9) for name, value in expected.items()}


def test_of_large_scenes_few_mistakes_are_solved(monkeypatch):
    source, work = text_source(TWO), Work()
    held = ["coordinate held (x)", "coordinate held (y)"]

    def solved():
        return [one.name for one in of_catalogue(problem_of(source, work=work), source.node, []) if one.kind == MODEL]

    assert solved() == held
    monkeypatch.setattr(known, "MOST", 7)
    assert solved() == held[:1]
    work.patience = 2
    assert solved() == held


def test_phase_beyond_resonance():
    right = {one.name: one for one in of_catalogue(problem_of(text_source(OSCILLATOR)), None, [])}
    assert "phase within a quarter" not in right
    found = wrong(OSCILLATOR, "phase(x)")["phase within a quarter"]
    assert abs(found) < pi / 2


def test_a_force_without_its_damper_is_one_of_a_single_degree():
    asked = "transmissibility[ground.force, pull](30 rad/s)"
    more = OSCILLATOR.replace("slide: x}}", "slide: x}, b: {mass: 1 kg, slide: y}}").replace(
        "springs: {", "springs: {t: {k: k, between: [block, b]}, ")
    assert "force without damper" in wrong(OSCILLATOR, asked) and "force without damper" not in wrong(more, asked)


def test_weight_in_the_stiffness():
    text = ROD + "springs: {s: {k: 500 N/m, stretch: L/2*phi}}\n"
    assert wrong(text, "omega[1]")["weight forgotten"] == pytest.approx(sqrt(500 * 0.16 / 0.64), rel=1e-12)


def test_a_lever_ratio_in_letters_has_no_sign():
    for sign in ("", "-"):
        text = LEVER.replace("0.4 m", "").replace("stretch: a*phi", f"stretch: {sign}a*phi")
        assert lever_ratio(problem_of(text_source(text)), "s") == "a"


def test_angles():
    text = ROD.replace("from: [0, 0], to: [0, -L]", "from: [0, 0], to: [L*sin(0.1), -L*cos(0.1)]")
    found = wrong(text, "equilibrium[phi]")
    assert found["degrees for radians"] == pytest.approx(-0.1 * 180 / pi, rel=1e-9)


def test_the_catalogue_is_its_folder():
    folder = Path(vibcli.homework.mistakes.__file__).parent
    helpers = {"__init__", "bodies", "changed", "known", "mistake", "nearest", "springs"}
    assert {path.stem for path in folder.glob("*.py")} - helpers == set(MISTAKES)
    assert len(MISTAKES) >= 25
    for name, (kind, about) in MISTAKES.items():
        one = by_kind(kind)[name]
        ways = [word for word in ("reading", "formula", "model") if getattr(one, word) is not None]
        assert len(ways) == 1 and one.sentence and about
        assert ways[0] == {READING: "reading", MODEL: "model"}.get(kind, ways[0]) != {FORMULA: "model"}.get(kind)


@pytest.mark.parametrize("scene, line, said", [
    (ROD, "omega[1]: 8.58 rad/s", "rod: this takes the moment of inertia about the mass centre for that about the pin"),
    (ROLLER, "omega[1]: 12.25 rad/s", "disc: it rolls: the energy of its rotation is forgotten"),
    (PAIR, "omega[1]: 10.00 rad/s", "s, t: these springs have the same stretch"),
    (MOUNTS, "omega[2]: 17.32 rad/s", "a of s: the sign of this angle differs"),
    (DRUM, "omega[1]: 22.36 rad/s", "drum: the moment of inertia of the wheel is forgotten"),
    (SLOPE, "equilibrium[x]: -1 cm", "the sign differs"),
])
def test_check_names_mistakes_of_the_model(scene, line, said):
    source = text_source(scene + f"answers: {{'{line.partition(':')[0]}':{line.partition(':')[2]}}}\n")
    verdict, = check(problem_of(source), partial(known_mistake, source.node))
    assert verdict.agrees is False and verdict.remark.startswith(said)
    without, = check(problem_of(source))
    assert without.remark != verdict.remark


def test_the_files_of_records_are_read_once_for_all_mistakes(tmp_path, monkeypatch, capsys):
    rows = "".join(f"{i / 10},{i % 7}\n" for i in range(100))
    (tmp_path / "a.csv").write_text(rows)
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m, c: 4 N*s/m}\nrecords: {ag: {file: a.csv, unit: m/s^2}}\n"
                    "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, stretch: x}}\n"
                    "dampers: {d: {c: c, stretch: x}}\nforces: {f: {coordinate: x, value: -m*ag(t)}}\n"
                    "answers: {x(5 s): 4 m}\n")
    reads, whole = [], data_columns.columns_in
    monkeypatch.setattr(data_columns, "columns_in", lambda *args: reads.append(args) or whole(*args))
    scenes, changed = [], known.read_changed
    monkeypatch.setattr(known, "read_changed", lambda *args: scenes.append(args) or changed(*args))
    assert run(["check", str(path)]) == 1
    assert "1 differs" in capsys.readouterr().out and len(reads) == 1 and scenes
