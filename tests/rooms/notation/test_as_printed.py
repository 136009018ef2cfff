"""Values as they are typed, set in print."""

import pytest

from vibcli.notation.as_printed import as_printed
from vibcli.notation.latex import latex
from vibcli.notation.mathml import mathml
from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.notation.typed_tree import typeset
from vibcli.notation.typst import typst
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import parse


@pytest.mark.parametrize(("typed", "printed"), [
    ("40 N*s/m", "40 N·s/m"), ("9.81 m/s^2", "9.81 m/s²"), ("-30 deg", "−30°"), ("2e-3 kg*m^2", "2e-3 kg·m²"),
    ("2*pi*f1", "2·π·f₁"), ("m1 * g / (2*k)", "m₁·g / (2·k)"), ("4 N/m^1.5", "4 N/m^1.5"),
    ("3 N/m^(3/2)", "3 N/m^(3/2)"),
    ("1.2 kN/m", "1.2 kN/m"), ("45  deg", "45°"), ("10 1/s", "10 1/s"), ("5 s^-1", "5 s⁻¹"), ("omega/2", "ω/2"),
    ("phi deg", "φ deg"), ("sqrt(2)*k", "√(2)·k"),
    ("omega[2] = 3*omega[1]", "ω₂ = 3·ω₁"), ("omega_d[12]", "ω_d₁₂"), ("phi'(2 s)", "φ̇(2 s)"),
    ("abs(frf[y, drive](omega)) = 1/(m1*omega^2)", "|frf[y, drive](ω)| = 1/(m₁·ω²)"),
    ("(k/m1)^2^(1/2)", "(k/m₁)^2^(1/2)"), ("2^3", "2³"),
    ("2*(abs(k - 1) + 1)", "2·(|k − 1| + 1)"), ("4 N/m^12.5", "4 N/m^12.5"), ("zeta[1] = zeta1", "zeta[1] = ζ₁")])
def test_signs_are_those_of_print(typed, printed):
    assert as_printed(typed, {"f1", "m1", "g", "k", "omega", "phi", "zeta1"}) == printed


def test_the_natural_logarithm_is_ln_in_every_notation():
    x = Table().parameter("x")
    node = x.table.call("log", 2 * x)
    for write in (plain, latex, typst, mathml):
        assert "ln" in write(node) and "log" not in write(node)
    assert as_printed("1200*log(x)/log(2)", {"x"}) == "1200·ln(x)/ln(2)"
    assert language(node) == "log(2*x)"         # which reads no other


def test_places_on_members_are_set_in_print():
    assert plain.symbol("blade.phi(2*L1/3)'") == "blade.φ̇(2·L₁/3)"
    assert plain.symbol("blade.slope(0 m)''") == "d²/dt²\u00a0blade.slope(0 m)"
    assert latex.symbol("blade.phi(L1)") == r"\text{blade.\ensuremath{\varphi}(L\ensuremath{{}_{1}})}"


@pytest.mark.parametrize(("typed", "set_in_latex"), [
    ("2*L/3", r"\frac{2 \, L}{3}"), ("sqrt(k/m1)", r"\sqrt{\frac{k}{m_{1}}}"), ("pi/6", r"\frac{\pi}{6}"),
    ("L - 0.50 mm", r"L - 0.50\text{ mm}"), ("(L + 2 N/m)^2", r"\left(L + 2\text{ N/m}\right)^{2}"),
    ("2*3 N/m*L", r"2 \cdot \left(3\text{ N/m}\right) \cdot L"), ("L - (1 - L)", r"L - \left(1 - L\right)"),
    ("2*(3*L)", r"2 \cdot 3 \, L"), ("2*(1/3)", r"2 \cdot \frac{1}{3}"), ("3*2^3", r"3 \cdot 2^{3}"),
    ("2*(L/3)", r"2 \, \frac{L}{3}")])
def test_what_is_given_as_a_formula_is_set_as_one(typed, set_in_latex):
    assert typeset(parse(typed), typed, latex).replace(" \\text", "\\text") == set_in_latex


def test_a_power_of_the_rate_of_a_word_has_brackets():
    rate = Table().parameter("bridge.oscillator(L/2)'")
    assert plain(rate ** 2) == "(d/dt\u00a0bridge.oscillator(L/2))²"
