"""Means of powers and products against averages over the angles of the loads, and against quadrature in mpmath."""

import cmath
import math
from itertools import product

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.numerics.quadrature import integral
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

SCENE = """
bodies: {{a: {{mass: {m[0]!r} kg, slide: x}}, b: {{mass: {m[1]!r} kg, slide: y}}}}
springs: {{s: {{k: {k[0]!r} N/m, between: [ground, a]}}, r: {{k: {k[1]!r} N/m, between: [a, b]}}}}
dampers: {{d: {{c: {c[0]!r} N*s/m, between: [ground, a]}}, e: {{c: {c[1]!r} N*s/m, between: [a, b]}}}}
forces:
  P: {{at: a, force: {F[0]!r} N*sin({W[0]!r} rad/s*t) + 2 N}}
  R: {{at: b, force: {F[1]!r} N*cos({W[1]!r} rad/s*t)}}
"""
ASKED = {
    "x^2": lambda s: s["x"] ** 2, "x*y": lambda s: s["x"] * s["y"], "x^3*y'": lambda s: s["x"] ** 3 * s["v"],
    "(x - y)^4": lambda s: (s["x"] - s["y"]) ** 4, "P.power": lambda s: s["P"] * s["u"],
    "R.power + P.power": lambda s: s["P"] * s["u"] + s["R"] * s["v"],
    "d.power + e.power": lambda s: s["c"][0] * s["u"] ** 2 + s["c"][1] * (s["u"] - s["v"]) ** 2,
    "x^2*y^2 - 3*x'*y'*1 s^2*x*y": lambda s: s["x"] ** 2 * s["y"] ** 2 - 3 * s["u"] * s["v"] * s["x"] * s["y"],
}
OTHERS = {"abs(x)": lambda s: abs(s["x"]), "sqrt(x^2 + y^2)": lambda s: (s["x"] ** 2 + s["y"] ** 2) ** 0.5,
          "max(x, y)": lambda s: max(s["x"], s["y"]), "exp(x/1 cm)*y": lambda s: mpmath.exp(100 * s["x"]) * s["y"]}


def drawn(seed):
    dice = np.random.default_rng(seed)
    given = {"m": dice.uniform(1, 3, 2), "k": dice.uniform(50, 200, 2), "c": dice.uniform(1, 8, 2),
             "F": dice.uniform(1, 5, 2), "W": dice.uniform(4, 12, 2)}
    if seed % 2:
        given["W"][1] = given["W"][0] * (2, 1.5, 1)[seed % 3]
    return {name: values.tolist() for name, values in given.items()}


def steady(m, k, c, F, W):
    """The state {name: value} at given angles of the loads, by hand."""
    def shape(speed, force):
        s = 1j * speed
        return np.linalg.solve(np.array([[m[0] * s * s + (c[0] + c[1]) * s + k[0] + k[1], -c[1] * s - k[1]],
                                         [-c[1] * s - k[1], m[1] * s * s + c[1] * s + k[1]]]), force)
    still = np.linalg.solve(np.array([[k[0] + k[1], -k[1]], [-k[1], k[1]]]), [2.0, 0.0])
    first, second = shape(W[0], [-1j * F[0], 0]), shape(W[1], [0, F[1]])

    def state(one, two):
        turns = cmath.exp(1j * one), cmath.exp(1j * two)
        q = [still[i] + (first[i] * turns[0] + second[i] * turns[1]).real for i in (0, 1)]
        v = [(1j * W[0] * first[i] * turns[0] + 1j * W[1] * second[i] * turns[1]).real for i in (0, 1)]
        return {"x": q[0], "y": q[1], "u": v[0], "v": v[1], "c": c, "P": 2 + F[0] * turns[0].imag,
                "R": F[1] * turns[1].real}
    return state


def averaged(function, state, W):
    """Over all angles where nothing binds them, exact of products of fewer than N factors; else over a period."""
    N = 24
    ratio = W[1] / W[0]
    if abs(2 * ratio - round(2 * ratio)) < 1e-12:
        values = [function(state(2 * t, 2 * ratio * t)) for t in (2 * math.pi * n / 96 for n in range(96))]
    else:
        angles = [2 * math.pi * n / N for n in range(N)]
        values = [function(state(*pair)) for pair in product(angles, angles)]
    return math.fsum(values) / len(values), max(map(abs, values))


