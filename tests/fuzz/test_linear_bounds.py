"""The bounds of values in time, extremes, instants, steady states and frequency responses hold in random linear scenes,
against many digits."""

from statistics import median

import pytest
from support.linear_bounds import compared, free, harmonics, survey

MEDIAN = 1e3


@pytest.mark.parametrize(("drawn", "scenes", "least"), [(compared, 18, 180), (harmonics, 20, 100), (free, 30, 150)])
def test_bounds_of_linear_motions_hold(drawn, scenes, least):
    failures, ratios = survey(scenes, 41, drawn)
    assert not failures
    assert len(ratios) > least
    assert median(ratio for ratio, *_ in ratios) <= MEDIAN
