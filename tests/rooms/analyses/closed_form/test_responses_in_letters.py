"""Steady states, free motions and conditions in letters: against the same scene in numbers, and against textbooks."""

import math
import re
from fractions import Fraction

import numpy as np
import pytest
from support.scenes import number, problem, value

from vibcli.analyses.closed_form.steady_state import steady_state
from vibcli.api.reports import report
from vibcli.base.errors import NotInLetters, PhysicsError, SpecError
from vibcli.inverse import settled
from vibcli.quantities.in_letters import quantity_in_letters
from vibcli.report.blocks import Equations, SumOfTerms
from vibcli.report.document import Report
from vibcli.report.formats.text import section_lines, shown
from vibcli.report.sections.symbolic_response import response_in_letters
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import parse

FORCED = """
    parameters: {m: , k: , c: , F0: , Omega: }
    bodies: {block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, block]}}
    dampers: {d: {c: c, between: [ground, block]}}
    forces: {drive: {at: block, force: F0*%s(Omega*t)}}
"""
UNDAMPED = FORCED.replace("    dampers: {d: {c: c, between: [ground, block]}}\n", "").replace("c: , ", "")
SHAKEN = """
    parameters: {m: , k: , c: , Y: , Omega: }
    bodies: {base: {slide: Y*sin(Omega*t)}, block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [base, block]}}
    dampers: {d: {c: c, between: [base, block]}}
"""
BETWEEN = """
    parameters: {m: , k: , c: , Y: , Z: , psi: , Omega: }
    bodies: {one: {slide: Y*sin(Omega*t)}, two: {slide: Z*sin(Omega*t + psi)}, block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [one, block]}, r: {k: 2*k, between: [block, two]}}
    dampers: {d: {c: c, between: [block, two]}}
"""
UNBALANCED = """
    parameters: {m: , k: , c: , m0: , e: , Omega: }
    bodies: {motor: {mass: m, at: [0, 0], slide: {along: [0, 1], by: x}}}
    springs: {s: {k: k, between: [[0, -1 m], motor]}}
    dampers: {d: {c: c, between: [[0, -1 m], motor]}}
    forces: {u: {at: motor, unbalance: m0*e, speed: Omega}}
"""
ABSORBER = """
    parameters: {m1: , m2: , k1: , k2: , F0: , Omega: }
    bodies: {machine: {mass: m1, slide: x1}, absorber: {mass: m2, slide: x2}}
    springs: {mount: {k: k1, between: [ground, machine]}, tuned: {k: k2, between: [machine, absorber]}}
    forces: {drive: {at: machine, force: F0*sin(Omega*t)}}
"""
DAMPED = ABSORBER.replace("F0: ", "c: , F0: ") + """
    dampers: {d: {c: c, between: [machine, absorber]}}
"""
FREE = """
    parameters: {m: , k: , c: , x0: , v0: }
    bodies: {block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, block]}}
    dampers: {d: {c: c, between: [ground, block]}}
    initial: {x: x0, x': v0}
"""


def printed(found, section="response"):
    """The lines of a section, without their indent."""
    report = Report(found)
    report.add(section)
    assert report.refusal is None, report.refusal
    return [line.strip() for line in shown(section_lines(report.sections)).splitlines()]


def numbers(lettered, seed):
    """{name: float} for the letters of a scene."""
    rng = np.random.default_rng(seed)
    return {name: float(Fraction(f"{x:.3g}")) for name, x in zip(lettered.symbolic.letters, np.exp(rng.uniform(
        -1, 1.5, len(lettered.symbolic.letters))), strict=True)}


def with_numbers(lettered, given):
    return lettered.with_values({name: Fraction(str(x)) for name, x in given.items()})