@pytest.mark.parametrize("seed", range(6))
def test_means_of_products_are_averages_over_the_angles_of_the_loads(seed):
    given = drawn(seed)
    scene, state = problem(SCENE.format(**given)), steady(**given)
    for text, function in ASKED.items():
        exact, size = averaged(function, state, given["W"])
        assert measure(scene, parse(f"mean({text})"))[0] == pytest.approx(exact, rel=1e-11, abs=1e-13 * size), text
        square = averaged(lambda s, function=function: function(s) ** 2, state, given["W"])[0]
        assert measure(scene, parse(f"rms({text})"))[0] == pytest.approx(math.sqrt(square), rel=1e-11), text


@pytest.mark.parametrize("text", OTHERS)
def test_other_functions_are_averaged_over_the_common_period(text):
    given = drawn(1)
    scene, state, W = problem(SCENE.format(**given)), steady(**given), given["W"]
    period = 2 * math.pi / W[0] * (2 if W[1] / W[0] % 1 else 1)
    edges = mpmath.linspace(0, period, 65)

    def value(t):
        return OTHERS[text](state(W[0] * float(t), W[1] * float(t)))
    exact = mpmath.quad(value, edges, maxdegree=5) / period
    corner = text in ("abs(x)", "max(x, y)")
    assert measure(scene, parse(f"mean({text})"))[0] == pytest.approx(float(exact), rel=1e-6 if corner else 1e-11)


def test_corners_and_jumps_are_narrowed_down():
    edges = np.linspace(0, 10, 4)
    assert integral(lambda t: np.abs(np.cos(t)), edges) == pytest.approx(6 + abs(math.sin(10)), abs=1e-13)
    assert integral(lambda t: np.sign(np.sin(t)), edges) == pytest.approx(4 * math.pi - 10, abs=1e-12)
    assert integral(lambda t: 1 / (t - 3.3) ** 2, edges) is None



NEAR = """
parameters: {{m: 2 kg, k: 200 N/m, c: {coupling} N/m, l: {other} N/m, W: {speed} rad/s, F: {force} N}}
bodies: {{a: {{mass: m, slide: x}}, b: {{mass: m, slide: y}}}}
springs: {{s: {{k: k, between: [ground, a]}}, r: {{k: l, between: [ground, b]}}, q: {{k: c, between: [a, b]}}}}
forces: {{P: {{at: a, force: F*sin(W*t)}}}}
initial: {{x: 1 cm}}
"""


@pytest.mark.parametrize(("coupling", "other", "speed", "force"), [
    ("1e-5", "200.00001", "3", "0"), ("1e-5", "200", "3", "0"), ("1e-7", "200.00001", "3", "0"),
    ("1e-9", "200", "3", "0"), ("10", "190", "3", "0"), ("1e-9", "170", "10.0000001", "4"),
    ("1e-9", "170", "10.00001", "4"), ("10", "200", "10.48808848", "4")])
def test_means_lie_within_their_bounds_where_frequencies_are_close(coupling, other, speed, force):
    """Of neighbours that hardly couple each frequency counts, however close; near a resonance the bound is wide."""
    scene = problem(NEAR.format(coupling=coupling, other=other, speed=speed, force=force))
    with mpmath.workdps(40):
        c, k, W, F = (mpmath.mpf(text) for text in (coupling, other, speed, force))
        K = mpmath.matrix([[200 + c, -c], [-c, k + c]])
        if F:
            waves = [tuple(mpmath.lu_solve(K - 2 * W * W * mpmath.eye(2), mpmath.matrix([F, 0])))]
        else:
            waves = [(V[0] * V[0] / 100, V[0] * V[1] / 100) for V in map(mpmath.eigsy(K)[1].column, range(2))]
        mean = sum(X * X for X, _ in waves) / 2
        exact = {"mean(x^2)": mean, "rms(x)": mpmath.sqrt(mean), "mean(x*y)": sum(X * Y for X, Y in waves) / 2,
                 "mean(x^4)": 3 * mean**2 - 3 * sum(X**4 for X, _ in waves) / 8}
        for text, value in exact.items():
            found, relative = measure(scene, parse(text))
            assert abs(found - value) <= relative * abs(found) + mpmath.mpf(2) ** -50 * abs(value), text
            assert relative < 2e-3 or not abs(value) > 1e-12 * mean, text
