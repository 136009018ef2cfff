"""Any signal of a small motion to as many digits as are asked for, against closed forms and exponentials in mpmath."""

import math
import re
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from support.scenes import problem
from support.signals import signal_of

from vibcli.api.given import expression
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.quantities.expression import measure

DIGITS = 40
NEAR_RESONANCE = """
parameters: {m: 1 kg, k: 400 N/m, F: 2 N, W: 20.0000002 rad/s}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
forces: {f: {at: a, force: F*sin(W*t)}}
"""
CHAIN = """
parameters: {m: 2 kg, k: 30 N/m, c: 0.7 N*s/m, u0: 0.1 m, W: 3.3 rad/s}
bodies: {wall: {slide: u0*sin(W*t)}, a: {mass: m, slide: x}, b: {mass: 3 kg, slide: y}}
springs: {s: {k: k, between: [wall, a]}, r: {k: 50 N/m, between: [a, b]}}
dampers: {d: {c: c, between: [ground, b]}}
initial: {x: 0.02 m, y': 0.3 m/s}
"""
FREE = """
bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 3 kg, slide: y}}
springs: {s: {k: 30 N/m, between: [ground, a]}, r: {k: 50 N/m, between: [a, b]}}
dampers: {d: {c: 0.7 N*s/m, between: [ground, b]}}
initial: {x: 0.02 m, y': 0.3 m/s}
"""
ROD = """
gravity: 9.81 m/s^2
points: {W: {at: [-0.4 m, 0.3 m]}, E: {at: [1 m, 0 m], body: rod}}
bodies: {rod: {shape: rod, mass: 3 kg, from: [0 m, 0 m], to: [1 m, 0 m], pin: {at: [0 m, 0 m], by: phi}}}
springs: {s: {k: 300 N/m, free_length: 0.9 m, between: [W, E]}}
"""


def near(found, exact, digits=DIGITS):
    return abs(found - exact) <= abs(exact) * mpmath.mpf(10) ** -digits


def close_to_resonance(t):
    """(x, x', x'') of m x'' + k x = F sin Ωt from rest: F/(m (ω² − Ω²)) (sin Ωt − Ω/ω sin ωt)."""
    w, W = mpmath.mpf(20), mpmath.mpf("20.0000002")
    size = 2 / (w * w - W * W)
    return (size * (mpmath.sin(W * t) - W / w * mpmath.sin(w * t)), size * W * (mpmath.cos(W * t) - mpmath.cos(w * t)),
            size * W * (w * mpmath.sin(w * t) - W * mpmath.sin(W * t)))


def test_twelve_printed_digits_a_million_seconds_after():
    """Of the case where the phase Ω t alone takes three digits, all that are printed are right, and as many as one
    likes."""
    with mpmath.workdps(80):
        exact = close_to_resonance(mpmath.mpf(10) ** 6)
        found = problem(NEAR_RESONANCE)
        t = Fraction(10) ** 6
        for text, value in (("x", exact[0]), ("x'", exact[1]), ("x''", exact[2]), ("s.force", 400 * exact[0]),
                            ("T", exact[1] ** 2 / 2), ("s.energy", 200 * exact[0] ** 2), ("x*x'", exact[0] * exact[1]),
                            ("m*x''+k*x", 2 * mpmath.sin(mpmath.mpf("20.0000002") * 10**6))):
            assert near(signal_of(found, text).precise(t, DIGITS), value), text


@pytest.mark.sweep
def test_two_degrees_under_a_driven_wall_against_the_exponential():
    """ż = G z written by hand, z = (x, y, x', y', sin Ωt, cos Ωt)."""
    with mpmath.workdps(90):
        m, k, c, u, W, M, r = (mpmath.mpf(text) for text in ("2", "30", "0.7", "0.1", "3.3", "3", "50"))
        G = mpmath.matrix(6, 6)
        G[0, 2] = G[1, 3] = 1
        G[2, 0], G[2, 1], G[2, 4] = -(k + r) / m, r / m, k * u / m
        G[3, 0], G[3, 1], G[3, 3] = r / M, -r / M, -c / M
        G[4, 5], G[5, 4] = W, -W
        z0, found = mpmath.matrix([mpmath.mpf("0.02"), 0, 0, mpmath.mpf("0.3"), 0, 1]), problem(CHAIN)
        for t in ("0.4", "7", "60"):
            z = mpmath.expm(G * mpmath.mpf(t), method="taylor") * z0
            rates = G * z
            moved = {"x": z[0], "y'": z[3], "x''": rates[2], "s.force": k * (z[0] - u * z[4]),
                     "r.force": r * (z[1] - z[0]),
                     "d.force": c * z[3], "d.power": c * z[3] ** 2, "T": (m * z[2] ** 2 + M * z[3] ** 2) / 2,
                     "(x - y)^2": (z[0] - z[1]) ** 2}
            for text, exact in moved.items():
                assert near(signal_of(found, text).precise(Fraction(t), DIGITS), exact), (text, t)


