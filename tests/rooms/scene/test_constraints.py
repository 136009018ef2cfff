"""Constraints against results in closed form: positions, loops, redundancy, the choice of coordinates."""

import math
import random
import re
from itertools import pairwise
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import asin, cos, sin, sqrt, tan
from support.scenes import problem, problem_of, value

import vibcli
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.bench.linkage import tongs
from vibcli.mechanics.energies import kinetic, potential
from vibcli.mechanics.inputs_outputs.reactions import slack
from vibcli.mechanics.inputs_outputs.reactions_along_motion import along_the_motion
from vibcli.results.random_states import states
from vibcli.scene.closed_loops import Loops, nearby
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

PROJECT = Path(__file__).parents[3]

# dependent coordinates as functions of the independent ones: (scene, {name: function of the coordinates and t})

ATWOOD = """
    parameters: {m1: 3 kg, m2: 2 kg, J: 0.1 kg*m^2, r: 0.2 m, k: 100 N/m, g: 9.81 m/s^2}
    gravity: g
    bodies:
      left: {mass: m1, at: [-r, -1 m], slide: {along: [0, 1], by: x}}
      right: {mass: m2, at: [r, -1 m], slide: {along: [0, 1], by: y}}
      wheel: {shape: disc, radius: r, inertia: J, at: [0, 0], pin: phi}
    springs: {s: {k: k, between: [[r, -2 m], right]}}
    constraints: {cord: {rope: [left, {over: wheel}, right]}}
    """
MOVING_PULLEY = """
    bodies:
      low: {shape: disc, mass: 1 kg, radius: 0.1 m, at: [0.1 m, 0], move: [0, y, psi]}
      top: {shape: disc, mass: 1 kg, radius: 0.3 m, at: [0.5 m, 2 m], pin: chi}
      block: {mass: 1 kg, at: [0.8 m, 0], slide: {along: [0, 1], by: z}}
    constraints: {cord: {rope: [[0, 2 m], {under: low}, {over: top}, block]}}
    """
STEPPED_DRUM = """
    bodies:
      drum: {inertia: 1 kg*m^2, at: [0, 0], pin: phi}
      big: {mass: 1 kg, at: [0.3 m, -1 m], slide: {along: [0, 1], by: x}}
      small: {mass: 1 kg, at: [-0.2 m, -1 m], slide: {along: [0, 1], by: y}}
      cart: {mass: 1 kg, at: [-2 m, -0.2 m], slide: z}
    constraints:
      one: {rope: [{right_of: drum, radius: 0.3 m}, big]}
      two: {rope: [small, {left_of: drum, radius: 0.2 m}]}
      three: {rope: [cart, {under: drum, radius: 0.2 m}]}
    """
DIFFERENTIAL_HOIST = """
    bodies:
      drum: {inertia: 1 kg*m^2, at: [0, 0], pin: phi}
      low: {shape: disc, mass: 1 kg, radius: 0.25 m, at: [0.05 m, -2 m], move: [0, y, psi]}
    constraints: {chain: {rope: [{right_of: drum, radius: 0.3 m}, {under: low}, {left_of: drum, radius: 0.2 m}]}}
    """
GEARS = """
    bodies:
      arm: {mass: 1 kg, at: [0, 0], pin: theta}
      sun: {shape: disc, mass: 1 kg, radius: 0.3 m, at: [0, 0], pin: phi}
      planet: {shape: disc, mass: 1 kg, radius: 0.1 m, at: [0.4 m, 0], pin: {carrier: arm, by: psi}}
      ring: {inertia: 1 kg*m^2, at: [0, 0], pin: chi}
      pinion: {inertia: 1 kg*m^2, turn: eta}
    constraints:
      inner: {gear: [sun, planet], carrier: arm}
      outer: {gear: [ring, planet], radii: [0.5 m, 0.1 m], inside: true, carrier: arm}
      side: {gear: [sun, pinion], radii: [0.3 m, 0.2 m]}
    """
BELTS = """
    bodies:
      arm: {mass: 1 kg, at: [0, 0], pin: theta}
      one: {shape: disc, mass: 1 kg, radius: 0.3 m, at: [0, 0], pin: phi}
      two: {shape: disc, mass: 1 kg, radius: 0.1 m, at: [1 m, 0], pin: psi}
      three: {shape: disc, mass: 1 kg, radius: 0.1 m, at: [0, 1 m], pin: chi}
      four: {shape: disc, mass: 1 kg, radius: 0.2 m, at: [0, -1 m], pin: {carrier: arm, by: eta}}
    constraints:
      open: {belt: [one, two]}
      crossed: {belt: [two, three], radii: [0.1 m, 0.4 m], crossed: true}
      carried: {belt: [one, four], carrier: arm}
    """
CRANK = """
    points: {P: {body: crank, at: [0, 0.3 m]}, Q: {body: rod, at: [0.4 m, 0]}}
    bodies:
      crank: {shape: rod, mass: 1 kg, from: [0, 0], to: [0, 0.3 m], pin: {at: [0, 0], by: phi}}
      rod: {shape: rod, mass: 1 kg, from: [0, 0.3 m], to: [0.4 m, 0], pin: {at: P, by: psi}}
      piston: {mass: 1 kg, at: [0.4 m, 0], slide: x}
      other: {mass: 1 kg, at: [-0.4 m, 0], slide: y}
    springs: {s: {k: 50 N/m, between: [piston, [1 m, 0]], preload: 3 N}}
    constraints:
      pin: {join: [Q, piston]}
      second: {link: [P, other]}
    """
SURFACES = """
    parameters: {a: 0.5 m}
    surfaces:
      ramp: {line: [[0, 0], [4 m, 3 m]]}
      wall: {line: [[0, 0], [0, 1 m]], body: cart}
      ring: {circle: [0, 0], radius: 0.5 m}
      bowl: {curve: w^2/a, in: w, body: cart}
    bodies:
      cart: {mass: 1 kg, at: [0, 0], slide: x}
      skid: {mass: 1 kg, at: [0, 0], move: [u, v, 0]}
      bead: {mass: 1 kg, at: [0, 0.5 m], move: [p, q, 0]}
      marble: {mass: 1 kg, at: [0.1 m, 0.02 m], move: [r, s, 0]}
      post: {mass: 1 kg, at: [0, 0.2 m], move: [d, e, 0]}
    constraints:
      sliding: {point: skid, surface: ramp}
      ringed: {point: bead, surface: ring}
      rolling: {point: marble, surface: bowl}
      guided: {point: post, surface: wall}
    """
EQUATIONS = """
    parameters: {L: 0.8 m, Y: 0.1 m, Omega: 3 rad/s}
    bodies:
      a: {mass: 1 kg, slide: x}
      b: {mass: 1 kg, slide: y}
      c: {mass: 1 kg, slide: z}
      d: {inertia: 1 kg*m^2, turn: phi}
      e: {mass: 1 kg, slide: s}
    constraints:
      driven: x + 2*y = Y*sin(Omega*t)
      round: (L + z)^2 + x^2 = L^2
      screw: s = L*tan(phi)
    """
