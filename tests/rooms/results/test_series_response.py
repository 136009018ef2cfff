"""Full motions to any number of digits, against equations written by hand and against elliptic functions."""

import json
from fractions import Fraction

import mpmath
import pytest
from mpmath import cos, mpf, sin
from support.extrapolation import solved
from support.motions import DOUBLE, FOUR_BAR, PENDULUM
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.symbolic.syntax import NameRef

DIGITS = 25
with mpmath.workdps(60):
    G = mpf(981) / 100


def precise(text, name, t, digits=DIGITS, primes=0):
    """A coordinate at an instant of the full motion of a scene."""
    found = problem(text + "motion: full\n")
    return found.response.signal(NameRef(0, 0, name, primes)).precise(Fraction(t), digits)


def agrees(found, exact, digits=DIGITS):
    return abs(found - exact) <= abs(exact) * mpf(10) ** -digits


@pytest.mark.sweep
def test_a_pendulum_against_elliptic_functions():
    """sin(φ/2) = k cd(ω t, k) of a pendulum let go at rest, k = sin(φ₀/2)."""
    found = precise(PENDULUM + "initial: {phi: 2.5 rad}\n", "phi", "7.3", 40)
    with mpmath.workdps(60):
        k, w = sin(mpf(5) / 4), mpmath.sqrt(mpf(981) / 80)
        exact = 2 * mpmath.asin(k * mpmath.ellipfun("cd", w * mpf(73) / 10, k=k))
        assert agrees(found, exact, 40)


DUFFING = """
parameters: {m: 2 kg, k: 300 N/m, k3: 10000 N/m^3, c: 3 N*s/m, F: 40 N, W: 11 rad/s}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + k3*d^3, between: [ground, block]}}
dampers: {d: {law: c*v + (2 kg/m)*v^2, between: [ground, block]}}
forces: {load: {at: block, force: F*cos(W*t)}}
initial: {x: 3 cm, x': 0.2 m/s}
"""
CART = """
parameters: {M: 2 kg, m: 0.5 kg, L: 0.7 m, k: 30 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1 m, 0], cart]}}
initial: {x: 0.1 m, phi: 1.5 rad}
"""
SPRUNG_BOB = """
parameters: {m: 1 kg, k: 200 N/m, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -0.5 m], move: [x, z, 0]}}
springs: {s: {k: k, free_length: 0.5 m, between: [[0, 0], bob]}}
initial: {x: 0.3 m, z: 0.1 m}
"""
SHAKEN = """
parameters: {m: 0.4 kg, L: 0.8 m, g: 9.81 m/s^2, A: 5 cm, W: 17 rad/s}
gravity: g
bodies:
  base: {mass: 1 kg, at: [0, 0], slide: {along: [0, 1], by: A*sin(W*t)}}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: base, by: phi}}
initial: {phi: 1 rad}
"""


def duffing(t, y):
    x, v = y
    return [v, (40 * cos(11 * t) - 300 * x - 10000 * x**3 - 3 * v - 2 * v**2) / 2]


def cart(t, y):
    _, phi, u, w = y
    M, m, L = mpf(2), mpf(1) / 2, mpf(7) / 10
    force = m * L * w**2 * sin(phi) - 30 * y[0]
    a = (force + m * G * sin(phi) * cos(phi)) / (M + m * sin(phi) ** 2)
    return [u, w, a, -(a * cos(phi) + G * sin(phi)) / L]


def sprung_bob(t, y):
    """From the suspension: x to the right, z upwards."""
    x, z, u, w = y
    r = mpmath.sqrt(x * x + (z - mpf(1) / 2) ** 2)
    pull = 200 * (1 - 1 / (2 * r))
    return [u, w, -pull * x, -pull * (z - mpf(1) / 2) - G]


def shaken(t, y):
    """L φ̈ = −(g + ÿ) sin φ"""
    return [y[1], -(G - mpf(5) / 100 * 289 * sin(17 * t)) * sin(y[0]) / (mpf(8) / 10)]


