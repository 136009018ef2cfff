"""The worked solution of members and of forces: roots and balances by plain arithmetic, and against the engine."""

import cmath
import math
import re
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, kept_settled_of, problem

from vibcli.base.errors import PhysicsError
from vibcli.notation.latex import latex
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.sections.members import carried, of_what_is_no_member
from vibcli.report.steps.ends import Ends
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

MEMBERS = sorted(Path("problems/8_continuous").glob("*.yaml"))


def told(lines):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in lines]


@pytest.mark.sweep
@pytest.mark.parametrize("path", MEMBERS, ids=lambda path: path.stem)
def test_every_member_has_its_lines(path):
    """Frequencies are those of the engine; each root gives its frequency by its own line."""
    scene = kept_settled_of(path)
    lines = worked(scene)
    if not scene.scene.pieces:
        return
    found = {line.settles: line.value for line in lines if re.fullmatch(r"omega\[\d+\]", line.settles)}
    letters = scene.numeric.has_free_symbols
    many = max([6, *(int(name[6:-1]) for name in found)])
    modes = [] if letters else [mode for mode in scene.modal.modes.first(many) if mode.omega is not None]
    known = {f"omega[{mode.index}]": mode for mode in modes}
    assert all(abs(float(known[name].omega) - value) <= 2 * known[name].error * value for name, value in found.items())
    assert found or letters
    assert all(use < line.number for line in lines for use in line.uses)


def test_a_cantilever_by_hand():
    """cos βL cosh βL = −1 (Rao 2007, table 11.1): 1.875104, 4.694091, 7.854757."""
    scene = problem("""
parameters: {L: 0.6 m, EI: 56 N*m^2, mu: 0.27 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
""")
    lines = worked(scene)
    roots = [line.value for line in lines if line.settles.startswith("βL[")]
    assert roots == pytest.approx([1.875104, 4.694091, 7.854757], abs=1e-6)
    omegas = [line.value for line in lines if line.settles.startswith("omega[")]
    assert omegas == pytest.approx([x**2 * math.sqrt(56 / 0.27) / 0.36 for x in roots], rel=1e-12)
    text = told(lines)
    assert "∂⁴X/∂x⁴ = β⁴·X,  β⁴ = μ·ω²/EI" in text[4]
    assert text[6].endswith("X = C₁·(cosh βx − cos βx) + C₂·(sinh βx − sin βx)")
    assert any(line == "so the frequency equation:  cos βL·cosh βL = −1" or
               line == "so the frequency equation:  cosh βL·cos βL = −1" for line in text)


def test_a_bar_with_a_mass_by_hand():
    """βL tan βL = μL/M: the condition at the right end, written down and solved here."""
    lines = worked(problem("""
parameters: {L: 2 m, EA: 1 MN, mu: 3 kg/m, M: 4 kg}
bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, attached: [{at: L, mass: M}]}}
"""))
    for line in lines:
        if line.settles.startswith("βL["):
            assert line.value * math.tan(line.value) == pytest.approx(6 / 4, rel=1e-9)
    assert any("the left end leaves  X = C₂·sin βx" in one for one in told(lines))


@pytest.mark.sweep
def test_damped_modes_by_hand():
    """EI β³ (1 + cos βL cosh βL)/(sin βL cosh βL − cos βL sinh βL) + c λ = 0, β⁴ = −μλ²/EI, of a cantilever whose end a
    dashpot holds; what it starts with is what held it, FL³/(3EI) with most of it in the first mode."""
    scene = kept_problem_of(Path("problems/8_continuous/springboard_on_a_dashpot.yaml"))
    L, EI, mu, c, F = 1.1, 260, 2.4, 9, 50
    lines = {line.settles: line for line in worked(scene)}
    for k in (1, 2, 3):
        root = complex(-lines[f"decay[{k}]"].value, lines[f"omega_d[{k}]"].value)
        x = L * cmath.sqrt(1j * root * math.sqrt(mu / EI))
        tip = EI * (x / L)**3 * (1 + cmath.cos(x) * cmath.cosh(x)) / (
            cmath.sin(x) * cmath.cosh(x) - cmath.cos(x) * cmath.sinh(x))
        assert abs(tip + c * root) < 1e-9 * abs(c * root)
    words = formula(lines["motion of board.u(L)"].parts, plain)
    cosines = [float(part.rpartition("(")[2]) for part in words.split("·cos(")[:-1]]
    assert 0.99 < sum(cosines) / (F * L**3 / (3 * EI)) < 1


