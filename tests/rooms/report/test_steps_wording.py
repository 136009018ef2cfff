"""What lines say in words, each read aloud once: nothing twice, no false word, nothing left out."""

from pathlib import Path

import pytest
from support.scenes import kept_problem_of, kept_settled_of, problem

from vibcli.inverse import settled
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.sections.steps import SI, steps
from vibcli.report.steps.worked import worked


def told(scene):
    """The lines as they are printed, joined ones in one, with single spaces."""
    lines: dict = {}
    for line in worked(scene):
        lines.setdefault(line.number, []).append(formula(line.parts, plain).replace("\u00a0", " "))
    return [" ".join(",  ".join(parts).split()) for parts in lines.values()]


def of(name, case=None):
    found, = Path("problems").glob(f"*/{name}.yaml")
    return told(settled(kept_problem_of(found).case(case)) if case else kept_settled_of(found))


@pytest.mark.parametrize(("name", "case", "wanted"), [
    ("galloping_sign_arm", "storm", ["N_s = −L·g·(m/2 + m₀) = −88.29 N·m", "negative, so free motion grows"]),
    ("double_pendulum_equal", None, ["in mode 1 φ₂/φ₁ = √2", "in mode 2 φ₂/φ₁ = −√2"]),
    ("car_bounce_and_pitch", None, ["y: displacement of car upwards, zero as drawn", "φ/y = −0.377913 rad/m",
                                    "v_car = ẏ, ω_car = φ̇"]),
    ("xylophone_bar", None, ["ω₁ = ω₂ = 0 rad/s: it moves freely"]),
    ("plucked_string", None, ["root 2: βL = 2·π", "ω₁ = π·√(80/0.005)/0.8 = 496.729 rad/s"]),
    ("five_equal_duffing_springs", None, ["F_s(d) = k·d₁ + γ·d₁³, d = 5·d₁"]),
    ("linear_and_quadratic_damper_in_series", None, ["c_d = 0 N·s/m", "Φ_d = 0", "c_e = c/2 = 4 N·s/m"]),
    ("feeder_tray_driven_by_a_sawtooth", None, ["speed across d: u̇_d = L·cos β·φ̇ (first order)"]),
    ("block_with_play", None, ["from rest, to the first order: m·ẍ = 0"]),
    ("sledge_hauled_up_by_a_falling_weight", None, [
        "Φ_snow = m·μ·g·cos α·|ṡ|", "sledge.reaction.x = −m·g·cos α·sin α",
        "sledge.reaction.y = m·g·cos² α"]),
    ("drum_on_a_slope_with_a_cord", None, ["∂V/∂s = (4·k₁ + k₂)·s"]),
    ("gear_pair_and_rack", None, ["ω_two = −r₁·φ̇/r₂, T_two = J₂·ω_two²/2 = J₂·r₁²·φ̇²/(2·r₂²)"]),
    ("platform_on_rods_dies_down", None, [
        "left turns about the fixed O₁, C at (L·sin φ/2 − 0.5 m, L − L·cos φ/2): J_O₁ = J_C + m·O₁C² = m·L²/12 + "
        "m·L²/4 = m·L²/3 = 5.07 kg·m²"]),
    ("crate_drawn_until_it_sticks", None, ["by the balance along it rope.force = M·g − M·ẍ"]),
    ("two_parcels_on_belt", None, ["speed across film1: u̇_film1 = ẋ₁ − v₀"]),
    ("three_weights_two_pulleys", None, ["at rest ∂V/∂x₂ = N_s2 − N_s3 = 0", "in mode 1 x₂/x₁ = −1",
                                         "in mode 2, by that row, x₁ = 0"]),
    ("half_disc_pendulum_decrement", None, ["time_to[0.5](φ): ln(2)/δ"]),
    ("load_under_a_movable_pulley", None, [
        "S_rope_3 for rope.force.3, at rest s1.force = m₁·g, s2.force = g·(mp/2 + m₁/2 − m₂), balance along y: "
        "g·(mp + m₁) − S_rope_1 − S_rope_2 = 0", "balance along w: g·(mp + m₁)/2 − S_rope_3 = 0"]),
    ("press_with_two_blows", None, ["at rest ∂V/∂y = 2·N_left·b₁ + m·g = 0"]),
    ("pointer_lags_behind_a_ramp", None, ["(under-damped, δ′ < ω)"]),
    ("pointer_lags_behind_a_ramp", "largest damping", ["c·w/k = δ"]),
    ("car_enters_the_foot_of_a_hill", None, ["the form of the load gives z = a·t²/2 − a·(m₁ + m₂)/k₂"]),
    ("trailer_for_a_ratio", None, ["others: 1451.04 kg)"]),
    ("three_discs_on_fixed_shaft", None, ["u·K·u = 9516.14 N·m", "u·M·u = 2.15662 kg·m²"]),
    ("scale_pan_on_a_hardening_spring", None, ["x: displacement of pan, downwards, zero as drawn"]),
    ("spool_on_driven_plank", None, ["s: rolling of spool, to the right, zero as drawn"]),
    ("planet_between_sun_and_ring", None, [
        "rolling of planet φ = (r₁/2 + r₂)·γ/r₂ − r₁·α/(2·r₂) (by the constraints)"]),
    ("four_bar_with_springs", None, ["and by the closed loop ψ: turn of the coupler, χ: turn of the rocker"]),
    ("spring_of_a_power_law", None, ["V = 0 + … (second order: it has no such term)", "to the first order: m·ẍ = 0",
                                     "m·ẋ²/2 + 2·a·|x|^(5/2)/5 = E"]),
    ("bead_on_a_turning_hoop", None, ["θ: zero as drawn"]),
    ("cart_with_pendulum", None, ["φ = −(5.33333 rad/m)·p₂",
                                  "(−5.33333 rad/m)·2·m₂·L + (−5.33333 rad/m)²·m₂·L² = 24 kg"]),
    ("pointer_lags_behind_a_ramp", None, ["final(shaft.angle − φ): c·w/k", "final(hair.force): −c·w"]),
    ("half_power_of_a_braked_lever", None, ["tan θ = Ω·√(m·k)/(4·(k − m·Ω²))",
                                            "amplitude(low.x): 2·a·X"]),
    ("two_inclined_springs_as_a_pair", None, [
        "ω₁ = √((k₁ + k₂ − √(k₁² + 2·k₁·k₂ − 4·k₁·k₂·sin²(a − b) + k₂²))/(2·m))",
        "stiffness[bead].max: (k₁ + k₂ + √(k₁² + 2·k₁·k₂·cos(2·a − 2·b) + k₂²))/2"]),
    ("seismograph_with_level_boom", None, ["phase(φ): θ"]),
    ("press_with_two_blows", None, ["√(b² + 6·b·y₀/5 + y₀²)) = 1.31915 1/m"]),
    ("three_storeys_on_shaking_ground", None, ["C₁₁ = 56874 N·s/m", "C₁₄ = −36495.9 N·s/m"]),
    ("unround_shaft", None, ["V0_disc = −m·Ω²·u²/2 − m·Ω²·v²/2"]),
])
def test_lines_of_problems(name, case, wanted):
    lines = of(name, case)
    for text in wanted:
        assert any(line.endswith(text) or text + "," in line for line in lines), (text, lines)
    assert not any(" = 0 = 0" in line for line in lines)