def double(t, y):
    p, r, u, w = y
    d, s = p - r, sin(p - r)
    below = 2 - cos(d) ** 2
    a = (-2 * G * sin(p) - w**2 * s + cos(d) * (G * sin(r) - u**2 * s)) / below
    return [u, w, a, -G * sin(r) + u**2 * s - cos(d) * a]


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "name", "t", "slope", "start", "number"), [
    (DUFFING, "x", "0.8", duffing, ("0.03", "0.2"), 0),
    (CART, "phi", "0.9", cart, ("0.1", "1.5", 0, 0), 1),
    (SPRUNG_BOB, "z", "0.5", sprung_bob, ("0.3", "0.1", 0, 0), 1),
    (SHAKEN, "phi", "0.7", shaken, (1, 0), 0),
    (DOUBLE + "initial: {p: 2 rad, r: 2.5 rad}\n", "r", "0.8", double, (2, "2.5", 0, 0), 1)])
def test_against_equations_by_hand(text, name, t, slope, start, number):
    with mpmath.workdps(DIGITS + 15):
        exact = solved(slope, [mpf(x) for x in start], mpf(t), DIGITS + 1)[number]
        assert agrees(precise(text, name, t), exact)


@pytest.mark.sweep
def test_a_closed_loop_keeps_its_energy_and_its_lengths():
    found = problem(FOUR_BAR + "initial: {alpha: 0.6 rad, alpha': 2 rad/s}\nmotion: full\n")
    signal, zero = found.response.signal, NameRef(0, 0, "T", 0)
    energy = [signal(zero).precise(Fraction(t), 30) + signal(zero._replace(name="V")).precise(Fraction(t), 30)
              for t in ("0", "0.7")]
    assert agrees(*energy)
    alpha, beta = (signal(zero._replace(name=name)).precise(Fraction("0.7"), 30) for name in ("alpha", "beta"))
    with mpmath.workdps(40):
        crank = mpmath.mpc(0, mpf(3) / 10) * mpmath.expj(alpha)
        end = crank + mpmath.mpc(1, mpf(1) / 2) * mpmath.expj(beta)
        assert agrees(abs(end - 1), mpf(8) / 10)


@pytest.mark.sweep
def test_no_horizon_from_an_unstable_place():
    """Let go 1e-25 rad below the top: floats see it rest there for ever."""
    found = problem(PENDULUM + "initial: {phi: pi - 1e-25}\nmotion: full\n")
    with mpmath.workdps(90):
        k, w = cos(mpf(10) ** -25 / 2), mpmath.sqrt(mpf(981) / 80)
        exact = 2 * mpmath.asin(k * mpmath.ellipfun("cd", 20 * w, m=k**2))
        half = 2 * mpmath.ellipk(k**2) / w
    found = found.with_digits(14).until(36.0)
    assert value(found, "phi(20 s)") == pytest.approx(float(exact), rel=1e-14)
    assert value(found, "argmin(phi)") == pytest.approx(float(half), rel=1e-15)
    assert value(found, "zero[1](phi)") == pytest.approx(float(half / 2), rel=1e-15)


@pytest.mark.sweep
def test_extremes_and_zeros_to_many_digits():
    """Of a pendulum: φ̇ is largest at the bottom, where φ vanishes, after a quarter of the period 4 K(k)/ω."""
    found = problem(PENDULUM + "initial: {phi: -2.5 rad}\nmotion: full\n").with_digits(30)
    signal = found.response.signal
    with mpmath.workdps(60):
        k, w = sin(mpf(5) / 4), mpmath.sqrt(mpf(981) / 80)
        quarter, speed = mpmath.ellipk(k**2) / w, 2 * w * k
        t, top = signal(NameRef(0, 0, "phi", 1)).precise_extreme(0.0, 5.0, 1, 30)
        assert agrees(t, quarter, 30) and agrees(top, speed, 30)
        assert agrees(signal(NameRef(0, 0, "phi", 0)).precise_zero(3 * float(quarter), 30), 3 * quarter, 30)
    assert value(found.until(5.0), "zero[2](phi)") == pytest.approx(float(3 * quarter), rel=1e-15)


@pytest.mark.sweep
def test_extremes_and_values_go_together():
    found = problem(DOUBLE + "initial: {p: 3 rad, r: 3 rad}\nmotion: full\n").with_digits(12).until(2.0)
    at = value(found, "argmax(p')")
    assert value(found, f"p'({at!r} s)") == pytest.approx(value(found, "max(p')"), rel=1e-14)
    assert value(found, f"p''({at!r} s)") == pytest.approx(0, abs=1e-10)


