"""Prescribed motions: displacements from the drawn position as they stand, small and full alike."""

from textwrap import dedent

import numpy as np
import pytest
from support.scenes import problem, problem_of, value

from vibcli.analyses.time_integration.integrate import simulate
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.report.sections.numeric_equations import numeric_drive
from vibcli.symbolic import normal_form
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.syntax import NameRef

MOTIONS = ["Y*(1 - exp(-r*t))", "Y*(1 - cos(w*t))", "Y*cos(w*t)", "Y + Y*sin(w*t)", "Y - Y*exp(-r*t)*cos(w*t)"]
FIGURES = {
    "a lumped body": ("bodies: {S: {slide: MOTION}, b: {mass: m, slide: x}}", "[S, b]", "S.x"),
    "a placed body": ("bodies: {S: {at: [0, 0], slide: MOTION}, b: {mass: m, at: [1 m, 0], slide: x}}",
                      "[S, b]", "S.x"),
    "a point": ("points: {S: {at: [0, 0], moves: ['MOTION', 0]}}\n"
                "bodies: {b: {mass: m, at: [1 m, 0], slide: x}}", "[S, b]", "S.x"),
    "a carrier": ("bodies: {S: {at: [0, 0], slide: MOTION}, b: {mass: m, at: [1 m, 0], slide: {by: x, carrier: S}}}",
                  "[[0, 0], b]", "b.x"),
    "beside a coordinate": ("bodies: {b: {mass: m, at: [1 m, 0], slide: x + MOTION}}", "[[0, 0], b]", "b.x"),
}
TIMES = np.array([0.0, 0.3, 1.0, 1.4])
SIGNALS = "x", "s.force", "s.stretch", "s.energy", "d.force", "V"


def scene_of(figure, motion, kind):
    bodies, ends, moved = FIGURES[figure]
    return problem(f"""
parameters: {{m: 1.3 kg, k: 80 N/m, c: 2 N*s/m, Y: 0.02 m, r: {{value: 3 s^-1, unused: allowed}},
  w: {{value: 3 rad/s, unused: allowed}}}}
coordinates: {{x: of the block}}
{bodies.replace("MOTION", motion)}
springs: {{s: {{k: k, between: {ends}, preload: 3 N}}, u: {{k: 50 N/m, between: {ends}, preload: -3 N}}}}
dampers: {{d: {{c: c, between: {ends}}}}}
initial: {{x: 0.01 m, x': 0}}
motion: {kind}
find: [{{response: {{until: 2 s}}}}]
"""), moved


def values(scene, signal):
    return scene.response.signal(NameRef(0, 0, signal, 0)).values(TIMES)


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("figure", FIGURES)
def test_a_prescribed_motion_counts_as_it_stands_small_and_full_alike(figure, motion):
    small, moved = scene_of(figure, motion, "small")
    full, _ = scene_of(figure, motion, "full")
    for signal in (*SIGNALS, moved):
        expected = values(full, signal)
        assert values(small, signal) == pytest.approx(expected, rel=1e-9, abs=1e-10 * abs(expected).max()), signal


TIED = {
    "a block": ("slide: MOTION", "y = MOTION"),
    "half of it": ("slide: MOTION", "2*y = MOTION"),
    "a cube beside it": ("slide: MOTION", "y + y^3/(1 m)^2 = MOTION"),
    "against another": ("slide: x + MOTION", "y = x + MOTION"),
    "against the sum": ("slide: MOTION - x", "x + y = MOTION"),
}


def tied(slide, constraint, motion):
    """A block x on a spring, tied by a spring and a damper to one that a drive or a constraint moves."""
    body, law = (slide.replace("MOTION", motion), "") if slide else (
        "slide: y", f"constraints: {{q: '{constraint.replace('MOTION', motion)}'}}")
    unused = ", unused: allowed}"
    return problem(f"""
parameters: {{m: 1.3 kg, k: 80 N/m, c: 2 N*s/m, Y: {{value: 0.02 m{unused}, r: {{value: 3 s^-1{unused},
  w: {{value: 3 rad/s{unused}, v: {{value: 0.3 m/s{unused}}}
coordinates: [x{'' if slide else ', y'}]
bodies: {{b: {{mass: m, slide: x}}, S: {{mass: 2*m, {body}}}}}
springs: {{s: {{k: k, between: [S, b]}}, u: {{k: k/3, between: [ground, b]}}}}
dampers: {{d: {{c: c, between: [S, b]}}}}
{law}
""")