@pytest.mark.parametrize(("name", "noted"), [("shelter_under_a_blast", False), ("garland_of_power_springs", False),
                                             ("jib_crane_with_winch", False),
                                             ("scale_pan_on_a_hardening_spring", True), ("gear_pair_and_rack", False),
                                             ("quarter_car_damped", False), ("lever_on_shaking_floor", False),
                                             ("disc_on_sprung_platform", False), ("platform_on_rods_dies_down", False)])
def test_it_is_noted_where_numbers_without_their_units_stand_beside_letters(name, noted):
    found, = Path("problems").glob(f"*/{name}.yaml")
    (section,) = steps(kept_problem_of(found), None)
    assert (SI in str(section.blocks[-1])) is noted


@pytest.mark.sweep
def test_a_condition_that_gives_a_coordinate_is_told_once():
    lines = of("platform_on_three_rods")
    assert sum("by the constraints" in line for line in lines) == 2
    assert [line.split()[0] for line in lines if "holds:" in line] == ["'second'", "'third'"]


@pytest.mark.sweep
def test_a_body_that_does_not_turn_to_the_first_order_has_no_energy_of_turning():
    assert "T_platform = M·v_platform²/2 = M·(X² + H²)·φ̇²/2" in of("platform_on_three_rods")


def test_how_it_is_damped_is_said_in_words():
    scene = ("parameters: {m: 2 kg, k: 800 N/m, c: %s N*s/m}\nbodies: {b: {mass: m, slide: x}}\n"
             "springs: {s: {k: k, between: [ground, b]}}\ndampers: {d: {c: c, between: [ground, b]}}\n")
    for c, words in ((8, "under-damped"), (80, "critically damped"), (100, "over-damped")):
        assert next(line for line in told(problem(scene % c)) if line.startswith("ζ")).endswith(words)


@pytest.mark.sweep
def test_a_quotient_of_forces_is_no_angle():
    assert any(line.endswith("max(|cylinder.friction|/cylinder.normal) = 0.397251") for line in of(
        "cylinder_rolls_in_a_gutter"))


def test_why_a_coordinate_follows_is_told_where_all_constraints_are_of_one_form():
    assert any(line.endswith("(as ropes keep their length)") for line in of("drum_on_a_slope_with_a_cord"))


@pytest.mark.parametrize(("last", "wanted"), [
    ("k", ["it factors: (ω² − 2·k/m)·(m³·ω⁴ − 4·m²·k·ω² + 2·m·k²) = 0"]), ("2*k", [])])
def test_a_determinant_that_factors_is_told_as_a_product(last, wanted):
    lines = told(problem(f"""
        parameters: {{m: , k: }}
        bodies: {{a: {{mass: m, slide: x1}}, b: {{mass: m, slide: x2}}, c: {{mass: m, slide: x3}}}}
        springs: {{s1: {{k: k, between: [ground, a]}}, s2: {{k: k, between: [a, b]}}, s3: {{k: k, between: [b, c]}},
                   s4: {{k: {last}, between: [c, ground]}}}}
    """))
    assert [line for line in lines if "it factors" in line] == wanted


def test_numbers_are_put_into_the_formula_of_two_roots():
    """√(9.99e7² − 4·810000·2.475e9) = 4.42833e7 by hand."""
    assert any(line.endswith("= (9.99e7 ∓ 4.42833e7)/1.62e6") for line in of("car_bounce_and_pitch"))


@pytest.mark.sweep
def test_a_number_is_told_once():
    """N = 4 N, not 4 = 4 N; an acceleration 0 m/s² without another zero before it."""
    loaded = "bodies: {a: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 800 N/m, between: [ground, a]}}\n"
    assert any("N_s = 4 N," in line for line in told(problem(loaded + "forces: {f: {at: a, force: 4 N}}\n")))
    free = "bodies: {a: {mass: 2 kg, slide: x}}\nforces: {f: {at: a, force: 4 N}}\nmotion: full\n"
    assert not any(" = 2 = 2 m/s²" in line for line in told(problem(free)))
