"""Scenes in motion and what is known of them exactly, for the tests of trajectories."""

import mpmath

from vibcli.language.document.document import read
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem

PENDULUM = """
parameters: {m: 2 kg, L: 0.8 m, g: 9.81 m/s^2}
gravity: g
bodies:
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}
"""

DUFFING = """
parameters: {m: 2 kg, k: 80 N/m, b: 500 N/m^3}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + b*d^3, between: [ground, block]}}
"""

DOUBLE = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
points:
  P: {body: upper, at: [0, -L]}
bodies:
  upper: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}
  lower: {mass: m, at: [0, -2*L], pin: {at: P, by: r}}
"""

FOUR_BAR = """
parameters: {m: 1.3 kg, g: 9.81 m/s^2}
gravity: g
points:
  A: {body: crank, at: [0, 0.3 m]}
  B: {body: rocker, at: [1 m, 0.8 m]}
  C: {body: coupler, at: [1 m, 0.8 m]}
bodies:
  crank: {shape: rod, mass: m, from: [0, 0], to: [0, 0.3 m], pin: {at: [0, 0], by: alpha}}
  coupler: {shape: rod, mass: 2*m, from: [0, 0.3 m], to: [1 m, 0.8 m], pin: {at: A, by: beta}}
  rocker: {shape: rod, mass: m, from: [1 m, 0], to: [1 m, 0.8 m], pin: {at: [1 m, 0], by: gamma}}
constraints:
  loop: {join: [C, B]}
"""
AT_THE_TOP = """
motion: full
parameters: {m: 1 kg, L: 1 m}
gravity: 9.81 m/s^2
bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}}
initial: {p: pi}
"""
RESTING = """
motion: full
parameters: {m: 1 kg, k: 500 N/m, P: 20 N}
gravity: 9.81 m/s^2
points: {Q: {body: b, at: [0.3 m, 0.1 m]}}
surfaces: {track: {line: [[0.3 m, 0.1 m], [0.9 m, 0.2 m]]}}
bodies: {b: {shape: rectangle, mass: m, width: 0.6 m, height: 0.2 m, at: [0, 0], move: [x, y, phi]}}
springs:
  s: {k: k, between: [[0.7 m, 0], b]}
  u: {k: 300 N/m, between: [[0, 0.8 m], b]}
  t: {torsion: 90 N*m/rad, between: [ground, b]}
forces: {p: {at: Q, force: [P, -P], carrier: b}}
constraints: {held: {point: Q, surface: track}}
"""


def problem(text, given=None):
    """The Problem of a scene."""
    node, diagnostics = read(text.encode(), "scene.yaml")
    return Problem(read_spec(node, "scene.yaml", diagnostics), given)


def pendulum(omega, amplitude, t):
    """(angle, period) of a pendulum released at rest: sin(θ/2) = k cd(ω t, k), k = sin(θ₀/2)."""
    with mpmath.workdps(30):
        k = mpmath.sin(mpmath.mpf(amplitude) / 2)
        return (2 * mpmath.asin(k * mpmath.ellipfun("cd", mpmath.mpf(omega) * t, m=k * k)),
                4 * mpmath.ellipk(k * k) / omega)


def duffing_period(omega, epsilon, amplitude):
    """The period of x'' + ω² x + ε x³ = 0 with amplitude a: 4 K(k²)/√(ω² + ε a²), k² = ε a²/(2 (ω² + ε a²))."""
    with mpmath.workdps(30):
        square = mpmath.mpf(omega) ** 2 + mpmath.mpf(epsilon) * mpmath.mpf(amplitude) ** 2
        m = mpmath.mpf(epsilon) * mpmath.mpf(amplitude) ** 2 / (2 * square)
        return 4 * mpmath.ellipk(m) / mpmath.sqrt(square)


def double_pendulum(start, until, digits=30):
    """(p, r, p', r') of the double pendulum of unit masses and lengths, by mpmath's Taylor series."""
    with mpmath.workdps(digits):
        g = mpmath.mpf("9.81")

        def rates(_, y):
            p, r, u, w = y
            s, c = mpmath.sin(p - r), mpmath.cos(p - r)
            h, k = s * w * w + 2 * g * mpmath.sin(p), g * mpmath.sin(r) - s * u * u
            bottom = 2 - c * c
            return [u, w, (c * k - h) / bottom, (c * h - 2 * k) / bottom]

        solution = mpmath.odefun(rates, 0, [mpmath.mpf(str(x)) for x in start], tol=mpmath.mpf(10) ** (5 - digits))
        return [float(x) for x in solution(until)]