@pytest.mark.parametrize("signal", ["x", "x'", "x''", "s.force", "d.force", "ground.force"])
@pytest.mark.parametrize("scene", [FORCED % "sin", FORCED % "cos", SHAKEN, BETWEEN, UNBALANCED, ABSORBER, DAMPED])
def test_steady_states_have_the_values_of_the_motion(scene, signal):
    """X, and θ of X sin(Ωt − θ); of X cos(Ωt − θ) the lag is a quarter less."""
    if scene in (ABSORBER, DAMPED):
        signal = signal.replace("x", "x2").replace("s.", "tuned.")
    if (scene is ABSORBER and signal == "d.force") or (scene is UNBALANCED and signal == "ground.force"):
        return
    lettered = problem(scene)
    for seed in range(3):
        given = numbers(lettered, seed)
        numeric, found = with_numbers(lettered, given), steady_state(lettered.symbolic, signal)
        forms = [found.formula.amplitude, found.formula.tangent or found.formula.amplitude]
        amplitude, tangent = evaluate(forms, Floats, given)
        assert abs(amplitude) == pytest.approx(value(numeric, f"amplitude({signal})"), rel=1e-11)
        theta = value(numeric, f"phase({signal})") + (math.pi / 2 if found.wave == "cos" else 0.0)
        if found.formula.ahead:
            assert math.sin(theta) == pytest.approx(-math.copysign(1.0, amplitude), rel=1e-9)
            continue
        assert math.tan(theta) == pytest.approx(tangent, rel=1e-9, abs=1e-12)
        if found.formula.undamped:
            assert math.cos(theta) == pytest.approx(math.copysign(1.0, amplitude), rel=1e-9)


@pytest.mark.parametrize(("scene", "lines"), [
    # Rao 2018, eqs. 3.33-3.35, 3.5, 3.67-3.68, 3.79: force, force without damper, base, unbalance
    (FORCED % "sin", ["x = X·sin(Ω·t − θ)", "X = F₀/√((k − m·Ω²)² + c²·Ω²)", "tan θ = c·Ω/(k − m·Ω²)",
                      "peak at Ω = √(k/m − c²/(2·m²)) for c² < 2·m·k"]),
    (FORCED % "cos", ["x = X·cos(Ω·t − θ)", "X = F₀/√((k − m·Ω²)² + c²·Ω²)"]),
    (SHAKEN, ["X = Y·√((k² + c²·Ω²)/((k − m·Ω²)² + c²·Ω²))", "tan θ = m·c·Ω³/(k² + c²·Ω² − m·k·Ω²)"]),
    (UNBALANCED, ["x = X·sin(Ω·t − θ)", "X = m₀·e·Ω²/√((k − m·Ω²)² + c²·Ω²)", "tan θ = c·Ω/(k − m·Ω²)",
                  "peak at Ω = √2·k/√(2·m·k − c²) for c² < 2·m·k"]),
    # Rao 2018, eqs. 9.142-9.143
    (ABSORBER, ["x₁ = X₁·sin(Ω·t)", "X₁ = F₀·(k₂ − m₂·Ω²)/((k₁ + k₂ − m₁·Ω²)·(k₂ − m₂·Ω²) − k₂²)",
                "X₂ = k₂·F₀/((k₁ + k₂ − m₁·Ω²)·(k₂ − m₂·Ω²) − k₂²)", "antiresonance at Ω = √(k₂/m₂)",
                "resonances where (k₁ + k₂ − m₁·Ω²)·(k₂ − m₂·Ω²) − k₂² = 0"]),
    # Rao 2018, eqs. 2.72, 2.80, 2.81
    (FREE, ["under-damped, c² < 4·m·k:", "ω_d = √(k/m − c²/(4·m²))",
            "x = exp(−c·t/(2·m))·(x₀·cos(ω_d·t) + (c·x₀/(2·m) + v₀)·sin(ω_d·t)/ω_d)",
            "x = exp(−c·t/(2·m))·(x₀ + (c·x₀/(2·m) + v₀)·t)"]),
    (FREE.replace(" c: ,", "").replace("dampers", "# dampers"), ["x = x₀·cos(ω·t) + v₀·sin(ω·t)/ω", "ω = √(k/m)"]),
    (FREE.replace("x0: , v0: ", "").replace("initial", "# initial").replace("c: ,", "c:"), [
        "x = exp(−c·t/(2·m))·(x₀ + (ẋ₀ + c·x₀/(2·m))·t)"])])
