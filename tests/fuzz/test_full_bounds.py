"""No number of a full motion is farther from the truth than its estimate says: a tenth of the scenes of full_bounds."""

from statistics import median

import mpmath
from fuzz.full_bounds import DIGITS, compared

SEEDS, LONGEST, LOOSE = range(7000, 7030), "1.2", 1e4


def test_no_estimate_of_a_full_motion_is_exceeded():
    ratios, kinds = [], set()
    with mpmath.workdps(DIGITS):
        for seed in SEEDS:
            moving, found = compared(seed, LONGEST)
            kinds.add(moving.kind)
            over = [row for row in found if row[1] > row[2]]
            assert not over, (seed, moving.kind, over[0])
            ratios += [estimate / error for _, error, estimate in found if error]
    assert len(kinds) > 10 and len(ratios) > 1000
    assert median(ratios) < LOOSE
