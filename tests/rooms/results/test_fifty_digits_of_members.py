"""Fifty digits of frequencies of members, as `--digits 50` has them: by transfer matrices and by Bessel's functions."""

import mpmath
import pytest
from derivations import portal_frame
from mpmath import besselj, mpf, sqrt
from support import transfer_matrices as transfer
from support.scenes import problem

WORKING = 75
FRAME = {"H": 3, "L": 4, "EI": 5, "mu": 2}


def along(parts, left, right):
    return lambda: transfer.condition(parts(), left, right)


def beam():
    return transfer.beam(mpf("1.3"), mpf("2.4"), mpf("0.7"))


def bar(size):
    return transfer.bar(mpf(size), mpf("3.1"), mpf("0.7"))


CANTILEVER = "beams: {b: {length: 1.3 m, EI: 2.4 N*m^2, mass_per_length: 0.7 kg/m, %s}}"
BAR = "bars: {b: {%s, mass_per_length: 0.7 kg/m, left: clamped%s}}"
SCENES = {      # {name: (scene, its frequency function, the first mode that is not rigid)}
    "cantilever": (CANTILEVER % "left: clamped", along(lambda: [beam()], "clamped", "free"), 1),
    "tip mass": (CANTILEVER % "left: clamped, attached: [{at: 1.3 m, mass: 0.4 kg}]", along(
        lambda: [beam(), transfer.mass(4, mpf("0.4"))], "clamped", "free"), 1),
    "free beam": (CANTILEVER % "left: free", along(lambda: [beam()], "free", "free"), 3),
    "bar with an end spring": (BAR % ("length: 1.3 m, EA: 3.1 N", ", right: {k: 1.7 N/m}"), along(
        lambda: [bar("1.3"), transfer.spring(2, mpf("1.7"))], "clamped", "free"), 1),
    "stepped bar": (BAR % ("segments: [{length: 0.8 m, EA: 3.1 N}, {length: 0.7 m, EA: 1.3 N}]", ""), along(
        lambda: [bar("0.8"), transfer.bar(mpf("0.7"), mpf("1.3"), mpf("0.7"))], "clamped", "free"), 1),
    "string with a bead": ("strings: {s: {length: 1.2 m, mass_per_length: 0.7 kg/m, preload: 3.1 N, left: clamped, "
                           "right: clamped, attached: [{at: 0.5 m, mass: 0.3 kg}]}}", along(
        lambda: [bar("0.5"), transfer.mass(2, mpf("0.3")), bar("0.7")], "clamped", "clamped"), 1),
    "hanging chain": ("gravity: 9.81 m/s^2\nstrings: {s: {from: [0, 0], to: [0, -1.7 m], mass_per_length: 0.7 kg/m, "
                      "left: clamped}}", lambda: lambda w: besselj(0, 2 * w * sqrt(mpf("1.7") / mpf("9.81"))), 1),
}


@pytest.mark.sweep
@pytest.mark.parametrize("name", SCENES)
def test_one_member(name):
    text, condition, first = SCENES[name]
    modes = problem(text).modal.modes_to(50).first(first + 2)[first - 1:]
    with mpmath.workdps(WORKING):
        vanishes = condition()
        for mode in modes:
            exact = mpmath.findroot(vanishes, (mode.omega * (1 - mpf(10)**-9), mode.omega * (1 + mpf(10)**-8)),
                                    tol=mpf(10)**-140, verify=False)
            assert abs(mode.omega / exact - 1) <= mode.error < 1e-50


@pytest.mark.sweep
def test_a_portal_frame():
    keys = "EI: 5 N*m^2, mass_per_length: 2 kg/m"
    found = problem(f"""
        bodies:
          A: {{mass: 0 kg, inertia: 0 kg*m^2, at: [0, 3 m], move: [x, y, p]}}
          B: {{mass: 0 kg, inertia: 0 kg*m^2, at: [4 m, 3 m], move: [x2, y2, p2]}}
        beams:
          left: {{from: [0, 0], to: [0, 3 m], {keys}, left: clamped, right: {{clamped: A}}}}
          right: {{from: [4 m, 0], to: [4 m, 3 m], {keys}, left: clamped, right: {{clamped: B}}}}
          girder: {{from: [0, 3 m], to: [4 m, 3 m], {keys}, left: {{clamped: A}}, right: {{clamped: B}}}}
    """).modal.modes_to(50).first(3)
    exact = portal_frame.answers(FRAME).values()
    with mpmath.workdps(WORKING):
        for mode, w in zip(found, exact, strict=True):
            assert abs(mode.omega / w - 1) <= mode.error + mpf(10)**-57 < 1e-50
