"""Forces in letters where a scene rests elsewhere than drawn: those in numbers, and by hand."""

import pytest
from support.scenes import problem

from vibcli.base.errors import NotInLetters
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

INCLINE = """
parameters: {m1: 5 kg, m2: 3 kg, alpha: 30 deg, r: 0.1 m, J: 0.02 kg*m^2, l: 1 m, k: 900 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  block: {mass: m1, at: [0, 0], slide: {along: [cos(alpha), sin(alpha)], by: x}}
  wheel: {inertia: J, at: [l*cos(alpha) + r*sin(alpha), l*sin(alpha) - r*cos(alpha)], pin: phi}
  load: {mass: m2, at: [l*cos(alpha) + r*sin(alpha) + r, -l], slide: {along: [0, -1], by: y}}
springs: {s: {k: k, between: [[-l*cos(alpha), -l*sin(alpha)], block]}}
constraints: {rope: {rope: [block, {over: wheel, radius: r}, load]}}
find: [equilibrium, reactions, frequencies]
"""
STACK = """
parameters: {m1: 2 kg, m2: 3 kg, k1: 400 N/m, k2: 300 N/m, h: 0.2 m, g: 9.81 m/s^2}
gravity: g
bodies:
  a: {mass: m1, at: [0, h], slide: {along: [0, 1], by: x1}}
  b: {mass: m2, at: [0, 2*h], slide: {along: [0, 1], by: x2}}
springs: {s1: {k: k1, between: [[0, 0], a]}, s2: {k: k2, between: [a, b]}}
forces: {f: {at: b, force: [5 N, -2 N]}}
"""
TABLE = """
parameters: {M: 4 kg, m: 1 kg, k: 200 N/m, F: 6 N, b: 0.3 m, g: 9.81 m/s^2}
gravity: g
bodies:
  table: {mass: M, at: [0, 0], slide: {along: [1, 0], by: x}}
  load: {mass: m, at: [b, b], weld: table}
springs: {s: {k: k, between: [[-b, 0], table]}}
forces: {f: {at: load, force: [F, 0]}}
"""


@pytest.mark.parametrize("text", [INCLINE, STACK, TABLE])
def test_forces_in_letters_are_those_in_numbers(text):
    scene = problem(text)
    assert not scene.symbolic.balanced_as_drawn
    numbers = {one.signal: one.value for one in scene.configuration.reactions}
    found = scene.symbolic.reactions.values
    assert numbers and set(found) == set(numbers)
    for signal, node in found.items():
        assert evaluate([node], Floats, scene.numeric.floats)[0] == pytest.approx(numbers[signal], rel=1e-12, abs=1e-12)


def test_a_block_on_an_incline_in_letters():
    values = problem(INCLINE.replace("m1: 5 kg", "m1: ").replace("k: 900 N/m", "k: ")).symbolic.reactions.values
    told = {signal: plain(node) for signal, node in values.items()}
    assert told["block.reaction.y"] == "m₁·g·cos²\u00a0α" and told["rope.force.1"] == "m₂·g"
    assert told["wheel.reaction.y"] == "m₂·g·(sin\u00a0α + 1)"


def test_steps_tell_them_from_the_balances():
    """N = m₁ g cos α across the path, 42.478 N, by 36.788 N upwards and 21.239 N back."""
    lines = {line.settles: line for line in worked(problem(INCLINE))}
    assert formula(lines["block.normal"].parts, plain).replace("\u00a0", " ") == (
        "across its path  block.normal = m₁·g·cos α = 42.4785 N")
    assert lines["block.normal"].value == pytest.approx(5 * 9.81 * 3**0.5 / 2, rel=1e-12)
    assert lines["block.normal"].uses == tuple(lines[f"block.reaction.{axis}"].number for axis in "xy")
    assert "load.normal" not in lines and "balance[y]" in lines


ASLANT = """
parameters: {m: 1 kg, l: 1 m, M: 3 N*m, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -l], pin: {at: [0, 0], by: phi}}}
forces: {turn: {body: bob, moment: M}}
"""
ROUGH = """
parameters: {m: 1 kg, k: 90 N/m, F: 3 N}
bodies: {b: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[-1 m, 0 m], b]}}
dampers: {f: {friction: F, between: [[-1 m, 0 m], b]}}
"""


@pytest.mark.parametrize(("text", "reason"), [(ASLANT, "nonlinear"), (ROUGH, "friction")])
def test_what_is_not_known_in_letters_is_refused(text, reason):
    """A pendulum that a moment holds aslant, a block that friction holds."""
    with pytest.raises(NotInLetters, match=reason):
        _ = problem(text).symbolic.reactions
