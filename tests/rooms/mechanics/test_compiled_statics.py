"""Compiled forces at rest have the numbers of those that are summed entry by entry, to the last bit."""

import random
from math import isnan

import pytest
from support.scenes import kept_problem_of, scene_of_potential

from vibcli.mechanics.compiled_statics import OFTEN
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats

SCENES = ["problems/6_two_degrees/inverted_double_pendulum_on_springs.yaml", "vibcli/examples/buckled_post.yaml",
          "problems/1_statics_and_energy/snap_through_truss.yaml", "vibcli/examples/ziegler_column.yaml",
          "vibcli/examples/given_matrices.yaml", "vibcli/examples/slider_crank.yaml", "vibcli/examples/strings.yaml"]


def plainly(numeric, position):
    numbers = in_numbers(numeric.system.statics, Floats, {**numeric.floats, **position})
    return numbers.residual, numbers.residual_size, numbers.elements.stiffness_array().tolist()


def bits(found):
    r, sizes, K = found
    return [float(x).hex() for part in (r, sizes, *K) for x in part]


@pytest.mark.parametrize("path", SCENES)
def test_compiled_as_summed(path):
    numeric, generator = kept_problem_of(path).configuration.numeric, random.Random(3)
    forces = numeric.static_forces
    for _ in range(OFTEN + 6):
        position = {name: x + generator.uniform(-0.2, 0.2) for name, x in numeric.drawn_floats.items()}
        assert bits(forces.at(position)) == bits(plainly(numeric, position))
    assert numeric.system.statics_code.function() is not None


def test_where_forces_have_no_value():
    """√(1 − x²) beyond its end is NaN, as before it was compiled."""
    numeric = scene_of_potential("(1 - x^2)^(3/2)").configuration.numeric
    for x in [0.5] * (OFTEN + 2) + [1.5, 0.25]:
        found = numeric.static_forces.at({"x": x})
        assert bits(found) == bits(plainly(numeric, {"x": x}))
        assert isnan(found[0][0]) == (x > 1)
