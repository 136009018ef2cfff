"""Odd combinations of all that the language has: random scenes against a mechanics of their own (tests/odd)."""

import pytest
from odd.sweep import Sweep

SCENES, MOST_REFUSED = 40, 0.25


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    found = Sweep(tmp_path_factory.mktemp("odd"))
    for seed in range(1, SCENES + 1):
        found.scene(seed)
    return found


def test_every_number_agrees(sweep):
    assert sweep.numbers > 40 * SCENES
    assert not sweep.disagreements


def test_few_are_refused(sweep):
    assert sweep.refused < MOST_REFUSED, sweep.refusals
