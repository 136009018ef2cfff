"""Scenes of a search that share their expressions: the same numbers as those drawn anew, as they are where something in
the drawing turns."""

from fractions import Fraction

import numpy as np
import pytest
from support.scenes import problem

from vibcli.inverse import settled
from vibcli.inverse.alike_drawings import FEW, AlikeDrawings
from vibcli.quantities.expression import measure
from vibcli.scene import build
from vibcli.symbolic.parser import parse

ROLLER = """
    parameters: {m: 2 kg, R: 0.3 m, r: {}, g: 9.81 m/s^2}
    gravity: g
    coordinates: {phi: turn of the line of centres}
    bodies:
      wheel: {shape: disc, mass: m, radius: r, at: [0, r - R], move: [(R - r)*sin(phi), -(R - r)*cos(phi), R/r*phi]}
    springs: {s: {k: 90 N/m, between: [wheel, [R - 2*r, R]]}}
"""
RIDER = """
    parameters: {M: 30 g, b: 3 cm, m: 10 g, g: 9.81 m/s^2}
    gravity: g
    bodies:
      bob: {mass: M, at: [0, -b], pin: {at: [0, 0], by: phi}}
      rider: {mass: m, at: [0, a], weld: bob}
    choose:
      a: stability limit
"""
SHAKEN = """
    parameters: {m: 2 kg, M: 9 kg, k: 4 kN/m, c: 30 N*s/m, Omega: 6 rad/s, g: 9.81 m/s^2}
    gravity: g
    coordinates: {x: of the cart}
    bodies:
      cart: {mass: M, at: [0, 0], move: [x, 0, 0]}
      bob: {mass: m, at: [0, -l], pin: {at: [0, 0], carrier: cart, by: phi}}
    springs: {s: {k: k, between: [[-1 m, 0], cart]}}
    dampers: {d: {c: c, between: [[-1 m, 0], cart]}}
    forces: {drive: {at: cart, force: [4 N*sin(Omega*t), 0]}}
    choose:
      l: amplitude(x) = 0
"""


@pytest.fixture
def drawn(monkeypatch):
    """How many scenes were drawn."""
    found, draw = [], build.build_scene
    monkeypatch.setattr(build, "build_scene", lambda *args: found.append(args[0]) or draw(*args))
    return found


@pytest.mark.sweep
def test_scenes_on_either_side_of_a_turn_are_those_drawn_anew(drawn):
    read = problem(ROLLER)
    drawings, tried = AlikeDrawings(read), 0
    for value in (0.02, 0.05, 0.21, 0.07, 0.11, 0.28, 0.4, 0.45, 0.13, 0.52, 0.09, 0.6, 0.26):
        given, before = {"r": Fraction(str(value))}, len(drawn)
        found = drawings.at(given)
        matrices = found.configuration.linear_system.arrays()
        tried += len(drawn) - before
        anew = read.with_values(given).configuration.linear_system.arrays()
        assert not drawings.misled(given, found)
        for one, other in zip(matrices, anew, strict=True):
            assert np.allclose(one, other, rtol=1e-12, atol=0)
    assert FEW <= tried < 13


def test_what_drives_them_is_shared_too(drawn):
    read, tree = problem(SHAKEN), parse("amplitude(bob.x)")
    drawings, tried = AlikeDrawings(read), 0
    for value in ("0.1", "0.2", "0.3", "0.4", "0.7", "1.1", "3"):
        given, before = {"l": Fraction(value)}, len(drawn)
        found = measure(drawings.at(given), tree)
        tried += len(drawn) - before
        assert found[0] == pytest.approx(measure(read.with_values(given), tree)[0], rel=1e-12)
    assert tried == FEW + 1     # one of them is drawn with numbers that are watched


def test_a_search_draws_few_scenes(drawn):
    found, = settled(problem(RIDER)).choice.solutions
    assert float(found.values["a"]) == pytest.approx(0.09, rel=1e-12)
    assert len(drawn) < 12


def test_a_look_gives_the_numbers_without_their_bounds():
    read = problem(SHAKEN).with_values({"l": Fraction("0.4")})
    for text in ("amplitude(x)", "peak[1](frf[x, drive]).value", "antiresonance[1](frf[x, drive])", "max(x)"):
        tree = parse(text)
        (rough, none), (found, error) = measure(read.roughly(), tree), measure(read, tree)
        assert rough == pytest.approx(found, rel=1e-11) and none == 0.0 < error
