"""Outputs and inputs of the small oscillations: against Newton's law for the whole, textbook scenes, all problems."""

import math
from pathlib import Path

import numpy as np
import pytest
from support.scenes import kept_problem_of, problem, value

from vibcli.analyses.excitation.signal_outputs import linear_output, quadratic_output
from vibcli.analyses.frequency_response.evaluate import frf
from vibcli.analyses.frequency_response.transfer_function import transfer
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.inputs import named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.notation.plain import plain
from vibcli.symbolic.evaluation import Floats, evaluate

OMEGA = np.array([0.7, 3.1, 9.0, 40.0])
FILES = sorted(Path(__file__).parents[3].glob("problems/*/*.yaml"))

PENDULUMS = """
    parameters: {m1: 2 kg, m2: 3 kg, J: 0.2 kg*m^2, L: 0.7 m, h: 0.3 m, g: 9.81 m/s^2, k: 40 N/m, c: 2 N*s/m, F: 5 N}
    gravity: g
    points:
      O: [0, 0]
      A: {body: rod, at: [0, -L]}
      B: {body: bob, at: [h, -L - h]}
    bodies:
      rod: {mass: m1, inertia: J, at: [0, -L/2], pin: {at: O, by: phi}}
      bob: {mass: m2, inertia: J, at: [0, -L - h], pin: {at: A, by: psi}}
    springs:
      s: {k: k, between: [[2*L, -L], A], preload: static}
    dampers:
      d: {c: c, between: [[-L, -L - h], bob]}
    forces:
      drive: {at: B, force: [0.6*F*sin(3 rad/s*t), 0.8*F*sin(3 rad/s*t)]}
"""

ROLLER = """
    parameters: {m: 4 kg, r: 0.2 m, k: 300 N/m, c: 3 N*s/m, g: 9.81 m/s^2, Y: 1 cm}
    gravity: g
    points:
      W: {at: [-1 m, 0], moves: [Y*cos(4 rad/s*t), 0]}
    surfaces:
      floor: {line: [[0, -r], [1 m, -r]]}
    bodies:
      disc: {shape: disc, mass: m, radius: r, at: [0, 0], roll: {surface: floor, travel: x}}
    springs:
      s: {k: k, between: [W, disc]}
    dampers:
      d: {c: c, between: [W, disc]}
"""

HOIST = """
    parameters: {m: 4 kg, M: 6 kg, J: 0.3 kg*m^2, r: 0.2 m, k: 900 N/m, c: 20 N*s/m, g: 9.81 m/s^2, F: 3 N}
    gravity: g
    bodies:
      drum: {mass: M, inertia: J, shape: disc, radius: r, at: [0, 0], pin: {by: phi}}
      load: {mass: m, at: [r, -1 m], slide: {along: [0, 1], by: y}}
    springs:
      s: {k: k, between: [[-r, -1 m], hook], preload: static}
    dampers:
      d: {c: c, between: [[r, -2 m], load]}
    points:
      hook: {body: drum, at: [-r, 0]}
    constraints:
      cable: {rope: [{right_of: drum}, load]}
    forces:
      pull: {at: load, force: [0, F*sin(2 rad/s*t)]}
"""


def response(scene, signal, driven_by, order=0):
    return frf(transfer(scene.configuration, signal, driven_by, order), OMEGA)


def acceleration(scene, signal, driven_by):
    return response(scene, signal, driven_by, 2)


def test_reaction_of_the_pin_is_newtons_law_for_the_whole():
    scene = problem(PENDULUMS)
    masses = {"rod": 2.0, "bob": 3.0}
    for axis, force in (("x", 0.6), ("y", 0.8)):
        moved = sum(mass * acceleration(scene, f"{body}.{axis}", "drive") for body, mass in masses.items())
        held = response(scene, f"ground.force.{axis}", "drive")
        found = response(scene, f"O.reaction.{axis}", "drive")
        assert found + force - held == pytest.approx(moved, rel=1e-10, abs=1e-10)


