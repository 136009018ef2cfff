"""What worked solutions tell of a motion under a load in pieces: each arc goes on where the one before ends; values,
extremes and limits; held against the integral of the impulses that a load consists of."""

import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from support.scenes import problem, problem_of
from support.worked_lines import told_later

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

SCENE = """
parameters: {{{values}, t1: {t1}}}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
{damper}
forces: {{f: {{at: b, force: {load}}}}}
answers: {{{asked}}}
"""
NUMBERS, LETTERS = "m: 2 kg, k: 800 N/m, F: 5 N", "m: , k: , F: "
DAMPED = "dampers: {d: {c: 8 N*s/m, between: [ground, b]}}"
PULSE = "F*(step(t) - step(t - t1))"


def told(load, asked, values=NUMBERS, damper="", t1="0.1 s"):
    text = SCENE.format(values=values, damper=damper, load=load, t1=t1, asked=", ".join(f'"{one}": 0' for one in asked))
    return {line.settles: line for line in worked(problem(text))}


def shown(line):
    return formula(line.parts, plain).replace("\\u00a0", " ")


def motion(force, t, c, bends=(0.1,)):
    """x(t) of 2 ẍ + c ẋ + 800 x = force(t) from rest, by Duhamel's integral."""
    delta = mpmath.mpf(c) / 4
    rate = mpmath.sqrt(400 - delta**2)
    places = [0, *[bend for bend in bends if bend < t], t]
    return mpmath.quad(lambda s: force(s) * mpmath.exp(delta * (s - t)) * mpmath.sin(rate * (t - s)) / rate, places) / 2


FORCES = [(PULSE, lambda s: 5 * (s < 0.1)), ("F*(1 - t/t1)*(step(t) - step(t - t1))", lambda s: max(5 - 50 * s, 0)),
          ("F*sin(pi*t/t1)*(step(t) - step(t - t1))", lambda s: 5 * mpmath.sin(10 * mpmath.pi * s) * (s < 0.1))]


@pytest.mark.parametrize(("load", "force"), FORCES, ids=["rectangle", "triangle", "half sine"])
@pytest.mark.parametrize("c", [0, 8])
def test_values_and_extremes_under_a_pulse_are_those_of_duhamels_integral(load, force, c):
    of = told(load, ["x(t1)", "x'(t1/2)", "max(x)", "argmax(x)", "min(s.force)"], damper=DAMPED if c else "")
    assert all(of[one].node is not None for one in ("x(t1)", "x'(t1/2)", "max(x)", "argmax(x)", "min(s.force)"))
    assert of["x(t1)"].value == pytest.approx(float(motion(force, 0.1, c)), rel=1e-9)
    at, h = of["argmax(x)"].value, 1e-4
    before, there, behind = (float(motion(force, at + step, c)) for step in (-h, 0, h))
    assert of["max(x)"].value == pytest.approx(there, rel=1e-9) and max(before, behind) < there
    rate = float(mpmath.diff(lambda t: motion(force, t, c), 0.05))
    assert of["x'(t1/2)"].value == pytest.approx(rate, rel=1e-6)
    assert of["min(s.force)"].value < 0 and of["min(s.force)"].unit == "N"


def test_the_arc_behind_a_pulse_goes_on_where_that_ends():
    """By hand: A = x(t₁), B = ẋ(t₁)/ω, the largest place √(A² + B²)."""
    of = told(PULSE, ["max(x)", "argmax(x)"], t1="0.05 s")
    assert shown(of["motion from bend 2"]).startswith(
        "from  t = t₁ on  with  τ = t − t₁:  x = A₂·cos(ω·τ) + B₂·sin(ω·τ)")
    A, B = 5 / 800 * (1 - math.cos(1)), 5 / 800 * math.sin(1)
    assert shown(of["A2"]).startswith("A₂ = F·x_step(t₁) = ") and of["A2"].value == pytest.approx(A, rel=1e-12)
    assert shown(of["B2"]).startswith("B₂ = F·ẋ_step(t₁)/ω = ") and of["B2"].value == pytest.approx(B, rel=1e-12)
    assert of["max(x)"].value == pytest.approx(math.hypot(A, B), rel=1e-12)
    assert of["argmax(x)"].value == pytest.approx(0.05 + math.atan2(B, A) / 20, rel=1e-9)