CARRIED_SURFACES = """
    parameters: {e: 0.1 m, R: 0.5 m}
    points: {P: {body: crank, at: [0, 0.2 m]}}
    surfaces:
      slot: {line: [[0, -0.4 m], [0, 0.5 m]], body: lever}
      groove: {circle: [e, 0], radius: R, body: crank}
    bodies:
      crank: {inertia: 1 kg*m^2, at: [0, 0], pin: phi}
      lever: {inertia: 1 kg*m^2, at: [0, -0.4 m], pin: psi}
      follower: {mass: 1 kg, at: [0, sqrt(R^2 - e^2)], slide: {along: [0, 1], by: y}}
    constraints:
      sliding: {point: P, surface: slot}
      cam: {point: follower, surface: groove}
    """
DRIVEN_LINK = """
    parameters: {X: 0.2 m, Y: 0.1 m, Omega: 3 rad/s}
    points: {S: {at: [0, 0], moves: [X*sin(Omega*t), Y*t*Omega]}}
    bodies: {bob: {mass: 2 kg, at: [0, -1 m], move: [x, y, 0]}}
    springs: {s: {k: 30 N/m, between: [bob, [1 m, -1 m]]}}
    constraints: {tie: {link: [bob, S]}}
    """
CLOSED = {
    "atwood": (ATWOOD, {"y": lambda x, **_: -x, "phi": lambda x, **_: -x / 0.2}),
    "moving pulley": (MOVING_PULLEY, {"psi": lambda y, **_: y / 0.1, "z": lambda y, **_: -2 * y,
                                      "chi": lambda y, **_: -2 * y / 0.3}),
    "stepped drum": (STEPPED_DRUM, {"x": lambda phi, **_: 0.3 * phi, "y": lambda phi, **_: -0.2 * phi,
                                    "z": lambda phi, **_: 0.2 * phi}),
    "differential hoist": (DIFFERENTIAL_HOIST, {"y": lambda phi, **_: 0.05 * phi, "psi": lambda phi, **_: phi}),
    "gears": (GEARS, {"psi": lambda theta, phi, **_: theta - 3 * (phi - theta),
                      "chi": lambda theta, phi, **_: theta - 3 / 5 * (phi - theta),
                      "eta": lambda phi, **_: -1.5 * phi}),
    "belts": (BELTS, {"psi": lambda phi, **_: 3 * phi, "chi": lambda phi, **_: -0.75 * phi,
                      "eta": lambda theta, phi, **_: theta + 1.5 * (phi - theta)}),
    "crank": (CRANK, {"psi": lambda phi, **_: asin(0.6) - asin(0.6 * cos(phi)),
                      "x": lambda phi, **_: -0.3 * sin(phi) + sqrt(0.25 - 0.09 * cos(phi) ** 2) - 0.4,
                      "y": lambda phi, **_: -0.3 * sin(phi) - sqrt(0.25 - 0.09 * cos(phi) ** 2) + 0.4}),
    "surfaces": (SURFACES, {"v": lambda u, **_: 0.75 * u, "q": lambda p, **_: sqrt(0.25 - p**2) - 0.5,
                            "s": lambda r, x, **_: (0.1 + r - x) ** 2 / 0.5 - 0.02, "d": lambda x, **_: x}),
    "carried surfaces": (CARRIED_SURFACES, {
        "psi": lambda phi, **_: mpmath.atan2(0.2 * sin(phi), 0.2 * cos(phi) + 0.4),
        "y": lambda phi, **_: 0.1 * sin(phi) + sqrt(0.01 * sin(phi) ** 2 + 0.24) - sqrt(0.24)}),
    "driven link": (DRIVEN_LINK, {"y": lambda x, t, **_: 0.3 * t + 1 - sqrt(1 - (x - 0.2 * sin(3 * t)) ** 2)}),
    "equations": (EQUATIONS, {"y": lambda x, t, **_: (0.1 * sin(3 * t) - x) / 2,
                              "z": lambda x, **_: sqrt(0.64 - x**2) - 0.8, "s": lambda phi, **_: 0.8 * tan(phi)}),
}


def closed_states(scene):
    """{symbol: value} of random states with all loops closed, the dependent coordinates by name."""
    found, _ = states(scene)
    dependent = scene.scene.dependent
    for i in range(len(found[scene.scene.coordinates[0]])):
        state = scene.numeric.floats | {"t": 0.0} | {name: float(values[i]) for name, values in found.items()}
        yield state | dict(zip(dependent, evaluate(list(dependent.values()), Floats, state), strict=True))


@pytest.mark.parametrize("name", CLOSED)
def test_dependent_coordinates(name):
    text, formulas = CLOSED[name]
    scene = problem(text)
    assert set(scene.scene.dependent) == set(formulas)
    assert scene.scene.freedom[1:] == (len(formulas), ())
    for state in closed_states(scene):
        for z, formula in formulas.items():
            assert state[z] == pytest.approx(float(formula(**state)), rel=1e-12, abs=1e-14), z


@pytest.mark.parametrize("name", CLOSED)
def test_their_velocities_and_accelerations(name):
    """The derivatives of the formulas along q + v h + a h²/2, in many digits."""
    text, formulas = CLOSED[name]
    scene = problem(text)
    nodes = [scene.scene.symbol(z, order) for z in formulas for order in (1, 2)]
    for state in list(closed_states(scene))[::7]:
        def path(h, state=state):
            return {"t": state["t"] + h} | {q: state[q] + state[q + "'"] * h + state[q + "''"] * h * h / 2
                                            for q in scene.scene.coordinates}

        with mpmath.workdps(30):
            exact = [float(mpmath.diff(lambda h, f=formula, path=path: f(**path(h)), 0, order))
                     for formula in formulas.values() for order in (1, 2)]
        assert evaluate(nodes, Floats, state) == pytest.approx(exact, rel=1e-11, abs=1e-12)


# ropes that run obliquely: their length, measured along tangents and arcs

def tangent(one, two):
    """(direction, length) of the free piece between two circles (x, y, radius, sense, turn), by bisection: the places
    where it touches them lie in line."""
    wx, wy, gap = two[0] - one[0], two[1] - one[1], two[2] * two[3] - one[2] * one[3]

    def across(angle):
        return wx * math.sin(angle) - wy * math.cos(angle) + gap

    low = math.atan2(wy, wx) - math.pi / 2
    high = low + math.pi
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (across(middle) > 0) == (across(low) > 0) else (low, middle)
    return low, wx * math.cos(low) + wy * math.sin(low)


