"""Worked solutions of motions that are no small oscillations: the integral of energy held against quadrature by hand,
and half cycles under dry friction."""

import math
import re

import mpmath
import numpy as np
import pytest
from scipy.linalg import expm
from support.scenes import problem

import vibcli
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps import dry_friction, motion_in_time
from vibcli.report.steps.worked import worked

DIGITS = str.maketrans("₁₂", "12")
PENDULUM = """
parameters: {m: 0.4 kg, L: 0.8 m, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
initial: {phi: 2 rad, phi': 1.5 rad/s}
motion: full
"""
DUFFING = """
parameters: {m: 2 kg, k: 30 N/m, b: 900 N/m^3, F: 4 N}
bodies: {b: {mass: m, slide: x}}
springs: {s: {law: k*d + b*d^3, between: [ground, b]}}
forces: {f: {at: b, force: F}}
initial: {x: 0.4 m}
motion: full
"""
RUBBED = """
parameters: {m: 2 kg, k: 200 N/m, R: 3 N, Rs: 4 N, F: 5 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {floor: {friction: R, breakaway: Rs, between: [ground, block]}}
forces: {f: {at: block, force: F}}
initial: {x: 0.2 m}
motion: full
"""


def told(text):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in worked(problem(text))]


def by_name(text):
    return {line.settles: line for line in worked(problem(text))}


def test_the_integral_of_energy_of_a_pendulum():
    """T = 4 √(L/g) K(sin ½φ_max) and φ̇² = 2(E + mgL cos φ)/(mL²) (Landau & Lifshitz, Mechanics, section 11)."""
    lines = by_name(PENDULUM)
    E = 0.4 * 0.64 * 1.5**2 / 2 - 0.4 * 9.81 * 0.8 * math.cos(2)
    assert lines["E"].value == pytest.approx(E, rel=1e-13)
    widest = math.acos(-E / (0.4 * 9.81 * 0.8))
    period = 4 * math.sqrt(0.8 / 9.81) * float(mpmath.ellipk(math.sin(widest / 2)**2))
    assert lines["period(phi)"].value == pytest.approx(period, rel=1e-12)
    fastest = math.sqrt(2 * (E + 0.4 * 9.81 * 0.8) / 0.256)
    assert lines["max(phi')"].value == pytest.approx(fastest, rel=1e-12)
    text = told(PENDULUM)
    assert any("m·L²·φ̇²/2 − m·L·g·cos φ = E" in line for line in text), text
    assert any("φ̇² = (2·m·L·g·cos φ + 2·E)/(m·L²)" in line for line in text), text
    ends = re.findall(r"φ = (−?[\d.]+) rad", next(line for line in text if line.startswith("it turns where")))
    assert [float(end.replace("−", "-")) for end in ends] == pytest.approx([-widest, widest], rel=1e-5)


@pytest.mark.sweep
@mpmath.workdps(40)
def test_the_integral_of_energy_under_a_steady_force():
    """The turning places are roots of V = E, the period twice the integral between them."""
    lines, text = by_name(DUFFING), told(DUFFING)
    E = lines["E"].value
    assert math.isclose(E, 15 * 0.16 + 225 * 0.4**4 - 4 * 0.4, rel_tol=1e-13)
    start = mpmath.mpf("0.4")
    exact = 15 * start**2 + 225 * start**4 - 4 * start
    other = mpmath.findroot(lambda x: 15 * x**2 + 225 * x**4 - 4 * x - exact, -0.38)
    assert any(f"x = −{float(-other):.6g} m and x = 0.4 m" in line for line in text), (other, text)
    middle, half = (start + other) / 2, (start - other) / 2

    def rate(angle):
        x = middle + half * mpmath.sin(angle)
        return half * mpmath.cos(angle) / mpmath.sqrt(exact - 15 * x**2 - 225 * x**4 + 4 * x)

    period = 2 * mpmath.quad(rate, [-mpmath.pi / 2, 0, mpmath.pi / 2])
    assert lines["period(x)"].value == pytest.approx(float(period), rel=1e-9)


@pytest.mark.parametrize("scene", [
    PENDULUM.replace("motion: full\n", ""), PENDULUM.replace("phi: 2 rad, phi': 1.5", "phi: 2 rad, phi': 15"),
    PENDULUM + "dampers: {d: {c: 1 N*s/m, between: [[0, -1 m], bob]}}\n"])
