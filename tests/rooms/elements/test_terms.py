"""What springs, dampers and their laws say of themselves: force, potential, energy and power belong together."""

import random
from pathlib import Path

import pytest
from support.scenes import kept_problem_of

import vibcli
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

EXAMPLES = sorted((Path(vibcli.__file__).parent / "examples").glob("*.yaml"))


def connected():
    """(scene, [springs, dampers and laws]) of every example whose coordinates are all independent."""
    for path in EXAMPLES:
        scene = kept_problem_of(path).scene
        terms = [term for term in (*scene.springs, *scene.dampers, *scene.laws) if term.owner not in scene.members]
        if terms and not scene.dependent:
            yield scene, terms


def agree(scene, pairs):
    """Pairs of expressions have the same values in a random state, none of them where a table of one ends."""
    draw = random.Random(4)
    state = {symbol.name: draw.uniform(0.05, 0.3) for symbol in (*scene.q, *scene.v, *scene.a, scene.time)}
    for one, other in pairs:
        left, right = evaluate([one, other], Floats, {**scene.sample, **state})
        assert left == pytest.approx(right, rel=1e-9, abs=1e-9, nan_ok=True)


@pytest.mark.sweep
def test_a_force_is_the_slope_of_the_potential_and_takes_or_gives_what_is_stored_or_dissipated():
    seen = set()
    for scene, terms in connected():
        zero = scene.table.zero
        for term in terms:
            speed, force = scene.rate(term.s), term.force(scene)
            stores = term.power(scene) is None
            by, along = (scene.q, term.s) if stores else (scene.v, speed)
            pairs = [(gradient(term.potential(scene)).get(x, zero), force * gradient(along).get(x, zero)) for x in by]
            if stores and not term.nodes[0].is_zero:
                pairs.append((scene.rate(term.energy(scene)), force * speed))
            if not stores:
                pairs.append((term.power(scene), force * speed))
            agree(scene, pairs)
            assert (term.energy(scene) is None) is not stores
            seen.add((type(term).__name__, stores))
    assert seen == {("Spring", True), ("Damper", False), ("Law", True), ("Law", False)}


@pytest.mark.sweep
def test_a_scene_knows_the_terms_of_each_element():
    for scene, terms in connected():
        for term in terms:
            assert term in scene.terms_of(term.owner)
            assert len(scene.terms_of(term.owner)) in (1, 2)    # two components where there is no free length
        assert sum(len(scene.terms_of(name)) for name in {term.owner for term in terms}) == len(terms)
        assert scene.terms_of("nobody") == [] and scene.force_of("nobody") is None
