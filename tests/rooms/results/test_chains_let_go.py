"""Hanging chains whose lower end is free, let go from a straight line and struck: against their series in Bessel's
functions, u = Σ c J₀(z √(s/L)) cos ωt, s the height above the lower end, ω = ½ z √(g/L)."""

import numpy as np
import pytest
from scipy.special import j0, j1, jn_zeros
from support.modes_found_once import modes_found_once  # noqa: F401

import vibcli
from vibcli.base.errors import NoBound
from vibcli.results import modal_response

LENGTH, G = 3.0, 9.81
CHAIN = f"""\
gravity: {G} m/s^2
strings: {{c: {{from: [0, 0], to: [0 m, -{LENGTH} m], mass_per_length: 2 kg/m, left: pinned}}}}
initial: {{%s}}
"""
pytestmark = pytest.mark.usefixtures("modes_found_once")


@pytest.fixture(scope="module")
def series():
    """What a chain does that starts with u = x/10, and with rates x/10, by 4,000 modes."""
    z = jn_zeros(0, 4000)
    omega, c = z / 2 * np.sqrt(G / LENGTH), 0.1 * LENGTH * 8 / (z**3 * j1(z))

    def moved(x, t):
        shapes = c * j0(z * np.sqrt((LENGTH - x) / LENGTH))
        return (shapes * np.cos(omega * t)).sum(), (shapes * np.sin(omega * t) / omega).sum()
    return moved


@pytest.mark.sweep
@pytest.mark.parametrize(("start", "which"), [("c.u: 0.1*x", 0), ("c.u': 0.1 s^-1*x", 1)])
def test_a_free_lower_end_is_no_jump(start, which, series, monkeypatch):
    monkeypatch.setattr(modal_response, "FIRST", 32)        # modes of what has a varying tension
    scene = vibcli.loads(CHAIN % start)
    for x, t in ((1.0, 0.5), (2.9, 0.5), (1.0, 3.1)):
        asked = scene[f"c.u({x} m)({t} s)"]
        assert abs(asked.value - series(x, t)[which]) <= asked.error + 1e-9
        assert asked.error < (1e-4, 1e-6)[which]
    with pytest.raises(NoBound, match="end without tension"):
        _ = scene[f"c.u({LENGTH} m)(0.5 s)"].value
