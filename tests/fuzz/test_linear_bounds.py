"""The bounds of values in time, extremes and their instants hold in random linear scenes, against many digits."""

from statistics import median

from support.linear_bounds import survey

SCENES, MEDIAN = 30, 1e3


def test_bounds_of_linear_motions_hold():
    failures, ratios = survey(SCENES, 41)
    assert not failures
    assert len(ratios) > 8 * SCENES
    assert median(ratio for ratio, *_ in ratios) <= MEDIAN
