"""How the frequency begins to hang on the amplitude, and closed forms at any, against quadrature by mpmath."""

import math

import mpmath
import pytest
from mpmath import mp

from vibcli import loads
from vibcli.analyses.nonlinear.closed_forms import ByGamma, closed_form
from vibcli.analyses.nonlinear.small_amplitudes import kappa_in_letters
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.symbolic.evaluation import Floats, evaluate


def omega_of(V, m, right):
    """2π over the period of ½ m q̇² + V = V(right) about 0, by mpmath."""
    with mp.workdps(3 * mp.dps):
        left = mpmath.findroot(lambda q: V(q) - V(right), (-right, -1.001 * right))
    middle, half = (left + right) / 2, (right - left) / 2

    def pace(angle):
        with mp.workdps(3 * mp.dps):
            q = middle + half * mp.sin(angle)
            return half * mp.cos(angle) * mp.sqrt(m(q) / abs(2 * (V(right) - V(q))))

    return mp.pi / mpmath.quad(pace, [-mp.pi / 2, 0, mp.pi / 2]), half


def kappa_of(V, m, k):
    """By Richardson's extrapolation from two small amplitudes."""
    with mp.workdps(40):
        small = mp.sqrt(k / m(mp.mpf(0)))
        found = []
        for right in (mp.mpf("2e-5"), mp.mpf("4e-5")):
            omega, A = omega_of(V, m, right)
            found.append((omega / small - 1) / A**2)
        return float((4 * found[0] - found[1]) / 3)


@pytest.mark.sweep
def test_kappa_with_uneven_inertia_and_all_terms_of_the_energies():
    model = loads("""
parameters: {m: 2 kg, k: 300 N/m, b: 500 N/m^2, c: 900 N/m^3, a: 2 kg/m, e: 5 kg/m^2}
energies: {T: (m + a*x + e*x^2)*x'^2/2, V: k*x^2/2 + b*x^3 + c*x^4}
coordinates: [x]
""")
    found = model["backbone[1, x^2]"]
    expected = kappa_of(lambda x: 150 * x**2 + 500 * x**3 + 900 * x**4, lambda x: 2 + 2 * x + 5 * x**2, 300)
    assert found.value == pytest.approx(expected, rel=1e-9)
    assert found.error < 1e-13 * abs(found.value)


@pytest.mark.sweep
def test_kappa_of_a_mass_that_hangs_on_a_duffing_spring():
    model = loads("""
parameters: {m: 2 kg, k: 300 N/m, c: 9 kN/m^3, g: 9.81 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, -1 m], move: [0, y]}}
springs: {s: {law: k*d + c*d^3, between: [[0, 0], b]}}
""")
    with mp.workdps(40):
        sag = mpmath.findroot(lambda d: 300 * d + 9000 * d**3 - 2 * mp.mpf("9.81"), mp.mpf("0.06"))
        expected = kappa_of(lambda y: 150 * (sag - y)**2 + 2250 * (sag - y)**4 + 2 * mp.mpf("9.81") * y
                            - 150 * sag**2 - 2250 * sag**4, lambda y: mp.mpf(2), 300 + 27000 * sag**2)
    assert model["backbone[1, y^2]"].value == pytest.approx(expected, rel=1e-9)


BODY = "bodies: {b: {mass: m, at: [0, 0], move: [x, 0]}}\nsprings: {s: {law: LAW, between: [[-1 m, 0], b]}}\n"
LETTERS = {
    "pendulum": ("parameters: {m: , l: , g: }\ngravity: g\n"
                 "bodies: {bob: {mass: m, at: [0, -l], pin: {at: [0, 0], by: x}}}\n", "-1/16"),
    "duffing": ("parameters: {m: , k: , c: }\n" + BODY.replace("LAW", "k*d + c*d^3"), "3*c/(8*k)"),
    "bead on a parabola": ("parameters: {m: , a: , g: }\nenergies: {T: m*(1 + 4*a^2*x^2)*x'^2/2, V: m*g*a*x^2}\n"
                           "coordinates: [x]\n", "-a^2")}


@pytest.mark.parametrize("name", LETTERS)
def test_kappa_in_letters(name):
    text, expected = LETTERS[name]
    assert str(loads(text)["backbone[1, x^2]"].expression) == expected


NUMBERS = {"m": 2.0, "k": 300.0, "c": 90.0, "g": 9.81, "l": 0.7}
CLOSED = {
    "pendulum": (LETTERS["pendulum"][0], {"m": "2 kg", "l": "0.7 m", "g": "9.81 m/s^2"}, 2.1),
    "hardening": (LETTERS["duffing"][0], {"m": "2 kg", "k": "300 N/m", "c": "90 N/m^3"}, 1.7),
    "softening": (LETTERS["duffing"][0].replace("k*d + c*d^3", "k*d - c*d^3"),
                  {"m": "2 kg", "k": "300 N/m", "c": "90 N/m^3"}, 1.7),
    "cubic": ("parameters: {m: , c: }\n" + BODY.replace("LAW", "c*d^3"), {"m": "2 kg", "c": "90 N/m^3"}, 0.4),
    "contact": ("parameters: {m: , c: {unit: N/m^(3/2)}}\n" + BODY.replace("LAW", "c*sign(d)*abs(d)^(3/2)"),
                {"m": "2 kg", "c": "90 N/m^(3/2)"}, 0.4)}