def test_a_blow_adds_its_speed_at_the_bend():
    of = told("-F*t1*impulse(t - t1) + 2*F*t1*impulse(t - 2*t1)", ["min(x)", "max(x)"], damper=DAMPED)
    rate = math.sqrt(396)
    place = -0.25 * math.exp(-0.2) * math.sin(0.1 * rate) / rate
    speed = -0.25 * math.exp(-0.2) * (math.cos(0.1 * rate) - 2 * math.sin(0.1 * rate) / rate) + 0.5
    line = next(line for name, line in of.items() if name == "B2")
    assert "2·F·t₁/m" in shown(line) and line.value == pytest.approx((speed + 2 * place) / rate, rel=1e-9)


@pytest.mark.parametrize(("part", "largest", "value"), [
    ("sqrt(m/k)*pi", "F/k", "2·F/k"), ("sqrt(m/k)*pi/2", "√2·F/k", "F/k")])
def test_in_letters_parts_of_a_period_are_put_in(part, largest, value):
    """Of a pulse of half and a quarter of a period (Thomson & Dahleh 1998, section 4.2)."""
    of = told(PULSE, ["max(x)", "x(t1)", "x(3*t1)", "max(s.force)"], values=LETTERS, t1=part)
    assert shown(of["x(t1)"]).endswith(value) and of["x(t1)"].value is None
    if part.endswith("/2"):
        assert shown(of["max(x)"]).endswith(largest)
        assert shown(of["max(s.force)"]).startswith("max(s.force):  k·max(x) = ")
    assert "told in numbers" not in "".join(map(shown, of.values()))


def test_where_it_settles_behind_a_ramp_is_told():
    of = told("F*ramp(t)/t1 - F*ramp(t - t1)/t1", ["final(x)", "final(s.force)"], values=LETTERS, t1="",
              damper="dampers: {d: {c: m*sqrt(k/m)/4, between: [ground, b]}}")
    assert shown(of["final(x)"]) == "final(x):  F/k" and shown(of["final(s.force)"]) == "final(s.force):  F"


TWO = """
parameters: {{m: 2 kg, n: 1 kg, k: 300 N/m, h: 200 N/m, F: 5 N, P: 8 N, t1: 0.12 s}}
bodies: {{a: {{mass: m, slide: x}}, b: {{mass: n, slide: y}}}}
springs: {{r: {{k: k, between: [ground, a]}}, s: {{k: h, between: [a, b]}}}}
{damping}
forces: {{f: {{at: a, force: F*(step(t) - step(t - t1))}}, g: {{at: b, force: P*(1 - t/t1)*(step(t) - step(t - t1))}}}}
answers: {{x(t1): 0 m, y'(2*t1): 0 m/s, max(y): 0 m, argmax(y): 0 s, max(s.force): 0 N}}
"""


def two(t, alpha):
    """[x, y, ẋ, ẏ] of the same with C = αM, by the exponential of its matrix with 1 and t beside."""
    M, K = np.diag([2.0, 1.0]), np.array([[500.0, -200], [-200, 200]])
    A = np.zeros((6, 6))
    A[:2, 2:4], A[2:4, :2], A[2:4, 2:4] = np.eye(2), -np.linalg.solve(M, K), -alpha * np.eye(2)
    A[2:4, 4:] = np.linalg.solve(M, [[5.0, 0], [8, -8 / 0.12]])
    A[5, 4] = 1
    start = expm(A * min(t, 0.12)) @ [0, 0, 0, 0, 1, 0]
    return start[:4] if t <= 0.12 else expm(A[:4, :4] * (t - 0.12)) @ start[:4]


