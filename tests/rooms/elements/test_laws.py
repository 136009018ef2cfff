"""Nonlinear laws, dry friction, stops and cables against exact solutions."""

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from support.motions import duffing_period, problem
from support.scenes import number

from vibcli.analyses.nonlinear.period import exact_period
from vibcli.analyses.time_integration.integrate import simulate
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import lower

BLOCK = "bodies: {b: {mass: m, slide: x}}\n"
SPRING = "springs: {s: {k: k, between: [ground, b]}}\n"


def laws_in(x, a, n):
    t = x.table
    call = t.call
    u = a * x + 2
    return [t.number(3), a * x, x ** 3 * a, call("abs", x) * x, x * call("abs", x) ** (n - 1), call("sign", x) * a,
            call("max", x - a, t.zero), call("min", x + a, t.zero) ** 2, call("sin", u) * 2 + x, call("exp", -u) * a,
            (1 + x) ** 2 * x, call("power", u, a), call("tanh", x), u ** -1, call("ramp", x - 2) ** 3,
            t.sqrt(u) * u, call("cosh", x) - call("cos", 3 * x)]


def test_antiderivatives_against_quadrature():
    table = Table()
    x, a, n = table.variable("x"), table.parameter("a"), 3
    swept = 0
    for law in laws_in(x, a, n):
        energy = from_zero(law, x)
        for end in (0.3, 1.7, 4.0):
            with mpmath.workdps(20):
                wanted = mpmath.quad(lambda s, law=law: evaluate([law], Floats, {"x": float(s), "a": 1.3})[0],
                                     sorted({0, end, *(p for p in (1.3, 2.0) if p < end)}))
            assert evaluate([energy], Floats, {"x": end, "a": 1.3})[0] == pytest.approx(float(wanted), rel=1e-9,
                                                                                       abs=1e-12)
        swept += 1
    assert swept >= 17


CONTACTS = ["max(x, 0)^(3/2)", "ramp(x)^(3/2)", "step(x)*abs(x)^(3/2)", "step(x)*x*sqrt(abs(x))", "max(-x, 0)^(3/2)",
            "max(x, 0)^(5/4)*abs(x)^(1/4)", "max(x, 0)*sqrt(max(x, 0))", "ramp(x)", "max(a*x + 2, 0)^(3/2)",
            "max(x, 0)^(3/2) - max(-x, 0)^(3/2)"]


@pytest.mark.parametrize("written", CONTACTS)
def test_contacts_have_a_slope_on_both_sides_and_where_they_begin(written):
    """By the difference quotient of the law; at 0 a Hertzian contact is not stiff."""
    table = Table()
    x, a = table.variable("x"), table.parameter("a")
    law = lower(parse(written), table, lambda name, primes, tree: {"x": x, "a": a}[name])
    slope = gradient(gradient(from_zero(law, x))[x])[x]
    for place in (-3.1, -0.2, 0.7, 2.9):
        left, right = (evaluate([law], Floats, {"x": place + step, "a": 1.3})[0] for step in (-1e-6, 1e-6))
        found = evaluate([slope], Floats, {"x": place, "a": 1.3})[0]
        assert found == pytest.approx((right - left) / 2e-6, rel=1e-8, abs=1e-12)
    assert math.isfinite(evaluate([slope], Floats, {"x": 0.0, "a": 1.3})[0])


@pytest.mark.parametrize("written", [
    "sign(x)*abs(x)^(1/3)", "x/abs(x)^(2/3)", "x*abs(x)^(-2/3)", "sign(x)*sqrt(abs(x))", "x/sqrt(abs(x))", "x^3/abs(x)",
    "sign(x)*abs(x)^(-1/3)", "abs(x)^(1/3)", "abs(x)", "x^2*sign(x)", "x*sign(x)", "sign(x)^2*x", "abs(x)^a*sign(x)",
    "x*abs(x)^(a - 1)", "sign(a*x + 2)*abs(a*x + 2)^(1/3)", "(a*x + 2)/abs(a*x + 2)^(2/3)", "abs(-x)^(1/3)*sign(x)",
    "a*x + 3*x/abs(x)^(2/3)", "(x - 1)*abs(x - 1)^(3/2)",
    *(text for text in CONTACTS if "ramp" not in text and "step" not in text)])
