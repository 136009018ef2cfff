"""The bounds of values, outputs, extremes, instants, steady states and frequency responses hold in random linear
scenes, against many digits."""

from statistics import median

import pytest
from support.linear_bounds import compared, free, harmonics, outputs, survey

MEDIAN = 1e3


@pytest.mark.parametrize(("drawn", "scenes", "least"), [
    (compared, 20, 190), (outputs, 10, 80), (harmonics, 14, 70), (free, 30, 150)])
def test_bounds_of_linear_motions_hold(drawn, scenes, least):
    failures, ratios = survey(scenes, 41, drawn)
    assert not failures
    assert len(ratios) > least
    assert median(ratio for ratio, *_ in ratios) <= MEDIAN