def test_members_about_a_rest_that_a_search_finds():
    """The bob hangs as on a fixed pin, ω₁ = √(g/l); the beam bears it all: det(d + K − ω²M) = 0 by the lines' own
    numbers, d₂₂ d₁₁ − d₁₂² of a cantilever with 6 kg at its end."""
    lines = worked(kept_problem_of(Path("problems/8_continuous/motor_on_cantilever_with_pendulum.yaml")))
    found = [line.value for line in lines if line.settles.startswith("omega[")]
    assert found[0] == pytest.approx(math.sqrt(9.81 / 0.3), rel=1e-12)
    EI, mu, L, m = 2400, 3, 1.2, 6
    for omega in found[1:]:
        beta = (mu * omega**2 / EI)**0.25
        c, s, C, S = (f(beta * L) for f in (math.cos, math.sin, math.cosh, math.sinh))
        N = 1 - c * C
        d33, d34, d44 = EI * beta**3 * (c * S + s * C) / N, -EI * beta**2 * s * S / N, EI * beta * (s * C - c * S) / N
        assert (d33 - m * omega**2) * d44 == pytest.approx(d34**2, rel=1e-9)
    text = told(lines)
    assert any("H₁₁ = 6 kg,  H₃₃ = 0.09 kg·m²,  K₃₃ = 2.943 N·m" in one for one in text), text
    assert any(one.startswith("the forces balance at  y = −0.0173048 m") for one in text)


@pytest.mark.sweep
def test_entries_of_a_receptance_have_each_its_unit():
    """m/N and 1/N and rad/(N·m) of a place and a turn."""
    text = told(worked(problem("""
        parameters: {L: 1.2 m, EI: 50 N*m^2, mu: 2 kg/m, c: 20 N*s/m, F: 3 N, w: 40 rad/s}
        beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {c: c}}}
        points: {end: {body: arm, at: L}}
        forces: {f: {at: end, force: F*sin(w*t)}}
        damping: {modal: 2 %}
        answers: {amplitude(arm.u(L)): 1 m}
        """)))
    line, = [one for one in text if "H₁₁ = " in one]
    assert [part.rpartition("·i ")[2] for part in line.split(",  ")] == ["m/N", "1/N", "rad/(N·m)"]


def test_each_stretch_about_a_rest_that_a_search_finds_has_its_stiffness():
    text = told(worked(problem("""
        gravity: 9.81
        parameters: {EI: 300}
        beams: {b: {segments: [{length: 1, EI: EI}, {length: 1, EI: 3*EI}], mass_per_length: 2, left: clamped}}
        bodies: {bob: {mass: 1, at: [3, 0], slide: {along: [0, 1], by: q}}}
        springs: {s: {k: 500, between: [[3.3, -0.4], bob]}}
        """)))
    assert [one.rpartition(" = ")[2] for one in text if one.startswith("b, ")] == ["300 N·m²", "900 N·m²"]


@pytest.mark.sweep
def test_a_load_that_swings_beside_a_dashpot_and_ratios_by_hand():
    """H = Σ 1/(½μL (ω_k² − Ω² + 2iζω_kΩ)) at the free end, Σ 1/(½μL ω_k²) = L/EA, and U = HF/(1 + iΩcH)."""
    L, EA, mu, c, zeta, F, Omega = 0.8, 4000, 0.6, 25, 0.03, 60, 300
    rates = [(2 * k - 1) * math.pi / 2 * math.sqrt(EA / mu) / L for k in range(1, 401)]
    H = L / EA + sum(2 / (mu * L) * (1 / (w * w - Omega**2 + 2j * zeta * w * Omega) - 1 / w**2) for w in rates)
    lines = {line.settles: line for line in worked(kept_problem_of(
        Path("problems/8_continuous/lossy_rod_on_a_dashpot.yaml")))}
    found = next(line.value for name, line in lines.items() if name.startswith("steady "))
    assert found == pytest.approx(abs(H * F / (1 + 1j * Omega * c * H)), rel=1e-6)


