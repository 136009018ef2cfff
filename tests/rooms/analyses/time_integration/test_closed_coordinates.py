"""Coordinates that close loops: what hardly moves of them has the rounding of the largest."""

from support.scenes import problem

from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

SLIDES = """
points: {A: {body: b, at: [0, 0]}, B: {body: b, at: [2 m, 0]}, C: {body: b, at: [1 m, 0]}}
surfaces: {floor: {line: [[0, 0], [2 m, 0]]}}
bodies: {b: {shape: rod, mass: 5 kg, from: [0, 0], to: [2 m, 0], move: [x, y, p]}}
constraints: {r: {point: A, surface: floor}, q: {point: B, surface: floor}}
forces: {P: {at: C, force: [100 N, -100 N]}}
"""


def test_a_coordinate_that_loops_keep_at_zero_is_zero_within_its_bound():
    scene = problem(SLIDES)
    for text in ("y(1 s)", "p(1 s)"):
        found, relative = measure(scene, parse(text))
        assert abs(found) <= relative * abs(found) <= 1e-12
    found, relative = measure(scene, parse("x(1 s)"))
    assert abs(found - 10) <= 10 * relative < 1e-9