def test_powers_of_sizes_are_integrated_to_both_sides(written):
    """The energy is that of quadrature left and right of 0, and its slope is the law, at 0 too where that is finite."""
    table = Table()
    x, a = table.variable("x"), table.parameter("a")
    law = lower(parse(written), table, lambda name, primes, tree: {"x": x, "a": a}[name])
    energy = from_zero(law, x)
    slope = gradient(energy)[x]
    with mpmath.workdps(25):
        names = {"x": mpmath.mpf(0), "a": mpmath.mpf("1.3")}
        kinks = (-2 / names["a"], mpmath.mpf(1))
        for end in (-3.1, 2.9):
            passed = sorted({mpmath.mpf(0), mpmath.mpf(end), *(p for p in kinks if min(0, end) < p < max(0, end))})
            path = passed if end > 0 else passed[::-1]
            wanted = mpmath.quad(lambda s: number(parse(written), names | {"x": s}, mpmath), path)
            at = {"x": end, "a": 1.3}
            assert evaluate([energy], Floats, at)[0] == pytest.approx(float(wanted), rel=1e-9)
            assert evaluate([slope], Floats, at)[0] == pytest.approx(evaluate([law], Floats, at)[0], rel=1e-12)
    if "-1/3" not in written and "^a" not in written and "(a - 1)" not in written:
        assert math.isfinite(evaluate([slope], Floats, {"x": 0.0, "a": 1.3})[0])


def test_what_has_no_antiderivative_is_said_so():
    table = Table()
    x = table.variable("x")
    for law in (table.call("exp", x * x), table.sqrt(1 + x * x), table.call("sin", x) * x, x ** -1):
        assert from_zero(law, x) is None


def test_a_duffing_law_swings_with_its_exact_period():
    scene = problem("parameters: {m: 2 kg, k: 200 N/m, k3: 3000 N/m^3}\n" + BLOCK
                    + "springs: {s: {law: k*d + k3*d^3, between: [ground, b]}}\n")
    period = float(duffing_period(10, 1500, 0.3))
    assert exact_period(scene.scene, scene.numeric.floats, 0.3, 0.0)[0] == pytest.approx(period, rel=1e-14)
    found = simulate(scene.configuration, 20 * period, initial={"x": 0.3})
    assert np.abs(found.at(np.arange(1, 21) * period)[0][0] - 0.3).max() < 1e-13


def test_a_law_counts_in_equilibrium_and_small_oscillations():
    scene = problem("parameters: {m: 2 kg, k: 300 N/m, k3: 1e4 N/m^3, F: 40 N}\n" + BLOCK
                    + "springs: {s: {law: k*d + k3*d^3, between: [ground, b]}}\nforces: {f: {at: b, force: F}}\n")
    assert scene.configuration.equilibrium.values["x"] == pytest.approx(0.1, rel=1e-14)
    assert [mode.omega for mode in scene.modal.modes] == pytest.approx([math.sqrt(300)], rel=1e-14)


def test_a_law_across_a_slide_has_geometric_stiffness():
    law = problem("parameters: {m: 2 kg, k: 300 N/m, N: 25 N}\nbodies:\n"
                  "  b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}\n"
                  "springs: {s: {law: N + k*d, between: [[0.6 m, 0], b]}}\n")
    assert law.modal.modes[0].omega == pytest.approx(math.sqrt(25 / 0.6 / 2), rel=1e-14)