def test_a_wrong_condition_is_seen(monkeypatch):
    """A moment left out at the right end."""
    right = Ends._moment
    monkeypatch.setattr(Ends, "_moment", lambda self, f, Z: 2 * self._shear(f, Z))
    with pytest.raises(PhysicsError, match="not told apart"):
        worked(problem("""
parameters: {L: 0.6 m, EI: 56 N*m^2, mu: 0.27 kg/m, M: 1 kg}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, attached: [{at: L, mass: M}]}}
"""))
    assert right is not Ends._moment


@pytest.mark.sweep
def test_forces_of_a_frame_are_those_of_the_answers():
    scene = kept_problem_of(Path("problems/1_statics_and_energy/jib_crane_with_winch.yaml"))
    found = {line.settles: line for line in worked(scene)}
    assert found["tie.force"].value == pytest.approx(18547.7, abs=0.05)
    assert found["rope.force.1"].value == pytest.approx(17658, rel=1e-12)
    # moments about the foot of the jib of what the lines say
    assert -4.74342 * found["tie.force"].value - 1.71758 * 17658 + 6 * 17658 + 12360.6 == pytest.approx(0, abs=1)


@pytest.mark.sweep
def test_forces_of_an_atwood_machine_by_hand():
    """m₁ẍ + S − m₁g = 0 with ẍ of the line before."""
    lines = worked(problem("""
parameters: {m1: 5 kg, m2: 3 kg, J: 0.08 kg*m^2, r: 0.2 m, h: 1 m, g: 10 m/s^2}
gravity: g
bodies:
  drum: {inertia: J, at: [0, 0], pin: phi}
  first: {mass: m1, at: [-r, -h], slide: {along: [0, -1], by: x}}
  second: {mass: m2, at: [r, -h], slide: {along: [0, 1], by: y}}
constraints:
  rope: {rope: [first, {over: drum, radius: r}, second]}
find: [accelerations]
answers: {rope.force.1(0 s): 40 N, rope.force.2(0 s): 36 N}
"""))
    found = {line.settles: line.value for line in lines}
    assert found["x''(0 s)"] == pytest.approx((5 - 3) * 10 / (8 + 0.08 / 0.2**2))
    assert found["rope.force.1"] == pytest.approx(5 * (10 - 2)) and found["rope.force.2"] == pytest.approx(3 * 12)
    assert any("m₁·ẍ + S_rope_1 − m₁·g = 0" in line for line in told(lines))


@pytest.mark.parametrize(("stem", "wanted"), [
    ("mast_on_a_cart", ["M·ẍ + k·x = EI·∂³u/∂ξ³ of mast at ξ = 0"]),
    ("geared_shafts_with_inertia", ["(J₁·r₂² + J₂·r₁²)/r₂²·φ̈₁ = −π·d⁴·G/32·∂φ/∂x of one at x = L₁ − "
                                    "π·r₁·d⁴·G/(32·r₂)·∂φ/∂x of two at x = 0"]), ("cantilever_with_tip_mass", [])])
def test_what_members_are_held_to_has_its_balance(stem, wanted):
    """Newton's and Euler's laws of a cart under the shear at the foot of its mast, of a pair of wheels on shafts."""
    lines = told(worked(kept_settled_of(Path("problems/8_continuous") / f"{stem}.yaml")))
    assert [line.partition(":  ")[2] for line in lines if line.startswith("what it is held to")] == wanted