def test_printed_as_in_a_textbook(scene, lines):
    assert set(lines) - set(printed(problem(scene))) == set()


def test_a_lag_of_a_right_angle_is_said_where_omega_is_the_natural_frequency():
    """1/(k − mΩ² + icΩ) is −i/(cΩ) at Ω² = k/m; where Ω is no letter of its own there is no peak at another."""
    at_rest = (FORCED % "sin").replace("Omega: ", "Omega: sqrt(k/m)")
    assert at_rest != FORCED % "sin"
    lines = printed(problem(at_rest))
    assert {"x = X·sin(√(k/m)·t − θ)", "X = F₀·√(m/k)/c", "θ = π/2"} <= set(lines)
    assert not any("peak" in one for one in lines)
    assert "θ = −π/2" in printed(problem(at_rest.replace("F0*sin", "-F0*sin")))


@pytest.mark.parametrize(("c", "told"), [("2*sqrt(k*m)", set()), ("sqrt(k*m)/5", {"peak at Ω = 7·√(k/(50·m))"})])
def test_a_peak_has_no_condition_that_always_or_never_holds(c, told):
    lines = printed(problem((FORCED % "sin").replace("c: ,", f"c: {c},")), "frequency_response")
    assert {one for one in lines if "peak" in one} == told


def test_the_first_input_is_one_that_drives():
    """A pivot that rises as a t²/2 makes the pendulum heavier, and drives it not."""
    risen = problem("""
        parameters: {m: , L: , a: , g: }
        gravity: g
        points: {O: {at: [0, 0], moves: [0, a*t^2/2]}}
        bodies: {bob: {mass: m, at: [0, -L], pin: {at: O, by: phi}}}
    """)
    assert "H = 1/(m·L·(a + g) − m·L²·Ω²)" in printed(risen, "frequency_response")


def test_letters_that_are_taken_are_given_to_nothing_else():
    """X, Z and R are parameters: the amplitude is not the A of the free part."""
    taken = (FORCED % "sin").replace("{m: , k: , c: ,", "{X: , Z: , R: ,").replace("mass: m", "mass: X")
    lines = printed(problem(taken.replace("{k: k", "{k: Z").replace("{c: c", "{c: R")))
    told = [one.partition(" = ")[0] for one in lines if " = " in one and one.partition(" = ")[0] != "x"]
    told = [name for name in told if name != "tan θ"]
    told.remove("X₂")                      # told by r and ζ once more
    assert {"X₂", "A", "B"} <= set(told) and len(told) == len(set(told)), told


def test_frequency_responses_say_where_they_resonate():
    lines = printed(problem(ABSORBER), "frequency_response")
    assert "H = (k₂ − m₂·Ω²)/((k₁ + k₂ − m₁·Ω²)·(k₂ − m₂·Ω²) − k₂²)" in lines
    assert "antiresonance at Ω = √(k₂/m₂)" in lines
    assert "resonances where (k₁ + k₂ − m₁·Ω²)·(k₂ − m₂·Ω²) − k₂² = 0" in lines


@pytest.mark.sweep
@pytest.mark.parametrize("scene", [FORCED % "sin", UNBALANCED])
def test_peak_of_one_degree(scene):
    lettered = problem(scene)
    given = {**numbers(lettered, 1), "m": 2.0, "k": 300.0, "c": 7.0}
    peak = steady_state(lettered.symbolic, "x").formula.peak
    place, = evaluate([peak.Omega], Floats, given)
    around = [value(with_numbers(lettered, {**given, "Omega": float(f"{place * share:.9g}")}), "amplitude(x)")
              for share in (0.999, 1.0, 1.001)]
    assert around[1] > max(around[0], around[2])