@pytest.mark.sweep
def test_what_is_largest_where_it_touches_zero():
    """x = −y: x y is largest, 0, where both vanish; the period is that of each, x(t + T) = x(t)."""
    text = "parameters: {m: 1 kg, k: 200 N/m, k3: 5 kN/m^3}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
    springs = "".join(f"  {s}: {{law: k*d + k3*d^3, between: [ground, {s[-1]}]}}\n" for s in ("sa", "sb"))
    scene = problem(f"{text}springs:\n{springs}initial: {{x: 10 cm, y: -10 cm}}\nmotion: full\n").with_digits(20)
    found = scene.until(1.0)
    assert value(found, "max(x*y)") == 0
    period = value(found, "period(x - 2*y)")
    assert value(found, f"x({period!r} s)") == pytest.approx(0.1, rel=1e-13)
    assert value(found, "zero[2](x)") == pytest.approx(0.75 * period, rel=1e-14)


def test_steps_and_pulses_of_the_time_end_steps():
    """m ẍ + k x = F step(t − t₁) |sin Ω t|: by pieces, each in closed form."""
    text = """
parameters: {m: 2 kg, k: 50 N/m, F: 3 N, W: 2 rad/s, t1: (1 s)/3}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
forces: {load: {at: block, force: F*step(t - t1)*abs(sin(W*t))}}
initial: {x: 1 cm}
"""
    with mpmath.workdps(45):
        w, W, t = mpf(5), mpf(2), mpf("4.1")
        pieces = [mpf(1) / 3, mpmath.pi / 2, mpmath.pi, t]
        exact = mpf(1) / 100 * cos(w * t)
        for a, b, sign in zip(pieces, pieces[1:], (1, -1, 1), strict=False):
            def part(s):
                """∫ sin W s sin w (t − s) ds"""
                return (sin((W + w) * s - w * t) / (W + w) - sin((W - w) * s + w * t) / (W - w)) / 2
            exact += sign * mpf(3) / (2 * w) * (part(b) - part(a))
        assert agrees(precise(text, "x", "4.1", 30), exact, 30)


@pytest.mark.sweep
def test_what_falls_and_what_is_thrown():
    """y = 3 t − g t²/2 and x = 2 t for as long as one likes: one step, whose turns are found all the same."""
    text = "gravity: 9.81 m/s^2\nbodies: {a: {mass: 1 kg, at: [0, 0], %s}}\nmotion: full\n"
    falling = problem(text % "slide: {along: [0, 1], by: y}").with_digits(20).response.signal(NameRef(0, 0, "y", 0))
    thrown = problem(text % "move: [x, y, 0]" + "initial: {x': 2 m/s, y': 3 m/s}\n").with_digits(20).response.signal
    t, top = thrown(NameRef(0, 0, "y", 0)).precise_extreme(0.0, 1e9, 1, 20)
    with mpmath.workdps(40):
        assert agrees(falling.precise(Fraction(2), 20), -2 * G, 20)
        assert agrees(t, 3 / G, 20) and agrees(top, 9 / (2 * G), 20)


def test_a_force_lets_go_and_what_rests_stays():
    text = """
gravity: 9.81 m/s^2
parameters: {m: 2 kg, k: 300 N/m, k3: 7 kN/m^3, F: 5 N}
bodies: {block: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {law: k*d + k3*d^3, between: [[0, 1 m], block]}}
forces: {pull: {at: block, force: [0, -F]}}
"""
    with mpmath.workdps(60):
        rest = mpmath.findroot(lambda d: 300 * d + 7000 * d**3 - 2 * G - 5, 0.06)
        assert agrees(precise(text + "initial: {released: pull}\n", "y", 0, 40), -rest, 40)
        assert agrees(precise(text, "y", 1, 40), -rest, 40)
        assert precise(text, "y", 1, 40, 1) == 0