def test_moment_about_the_pin():
    """The momentum about O changes by the moments of the drive, the weights and what holds the rods."""
    scene = problem(PENDULUMS)
    inner = response(scene, "bob.reaction.x", "drive"), response(scene, "bob.reaction.y", "drive")
    assert inner[0] + 0.6 - _pull(scene, "d", "x") == pytest.approx(3 * acceleration(scene, "bob.x", "drive"), rel=1e-9)
    assert inner[1] + 0.8 - _pull(scene, "d", "y") == pytest.approx(3 * acceleration(scene, "bob.y", "drive"), rel=1e-9,
                                                                    abs=1e-10)


def _pull(scene, name, axis):
    """What the damper exerts on the ground: its force along x, where it is drawn."""
    return response(scene, f"{name}.force", "drive") if axis == "x" else 0.0


def test_friction_and_normal_force_of_a_driven_roller():
    scene = problem(ROLLER)
    assert response(scene, "disc.friction", "W") == pytest.approx(
        0.5 * 4.0 * 0.2**2 * acceleration(scene, "disc.angle", "W") / 0.2, rel=1e-12)
    assert response(scene, "disc.normal", "W") == pytest.approx(np.zeros(4), abs=1e-12)
    assert linear_row(scene.configuration, "disc.normal").constant == pytest.approx(4 * 9.81)
    held = response(scene, "ground.force.x", "W")
    total = response(scene, "disc.reaction.x", "W") - held
    assert total == pytest.approx(4 * acceleration(scene, "x", "W"), rel=1e-12)


def test_cable_with_inertia():
    scene = problem(HOIST)
    pulled = response(scene, "cable.force", "pull") + 1 - response(scene, "d.force", "pull")
    assert pulled == pytest.approx(4 * acceleration(scene, "y", "pull"), rel=1e-12)
    assert linear_row(scene.configuration, "cable.force").constant == pytest.approx(4 * 9.81)
    bearing = response(scene, "drum.reaction.y", "pull") - response(scene, "cable.force", "pull")
    assert bearing == pytest.approx(response(scene, "s.force", "pull"), rel=1e-12)


def test_a_force_without_work_acts_on_the_reaction():
    scene = problem("""
        parameters: {m: 2 kg, k: 50 N/m, F: 3 N}
        bodies: {block: {mass: m, at: [0, 0], slide: x}}
        springs: {s: {k: k, between: [[-1 m, 0], block]}}
        forces: {drive: {at: block, force: [3*F, 4*F]}}
    """)
    assert response(scene, "block.reaction.y", "drive") == pytest.approx(np.full(4, -0.8))
    assert response(scene, "x", "drive") == pytest.approx(0.6 / (50 - 2 * OMEGA**2))


BASE = """
    parameters: {m: 5 kg, k: 2 kN/m, c: 30 N*s/m, Y: 1 cm, Omega: 15 rad/s, h: 0.5 m, g: 9.81 m/s^2, me: 0.2 kg*m}
    gravity: g
    points:
      S: {at: [0, h], moves: [0, Y*sin(Omega*t)]}
    bodies:
      load: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}
    springs:
      s: {k: k, between: [S, load], preload: static}
    dampers:
      d: {c: c, between: [S, load]}
    forces:
      motor: {at: load, unbalance: me, speed: Omega}
"""


def test_base_motion_and_unbalance():
    scene, s = problem(BASE), 1j * OMEGA
    D = 2000 + 30 * s + 5 * s * s
    assert response(scene, "y", "S") == pytest.approx((2000 + 30 * s) / D, rel=1e-12)
    assert response(scene, "s.stretch", "S") == pytest.approx(5 * s * s / D, rel=1e-12)
    assert response(scene, "y", "motor") == pytest.approx(-1j * OMEGA**2 / D, rel=1e-12)
    assert response(scene, "load.reaction.x", "motor") == pytest.approx(-OMEGA**2, rel=1e-12)
    assert response(scene, "ground.force.y", "motor") == pytest.approx((2000 + 30 * s) * -1j * OMEGA**2 / D, rel=1e-12)