def motion(lettered, given, t):
    """x(t) by the printed formulas of the regime that holds."""
    blocks = [block.lines for found in response_in_letters(lettered, [("x", parse("x"))]) for block in found.blocks
              if isinstance(block, Equations)]
    known = dict(given, t=t)
    if lettered.scene.timed:
        formula = steady_state(lettered.symbolic, "x").formula
        known["X"], = evaluate([formula.amplitude], Floats, given)
        if not formula.undamped:
            known["theta"] = math.atan(evaluate([formula.tangent], Floats, given)[0]) % math.pi
        blocks = blocks[1:]
        for line in blocks.pop() if len(blocks) > 1 else ():
            known[line.parts[0].name], = evaluate([line.parts[2]], Floats, known)
    over = known.get("c", 0.0) ** 2 > 4 * known["m"] * known["k"]
    first, *others = blocks[2 if over else 0]
    for line in others:
        known[line.parts[0].name], = evaluate([line.parts[2]], Floats, known)
    terms, product = 0.0, 1.0
    for part in first.parts[2:]:
        if part == " + ":
            terms, product = terms + product, 1.0
        elif not isinstance(part, str):
            product *= sum(evaluate(list(part.nodes) if isinstance(part, SumOfTerms) else [part], Floats, known))
    return terms + product


@pytest.mark.parametrize("c", [None, 3.0, 90.0])
@pytest.mark.parametrize("driven", [False, "sin", "cos"])
def test_motions_from_the_start_are_those_in_numbers(c, driven):
    started = FORCED.replace("F0: ,", "F0: , x0: , v0: ,") + "    initial: {x: x0, x': v0}\n"
    scene = started % driven if driven else FREE
    if c is None:
        scene = scene.replace(" c: ,", "").replace("dampers", "# dampers")
    lettered = problem(scene)
    given = {name: x for name, x in {"m": 2.0, "k": 300.0, "c": c, "x0": 0.3, "v0": -1.2, "F0": 40.0,
                                     "Omega": 9.0}.items() if name in lettered.symbolic.letters}
    numeric = with_numbers(lettered, given)
    for t in (0.0, 0.13, 0.9):
        assert motion(lettered, given, t) == pytest.approx(value(numeric, f"x({t} s)"), rel=1e-9)


@pytest.mark.parametrize(("scene", "words"), [
    (FORCED.replace("%s(Omega*t)", "sin(Omega*t)^2"), "sin\\(Omega"),
    ((FORCED % "sin").replace("F0*sin(Omega*t)", "F0*sin(Omega*t) + F0*sin(2*Omega*t)"), "one harmonic"),
    ((FORCED % "sin").replace("F0*sin(Omega*t)", "F0*step(t - 1 s) + F0*sin(Omega*t)"), "sin\\(Omega"),
    (ABSORBER.replace("F0*sin(Omega*t)", "F0").replace(", Omega: ", ""), "one degree"),
    (FREE + "    motion: full\n", "motions that are integrated")])
def test_what_is_not_known_is_refused(scene, words):
    report = Report(problem(scene))
    report.add("response")
    assert isinstance(report.refusal, NotInLetters)
    with pytest.raises(NotInLetters, match=words):
        raise report.refusal


# chosen by responses

@pytest.mark.parametrize(("scene", "condition", "known"), [
    # Den Hartog 1956, §3.2: an absorber tuned to the excitation brings the machine to rest
    (ABSORBER, "k2: amplitude(x1) = 0", "m2*Omega^2"),
    (ABSORBER, "k2: abs(frf[x1, drive](2*Omega)) = 0", "4*m2*Omega^2"),
    (ABSORBER, "m2: amplitude(ground.force) = 0", "k2/Omega^2"),
    # Rao 2018, eq. 9.116: the stiffness of an isolator without damping that lets a fraction of the force through
    (FORCED.replace("dampers", "# dampers").replace("c: ,", "T: ,") % "sin",
     "k: transmissibility[ground.force, drive](Omega) = T", "m*Omega^2*T/(1 + T)"),
    (SHAKEN.replace("dampers", "# dampers").replace("c: ,", "a: ,"), "m: amplitude(x) = a", "k*(1 + Y/a)/Omega^2"),
    (FORCED.replace("F0: ,", "F0: , a: ,") % "sin", "c: amplitude(x) = a",
     "sqrt((F0/a)^2 - (k - m*Omega^2)^2)/Omega"),
    (UNBALANCED.replace("Omega: }", "Omega: , a: }"), "m0: abs(frf[x, x](Omega)) = a/(m0*e*Omega^2)",
     "a*sqrt((k - m*Omega^2)^2 + c^2*Omega^2)/(e*Omega^2)")])