class Rope:
    """A random rope over pulleys in a row: places, bodies that move, bodies that move and turn."""

    def __init__(self, seed):
        generator = random.Random(seed)
        last = generator.randint(2, 4)
        places = [(1.1 * i + generator.uniform(-0.15, 0.15), generator.uniform(-0.6, 0.6)) for i in range(last + 1)]
        self.stops, bodies, cord = [], [], []
        for i, (x, y) in enumerate(places):
            ending = i in (0, last)
            kind = generator.choice(["moving", "turning"] if ending else ["fixed", "moving", "turning"])
            radius = 0.0 if ending and kind == "moving" else generator.uniform(0.05, 0.2)
            over = generator.random() < 0.5
            if not ending:
                (ax, ay), (bx, by) = places[i - 1], places[i + 1]
                over = y > ay + (by - ay) * (x - ax) / (bx - ax)
            at = f"[{x!r} m, {y!r} m]"
            if kind != "fixed":
                turn = f"turn{i}" if kind == "turning" else 0
                bodies.append(f"  b{i}: {{mass: 1 kg, inertia: 1 kg*m^2, at: {at}, move: [x{i}, y{i}, {turn}]}}")
            name = at if kind == "fixed" else f"b{i}"
            cord.append(f"{{{'over' if over else 'under'}: {name}, radius: {radius!r} m}}" if radius else name)
            self.stops.append((x, y, radius, -1 if over else 1, kind))
        names = sorted(re.findall(r"\b(?:turn|x|y)\d\b", " ".join(bodies)), key=lambda name: (name[0] == "x", name))
        self.text = "\n".join(["coordinates:", *(f"  {name}: of a stop" for name in names), "bodies:", *bodies,
                               "constraints:", f"  cord: {{rope: [{', '.join(cord)}]}}"])

    def lengths(self, state):
        """The length of each stretch between the ends and the marks on pulleys that turn."""
        stops = [(x + state.get(f"x{i}", 0), y + state.get(f"y{i}", 0), r, sense, state.get(f"turn{i}", 0))
                 for i, (x, y, r, sense, _) in enumerate(self.stops)]
        found, total = [], 0.0
        for i, (one, two) in enumerate(pairwise(stops), 1):
            angle, length = tangent(one, two)
            total += length + one[2] * one[3] * (angle - one[4]) - two[2] * two[3] * (angle - two[4])
            if self.stops[i][4] == "turning" or i == len(stops) - 1:
                found.append(total)
                total = 0.0
        return found


@pytest.mark.parametrize("seed", range(12))
def test_the_length_of_a_rope(seed):
    rope = Rope(seed)
    scene, generator = problem(rope.text), random.Random(seed)
    drawn = rope.lengths({})
    assert scene.scene.freedom.conditions == len(drawn)
    for _ in range(6):
        target = scene.numeric.drawn_floats | {name: generator.uniform(-0.15, 0.15) for name in scene.scene.coordinates}
        state = scene.numeric.floats | scene.numeric.closed(scene.numeric.drawn_floats, target)
        dependent = scene.scene.dependent
        state |= dict(zip(dependent, evaluate(list(dependent.values()), Floats, state), strict=True))
        assert rope.lengths(state) == pytest.approx(drawn, rel=1e-12, abs=1e-13)
        spoiled = state | {name: state[name] + 1e-9 for name in list(dependent)[:1]}
        assert rope.lengths(spoiled) != pytest.approx(drawn, rel=1e-12, abs=1e-13)


@pytest.mark.sweep
def test_all_kinds_of_ropes_were_tried():
    ropes = [Rope(seed) for seed in range(12)]
    assert {kind for rope in ropes for *_, kind in rope.stops[1:-1]} == {"fixed", "moving", "turning"}
    assert {(kind, sense) for rope in ropes for _, _, _, sense, kind in (rope.stops[0], rope.stops[-1])} > {
        ("turning", 1), ("turning", -1)}
    assert sum(bool(problem(rope.text).scene.loops) for rope in ropes) >= 6


# implicit derivatives, digits

FOUR_BAR = """
    points: {B: {body: rocker, at: [4 m, 6 m]}, C: {body: coupler, at: [4 m, 6 m]}}
    bodies:
      crank: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, 3 m], pin: {at: [0, 0], by: phi}}
      coupler: {shape: rod, mass: 3 kg, from: [0, 3 m], to: [4 m, 6 m], pin: {at: [0, 3 m], carrier: crank, by: psi}}
      rocker: {shape: rod, mass: 1 kg, from: [4 m, 0], to: [4 m, 6 m], pin: {at: [4 m, 0], by: chi}}
    springs: {coil: {torsion: 400 N*m, between: [ground, crank]}, stay: {k: 30 N/m, between: [B, [12 m, 0]]}}
    gravity: 10 m/s^2
    constraints: {hinge: {join: [B, C]}}
    """


def four_bar(phi):
    """{name: value} of the coordinates of FOUR_BAR, by Newton's method in mpmath."""
    def gap(psi, chi):
        return (-3 * sin(phi) + 4 * cos(psi) - 3 * sin(psi) - 4 + 6 * sin(chi),
                3 * cos(phi) + 4 * sin(psi) + 3 * cos(psi) - 6 * cos(chi))

    psi, chi = mpmath.findroot(gap, (phi / 3, phi / 2))
    return {"phi": phi, "psi": psi, "chi": chi}


def centres(phi):
    """(x, y, turn) of its bars."""
    q = four_bar(phi)
    (sa, ca), (sb, cb), (sc, cc) = ((sin(x), cos(x)) for x in q.values())
    return [(-1.5 * sa, 1.5 * ca, phi), (-3 * sa + 2 * cb - 1.5 * sb, 3 * ca + 2 * sb + 1.5 * cb, q["psi"]),
            (4 - 3 * sc, 3 * cc, q["chi"])]


MASSES, INERTIAS = (2, 3, 1), (1.5, 6.25, 3)        # the bars are 3, 5 and 6 m long


def four_bar_potential(phi):
    q = four_bar(phi)
    reach = mpmath.hypot(8 + 6 * sin(q["chi"]), 6 * cos(q["chi"])) - 10
    return 200 * phi**2 + 15 * reach**2 + sum(10 * m * y for m, (_, y, _) in zip(MASSES, centres(phi), strict=True))


@pytest.mark.sweep
@pytest.mark.parametrize("phi", [0.25, -0.5])
def test_implicit_derivatives_of_a_four_bar(phi):
    """Three derivatives of psi(phi) and chi(phi) as nested gradients, against differences in many digits."""
    scene = problem(FOUR_BAR).scene
    assert scene.coordinates == ["phi"]
    assert set(scene.loops.names) == {"psi", "chi"}
    with mpmath.workdps(50):
        values = four_bar(mpmath.mpf(phi))
        for name in ("psi", "chi"):
            node = scene.dependent[name]
            for order in (1, 2, 3):
                node = gradient(node)[scene.q[0]]
                exact = mpmath.diff(lambda x, name=name: four_bar(x)[name], mpmath.mpf(phi), order)
                assert abs(evaluate([node], multiprecision(), values)[0] - exact) <= abs(exact) * mpmath.mpf(10) ** -25


