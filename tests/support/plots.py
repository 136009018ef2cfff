"""Figures that the tests of plots share: those of a textbook, and hostile ones."""

import cmath
import hashlib
import math
import random

from vibcli.plots.eigenvalues import argand
from vibcli.plots.figure import Curve, Figure, Mark, Panel
from vibcli.plots.frequency import nyquist, of_frequency_response
from vibcli.plots.response import of_response

EVIL = "$\\frac{1}{0}$ <b>&amp; ]]> --> {x} % _a^b # ~ \\ \x1b[31m\u202e"
LENGTH, FORCE = {"m": 1}, {"kg": 1, "m": 1, "s": -2}
TIMES = [i / 200 for i in range(1001)]


def two_degrees(Omega, zeta=0.02):
    """Receptances of two equal masses between three equal springs, the force on the first."""
    modes = [(10.0, 1.0), (10.0 * math.sqrt(3), -1.0)]
    terms = [[1 / (w * w - o * o + 2j * zeta * w * o) / 2 for w, _ in modes] for o in Omega]
    return {"x₁/F": [a + b for a, b in terms], "x₂/F": [a - b for a, b in terms]}


def wave(size, omega, decay=0.0):
    return [size * math.exp(-decay * t) * math.cos(omega * t) for t in TIMES]


def grid(low, high, n):
    return [low * (high / low) ** (i / (n - 1)) for i in range(n)]


def noise(n):
    draw = random.Random(7)
    return [draw.gauss(0, 3) for _ in range(n)]


def pairs(omegas, zetas):
    return [value for w, z in zip(omegas, zetas, strict=True)
            for value in (cmath.rect(w, math.pi - math.acos(z)), cmath.rect(w, math.acos(z) - math.pi))]


OMEGA = grid(2, 60, 600)
FIGURES = {
    "decay": of_response(TIMES, [("x", LENGTH, wave(4e-3, 12, 0.5))], title="Damped decay",
                         envelope=[[4e-3 * math.exp(-0.5 * t) for t in TIMES]]),
    "beats": of_response(TIMES, [("x₁", "m", wave(1, 60)), ("x₂", "m", wave(2, 63))]),
    "units": of_response(TIMES, [("x", LENGTH, wave(3e-3, 5)), ("s.force", FORCE, wave(9e4, 5))],
                         steady=[wave(2e-3, 4), None]),
    "frf": of_frequency_response(OMEGA, two_degrees(OMEGA), "receptance", {"kg": -1, "s": 2}, peaks=(10, 17.3),
                                 antiresonances=(14.1,)),
    "pole": of_frequency_response([0.0, 1.0, 2.0], {"x/F": [1 + 0j, complex(math.inf), -0.5 + 0j]}, "", "m/N"),
    "nyquist": nyquist(OMEGA, two_degrees(OMEGA), "m/N", at=(9.5, 10, 10.5)),
    "argand": argand(pairs((5, 12, 20, 31, 40), (0.02, 0.05, 0.1, 0.3, 0.15)),
                     [f"λ{i}" for i in range(10)], title="Eigenvalues"),
    "round": argand([*pairs((5, 12), (0.5, 0.7)), -9 + 0j], ["1", "", "2", "", "3"], title="Eigenvalues"),
    "noise": of_response([i / 100 for i in range(4000)], [("a", {"m": 1, "s": -2}, noise(4000))]),
    "zero": of_response(TIMES, [("x", "m", [0.0] * 1001)]),
    "constant": of_response(TIMES, [("F", "N", [5000.0] * 1001)]),
    "single": of_response([2.0], [("x", "m", [0.3])]),
    "empty": of_response([], [("x", "m", [])]),
    "narrow": of_response([500 + 1e-6 * i for i in range(100)], [("x", "m", [1 + 1e-7 * i for i in range(100)])]),
    "nothing": Figure("", ()),
    "nan": of_response(TIMES, [("x", "m", [math.nan if t > 3 else math.inf if t < 1 else t for t in TIMES])]),
    "tiny": of_response(TIMES, [("x", "m", wave(1e-31, 3))]),
    "denormal": of_response(TIMES, [("x", "m", [5e-324] * 1001)]),
    "huge": of_response([1e9 * t for t in TIMES], [("x", "m", wave(1e299, 3))]),
    "hostile": Figure(EVIL * 3, (Panel(EVIL * 2, EVIL * 3, curves=(
        Curve("_" + EVIL, (0, 1, 2), (0, 1, 4)),
        Curve(EVIL * 4, (0, 1, 2), (3, 1, 0), names=(EVIL, "", EVIL))), marks=(
        Mark(1, EVIL), Mark(1.1, EVIL), Mark(2, EVIL), Mark(0.3, "日本語"))),)),
    "many": of_response(TIMES, [(f"x{i}", "m", wave(1 + i, 1 + i / 3)) for i in range(9)], title="W" * 900),
}


def digests(pictures):
    """{name and kind of a picture: digest of its bytes} of FIGURES."""
    from vibcli.plots.picture import picture

    return {name + kind: hashlib.sha256(picture(FIGURES[name], kind)).hexdigest() for name, kind in pictures}
