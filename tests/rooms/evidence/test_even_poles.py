"""Poles of beams that are even: a few of them give all others, as the equations have them."""

import mpmath
import numpy as np
import pytest

from vibcli.evidence.reference.even_poles import even_poles


class Residues:
    """Of what has the poles 2 i (n π)² and (−1)ⁿ/(n³ (1 + 1/n)) there."""

    def __init__(self, uneven=0):
        self.few = [self._one(n, uneven) for n in range(1, 110)]

    def _one(self, n, uneven=0):
        n = mpmath.mpf(n)
        return 2j * (n * mpmath.pi) ** 2 + uneven * mpmath.sin(n), [mpmath.mpc((-1) ** int(n) / (n**3 + n**2))]

    def exact(self, near):
        return self._one(mpmath.nint(mpmath.sqrt(abs(near) / 2) / mpmath.pi))


@pytest.mark.sweep
def test_every_other_one_is_alike():
    with mpmath.workdps(60):
        found = even_poles(Residues())
        p, c = found.between(1001, 5000)
        n = np.arange(1001, 5001)
        assert np.abs(p / (2j * np.longdouble(mpmath.nstr(mpmath.pi**2, 30)) * n**2) - 1).max() < 1e-17
        assert np.abs(c[0] * (-1.0) ** n * n**2 * (n + 1) - 1).max() < 1e-13
        (p, (c,)), = found.exactly(777, 777)
        exact, (residue,) = Residues().exact(p)
        assert abs(p - exact) < 1e-45 and abs(c - residue) < 1e-26


def test_what_is_uneven_is_left_alone():
    with mpmath.workdps(60):
        assert even_poles(Residues(uneven=1)) is None
