"""Marches along series that reach no further than the grain of the time."""

from types import SimpleNamespace

import pytest

from vibcli.analyses.time_integration.taylor_march import TaylorMarch
from vibcli.base.errors import PhysicsError


def steep(t, scale, state, order):
    """Series whose coefficients grow by 2⁴⁰⁰ each, in whatever unit of time."""
    rows = [[1 << 400 * k for k in range(order + 2)]]
    return SimpleNamespace(q=rows, v=rows, a=rows)


@pytest.mark.parametrize("longest", [None, 1 << 40])
def test_a_step_of_no_length_ends_the_march(longest):
    march = TaylorMarch(lambda t, bits: (steep, None, longest), lambda bits: [1 << bits, 0], [1.0], 30)
    assert march.bits < 200
    with pytest.raises(PhysicsError, match="series of this motion end at t = 0 s"):
        march.reach(1)
