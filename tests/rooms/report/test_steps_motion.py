"""The worked solution beyond the frequencies: steady states, pieces of loads, free motions, chosen parameters, normal
coordinates, held against the motion that the engine finds and against plain arithmetic."""

import cmath
import math
import re
from pathlib import Path

import mpmath
import pytest
from support.scenes import kept_problem_of, problem

import vibcli
from vibcli.inverse import settled
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

VALUES = {"F": "5 N", "S": "3 N*s", "w": "15 rad/s", "t1": "0.1 s"}


def oscillator(load=None, c="8 N*s/m", values=VALUES, more=""):
    """A mass of 2 kg on a spring of 800 N/m under a load."""
    used = {name: value for name, value in values.items() if re.search(rf"\b{name}\b", load or "")}
    used = {"m": "2 kg", "k": "800 N/m", **({"c": c} if c else {}), **used}
    return "\n".join([
        "parameters: {" + ", ".join(f"{name}: {value}" for name, value in used.items()) + "}",
        "bodies: {b: {mass: m, slide: x}}", "springs: {s: {k: k, between: [ground, b]}}",
        *(["dampers: {d: {c: c, between: [ground, b]}}"] if c else []),
        *([f"forces: {{f: {{at: b, force: {load}}}}}"] if load else []), more, ""])


def told(lines):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in lines]


def lines_of(text):
    return {line.settles: line for line in worked(problem(text))}


@pytest.mark.parametrize(("wave", "orders"), [("square", (1, 3, 5)), ("sawtooth", (1, 2, 3))])
def test_harmonics_of_a_wave_are_those_of_the_motion(tmp_path, wave, orders):
    text = oscillator(f"F*{wave}(w*t)")
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    found, lines = vibcli.load(path), lines_of(text)
    for n in orders:
        value = lines[f"harmonic[{n}](x)"].value
        assert value == pytest.approx(found[f"harmonic[{n}](x)"].value, rel=1e-9)
        factor = 4 / math.pi if wave == "square" else 2 / math.pi
        by_hand = 5 * factor / n / abs(800 - 2 * (15 * n)**2 + 8j * 15 * n)
        assert value == pytest.approx(by_hand, rel=1e-12)


@pytest.mark.parametrize("load", ["F*sin(w*t)", "F*cos(w*t)", "F*sin(w*t) + 2*F*cos(w*t)"])
@pytest.mark.parametrize("damped", [True, False])
@pytest.mark.parametrize("start", ["", "initial: {x: 3 mm, x': 0.2 m/s}"])
def test_the_motion_from_the_start_under_a_harmonic(tmp_path, load, damped, start):
    """X, θ, A, B of the lines make the motion that the engine finds."""
    text = oscillator(load, "8 N*s/m" if damped else None, more=start + "\nanswers: {max(x): 1 m}")
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    found, lines = vibcli.load(path), lines_of(text)
    line = told([lines["motion from the start"]])[0].replace("−", "-")
    A, B = (float(x) for x in re.findall(r"= (-?[\d.e-]+) m(?:,|$)", line)[-2:])
    X = lines["amplitude(x)"].value
    theta = float(told([lines["tan theta"]])[0].replace("−", "-").rpartition("θ = ")[2].split()[0]) if (
        "tan theta" in lines) else 0.0
    wave = math.cos if "cos" in load and "sin" not in load else math.sin
    delta, rate = (2.0, math.sqrt(396)) if damped else (0.0, 20.0)
    for t in (0.05, 0.21, 0.6):
        motion = X * wave(15 * t - theta) + math.exp(-delta * t) * (A * math.cos(rate * t) + B * math.sin(rate * t))
        assert found[f"x({t} s)"].value == pytest.approx(motion, rel=2e-4, abs=2e-8)


def test_two_harmonics_each_with_its_amplitude(tmp_path):
    lines = lines_of(oscillator("F*sin(w*t) + 2*F*cos(3*w*t) + F*sin(3*w*t)"))
    found = {line.value for name, line in lines.items() if name.startswith("amplitude")}
    for Omega, F in ((15, 5), (45, 5 * math.sqrt(5))):
        by_hand = F / abs(800 - 2 * Omega**2 + 8j * Omega)
        assert any(math.isclose(value, by_hand, rel_tol=1e-12) for value in found), (found, by_hand)


