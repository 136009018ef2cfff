"""Newton's steps towards complex frequencies, from starts of which some lead nowhere."""

import numpy as np
import pytest

from vibcli.analyses.continuous.newton_of_members import approached, distinct


class OneRoot:
    """D = s − 2, but at s = 3, where D′/D is beyond all floats."""

    def parts(self, s):
        far = s == 3
        D, slope = np.where(far, 1e-310, s - 2), np.where(far, 1e10, 1.0)
        yield None, np.arange(len(s)), D[:, None, None], slope[:, None, None]


def test_a_start_whose_step_is_not_found_is_left_out():
    with np.errstate(over="ignore", invalid="ignore"):
        assert approached(OneRoot(), np.array([1.0, 3.0, 2.5])).tolist() == [2.0, 2.0]


def test_roots_found_ever_so_often_stand_once_beside_others_as_far_from_zero():
    one, other = 3j - 1e-7, 3j - 2e-6       # |λ| alike to 1e-12
    found = distinct(np.array([one * (1 - 1e-11), *[other] * 20, one * (1 + 1e-11)]))
    assert sorted(found.real) == pytest.approx([-2e-6, -1e-7])
