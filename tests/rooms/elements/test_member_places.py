"""How the ends of members are called that are drawn from one place to another."""

import pytest

import vibcli

GIVEN = {"L": "2 m", "B": "1 m", "alpha": "30 deg", "beta": "40 deg"}
SCENE = """
parameters: {GIVEN}
beams: {b: {from: [0, 0], to: TO, EI: 800 N*m^2, mass_per_length: 3 kg/m, left: clamped}}
"""


@pytest.mark.parametrize(("to", "end"), [
    ("[L*cos(alpha), L*sin(alpha)]", "L"), ("[-L*sin(alpha), L*cos(alpha)]", "L"), ("[-L, 0]", "L"),
    ("[L*cos(alpha), L*sin(beta)]", "sqrt((L*cos(alpha))^2 + (L*sin(beta))^2)"),
    ("[L*cos(alpha), L*cos(alpha)]", "sqrt((L*cos(alpha))^2 + (L*cos(alpha))^2)"),
    ("[L*cos(alpha), B*sin(alpha)]", "sqrt((L*cos(alpha))^2 + (B*sin(alpha))^2)"), ("[L, B]", "sqrt(L^2 + B^2)")])
def test_the_end_of_a_member_at_an_angle_is_called_by_its_length(to, end):
    """It was √((L cos α)² + (L sin α)²)."""
    parameters = ", ".join(f"{name}: {value}" for name, value in GIVEN.items() if name in to)
    scene = SCENE.replace("GIVEN", parameters).replace("TO", to)
    assert vibcli.loads(scene).coordinates == [f"b.u({end})", f"b.slope({end})"]
