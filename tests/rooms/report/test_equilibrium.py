"""What a report tells of rest: members that bend between their stations, which are no coordinates, and conditions with
quantities as they are set in print."""

import pytest
from support.scenes import problem

from vibcli.api.reports import report, solution
from vibcli.base.errors import NotInLetters
from vibcli.report.formats import text
from vibcli.report.sections.design_parameters import condition_told

STRING = """
parameters: {L: 1 m, T: 100 N, mu: 0.01 kg/m, q: 20 N/m}
strings: {s: {length: L, preload: T, mass_per_length: mu, left: clamped, right: clamped}}
"""
HUNG = """
parameters: {L: 1 m, T: 100 N, mu: 0.01 kg/m, g: 9.81 m/s^2}
gravity: g
strings: {s: {from: [0, 0], to: TO, preload: T, mass_per_length: mu, left: clamped, right: clamped}}
"""


@pytest.mark.parametrize(("scene", "deflects"), [
    (STRING.replace(", q: 20 N/m", ""), False), (STRING + "forces: {f: {body: s, per_length: -q}}\n", True),
    (STRING + "forces: {f: {body: s, per_length: q*sin(2*pi*x/L)}}\n", True),
    (STRING + "forces: {f: {body: s, per_length: q*sin(2*pi*x/L)*cos(3 rad/s*t)}}\n", False),
    (HUNG.replace("TO", "[L, 0]"), True), (HUNG.replace("TO", "[0, -L]"), False)])
def test_members_that_deflect_at_rest_are_said_to(scene, deflects):
    """By its weight, an even and an uneven load; not by one without a steady part, nor as it hangs along its weight."""
    found = problem(scene)
    told = text.render([report(found, solution(found)).document()], None)
    assert "the drawn position" in told
    assert ("; s deflects from it under what acts along)" in told) is deflects


@pytest.mark.parametrize(("typed", "printed"), [
    ("c = 0.2 N*s/m", "c = 0.2 N·s/m"), ("re(eigenvalue[1]) = -5 s^-1", "re(eigenvalue[1]) = −5 s⁻¹"),
    ("theta = 25 deg", "θ = 25°"), ("amplitude(y) = 1 mm", "amplitude(y) = 1 mm"), ("x1'(t) = 0", "ẋ₁(t) = 0"),
    ("omega[2] = 3*omega[1]", "ω₂ = 3·ω₁"), ("zeta[1] = 0.6", "ζ₁ = 0.6"),
    ("abs(frf[y, drive](Omega)) = 1/(m*Omega^2)", "|frf[y, drive](Ω)| = 1/(m·Ω²)")])
def test_conditions_have_quantities_as_printed(typed, printed):
    assert condition_told(typed, {"theta", "x1", "Omega"}) == printed


@pytest.mark.sweep
@pytest.mark.parametrize(("load", "at"), [("P", "x = (P²/c²)^(1/3)"), ("-P", "x = −(P²/c²)^(1/3)")])
def test_a_spring_whose_force_is_a_power_of_its_stretch_has_its_rest_in_letters(load, at):
    """To either side: c |x|^(3/2) sign x = P."""
    found = problem(f"""
        parameters: {{c: {{unit: N/m^(3/2)}}, P: {{unit: N}}}}
        bodies: {{b: {{mass: 1 kg, slide: x}}}}
        springs: {{s: {{law: c*sign(d)*abs(d)^(3/2), between: [ground, b]}}}}
        forces: {{f: {{at: b, force: {load}}}}}
        find: [equilibrium]
    """)
    assert at in text.render([report(found, solution(found)).document()], None)


@pytest.mark.sweep
@pytest.mark.parametrize("load", ["P - R", "Q"])
def test_a_load_of_either_sign_leaves_the_side_of_rest_open(load):
    """What holds for one sign of the load is false for the other."""
    found = problem(f"""
        parameters: {{c: {{unit: N/m^2}}, k: {{unit: N/m}}, P: {{unit: N, unused: allowed}},
                      Q: {{unit: N, sign: any, unused: allowed}}, R: {{unit: N, unused: allowed}}}}
        bodies: {{b: {{mass: 1 kg, slide: x}}}}
        springs: {{s: {{law: c*d*abs(d) + k*d, between: [ground, b]}}}}
        forces: {{f: {{at: b, force: {load}}}}}
    """)
    with pytest.raises(NotInLetters, match="not found in letters"):
        found.symbolic.equilibrium_position  # noqa: B018


def test_what_is_driven_alone_tells_what_answers_ask_at_instants():
    """Beside what has no value."""
    found = problem("""
        parameters: {r: 60 mm, m: 2 kg, Omega: 30 rad/s, t1: 0.05 s}
        bodies: {b: {mass: m, at: [0, 0], slide: r*cos(Omega*t)}}
        answers: {"b.x(t1)": 0.004244 m, "T(t1)": 3.2238 J, "max(steady(b.x))": 0.06 m}
    """)
    made = report(found, solution(found))
    told = text.render([made.document()], None)
    assert made.refusal is None and "b.x(t₁) = 0.00424423 m" in told and "T(t₁) = 3.22379" in told


@pytest.mark.parametrize("asked", ["frequencies", "equilibrium"])
def test_what_is_driven_alone_has_nothing_of_what_is_asked_by_name(asked):
    found = problem(f"""
        parameters: {{r: 60 mm, m: 2 kg, Omega: 30 rad/s}}
        bodies: {{b: {{mass: m, at: [0, 0], slide: r*cos(Omega*t)}}}}
        find: [{asked}]
        answers: {{"b.x(0.05 s)": 0.004244 m}}
    """)
    assert "nothing moves freely" in report(found, solution(found)).refusal.message


@pytest.mark.parametrize("parameters", ["{k: 10 N/m, m: 1 kg, a: 1 m}", "{k: , m: , a: }"])
def test_where_nothing_takes_a_force_it_is_said(parameters):
    found = problem(f"""
        parameters: {parameters}
        bodies: {{A: {{mass: m, at: [a, 0], slide: {{along: [1, 0], by: x}}}}}}
        springs: {{s: {{k: k, between: [[0, 0], A]}}}}
        find: [equilibrium, reactions]
    """)
    told = text.render([report(found, solution(found)).document()], None)
    assert "none: neither a constraint nor a support takes any force" in told
