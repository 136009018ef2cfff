"""Derivatives of frequencies, coefficients of energies, laws and equivalents beside closed forms."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.analyses.modal.sensitivities import _Group
from vibcli.evidence.asked import subjects
from vibcli.evidence.methods import differences, inner_forces, ours
from vibcli.evidence.subject import Deadline
from vibcli.mechanics import spring_shares
from vibcli.mechanics.characteristics import ForceLaw
from vibcli.mechanics.equivalents import Equivalent
from vibcli.mechanics.expansion import ENERGIES

SAGGING = """
parameters: {m: 2 kg, k: 150 N/m, c: 900 N/m^3, g: 10 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, -1], by: x}}}
springs: {s: {law: k*d + c*d^3, stretch: x}}
answers: {"sensitivity[1,k]": 0, "sensitivity[1,m]": 0, "V[x^3]": 0, "V[x^4]": 0}
"""
ALIKE = """
parameters: {m: 1 kg, k: 25 N/m, q: 25 N/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, r: {k: q, between: [ground, b]}}
answers: {"sensitivity[1,k]": 0, "sensitivity[2,k]": 0}
"""
TURNING = """
parameters: {m: 2 kg, k: 500 N/m, W: 9 rad/s}
bodies:
  shaft: {at: [0, 0], pin: {by: W*t}}
  disc: {mass: m, at: [0, 0], move: {by: [u, v, 0], carrier: shaft}}
springs: {first: {k: k, stretch: u}, second: {k: k, stretch: v}}
answers: {"sensitivity[1,W]": 0}
"""
TAUT = """
parameters: {N: 30 N, k: 200 N/m, m: 1 kg}
bodies: {p: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[0, 0.5 m], p], preload: N}}
answers: {"V[x^2]": 0, "V[x^4]": 0, "stiffness_correction[s,x]": 0, "stiffness_correction[s,x^3]": 0}
"""
SWINGING = """
parameters: {m: 1 kg, L: 2 m, g: 10 m/s^2}
gravity: g
bodies: {cart: {mass: m, at: [0, 0], slide: x}, bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}}
springs: {s: {k: 1 N/m, stretch: x}}
answers: {"T[x'*phi'*phi^2]": 0}
"""
HELD = """
bodies: {p: {mass: 1 kg, at: [0, 0], move: [x, y, 0]}}
springs: {s: {k: 100 N/m, between: [[3 m, 4 m], p]}, r: {k: 50 N/m, between: [[-1 m, 0], p]}}
dampers: {d: {c: 7 N*s/m, between: [[0, 1 m], p]}}
answers: {"stiffness[p].xx": 0, "stiffness[p].max": 0, "stiffness[p].angle": 0, "damping[p].yy": 0,
  "damping[p].angle": 0}
"""
CHAIN = """
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {series: [{k: 2 N/m}, {parallel: [{k: 2 N/m}, {law: (3 N/m^3)*d^3}]}], between: [ground, b]}}
answers: {"law[s](2 m)": 0, "law[s,d]": 0, "law[s,d^3]": 0}
"""


def sagging():
    """k x + c x³ = m g, ω² = (k + 3 c x²)/m."""
    m, k, c, g = 2, 150, 900, 10
    x = mpmath.findroot(lambda x: k * x + c * x**3 - m * g, mpmath.mpf("0.1"))
    K = k + 3 * c * x**2
    w = mpmath.sqrt(K / m)
    return [(1 - 6 * c * x**2 / K) / (2 * m * w), (6 * c * x * g / K - K / m) / (2 * m * w), c * x, mpmath.mpf(c) / 4]


def taut():
    """V = N(s − L) + ½ k (s − L)², s = √(L² + x²)."""
    N, k, L = 30, 200, mpmath.mpf("0.5")
    first, third = N / L, (k - N / L) / (2 * L**2)
    return [first / 2, third / 4, first, third]


def held():
    K = mpmath.matrix([[36 + 50, 48], [48, 64]])
    largest = max(mpmath.eigsy(K, eigvals_only=True))
    return [86, largest, mpmath.atan((largest - 86) / 48), 7, mpmath.pi / 2]


def chain():
    """2 (D − d) = 2 d + 3 d³"""
    d = mpmath.findroot(lambda d: 2 * (2 - d) - 2 * d - 3 * d**3, mpmath.mpf("0.7"))
    return [2 * (2 - d), 1, mpmath.mpf(3) / 16]


def found(text):
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


CLOSED = [(SAGGING, sagging), (ALIKE, lambda: [0, mpmath.mpf("0.1")]), (TURNING, lambda: [-1]), (TAUT, taut),
          (SWINGING, lambda: [-1]), (HELD, held), (CHAIN, chain)]


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "exact"), CLOSED)
def test_numbers_beside_closed_forms(text, exact):
    with mpmath.workdps(50):
        for each, x in zip(found(text), exact(), strict=True):
            (own,) = ours.attempts(each)
            answer = own.run(Deadline(1))
            assert abs(each.true.values[0] - x) < 1e-26 * max(1, abs(x)), each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-12 or not x
            files = inner_forces if each.kind == "force law" else differences
            best = min(each.error(run.run(Deadline(1)).values, each.true) for run in files.attempts(each))
            assert best < 1e-2 or text == ALIKE     # whose frequencies change places


def broken(text):
    """Those whose error is not within its bound."""
    return {each.asked for each in found(text) for answer in (each.ours(),)
            if not each.error(answer.values, each.true) <= answer.bound}


def off(function):
    return lambda *args: function(*args) * (1 + 1e-11)


def test_a_derivative_that_is_off_is_found(monkeypatch):
    rates = _Group.rates
    monkeypatch.setattr(_Group, "rates", lambda *args: [x * (1 + mpmath.mpf("1e-11")) for x in rates(*args)])
    assert broken(SAGGING) == {"sensitivity[1,k]", "sensitivity[1,m]"}


def test_an_energy_and_a_share_of_it_that_are_off_are_found(monkeypatch):
    monkeypatch.setitem(ENERGIES, "T", off(ENERGIES["T"]))
    monkeypatch.setitem(ENERGIES, "V", off(ENERGIES["V"]))
    assert broken(SWINGING) and broken(TAUT) == {"V[x^2]", "V[x^4]"}
    of_the_material = spring_shares._of_the_first_order
    monkeypatch.setattr(spring_shares, "_of_the_first_order", lambda scene, term, s, how: {
        powers: c * 1.5 for powers, c in of_the_material(scene, term, s, how).items()})
    assert "stiffness_correction[s,x]" not in broken(TAUT) and not broken(CHAIN)


def test_a_law_and_an_equivalent_that_are_off_are_found(monkeypatch):
    at, largest = ForceLaw.at, Equivalent.max
    monkeypatch.setattr(ForceLaw, "at", off(at))
    monkeypatch.setattr(Equivalent, "max", property(lambda self: largest.fget(self) * (1 + 1e-11)))
    assert broken(CHAIN) == {"law[s](2 m)"} and broken(HELD) == {"stiffness[p].max"}
