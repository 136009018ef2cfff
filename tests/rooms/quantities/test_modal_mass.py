"""φᵀMφ of undamped modes against shapes found from M and K by mpmath, and against textbooks' numbers."""

from math import sqrt
from pathlib import Path
from textwrap import dedent

import mpmath
import pytest
from support.scenes import problem, problem_of, value

import vibcli
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.check.instances import Instances
from vibcli.cli.program import run
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

PROBLEMS = Path(__file__).parents[3] / "problems"
NAMES = ("6_more_degrees/chain_of_six", "6_more_degrees/five_disc_shaft", "6_more_degrees/geared_shafts",
         "6_more_degrees/three_discs_on_fixed_shaft", "6_more_degrees/three_car_train",
         "6_two_degrees/car_bounce_and_pitch", "6_two_degrees/cart_with_pendulum", "6_two_degrees/disc_on_seesaw",
         "6_two_degrees/disc_in_track_with_rod", "6_two_degrees/double_pendulum_rods",
         "6_two_degrees/quarter_car_damped", "6_two_degrees/sagging_spring_pendulum",
         "6_two_degrees/stepped_drum_with_block_and_pulley", "3_free_undamped/eccentric_cylinder")
TWO = dedent("""
    parameters: {m: 2 kg, J: 3 kg*m^2, k: 50 N/m, L: 1 m}
    bodies: {a: {mass: m, slide: x}, b: {inertia: J, turn: phi}}
    springs: {s: {k: k, between: [ground, a]}, t: {torsion: k*L^2, between: [ground, b]}}
""")


def exact(scene):
    """φᵀMφ of all modes, by ascending frequency."""
    names = scene.scene.coordinates
    with mpmath.workdps(40):
        M, K = (mpmath.matrix([[value(scene, f"{which}[{i},{j}]") for j in names] for i in names]) for which in "MK")
        squares, shapes = mpmath.eig(M**-1 * K)
        found = []
        for _, i in sorted((mpmath.re(square), i) for i, square in enumerate(squares)):
            shape = shapes[:, i]
            first = next(x for j, x in enumerate(shape) if abs(x)**2 * M[j, j] > mpmath.mpf(10)**-18)
            found.append(float(mpmath.re((shape.T * M * shape)[0] / first**2)))
        return found


@pytest.mark.parametrize("name", NAMES)
def test_it_is_that_of_the_shapes_of_M_and_K(name):
    scene = next(iter(Instances(problem_of(PROBLEMS / f"{name}.yaml"))))
    wanted = exact(scene)
    assert len(wanted) == len(scene.modal.modes) > 0
    for i, expected in enumerate(wanted, 1):
        found, error = measure(scene, parse(f"modal_mass[{i}]"))
        assert abs(found - expected) <= error * abs(expected), i
        assert error <= 1e-10


def test_it_has_the_measure_of_the_coordinate_that_moves_first(tmp_path, capsys):
    scene = problem(TWO)
    assert [value(scene, f"modal_mass[{i}]") for i in (1, 2)] == [3.0, 2.0]
    frame = problem("parameters: {m: 2 kg, k: 50 N/m}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
                    "springs: {s: {k: k, between: [ground, a]}, t: {k: k, between: [a, b]}}")
    assert value(frame, "modal_mass[1]") == pytest.approx(5 + sqrt(5), rel=1e-13)
    path = tmp_path / "scene.yaml"
    shaft = ("parameters: {J: 2 kg*m^2, k: 8 N*m/rad}\nbodies: {a: {inertia: J, turn: phi}}\n"
             "springs: {s: {torsion: k, between: [ground, a]}}\nanswers: {'modal_mass[1]': UNIT}\n")
    for unit, code in (("2.00 kg*m^2", 0), ("2.01 kg*m^2", 1), ("2.00 kg", 3)):
        path.write_text(shaft.replace("UNIT", unit))
        assert run(["check", str(path)]) == code
    assert "expected a moment of inertia" in capsys.readouterr().err


@pytest.mark.sweep
def test_of_beams_no_slope_is_ever_one(tmp_path, capsys):
    """So a modal mass is a mass, and a moment by the displacement a force; of damped modes a slope may be the first."""
    path = tmp_path / "scene.yaml"
    text = ("beams: {b: {length: 2 m, EI: 300 N*m^2, mass_per_length: 2 kg/m, left: pinned, right: {c: 3 N*s/m, "
            "k: 90 N/m}}}\nanswers: {'ASKED': {value: VALUE, rtol: 1 %}}\n")
    for asked, given, code in (("modal_mass[2]", "0.955 kg", 0), ("modal_mass[2]", "0.955", 3),
                               ("mode[2][b.moment(1 m)]", "1 m", 3), ("abs(mode_d[2,b.slope(0 m)])", "1 m/m", 0)):
        path.write_text(text.replace("ASKED", asked).replace("VALUE", given))
        assert run(["check", str(path)]) == code, (asked, given, capsys.readouterr())
    assert "expected a force" in capsys.readouterr().err


@pytest.mark.parametrize(("quantity", "words"), [
    ("modal_mass[3]", "this scene has 2 modes"), ("modal_mass", "needs an index"), ("modal_mass[x]", "no mode 'x'"),
    ("modal_mass[1](2 s)", "no function of time"), ("modal_mas[1]", "unknown quantity")])
def test_what_cannot_be_asked_is_refused(quantity, words, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(TWO + f"answers: {{'{quantity}': 2 kg}}\n")
    assert run(["check", str(path)]) in (3, 4)
    assert words in "".join(capsys.readouterr())


def test_modes_in_which_coordinates_do_not_move_in_phase_have_none():
    gyroscopic = problem("parameters: {m: 2 kg, k: 50 N/m, Omega: 1 rad/s}\n"
                         "bodies: {a: {mass: m, at: [0, 0], move: [x, y, 0]}}\n"
                         "energies: {T: m*Omega*(x*y' - y*x'), V: k/2*(x^2 + 2*y^2)}")
    with pytest.raises(PhysicsError, match="do not move in phase"):
        value(gyroscopic, "modal_mass[1]")


def test_in_letters_it_is_found_of_one_degree_alone():
    one = "parameters: {m: , k: }\nbodies: {a: {mass: 2*m, slide: x}}\nsprings: {s: {k: k, between: [ground, a]}}\n"
    assert str(vibcli.loads(one)["modal_mass[1]"].expression) == "2*m"
    two = one.replace("x}}", "x}, b: {mass: m, slide: y}}").replace("a]}", "a]}, t: {k: k, between: [a, b]}")
    with pytest.raises((PhysicsError, SpecError), match="in letters for one degree"):
        vibcli.loads(two)["modal_mass[1]"]


def test_a_parameter_can_be_chosen_by_it():
    scene = vibcli.loads(
        "parameters: {m: 2 kg, k: 800 N/m}\nbodies: {a: {mass: m, slide: x}, b: {mass: 3 kg, slide: y}}\n"
        "springs: {s: {k: k, between: [ground, a]}, t: {k: c, between: [a, b]}}\n"
        "choose: {c: 'modal_mass[2] = 3 kg'}\n")
    assert float(scene["modal_mass[2]"]) == pytest.approx(3, rel=1e-9)