@pytest.mark.filterwarnings("error")
def test_where_the_slope_of_a_loop_is_no_number_it_is_not_followed_in_silence():
    table = problem(ATWOOD).scene.table
    z, slope = (table.parameter(name, positive=False) for name in ("z", "slope"))
    start, target = ({"z": 0.0, "slope": x} for x in (math.nan, math.inf))
    assert Loops(["z"], [z], [slope], [1.0]).followed(start, target) is None


@pytest.mark.sweep
def test_digits_of_a_closed_loop():
    """ω² = V″/M at V′ = 0, by differences in many more digits; the loop is closed to as many."""
    scene = problem(FOUR_BAR)
    with mpmath.workdps(90):
        phi = scene.configuration.equilibrium.values["phi"]
        phi = mpmath.findroot(lambda x: mpmath.diff(four_bar_potential, x), phi)
        slopes = [[mpmath.diff(lambda x, i=i, j=j: centres(x)[i][j], phi) for j in range(3)] for i in range(3)]
        inertia = sum(m * (x**2 + y**2) + J * turn**2
                      for m, J, (x, y, turn) in zip(MASSES, INERTIAS, slopes, strict=True))
        exact = mpmath.sqrt(mpmath.diff(four_bar_potential, phi, 2) / inertia)
        mode, = scene.modal.modes_to(40)
        assert abs(mode.omega - exact) <= exact * mpmath.mpf(10) ** -39
    assert value(scene, "omega[1]") == pytest.approx(float(exact), rel=1e-14)
    assert value(scene, "equilibrium[chi]") == pytest.approx(float(four_bar(phi)["chi"]), rel=1e-14)


# linkages

PEAUCELLIER = """
    bodies:
      A: {mass: 1 kg, at: [4 m, 0], move: [ax, ay, 0]}
      B: {mass: 1 kg, at: [7 m, 4 m], move: [bx, by, 0]}
      D: {mass: 1 kg, at: [7 m, -4 m], move: [dx, dy, 0]}
      P: {mass: 1 kg, at: [10 m, 0], move: [px, py, 0]}
    springs: {s: {k: 100 N/m, between: [A, [2 m, 5 m]], free_length: 4 m}}
    constraints:
      crank: {link: [[2 m, 0], A]}
      one: {link: [[0, 0], B]}
      two: {link: [[0, 0], D]}
      three: {link: [A, B]}
      four: {link: [A, D]}
      five: {link: [P, B]}
      six: {link: [P, D]}
    """


def test_a_parallelogram_drawn_aslant_hangs_with_arms_along_an_axis():
    """ω² = g (m/2 + M + m/2)/((m/3 + M + m/3) L): at rest the coupler and both arms stand along the axes, where single
    slopes of the conditions are zero, which were none as drawn."""
    for drawn, gravity in ((lambda x, y: (x, y), (0, -1)), (lambda x, y: (-y, x), (1, 0))):
        A, B, C, D = (list(drawn(*place)) for place in ((0, 0), (3, -4), (10, -4), (7, 0)))
        found = vibcli.load({
            "gravity": [f"{9.81 * g} m/s^2" for g in gravity],
            "points": {"P": {"body": "coupler", "at": metres(C)}, "Q": {"body": "right", "at": metres(C)}},
            "bodies": {
                "left": {"shape": "rod", "mass": "2 kg", "from": metres(A), "to": metres(B),
                         "pin": {"at": metres(A), "by": "a"}},
                "coupler": {"shape": "rod", "mass": "3 kg", "from": metres(B), "to": metres(C),
                            "pin": {"at": metres(B), "carrier": "left", "by": "b"}},
                "right": {"shape": "rod", "mass": "2 kg", "from": metres(D), "to": metres(C),
                          "pin": {"at": metres(D), "by": "c"}}},
            "constraints": {"closed": {"join": ["P", "Q"]}}})
        assert found.omega == pytest.approx([math.sqrt(9.81 * 5 / (13 / 3 * 5))], rel=1e-14)


def metres(place):
    return [f"{x} m" for x in place]


def test_an_inversor_draws_a_straight_line():
    """A runs on a circle through O, P is its inverse: OA·OP = OB² − AB² = 40 m², so P stays at x = 10 m."""
    scene = problem(PEAUCELLIER)
    assert len(scene.scene.coordinates) == 1
    for state in closed_states(scene):
        a, p = complex(4 + state["ax"], state["ay"]), complex(10 + state["px"], state["py"])
        assert state["px"] == pytest.approx(0, abs=1e-11)
        assert a * p.conjugate() == pytest.approx(40, rel=1e-11)


@pytest.mark.sweep
def test_lazy_tongs():
    """Ten cells of two bars whose ends are w = L cos θ and h = L sin θ apart: all turn by the same angle.

    V = k n²(w − 1)²/2 + n m g h, T = Σ m((i + ½)² w′² + h′²/4) + n J φ′² with θ = π/4 + φ, L = √2, J = m L²/12.
    """
    scene, n, g = problem(tongs(10)), 10, mpmath.mpf("9.81")

    def V(phi):
        theta = mpmath.pi / 4 + phi
        return 50 * n**2 * (sqrt(2) * cos(theta) - 1) ** 2 + n * g * sqrt(2) * sin(theta)

    with mpmath.workdps(40):
        phi = mpmath.findroot(lambda x: mpmath.diff(V, x), -0.01)
        theta = mpmath.pi / 4 + phi
        inertia = sum(4 * (i + 0.5) ** 2 * sin(theta) ** 2 + cos(theta) ** 2 for i in range(n)) + n / mpmath.mpf(3)
        exact = {"equilibrium[phi0]": phi, "equilibrium[psi9]": -phi, "M[phi0, phi0]": inertia,
                 "omega[1]": sqrt(mpmath.diff(V, phi, 2) / inertia)}
    assert scene.scene.freedom == (38, 37, ())
    assert {name: value(scene, name) for name in exact} == pytest.approx(
        {name: float(x) for name, x in exact.items()}, rel=1e-12)


OBLIQUE_ROPE = """
    gravity: 10 m/s^2
    bodies:
      bob: {mass: 1 kg, at: [-1 m, -0.5 m], move: [x, y, 0]}
      wheel: {shape: disc, radius: 0.2 m, mass: 1 kg, at: [0.2 m, 0.3 m], move: [a, b, c]}
      weight: {mass: 1 kg, at: [1.5 m, -0.3 m], move: [u, v, 0]}
    springs:
      s1: {k: 500 N/m, between: [bob, [-2 m, -1 m]]}
      s2: {k: 600 N/m, between: [bob, [-1 m, -2 m]], preload: 20 N}
      s3: {k: 900 N/m, between: [wheel, [0.2 m, 2 m]]}
      s4: {k: 700 N/m, between: [wheel, [-1 m, 0.5 m]]}
      s5: {k: 400 N/m, between: [weight, [1.6 m, -1 m]], preload: 20 N}
      s6: {k: 450 N/m, between: [weight, [2 m, -0.2 m]]}
    constraints: {cord: {rope: [bob, {over: wheel}, {under: [0.9 m, -0.1 m], radius: 0.1 m}, weight]}}
    """