def test_two_columns_under_a_floor_by_hand():
    """EI θ³ (cos θ sinh θ + sin θ cosh θ)/(H³ (1 − cos θ cosh θ)) of each, 12 EI/H³ at rest."""
    scene = problem("""
parameters: {H: 3 m, EI: 4 MN*m^2, mu: 60 kg/m, M: 900 kg}
beams:
  one: {length: H, EI: EI, mass_per_length: mu, left: clamped, right: {clamped: floor}}
  two: {length: H, EI: EI, mass_per_length: mu, left: clamped, right: {clamped: floor}}
bodies: {floor: {mass: M, slide: x}}
""")
    text = told(worked(scene))
    assert any("of one, two:  k = EI·θ³·(cos θ·sinh θ + sin θ·cosh θ)/(H³·(1 − cos θ·cosh θ))" in one for one in text)
    assert "so the frequency equation:  2·k − M·ω² = 0,  and where the denominator of k is 0, the joint at rest" in text


def test_members_that_meet_have_their_lines_in_letters():
    text = told(worked(problem("""
parameters: {L: , S: , mu: , M: }
strings:
  one: {length: L, preload: S, mass_per_length: mu, left: clamped, right: {clamped: bead}}
  two: {length: 2*L, preload: S, mass_per_length: mu, left: clamped, right: {clamped: bead}}
bodies: {bead: {mass: M, slide: y}}
""")))
    assert text[-3:] == ["dynamic stiffness at the joint, of one:  k₁ = S·θ₁·cos θ₁/(L·sin θ₁)",
                         "dynamic stiffness at the joint, of two:  k₂ = S·θ₂·cos θ₂/(2·L·sin θ₂)",
                         "so the frequency equation:  k₁ + k₂ − M·ω² = 0"]


@pytest.mark.sweep
def test_a_plucked_string_and_a_struck_bar_by_hand():
    """Rao 2007, 8.6 and 9.2: p_n = 2hL² sin(nπa/L)/(n²π²a(L − a)); m = ∫ρA X² dx + M X(L)², m ṗ = M X(L) ẋ(0)."""
    lines = {line.settles: line for line in worked(kept_problem_of("problems/8_continuous/plucked_string.yaml"))}
    L, h, a = 0.8, 0.004, 0.2
    for n in (1, 2, 3):
        wanted = 2 * h * L**2 * math.sin(n * math.pi * a / L) / (n**2 * math.pi**2 * a * (L - a))
        assert abs(lines[f"p[{n}](0)"].value) == pytest.approx(abs(wanted), rel=1e-9)
        assert lines[f"modal mass {n}"].value == pytest.approx(0.005 * L / 2, rel=1e-12)
    lines = {line.settles: line for line in worked(kept_problem_of("problems/8_continuous/struck_bar.yaml"))}
    M, v, of_bar = 3.2, -2.0, 8000 * 4e-4
    for n in (1, 2, 3):
        x = lines[f"βL[{n}]"].value
        m = of_bar * (0.5 - math.sin(2 * x) / (4 * x)) / math.sin(x)**2 + M
        assert lines[f"modal mass {n}"].value == pytest.approx(m, rel=1e-9)
        assert lines[f"p'[{n}](0)"].value == pytest.approx(M * v / m, rel=1e-9)


@pytest.mark.sweep
def test_what_lets_go_and_what_loads_do_by_modes():
    """A rope holds the top of a chimney in F x²(3L − x)/(6EI); Q of a walker at midspan is F by sin(kπ/2)."""
    text = told(worked(kept_problem_of("problems/8_continuous/chimney_let_go.yaml")))
    assert any("as rope held it:  u(x, 0) = 1.5e-5·x² − 8.33333e-8·x³" in line for line in text)
    assert any(line.startswith("so  u(x, t) = X₁(x)·(0.0349448·cos(ω_d1·t)") for line in text)
    text = told(worked(kept_problem_of("problems/8_continuous/footbridge_under_a_walker.yaml")))
    assert {"Q₁ = F·sin(Ω·t)", "Q₃ = −F·sin(Ω·t)"} <= set(text)


@pytest.mark.parametrize("name, wanted", [
    ("plucked_string", ("f₂(L + s) = −f₁(L − s),  as it is held", "f₁(−0.2) + f₂(1.4) = −0.002 − 0.002 = −0.004 m")),
    ("bar_half_strained_let_go", ("r = −(c − Z)/(c + Z) = 0.6", "f₁(−5.2) + f₂(7.2) = 0.0001 − 6.4e-5 = 3.6e-5 m")),
    ("matched_damper", ("as pull held it:  u(x, 0) = 0.000285714·x", "f₁(0) + f₂(3) = 0 + 0.000214286 =")),
    ("bar_pulled_and_let_go", ("f₂(L + s) = f₁(L − s),  as it is free",))])