def test_what_has_no_such_integral_or_does_not_come_back(scene):
    """Small oscillations, a pendulum that turns over, one with a dashpot: no period is told."""
    assert "period(phi)" not in by_name(scene)


def test_a_wrong_potential_is_not_told(monkeypatch):
    """What is no integral of the engine's equation is left out."""
    whole = motion_in_time.EnergyIntegral.__init__

    def wrong(self, *args):
        whole(self, *args)
        self.V = 2 * self.V

    monkeypatch.setattr(motion_in_time.EnergyIntegral, "__init__", wrong)
    assert "E" not in by_name(PENDULUM)


@pytest.mark.sweep
@pytest.mark.parametrize(("start", "turns"), [
    ("0.2 m", [-0.12, 0.14, -0.06, 0.08, 0.0, 0.02]), ("-0.09 m", [0.11, -0.03, 0.05, 0.01]), ("0.04 m", [])])
def test_half_cycles_under_dry_friction(tmp_path, start, turns):
    """About (F ∓ R)/k = 0.01 and 0.04 m, by hand until |200 x − 5| ≤ 4, that is from 0.005 to 0.045 m."""
    scene = RUBBED.replace("x: 0.2 m", f"x: {start}")
    place, found = float(start.split()[0]), []
    while abs(200 * (found or [place])[-1] - 5) > 4:
        last = (found or [place])[-1]
        found.append(2 * (0.04 if last > 0.025 else 0.01) - last)
    path = tmp_path / "scene.yaml"
    path.write_text(scene)
    engine, lines = vibcli.load(path), by_name(scene)
    end = len(found) * math.pi / 10
    final = lines["final(x)"].value
    assert final == pytest.approx((found or [place])[-1], rel=1e-12)
    assert engine[f"x({end + 0.3} s)"].value == pytest.approx(final, rel=1e-9)
    text, = (line for line in told(scene) if "it goes to" in line or "stays where it starts" in line)
    if found:
        assert f"after {len(found)} half cycle" in text
        listed = text.partition("it goes to")[2].partition(" m,")[0].replace("−", "-")
        assert [float(one) for one in listed.split(",")] == pytest.approx(found, abs=1e-6)
    else:
        assert "so it stays where it starts" in text


def test_half_cycles_that_the_engine_has_not_are_not_told(monkeypatch):
    assert "final(x)" in by_name(RUBBED)
    whole = dry_friction.coulomb
    monkeypatch.setattr(dry_friction, "coulomb", lambda scene: whole(scene)._replace(R=2 * whole(scene).R))
    assert "final(x)" not in by_name(RUBBED)


def without_units(text):
    """A formula as Python reads it, (9 1/s)·t as 9*t."""
    return re.sub(r"\(([\d.]+)\u00a0[^()]*\)", r"\1", text).replace("·", "*").replace("−", "-")


