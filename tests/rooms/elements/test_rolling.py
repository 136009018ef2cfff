"""Rolling on two surfaces: what two words say of one scene agrees, in motion and in the forces of contact."""

import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError

CYLINDER = """
parameters: {m: 12 kg, M: 20 kg, g: 9.81 m/s^2, b: 0.9 m, h: 4 cm, R: 0.25 m, k: 900 N/m}
gravity: g
motion: full
initial: {phi: 0.2, psi: 0.1}
springs: {s: {k: k, between: [[-1.2 m, R], cylinder], free_length: 1.2 m}}
bodies:
  cylinder: {shape: disc, mass: M, radius: R, at: [0, R], roll: {%s, turn: phi}}
  plank: {shape: rectangle, mass: m, width: 2*b, height: 2*h, at: [0, 2*R + h], %s}
surfaces:
  floor: {line: [[-1 m, 0], [1 m, 0]]}
"""
FLAT = ("coordinates: [phi, psi]" + CYLINDER % (
    "surface: floor", "roll: {surface: drum, flat: [[-b, 2*R], [b, 2*R]], turn: psi}")
    + "  drum: {circle: [0, R], radius: R, body: cylinder}\n")
ROUND = ("coordinates: [phi, psi, x, y]" + CYLINDER % ("between: [floor, underside]", "move: [x, y, psi]")
         + "  underside: {line: [[-b, 2*R], [b, 2*R]], body: plank}\n")
SAME = (("plank.normal", "cylinder.normal.underside"), ("plank.friction", "cylinder.friction.underside"),
        ("plank.x", "plank.x"), ("plank.y", "plank.y"))

RACKS = """
parameters: {m: 4 kg, r: 5 cm}
coordinates: [one, two]
springs: {s: {%s}}
initial: {%s}
surfaces: {a: {%s}, b: {%s}}
bodies:
  first: {%s}
  second: {%s}
  disc: {shape: disc, mass: m, radius: r, at: [0, 2*r], roll: {between: [a, b]%s}}
"""
PAIRS = {
    "racks": ("k: 800 N/m, between: [[-1 m, 0], first], free_length: 1 m", "one: 1 cm, two': 0.3 m/s",
              "line: [[0, r], [1 m, r]], body: first", "line: [[0, 3*r], [1 m, 3*r]], body: second",
              "mass: 9 kg, at: [0, 0], slide: one", "mass: 9 kg, at: [0, 4*r], slide: two"),
    "wheels": ("torsion: 30 N*m/rad, between: [ground, first]", "one: 0.1 rad, two': 0.3 rad/s",
               "circle: [0, 0], radius: r, body: first", "circle: [0, 0], radius: 3*r, side: inside, body: second",
               "inertia: 0.3 kg*m^2, at: [0, 0], pin: one", "inertia: 0.6 kg*m^2, at: [0, 0], pin: two"),
}


@pytest.mark.sweep
def test_a_flat_side_is_what_rolls_below_it():
    flat, round_ = problem(FLAT), problem(ROUND)
    for asked in ("omega[1]", "omega[2]", "M[phi,psi]", "K[phi,psi]", "K[psi,psi]"):
        assert value(round_, asked) == pytest.approx(value(flat, asked), rel=1e-9), asked
    for one, two in SAME:
        for t in ("0 s", "0.7 s"):
            assert value(round_, f"{two}({t})") == pytest.approx(value(flat, f"{one}({t})"), rel=1e-6), (two, t)


@pytest.mark.parametrize("kind", ["racks", "wheels"])
def test_with_a_coordinate_or_none(kind):
    none, one = (problem(RACKS % (*PAIRS[kind], turn)) for turn in ("", ", turn: phi"))
    for asked in ("omega[1]", "omega[2]", "M[one,two]", "M[two,two]", "disc.x(0.3 s)", "disc.angle(0.3 s)",
                  "first.reaction.x(0.3 s)"):
        assert value(none, asked) == pytest.approx(value(one, asked), rel=1e-9, abs=1e-9), asked
    turned = [value(one, f"disc.friction.{surface}(0.3 s)") for surface in "ab"]
    assert value(none, "disc.reaction.moment(0.3 s)") == pytest.approx(0.05 * sum(turned), rel=1e-9)
    with pytest.raises(PhysicsError, match="not told apart"):
        value(none, "disc.friction.a(0.3 s)")
    with pytest.raises(PhysicsError, match="do not fix"):
        value(one, "disc.normal.b(0.3 s)")

