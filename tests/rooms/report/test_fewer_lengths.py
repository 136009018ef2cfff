"""Reactions of a rope whose load swings, by one length."""

import random

import pytest
from support.scenes import problem

from vibcli.mechanics.inputs_outputs.reactions_along_motion import along_the_motion
from vibcli.notation.plain import plain
from vibcli.report.sections.fewer_lengths import in_few_lengths
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate

SWINGING = """\
parameters: {m: , J: , k: , r: , h: HEIGHT, g: }
coordinates: [x, y]
gravity: g
bodies:
  drum: {inertia: J, at: [0, 0], pin: phi}
  load: {mass: m, at: [r, -h], move: [x, -y, 0]}
springs: {s: {torsion: k, between: [ground, drum]}}
constraints: {rope: {rope: [{over: drum, radius: r}, load]}}
find: [reactions]
"""


@pytest.mark.sweep
@pytest.mark.parametrize("height", ["", "{sign: any}"])
def test_a_rope_pulls_its_drum_by_what_reads_in_a_line(height):
    """(r·(x + r) + (y + h)·ℓ)·λ/(ℓ² + r²), the unit vector of a tangent of length ℓ to the circle, with the values of
    what is multiplied out; also where the load may lie above the drum."""
    found = along_the_motion(problem(SWINGING.replace("HEIGHT", height)).numeric)
    known = {}
    shown, lengths = in_few_lengths(list(found.values()), known)
    assert len(lengths) == 1 and set(known.values()) == {lengths[0][0]}
    draw = random.Random(3)
    for node, short in zip(found.values(), shown, strict=True):
        assert len(plain(short)) < 60 < len(plain(node))
        whole, = substitute([short], dict(lengths))
        at = {name: draw.uniform(0.5, 1.5) for name in ("m", "J", "k", "r", "h", "g", "x", "y", "lambda_rope")}
        assert evaluate([whole], Floats, at) == pytest.approx(evaluate([node], Floats, at), rel=1e-12)


def test_what_has_no_length_stays():
    scene = problem("bodies: {b: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 3 N/m, between: [ground, b]}}\n")
    energy = scene.symbolic.energies["V"]
    assert in_few_lengths([energy], {}) == ([energy], []) and in_few_lengths([], {}) == ([], [])