ENERGIES = {"pendulum": lambda A: 2 * 9.81 * 0.7 * (1 - math.cos(A)), "hardening": lambda A: 150 * A**2 + 22.5 * A**4,
            "softening": lambda A: 150 * A**2 - 22.5 * A**4, "cubic": lambda A: 22.5 * A**4,
            "contact": lambda A: 36 * A**2.5}


@pytest.mark.parametrize("name", CLOSED)
def test_closed_forms_are_the_frequencies_by_quadrature(name):
    text, given, amplitude = CLOSED[name]
    model = loads(text)
    symbolic = model._problem.symbolic
    A = symbolic.scene.resting.table.parameter("A")
    found = closed_form(symbolic, A)
    rate, other, energy = evaluate(list(found), Floats, {"A": amplitude, **NUMBERS})
    if isinstance(found, ByGamma):
        omega = mp.sqrt(mp.pi) * mp.gamma(0.5 + 1 / other) / (2 * mp.gamma(1 + 1 / other)) * rate
    else:
        omega = mp.pi / (2 * mp.ellipk(other)) * rate
    assert energy == pytest.approx(ENERGIES[name](amplitude), rel=1e-13)
    exact = model.with_values(**given)[f"backbone[1](x)({amplitude}{'' if name == 'pendulum' else ' m'})"]
    assert float(omega) == pytest.approx(exact.value, rel=1e-13)


@pytest.mark.parametrize("text", [LETTERS["bead on a parabola"][0], "parameters: {m: , k: }\n" + BODY.replace(
    "LAW", '"k*d + k*max(d, -d/2)"'), "parameters: {m: , k: }\n" + BODY.replace("LAW", "k*d")])
def test_others_have_none(text):
    symbolic = loads(text)._problem.symbolic
    assert closed_form(symbolic, symbolic.scene.resting.table.parameter("A")) is None


@pytest.mark.parametrize(("law", "told"), [("c*d^3", "linear stiffness is not positive"),
                                           ('"c*d^3 + 3 N*max(d/(1 m), 0)"', "'s' has a kink of max")])
def test_what_has_no_small_amplitudes_is_refused(law, told):
    model = loads("parameters: {m: 2 kg, c: 90 N/m^3}\n" + BODY.replace("LAW", law))
    with pytest.raises(PhysicsError, match=told):
        model["backbone[1, x^2]"]


def test_a_hilltop_has_neither():
    symbolic = loads("parameters: {m: , k: , c: }\n" + BODY.replace("LAW", "-k*d + c*d^3"))._problem.symbolic
    assert closed_form(symbolic, symbolic.scene.resting.table.parameter("A")) is None
    with pytest.raises(PhysicsError, match="linear stiffness is not positive"):
        kappa_in_letters(symbolic)


def told(tmp_path, capsys, scene, code=0):
    """What `solve` prints of a scene in letters."""
    path = tmp_path / "scene.yaml"
    path.write_text(scene)
    assert run(["solve", str(path)]) == code
    return "".join(capsys.readouterr())


BACKBONE = "find: [{backbone: {of: [x], up_to: 1 m}}]\n"


def test_a_letter_of_the_scene_is_not_the_amplitude(tmp_path, capsys):
    report = told(tmp_path, capsys, "parameters: {m: , k: , A: }\n" + BACKBONE + BODY.replace("LAW", "k*d + A*d^3"))
    assert "ω = π/(2 K) · √((k + A·A_0²)/m)" in report and "A_0 is the amplitude of x" in report


def test_no_letter_of_the_scene_means_something_else_in_a_formula(tmp_path, capsys):
    report = told(tmp_path, capsys, "parameters: {s: , K: , E: , kappa: }\n" + BACKBONE + BODY.replace(
        "LAW", "K*d + E*kappa*d^3").replace("mass: m", "mass: s"))
    assert "ω = π/(2 K_0) · √((K + E·κ·A²)/s)" in report and "s_0 = " in report and "E_0 = " in report
    assert "κ_0 = 3·E·κ/(8·K)" in report and "ω₁(1 + κ_0A²)" in report


def test_another_family_than_the_first_is_refused_in_letters_too(tmp_path, capsys):
    report = told(tmp_path, capsys, "parameters: {m: , k: }\n" + BACKBONE.replace("1 m", "1 m, mode: 2")
                  + BODY.replace("LAW", "k*d"), 4)
    assert "one degree of freedom has one family of free motions, found the index 2" in report