@pytest.mark.sweep
@pytest.mark.parametrize("width", ["0.01"])
def test_a_pulse_that_is_nothing_before_is_not_stepped_over(width):
    """Of m ẍ + k x = F e^{−((t − t₁)/τ)²} at rest, long after: x = F √π τ/(m ω) e^{−(ωτ/2)²} sin ω(t − t₁)."""
    text = f"""
bodies: {{block: {{mass: 2 kg, slide: x}}}}
springs: {{s: {{k: 50 N/m, between: [ground, block]}}}}
forces: {{load: {{at: block, force: (3 N)*exp(-((t - 5 s)/({width} s))^2)}}}}
initial: {{x: 0}}
"""
    with mpmath.workdps(40):
        tau = mpf(width)
        exact = 3 * mpmath.sqrt(mpmath.pi) * tau / 10 * mpmath.exp(-((5 * tau / 2) ** 2)) * sin(mpf(25))
        assert agrees(precise(text, "x", 10, 20), exact, 20)


@pytest.mark.parametrize(("extra", "told"), [
    ("dampers: {d: {friction: 2 N, between: [ground, block]}}", "'d' bends or jumps with the motion"),
    ("springs: {s: {k: 50 N/m, gap: 1 cm, acts: compression, between: [block, ground]}}", "'s' bends or jumps"),
    ("forces: {f: {at: block, force: -(2 kg/m)*x'*abs(x')}}", "abs(…) bends or jumps"),
    ("forces: {f: {at: block, force: (2 N*s)*impulse(t - 1 s)}}", "an impulse drives this motion")])
def test_what_bends_with_the_motion_is_refused_by_name(extra, told):
    with pytest.raises(PhysicsError, match=told.replace("(", r"\(").replace(")", r"\)")):
        precise("bodies: {block: {mass: 2 kg, slide: x}}\ninitial: {x: 1 cm}\n" + extra + "\n", "x", 2)


@pytest.mark.sweep
def test_what_would_take_minutes_is_refused_with_the_estimate():
    with pytest.raises(PhysicsError, match=r"would take about .* steps of a million products") as refusal:
        precise(DOUBLE + "initial: {p: 3 rad, r: 3 rad}\n", "p", 1000, 100)
    assert "--patience" in refusal.value.hint


def run_on(tmp_path, text, *args):
    """(exit code, of `vibcli` on a scene written out)"""
    path = tmp_path / "scene.yaml"
    path.write_text(text + "motion: full\n", encoding="utf-8")
    return run([args[0], str(path), *args[1:]])


@pytest.mark.sweep
def test_the_commands_print_them(tmp_path, capsys):
    swing = PENDULUM + "initial: {phi: -2.5 rad}\nfind: [{response: {until: 2 s}}]\n"
    with mpmath.workdps(60):
        k, w = sin(mpf(5) / 4), mpmath.sqrt(mpf(981) / 80)
        at = mpmath.nstr(-2 * mpmath.asin(k * mpmath.ellipfun("cd", w * 3, k=k)), 30)
        top = mpmath.nstr(2 * w * k, 30)
    assert run_on(tmp_path, swing, "response", "--at", "3", "--digits", "30", "--of", "phi", "--of", "phi'") == 0
    out = capsys.readouterr().out
    assert at in out and top in out
    assert run_on(tmp_path, swing, "response", "--at", "3", "--digits", "30", "--json") == 0
    data = json.loads(capsys.readouterr().out)["response"]
    assert data["signals"][0]["at"][0]["value"] == at and data["unknown"] is None


def test_what_has_no_series_is_refused_where_digits_of_it_are_asked(tmp_path, capsys):
    stop = ("bodies: {block: {mass: 2 kg, slide: x}}\nsprings:\n  s: {k: 50 N/m, between: [ground, block]}\n"
            "  stop: {k: 500 N/m, gap: 1 cm, acts: compression, between: [block, ground]}\ninitial: {x: 2 cm}\n"
            "find: [frequencies, {response: {until: 1 s}}]\n")
    assert run_on(tmp_path, stop, "response", "--at", "1", "--digits", "30") == 4
    assert "'stop' bends or jumps with the motion" in capsys.readouterr().err
    assert run_on(tmp_path, stop, "solve", "--digits", "30") == 0
    assert "ω = 5.00000000000000000000000000000 rad/s" in capsys.readouterr().out
