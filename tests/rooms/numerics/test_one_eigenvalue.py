"""A matrix with one entry is not searched for eigenvectors: it comes out as one does that is."""

import random

import numpy as np
import pytest

from vibcli.numerics.symmetric_eigenvalues import spectrum


@pytest.mark.parametrize("zeros", [None, 0, 1])
@pytest.mark.parametrize("bits", [221, 400, 1000])
def test_one_entry_as_any_matrix(bits, zeros):
    entries = random.Random("entries")
    for size in (0, 1, bits // 2, bits, bits + 40):
        a = np.array([[entries.choice((1, -1)) * entries.getrandbits(size)]], object)
        for slack in (-3, 0, 2.5, 17.25, 120.0):
            with np.errstate(all="ignore"):
                alone, sought = spectrum(a, bits, 60, zeros, slack), spectrum(a, bits, 60, zeros, slack, np.eye(1))
            for part in ("values", "radius", "vectors"):
                assert getattr(alone, part).tolist() == getattr(sought, part).tolist()
                assert getattr(alone, part).dtype == getattr(sought, part).dtype
            assert (alone.shift, alone.bits) == (sought.shift, sought.bits)