@pytest.mark.parametrize("start", [0.1005, 0.2, 0.31])
def test_dry_friction_takes_as_much_each_half_swing_and_sticks(start):
    scene = problem("parameters: {m: 2 kg, k: 200 N/m, R: 3 N}\n" + BLOCK + SPRING
                    + "dampers: {d: {friction: R, between: [ground, b]}}\n")
    found = simulate(scene.configuration, 10.0, initial={"x": start})
    turn, x, n = math.pi / 10, start, 0
    while abs(x) > 0.015:
        x, n = -(x - math.copysign(0.03, x)), n + 1
        assert found.at([n * turn])[0][0, 0] == pytest.approx(x, abs=1e-13)
    assert found.at([10.0])[0][0, 0] == pytest.approx(x, abs=1e-13)
    assert found.events[-1].kind == "sticks" and found.events[-1].time == pytest.approx(n * turn, rel=1e-14)
    assert found.events[-1].name == "d"
    assert found.balance.error < 1e-14
    assert found.balance.dissipated[-1] == pytest.approx(100 * (start**2 - x**2), rel=1e-13)


def test_a_block_on_a_belt_sticks_and_slips():
    scene = problem("parameters: {m: 2 kg, k: 200 N/m, R: 3 N, Rs: 5 N, V: 0.1 m/s}\nbodies:\n"
                    "  b: {mass: m, slide: x}\n  belt: {slide: V*t}\n" + SPRING
                    + "dampers: {d: {friction: R, breakaway: Rs, between: [belt, b]}}\n")
    found = simulate(scene.configuration, 6.0, initial={"x": 0, "x'": 0.1})
    slips = [event.time for event in found.events if event.kind == "slips"]
    sticks = [event.time for event in found.events if event.kind == "sticks"]
    assert slips[0] == pytest.approx(5 / 200 / 0.1, rel=1e-13)      # when the spring pulls with Rs
    reach = math.hypot(0.01, 0.1 / 10)                              # amplitude about R/k
    away = 2 * (math.pi - math.acos(0.01 / reach))
    assert sticks[0] - slips[0] == pytest.approx(away / 10, rel=1e-12)
    assert len(slips) >= 5 and np.diff(slips) == pytest.approx(slips[1] - slips[0], rel=1e-12)


def test_two_blocks_with_friction_move_together_until_the_upper_slips():
    text = ("parameters: {m: 1 kg, M: 3 kg, R: 2 N, A: %s N, W: 5 rad/s}\nbodies:\n  lower: {mass: M, slide: x}\n"
            "  upper: {mass: m, slide: y}\ndampers: {d: {friction: R, between: [lower, upper]}}\n"
            "forces: {f: {at: lower, force: A*sin(W*t)}}\n")
    gentle = simulate(problem(text % 7).configuration, 3.0,
                      initial={"x": 0, "y": 0, "x'": -7 / 4 / 5, "y'": -7 / 4 / 5})
    q, _, _ = gentle.at(np.linspace(0, 3, 50))
    assert np.abs(q[0] - q[1]).max() < 1e-15 and not gentle.events
    assert np.abs(q[0] + 7 / 4 / 25 * np.sin(5 * np.linspace(0, 3, 50))).max() < 1e-13
    wild = simulate(problem(text % 20).configuration, 3.0, initial={"x": 0, "y": 0})
    first = next(event for event in wild.events if event.kind == "slips")
    assert first.time == pytest.approx(math.asin(8 / 20) / 5, rel=1e-12)
    assert wild.balance.error < 1e-13


@pytest.mark.sweep
def test_a_stop_with_clearance_gives_half_a_sine():
    scene = problem("parameters: {m: 1 kg, k: 1e4 N/m, gap: 0.5 m}\n" + BLOCK
                    + "springs: {s: {k: k, gap: gap, between: [ground, b]}}\n")
    found = simulate(scene.configuration, 20.0, initial={"x": 0, "x'": 2})
    assert [event.time for event in found.events[:3]] == pytest.approx(
        [0.25, 0.25 + math.pi / 100, 0.75 + math.pi / 100], rel=1e-14)
    assert found.balance.error < 1e-13
    lap = 1 + 2 * math.pi / 100
    assert np.abs(found.at(np.arange(1, 19) * lap)[0]).max() < 1e-12


