"""Lengths as they are told where they have symbols."""

from math import cos, hypot, sin

import pytest
from support.scenes import problem

from vibcli.notation.abbreviations import abbreviated
from vibcli.notation.plain import plain
from vibcli.symbolic.evaluation import Floats, evaluate

B, H, L, Y, PHI = 0.4, 0.7, 1.3, 0.21, 0.37
LETTERS = f"b: {{value: {B} m, unused: allowed}}, h: {H} m, L: {{value: {L} m, unused: allowed}}"
SPRUNG = """\
parameters: {m: 3 kg, k: 200 N/m, LETTERS}
bodies: {a: {mass: m, BODY}}
points: {P: {body: a, at: POINT}}
springs: {s: {k: k, between: [END, P]}}
"""


@pytest.mark.parametrize(("body", "point", "end", "told", "length"), [
    ("at: [0, 0], slide: {along: [0, 1], by: y}", "[0, 0]", "[b, -h]", "√((y + h)² + b²)", hypot(Y + H, B)),
    ("inertia: m*h^2, at: [0, 0], move: [0, y, phi]", "[b, L]", "[0, -h]",
     "√((y + b·sin φ + L·cos φ + h)² + (b·cos φ − L·sin φ)²)",
     hypot(Y + L * cos(PHI) + B * sin(PHI) + H, B * cos(PHI) - L * sin(PHI))),
    ("shape: rod, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}", "[0, -L]", "[0, -(L + h)]",
     "√(h² + 2·h·L + 2·L² − 2·L·(h + L)·cos φ)", hypot(L * sin(PHI), L + H - L * cos(PHI)))])
def test_a_length_is_told_by_its_legs_where_that_is_shorter_by_far(body, point, end, told, length):
    """The law of cosines stays; either way it has the value of the length."""
    text = SPRUNG.replace("LETTERS", LETTERS).replace("BODY", body).replace("POINT", point).replace("END", end)
    energy = problem(text).symbolic.energies["V"]
    _, ((_, root),) = abbreviated([energy], {})
    assert plain(root).replace("\u00a0", " ") == told
    at = {"b": B, "h": H, "L": L, "y": Y, "phi": PHI}
    assert evaluate([root], Floats, at) == pytest.approx([length], rel=1e-15)
