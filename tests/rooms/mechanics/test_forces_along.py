"""Forces along a motion: of a scene at rest in its equilibrium they are those of statics."""

from pathlib import Path

import numpy as np
import pytest
from support.scenes import kept_instances_of

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.forces_along_motion import ForcesAlong
from vibcli.symbolic.evaluation import Floats, evaluate

ROOT = Path(__file__).parents[3]
FILES = sorted([*ROOT.glob("problems/[12]_*/*.yaml"), *ROOT.glob("problems/6_two*/*.yaml"),
                *ROOT.glob("vibcli/examples/*.yaml")])
COMPARED = []


def at_rest(one):
    """{name: array} of all coordinates at rest in equilibrium, as a motion has them."""
    scene = one.scene
    values = {**one.configuration.at_rest, **dict.fromkeys((node.name for node in (*scene.v, *scene.a)), 0.0)}
    found = {**one.numeric.floats, scene.time.name: np.zeros(1)}
    own = [node for node in (*scene.q, *scene.v, *scene.a) if node.name in values]      # nodes of members too
    found |= {node.name: np.array([values[node.name]]) for node in own}
    for name in one.spec.coordinates:
        for primes in range(3):
            found[name + "'" * primes] = np.array(evaluate([scene.symbol(name, primes)], Floats, values))
    return found


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_of_a_scene_at_rest(path):
    one = next(iter(kept_instances_of(path)), None)
    try:
        statics = {} if one is None or one.scene.timed else {
            reaction.signal: reaction.value for reaction in one.configuration.reactions if reaction.value is not None}
    except PhysicsError:
        return
    found = ForcesAlong(one.numeric).values(list(statics), at_rest(one)) if statics else {}
    size = max(map(abs, statics.values()), default=0.0)
    for name, value in statics.items():
        assert found[name][0] == pytest.approx(value, rel=1e-8, abs=1e-9 * size + 1e-10), name
    COMPARED.extend(found)


def test_many_were_compared():
    assert len(COMPARED) > 300 or not COMPARED