@pytest.mark.parametrize(("c", "roots", "F"), [("6", 2, 0), ("60", 3, 0), ("6", 2, 5), ("0", 0, 5)])
def test_a_motion_from_the_start_is_a_sum_of_modes_beside_what_is_kept_up(c, roots, F):
    """Where damping couples them, of complex ones; held against expm of the state matrix, with the load as a state."""
    load = "forces: {f: {at: a, force: 5 N*sin(9 rad/s*t)}}" if F else ""
    found = problem(f"""
        parameters: {{m1: 2 kg, m2: 1 kg, k1: 800 N/m, k2: 300 N/m}}
        bodies: {{a: {{mass: m1, slide: x1}}, b: {{mass: m2, slide: x2}}}}
        springs: {{s1: {{k: k1, between: [ground, a]}}, s2: {{k: k2, between: [a, b]}}}}
        {f"dampers: {{d: {{c: {c} N*s/m, between: [a, b]}}}}" if roots else ""}
        {load}
        initial: {{x1: 10 mm, x2': 0.3 m/s}}
        answers: {{x1(0.3 s): 0 m}}
    """)
    lines = worked(found)
    settled = {line.settles: formula(line.parts, plain).translate(DIGITS) for line in lines}
    assert sum(key.startswith("part ") for key in settled) == roots
    C = float(c) * np.array([[1, -1], [-1, 1]])
    M, K = np.diag([2.0, 1.0]), np.array([[1100.0, -300.0], [-300.0, 300.0]])
    A = np.zeros((6, 6))        # the last two states are sin 9t and 9 cos 9t
    A[:2, 2:4], A[2:4, :2], A[2:4, 2:4] = np.eye(2), -np.linalg.solve(M, K), -np.linalg.solve(M, C)
    A[2, 4], A[4, 5], A[5, 4] = F / 2, 1, -81
    t, values = 0.3, {line.settles: line.value for line in lines}
    letters = {f"{letter}{i}{bar}": values.get(of.format(i)) for i in (1, 2) for letter, of, bar in (
        ("δ", "decay[{}]", ""), ("ω_d", "omega_d[{}]", ""), ("ω", "omega[{}]", ""), ("X", "amplitude(x{})", ""),
        ("|X", "amplitude(x{})", "|"), ("θ", "phase(x{})", ""))}
    due = expm(A * t) @ np.array([0.01, 0, 0, 0.3, 0, 9])
    for name, wanted in (("x1", due[0]), ("x2", due[1])):
        told = without_units(settled[f"motion of {name}"].split(" = ")[1].partition("   (in m")[0])
        value = eval(re.sub(r"δ\d|ω_d\d|ω\d|\|X\d\||X\d|θ\d", lambda one: f"({letters[one.group()]})", told),
                     {"cos": math.cos, "sin": math.sin, "exp": math.exp, "t": t})
        assert value == pytest.approx(wanted, rel=2e-4)


@pytest.mark.parametrize("c", ["8", "0"])
def test_what_moves_freely_goes_on_with_its_speed_beside_what_vibrates(c):
    """Two wagons that nothing holds, held against expm of the state matrix."""
    scene = f"""
        parameters: {{m1: 3 kg, m2: 5 kg, k: 1.2 kN/m, c: {c} N*s/m}}
        bodies: {{a: {{mass: m1, slide: x}}, b: {{mass: m2, slide: y}}}}
        springs: {{s: {{k: k, between: [a, b]}}}}
        dampers: {{d: {{c: c, between: [a, b]}}}}
        initial: {{x: 2 cm, y': 0.1 m/s}}
        answers: {{x(1.3 s): 0 m}}
    """ if float(c) else """
        parameters: {m1: 3 kg, m2: 5 kg, k: 1.2 kN/m}
        bodies: {a: {mass: m1, slide: x}, b: {mass: m2, slide: y}}
        springs: {s: {k: k, between: [a, b]}}
        initial: {x: 2 cm, y': 0.1 m/s}
        answers: {x(1.3 s): 0 m}
    """
    lines = worked(problem(scene))
    settled = {line.settles: formula(line.parts, plain).translate(DIGITS) for line in lines}
    assert settled["start of mode 1"].endswith("as ω1 = 0 it moves freely,  p1 = p1(0) + ṗ1(0)·t")
    minus, couples, A, t = -np.diag([1 / 3, 1 / 5]), np.array([[1, -1], [-1, 1]]), np.zeros((4, 4)), 1.3
    A[:2, 2:], A[2:, :2], A[2:, 2:] = np.eye(2), minus @ couples * 1200, minus @ couples * float(c)
    values = {line.settles: line.value for line in lines}
    letters = {"δ2": values.get("decay[2]"), "ω_d2": values.get("omega_d[2]"), "ω2": values["omega[2]"]}
    for name, wanted in zip("xy", expm(A * t) @ np.array([0.02, 0, 0, 0.1]), strict=False):
        told = without_units(settled[f"motion of {name}"].split(" = ")[1].partition("   (in m")[0])
        value = eval(re.sub(r"δ2|ω_d2|ω2", lambda one: f"({letters[one.group()]})", told),
                     {"cos": math.cos, "sin": math.sin, "exp": math.exp, "t": t})
        assert value == pytest.approx(wanted, rel=2e-4, abs=1e-7)