def test_channels_carry_what_is_driven():
    scene = problem(BASE)
    output, channels = linear_output(scene.configuration, "s.force", channel=4)
    assert output.q == {0: pytest.approx(-2000)} and output.channels == {4: 1.0}
    assert output.constant == pytest.approx(5 * 9.81)
    instant = {**scene.configuration.with_inputs.values, "t": 0.3}
    assert evaluate([channels[4]], Floats, instant)[0] == pytest.approx(2000 * 0.01 * math.sin(4.5))
    output, channels = linear_output(scene.configuration, "s.force", order=1)
    assert output.v == {0: pytest.approx(-2000)}
    assert evaluate([channels[1]], Floats, instant)[0] == pytest.approx(2000 * 0.15 * math.cos(4.5))
    assert linear_output(scene.configuration, "y''")[0].a == {0: 1.0}


def test_energy_and_power_are_squares():
    scene = problem(BASE)
    (weight, ((output, channels), again)), = quadratic_output(scene.configuration, "s.energy")
    assert again[0] == output
    assert weight == pytest.approx(1 / 4000) and output == linear_output(scene.configuration, "s.force")[0] and channels
    assert value(scene, "equilibrium[s.energy]") == pytest.approx((5 * 9.81) ** 2 / 4000)
    (weight, ((output, _), _)), = quadratic_output(scene.configuration, "d.power")
    assert weight == 30.0 and output.v == {0: pytest.approx(-1.0)}
    assert value(scene, "equilibrium[ground.force.y]") == pytest.approx(-5 * 9.81)


LUMPED = """
    parameters: {m: 2 kg, k: 30 N/m, c: 0.4 N*s/m, kt: 5 N*m, J: 0.3 kg*m^2, F: 1 N}
    bodies:
      a: {mass: m, slide: x}
      b: {mass: m, slide: y}
      wheel: {inertia: J, turn: phi}
      base: {slide: 1 cm*sin(2 rad/s*t)}
    springs:
      s: {k: k, between: [ground, a]}
      w: {k: k, between: [b, base]}
      t: {torsion: kt, between: [ground, wheel]}
    dampers:
      d: {c: c, between: [a, b]}
    forces:
      drive: {at: a, force: -F*sin(2 rad/s*t)}
      turning: {body: wheel, moment: F*(1 m)}
      general: {coordinate: y, value: F}
"""


def test_lumped_bodies():
    scene = problem(LUMPED)
    total = response(scene, "ground.force", "drive")
    assert total == pytest.approx(30 * (response(scene, "x", "drive") + response(scene, "y", "drive")), rel=1e-12)
    moved = 2 * (acceleration(scene, "a.x", "drive") + acceleration(scene, "b.x", "drive"))
    assert -1 - total == pytest.approx(moved, rel=1e-12)           # the force is written against the axis
    assert response(scene, "ground.moment", "turning") == pytest.approx(5 * response(scene, "phi", "phi"), rel=1e-12)
    assert response(scene, "y", "general") == pytest.approx(response(scene, "y", "y"), rel=1e-12)
    assert response(scene, "x", "base") == pytest.approx(30 * response(scene, "x", "y"), rel=1e-12)


@pytest.mark.parametrize("name", ["wind", "O", "rod.x"])
def test_what_is_no_input(name):
    with pytest.raises(PhysicsError, match="drives this scene"):
        named_input(problem(PENDULUMS).configuration, name)


def test_a_force_that_turns_has_no_line():
    scene = problem("""
        parameters: {m: 2 kg, k: 50 N/m, F: 3 N}
        bodies: {block: {mass: m, at: [0, 0], slide: x}}
        springs: {s: {k: k, between: [[-1 m, 0], block]}}
        forces: {drive: {at: block, force: [F*cos(2 rad/s*t), F*sin(2 rad/s*t)]}}
    """)
    with pytest.raises(PhysicsError, match="no line"):
        named_input(scene.configuration, "drive")
    assert response(scene, "x", "drive.x") == pytest.approx(1 / (50 - 2 * OMEGA**2))
    assert response(scene, "block.reaction.y", "drive.y") == pytest.approx(np.full(4, -1.0))


