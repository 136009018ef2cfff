"""Motions in time by second routes: integrators on matrices and loads evaluated here, Kane's method, small against full
motion, frequency responses against steady states, Newton's law and the balance of energy."""

import math
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from support import kane
from support.scenes import problem, problem_of
from sympy.physics.mechanics import KanesMethod, dynamicsymbols

from vibcli.analyses.time_integration.integrate import simulate
from vibcli.analyses.transient.linear_response import linear_motion
from vibcli.check.instances import Instances
from vibcli.results.random_states import reach
from vibcli.symbolic.parser import parse

ROOT = Path(__file__).parents[2]
FILES = {path.stem: path for path in [*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")]}
TURNS = 12.0        # how long motions are followed: so many radians of the fastest vibration

LOADED = ("lever_on_shaking_floor", "accelerometer_on_a_casing", "beats_in_a_manometer", "bell_crank_under_a_step",
          "crane_trolley_starts_without_sway", "disc_in_a_shaken_track", "feeder_tray_driven_by_a_sawtooth",
          "motor_raised_on_a_hinged_beam", "pendulum_under_a_square_wave", "press_with_two_blows",
          "roller_under_a_rectangular_pulse", "seismograph_with_level_boom", "shelter_under_a_blast",
          "trailer_over_a_half_sine_bump", "valve_lifted_by_a_cycloidal_cam", "motor_on_inclined_mounts",
          "car_over_a_bump_with_both_axles", "platforms_under_a_shaken_frame", "two_storeys_on_shaken_ground",
          "two_storeys_under_a_blast", "washing_machine_on_a_bench", "geared_drive_line_driven",
          "shaft_under_a_torque_pulse", "six_storeys_shaken_at_the_top", "shaken_support", "unbalanced_motor")

CALLS = {"sin": math.sin, "cos": math.cos, "exp": math.exp, "abs": abs, "sqrt": math.sqrt,
         "step": lambda u: float(u >= 0), "ramp": lambda u: max(u, 0.0),
         "square": lambda u: math.copysign(1.0, math.sin(u)), "sawtooth": lambda u: u / math.pi % 2 - 1}
EVERY = {"step": None, "ramp": None, "impulse": None, "square": math.pi, "sawtooth": 2 * math.pi}


def first(name):
    """A numeric Problem of a file."""
    return next(iter(Instances(problem_of(FILES[name]))))


def function(node, values, time, blow=0.0):
    """An expression as a function of the time, by a walk of its own; `blow`: what stands for δ."""
    if node.op in ("number", "pi"):
        return fixed(float(node.coefficient) * (math.pi if node.op == "pi" else 1))
    if node.op == "symbol":
        return (lambda t: t) if node is time else fixed(values[node.name])
    parts = [function(part[0] if isinstance(part, tuple) else part, values, time, blow) for part in node.args]
    if node.op == "call":
        call = CALLS.get(node.name, lambda u: blow * (abs(u) < 1e-12))
        found = lambda t: call(*(part(t) for part in parts))  # noqa: E731
    else:
        first, numbers = float(node.coefficient), [float(number) for _, number in node.args]
        if node.op == "sum":
            found = lambda t: first + sum(x * part(t) for x, part in zip(numbers, parts, strict=True))  # noqa: E731
        else:
            found = lambda t: first * math.prod(part(t) ** x for x, part in zip(numbers, parts, strict=True))  # noqa: E731
    return found if node.mask & time.mask else fixed(found(0.0))


def fixed(value):
    return lambda t: value


def calls(node):
    """All calls within an expression."""
    parts = [part[0] if isinstance(part, tuple) else part for part in node.args]
    return ([node] if node.op == "call" else []) + [call for part in parts for call in calls(part)]


class Load:
    """Q(t) of a problem, and the instants at which it jumps or strikes."""

    def __init__(self, problem):
        self.n, self.given = len(problem.scene.q), (problem.numeric.floats, problem.scene.time)
        self.rows = problem.symbolic.excitation
        self.smooth, self.struck = ([(i, function(node, *self.given, blow)) for i, node in self.rows.items()]
                                    for blow in (0.0, 1.0))

    def at(self, t, struck=False):
        found = np.zeros(self.n)
        for i, row in self.struck if struck else self.smooth:
            found[i] = row(t)
        return found

    def instants(self, end):
        found = {0.0, end}
        for call in (call for node in self.rows.values() for call in calls(node) if call.name in EVERY):
            argument, every = function(call.args[0], *self.given), EVERY[call.name]
            start, rate = argument(0.0), argument(1.0) - argument(0.0)
            levels = [0.0] if every is None else every * np.arange(math.ceil((start + rate * end) / every) + 1)
            found |= {t for t in ((level - start) / rate for level in levels) if 0 <= t < end}
        return sorted(found)


def followed(M, C, K, load, state, end, times):
    """q, q̇ at the times by DOP853, piece by piece."""
    n, pieces = len(M), load.instants(end)
    found = np.empty((2 * n, len(times)))
    for early, late in pairwise(pieces):
        state = state + np.append(np.zeros(n), np.linalg.solve(M, load.at(early, True) - load.at(early)))
        inside = (times >= early) & (times <= late)
        low, high = early + 1e-12 * (late - early), late - 1e-12 * (late - early)

        def rates(t, y, low=low, high=high):
            return np.append(y[n:], np.linalg.solve(M, load.at(min(max(t, low), high)) - C @ y[n:] - K @ y[:n]))

        run = solve_ivp(rates, (early, late), state, "DOP853", rtol=1e-11, atol=1e-13 * np.abs(state).max() + 1e-16,
                        dense_output=True)
        if inside.any():
            found[:, inside] = run.sol(times[inside])
        state = run.y[:, -1]
    return found


def matrices(scene):
    n = len(scene.scene.q)
    M, C, G, K = (np.zeros((n, n)) for _ in range(4))
    for matrix, entries in zip((M, C, G, K), scene.configuration.linear_system.matrices(), strict=True):
        for pair, x in entries.items():
            matrix[pair] = x
    return M, C + G, K


def rates_of(M, C, K):
    """|λ| of the free vibrations."""
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    return np.abs(np.linalg.eigvals(A))


@pytest.mark.parametrize("name", LOADED)
def test_small_motion_against_an_integrator(name):
    scene, dice = first(name), np.random.default_rng(5)
    M, C, K = matrices(scene)
    n, end = len(M), min(scene.response.until, 2 * TURNS / rates_of(M, C, K).max())
    times, load = np.sort(dice.uniform(0, end, 25)), Load(scene)
    places, speeds = scene.initial.start
    q0 = np.array([places[q] - scene.configuration.equilibrium.values[q] for q in scene.scene.coordinates])
    exact = followed(M, C, K, load, np.append(q0, [speeds[q] for q in scene.scene.coordinates]), end, times)
    for i, q in enumerate(scene.scene.coordinates):
        for row, order in ((exact[i] + scene.configuration.equilibrium.values[q], 0), (exact[n + i], 1)):
            found = scene.response.signal(parse(q + "'" * order)).values(times)
            assert np.abs(found - row).max() <= 1e-8 * (np.abs(exact[order * n:][:n]).max() + 1e-30)
    assert np.abs(exact).max() > 0


FREE = ("pendulum_on_sprung_cart", "bead_on_swinging_rod", "four_bar_with_springs", "slider_crank_on_spring",
        "geared_pendulums", "rod_with_inclined_spring", "cam_and_follower_at_rest", "galloping_sign_arm",
        "inverted_pendulum_dashpot", "sagging_boom", "bead_in_swinging_tube", "disc_on_three_tight_springs")


@pytest.mark.parametrize("name", FREE)
def test_full_motion_of_small_amplitude_is_the_small_motion(name):
    scene = first(name)
    M, C, K = matrices(scene)
    names, rest = scene.scene.coordinates, scene.configuration.equilibrium.values
    end = TURNS / rates_of(M, C, K).max()
    times, shift = np.linspace(0, end, 30), np.array([0.7 * reach(scene, q) * (-0.6) ** i for i, q in enumerate(names)])
    exact = linear_motion(M, C, K, scene.response.forcing(), shift, np.zeros(len(M)))
    q = np.array([exact.values(SimpleNamespace(constant=0.0, q={i: 1.0}, v={}, a={}, channels={}), times)
                  for i in range(len(M))])
    gaps = []
    for size in (1e-3, 1e-5):
        start = {name: rest[name] + size * x for name, x in zip(names, shift, strict=True)}
        found = simulate(scene.configuration, end, initial=start)
        rows = [found.names.index(name) for name in names]
        moved = found.at(times)[0][rows] - np.array([[rest[name]] for name in names])
        gaps.append(np.abs((moved / size - q) / np.abs(shift)[:, None]).max())
    assert gaps[0] < 0.1 and gaps[1] < 0.03 * gaps[0] + 3e-7


KANE = (kane.pendulum_on_sprung_cart, kane.bead_on_swinging_rod, kane.disc_on_sprung_platform,
        kane.particle_on_turning_disc,
        kane.rods_on_shaken_pivot, kane.bead_in_bowl_on_cart, kane.galloping_sign_arm, kane.four_bar_with_springs,
        kane.slider_crank_on_spring)


def by_kane(build, scene, values, until, times):
    """All coordinates at the times, Kane's equations of a model integrated."""
    symbols = {name: sympy.Symbol(name, positive=True) for name in values}
    model = kane.Model(symbols.get("g"))
    build(model, SimpleNamespace(**symbols))
    q, dependent, free = model.independent + model.rolled, model.dependent, len(model.independent)
    u = [dynamicsymbols(f"u{i}") for i in range(len(q + dependent))]
    ties = [*model.rolling, *(condition.diff(model.t) for condition in model.tied)]
    method = KanesMethod(model.N, q, u[:free], [x - y.diff(model.t) for x, y in zip(u, q + dependent, strict=True)],
                         q_dependent=dependent, configuration_constraints=model.tied, u_dependent=u[free:],
                         velocity_constraints=ties)
    method.kanes_equations(model.bodies, model.loads)
    state = [*q, *dependent, *u]
    right = sympy.lambdify([state, model.t, list(symbols.values())],
                           [method.mass_matrix_full, method.forcing_full], "numpy", cse=True)

    def rates(t, y):
        mass, force = right(y, t, list(values.values()))
        return np.linalg.solve(np.asarray(mass, float), np.asarray(force, float).ravel())

    names = [x.name for x in q + dependent]
    start = np.array([*(scene[0].get(x, 0.0) for x in names), *(scene[1].get(x, 0.0) for x in names)])
    run = solve_ivp(rates, (0, until), start, "DOP853", rtol=1e-11, atol=1e-13, t_eval=times)
    return dict(zip(names, run.y, strict=False))


@pytest.mark.sweep
@pytest.mark.parametrize("build", KANE, ids=lambda build: build.__name__)
def test_full_motion_against_kanes_method(build):
    scene = first(build.__name__)
    names = scene.scene.coordinates
    start = {q: scene.numeric.drawn_floats.get(q, 0.0) for q in names}
    start |= {q + "'": 3 * reach(scene, q) * (-0.7) ** i for i, q in enumerate(names)}
    until = 1.5
    found = simulate(scene.configuration, until, initial=start)
    times = np.linspace(0, until, 12)
    places, speeds, _ = found.at([0.0])
    known = [dict(zip(found.names, part[:, 0], strict=True)) for part in (places, speeds)]
    exact = by_kane(build, known, scene.numeric.floats, until, times)
    rows = dict(zip(found.names, found.at(times)[0], strict=True))
    common = [q for q in exact if q in rows]
    assert set(names) <= set(common)
    for q in common:
        assert np.abs(rows[q] - exact[q]).max() <= 1e-8 * max(1.0, np.abs(exact[q]).max()), q
    assert any(np.ptp(rows[q]) > 0.01 for q in common)


DRIVEN = """
    parameters: {m: 2 kg, M: 5 kg, L: 0.7 m, k: 400 N/m, K: 150 N/m, c: 3 N*s/m, d: 2 N*s/m, g: 9.81 m/s^2, F: 3 N,
                 Omega: 6 rad/s}
    gravity: g
    points:
      A: {body: cart, at: [0, 0]}
      B: {body: rod, at: [0, -L]}
    bodies:
      cart: {mass: M, at: [0, 0], slide: x}
      rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: A, by: phi}}
    springs:
      s: {k: k, between: [[-L, 0], cart]}
      w: {k: K, between: [[L, -L], B]}
    dampers:
      b: {c: c, between: [[-L, 0], cart]}
      e: {c: d, between: [[L, -L], B]}
    forces:
      pull: {at: B, force: [F*cos(Omega*t), 0]}
    initial: {x: 3 cm, phi': 0.4 rad/s}
"""
SIGNALS = ("x", "phi", "x'", "phi''", "s.force", "w.stretch", "e.force", "B.x", "rod.x", "ground.force.x")


def at(scene, text, times, order=0):
    return scene.response.signal(parse(text)).values(np.asarray(times, dtype=float), order)


@pytest.mark.parametrize("signal", SIGNALS)
def test_a_frequency_response_is_the_steady_state(signal):
    scene = problem(DRIVEN)
    quarter = math.pi / 12
    steady = scene.response.signal(parse(signal)).steady.values(np.array([0.0, quarter, 2 * quarter]))
    middle = 0.5 * (steady[0] + steady[2])
    H = scene.frequency_response(signal, "pull").at(6.0)[0] * 3.0
    assert abs(complex(steady[0] - middle, middle - steady[1]) - H) <= 1e-11 * abs(H) > 0


@pytest.mark.parametrize("name", ["chain_of_six", "six_storeys_shaken_at_the_top", "three_storeys_dashpot",
                                  "platform_on_rods_dies_down", "five_disc_shaft"])
def test_reciprocity(name):
    scene = first(name)
    names = scene.scene.coordinates
    for Omega in (0.37, 5.3, 61.0):
        H = {(a, b): scene.frequency_response(a, b).at(Omega)[0] for a in names for b in names}
        assert all(abs(H[a, b] - H[b, a]) <= 1e-11 * max(map(abs, H.values())) for a, b in H)


TIMES = np.linspace(0.01, 3.0, 37)


def test_newtons_law_in_time():
    """The level momentum of all that moves changes by what the ground and the pull exert; of the rod by the pin."""
    scene = problem(DRIVEN)
    change = 5 * at(scene, "x", TIMES, 2) + 2 * at(scene, "rod.x", TIMES, 2)
    exerted = 3 * np.cos(6 * TIMES) - at(scene, "ground.force.x", TIMES)
    assert np.abs(change - exerted).max() <= 1e-11 * np.abs(change).max()
    held = (at(scene, "w.force", TIMES) + at(scene, "e.force", TIMES) + 3 * np.cos(6 * TIMES)
            + at(scene, "rod.reaction.x", TIMES))
    own = 2 * at(scene, "rod.x", TIMES, 2)
    assert np.abs(own - held).max() <= 1e-11 * np.abs(own).max()


def test_the_balance_of_energy():
    """T + V(t) − T − V(0) = ∫ F ẋ dt − ∫ P dt, P the power of the dampers, by Gauss-Legendre rules."""
    scene = problem(DRIVEN)
    M, _, _ = matrices(scene)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    for end in (0.7, 2.9):
        ends, inside = np.array([0.0, end]), 0.5 * end * (nodes + 1)
        v = np.array([at(scene, q + "'", ends) for q in scene.scene.coordinates])
        weight = 2 * 9.81 * 0.7 / 2 * at(scene, "phi", ends) ** 2 / 2
        energy = (0.5 * np.einsum("it,ij,jt->t", v, M, v) + at(scene, "s.energy", ends) + at(scene, "w.energy", ends)
                  + weight)
        power = 3 * np.cos(6 * inside) * at(scene, "B.x'", inside) - sum(at(scene, d, inside)
                                                                        for d in ("b.power", "e.power"))
        assert abs(energy[1] - energy[0] - 0.5 * end * weights @ power) <= 1e-11 * energy.max()