def test_waves_by_hand(name, wanted):
    """A half of the strained bar: f₁(−5.2) = −f₂(5.2), f₂(5.2) = r f₁(−1.2) + …, and so on; a matched damper sends
    nothing back."""
    text = told(worked(kept_problem_of(f"problems/8_continuous/{name}.yaml")))
    assert all(any(part in line for line in text) for part in wanted), text


@pytest.mark.sweep
def test_what_an_engine_keeps_up_of_a_bridge_by_hand():
    """The entries that the line tells make D, and U by D U = F is mid-span's share of Σ 2F sin²(kπ/3)/(μL(ω_k² − Ω²));
    the solution is put into its rows."""
    lines = worked(kept_problem_of("problems/8_continuous/bridge_under_an_engine.yaml"))
    text, EI, Omega = told(lines), 4.5e8, 30.0
    beta, = (line.value for line in lines if line.settles.startswith("beta "))
    assert beta == pytest.approx((900 * Omega**2 / EI)**0.25, rel=1e-12)
    d = {}
    for length in (6.0, 12.0):
        x = beta * length
        N = 1 - math.cos(x) * math.cosh(x)
        d[length] = {"d₁₁": EI * beta**3 * (math.cos(x) * math.sinh(x) + math.sin(x) * math.cosh(x)) / N,
                     "d₁₂": EI * beta**2 * math.sin(x) * math.sinh(x) / N,
                     "d₂₂": EI * beta * (math.sin(x) * math.cosh(x) - math.cos(x) * math.sinh(x)) / N,
                     "d₁₄": EI * beta**2 * (math.cosh(x) - math.cos(x)) / N,
                     "d₂₄": EI * beta * (math.sinh(x) - math.sin(x)) / N}
    entries, = (line for line in text if line.startswith("of  bridge.slope(0 m), "))
    for name, value in (("D₁₁", d[6.0]["d₂₂"]), ("D₁₂", -d[6.0]["d₁₄"]), ("D₁₃", d[6.0]["d₂₄"]),
                        ("D₂₂", d[6.0]["d₁₁"] + d[12.0]["d₁₁"]), ("D₂₃", d[12.0]["d₁₂"] - d[6.0]["d₁₂"]),
                        ("D₃₄", d[12.0]["d₂₄"])):
        found = float(entries.split(f"{name} = ")[1].split(",")[0].replace("−", "-"))
        assert found == pytest.approx(value, rel=1e-5)
    values = {line.letter: line.value for line in lines if line.settles.startswith("steady bridge")}
    series = sum(2 * 3000 * math.sin(k * math.pi / 3)**2 / (900 * 18 * ((k * math.pi / 18)**4 * EI / 900 - Omega**2))
                 for k in range(1, 4000))
    assert values["U2"] == pytest.approx(series, rel=1e-9)
    rows = [line.vanishes for line in lines if line.settles.startswith("steady bridge")]
    assert all(abs(left) < 1e-7 for left in evaluate(rows, Floats, values))


@pytest.mark.parametrize("name", ["struck_bar", "bar_half_strained_let_go", "bridge_under_an_engine",
                                  "footbridge_under_a_walker"])
def test_lines_on_motions_are_latex(name):
    """No letter is left that LaTeX does not know, as a dot that combines with a letter."""
    for line in worked(kept_problem_of(f"problems/8_continuous/{name}.yaml")):
        assert formula(line.parts, latex).isascii(), line