def test_steady_and_transient_parts():
    """X = (K + iΩ C − Ω² M)⁻¹ F, and what is left."""
    found, t = problem(CHAIN), Fraction(7, 2)
    with mpmath.workdps(70):
        W = mpmath.mpf("3.3")
        Z = mpmath.matrix([[80 - 2 * W**2, -50], [-50, 50 - 3 * W**2 + 1j * W * mpmath.mpf("0.7")]])
        X = mpmath.lu_solve(Z, mpmath.matrix([mpmath.mpf(3), 0]))
        exact = mpmath.im(X[1] * mpmath.expj(W * mpmath.mpf("3.5")))
        steady, whole = (signal_of(found, text).precise(t, DIGITS) for text in ("steady(y)", "y"))
        assert near(steady, exact)
        assert near(signal_of(found, "transient(y)").precise(t, DIGITS), whole - exact, DIGITS - 2)


def test_frequency_responses():
    """H = cᵀ (K + iΩ C − Ω² M)⁻¹ b of a driven wall and of a force along a line, near a lightly damped resonance."""
    found = problem(CHAIN)
    with mpmath.workdps(50):
        W = 2 * mpmath.pi * mpmath.mpf("0.4")
        Z = mpmath.matrix([[80 - 2 * W**2, -50], [-50, 50 - 3 * W**2 + 1j * W * mpmath.mpf("0.7")]])
        X = mpmath.lu_solve(Z, mpmath.matrix([30, 0]))
        exact = {"x": X[0], "d.force": 1j * W * X[1] * mpmath.mpf("0.7"), "s.force": 30 * (X[0] - 1)}
        for text, H in exact.items():
            two, error = measure(found.with_digits(30), expression(f"frf[{text}, wall](0.4 Hz)", "").tree)
            assert near(two, H, 28) and error <= 1e-28


@pytest.mark.parametrize("c", ["0", "2"])
def test_places_of_a_frequency_response(c):
    """Of 1/(k − mΩ² + icΩ) of one mass with an absorber: roots of polynomials in Ω² and of |H|² by mpmath."""
    found = problem(f"""
        bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 0.5 kg, slide: y}}}}
        springs: {{s: {{k: 400 N/m, between: [ground, a]}}, r: {{k: 100 N/m, between: [a, b]}}}}
        {"dampers: {d: {c: 2 N*s/m, between: [ground, a]}}" if c != "0" else ""}
        forces: {{f: {{at: a, force: 1 N*sin(3 rad/s*t)}}}}
    """)

    def H(W):
        return (100 - W**2 / 2) / ((500 - W**2 + 1j * mpmath.mpf(c) * W) * (100 - W**2 / 2) - 10**4)

    with mpmath.workdps(50):
        if c == "0":
            roots = mpmath.polyroots([mpmath.mpf("0.5"), -350, 40000])
            exact = {"peak[1]({}).Omega": mpmath.sqrt(min(roots)), "antiresonance[1]({})": mpmath.sqrt(200)}
        else:
            at = mpmath.findroot(lambda W: mpmath.diff(lambda w: abs(H(w)), W), mpmath.mpf("11.992"))
            low, high = (mpmath.findroot(lambda W: abs(H(W)) - abs(H(at)) / mpmath.sqrt(2), mpmath.mpf(near))
                         for near in ("11.8475", "12.1211"))
            exact = {"peak[1]({}).Omega": at, "peak[1]({}).value": abs(H(at)), "half_power[2]({})": high,
                     "quality[1]({})": at / (high - low)}
        for text, value in exact.items():
            two, error = measure(found.with_digits(25), expression(text.format("frf[x, f]"), "").tree)
            assert near(two, value, 22) and error <= 1e-23, text


