"""Faults in one variant, its mistakes among them, are noticed before it is handed out."""

import random

import pytest
from support.mutations import MUTATIONS, is_noticed, mistakes_swapped, mutated, some_of
from support.shipped_variants import WITH_VARIANTS

SOME = "bell_crank_dashpot", "torsiograph_on_a_shaft", "quarter_car_damped", "string_with_a_bead"


@pytest.fixture(scope="module")
def known():
    return [some_of(path, 3) for path in WITH_VARIANTS if path.stem in SOME]


@pytest.mark.sweep
@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda one: one.__name__)
def test_a_fault_is_noticed_before_a_variant_is_handed_out(mutation, known):
    draw = random.Random(5)
    assert all(is_noticed(*mutated(draw, mutation, known)) for _ in range(6))
    assert not any(is_noticed(document, found, found.accepted[0]) for document, found in known)


def test_what_a_manifest_says_of_mistakes_is_of_its_time(known):
    document, found = known[0]
    one = mistakes_swapped(random.Random(1), document, found, found.accepted[0])
    assert is_noticed(document, found, one) and not is_noticed(document, found, one._replace(place=()))
