"""Sums over damped modes from those without damping, against the sums themselves."""

import numpy as np
import pytest

from vibcli.analyses.continuous.damped_sum import DampedSum
from vibcli.analyses.continuous.member_damping import MemberDamping
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.undamped import Mode

SHARES = np.array([[1.0, -0.5, 0.3, 2.0, 1.0], [0.1, 0.2, 0.3, 0.4, 0.5]])


def modes(rates):
    return Modes([Mode(i, rate, None, np.zeros(0), np.zeros(0), 0.0) for i, rate in enumerate(rates, 1)])


def both(rates, damping, s):
    """The DampedSum and the plain sum at s."""
    squares = np.array(rates)[:, None] ** 2

    def undamped(sigma):
        return np.einsum("ki,in->kn", SHARES, 1 / (squares + sigma**2))

    known = modes(rates)
    c = np.array([damping.rate(mode) for mode in known])[:, None]
    wanted = np.einsum("ki,in->kn", SHARES, 1 / (squares + s**2 + c * s))
    return DampedSum(damping, known, undamped).at(s), wanted


@pytest.mark.parametrize("damping", [
    MemberDamping(ratios=(0.02,)), MemberDamping(ratios=(0.6,)), MemberDamping(ratios=(0.9,)),
    MemberDamping(ratios=(1.0,)), MemberDamping(ratios=(0.05, 20.0)),
    MemberDamping(ratios=(0.02, 0.03, 0.1, 0.01)), MemberDamping(ratios=(1.3, 0.05)), MemberDamping(series=(0.3,)),
    MemberDamping(series=(0.1, 0.01)), MemberDamping(series=(0.0, 0.5)),
    MemberDamping(series=(0.1, 0.01, 0.002, 1e-5))])
@pytest.mark.parametrize("lowest", [1.0, 0.0])
def test_sums_over_damped_modes(damping, lowest):
    s = 1j * np.array([0.01, 1.0, 2.55, 7.0, 39.9, 300.0])
    found, wanted = both([lowest, 2.5, 2.6, 7.0, 40.0], damping, s)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=2e-11 * abs(wanted).max())
    assert (abs(found - wanted) <= 1e-11 * abs(wanted).max(axis=0)).all()


def test_sums_off_the_axis():
    s = 3 * np.exp(1j * np.linspace(0.3, 2.8, 9))
    found, wanted = both([1.0, 2.5, 2.6, 7.0, 40.0], MemberDamping(ratios=(0.04, 0.02)), s)
    assert (abs(found - wanted) <= 1e-11 * abs(wanted).max(axis=0)).all()
