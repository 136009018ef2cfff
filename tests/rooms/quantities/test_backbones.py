"""Frequencies of free motions by their amplitude, against elliptic integrals and what ends a family."""

import json

import mpmath
import pytest
from support.motions import DUFFING, PENDULUM, problem

from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.cli.program import run
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

TWO_WELLS = """
parameters: {m: 1 kg, k: 4 N/m, b: 100 N/m^3}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: b*d^3 - k*d, between: [ground, block]}}
"""


def asked(text, what):
    return measure(problem(text), given_expression(what, "it").tree)


@pytest.mark.parametrize(("amplitude", "b"), [("0.001", "500"), ("0.1", "500"), ("3", "500"), ("0.1", "-100"),
                                              ("0.8", "-100")])
def test_duffing(amplitude, b):
    """ω = π √(k + b A²)/(2 √m K(μ)), μ = b A²/(2 (k + b A²)) [the parameter m = k² of K]."""
    found, error = asked(DUFFING.replace("500", b), f"backbone[1](x)({amplitude} m)")
    with mpmath.workdps(30):
        cubic = mpmath.mpf(b) * mpmath.mpf(amplitude) ** 2
        exact = mpmath.pi * mpmath.sqrt((80 + cubic) / 2) / (2 * mpmath.ellipk(cubic / (2 * (80 + cubic))))
        assert abs(found / exact - 1) <= error <= 2e-14


@pytest.mark.parametrize(("angle", "ratio"), [("90 deg", 1.180340599016096), ("170 deg", 2.439362719673884)])
def test_a_pendulum(angle, ratio):
    found, error = asked(PENDULUM, f"backbone[1](phi)({angle})")
    assert (9.81 / 0.8) ** 0.5 / found == pytest.approx(ratio, rel=2e-15)
    assert error <= 2e-14


def test_the_amplitude_is_half_the_range_of_a_signal():
    """The bob of a pendulum that swings to 90° rises by L once on each side, and goes to and fro by L."""
    by_angle = asked(PENDULUM, "backbone[1](phi)(90 deg)")[0]
    assert asked(PENDULUM, "backbone[1](bob.y)(0.4 m)")[0] == pytest.approx(by_angle, rel=1e-12)
    assert asked(PENDULUM, "backbone[1](bob.x)(0.4 m)")[0] == pytest.approx(
        asked(PENDULUM, "backbone[1](phi)(30 deg)")[0], rel=1e-13)
    assert asked(DUFFING, "backbone[1](s.force)(8.5 N)")[0] == pytest.approx(
        asked(DUFFING, "backbone[1](x)(10 cm)")[0], rel=1e-13)


@pytest.mark.sweep
def test_about_one_of_two_wells():
    """V = ¼ b (x² − k/b)²: 2 (E − V)/m = b/(2 m) (q₂² − x²)(x² − q₁²), T = 2 √(2 m/b) K(1 − q₁²/q₂²)/q₂."""
    with mpmath.workdps(30):
        for half in ("0.01", "0.1"):
            a = mpmath.mpf(half)
            mean = mpmath.sqrt(mpmath.mpf("0.04") - a**2)        # q₁² + q₂² = 2 k/b
            low, high = mean - a, mean + a
            period = 2 * mpmath.sqrt(mpmath.mpf(2) / 100) / high * mpmath.ellipk(1 - low**2 / high**2)
            found, error = asked(TWO_WELLS + "equilibrium: {x: 0.2 m}\n", f"backbone[1](x)({half} m)")
            assert abs(found * period / (2 * mpmath.pi) - 1) <= error <= 1e-13


def test_dampers_are_left_out():
    damped = DUFFING + "dampers: {d: {c: 3 N*s/m, between: [ground, block]}}\n"
    assert asked(damped, "backbone[1](x)(10 cm)") == asked(DUFFING, "backbone[1](x)(10 cm)")


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "what", "message"), [
    (TWO_WELLS + "equilibrium: {x: 0.2 m}\n", "backbone[1](x)(15 cm)", "end at 0.141421 m"),
    (TWO_WELLS, "backbone[1](x)(15 cm)", "not stable"),
    (PENDULUM, "backbone[1](phi)(3.2 rad)", "end at 3.14159"),
    (DUFFING, "backbone[2](x)(15 cm)", "one family"),
    (DUFFING, "backbone[1](x')(1 m/s)", "a displacement or a spring"),
    (DUFFING, "backbone[1](x)(0 m)", "positive"),
    ("bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}\nsprings: {s: {k: 5 N/m, between: [ground, a]}, "
     "t: {law: (7 N/m^3)*d^3, between: [a, b]}}\n", "backbone[1](x)(1 m)", "without stiffness"),
])
def test_what_has_no_such_motion_is_refused(text, what, message):
    with pytest.raises(PhysicsError, match=message):
        asked(text, what)