@pytest.mark.parametrize("load", ["F*sin(w*t)", "F*cos(w*t)", "F*sin(w*t) + 2*F*cos(w*t)", "-F*cos(w*t)"])
def test_the_complex_equation_gives_amplitude_and_lag(load):
    """X e^{−iθ} of the line, solved by hand, is what the next lines say."""
    lines = lines_of(oscillator(load))
    text, = told([lines["complex equation"]])
    right = text.partition(") = ")[2]
    factor = complex(eval(right.replace("·", "*").replace("−", "-").replace("i", "1j"), {"F": 5.0}))
    phasor = factor / (800 - 2 * 225 + 8j * 15)
    assert abs(phasor) == pytest.approx(lines["amplitude(x)"].value, rel=1e-12)
    assert math.tan(-cmath.phase(phasor)) == pytest.approx(lines["tan theta"].value, rel=1e-9)


@pytest.mark.parametrize("load", [
    "F*step(t)", "F*(step(t) - step(t - t1))", "S*impulse(t - t1)", "-S*impulse(t - t1) + F*step(t)",
    "F*ramp(t)/t1 - F*ramp(t - t1)/t1", "F*(1 - t/t1)*(step(t) - step(t - t1))", "F*sin(w*t)*step(t)",
    "F*sin(pi*t/t1)*(step(t) - step(t - t1))", "F*cos(w*t)*step(t - t1)", "F*sin(w*(t1 - t))*step(t)",
    "F*sin(2*pi*t/t1)*(step(t) - step(t - t1)) + F*step(t)"])
@pytest.mark.parametrize("damped", [True, False])
def test_pieces_add_up_to_the_motion(tmp_path, load, damped):
    text = oscillator(load, "8 N*s/m" if damped else None)
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    found, scene = vibcli.load(path), problem(text)
    lines = worked(scene)
    known = dict(scene.numeric.floats)
    of = {line.settles: line for line in lines}
    known |= {"omega": of["omega[1]"].value} | {name: of[name].value for name in "RS" if name in of}
    known |= {"Omega": of["Omega of the load"].value} if "Omega of the load" in of else {}
    if damped:
        known |= {"delta": of["delta"].value, "omega_d": of["omega_d[1]"].value}
    for t in (0.05, 0.13, 0.4):
        assert _sum_of_pieces(of, known, t) == pytest.approx(found[f"x({t} s)"].value, rel=1e-9, abs=1e-15)


def test_any_load_is_the_sum_of_its_impulses(tmp_path):
    """A load that is none of the pieces: the integral of the line by quadrature is the motion of the engine."""
    text = oscillator("F*(w*t)^2*exp(-w*t)*step(t)")
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    lines, values = lines_of(text), {"m": 2.0, "delta": 2.0, "omega_d": math.sqrt(396)}
    line = lines["convolution"]
    weight = next(part.node for part in line.parts if type(part).__name__ == "Factor")
    for t in (0.1, 0.4):
        def of_load(tau, t=t):
            weighed, = evaluate([weight], Floats, {**values, "t": t, "tau": float(tau)})
            return 5 * (15 * tau)**2 * mpmath.exp(-15 * tau) * weighed

        assert vibcli.load(path)[f"x({t} s)"].value == pytest.approx(float(mpmath.quad(of_load, [0, t])), rel=1e-8)


def _sum_of_pieces(lines, known, t):
    """Σ factor·kind(t − t₁), read off the line."""
    total, sign, factor = 0.0, 1.0, 1.0
    parts = list(lines["forced motion"].parts)
    for i, part in enumerate(parts):
        if isinstance(part, str) and part.strip() in ("+", "−"):
            sign = -1.0 if "−" in part else 1.0
        if type(part).__name__ == "Factor":
            factor, = evaluate([part.node], Floats, known)
        if part == "(":
            tau, = evaluate([parts[i + 1]], Floats, {**known, "t": t})
            unit = lines[parts[i - 1].text].parts[3]
            total += sign * factor * evaluate([unit], Floats, {**known, "tau": tau})[0] * (tau > 0)
            sign = factor = 1.0
    return total


@pytest.mark.parametrize(("c", "words"), [("8 N*s/m", "A·cos(ω_d·t)"), ("80 N*s/m", "(B·t + A)·exp(−δ·t)"),
                                          ("100 N*s/m", "A·exp(s₁·t) + B·exp(s₂·t)"), (None, "A·cos(ω·t)")])