@pytest.mark.parametrize("motion", ["Y*(1 - exp(-r*t))", "Y*(1 - cos(w*t))", "Y - Y*exp(-r*t)*cos(w*t)", "v*t"])
@pytest.mark.parametrize("kind", TIED)
def test_a_constraint_in_time_drives_as_a_prescribed_motion_does(kind, motion):
    """None of what it prescribes is there at rest, constants included."""
    slide, constraint = TIED[kind]
    if kind == "a cube beside it" and motion == "v*t":
        pytest.skip("far from small")
    if kind == "half of it":
        slide = slide.replace("MOTION", f"({motion})/2")
    one, other = tied(slide, None, motion), tied(None, constraint, motion)
    assert other.configuration.equilibrium.values["x"] == one.configuration.equilibrium.values["x"]
    assert motion == "v*t" or not other.configuration.equilibrium.values["x"]
    scale = abs(values(one, "x")).max()
    for signal in ("x", "s.force", "d.force"):
        assert values(other, signal) == pytest.approx(values(one, signal), rel=1e-9, abs=1e-9 * scale), signal


LINKAGE = """
parameters: {{W: 3 rad/s, A: 1e-6}}
points: {{P: {{body: crank, at: [0.3 m, 0.2 m]}}, E: {{body: rod, at: [1 m, 0]}}}}
bodies:
  crank: {{at: [0, 0], pin: "{motion}"}}
  rod: {{shape: rod, mass: 0.5 kg, from: [0.3 m, 0.2 m], to: [1 m, 0], pin: {{at: P, by: psi}}}}
  piston: {{mass: 1 kg, at: [1 m, 0], slide: x}}
  bob: {{mass: 1 kg, at: [2 m, 0], slide: y}}
constraints: {{c: {{join: [E, piston]}}}}
springs: {{s: {{k: 30 N/m, between: [piston, bob]}}}}
dampers: {{d: {{c: 0.3 N*s/m, between: [piston, bob]}}}}
motion: {kind}
find: [{{response: {{until: 2 s}}}}]
"""


@pytest.mark.sweep
@pytest.mark.parametrize("motion", ["A*sin(W*t)", "A*cos(W*t)", "A*(1 - exp(-2*W*t))"])
def test_what_is_tied_to_a_driven_body_vibrates_with_it(motion):
    """A small motion of the crank of a closed loop: to first order as by the full equations."""
    small, full = (problem(LINKAGE.format(motion=motion, kind=kind)) for kind in ("small", "full"))
    assert small.configuration.equilibrium.values["y"] == pytest.approx(0, abs=1e-14)
    for signal in ("y", "x", "psi", "s.force", "d.force", "rod.y", "crank.drive", "piston.reaction.y", "rod.reaction.x",
                   "c.force.x", "T", "V"):
        expected = values(full, signal)
        assert values(small, signal) == pytest.approx(expected, abs=1e-4 * abs(expected).max()), signal


@pytest.mark.parametrize(("shaken", "refused"), [("[A*cos(W*t), 0]", False), ("[0, A*cos(W*t)]", True)])
def test_a_pendulum_on_a_link_that_is_shaken_upwards_has_no_frequencies(shaken, refused):
    scene = problem(f"""
        gravity: 10 m/s^2
        parameters: {{A: 0.01 m, W: 3 rad/s}}
        points: {{S: {{at: [0, 0], moves: {shaken}}}}}
        bodies: {{bob: {{mass: 2 kg, at: [0, -1 m], move: [x, y, 0]}}}}
        constraints: {{tie: {{link: [bob, S]}}}}
        """)
    if refused:
        with pytest.raises(PhysicsError, match="depends on the time"):
            value(scene, "omega[1]")
    else:
        assert value(scene, "omega[1]") == pytest.approx(10**0.5, rel=1e-12)