def test_a_ball_dropped_on_a_stiff_floor_comes_back_as_high():
    scene = problem("parameters: {m: 0.2 kg, k: 1e6 N/m, g: 9.81 m/s^2, h: 0.5 m}\ngravity: g\nbodies:\n"
                    "  ball: {mass: m, at: [0, h], slide: {along: [0, 1], by: y}}\n"
                    "springs: {floor: {k: k, acts: compression, gap: h - 0.1 m, between: [[0, -0.1 m], ball]}}\n")
    found = simulate(scene.configuration, 6.0, initial={"y": 0, "y'": 0})
    fall = math.sqrt(2 * 0.4 / 9.81)
    assert found.events[0].time == pytest.approx(fall, rel=1e-14)
    omega, v = math.sqrt(1e6 / 0.2), 9.81 * fall
    touch = 2 * (math.pi - math.atan2(v * omega, 9.81)) / omega
    again = 2 * fall + touch
    for bounce in range(1, 7):
        assert found.at([bounce * again])[0][0, 0] == pytest.approx(0, abs=1e-11)


def test_a_cable_goes_slack_and_pulls_again():
    scene = problem("parameters: {m: 1 kg, k: 100 N/m, N: 5 N}\n" + BLOCK
                    + "springs: {s: {k: k, acts: tension, preload: N, between: [ground, b]}}\n"
                    "forces: {f: {at: b, force: N}}\n")
    found = simulate(scene.configuration, 3.0, initial={"x": 0.08, "x'": 0})
    first = math.acos(-0.05 / 0.08) / 10
    assert found.events[0].time == pytest.approx(first, rel=1e-13)
    speed = 0.8 * math.sin(10 * first)
    assert found.events[1].time - first == pytest.approx(2 * speed / 5, rel=1e-12)


def test_small_oscillations_of_stops():
    text = ("parameters: {m: 2 kg, k: 200 N/m}\n" + BLOCK + "springs:\n  s: {k: k, between: [ground, b]}\n"
            "  t: {k: 5*k, %s between: [ground, b]}\n")
    assert problem(text % "gap: 1 mm,").modal.modes[0].omega == pytest.approx(10)
    assert problem(text % "acts: tension, preload: 3 N," + "forces: {f: {at: b, force: 3 N}}").modal.modes[0].omega == (
        pytest.approx(math.sqrt(600)))
    with pytest.raises(PhysicsError, match="kink"):
        _ = problem(text % "acts: tension,").modal.modes


def test_quadratic_damping_against_its_first_integral():
    scene = problem("parameters: {m: 2 kg, k: 200 N/m, c: 8 kg/m}\n" + BLOCK + SPRING
                    + "dampers: {d: {law: c*v*abs(v), between: [ground, b]}}\n")
    found = simulate(scene.configuration, 3.0, initial={"x": 0.2})
    turns = [event.time for event in found.events]
    places = np.abs([0.2, *found.at(turns)[0][0]])
    for before, after in pairwise(places):
        assert (1 - 8 * after) * math.exp(8 * after) == pytest.approx((1 + 8 * before) * math.exp(-8 * before),
                                                                      rel=1e-12)
    assert len(turns) == 9


def test_friction_that_locks_is_refused_without_hanging():
    scene = problem("parameters: {m: 1 kg, R: 2 N}\nbodies: {b: {mass: m, slide: x}}\n"
                    "forces: {f: {at: b, force: R*sign(x')}}\n")
    found = simulate(scene.configuration, 1.0, initial={"x": 0, "x'": 0})
    assert abs(found.at([1.0])[0][0, 0]) == pytest.approx(1.0, rel=1e-13)


def test_the_modes_of_a_law_that_bends_are_printed(tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text("parameters: {m: 2 kg, k: 3e5 N/m^(3/2), g: 9.81 m/s^2}\ngravity: g\n"
                    "bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, -1], by: x}}}\n"
                    "springs: {s: {law: k*sign(d)*abs(d)^(3/2), between: [[0, 0.3 m], b]}}\n")
    assert run(["solve", str(file)]) == 0 and "95.2111" in capsys.readouterr().out