def test_about_an_equilibrium_that_is_searched_for():
    """A rod on a spring with a free length: equilibrium, stiffness and reaction at the pin from V by derivatives."""
    found = problem(ROD + "initial: {phi': 0.2 rad/s}")
    with mpmath.workdps(60):
        g, J = mpmath.mpf("9.81"), mpmath.mpf(1)
        wall = mpmath.mpf("-0.4"), mpmath.mpf("0.3")

        def length(p):
            return mpmath.hypot(mpmath.cos(p) - wall[0], mpmath.sin(p) - wall[1])

        def V(p):
            return 3 * g * mpmath.sin(p) / 2 + 150 * (length(p) - mpmath.mpf("0.9")) ** 2

        rest = mpmath.findroot(lambda p: mpmath.diff(V, p), signal_of(found, "phi").values(np.zeros(1))[0])
        omega = mpmath.sqrt(mpmath.diff(V, rest, 2) / J)
        t = mpmath.mpf("1.7")
        phi = rest + mpmath.mpf("0.2") / omega * mpmath.sin(omega * t)
        assert near(signal_of(found, "phi").precise(Fraction("1.7"), 30), phi, 25)
        force = 300 * (length(rest) - mpmath.mpf("0.9") + mpmath.diff(length, rest) * (phi - rest))
        assert near(signal_of(found, "s.force").precise(Fraction("1.7"), 30), force, 25)


@pytest.mark.parametrize("text", ["x", "x'", "s.force", "s.energy"])
def test_extremes_and_zeros(text):
    """Those of 0.02 e^{−2t} …, by roots in mpmath."""
    found = problem("""
        bodies: {a: {mass: 1 kg, slide: x}}
        springs: {s: {k: 400 N/m, between: [ground, a]}}
        dampers: {d: {c: 4 N*s/m, between: [ground, a]}}
        initial: {x: 20 mm, x': 0.1 m/s}
    """)
    with mpmath.workdps(60):
        fast = mpmath.sqrt(396)

        def x(t):
            return mpmath.exp(-2 * t) * (mpmath.mpf("0.02") * mpmath.cos(fast * t)
                                         + mpmath.mpf("0.14") / fast * mpmath.sin(fast * t))

        exact = {"x": x, "x'": lambda t: mpmath.diff(x, t), "s.force": lambda t: 400 * x(t),
                 "s.energy": lambda t: 200 * x(t) ** 2}[text]
        signal = signal_of(found, text)
        for sense in (1, -1):
            t, value = signal.precise_extreme(0.0, 2.0, sense, 25)
            near_by, _ = signal.extreme(0.0, 2.0, sense)
            top = mpmath.findroot(lambda t: mpmath.diff(exact, t), near_by) if near_by else mpmath.mpf(0)
            if text != "s.energy" or sense > 0:
                assert near(t, top, 20) and near(value, exact(top), 20), sense
        near_by = signal.zeros(0.0, 2.0)[1]
        assert near(signal.precise_zero(near_by, 25), mpmath.findroot(x if text == "s.energy" else exact, near_by), 20)


def test_what_has_died_out_and_what_is_zero():
    found = problem(FREE)
    with mpmath.workdps(40):
        assert near(signal_of(found, "x").precise(Fraction(0), 30), mpmath.mpf("0.02"), 30)
    assert signal_of(found, "y").precise(Fraction(0), 30) == 0
    with mpmath.workdps(240):
        c, r = mpmath.mpf("0.7"), mpmath.mpf(50)
        G = mpmath.matrix([[0, 0, 1, 0], [0, 0, 0, 1], [-40, 25, 0, 0], [r / 3, -r / 3, 0, -c / 3]])
        z = mpmath.expm(G * 10**4, method="taylor") * mpmath.matrix([mpmath.mpf("0.02"), 0, 0, mpmath.mpf("0.3")])
        assert 0 < abs(z[0]) < mpmath.mpf(10) ** -100
        assert near(signal_of(found, "x").precise(Fraction(10**4), 30), z[0], 30)


def test_a_start_under_a_force_that_lets_go():
    """x = x₀ + (p/k) cos ωt about the place where the spring carries the weight, sagging from its free length."""
    found = problem("""
        gravity: 9.81 m/s^2
        bodies: {a: {mass: 3 kg, at: [0 m, 0 m], slide: {along: [0, -1], by: x}}}
        points: {C: {at: [0 m, 2 m]}}
        springs: {s: {k: 70 N/m, free_length: 1.9 m, between: [C, a]}}
        forces: {pull: {at: a, force: [0 N, -4 N]}}
        initial: {released: pull}
    """)
    with mpmath.workdps(50):
        rest = mpmath.mpf("29.43") / 70 - mpmath.mpf("0.1")
        exact = rest + mpmath.mpf(4) / 70 * mpmath.cos(mpmath.sqrt(mpmath.mpf(70) / 3) * mpmath.mpf("2.5"))
        assert near(signal_of(found, "x").precise(Fraction("2.5"), 30), exact, 30)


