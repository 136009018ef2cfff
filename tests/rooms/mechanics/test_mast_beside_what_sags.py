"""What sags beside a mast does not bend it: B u⁗ − ((N + n x) u′)′ = μω² u, N = −μgh, n = μg, by its power series."""

import pytest
from support.scenes import problem

SCENE = """
parameters: {h: 4 m, L: 2 m, EI: 4e6 N*m^2, mu: 60 kg/m, g: 9.81 m/s^2}
gravity: g
beams:
  mast: {from: [0, 0], to: [0, h], EI: EI, mass_per_length: mu, left: clamped}
  arm: {from: [0, 0], to: [L, 0], EI: EI, mass_per_length: mu, left: clamped}
"""


@pytest.mark.sweep
def test_a_mast_keeps_its_frequencies():
    found = [mode.omega for mode in problem(SCENE).modal.modes.first(3)]
    assert found == pytest.approx([56.7054923644764527, 226.957809665201414, 355.550256863146968], rel=1e-12)