def test_of_dependent_coordinates():
    """x2 = 2·x1: a unit force along x2 works twice as much."""
    scene = problem("""
        parameters: {m: 2 kg, k: 50 N/m}
        coordinates: {x1: one, x2: two}
        bodies: {a: {mass: m, slide: x1}, b: {mass: m, slide: x2}}
        springs: {s: {k: k, between: [ground, a]}}
        constraints: {lever: x2 = 2*x1}
    """)
    assert response(scene, "x2", "x1") == pytest.approx(2 / (50 - 10 * OMEGA**2))
    assert response(scene, "x2", "x2") == pytest.approx(4 / (50 - 10 * OMEGA**2))
    tie = 2 * acceleration(scene, "x2", "x2") - 1      # G = x2 − 2·x1 holds x2 back by λ
    assert response(scene, "lever.force", "x2") == pytest.approx(-tie, rel=1e-12)


def test_of_points_that_springs_hold_before_loops_close():
    scene = problem("""
        parameters: {m: 2 kg, k: 50 N/m}
        points: {P: {body: b, at: [2 m, 0]}}
        bodies:
          a: {mass: m, at: [0, 0], slide: {along: [0, 1], by: x}}
          b: {mass: m, at: [2 m, 0], slide: {along: [0, 1], by: y}}
        springs: {s: {k: k, between: [[0, 1 m], a]}, u: {k: k, between: [[2 m, 3 m], P]}}
        constraints: {lever: y = 2*x}
    """)
    assert value(scene, "mode[1, P.y]") == pytest.approx(2.0)
    assert response(scene, "P.y", "x") == pytest.approx(2 / (250 - 10 * OMEGA**2))


def at_start(scene, node):
    return evaluate([node], Floats, scene.configuration.with_inputs.values)[0]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_equilibrium_values_of_all_signals(path):
    """The constant of every output is the value in equilibrium, found by other ways."""
    scene = kept_problem_of(path)
    try:
        scene.configuration.linear_system  # noqa: B018
    except PhysicsError:
        pytest.skip("no equilibrium in numbers")
    spec = scene.spec
    signals = list(spec.coordinates)
    signals += [f"{name}.{part}" for name, body in scene.scene.bodies.items() for part in ("x", "y", "angle")
                if body.frame is not None]
    signals += [f"{name}.{part}" for name in (spec.get("springs") or {}) for part in ("stretch", "force")]
    known = [reaction for reaction in scene.configuration.reactions if reaction.value is not None]
    refused = 0
    for signal in signals:
        try:
            row = linear_row(scene.configuration, signal)
        except PhysicsError:
            refused += 1
            continue
        constant = row.constant + sum(factor * at_start(scene, node) for factor, node in row.time)
        assert constant == pytest.approx(value(scene, f"equilibrium[{signal}]"), rel=1e-9, abs=1e-12)
    size = max((abs(reaction.value) for reaction in known), default=0.0) or 1.0
    for reaction in known:
        try:
            row = linear_row(scene.configuration, reaction.signal)
        except PhysicsError:
            refused += 1
            continue
        drawn = row.constant + sum(factor * at_start(scene, node) for factor, node in row.time)
        wanted = pytest.approx(reaction.value, rel=1e-8, abs=1e-8 * size)
        assert row.constant == wanted or drawn == wanted    # at t = 0, where a carrier turns
    assert refused == 0 or scene.scene.timed or scene.scene.members      # no reactions in motion with members