CRADLE = """
    gravity: 10 m/s^2
    parameters: {{A: 0.001 rad, W: 5 rad/s, L: 0.5 m, e: 0.1 m}}
    motion: {kind}
    initial: {{q: 0 rad, q': 0 rad/s}}
    {support}
    bodies:
      {cradle}
      bob: {{mass: 2 kg, at: [0, -e - L], pin: {{at: {pivot}, by: q}}}}
    """
ROCKED = {"support": "", "pivot": "[0, -e], carrier: cradle",
          "cradle": "cradle: {mass: 1 kg, inertia: 1 kg*m^2, at: [0, 0], pin: {at: [0, 0], by: A*sin(W*t)}}"}
MOVED = {"support": "points: {P: {at: [0, -e], moves: [e*A*sin(W*t), 0]}}", "pivot": "P", "cradle": ""}


def test_a_rocked_pivot_is_in_first_order_one_that_moves_sideways():
    """Masses follow a driven displacement as it stands, so that the rocked one is refused."""
    with pytest.raises(PhysicsError, match="depends on the time"):
        value(problem(CRADLE.format(**ROCKED, kind="small")), "omega[1]")
    rocked, moved = problem(CRADLE.format(**ROCKED, kind="full")), problem(CRADLE.format(**MOVED, kind="small"))
    assert value(moved, "omega[1]") == pytest.approx(20**0.5, rel=1e-12)
    expected = values(rocked, "bob.angle")
    assert values(moved, "bob.angle") == pytest.approx(expected, abs=1e-4 * abs(expected).max())


ENERGIES = {
    "a cart, a spring and a damper": """
        initial: {x: 0.02 m}
        bodies: {cart: {mass: 5 kg, slide: MOTION}, b: {mass: 2 kg, slide: x}}
        springs: {s: {k: 80 N/m, between: [cart, b]}}
        dampers: {d: {c: 0.7 N*s/m, between: [cart, b]}}
        forces: {f: {at: cart, force: 3 N}, g: {at: b, force: -2 N*s/m*x'}}""",
    "a slider on a driven arm that has weight": """
        gravity: 9.81 m/s^2
        initial: {x: 0.02 m}
        bodies:
          arm: {shape: rod, mass: 3 kg, from: [0, 0], to: [1 m, 0], pin: {at: [0, 0], by: MOTION/(1 m)}}
          bead: {mass: 1 kg, at: [0.4 m, 0], slide: {by: x, carrier: arm}}
        springs: {s: {k: 90 N/m, between: [[0, 0], bead]}}""",
    "a crank, a rod and a piston with a bob": """
        gravity: 9.81 m/s^2
        initial: {x: 0.02}
        points: {P: {body: crank, at: [0.3 m, 0.2 m]}, E: {body: rod, at: [1 m, 0]}}
        bodies:
          crank: {mass: 2 kg, inertia: 0.1 kg*m^2, at: [0, 0.1 m], pin: {at: [0, 0], by: MOTION/(1 m)}}
          rod: {shape: rod, mass: 0.5 kg, from: [0.3 m, 0.2 m], to: [1 m, 0], pin: {at: P, by: psi}}
          piston: {mass: 1 kg, at: [1 m, 0], slide: z}
          bob: {mass: 1 kg, at: [1 m, -0.5 m], pin: {carrier: piston, at: [1 m, 0], by: x}}
        constraints: {c: {join: [E, piston]}}
        dampers: {d: {c: 0.2 N*s/m, between: [piston, [2 m, 0]]}}""",
}


@pytest.mark.parametrize("motion", ["Y*sin(w*t)", "Y*cos(w*t)", "2*w*Y*t", "w*Y*ramp(t - 0.4 s)",
                                    "Y*w^2*ramp(t - 0.3 s)^2"])