@pytest.mark.sweep
def test_what_a_walker_keeps_up_is_the_sum_of_the_modes():
    """At midspan X_k is ±1 as Q_k/F is: Σ P_k e^{−iθ_k} of three modes has but the fifth odd mode's share to go."""
    scene = kept_problem_of("problems/8_continuous/footbridge_under_a_walker.yaml")
    F, m, Omega, zeta = 280.0, 1200 * 30 / 2, 12.5, 0.006
    lines = {line.settles: line for line in worked(scene)}
    for k in (1, 3, 5):
        omega = (k * math.pi / 30)**2 * math.sqrt(1.75e9 / 1200)
        wanted = F / m / math.hypot(omega**2 - Omega**2, 2 * zeta * omega * Omega)
        assert lines[f"steady mode {k}"].value == pytest.approx(wanted, rel=1e-9)
    assert sum(lines[f"steady mode {k}"].value for k in (1, 3, 5)) == pytest.approx(0.810256955e-3, rel=1e-3)


@pytest.mark.sweep
def test_a_start_in_one_mode_is_of_that_mode_alone():
    """Not 6e-16 of the third that the load moves, which is what rounds in the integral of the shape by the start."""
    text = told(worked(problem("""
parameters: {L: 1.2 m, EI: 900 N*m^2, mu: 4 kg/m, F: 20 N, W: 40 rad/s, a: 3 mm}
beams: {girder: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned}}
points: {mid: {body: girder, at: L/2}}
forces: {f: {at: mid, force: F*cos(W*t)}}
initial: {girder.u: a*sin(pi*x/L)}
answers: {girder.u(L/2)(0 s): 3 mm}
""")))
    assert "p₁(0) = 0.003 m" in text and "Q₃ = −F·cos(W·t)" in text and not any("p₃(0)" in line for line in text)


def test_what_carries_a_member_has_its_balance_once():
    text = told(worked(problem("""
        parameters: {L: 0.9 m, EI: 60 N*m^2, mu: 0.6 kg/m, m: 2 kg, k: 900 N/m}
        bodies: {cart: {mass: m, at: [0, 0], move: [x, 0, 0]}}
        beams: {mast: {from: [0, 0], to: [0, L], EI: EI, mass_per_length: mu, left: {clamped: cart}}}
        springs: {s: {between: [[-0.3 m, 0], cart], k: k}}
        """)))
    assert [line for line in text if "k·x" in line] == ["what it is held to:  m·ẍ + k·x = EI·∂³u/∂ξ³ of mast at ξ = 0"]


@pytest.mark.sweep
def test_a_motion_that_symmetry_leaves_at_rest_is_0():
    text = told(worked(problem("""
        parameters: {L: 6 m, EI: 6.4 MN*m^2, mu: 60 kg/m, k: 20 MN/m^2, c: 40 kN*s/m^2, F: 100 kN}
        beams: {rail: {length: L, EI: EI, mass_per_length: mu, foundation: k, drag: c}}
        points: {w: {body: rail, at: L/2}}
        forces: {wheel: {at: w, force: -F*cos((300 rad/s)*t)}}
        answers: {amplitude(rail.u(L/2)): 2.5017 mm}
        """)))
    assert any("U₄ = 0 rad,  |U₄| = 0 rad" in line for line in text), text


def test_gyroscopic_terms_stand_in_the_balance_of_what_members_are_held_to():
    """In the steps, and in the report's equations."""
    scene = problem("""
        parameters: {L: 1 m, GIo: 90 N*m^2, j: 1 kg*m, h: 0.4 N*m*s, J: 0.02 kg*m^2}
        bodies: {d: {inertia: J, turn: a}, e: {inertia: J, turn: b}}
        shafts:
          one: {length: L, GIo: GIo, inertia_per_length: j, left: clamped, right: {clamped: d}}
          two: {length: L, GIo: GIo, inertia_per_length: 2*j, left: clamped, right: {clamped: e}}
        matrices: {C: [[0, h], [-h, 0]]}
        """)
    held = [line for line in told(worked(scene)) if line.startswith("what it is held to")]
    assert [line.partition(":  ")[2].partition(" =")[0] for line in held] == ["J·ä + h·ḃ", "J·b̈ − h·ȧ"]
    of_joints = [formula(carried(i, scene.symbolic.linearisation.pieces, of_what_is_no_member(scene),
                                 scene.scene).parts, plain) for i in range(2)]
    assert [line.partition(" =")[0] for line in of_joints] == ["J·ä + h·ḃ", "J·b̈ − h·ȧ"]