def test_a_support_that_moves_by_a_pulse_is_an_input():
    """Its static preload is that at rest, and its displacement drives, as a sine would."""
    text = """
        parameters: {m: 4 kg, k: 900 N/m, c: 20 N*s/m, h: 5 cm, t1: 0.2 s, L: 0.5 m, g: 9.81 m/s^2}
        gravity: g
        points: {W: {at: [0, -L], moves: [0, %s]}}
        bodies: {car: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
        springs: {s: {k: k, between: [W, car], preload: static}}
        dampers: {d: {c: c, between: [W, car]}}
    """
    pulse = problem(text % "h*sin(pi*t/t1)*(step(t) - step(t - t1))")
    assert linear_row(pulse.configuration, "s.force").constant == pytest.approx(-4 * 9.81)
    assert response(pulse, "y", "W") == pytest.approx(response(problem(text % "h*sin(pi*t/t1)"), "y", "W"))


@pytest.mark.sweep
def test_forces_at_rest_in_letters_have_lengths_as_drawn_and_no_common_factors():
    """A rope whose length is |2b(e/h − 1)| as drawn, between the legs of a ladder."""
    path = next(path for path in FILES if path.stem == "step_ladder_with_a_man")
    values = kept_problem_of(path).symbolic.reactions.values
    assert plain(values["tie.force"]) == "b·g·(2·m₁ + 2·m₂ + 3·M)/(8·(h − e))"
    assert plain(values["left.reaction.y"]) == "g·(6·m₁ + 2·m₂ + 5·M)/8"


def test_lengths_at_rest_have_no_sign_that_letters_leave_open():
    """Of a rope whose length is |2b(1 − e/h)| for either sign of b, and for e on both sides of h; letters that come in
    this order have samples of which the first are all alike."""
    letters = "F: , h: , b: {sign: any}, " + "".join(f"{name}: {{unused: allowed}}, " for name in "uvw") + "e: "
    text = f"""
        parameters: {{{letters}}}
        points:
          A: [-b, 0]
          left: {{body: one, at: [-b*(1 - e/h), e]}}
          right: {{body: two, at: [b*(1 - e/h), e]}}
        bodies:
          one: {{shape: rod, mass: 1, from: A, to: [0, h], pin: {{at: A, by: phi}}}}
          two: {{shape: rod, mass: 1, from: [b, 0], to: [0, h], pin: {{at: [b, 0], by: psi}}}}
        constraints: {{even: psi = -phi, tie: {{rope: [left, right]}}}}
        forces: {{push: {{at: left, force: [-F, 0]}}}}
    """
    node = problem(text).symbolic.reactions.values["tie.force"]
    for b, e, h in ((0.7, 1.0, 2.0), (0.7, 2.0, 1.0), (-0.7, 1.0, 2.0)):
        found = evaluate([node], Floats, {"b": b, "e": e, "h": h, "F": 3.0})[0]
        assert found == pytest.approx(1.5 * (1 if b * (1 - e / h) > 0 else -1))


def test_what_holds_along_an_axis_pulls_for_letters_of_either_sign():
    """F in a link, and where a spring under preload rests, of a block that lies to the left or right of the ground."""
    scene = """
        parameters: {{a: {{sign: any}}, F: , N: , k: {{unused: allowed}}}}
        bodies: {{b: {{mass: 1, at: [a, 0], slide: {{along: [1, 0], by: x}}}}}}
        forces: {{f: {{at: b, force: [F + N, 0]}}}}
        {}
    """
    held = problem(scene.format("constraints: {hold: {link: [[0, 0], b]}}"))
    sprung = problem(scene.format("springs: {s: {k: k, between: [[0, 0], b], preload: N}}"))
    force = held.symbolic.reactions.values["hold.force"]
    place = sprung.symbolic.equilibrium_position["x"]
    for a in (0.7, -0.7):
        values, sign = {"a": a, "F": 3.0, "N": 2.0, "k": 10.0}, 1 if a > 0 else -1
        assert evaluate([force], Floats, values)[0] == pytest.approx(5.0 * sign)
        assert evaluate([place], Floats, values)[0] == pytest.approx((5.0 - 2.0 * sign) / 10)