@pytest.mark.parametrize("c", ["6", "0"])
def test_under_two_harmonics_and_a_steady_load_each_keeps_up_its_own(c):
    """Held against expm of the state matrix with the loads as states: sin 9t, 9 cos 9t, cos 5t, −5 sin 5t, 1."""
    lines = worked(problem(f"""
        parameters: {{m1: 2 kg, m2: 1 kg, k1: 800 N/m, k2: 300 N/m}}
        bodies: {{a: {{mass: m1, slide: x1}}, b: {{mass: m2, slide: x2}}}}
        springs: {{s1: {{k: k1, between: [ground, a]}}, s2: {{k: k2, between: [a, b]}}}}
        {f"dampers: {{d: {{c: {c} N*s/m, between: [a, b]}}}}" if c != "0" else ""}
        forces: {{f: {{at: a, force: 5 N*sin(9 rad/s*t) + 4 N}}, g: {{at: b, force: 3 N*cos(5 rad/s*t)}}}}
        initial: {{x1: 10 mm, x2: 0 m, x2': 0.3 m/s}}
        answers: {{x1(0.3 s): 0 m}}
    """))
    settled = {line.settles: formula(line.parts, plain).translate(DIGITS) for line in lines}
    values = {line.settles: line.value for line in lines}
    C, K = float(c) * np.array([[1, -1], [-1, 1]]), np.array([[1100.0, -300.0], [-300.0, 300.0]])
    minus = -np.diag([0.5, 1.0])
    A = np.zeros((9, 9))
    A[:2, 2:4], A[2:4, :2], A[2:4, 2:4] = np.eye(2), minus @ K, minus @ C
    A[2, 4], A[2, 8], A[3, 6], A[4, 5], A[5, 4], A[6, 7], A[7, 6] = 5 / 2, 4 / 2, 3, 1, -81, 1, -25
    t, rest = 0.3, np.linalg.solve(K, [4.0, 0.0])
    due = (expm(A * t) @ np.array([0.01, 0, 0, 0.3, 0, 9, 1, 0, 1]))[:2] - rest
    letters = {f"{letter}{i}": values.get(of.format(i)) for i in (1, 2) for letter, of in (
        ("δ", "decay[{}]"), ("ω_d", "omega_d[{}]"), ("ω", "omega[{}]"))}
    signed = {name: float(number.replace("−", "-")) for text in settled.values() for name, number in re.findall(
        r"((?<!\|)X\d\d) = (?:[^=|]+ = )?(−?[\d.e−]+) m", text)}
    letters |= {f"|X{i}{n}|": values.get(f"amplitude {n} of x{i}") for i in (1, 2) for n in (1, 2)}
    letters |= {f"θ{i}{n}": values.get(f"lag {n} of x{i}") for i in (1, 2) for n in (1, 2)} | signed
    for name, wanted in zip(("x1", "x2"), due, strict=True):
        told = without_units(settled[f"motion of {name}"].split(" = ")[1].partition("   (in m")[0])
        value = eval(re.sub(r"δ\d|ω_d\d|ω\d|\|X\d\d\||X\d\d|θ\d\d", lambda one: f"({letters[one.group()]})", told),
                     {"cos": math.cos, "sin": math.sin, "exp": math.exp, "t": t})
        assert value == pytest.approx(wanted, rel=2e-4, abs=1e-7)


def test_the_energy_of_a_pendulum_let_go_level_is_zero():
    """Not what is left of −m g L cos φ at the float next to π/2."""
    lines = worked(problem(PENDULUM.replace("phi: 2 rad, phi': 1.5 rad/s", "phi: 90 deg")))
    assert next(line.value for line in lines if line.settles == "E") == 0.0


def test_what_is_asked_of_a_place_in_time_is_told_as_counted():
    """Where lines count from rest, what the file asks of them is as drawn; speeds are the same."""
    lines = by_name("""
        parameters: {m: 2 kg, k: 300 N/m, g: 9.81 m/s^2}
        gravity: g
        bodies: {A: {mass: m, at: [0, 0], slide: {along: [0, -1], by: x}}}
        springs: {s: {k: k, between: [[0, 1 m], A]}}
        initial: {x: 2 cm}
        answers: {x(0.3 s): 0 m, max(x): 0 m, "x'(0.2 s)": 0 m/s}
    """)
    said = {key: formula(line.parts, plain).replace("\u00a0", " ") for key, line in lines.items()}
    assert said["x(0.3 s)"] == "x(0.3 s) = 0.104511 m (counted as drawn)"
    assert said["max(x)"] == "max(x):  m·g/k − A = 0.1108 m (counted as drawn)"
    assert "counted" not in said["x'(0.2 s)"]
