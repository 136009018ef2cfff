"""Loads as inputs of a scene: its own expressions, with rows of loads; what is driven, tied or held is drawn anew."""

import pytest
from support.scenes import problem

from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
from vibcli.scene import build

BLOCKS = """
    parameters: {m: 2 kg, k: 50 N/m, c: 3 N*s/m, F: 3 N}
    bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}}
    springs: {s: {k: k, between: [ground, a]}, t: {law: (3 N/m)*d + (5 N/m^3)*d^3, between: [a, b]}}
    dampers: {d: {c: c, between: [a, b]}}
    forces: {drive: {at: b, force: F*sin(3 rad/s*t)}, hold: {at: a, force: 2 N}, drag: {at: a, force: "-c*x'"}}
"""
ROD = """
    parameters: {m: 2 kg, L: 0.7 m, g: 9.81 m/s^2, k: 40 N/m, F: 5 N}
    gravity: g
    points: {O: [0, 0], A: {body: rod, at: [0, -L]}}
    bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: O, by: phi}}}
    springs: {s: {k: k, between: [[L, -L], A], preload: static}}
    forces: {drive: {at: A, force: [F*sin(3 rad/s*t), F], carrier: rod}}
"""
TURNED = """
    parameters: {m: 2 kg, k: 900 N/m, W: 3 rad/s, F: 5 N}
    points: {O: [0, 0]}
    bodies:
      arm: {at: [0, 0], pin: {at: O, by: W*t}}
      bead: {mass: m, at: [1 m, 0], slide: {by: x, along: [1, 0], carrier: arm}}
    springs: {s: {k: k, between: [O, bead], preload: static}}
    forces: {drive: {at: bead, force: [F*sin(2 rad/s*t), 0], carrier: arm}}
"""
SHAKEN = BLOCKS.replace("    bodies:", "    points: {P: {at: [0, 0], moves: [1 cm*sin(2 rad/s*t), 0]}}\n    bodies:")
TIED = BLOCKS + "    constraints: {tie: {equation: y = 2*x}}\n"
STILL = """
    bodies: {block: {mass: 2 kg, at: [0, 0], slide: x}}
    springs: {s: {k: 50 N/m, between: [[-1 m, 0], block]}}
    forces: {drive: {at: block, force: [3 N, 4 N*sin(2 rad/s*t)]}}
"""


def opened(scene, found):
    """SystemWithInputs of what is found of a scene."""
    scene.system.__dict__["with_inputs"] = found
    return SystemWithInputs(scene.configuration)


@pytest.mark.parametrize("text", [BLOCKS, ROD], ids=["blocks", "rod"])
def test_rows_of_loads_are_those_of_the_scene_drawn_anew(text):
    scene = problem(text)
    drawn = scene.system._with_inputs(scene.scene.with_inputs())
    one, other = (opened(scene, found) for found in (scene.system._with_loads_alone(), drawn))
    assert one.scene.table is scene.scene.table is not other.scene.table
    assert one.scene.coordinates == other.scene.coordinates and one.varies == other.varies
    assert [*one.scene.inputs.values()] == [*other.scene.inputs.values()]
    assert one.elements.matrices() == other.elements.matrices() and one.columns == other.columns
    assert any(column[0] for column in one.columns.values())
    assert scene.scene.coordinates == [*scene.spec.coordinates] and not scene.scene.inputs


@pytest.mark.parametrize("text", [TURNED, SHAKEN, TIED, STILL], ids=["turned", "shaken", "tied", "still"])
def test_what_more_than_loads_drive_is_drawn_anew(text):
    scene = problem(text)
    assert scene.system._with_loads_alone() is None
    assert scene.configuration.with_inputs.scene.table is not scene.scene.table


def test_a_response_to_a_load_draws_the_scene_once(monkeypatch):
    drawn, builder = [], build.Builder
    monkeypatch.setattr(build, "Builder", lambda *args: drawn.append(args) or builder(*args))
    scene = problem(BLOCKS)
    assert scene.frequency_response("x", "drive").peaks
    assert len(drawn) == 1
