"""Where loads lead along what is held far more softly than the rest: places that floats do not tell, against sums of
what each spring gives way by."""

from fractions import Fraction

import pytest
from support.scenes import problem

STIFF = """
    bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 1 kg, slide: y}}}}
    springs: {{s: {{k: {stiff} N/m, stretch: x + y}}, t: {{k: {soft} N/m, stretch: y}}}}
    forces: {{F: {{at: b, force: -3 N}}}}
    """
LEVER = """
    parameters: {{L: 1 m}}
    bodies: {{rod: {{shape: rod, mass: 2 kg, from: [0, 0], to: [L, 0], move: [x, y, phi]}}}}
    springs:
      across: {{k: {stiff} N/m, stretch: y - sin(phi)*0.5 m}}
      along: {{k: {stiff} N/m, stretch: x}}
      turn: {{torsion: {soft} N*m, stretch: phi}}
    forces: {{M: {{body: rod, moment: {moment} N*m}}}}
    """


@pytest.mark.parametrize("stiff", ["1e6", "1e9", "1e12", "1e14"])
@pytest.mark.parametrize("soft", ["1e-3", "20"])
def test_a_soft_spring_is_drawn_out_whatever_holds_beside_it(stiff, soft):
    found = problem(STIFF.format(stiff=stiff, soft=soft)).configuration.equilibrium.values
    y = -3 / Fraction(soft)
    x = -y          # the stiff spring bears nothing, as no force acts on x
    assert found["y"] == pytest.approx(float(y), rel=1e-12) and found["x"] == pytest.approx(float(x), rel=1e-12)


@pytest.mark.parametrize("stiff", ["1e6", "1e9", "1e12", "1e14"])
def test_so_is_a_soft_hinge_in_a_scene_that_is_not_linear(stiff):
    scene = problem(LEVER.format(stiff=stiff, soft="1e-3", moment="2e-4"))
    assert not scene.system.is_linear
    assert scene.configuration.equilibrium.values["phi"] == pytest.approx(0.2, rel=1e-12)


def test_no_more_digits_are_asked_for_where_floats_tell(monkeypatch):
    from vibcli.mechanics.equilibrium import equilibrium

    monkeypatch.setattr(equilibrium, "_in_digits", None)
    assert problem(STIFF.format(stiff="1e3", soft="1")).configuration.equilibrium.values["y"] == -3.0