@pytest.mark.parametrize("alpha", [0, 3])
def test_pieces_of_several_degrees_are_told_by_their_modes(alpha):
    damping = "dampers: {d: {c: 3*m, between: [ground, a]}, e: {c: 3*n, between: [ground, b]}}" if alpha else ""
    damping = damping.replace("3*m", "3*m/(1 s)").replace("3*n", "3*n/(1 s)")
    of = {line.settles: line for line in worked(problem(TWO.format(damping=damping)))}
    at = of["argmax(y)"].value
    wanted = {"x(t1)": two(0.12, alpha)[0], "y'(2*t1)": two(0.24, alpha)[3], "max(y)": two(at, alpha)[1]}
    for asked, value in wanted.items():
        assert of[asked].node is not None and of[asked].value == pytest.approx(value, rel=1e-9)
    assert abs(two(at, alpha)[3]) < 1e-6 and of["max(s.force)"].node is not None
    assert shown(of["x(t1)"]).startswith("x(t₁):  p₁(t₁) + p₂(t₁) = ")
    assert "s₁(t) − s₁" not in shown(of["p1"]) and "·s₁(t − t₁)" in shown(of["p1"])
    assert shown(of["equation of mode 1"]).startswith("of the right sides  Q,  with the shape of mode 1  u₁ = (1, ")


COUPLED = "dampers: {d: {c: 6 N*s/m, between: [ground, a]}}"
STARTED = COUPLED + "\ninitial: {x: 1 cm, y': -0.2 m/s}"


def coupled(times, load, c=6.0, start=(0.0, 0, 0, 0), grounded=500.0):
    """[x, y, ẋ, ẏ] of 2 ẍ + c ẋ + 500 x − 200 y = load(t), ÿ − 200 x + 200 y = 0 at instants, by a solver of
    differential equations."""
    found = solve_ivp(lambda t, s: [*s[2:], (load(t) - c * s[2] - grounded * s[0] + 200 * s[1]) / 2,
                                    200 * (s[0] - s[1])], (0, max(times)), start, "DOP853", times, rtol=1e-11,
                      atol=1e-13, max_step=0.01)
    return found.y.T


ONE = TWO.replace(", P: 8 N", "").replace("force: F*(step(t) - step(t - t1))", "force: {load}")
ONE = "".join((ONE[:ONE.index(", g: {{")], "}}", ONE[ONE.index("\nanswers"):]))


@pytest.mark.sweep
@pytest.mark.parametrize(("damping", "c", "start"), [
    (COUPLED, 6, (0, 0, 0, 0)), (STARTED, 6, (0.01, 0, 0, -0.2)), (COUPLED.replace("6 N", "-6 N"), -6, (0, 0, 0, 0)),
    (STARTED.replace("6 N", "60 N"), 60, (0.01, 0, 0, -0.2)), (STARTED[len(COUPLED) + 1:], 0, (0.01, 0, 0, -0.2))])
@pytest.mark.parametrize("load", ["F*(step(t) - step(t - t1))", "F*sin(7 rad/s*t)*(step(t) - step(t - t1))",
                                  "F/t1*(ramp(t) - ramp(t - t1))"])
def test_pieces_and_a_start_where_damping_couples_the_modes(damping, c, start, load):
    """Oscillating and overdamped modes, growing ones and real ones, held against a solver."""
    of = {line.settles: line for line in worked(problem(ONE.format(damping=damping, load=load)))}
    at = of["argmax(y)"].value
    instants = sorted({0.12, 0.24, at})
    acts = {"F*(": lambda t: 5.0 * (t < 0.12), "F*s": lambda t: 5 * math.sin(7 * t) * (t < 0.12),
            "F/t": lambda t: 5 * min(t / 0.12, 1)}[load[:3]]
    y = dict(zip(instants, coupled(instants, acts, c, start), strict=True))
    for asked, value in {"x(t1)": y[0.12][0], "y'(2*t1)": y[0.24][3], "max(y)": y[at][1]}.items():
        assert of[asked].node is not None and of[asked].value == pytest.approx(value, rel=1e-6)
    if c:
        assert "Re(" in shown(of["x(t1)"]) and "= u·Q  with" in shown(of["equations of complex modes"])
        assert ("z₁(0) = " in shown(of["equation of complex mode 1"])) == bool(any(start))
    else:
        assert shown(of["equation of mode 1"]).startswith(
            "of the right sides  Q,  with  q = (x, y)  and the shape of mode 1  u₁ = (1, ")
    assert len({line.number for line in of.values()}) <= 60