def test_chosen_in_letters_by_a_response(scene, condition, known):
    name = condition.partition(":")[0]
    scene = re.sub(rf"([{{ ]){name}: ,? ?", r"\1", scene, count=1)
    found = settled(problem(scene + f"    choose: {{'{name}':{condition.partition(':')[2]!r}}}\n"))
    forms = [solution.forms[name] for solution in found.choice.solutions]
    draw = {"m": 2.0, "k": 300.0, "c": 1.5, "F0": 300.0, "Omega": 11.0, "a": 0.7, "Y": 0.4, "T": 0.3, "m1": 5.0,
            "m2": 1.5, "k1": 900.0, "k2": 250.0, "m0": 0.3, "e": 0.2}
    wanted = number(parse(known), draw)
    assert any(x == pytest.approx(wanted, rel=1e-12) for x in evaluate(forms, Floats, draw))


# fixed points

TUNED = """
    parameters: {m1: %s, m2: %s, k1: %s, c: %s, F0: %s}
    bodies: {machine: {mass: m1, slide: x1}, absorber: {mass: m2, slide: x2}}
    springs: {mount: {k: k1, between: [ground, machine]}, tuned: {k: k2, between: [machine, absorber]}}
    dampers: {d: {c: c, between: [machine, absorber]}}
    forces: {drive: {at: machine, force: F0*sin(25 rad/s*t)}}
    choose:
      k2: "fixed_point[1, d](frf[x1, drive]).value = fixed_point[2, d](frf[x1, drive]).value"
"""


@pytest.mark.sweep
def test_absorber_chosen_by_its_fixed_points():
    """Den Hartog 1956, §3.3: ω₂/ω₁ = 1/(1 + μ); g² = (1 ± √(μ/(2 + μ)))/(1 + μ), √(1 + 2/μ) static deflections high."""
    found = settled(problem(TUNED % ("20 kg", "2 kg", "8000 N/m", "30 N*s/m", "50 N")))
    assert float(found.choice.solutions[0].values["k2"]) == pytest.approx(2 * (20 / 1.1) ** 2, rel=1e-12)
    mu = 0.1
    for i, sign in ((1, -1), (2, 1)):
        place = 20 * math.sqrt((1 + sign * math.sqrt(mu / (2 + mu))) / (1 + mu))
        point = f"fixed_point[{i}, d](frf[x1, drive])"
        assert value(found, point + ".Omega") == pytest.approx(place, rel=1e-7)
        assert value(found, point + ".value") == pytest.approx(math.sqrt(1 + 2 / mu) / 8000, rel=1e-7)
    lines = printed(found, "frequency_response")
    assert sum(line.startswith("fixed point") for line in lines[:lines.index(lines[-1])]) >= 2


@pytest.mark.sweep
def test_tuning_in_letters():
    """k₂ = m₂ω₁²/(1 + μ)², μ = m₂/m₁ (Den Hartog 1956, §3.3)."""
    found = settled(problem((TUNED % ("", "", "", "", "")).replace("25 rad/s", "3 rad/s")))
    draw = {"m1": 20.0, "m2": 2.0, "k1": 8000.0, "c": 30.0, "F0": 50.0}
    form = found.choice.solutions[0].forms["k2"]
    assert evaluate([form], Floats, draw)[0] == pytest.approx(2 * (20 / 1.1) ** 2, rel=1e-12)


