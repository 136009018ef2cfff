"""Modes whose two eigenvalues are one, or nearly so, against their closed form in many digits."""

import numpy as np
import pytest
from mpmath import exp, mp, mpf, sqrt

from vibcli.analyses.continuous.modal_states import states_of

PLACE, SPEED = 0.7, -3.0


@pytest.mark.parametrize("beyond", [0.0, 1e-12, -1e-7, 2e-5, -3e-5, 4e-5, 1e-3])
def test_free_motions(beyond):
    """η = Σ of λ, μ: (v − μ x) e^{λt}/(λ − μ)."""
    omega, times = 5.0, np.linspace(0, 3, 31)
    states = states_of(np.array([omega**2]), np.array([2 * (1 + beyond) * omega]), np.zeros((1, 1)),
                       np.array([PLACE]), np.array([SPEED]))
    found = np.real(np.exp(np.outer(times, states.rates)) @ states.begin)
    with mp.workdps(60):
        zeta = 1 + mpf(beyond) + mpf(10) ** -25
        root = sqrt(zeta**2 - 1) * 5
        one, two = -5 * zeta + root, -5 * zeta - root
        wanted = [((SPEED - two * PLACE) * exp(one * t) - (SPEED - one * PLACE) * exp(two * t)) / (one - two)
                  for t in map(mpf, times.tolist())]
    assert np.abs(found - np.array([float(x.real) for x in wanted])).max() < 1e-13