@pytest.mark.sweep
def test_harmonics_of_a_square_wave():
    """4F/(nπ) of the force, n odd, over the dynamic stiffness; the mean of a force that is there half of the time."""
    found = problem("""
        bodies: {a: {mass: 2 kg, slide: x}}
        springs: {s: {k: 30 N/m, between: [ground, a]}}
        dampers: {d: {c: 0.7 N*s/m, between: [ground, a]}}
        forces: {f: {at: a, force: 5 N*square(3 rad/s*t) + 1 N}}
    """)
    with mpmath.workdps(45):
        exact = {f"harmonic[{n}](x)": 20 / (n * mpmath.pi) / abs(30 - 18 * n * n + mpmath.mpc(0, "2.1") * n)
                 for n in (1, 3)} | {"mean(x)": mpmath.mpf(1) / 30}
        for text, value in exact.items():
            two, error = measure(found.with_digits(25), expression(text, "").tree)
            assert near(two, value, 22) and error <= 1e-20, text


def test_what_follows_its_loads_at_once():
    """Nothing that moves has inertia: x = F(t)/k."""
    found = problem("""
        bodies: {a: {mass: 0 kg, slide: x}}
        springs: {s: {k: 30 N/m, between: [ground, a]}}
        forces: {f: {at: a, force: 5 N*sin(3 rad/s*t)*step(t - 1 s)}}
    """)
    assert signal_of(found, "x").precise(Fraction("0.5"), 30) == 0
    with mpmath.workdps(45):
        assert near(signal_of(found, "x").precise(Fraction(2), 30), mpmath.sin(6) / 6, 30)


def test_envelopes():
    """|a₁ e^{iω₁t} + a₂ e^{iω₂t}| of two equal masses that a soft spring ties, ω₁ = 20 rad/s being met exactly."""
    found = problem("""
        bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
        springs:
          s: {k: 400 N/m, between: [ground, a]}
          r: {k: 400 N/m, between: [ground, b]}
          q: {k: 8 N/m, between: [a, b]}
        initial: {x: 0.02 m, y': 0.1 m/s}
    """)
    with mpmath.workdps(50):
        t, fast, tenth = mpmath.mpf(10) ** 6, mpmath.sqrt(416), mpmath.mpf("0.1")
        one, two = (mpmath.mpc("0.02", -tenth / 20) / 2, mpmath.mpc("0.02", tenth / fast) / 2)
        exact = abs(one * mpmath.expj(20 * t) + two * mpmath.expj(fast * t))
        assert near(signal_of(found, "envelope(x)").precise(Fraction(10**6), 30), exact, 30)
    with pytest.raises(PhysicsError, match="more digits of what holds an envelope are not found"):
        signal_of(found, "2*envelope(x)").precise(Fraction(1), 20)


def test_numbers_of_a_free_vibration():
    """Of x₀ e^{−δt} cos …: A, φ, ln of successive maxima, times to a fraction."""
    found = problem("""
        bodies: {a: {mass: 1 kg, slide: x}}
        springs: {s: {k: 400 N/m, between: [ground, a]}}
        dampers: {d: {c: 4 N*s/m, between: [ground, a]}}
        initial: {x: 20 mm, x': 0.1 m/s}
    """)
    with mpmath.workdps(40):
        fast, start, rate = mpmath.sqrt(396), mpmath.mpf("0.02"), mpmath.mpf("0.14")
        log = mpmath.log(10)
        exact = {"amplitude(x)": mpmath.hypot(start, rate / fast), "phase(x)": mpmath.atan2(rate / fast, start),
                 "decrement(x)": 4 * mpmath.pi / fast, "time_to[0.1](x)": log / 2, "period(x)": 2 * mpmath.pi / fast,
                 "cycles_to[0.1](x)": log * fast / (4 * mpmath.pi)}
        for text, value in exact.items():
            two, error = measure(found.with_digits(25), expression(text, "").tree)
            assert near(two, value, 22) and error <= 1e-20, text


@pytest.mark.sweep
def test_digits_that_would_take_long_are_refused_with_the_estimate(tmp_path, capsys):
    """Loads that jump a thousand times within what is asked; what the hint says works."""
    path = tmp_path / "scene.yaml"
    path.write_text(FREE + "forces: {f: {at: a, force: 2 N*square(200 rad/s*t)}}\n")
    assert run(["response", str(path), "--at", "1200", "--digits", "150", "--until", "1"]) == 4
    refused = capsys.readouterr().err
    found = re.search(r"--digits 150 would take about (\d+) steps of a million products each; 600 are the limit",
                      refused)
    assert found and int(found[1]) > 600
    assert f"--patience {math.ceil(int(found[1]) / 600)}" in refused