@pytest.mark.parametrize("name", ["atwood", "crank", "four-bar", "inversor", "oblique rope"])
def test_the_reduction_against_multipliers(name):
    """M = NᵀTN and K = Nᵀ(V″ + Σ λ G″)N with the null space N of ∂G/∂q and λ from V′ + λ ∂G/∂q = 0."""
    scene = problem({"atwood": ATWOOD, "crank": CRANK, "four-bar": FOUR_BAR, "inversor": PEAUCELLIER,
                     "oblique rope": OBLIQUE_ROPE}[name])
    loose, own = scene.system.scene_with_multipliers, scene.scene.coordinates
    state = scene.configuration.at_rest | scene.configuration.dependent_values
    zero = loose.table.zero

    def numbers(nodes):
        return np.array(evaluate(nodes, Floats, state | dict.fromkeys((v.name for v in loose.v), 0.0)))

    def slopes(node, symbols):
        return [gradient(node).get(x, zero) for x in symbols]

    def hessian(node, symbols):
        return np.array([numbers(slopes(part, symbols)) for part in slopes(node, symbols)])

    V, conditions = potential(loose), [constraint.node for constraint in loose.constraints]
    G = np.array([numbers(slopes(node, loose.q)) for node in conditions])
    free = [q.name in own for q in loose.q]
    N = np.zeros((len(loose.q), len(own)))
    N[free] = np.eye(len(own))
    N[np.logical_not(free)] = np.linalg.lstsq(G[:, np.logical_not(free)], -G[:, free], rcond=None)[0]
    forces = numbers(slopes(V, loose.q))
    multipliers = np.linalg.lstsq(G.T, -forces, rcond=None)[0]
    assert forces + multipliers @ G == pytest.approx(0, abs=1e-11 * (1 + abs(forces).max()))
    bent = hessian(V, loose.q) + sum(x * hessian(g, loose.q) for x, g in zip(multipliers, conditions, strict=True))
    M, _, _, K = scene.configuration.linear_system.matrices()
    for found, exact in ((M, N.T @ hessian(kinetic(loose), loose.v) @ N), (K, N.T @ bent @ N)):
        assert [found.get((i, j), 0) for i in range(len(own)) for j in range(len(own))] == pytest.approx(
            list(exact.flat), rel=1e-11, abs=1e-11 * abs(exact).max())


# driven supports

@pytest.mark.parametrize(("turn", "tie"), [("phi", "join: [A, S]"), ("0", "link: [rod, S]")])
def test_a_pendulum_tied_to_a_shaken_support(turn, tie):
    """As one pinned to it: about the drawn position ω² = g/L + k/m."""
    scene = problem(f"""
        gravity: 10 m/s^2
        parameters: {{X: 0.2 m, Omega: 3 rad/s}}
        points: {{S: {{at: [0, 0], moves: [X*sin(Omega*t), 0]}}, A: {{body: rod, at: [0, 0]}}}}
        bodies: {{rod: {{mass: 2 kg, at: [0, -1 m], move: [x, y, {turn}]}}}}
        springs: {{s: {{k: 30 N/m, between: [rod, [1 m, -1 m]]}}}}
        constraints: {{tie: {{{tie}}}}}
        """)
    assert value(scene, "equilibrium[rod.x]") == pytest.approx(0, abs=1e-12)
    assert value(scene, "omega[1]") == pytest.approx(5, rel=1e-12)


def test_no_equilibrium_where_a_spring_is_pulled_round():
    scene = problem("""
        parameters: {Omega: 3 rad/s}
        points: {T: {body: rotor, at: [0.5 m, 0]}}
        bodies:
          rotor: {at: [0, 0], pin: Omega*t}
          bob: {mass: 2 kg, at: [1 m, 0], slide: x}
        springs:
          s: {k: 30 N/m, between: [bob, T], free_length: 0.3 m}
          u: {k: 20 N/m, between: [bob, [2 m, 0]]}
        """)
    with pytest.raises(PhysicsError):
        value(scene, "equilibrium[x]")


# freedom: redundant, locked and contradictory constraints, the choice of coordinates

THREE_RODS = """
    points: {A: {body: deck, at: [-1 m, 0]}, B: {body: deck, at: [0.2 m, 0]}, C: {body: deck, at: [1 m, 0]}}
    bodies: {deck: {mass: 2 kg, inertia: 1 kg*m^2, at: [0, 0], move: [x, y, phi]}}
    gravity: 9.81 m/s^2
    constraints: {a: {link: [A, [-1 m, 2 m]]}, b: {link: [B, [0.2 m, 2 m]]}, c: {link: [C, [1 m, 2 m]]}}
    """
AT_DEAD_CENTRE = """
    coordinates: {x: of the piston, phi: of the crank}
    points: {P: {body: crank, at: [0.3 m, 0]}}
    bodies:
      crank: {shape: rod, mass: 1 kg, from: [0, 0], to: [0.3 m, 0], pin: {at: [0, 0], by: phi}}
      piston: {mass: 1 kg, at: [0.7 m, 0], slide: x}
    springs: {s: {k: 50 N/m, between: [piston, [1 m, 0]], preload: 3 N}}
    constraints: {rod: {link: [P, piston]}}
    """


def lumped(constraints, coordinates=""):
    """Three masses in a row."""
    return f"""
        {coordinates}
        bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 2 kg, slide: y}}, c: {{mass: 3 kg, slide: z}}}}
        springs: {{s: {{k: 100 N/m, between: [ground, a]}}}}
        constraints: {{{constraints}}}
        """


@pytest.mark.parametrize(("text", "conditions", "redundant"), [
    (lumped("one: y = 2*x, two: 2*y = 4*x"), 1, ["two"]),
    (lumped("one: y = 2*x, two: z = y + x, three: z = 3*x"), 2, ["two", "three"]),
    (THREE_RODS, 2, ["c"])])
def test_a_redundant_constraint_is_named(text, conditions, redundant):
    freedom = problem(text).scene.freedom
    assert (freedom.coordinates, freedom.conditions) == (3, conditions)
    assert len(freedom.redundant) == 1
    assert freedom.redundant[0] in redundant


def test_a_redundant_rod_changes_nothing():
    """A deck on parallel rods swings as a simple pendulum of their length L, rising by L(1 − cos)."""
    scene = problem(THREE_RODS)
    assert value(scene, "omega[1]") == pytest.approx(math.sqrt(9.81 / 2), rel=1e-14)
    for state in closed_states(scene):
        assert state["phi"] == pytest.approx(0, abs=1e-13)
        assert state["y"] == pytest.approx(2 - math.sqrt(4 - state["x"] ** 2), rel=1e-12, abs=1e-14)