def test_free_motions_of_all_regimes(tmp_path, c, words):
    text = oscillator(c=c, more="initial: {x: 3 mm, x': 0.2 m/s}")
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    found, lines = vibcli.load(path), worked(problem(text))
    of = {line.settles: line for line in lines}
    assert any(words in line for line in told(lines))
    A, B = (float(x) for x in re.findall(r"= (-?[\d.]+) (?:m|m/s)(?:,|$)", told([of["free motion"]])[0].replace(
        "−", "-"))[-2:])
    delta, square = (float(c.split()[0]) / 4 if c else 0.0), 400.0
    for t in (0.03, 0.2):
        rate = abs(square - delta**2)**0.5
        if delta**2 < square:
            motion = math.exp(-delta * t) * (A * math.cos(rate * t) + B * math.sin(rate * t))
        elif rate:
            motion = A * math.exp((rate - delta) * t) + B * math.exp((-rate - delta) * t)
        else:
            motion = (A + B * t) * math.exp(-delta * t)
        assert found[f"x({t} s)"].value == pytest.approx(motion, rel=2e-5, abs=1e-9)


def test_a_load_that_grows_is_followed():
    of = lines_of(oscillator("F*t", values={"F": "5 N/s"}))
    assert "x = F·t/k − c·F/k²" in told([of["following(x)"]])[0]


def test_a_condition_is_solved_after_the_letters():
    text = """
parameters: {m: , k: , w: }
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
choose: {k: "omega[1] = w"}
"""
    lines = worked(settled(problem(text)))
    assert "ω² = k/m" in told(lines)[-2] and told(lines)[-1] == "so that ω₁ = w:  k = m·w²"
    lines = worked(settled(problem(text.replace("{m: , k: , w: }", "{m: 2 kg, k: , w: 3 rad/s}"))))
    assert lines[-1].value == pytest.approx(18.0) and "= 18 N/m" in told(lines)[-1]


def test_two_degrees_by_hand():
    """Two equal pendulums that a spring joins (Thomson & Dahleh 1998, section 5.1): g/L and g/L + 2ka²/(mL²)."""
    lines = worked(kept_problem_of(Path("problems/6_two_degrees/coupled_pendulums_beats.yaml")))
    text = told(lines)
    assert any("ω₁² = g/L," in line for line in text)
    assert any("ω₂² = (m·L·g + 2·a²·k)/(m·L²)," in line for line in text)
    assert any(line.endswith("in mode 1  φ₂/φ₁ = 1") for line in text) and any(
        line.endswith("in mode 2  φ₂/φ₁ = −1") for line in text) and text[-1].endswith("period[1]:  2·π/ω₁")


def test_modal_masses_and_ratios_are_the_modes():
    scene = kept_problem_of(Path("vibcli/examples/tuned_absorber.yaml"))
    scene = settled(scene)
    of = {line.settles: line for line in worked(scene)}
    m1, m2, k1, k2 = (scene.numeric.floats[name] for name in ("m1", "m2", "k1", "k2"))
    for mode in (1, 2):
        omega, ratio = of[f"omega[{mode}]"].value, of[f"mode[{mode}][x2]"].value
        assert (k1 + k2 - m1 * omega**2) / k2 == pytest.approx(ratio, rel=1e-9)
        assert (k2 - m2 * omega**2) * ratio == pytest.approx(k2, rel=1e-9)
        assert of[f"modal_mass[{mode}]"].value == pytest.approx(m1 + m2 * ratio**2, rel=1e-12)


def test_damping_in_proportion_is_seen():
    of = lines_of("""
parameters: {m: 1 kg, k: 10 N/m, c: 1 N*s/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {l: {k: k, between: [ground, a]}, m: {k: k, between: [a, b]}}
dampers: {d: {c: c, between: [ground, a]}, e: {c: c, between: [a, b]}}
""")
    assert "it is proportional" in told([of["proportional"]])[0]
    of = lines_of("""
parameters: {m: 1 kg, k: 10 N/m, c: 1 N*s/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {l: {k: k, between: [ground, a]}, m: {k: k, between: [a, b]}}
dampers: {d: {c: c, between: [ground, a]}}
""")
    assert "it is not proportional" in told([of["proportional"]])[0]


def test_three_degrees_are_written_out():
    """Three masses in a row (Rao 2011, section 6.12): det(K − ω²M) by powers of ω², its coefficients by hand, and roots
    that make it vanish."""
    lines = worked(problem("""
parameters: {m: 2 kg, M: 3 kg, k: 7 N/m, c: 5 N/m}
bodies: {a: {mass: m, slide: x}, b: {mass: M, slide: y}, c: {mass: m, slide: z}}
springs: {p: {k: k, between: [ground, a]}, q: {k: c, between: [a, b]}, r: {k: k, between: [b, c]}}
"""))
    of = {line.settles: line.value for line in lines}
    assert of["a3"] == 2 * 3 * 2 and of["a0"] == pytest.approx(7 * 5 * 7)
    assert of["a2"] == pytest.approx(12 * 3 * 2 + 12 * 2 * 2 + 7 * 2 * 3)
    assert of["a1"] == pytest.approx(2 * (12 * 7 - 49) + 3 * 12 * 7 + 2 * (12 * 12 - 25))
    for k in (1, 2, 3):
        x = of[f"omega[{k}]"]**2
        assert of["a3"] * x**3 - of["a2"] * x**2 + of["a1"] * x - of["a0"] == pytest.approx(0, abs=1e-9 * of["a0"])


