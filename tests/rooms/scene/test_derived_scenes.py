"""A scene is finished when it is made: what is derived from it leaves it as it is."""

import pytest
from support.scenes import problem

from vibcli.language.reader import Reference
from vibcli.results.problem import Problem

HANGING = """
parameters: {m: 2 kg, k: 800 N/m, l: 1 m, Y: 1 cm, W: 3 rad/s, g: 9.81 m/s^2}
gravity: g
coordinates: [phi, x]
points: {top: {at: [0, 0], moves: [Y*sin(W*t), 0]}, tip: {body: rod, at: [l, 0]},
  middle: {body: rod, at: [l/2, 0]}}
bodies:
  rod: {shape: rod, mass: m, from: [0, 0], to: [l, 0], pin: {at: top, by: phi}}
  block: {mass: m, at: [l, 1 m], slide: {by: x, along: [0, 1]}}
springs: {s: {k: k, between: [[l/2, -1 m], tip], preload: static}, b: {k: k, between: [[l, 3 m], block]}}
constraints: {tie: {equation: x = l*sin(phi)}}
"""
LINKED = HANGING.replace("tie: {equation: x = l*sin(phi)}", "bar: {link: [tip, block]}")
DERIVED = ("with_multipliers", "with_released_supports", "with_inputs", "resting", "vibrating", "drawn_anew")


def contents(scene):
    """All that a scene is made of, as the objects that stand in it now."""
    return [scene.coordinates[:], scene.q[:], dict(scene.drawn), dict(scene.points), dict(scene.driven),
            dict(scene.inputs), scene.released[:], scene.constraints[:], scene.static_preloads[:], scene.contents.nodes]


def derived(scene, how):
    found = getattr(scene, how)
    return found(scene.attempt) if how == "drawn_anew" else found() if callable(found) else found


@pytest.mark.parametrize("text", [HANGING, LINKED])
@pytest.mark.parametrize("how", DERIVED)
def test_what_is_derived_leaves_a_scene_as_it_is(text, how):
    scene = problem(text).scene
    before = contents(scene)
    other = derived(scene, how)
    other.place(Reference("middle", None))
    scene.place(Reference("middle", None))
    assert contents(scene) == before
    assert derived(other, how).coordinates == other.coordinates


def test_derived_scenes_have_the_coordinates_that_they_add():
    scene = problem(LINKED).scene
    assert scene.coordinates == ["phi"] and scene.loops.names == ["x"]
    assert scene.with_multipliers().coordinates == ["phi", "x"]
    released = scene.with_released_supports()
    assert released.coordinates[:2] == ["phi", "x"] and len(released.released) == len(released.coordinates) - 2
    opened = scene.with_inputs()
    assert opened.q[:1] + list(opened.inputs) == opened.q
    assert {opening.name for opening in opened.inputs.values()} >= {"top.x", "phi", "x"}
    both = released.with_inputs()
    assert both.released and both.inputs and list(both.inputs) == both.q[-len(both.inputs):]


def test_preloads_are_put_into_a_copy():
    scene = Problem(problem(LINKED).spec).scene.with_multipliers()
    (symbol, record), = scene.static_preloads
    loaded = scene.with_preloads({symbol: scene.table.number(7)})
    assert record.name == "s" and not loaded.static_preloads
    assert scene.terms_of("s")[0].offset is symbol and loaded.terms_of("s")[0].offset is scene.table.number(7)
    assert loaded.resting.terms_of("s")[0].offset is scene.table.number(7)
