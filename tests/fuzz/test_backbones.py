"""Families of random scenes against motions shot anew: `python -m fuzz.backbones 100` takes more of them."""

from fuzz.backbones import LEFT, differences


def test_random_families():
    found = list(differences(3, 7))
    assert all(apart is not None and apart <= bound + LEFT for apart, bound, _ in found)
    assert all(0 < bound < 1e-9 for _, bound, _ in found)