def test_a_fixed_point_needs_a_damper_of_the_scene():
    with pytest.raises(SpecError, match="no damper 'e'"):
        problem((TUNED % ("20 kg", "2 kg", "8000 N/m", "30 N*s/m", "50 N")).replace("[1, d]", "[1, e]"))


@pytest.mark.parametrize("scene", [FORCED % "sin", UNDAMPED % "sin", UNDAMPED % "cos", SHAKEN, UNBALANCED, ABSORBER,
                                   DAMPED])
def test_resonances_are_told_once_of_each_signal_and_only_where_nothing_is_damped(scene):
    given = problem(scene)
    signals = [*given.spec.coordinates, *(f"{name}.force" for name in given.spec.get("springs"))]
    found = problem(f"{scene}\n    find: {{response: {{of: [{', '.join(signals)}]}}}}\n")
    told = [line for line in printed(found) if line.startswith("resonance")]
    assert len(told) == (0 if "dampers:" in scene else len(signals))


@pytest.mark.parametrize("scene", [ABSORBER, DAMPED])
@pytest.mark.parametrize("signal", ["x1 - x2", "k1*x1 + 3*k2*(x2 - x1)", "x1'/Omega - (x2 + tuned.stretch)*m1/m2"])
def test_sums_of_signals_have_the_amplitude_of_the_motion(scene, signal):
    lettered = problem(scene)
    given = numbers(lettered, 5)
    found, = evaluate([steady_state(lettered.symbolic, parse(signal)).formula.amplitude], Floats, given)
    assert abs(found) == pytest.approx(value(with_numbers(lettered, given), f"amplitude({signal})"), rel=1e-11)
    asked, = evaluate([quantity_in_letters(lettered, parse(f"amplitude({signal})"))], Floats, given)
    assert asked == pytest.approx(abs(found), rel=1e-12)


def test_a_signal_that_is_not_found_leaves_the_others():
    lines = printed(problem(ABSORBER + "    find: [{response: {of: [x1, x1*x2, x1 + x2]}}]\n"))
    at = lines.index("Not found in letters")
    assert lines[at + 1] == "x₁·x₂: of signals sums alone are found in letters, each with a factor that is fixed"
    assert "x₁ + x₂ = X₂·sin(Ω·t)" in lines and lines.index("Steady state of x₁ + x₂") < at
    found = Report(problem(ABSORBER + "    find: [{response: {of: [x1*x2]}}]\n"))
    found.add("response")
    assert isinstance(found.refusal, NotInLetters)


def test_no_antiresonance_where_nothing_vanishes():
    """k₁(x₁ − 2x₂) of two equal masses is −k F₀ (m Ω² + k) over the determinant."""
    chain = ABSORBER.replace("m1: , m2: , k1: , k2: ", "m: , k: ")
    chain = re.sub(r"\bm[12]\b", "m", re.sub(r"\bk[12]\b", "k", chain))
    formula = steady_state(problem(chain).symbolic, parse("x1 - 2*x2")).formula
    assert formula.zeros is None
    assert steady_state(problem(chain).symbolic, "x1").formula.zeros is not None


@pytest.mark.parametrize("k", ["{unit: N/m}", "4 N/m"])
def test_what_resists_no_force_has_no_finite_response(k):
    """A body without mass that nothing ties, beside one on a spring: refused in letters, without bound in numbers."""
    loose = problem(f"parameters: {{k: {k}}}\nbodies: {{a: {{mass: 0 kg, slide: x}}, b: {{mass: 1 kg, slide: y}}}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\nmotion: small\n")
    with pytest.raises(PhysicsError, match="neither inertia nor stiffness nor damping"):
        loose.symbolic_frequency_response("x", "x")
    assert not loose.symbolic_frequency_response("y", "y").vanishes
    if k == "4 N/m":
        told = "\n".join(section_lines(report(loose, ["frequency_response"]).sections))
        assert "it has no bound" in told
