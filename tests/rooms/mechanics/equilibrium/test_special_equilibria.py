"""Zero frequencies that are no rigid motion, shapes of decoupled and repeated modes, preloads of written stretches."""

from fractions import Fraction
from pathlib import Path

import pytest
from support.scenes import problem, problem_of

from vibcli.symbolic.evaluation import Floats, evaluate

PROBLEMS = Path(__file__).parents[4] / "problems"
QUARTIC = "parameters: {{m: 1 kg, a: 3 N/m^3}}\ncoordinates: [x]\nenergies: {{T: m*x'^2/2, V: {}}}"


@pytest.mark.parametrize("V, kind, stable", [("a*x^4/4", "held", True), ("-a*x^4/4", "falling", False),
                                             ("a*x^3*(1 m)/3", "falling", False)])
def test_terms_beyond_the_linear_ones_decide(V, kind, stable):
    found = problem(QUARTIC.format(V))
    assert found.modal.zero_modes == {1: kind}
    assert found.modal.stability.stable is stable


def test_a_rigid_motion_costs_no_energy():
    found = problem("parameters: {m: 1 kg, k: 2 N/m}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
                    "springs: {s: {k: k, between: [a, b]}}")
    assert found.modal.zero_modes == {1: "free"}
    assert found.modal.stability.stable


def test_lateral_springs_hold_without_a_linear_force():
    found = problem("parameters: {m: 1 kg, k: 3 N/m, L: 1 m}\n"
                    "bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}\n"
                    "springs: {l: {k: k, between: [b, [-L, 0]]}, r: {k: k, between: [b, [L, 0]]}}")
    assert found.modal.zero_modes == {1: "held"}


def test_preload_of_a_written_stretch_is_the_tension_as_drawn():
    found = problem("parameters: {m: 1 kg, k: 100 N/m, N: 10 N}\ncoordinates: {x: {drawn: 0.3 m}}\n"
                    "bodies: {b: {mass: m, slide: x}}\nsprings: {a: {k: k, stretch: x, preload: N}}")
    assert found.configuration.equilibrium.values["x"] == pytest.approx(0.2, abs=1e-15)


TWO = """
parameters: {{m: , k: , K: {{unit: N/m, unused: allowed}}}}
bodies: {{p: {{mass: m, slide: x}}, q: {{mass: m, slide: y}}}}
springs: {{a: {{k: k, between: [ground, p]}}, b: {{k: {}, between: [ground, q]}}}}
"""


@pytest.mark.parametrize("second", ["k", "k + K"])
def test_uncoupled_coordinates_move_alone(second):
    found = problem(TWO.format(second)).closed_forms
    assert [[part.coefficient for part in mode.shape] for mode in found.modes] == [[1, 0], [0, 1]]
    assert all(mode.pattern is None for mode in found.modes)


def test_letters_are_drawn_where_the_scene_is_stable():
    found = problem("parameters: {m: , k: , L: , g: }\ngravity: g\n"
                    "bodies: {b: {mass: m, at: [0, L], pin: {at: [0, 0], by: th}}}\n"
                    "springs: {s: {torsion: k, between: [ground, b]}}")
    assert found.scene.sample["k"] > found.scene.sample["m"] * found.scene.sample["g"] * found.scene.sample["L"]


def test_a_skew_C_turns_the_full_equations():
    from vibcli.notation.scene_language import language

    found = problem("parameters: {m: 2 kg, h: 3 N*s/m}\ncoordinates: [x, y]\n"
                    "matrices: {M: [[m, 0], [0, m]], C: [[0, h], [-h, 0]]}")
    assert language(found.symbolic.equations.full[0]) == "m*x'' + h*y'"


def test_a_derived_parameter_follows_its_definition():
    found = problem("parameters: {m: , R: , r: , d: R - r, g: }\ngravity: g\n"
                    "surfaces: {track: {circle: [0, 0], radius: R, side: inside}}\n"
                    "bodies: {b: {shape: disc, mass: m, radius: r, at: [0, -d], roll: {surface: track, turn: phi}}}")
    sample = found.scene.sample
    assert sample["d"] == pytest.approx(sample["R"] - sample["r"])


IN_LETTERS = ("6_more_degrees/three_car_train", "6_two_degrees/coupled_pendulums_beats",
              "6_two_degrees/disc_rolling_on_cart",
              "6_two_degrees/double_pendulum_equal", "6_two_degrees/disc_rolling_on_tied_cart")


@pytest.mark.parametrize("stem", IN_LETTERS)
def test_shapes_in_letters_are_those_in_numbers(stem):
    """At the sample values every closed form equals the numeric mode."""
    found = problem_of(PROBLEMS / f"{stem}.yaml")
    sample = {name: Fraction(found.scene.sample[name]) for name in found.scene.parameters.free}
    numeric = found.with_values(sample)
    forms = found.closed_forms.modes
    assert len(forms) == len(numeric.modal.modes)
    for form, mode in zip(forms, numeric.modal.modes, strict=True):
        omega, *shape = evaluate([form.omega, *form.shape], Floats, found.scene.sample)
        assert omega == pytest.approx(mode.omega, rel=1e-9, abs=1e-6)
        assert shape == pytest.approx(numeric.modal.shape(mode), rel=1e-7, abs=1e-7)
