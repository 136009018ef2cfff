"""A scene with other values shares its derivation where it would be drawn alike, and is then the scene read anew."""

import math
import random
from functools import partial
from pathlib import Path

import pytest

import vibcli
from vibcli.api import given
from vibcli.api.model import Model
from vibcli.api.source import problem_of
from vibcli.language.parameters import unit_text

PROBLEMS = Path(__file__).parents[3] / "problems"
TRIES = 8
LEVER = """
parameters: {k: 100 N/m, a: 1 m, b: 0.3 m, m: 1 kg, c: 2 N*s/m, F: 3 N, W: 4 rad/s}
points: {e: {body: s, at: [a, 0]}}
bodies: {s: {mass: m, at: [0, 0], move: [x, 0, 0]}}
springs: {s1: {k: k, between: [[b, 0], e]}}
dampers: {d: {c: c, between: [[b, 0], e]}}
forces: {f: {at: s, force: [F*cos(W*t), 0]}}
"""
SAMPLED = ["3_free_undamped/wheel_on_incline_with_cord", "4_free_damped/bell_crank_dashpot",
           "6_two_degrees/quarter_car_damped", "6_two_degrees/sagging_spring_pendulum",
           "3_free_undamped/hoist_with_moving_pulley", "4_free_damped/crate_drawn_until_it_sticks",
           "5_forced/press_with_two_blows", "7_forced_two_degrees/washing_machine_on_a_bench",
           "1_statics_and_energy/snap_through_truss", "6_two_degrees/motor_on_inclined_mounts"]

EACH_KEY = {      # each section and key of the language that scenes share, twice where several files have it
    "1_statics_and_energy": "ladder_held_by_spring ladder_on_tie_rod plate_with_offset_hole "
        "scissor_lift_on_spring slider_crank_on_spring",
    "3_free_undamped": "ball_let_go_on_a_thread ellipse_plate_pendulum gear_pair_and_rack half_disc_in_track "
        "hoist_with_moving_pulley paddle_on_turning_hub plank_rocking_on_a_drum roller_on_a_hardening_spring",
    "4_free_damped": "bell_crank_dashpot cage_loses_half_its_load cam_and_follower_at_rest "
        "crate_let_go_on_a_rough_slope galloping_sign_arm plate_swings_in_water relay_armature_in_oil",
    "5_forced": "accelerometer_on_a_casing block_that_sticks_and_slips_under_a_force "
        "motor_raised_on_a_hinged_beam trailer_over_a_half_sine_bump",
    "6_two_degrees": "cylinder_in_a_turning_tube epicyclic_gear_with_sprung_ring "
        "half_cylinder_on_a_sprung_plank motor_on_inclined_mounts plank_on_a_rolling_cylinder "
        "wing_section_in_wind",
    "7_forced_two_degrees": "inerter_under_a_machine",
    "7_more_degrees": "fan_run_up_by_two_stages_of_gears geared_drive_line_driven "
        "three_storeys_on_shaking_ground",
    "9_equivalents_and_corrections": "ball_on_a_springboard block_in_one_of_two_wells block_with_play "
        "hardening_spring_beside_a_taut_wire slider_of_a_hardening_spring_on_oblique_ones two_wells "
        "weight_that_jerks_a_slack_rope"}


def anew(model, **values):
    """The Model of the scene with other values, read and drawn anew."""
    settings = {}
    for name, value in values.items():
        settings |= given.setting(name, str(value), given.parameters_of(model._source.node), "with_values")
    return Model(model._source, problem_of(model._source, settings))


def answer(model, quantity):
    try:
        found = model[quantity]
        return found.value, found.error
    except (vibcli.PhysicsError, vibcli.SpecError) as error:
        return str(error)


def outcomes(make, values):
    """Frequencies, damping ratios, equilibrium and first answer of a Model, to the last bit, or why there are none."""
    found = []
    try:
        model = make(**values)
        found += [answer(model, asked.asked.text) for asked in model._as_read.spec.answers[:1]]
    except vibcli.SpecError as error:
        return str(error)
    for what in ("omega", "zeta", "equilibrium"):
        try:
            part = getattr(model, what)
            found.append(repr(part if isinstance(part, dict) else list(part)))
        except (vibcli.PhysicsError, vibcli.SpecError) as error:
            found.append(str(error))
    return found