def refusal(text):
    """What is said of a scene whose frequencies are asked."""
    with pytest.raises((SpecError, PhysicsError)) as caught:
        problem(text).modal.modes     # noqa: B018
    return str(caught.value)


@pytest.mark.parametrize(("text", "words"), [
    (THREE_RODS.replace("[1 m, 2 m]", "[1.1 m, 2 m]"), ["'a', 'b', 'c' lock", "'deck' cannot move"]),
    (THREE_RODS.replace("[1 m, 2 m]", "[1 m, 1 m]"), ["'c' locks", "as soon as anything moves"]),
    (lumped("one: x = y, two: y = 2*z, three: x = 3*z"), ["'a', 'b', 'c' cannot move", "3 coordinates"]),
    (lumped("one: x = y, two: x = y + x^2/(1 m)"), ["'two' locks"]),
    (lumped("one: x = y, two: x = y + 1 m"), ["'two' does not hold as drawn"]),
    (lumped("one: x = y, two: x = y + 2 m*sin(3 s^-1*t)"), ["'two' contradicts the others"]),
    (lumped("one: x = 1 m*sin(3 s^-1*t), two: y = 2*x, three: z = x"), ["motion is prescribed"])])
def test_locked_and_contradictory_constraints_are_refused(text, words):
    said = refusal(text)
    assert all(word in said for word in words), said


@pytest.mark.parametrize(("coordinates", "kept"), [
    ("", ["x"]), ("coordinates: {z: of c}", ["z"]), ("coordinates: {y: of b, z: of c, x: of a}", ["y"])])
def test_the_first_coordinates_stay_independent(coordinates, kept):
    """Whichever is kept, ω² = k/(m₁ + 4 m₂ + 9 m₃) of x = y/2 = z/3."""
    scene = problem(lumped("one: y = 2*x, two: z = 3*x", coordinates))
    assert scene.scene.coordinates == kept
    assert value(scene, "omega[1]") == pytest.approx(math.sqrt(100 / 36), rel=1e-14)


@pytest.mark.parametrize(("order", "kept"), [("phi chi psi", "phi"), ("chi psi phi", "chi"), ("psi chi phi", "chi")])
def test_the_choice_of_the_coordinate_of_a_loop(order, kept):
    """As drawn crank and rocker are parallel, so the coupler does not turn: psi cannot be the coordinate."""
    listed = "".join(f"\n      {name}: of a bar" for name in order.split())
    scene = problem(f"    coordinates: {listed}{FOUR_BAR}")
    assert scene.scene.coordinates == [kept]
    assert value(scene, "omega[1]") == pytest.approx(value(problem(FOUR_BAR), "omega[1]"), rel=1e-13)


def test_at_dead_centre_the_piston_cannot_be_the_coordinate():
    """x = −r(1 + r/l) φ²/2 to second order, so K = N r(1 + r/l) of the force N on the piston, and x′ = 0 as drawn."""
    scene = problem(AT_DEAD_CENTRE)
    assert scene.scene.coordinates == ["phi"]
    assert value(scene, "K[phi,phi]") == pytest.approx(3 * 0.3 * (1 + 0.3 / 0.4), rel=1e-14)
    assert value(scene, "M[phi,phi]") == pytest.approx(0.3**2 / 3, rel=1e-14)
    away = problem(AT_DEAD_CENTRE.replace("[0.3 m, 0]", "[0, 0.3 m]").replace("0.7 m, 0]", "0.4 m, 0]"))
    assert away.scene.coordinates == ["x"]


# reactions

FRAME = """
    parameters: {m1: 2 kg, m2: 3 kg, h: 0.8 m, L: 1.2 m, F: 10 N, W: 25 N, k: 500 N/m, g: 10 m/s^2}
    gravity: g
    points: {A: [0, 0], B: {body: frame, at: [L, h]}, C: {body: frame, at: [0, h]}, D: {body: frame, at: [L/4, h]}}
    surfaces: {floor: {line: [[0, h], [L, h]]}}
    bodies:
      truck: {at: [0, 0], slide: x}
      frame:
        parts:
          - {shape: rod, mass: m1, from: [0, 0], to: [0, h]}
          - {shape: rod, mass: m2, from: [0, h], to: [L, h]}
        pin: {at: [0, 0], carrier: truck, by: phi}
    springs: {s: {k: k, between: [[-1 m, 0], truck]}}
    forces: {push: {at: C, force: [F, 0]}, load: {at: D, force: [0, -W]}}
    constraints: {foot: {point: B, surface: floor}}
    """
TWO_ON_A_WHEEL = """
    gravity: 10 m/s^2
    bodies:
      left: {mass: 3 kg, at: [-0.2 m, -1 m], slide: {along: [0, 1], by: x}}
      right: {mass: 5 kg, at: [0.2 m, -1 m], slide: {along: [0, 1], by: y}}
      wheel: {shape: disc, radius: 0.2 m, mass: 7 kg, at: [0, 0], pin: phi}
    springs: {coil: {torsion: 40 N*m, between: [ground, wheel]}}
    constraints: {cord: {rope: [left, {over: wheel}, right]}}
    """
TACKLE = """
    gravity: 10 m/s^2
    bodies:
      low: {mass: 6 kg, at: [0, 0], slide: {along: [0, 1], by: y}}
      block: {mass: 1 kg, at: [0.3 m, 0], slide: {along: [0, 1], by: z}}
    springs: {tie: {k: 500 N/m, between: [[0.3 m, -1 m], block]}}
    constraints:
      cord: {rope: [[-0.1 m, 1 m], {under: low, radius: 0.1 m}, {over: [0.2 m, 1 m], radius: 0.1 m}, block]}
    """
ON_A_SLOPE = """
    gravity: 10 m/s^2
    surfaces: {slope: {line: [[0, 0], [4 m, 3 m]]}}
    points: {top: {body: disc, at: [1.88 m, 1.66 m]}}
    bodies:
      disc: {shape: disc, mass: 2 kg, radius: 0.1 m, at: [1.94 m, 1.58 m], roll: {surface: slope, travel: x}}
    springs: {s: {k: 300 N/m, between: [top, [2.68 m, 2.26 m]], preload: static}}
    """
GEARED = """
    bodies:
      one: {shape: disc, mass: 2 kg, radius: 0.3 m, at: [0, 0], pin: phi}
      two: {shape: disc, mass: 2 kg, radius: 0.1 m, at: [0.4 m, 0], pin: psi}
    springs: {coil: {torsion: 20 N*m, between: [ground, two]}}
    forces: {drive: {body: one, moment: 6 N*m}}
    constraints: {teeth: {gear: [one, two]}}
    """