@pytest.mark.parametrize("figure", ENERGIES)
def test_the_work_of_what_drives_a_motion_balances_its_energies(figure, motion):
    """T + V of all that moves, what is driven included."""
    one = problem("""
parameters: {Y: 0.1 m, w: 3 rad/s}
motion: full
find: [{response: {until: 1.5 s}}]
""" + dedent(ENERGIES[figure]).replace("MOTION", motion))
    balance = one.response.trajectory().balance
    assert balance.error < 1e-10


@pytest.mark.parametrize(("figure", "drive", "lost"), [
    ("a slider on a driven arm that has weight", "arm.drive", None),
    ("a crank, a rod and a piston with a bob", "crank.drive", "d.power")])
def test_the_power_of_a_drive_is_what_the_energies_gain(figure, drive, lost):
    one = problem("""
parameters: {Y: 0.1 m, w: 3 rad/s}
motion: full
find: [{response: {until: 1.5 s}}]
""" + dedent(ENERGIES[figure]).replace("MOTION", "Y*sin(w*t)"))
    gained = sum(one.response.signal(NameRef(0, 0, name, 1)).values(TIMES) for name in "TV")
    spent = gained + (values(one, lost) if lost else 0.0)
    assert values(one, drive) * 0.3 * np.cos(3 * TIMES) == pytest.approx(spent, rel=1e-9, abs=1e-9 * abs(spent).max())


@pytest.mark.parametrize("kind", ["small", "full"])
def test_where_all_is_prescribed(kind):
    """A rod on two driven wheels is turned as they are; the force on a driven cart is its inertia and its weight."""
    one = problem(f"""
        gravity: 10 m/s^2
        parameters: {{a: 0.2 m, w: 3 rad/s}}
        bodies:
          cart: {{mass: 2 kg, at: [0, 0], slide: {{along: [3, 4], by: a*(1 - cos(w*t))}}}}
          wheel: {{inertia: 0.5 kg*m^2, at: [1 m, 0], pin: {{at: [1 m, 0], by: 2*w*t}}}}
        forces: {{push: {{at: cart, force: [5 N, 0]}}}}
        motion: {kind}
        """)
    acceleration = 0.2 * 9 * np.cos(3 * TIMES)
    assert values(one, "cart.drive") == pytest.approx(2 * acceleration + 2 * 10 * 0.8 - 5 * 0.6, rel=1e-12)
    assert values(one, "cart.reaction.x") == pytest.approx(2 * acceleration * 0.6 - 5, rel=1e-12)
    assert values(one, "cart.y") == pytest.approx(0.16 * (1 - np.cos(3 * TIMES)), rel=1e-12)
    assert values(one, "T") == pytest.approx((0.6 * np.sin(3 * TIMES)) ** 2 + 0.25 * 36, rel=1e-12)
    assert values(one, "wheel.drive") == pytest.approx(0, abs=1e-12)
    assert one.response.signal(NameRef(0, 0, "cart.x", 2)).values(TIMES) == pytest.approx(0.6 * acceleration)


def test_a_record_and_an_impulse_in_one_force(tmp_path):
    """With nothing else: m x' is the integral of the record up to the blow, and P more from then on."""
    (tmp_path / "f.csv").write_text("0, 1\n1, 2\n2, 2\n", encoding="utf-8")
    scene = tmp_path / "scene.yaml"
    scene.write_text("""
parameters: {P: 3 N*s, F: 4 N}
records: {f: {file: f.csv}}
bodies: {b: {mass: 2 kg, slide: x}}
forces: {push: {at: b, force: F*f(t) + P*impulse(t - 0.5 s)}}
initial: {x: 0 m}
motion: full
find: [{response: {until: 1.5 s}}]
""", encoding="utf-8")
    speed = problem_of(scene).response.signal(NameRef(0, 0, "x", 1)).values(np.array([0.4, 0.6, 1.0]))
    assert speed == pytest.approx([4 * 0.48 / 2, (4 * 0.78 + 3) / 2, (6 + 3) / 2], rel=1e-10)