def test_three_cars_in_letters():
    text = told(worked(kept_problem_of(Path("problems/6_more_degrees/three_car_train.yaml"))))
    assert "ω₂ = √(k/m₁),  x₁ : x₂ : x₃ = 1 : 0 : −1" in text
    assert any(line.startswith("ω₁ = 0,  x₁ : x₂ : x₃ = 1 : 1 : 1") for line in text)


def test_modes_that_whirl_are_complex():
    """M q̈ + G q̇ + K q = 0 by hand: (K₁₁ − ω²M₁₁) u + iωG₁₂ v = 0 with u : v as printed."""
    lines = worked(kept_problem_of(Path("problems/6_two_degrees/unround_shaft.yaml")))
    of = {line.settles: line for line in lines}
    values = kept_problem_of(Path("problems/6_two_degrees/unround_shaft.yaml")).numeric.floats
    m, Omega, k1 = values["m"], values["Omega"], values["k1"]
    for k in (1, 2):
        omega = of[f"omega[{k}]"].value
        line = told([of[f"omega[{k}]"]])[0].replace("−", "-")
        ratio = complex(line.rpartition("1 : ")[2].replace("·i", "j"))
        assert (k1 - m * Omega**2 - m * omega**2) + 1j * omega * (-2 * m * Omega) * ratio == pytest.approx(
            0, abs=2e-5 * abs(m * omega**2))


def read(line, known):
    """The number behind the first `=` of a line, its letters by these values."""
    text = line.partition(" = ")[2].partition(",  its")[0].replace("\u00a0", " ").partition("   (in ")[0]
    for sign, plainly in (("−", "-"), ("·", "*"), ("₁", "1"), ("₂", "2")):
        text = text.replace(sign, plainly)
    names = {"cos": math.cos, "sin": math.sin, "exp": math.exp}
    return eval(text, {"__builtins__": {}}, {**names, **known})


@pytest.mark.parametrize("path", ["vibcli/examples/beats.yaml",
                                  "problems/6_two_degrees/pendulums_beat_in_oiled_bearings.yaml"])
def test_several_degrees_move_from_their_start_as_the_sum_of_their_modes(path):
    """Each coordinate by its line with the numbers of the lines before, as the engine has it."""
    p = vibcli.load(path)
    lines = worked(p._problem)
    known = {}
    for line in lines:
        for name, value in re.findall(r"([ωδ](?:_d)?[₁₂12]) = (?:√\(.*\) = )?([\d.]+)", formula(line.parts, plain)):
            known[name.translate({ord("₁"): "1", ord("₂"): "2"})] = float(value)
    count = 0
    for line in lines:
        text = formula(line.parts, plain)
        if line.settles.startswith(("motion of ", "beat_period(")) and "·t" in text:      # else a number that is asked
            name = line.settles.removeprefix("motion of ").removeprefix("beat_period(").rstrip(")")
            for t in (0.3, 2.1):
                count += 1
                moved = p[f"{name}({t} s)"].value
                assert read(text, {**known, "t": t}) == pytest.approx(moved, rel=2e-3, abs=2e-6), text
    assert count >= 4


def test_coupled_pendulums_beat_in_letters():
    """Two pendulums with a weak spring, one of them drawn aside: θ₁ = A cos ½(ω₂ − ω₁)t cos ½(ω₁ + ω₂)t, θ₂ the product
    of the sines (Thomson, Theory of Vibration, Example 5.2-2)."""
    lines = {line.settles: line for line in worked(problem("""
parameters: {m: , L: , a: , k: , g: , A: }
gravity: g
points: {P: {body: left, at: [0, -a]}, Q: {body: right, at: [1 m, -a]}}
bodies:
  left: {mass: m, at: [0, -L], pin: {at: [0, 0], by: x}}
  right: {mass: m, at: [1 m, -L], pin: {at: [1 m, 0], by: y}}
springs: {s: {k: k, between: [P, Q]}}
initial: {x: A, y: 0}
"""))}
    told = {name: formula(line.parts, plain).replace("\u00a0", " ") for name, line in lines.items()}
    assert told["start of mode 1"] == ("with  q = (x, y)  and the shape of mode 1  u₁ = (1, 1):  "
                                       "p₁(0) = u₁·M·q(0)/(u₁·M·u₁) = A/2,  ṗ₁(0) = 0")
    assert told["start of mode 2"].endswith("p₂(0) = u₂·M·q(0)/(u₂·M·u₂) = A/2,  ṗ₂(0) = 0"), told
    assert told["motion of x"] == "so  x = A·cos(ω₁·t)/2 + A·cos(ω₂·t)/2"
    assert told["motion of y"] == "so  y = A·cos(ω₁·t)/2 − A·cos(ω₂·t)/2"
    assert told["beats of x"].endswith("x = A·cos((ω₂ − ω₁)·t/2)·cos((ω₁ + ω₂)·t/2)")
    assert told["beats of y"].endswith("y = A·sin((ω₂ − ω₁)·t/2)·sin((ω₁ + ω₂)·t/2)")