HUNG = """
    gravity: 10 m/s^2
    bodies: {bob: {mass: 3 kg, at: [0, 0], move: [x, y, 0]}}
    springs: {s: {k: 200 N/m, between: [bob, [1 m, 0]], preload: static}}
    constraints: {tie: {link: [bob, [-3 m, 4 m]]}}
    """
STATICS = {      # scene: {signal: value by hand}
    # about A: N L = m2 g L/2 + W L/4 + F h
    "frame": (FRAME, {"foot.force": 15 + 6.25 + 10 * 0.8 / 1.2, "frame.reaction.x": -10, "s.force": 10,
                      "frame.reaction.y": 75 - 15 - 6.25 - 10 * 0.8 / 1.2, "frame.reaction.moment": 0,
                      "truck.reaction.y": 75 - 15 - 6.25 - 10 * 0.8 / 1.2, "frame.x": 0.02, "D.x": 0.02, "C.y": 0}),
    "wheel": (TWO_ON_A_WHEEL, {"cord.force.1": 30, "cord.force.2": 50, "wheel.reaction.y": 150, "wheel.reaction.x": 0,
                               "wheel.angle": -0.1, "right.y": -0.02, "coil.force": -4, "coil.stretch": -0.1}),
    # about the point of contact: F 2r = m g r sin, so F = 6 N up the slope at the top and as much friction
    "slope": (ON_A_SLOPE, {"s.force": 6, "disc.normal": 16, "disc.friction": 6, "top.x": 0}),
    "gears": (GEARED, {"two.angle": -0.1, "one.angle": 1 / 30, "coil.force": -2, "two.reaction.moment": 0}),
    # tie: 30 = 0.8 S, s: 0.6 S
    "hung": (HUNG, {"tie.force": 37.5, "s.force": 22.5, "s.stretch": 0}),
    # two rods alone: moments about either hanger
    "deck": (THREE_RODS.replace(", c: {link: [C, [1 m, 2 m]]}", ""), {"a.force": 19.62 * 0.2 / 1.2,
                                                                       "b.force": 19.62 / 1.2}),
}


@pytest.mark.parametrize("name", STATICS)
def test_statics(name):
    text, by_hand = STATICS[name]
    scene = problem(text)
    assert {signal: value(scene, f"equilibrium[{signal}]") for signal in by_hand} == pytest.approx(
        by_hand, rel=1e-12, abs=1e-12)


def test_the_tooth_force():
    """M₁/r₁ = M₂/r₂."""
    assert abs(value(problem(GEARED), "equilibrium[teeth.force]")) == pytest.approx(20, rel=1e-12)


def test_bearings_carry_the_tooth_force():
    """The teeth push gear one down at its right, gear two up at its left."""
    scene = problem(GEARED)
    assert [value(scene, f"equilibrium[{name}.reaction.y]") for name in ("one", "two")] == pytest.approx([20, -20])


def test_a_rope_around_a_body_that_does_not_turn_has_one_tension():
    scene = problem(TACKLE)
    assert value(scene, "equilibrium[cord.force]") == pytest.approx(30, rel=1e-12)


def test_what_is_carried_round_is_held():
    """The rod, 0.1 m off the axis, pushes the bead towards it by m Ω² e: as drawn, along −y."""
    scene = problem("""
        parameters: {Omega: 10 rad/s}
        bodies:
          rod: {at: [0, 0.1 m], pin: {at: [0, 0], by: Omega*t}}
          bead: {mass: 2 kg, at: [0.2 m, 0.1 m], slide: {by: s, carrier: rod}}
        points: {F: {body: rod, at: [0, 0.1 m]}}
        springs: {tie: {k: 900 N/m, between: [F, bead]}}
        """)
    assert value(scene, "equilibrium[bead.reaction.y]") == pytest.approx(-20, rel=1e-12)


def test_pins_of_a_four_bar():
    """Against the nine equations of the free bars, with the pin forces as unknowns."""
    scene = problem(FOUR_BAR)
    q = four_bar(mpmath.mpf(value(scene, "equilibrium[phi]")))
    bars = [tuple(map(float, part)) for part in centres(q["phi"])]
    sa, ca, sc, cc = (float(f(q[name])) for name in ("phi", "chi") for f in (sin, cos))
    A, B = (-3 * sa, 3 * ca), (4 - 6 * sc, 6 * cc)
    reach = math.hypot(12 - B[0], B[1])
    pull = [30 * (reach - 10) * part / reach for part in (12 - B[0], -B[1])]
    matrix, load = np.zeros((9, 8)), np.zeros(9)
    pins = [((0, 0), 0, None), (A, 1, 0), (B, 1, 2), ((4, 0), 2, None)]     # a force on one bar, against the other
    for j, (place, one, other) in enumerate(pins):
        for bar, sign in ((one, 1), (other, -1)):
            if bar is not None:
                x, y = place[0] - bars[bar][0], place[1] - bars[bar][1]
                matrix[3 * bar:3 * bar + 3, 2 * j:2 * j + 2] = sign * np.array([[1, 0], [0, 1], [-y, x]])
    for i, mass in enumerate(MASSES):
        load[3 * i + 1] -= 10 * mass
    load[2] -= 400 * float(q["phi"])
    load[6:] += [*pull, (B[0] - bars[2][0]) * pull[1] - (B[1] - bars[2][1]) * pull[0]]
    forces, rest, *_ = np.linalg.lstsq(matrix, -load, rcond=None)
    assert rest == pytest.approx(0, abs=1e-18)
    signals = [f"{name}.{axis}" for name in ("crank.reaction", "coupler.reaction", "hinge.force", "rocker.reaction")
               for axis in "xy"]
    assert [value(scene, f"equilibrium[{signal}]") for signal in signals] == pytest.approx(list(forces), rel=1e-10)


@pytest.mark.sweep
def test_the_tension_of_an_oblique_rope():
    """It balances springs and weight of the bob, and is the same on both sides of a wheel that nothing holds."""
    scene = problem(OBLIQUE_ROPE)
    x, y = -1 + value(scene, "equilibrium[x]"), -0.5 + value(scene, "equilibrium[y]")
    pull = -10j
    for end, k, preload, length in ((-2 - 1j, 500, 0, math.sqrt(1.25)), (-1 - 2j, 600, 20, 1.5)):
        reach = end - complex(x, y)
        pull += (preload + k * (abs(reach) - length)) * reach / abs(reach)
    assert [value(scene, f"equilibrium[cord.force.{i}]") for i in (1, 2)] == pytest.approx([abs(pull)] * 2, rel=1e-11)


def test_forces_that_statics_leaves_open():
    """Three parallel rods; the bob that hangs below pulls its own rod all the same."""
    scene = problem(THREE_RODS.replace("bodies: {", "bodies: {bob: {mass: 1 kg, at: [0, -1 m], move: [u, v, 0]}, ")
                    .replace("constraints: {", "constraints: {d: {link: [deck, bob]}, "))
    found = {reaction.signal: reaction.value for reaction in scene.configuration.reactions if reaction.form == "link"}
    assert found == {"d.force": pytest.approx(9.81, rel=1e-12), "a.force": None, "b.force": None, "c.force": None}
    with pytest.raises(PhysicsError, match="statics alone does not fix 'b\\.force'"):
        value(scene, "equilibrium[b.force]")