def shares(model, other):
    return model._problem.scene.table is other._problem.scene.table


@pytest.mark.parametrize("path", SAMPLED)
def test_answers_are_those_of_the_scene_read_anew(path):
    """To the last bit, the sentences of refusals too."""
    model, draw, shared = vibcli.load(PROBLEMS / f"{path}.yaml"), random.Random(path), 0
    spec = model._as_read.spec
    quantities = list(dict.fromkeys(answer.asked.text for answer in spec.answers))
    for name in spec.independent_parameters:
        literal = spec.parameters[name]["value"].parts.whole
        value = float(f"{float(literal.value) * math.exp(draw.uniform(-1, 1)):.4g}")
        one, other = model.with_values(**{name: value}), anew(model, **{name: value})
        try:
            shared += shares(model, one)
        except vibcli.SpecError as error:
            assert str(error) == answer(other, quantities[0])
            continue
        assert [answer(one, text) for text in quantities] == [answer(other, text) for text in quantities], (name, value)
    assert shared >= len(spec.independent_parameters) / 2


@pytest.mark.sweep
@pytest.mark.parametrize("path", [f"{chapter}/{name}" for chapter, names in EACH_KEY.items() for name in names.split()])
def test_scenes_of_every_key_answer_as_the_scene_read_anew(path):
    """At some of their parameters at a time, drawn at random, as numbers and as texts, of which two share."""
    model, draw, shared = vibcli.load(PROBLEMS / f"{path}.yaml"), random.Random(path), 0
    literals = {name: whole for name, record in model._as_read.spec.parameters.items()
                if "value" in record and (whole := record["value"].parts.whole) is not None}
    for _ in range(TRIES):
        values = {}
        for name in draw.sample(sorted(literals), min(len(literals), draw.randint(1, 3))):
            value = float(f"{float(literals[name].value) * math.exp(draw.uniform(-0.5, 0.5)):.{draw.randint(1, 6)}g}")
            unit = unit_text(model._as_read.spec.parameters[name])
            values[name] = draw.choice([value, f"{value} {unit}", f"{1000 * value}e-3"])
        if shared < 2 and shares(model, model.with_values(**values)):
            shared += 1
            assert outcomes(model.with_values, values) == outcomes(partial(anew, model), values), values
    assert shared == 2


@pytest.mark.parametrize(("values", "alike"), [
    ({"k": 220}, True), ({"k": "0.2 N/mm"}, True), ({"a": 0.4}, True), ({"a": 0.2}, False), ({"b": 1.5}, False),
    ({"a": 2, "b": 1.5}, True), ({"a": 2, "b": 2.5}, False), ({"m": 4, "W": 3, "F": 2}, True), ({"F": -2}, False),
    ({"F": 0}, False), ({"k": "(240 N/m)/2"}, False), ({"W": "40 rpm"}, False)])
def test_what_would_be_drawn_otherwise_is_drawn_anew(values, alike):
    """The spring leads to one side or the other; a minus, zero, formula or other kind of unit is read anew."""
    model = vibcli.loads(LEVER)
    one, other = model.with_values(**values), anew(model, **values)
    assert shares(model, one) == alike
    for quantity in ("omega[1]", "zeta[1]", "amplitude(x)", "amplitude(s1.force)", "amplitude(ground.force.x)"):
        assert answer(one, quantity) == answer(other, quantity)
    assert one._repr_latex_() == other._repr_latex_()


def test_what_is_drawn_at_a_parameter_follows_it():
    model = vibcli.load(PROBLEMS / "1_statics_and_energy/ladder_held_by_spring.yaml")
    for values, moved in (({"theta0": "52 deg"}, True), ({"k": "7 kN/m"}, False)):
        one, other = model.with_values(**values), anew(model, **values)
        was, found, wanted = (each._problem.numeric.drawn_floats for each in (model, one, other))
        assert shares(model, one) and found == wanted and (found != was) is moved