@pytest.mark.sweep
def test_lines_of_complex_modes_have_the_numbers_of_their_matrices():
    """By hand: λ by numpy of the companion matrix, u·Q over u·(2λM + C)·u."""
    scene = problem(ONE.format(damping=COUPLED, load="F*step(t)"))
    lines = worked(scene)
    of = {line.settles: line for line in lines}
    assert not told_later(scene, lines)
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [np.array([[-250.0, 100], [200, -200]]), np.diag([-3.0, 0])]])
    roots, shapes = np.linalg.eig(A)
    k = min((i for i in range(4) if roots[i].imag > 0), key=lambda i: roots[i].imag)
    u = shapes[:2, k] / shapes[0, k]
    g = u[0] / (u @ (2 * roots[k] * np.diag([2, 1]) + np.diag([6, 0])) @ u)
    line = shown(of["equation of complex mode 1"])
    for value in (roots[k].real, roots[k].imag, u[1].real, u[1].imag, g.real, g.imag):
        assert f"{abs(value):.6g}".rstrip("0") in line
    unit = shown(of["s_k"])
    assert unit.startswith("a unit step at τ = 0 has in mode k the particular part  −1/λ,  and as z = 0 at its start")
    assert f"1/λ₁ = −{abs((1 / roots[k]).real):.6g}" in unit
    assert shown(of["z1"]).endswith("·F·s₁(t)   (each from when its argument is positive)")


def test_a_mode_that_moves_freely_under_pieces():
    """By hand: the mass centre of 3 kg under 5 N for 0.12 s, and the distance as of m₁m₂/(m₁ + m₂) = ⅔ kg."""
    scene = ONE.format(damping="", load="F*(step(t) - step(t - t1))").replace("r: {k: k, between: [ground, a]}, ", "")
    of = {line.settles: line for line in worked(problem(scene.replace("k: 300 N/m, ", "")))}
    omega = math.sqrt(300)
    apart = 5 / 600 * (1 - math.cos(omega * 0.12))
    assert of["x(t1)"].value == pytest.approx(5 / 3 * 0.12 ** 2 / 2 + apart / 3, rel=1e-9)
    assert of["x(t1)"].node is not None and "which moves freely,  s₁(τ) = τ²/2" in shown(of["s_k"])


def test_a_root_that_is_zero_under_pieces():
    """Two masses on a spring, one in a bath: what ends drifts away by ∫F dt/c."""
    scene = ONE.format(damping=COUPLED, load="F*(step(t) - step(t - t1))").replace(
        "r: {k: k, between: [ground, a]}, ", "").replace("x(t1): 0 m", "x(40 s): 0 m")
    of = {line.settles: line for line in worked(problem(scene.replace("k: 300 N/m, ", "")))}
    assert of["x(40 s)"].value == pytest.approx(5 * 0.12 / 6, rel=1e-6) and of["x(40 s)"].node is not None
    assert "but as λ₁ = 0  s₁(τ) = τ" in shown(of["s_k"])


@pytest.mark.parametrize("damping", [COUPLED, STARTED, ""])
def test_recorded_loads_are_integrals_of_impulses(damping, tmp_path):
    (tmp_path / "push.csv").write_text("t,F\n0,1\n0.05,2\n0.2,0\n")
    (tmp_path / "scene.yaml").write_text("records: {push: {file: push.csv}}" + ONE.format(
        damping=damping, load="F*push(t)").replace("max(y): 0 m, argmax(y): 0 s, ", ""))
    of = {line.settles: line for line in worked(problem_of(tmp_path / "scene.yaml"))}
    start = (0.01, 0, 0, -0.2) if "initial" in damping else (0, 0, 0, 0)
    found = coupled([0.12], lambda t: 5 * np.interp(t, [0, 0.05, 0.2], [1, 2, 0]), 6 * bool(damping), start)
    assert of["x(t1)"].value == pytest.approx(found[0][0], rel=1e-6)
    told = shown(of["convolution"])
    assert told.endswith("exp(λ·(t − τ))·g·Q(τ)·dτ" if damping else "h_k(t − τ)·u_k·Q(τ)/(u_k·M·u_k)·dτ")
    assert ("z(0)·exp(λ·t) + " in told) == ("initial" in damping)
    assert shown(of["motion of x"]).startswith("and  x = 2·Re(z₁) + " if damping else "and  x = p₁ + p₂")