@pytest.mark.parametrize(("what", "message"), [
    ("backbone[1](x)(15 s)", "expected an amplitude of the signal before it"),
    ("backbone[1](x)", "a signal and a number"),
    ("backbone[1](z)(1 m)", "no coordinate or signal 'z'"),
    ("backbone(x)(1 m)", "is no signal"),
])
def test_what_is_asked_wrongly_is_told(what, message):
    with pytest.raises(SpecError, match=message):
        problem(DUFFING + f"answers: {{{what}: 1 rad/s}}\n")


@pytest.mark.sweep
def test_a_curve_is_printed_drawn_and_in_the_json(tmp_path, capsys):
    file = tmp_path / "duffing.yaml"
    file.write_text("title: A block\n" + DUFFING + "find: [{backbone: {up_to: 20 cm}}]\n")
    assert run(["frequencies", str(file), "--backbone", "--plot", "--save", str(tmp_path / "curve.svg")]) == 0
    told = capsys.readouterr().out
    assert "amplitude of x [m]" in told and "0.2 " in told and (tmp_path / "curve.svg").stat().st_size > 1000
    assert run(["solve", str(file), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["backbone"]
    assert found["signal"] == "x" and found["unit"] == "m" and len(found["points"]) == 10
    last = found["points"][-1]
    exact = asked(DUFFING, "backbone[1](x)(20 cm)")[0]
    assert last["omega"] == pytest.approx(exact, rel=1e-15)
    assert last["energy"] == pytest.approx(40 * 0.2**2 + 125 * 0.2**4, rel=1e-15)


@pytest.mark.parametrize(("asked_for", "message"), [
    ("{of: [x], up_to: 3 s}", "expected an amplitude of the signal before it, a length"),
    ("{of: [z], up_to: 3 cm}", "no coordinate or signal 'z'"),
    ("{of: [x]}", "up_to"),
    ("{of: [x/0], up_to: 3 cm}", "divides by zero"),
    ("{of: [x], up_to: 3 cm/0}", "divides by zero"),
])
def test_a_curve_that_is_asked_wrongly_is_told(asked_for, message):
    with pytest.raises(SpecError, match=message):
        problem(DUFFING + f"find: [{{backbone: {asked_for}}}]\n")


@pytest.mark.parametrize(("signal", "message"), [("0*phi", "does not change"), ("phi+pi-phi", "does not change"),
                                                 ("sin(phi)^2+cos(phi)^2", "no free motion")])
def test_what_does_not_change_has_no_amplitude(signal, message):
    with pytest.raises(PhysicsError, match=message):
        problem(PENDULUM).free_motions.curve(1, parse(signal), [0.3])


CUBE_ROOT = """
parameters: {m: 2 kg, a: 3 N/m^(1/3)}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: a*sign(d)*abs(d)^(1/3), between: [ground, block]}}
"""


def test_a_power_law_without_slope_at_rest(tmp_path, capsys):
    """ω = √π Γ(½ + 1/p)/Γ(1/p) · p √(c A^(p − 2)/(2m)) of V = c |x|^p; here p = 4/3, c = 3a/4."""
    found, error = asked(CUBE_ROOT, "backbone[1](x)(10 cm)")
    with mpmath.workdps(30):
        p, c, A = mpmath.mpf(4) / 3, mpmath.mpf(9) / 4, mpmath.mpf("0.1")
        exact = mpmath.sqrt(mpmath.pi) * mpmath.gamma(0.5 + 1 / p) / mpmath.gamma(1 / p) * p * mpmath.sqrt(
            c * A ** (p - 2) / (2 * 2))
        assert abs(found / exact - 1) <= error <= 2e-14
    file = tmp_path / "root.yaml"
    file.write_text(CUBE_ROOT.replace("2 kg", "{unit: kg}").replace("3 N/m^(1/3)", "{unit: N/m^(1/3)}")
                    + "find: [{backbone: {up_to: 10 cm}}]\n")
    assert run(["frequencies", str(file), "--backbone"]) == 0
    told = capsys.readouterr().out
    assert "(1/A)^(1/3)·√(3·a/(2·m))" in told and "p = 4/3" in told


def test_a_kink_that_drives_away_has_no_family():
    with pytest.raises(PhysicsError, match="slope of a force is infinite"):
        asked(CUBE_ROOT.replace("law: a*", "law: -a*"), "backbone[1](x)(10 cm)")