def test_what_is_driven_is_drawn_once():
    model = vibcli.loads(LEVER)
    one, other = model.with_values(k=200), model.with_values(k=300)
    scenes = [each._problem.configuration.with_inputs.scene for each in (model, one, other)]
    assert len({scene.table for scene in scenes}) == 1
    assert [scene.sample["k"] for scene in scenes] == [100, 200, 300]


def test_what_follows_from_expressions_is_derived_once():
    model = vibcli.loads(LEVER)
    systems = [each._problem.system for each in (model, model.with_values(k=200), model.with_values(k=300, m=2))]
    for part in ("statics", "statics_code", "potential", "hangs_on_time"):
        assert all(getattr(system, part) is getattr(systems[0], part) for system in systems)
    assert all(system.scene.rates_at_rest is systems[0].scene.rates_at_rest for system in systems)
    assert [system.scene.timed for system in systems] == [True] * 3


def test_values_follow_those_given_before():
    model = vibcli.loads(LEVER)
    one = model.with_values(k="0.4 N/mm").with_values(m=4)
    assert one.omega == pytest.approx([10.0]) and shares(model, one)
    assert one.with_values(k=1600).omega == pytest.approx([20.0])
    cased = vibcli.loads(LEVER + "cases: {heavy: {parameters: {m: 4 kg}}}\n")
    heavy = cased.case("heavy").with_values(k=400)
    assert heavy.omega == pytest.approx([10.0]) and shares(cased.case("heavy"), heavy)
    assert cased.with_values(k=400).case("heavy").omega == pytest.approx([10.0])
    assert cased.with_values(m=1).case("heavy").omega == anew(cased, m=1).case("heavy").omega


def test_scenes_in_letters_are_read_anew():
    model = vibcli.loads("parameters: {m: 2 kg, k: {unit: N/m}}\nbodies: {b: {mass: m, slide: x}}\n"
                         "springs: {s: {k: k, between: [ground, b]}}\n")
    other = model.with_values(m=8)
    assert not shares(model, other) and other._problem.scene.parameters.nodes


def test_of_scenes_without_units_small_whole_numbers_are_factors():
    """And are so at the other values, or the scene is read anew."""
    model = vibcli.loads("parameters: {m: 2, k: 50}\nbodies: {b: {mass: m, slide: x}}\n"
                         "springs: {s: {k: k, between: [ground, b]}}\n")
    for values, alike in (({"m": 8}, True), ({"m": 12}, False), ({"m": 2.5}, False), ({"k": 72}, True)):
        other = model.with_values(**values)
        assert shares(model, other) is alike and answer(other, "omega[1]") == answer(anew(model, **values), "omega[1]")


@pytest.mark.parametrize(("path", "values", "alike"), [
    ("8_continuous/column_near_buckling", {"P": "9 kN", "L": "2.7 m"}, True),
    ("8_continuous/string_with_a_bead", {"m": "3 g"}, True),
    ("8_continuous/portal_frame", {"EI": "5 MN*m^2"}, False),             # a search finds the tension of its members
    ("1_statics_and_energy/scissor_lift_on_spring", {"M": "33 kg", "k": "13 kN/m"}, True),
    ("1_statics_and_energy/scissor_lift_on_spring", {"L": "1.3 m"}, False)])     # one loop follows from the others
def test_members_and_closed_loops(path, values, alike):
    model = vibcli.load(PROBLEMS / f"{path}.yaml")
    one, other = model.with_values(**values), anew(model, **values)
    assert shares(model, one) is alike
    for text in ("omega[1]", "omega[2]", "equilibrium[y]"):
        assert answer(one, text) == answer(other, text)


def test_a_value_out_of_range_is_told():
    model = vibcli.loads(LEVER)
    for value in ("1e200 N/m", "1e-200 N/m"):
        with pytest.raises(vibcli.SpecError, match="out of range"):
            _ = model.with_values(k=value).omega