def test_the_start_of_modes_meets_no_name_of_the_scene():
    """Two coupled masses m and 2m, one drawn aside and the other pushed; p = uᵀM q(0)/uᵀMu by hand. Their coordinates,
    a spring and masses have the letters q, u₁, p₁ and M."""
    p = problem("""
parameters: {M: 2 kg, p1: 800 N/m, A: 0.1 m, v: 1 m/s, L: 1 m}
coordinates: {q: , u1: }
bodies:
  one: {mass: M, at: [0, 0], slide: {along: [1, 0], by: q}}
  two: {mass: 2*M, at: [L, 0], slide: {along: [1, 0], by: u1}}
springs:
  a: {k: p1, between: [[-L, 0], one]}
  b: {k: p1, between: [one, two]}
initial: {q: A, u1': v}
""")
    lines = {line.settles: formula(line.parts, plain) for line in worked(p)}
    for k, root in ((1, -1), (2, 1)):
        x = 2 - (5 + root * 17**0.5) / 4        # (2k − ω²m)/k with ω² = (5 ∓ √17)k/(4m)
        mass = 1 + 2 * x * x
        start, speed = re.findall(r"·D·\S*\(0\)/\(\S*·D·\S*\) = (\S+)\s", lines[f"start of mode {k}"])
        assert float(start) == pytest.approx(0.1 / mass, rel=1e-5)
        assert float(speed.replace("−", "-")) == pytest.approx(2 * x / mass, rel=1e-5), lines
    assert lines["start of mode 1"].startswith("with  q′ = (q, u₁)  and the shape of mode 1  u₁′ = (1, 1.7"), lines


@pytest.mark.parametrize("path", ["vibcli/examples/given_matrices.yaml", "problems/6_two_degrees/unround_shaft.yaml"])
def test_the_determinant_with_gyroscopic_terms(path):
    """a₂ ω⁴ − a₁ ω² + a₀ of the lines vanishes at the frequencies of the engine, and is det(K + iωG − ω²M) of its
    matrices."""
    p = vibcli.load(path)
    lines = {line.settles: line for line in worked(p._problem)}
    M, _, G, K = p._problem.configuration.linear_system.matrices()
    a2, a1, a0 = (lines[name].value for name in ("a2", "a1", "a0"))
    for omega in (3.0, p["omega[1]"].value, p["omega[2]"].value):
        D = [[K.get((i, j), 0) + 1j * omega * G.get((i, j), 0) - omega**2 * M.get((i, j), 0) for j in range(2)]
             for i in range(2)]
        found = D[0][0] * D[1][1] - D[0][1] * D[1][0]
        assert a2 * omega**4 - a1 * omega**2 + a0 == pytest.approx(found.real, abs=1e-9 * a0), omega
    assert abs(a2 * omega**4 - a1 * omega**2 + a0) < 1e-9 * a0
    assert lines["omega[1]"].value == pytest.approx(p["omega[1]"].value) and lines["omega[1]"].node is not None


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["5_forced/trailer_over_a_half_sine_bump",
                                  "7_forced_two_degrees/car_over_a_bump_with_both_axles"])
def test_a_stretch_along_what_drives_it_has_no_root(name):
    """√((H − u)²) is H − u while the road moves, and what begins later has not begun at rest."""
    text = told(worked(kept_problem_of(Path(f"problems/{name}.yaml"))))
    lines = [line for line in text if line.startswith(("stretch of", "speed across", "V_s", "Φ"))]
    assert len(lines) >= 4 and not any("√" in line or "step(−" in line for line in lines), lines
    assert any("h·sin(π·t/t₁)·step(t" in line for line in lines), lines