LONG = """
parameters: {m2: 1.62 kg, w1: 150.6 mm, m3: 0.9493 kg, r1: 20.71 cm, a1: 35.64 deg, b1: 163 deg, m4: 1.716 kg,
  r2: 0.1217 m, a2: 134.2 deg, b2: 97.05 deg, k1: 2.677 N/mm, Y1: 29.45 mm, k2: 318.4 N/m, U1: 0.01682 kg*m,
  W2: 10.06 rad/s}
points:
  A: {body: b, at: [0.212 m, -0.401 m]}
  S: {at: [0.195 m, 0.093 m], moves: [Y1*(1 - exp(-t/(0.112 s))), 0]}
bodies:
  b:
    parts:
      - {shape: disc, mass: m2, radius: w1, at: [0.115 m, -0.401 m]}
      - {shape: sector, mass: m3, radius: r1, half_angle: a1, angle: b1, at: [0.384 m, -0.301 m]}
      - {shape: sector, mass: m4, radius: r2, half_angle: a2, angle: b2, at: [0.322 m, -0.201 m]}
    slide: {by: x, along: [-0.914, -0.405]}
springs:
  s: {k: k1, between: [A, [-0.605 m, -0.763 m]], free_length: 0.875 m}
  r: {k: k2, between: [S, b]}
forces: {f: {at: b, unbalance: U1, speed: W2}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("most", [None, 40])
def test_what_drives_is_the_same_in_numbers_however_long_its_letters_are(most, monkeypatch):
    """With `most` terms allowed the letters are too long to be multiplied out."""
    scene = problem(LONG)
    drive = scene.symbolic.equations.drive[0]
    values = [evaluate([drive], Floats, {**scene.configuration.at_rest, "t": t})[0] for t in (0.1, 0.7, 3.0)]
    if most is not None:
        monkeypatch.setattr(normal_form, "MOST", most)
        with pytest.raises(normal_form.TooLong):
            normal_form.expanded(drive)
    row = numeric_drive(scene, scene.symbolic.equations, 0)
    assert 3 <= len(row) <= 4
    for t, wanted in zip((0.1, 0.7, 3.0), values, strict=True):
        at = {**scene.configuration.at_rest, "t": t}
        assert sum(c * evaluate([node], Floats, at)[0] for c, node in row) == pytest.approx(
            wanted, rel=1e-13)


def test_a_constant_that_drives_stands_without_a_factor_one(capsys, tmp_path):
    path = tmp_path / "cam.yaml"
    path.write_text("parameters: {k: 80 N/m}\nsprings: {s: {k: k, between: [S, B]}}\nbodies:\n"
                    "  B: {mass: 1 kg, at: [1 m, 0], slide: x}\n"
                    "  S: {at: [0, 0], slide: 0.02 m*(1 - cos(3 rad/s*t))}\n")
    assert run(["equations", str(path)]) == 0
    assert "ẍ + 80·x = 1.6 − 1.6·cos(3·t)\n" in capsys.readouterr().out


CORNERS = """
motion: full
parameters: {{Y: 0.1 m, w: {{value: 3 rad/s, unused: allowed}}}}
bodies:
  cart: {{mass: 1 kg, at: [0, 0], slide: {{along: [1, 0], by: "Y*({})"}}}}
  b: {{mass: 2 kg, at: [1 m, 0], slide: {{along: [1, 0], by: x{}}}}}
springs: {{s: {{k: 80 N/m, between: [cart, b]}}}}
dampers: {{d: {{{}, between: [cart, b]}}}}
initial: {{x: 0}}
"""


@pytest.mark.parametrize("damper", ["c: 3 N*s/m", "friction: 1 N"])
@pytest.mark.parametrize("carrier", ["", ", carrier: cart"])
@pytest.mark.parametrize("drive", ["abs(sin(w*t))", "1 + abs(sin(w*t) - 0.3)", "abs(cos(w*t)) + sin(w*t)"])
def test_energies_balance_where_a_drive_turns_at_another_speed(drive, carrier, damper):
    found = simulate(problem(CORNERS.format(drive, carrier, damper)).configuration, 3.0, initial={"x": 0.0})
    assert found.end == 3.0 and found.balance.error < 1e-13 and found.balance.driving[-1]