def test_a_slack_rope_is_reported():
    """The coil turns the wheel against the light weight; a spring under the heavy one lifts it."""
    lifted = TWO_ON_A_WHEEL.replace("springs: {", "springs: {s: {k: 10 N/m, between: [[0.2 m, -2 m], right], "
                                                  "preload: -60 N}, ")
    scene = problem(lifted)
    assert [signal for signal, _ in slack(scene.configuration.reactions)] == ["cord.force.2"]
    assert slack(scene.configuration.reactions)[0][1] == pytest.approx(value(scene, "equilibrium[cord.force.2]"))
    assert not slack(problem(TWO_ON_A_WHEEL).configuration.reactions)


def test_reactions_along_the_motion_of_a_pendulum():
    """R = m(a + g): a of the rod's middle, at the distance L/2 of its pin."""
    scene = problem("""
        parameters: {m: 2 kg, L: 0.6 m, g: 9.81 m/s^2}
        gravity: g
        bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
        """)
    found = along_the_motion(scene.numeric)
    assert set(found) == {"rod.reaction.x", "rod.reaction.y"}
    generator = random.Random(1)
    for _ in range(5):
        phi, rate, change = (generator.uniform(-3, 3) for _ in range(3))
        state = scene.numeric.floats | {"phi": phi, "phi'": rate, "phi''": change}
        x = 2 * 0.3 * (change * math.cos(phi) - rate**2 * math.sin(phi))
        y = 2 * 0.3 * (change * math.sin(phi) + rate**2 * math.cos(phi)) + 2 * 9.81
        assert evaluate([found["rod.reaction.x"], found["rod.reaction.y"]], Floats, state) == pytest.approx([x, y])


def test_reactions_along_the_motion_of_two_rods():
    """Newton's law of each rod, its acceleration by differences of its place along q + v h + a h²/2."""
    scene = problem("""
        gravity: 10 m/s^2
        bodies:
          top: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, -3 m], pin: {at: [0, 0], by: a}}
          low: {shape: rod, mass: 1 kg, from: [0, -3 m], to: [0, -5 m], pin: {at: [0, -3 m], carrier: top, by: b}}
        """)
    found, generator = along_the_motion(scene.numeric), random.Random(2)
    nodes = [found[f"{name}.reaction.{axis}"] for name in ("top", "low") for axis in "xy"]
    for _ in range(4):
        state = {name + "'" * primes: generator.uniform(-2, 2) for name in "ab" for primes in range(3)}

        def angle(name, h, state=state):
            return state[name] + state[name + "'"] * h + state[name + "''"] * h**2 / 2

        places = [lambda h: 1.5 * sin(angle("a", h)), lambda h: -1.5 * cos(angle("a", h)),
                  lambda h: 3 * sin(angle("a", h)) + sin(angle("b", h)),
                  lambda h: -3 * cos(angle("a", h)) - cos(angle("b", h))]
        x1, y1, x2, y2 = (float(mpmath.diff(place, 0, 2)) for place in places)
        low = [x2, y2 + 10]
        top = [2 * x1 + low[0], 2 * (y1 + 10) + low[1]]
        assert evaluate(nodes, Floats, state) == pytest.approx([*top, *low], rel=1e-7)


# signals

def test_signals_in_modes():
    """A bob on a cart: mode[i, P.x] follows the coordinates by ∂P/∂q at the equilibrium."""
    scene = problem("""
        gravity: 10 m/s^2
        points: {P: {body: rod, at: [0.2 m, -1 m]}}
        bodies:
          cart: {mass: 3 kg, at: [0, 0], slide: x}
          rod: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, -1 m], pin: {at: [0, 0], carrier: cart, by: phi}}
        springs: {s: {k: 50 N/m, between: [[-1 m, 0], cart]}}
        """)
    for i in (1, 2):
        x, phi = value(scene, f"mode[{i}, x]"), value(scene, f"mode[{i}, phi]")
        assert value(scene, f"mode[{i}, P.x]") == pytest.approx(x + phi, rel=1e-12)
        assert value(scene, f"mode[{i}, P.y]") == pytest.approx(0.2 * phi, rel=1e-12)
        assert value(scene, f"mode[{i}, rod.x]") == pytest.approx(x + 0.5 * phi, rel=1e-12)
        assert value(scene, f"mode[{i}, rod.angle]") == pytest.approx(phi, rel=1e-12)
        assert value(scene, f"mode[{i}, s.stretch]") == pytest.approx(x, rel=1e-12)


def test_signals_of_dependent_things():
    """The piston's place and the rod's turn in the mode of a crank, and where they rest."""
    scene = problem(CRANK)
    phi = value(scene, "equilibrium[phi]")
    along = math.sqrt(0.25 - 0.09 * math.cos(phi) ** 2)
    assert value(scene, "equilibrium[piston.x]") == pytest.approx(-0.3 * math.sin(phi) + along - 0.4, rel=1e-12)
    assert value(scene, "equilibrium[P.y]") == pytest.approx(0.3 * math.cos(phi) - 0.3, rel=1e-12)
    assert value(scene, "equilibrium[rod.angle]") == pytest.approx(value(scene, "equilibrium[psi]"), rel=1e-12)
    slope = -0.3 * math.cos(phi) + 0.09 * math.cos(phi) * math.sin(phi) / along
    assert value(scene, "mode[1, piston.x]") == pytest.approx(slope * value(scene, "mode[1, phi]"), rel=1e-11)
    assert value(scene, "mode[1, x]") == pytest.approx(value(scene, "mode[1, piston.x]"), rel=1e-13)


@pytest.mark.parametrize("scene", ["vibcli/examples/slider_crank.yaml", "vibcli/examples/double_pendulum.yaml",
                                   "problems/3_free_undamped/four_bar_with_springs.yaml",
                                   "problems/6_two_degrees/cart_with_pendulum.yaml"])
def test_positions_near_the_drawn_one_differ_from_it_and_from_each_other_in_every_coordinate(scene):
    scene = problem_of(PROJECT / scene).scene
    drawn, found = scene.drawn_values, [nearby(scene, attempt) for attempt in range(4)]
    for q in scene.q:
        ways = [(position[q.name] - drawn[q.name]) / scene.unit_of(q.name) for position in found]
        assert len({round(way, 9) for way in ways}) == 4 and min(ways) < 0 < max(ways)
        assert min(map(abs, ways)) > 0.005 and max(map(abs, ways)) <= 0.06
    if scene.loops is not None:
        assert all(abs(size) < 1e-9 for position in found for size in evaluate(
            list(scene.loops.conditions), Floats, position))
