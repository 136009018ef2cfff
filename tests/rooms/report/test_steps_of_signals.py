"""What answers of a scene in letters ask of its motion: values at instants, beats, extremes and envelopes by the
letters of lines; lags and responses; and what is left to numbers is named."""

import math
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, kept_settled_of, problem
from support.worked_lines import Checked, told_later

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.step import WorkedLine
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

TWO = """
parameters: {m: , k: , q: , PARAMETERS}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {l: {k: k, between: [ground, a]}, r: {k: k, between: [b, ground]}, s: {k: q, between: [a, b]}}
%s
"""
VALUES = {"m": 2.0, "k": 50.0, "q": 7.0, "A": 0.02, "V": 0.3, "T": 1.3, "c": 0.8}
DAMPED = """
        parameters: {m: , c: , k: , F: , W: }
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: c, between: [ground, b]}}"""


def two(parameters, rest):
    return TWO.replace("PARAMETERS", ", ".join(f"{name}: " for name in parameters)) % rest


def lines_of(text):
    return {line.settles: line for line in worked(problem(text))}


def text_of(line):
    return formula(line.parts, plain).replace("\u00a0", " ")


def value_of(lines, asked):
    """By the lines: their letters first."""
    known = dict(VALUES)
    for line in lines.values():
        if line.letter and line.node is not None:
            known[line.letter], = evaluate([line.node], Floats, known)
    return evaluate([lines[asked].node], Floats, known)[0]


@pytest.mark.sweep
def test_values_and_beats_of_two_oscillators_by_hand():
    """Mass a is struck; x ± y swing by themselves."""
    lines = lines_of(two("AVT", "initial: {x: A, x': V}\nanswers: {x(T): 0 m, s.stretch(T): 0 m, r.force(T): 0 N,"
                     " beat_period(x): 1 s, envelope(y)(T): 0 m, y'(T): 0 m/s}"))
    slow, fast = 5.0, math.sqrt(64 / 2)
    sum_, difference = (0.02 * math.cos(w * 1.3) + 0.3 / w * math.sin(w * 1.3) for w in (slow, fast))
    assert value_of(lines, "x(T)") == pytest.approx((sum_ + difference) / 2)
    assert value_of(lines, "s.stretch(T)") == pytest.approx(-difference)
    assert value_of(lines, "r.force(T)") == pytest.approx(-50 * (sum_ - difference) / 2)
    assert value_of(lines, "beat_period(x)") == pytest.approx(2 * math.pi / (fast - slow))
    rates = [-0.02 * w * math.sin(w * 1.3) + 0.3 * math.cos(w * 1.3) for w in (slow, fast)]
    assert value_of(lines, "y'(T)") == pytest.approx((rates[0] - rates[1]) / 2)
    one, other = (complex(0.02, -0.3 / w) / 2 for w in (slow, fast))
    turned = abs(one - other * complex(math.cos(1.3 * (fast - slow)), math.sin(1.3 * (fast - slow))))
    assert value_of(lines, "envelope(y)(T)") == pytest.approx(turned)


def test_extremes_that_have_a_formula_and_those_that_have_none_by_name():
    """x is largest as it is let go; the stretch between is one vibration; of y two are added."""
    lines = lines_of(two("A", "initial: {x: A}\nanswers: {max(x): A, argmax(x): 0 s, min(s.stretch): 0 m}"))
    assert text_of(lines["max(x)"]).endswith("max(x):  A") and lines["argmax(x)"].node.is_zero
    assert plain(lines["min(s.stretch)"].node) == "−A"
    left, = (text_of(line) for line in worked(problem(two("A", "initial: {x: A}\nanswers: {max(y): 0 m}")))
             if "--set" in text_of(line))
    assert left == ("where several vibrations at once turn back is a root of an equation without a formula; in numbers "
                    "(--set):  max(y)")


def test_damping_in_proportion_leaves_modes_apart_in_letters():
    damped = two("ATc", (
        "dampers: {d: {c: c, between: [ground, a]}, e: {c: c, between: [ground, b]}}\ninitial: {x: A}\n"
        "answers: {y(T): 0 m}"))
    found = value_of(lines_of(damped), "y(T)")
    delta, waves = 0.8 / 4, []
    for w in (5.0, math.sqrt(32)):
        rate = math.sqrt(w**2 - delta**2)
        waves.append(math.cos(rate * 1.3) + delta / rate * math.sin(rate * 1.3))
    assert found == pytest.approx(0.01 * math.exp(-1.3 * delta) * (waves[0] - waves[1]))


def test_coordinates_that_nothing_couples_have_no_modal_masses_and_a_zero_is_told():
    lines = lines_of("""
        parameters: {m: , k: , q: , A: , w: sqrt(k/m), v: sqrt((k + q)/m), T: pi/(v - w)}
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
        springs: {l: {k: k, between: [ground, a]}, r: {k: k + q, between: [ground, b]}}
        initial: {x: A, y: -A}
        answers: {(x - y)(T): 0 m, x(pi/w): -A}
    """)
    assert not any(name.startswith("start of mode") for name in lines)
    assert lines["(x - y)(T)"].node.is_zero and text_of(lines["(x - y)(T)"]).endswith(" = 0")
    assert text_of(lines["x(pi/w)"]).endswith("x(π/w):  −A")


def test_letters_that_leave_the_order_of_frequencies_open_leave_the_motion():
    lines = lines_of("""
        parameters: {m: , k: , q: , A: , T: }
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
        springs: {l: {k: k, between: [ground, a]}, r: {k: q, between: [ground, b]}}
        initial: {x: A, y: -A}
        answers: {x(T): 0 m}
    """)
    assert "told in numbers alone (--set):  x(T)" in text_of(lines[""]) and "motion of x" not in lines


@pytest.mark.sweep
def test_where_several_coordinates_start_as_a_force_lets_go():
    lines = lines_of(two("P", (
        "forces: {pull: {at: b, force: P}}\ninitial: {released: pull}\nanswers: {x(0 s): 0 m}")))
    assert plain(lines["x(0 s)"].node) == "q·P/(k·(k + 2·q))"


def test_lags_and_responses_at_a_frequency_with_a_unit():
    lines = lines_of(DAMPED + """
        forces: {f: {at: b, force: F*sin(W*t)}}
        answers: {phase(x): 0 rad, "abs(frf[x, f](40 Hz))": 1 m/N, "peak[1](frf[x, f]).Omega": 1 rad/s,
                  mean(d.power): 1 W, mean(x^4): 1 m^4}
    """)
    assert plain(lines["phase(x)"].node) == "atan2(c·W, k − m·W²)"
    assert text_of(lines["abs(frf[x, f](40 Hz))"]).endswith("with  Ω₁ = 80·π rad/s:  1/√((m·Ω₁² − k)² + c²·Ω₁²)")
    assert plain(lines["peak[1](frf[x, f]).Omega"].node) == "√(k/m − c²/(2·m²))"
    assert plain(lines["mean(d.power)"].node) == "c·W²·X²/2" and plain(lines["mean(x^4)"].node) == "3·X⁴/8"
    assert not any("told in numbers alone" in text_of(line) for line in lines.values())


def test_what_is_damped_so_that_it_just_does_not_swing_moves_so_once_that_is_chosen():
    """x = v t e^{−ωt} of a mass that is struck: farthest at 1/ω, at v/(e ω)."""
    from vibcli.inverse import settled

    lines = {line.settles: line for line in worked(settled(problem("""
        parameters: {m: , k: , v: , T: }
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        dampers: {d: {c: c, between: [ground, b]}}
        initial: {x': v}
        choose: {c: "zeta[1] = 1"}
        answers: {max(x): 1 m, argmax(x): 1 s, max(s.force): 1 N, x(T): 1 m}
    """)))}
    assert text_of(lines["x"]) == "x = (B·t + A)·exp(−δ·t)" and "omega_d[1]" not in lines
    assert [plain(lines[asked].node) for asked in ("argmax(x)", "max(x)", "max(s.force)", "x(T)")] == [
        "1/δ", "B·exp(−1)/δ", "k·B·exp(−1)/δ", "(T·B + A)·exp(−T·δ)"]


@pytest.mark.sweep
def test_letters_of_multipliers_and_of_forces_are_told_before_they_are_used():
    thread = """
        parameters: {m: 0.4 kg, L: 1.1 m, g: 9.81 m/s^2}
        coordinates: {x: displacement, y: rise}
        gravity: g
        points: {O: [0, 0]}
        bodies: {ball: {mass: m, at: [0, -L], move: [x, y, 0]}}
        constraints: {thread: {link: [O, ball]}}
    """
    full = problem(thread + "    motion: full\n        initial: {x: L/2}\n        answers: {max(thread.force): 1 N}\n")
    lines = worked(full)
    told = [text_of(line) for line in lines]
    assert not told_later(full, lines) and not any("S_thread" in text for text in told)
    assert any(text.endswith("multiplier:  λ_thread for 'thread'") for text in told)
    resting = problem(thread + "    answers: {\"equilibrium[thread.force]\": m*g}\n")
    lines = worked(resting)
    assert not told_later(resting, lines) and "cut free, with  S_thread for thread.force" in map(text_of, lines)


def test_a_letter_that_no_line_tells_is_seen():
    scene = problem("parameters: {m: , k: }\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\n")
    table = scene.scene.table
    line = WorkedLine(1, "", (), ("x", " = ", table.parameter("lambda_s") * table.parameter("k")))
    assert told_later(scene, [line]) == [(1, "lambda_s")]


def test_a_load_that_begins_at_rest_beats_with_the_free_motion():
    """x = F (sin Wt − W/w sin wt)/(k − mW²) of what nothing damps."""
    lines = lines_of("""
        parameters: {m: , k: , F: , W: , T: }
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        forces: {f: {at: b, force: F*sin(W*t)}}
        answers: {x(T): 0 m, beat_period(x): 1 s, s.force(T): 0 N, envelope(x)(T): 0 m}
    """)
    known = {"m": 2.0, "k": 50.0, "F": 3.0, "W": 4.5, "T": 1.3}
    for line in lines.values():
        if line.letter and line.node is not None:
            known[line.letter], = evaluate([line.node], Floats, known)
    X, ratio = 3 / (50 - 2 * 4.5**2), 4.5 / 5
    x = X * (math.sin(4.5 * 1.3) - ratio * math.sin(5 * 1.3))
    wanted = {"x(T)": x, "beat_period(x)": 2 * math.pi / 0.5, "s.force(T)": 50 * x,
              "envelope(x)(T)": X * math.sqrt(1 + ratio**2 - 2 * ratio * math.cos(0.5 * 1.3))}
    assert {asked: evaluate([lines[asked].node], Floats, known)[0] for asked in wanted} == pytest.approx(wanted)


def test_passages_through_zero_in_letters():
    lines = lines_of("""
        parameters: {m: , k: , v: }
        bodies: {b: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, b]}}
        initial: {x': v}
        answers: {"zero[2](x)": 1 s, "zero[1](x')": 1 s, "mean(x^2)": 1 m^2}
    """)
    known = {"m": 2.0, "k": 50.0, "v": 0.3}
    for line in lines.values():
        if line.letter and line.node is not None:
            known[line.letter], = evaluate([line.node], Floats, known)
    wanted = {"zero[2](x)": math.pi / 5, "zero[1](x')": math.pi / 10, "mean(x^2)": (0.3 / 5) ** 2 / 2}
    assert {asked: evaluate([lines[asked].node], Floats, known)[0] for asked in wanted} == pytest.approx(wanted)


@pytest.mark.sweep
def test_two_modes_whose_frequencies_have_long_formulas_have_letters():
    lines = lines_of("""
        parameters: {m: , n: , k: , q: , A: , V: , T: }
        bodies: {a: {mass: m, slide: x}, b: {mass: n, slide: y}}
        springs: {l: {k: k, between: [ground, a]}, s: {k: q, between: [a, b]}}
        initial: {x: A, y': V}
        answers: {y(T): 0 m, s.stretch(T): 0 m}
    """)
    known = {"m": 2.0, "n": 1.0, "k": 50.0, "q": 20.0, "A": 0.02, "V": 0.3, "T": 1.3}
    for line in lines.values():
        if line.letter and line.node is not None:
            known[line.letter], = evaluate([line.node], Floats, known)
    places = {"x": 0.0, "y": 0.0}           # det = 2 w⁴ − 110 w² + 1000
    for w2 in ((110 + sign * math.sqrt(110**2 - 8000)) / 4 for sign in (-1, 1)):
        w, r = math.sqrt(w2), (70 - 2 * w2) / 20
        wave = (2 * 0.02 * math.cos(w * 1.3) + r * 0.3 * math.sin(w * 1.3) / w) / (2 + r * r)
        places = {"x": places["x"] + wave, "y": places["y"] + r * wave}
    found = {asked: evaluate([lines[asked].node], Floats, known)[0] for asked in ("y(T)", "s.stretch(T)")}
    assert found == pytest.approx({"y(T)": places["y"], "s.stretch(T)": places["y"] - places["x"]})


def test_harmonics_of_a_square_wave_that_are_asked_in_letters():
    lines = lines_of(DAMPED + """
        forces: {f: {at: b, force: F*square(W*t)}}
        answers: {"harmonic[3](x)": 1 m}
    """)
    found, = evaluate([lines["harmonic[3](x)"].node], Floats, {"m": 2.0, "c": 0.8, "k": 50.0, "F": 3.0, "W": 2.0})
    assert found == pytest.approx(4 * 3 / (3 * math.pi) / math.hypot(50 - 2 * 36, 0.8 * 6)) and len(lines) > 3
    assert not any(line.startswith("harmonic[1]") for line in lines)


@pytest.mark.sweep
def test_the_force_of_a_thread_that_swings_wide_is_derived():
    """m(v²/L + g cos α) of the ball at any place of its circle, by Newton, from the line of its multiplier."""
    path = Path("problems/3_free_undamped/ball_let_go_on_a_thread.yaml")
    lines: dict = {}
    for line in worked(kept_problem_of(path)):
        lines.setdefault(line.settles, line)
    m, L, g, alpha, speed = 0.4, 1.1, 9.81, 0.7, 1.3
    place = {"x": L * math.sin(alpha), "y": L * (1 - math.cos(alpha)), "x'": speed * math.cos(alpha),
             "y'": speed * math.sin(alpha)}
    found = evaluate([lines["thread.force"].node], Floats, {"m": m, "L": L, "g": g, **place})[0]
    assert found == pytest.approx(m * (speed**2 / L + g * math.cos(alpha)), rel=1e-12)
    assert text_of(lines["thread.force"]).startswith("by these and the equations  thread.force = λ_thread = ")
    assert text_of(lines["rate[thread]"]).endswith("x·ẍ/L − ÿ + y·ÿ/L + ẋ²/L + ẏ²/L = 0")


@pytest.mark.parametrize(("name", "asked", "told"), [
    ("motor_raised_on_a_hinged_beam", "amplitude(s.force + d.force)", "L·X·√(k² + c²·Ω²) = "),
    ("seismograph_with_level_boom", "amplitude(weight.y - frame.y)", "L·X"),
    ("compressor_to_be_isolated", "amplitude(ground.force)", "4·X·√(c²·Ω² + k²) = 90 N"),
    ("inerter_under_a_machine", "amplitude(ground.force)", "|k₂·X₁| = "),
    ("inerter_under_a_machine", "amplitude(i.force)", "|b·Ω²·(X₁ − X₂)| = "),
    ("block_between_two_shaken_walls", "amplitude(s1.force)", "|k₁·X·exp(−i·θ) − k₁·Y₁| = ")])
def test_amplitudes_of_signals_go_by_the_letter_of_that_of_the_coordinate(name, asked, told):
    """A force of the ground too, and one that accelerations add to."""
    path, = Path("problems").glob(f"*/{name}.yaml")
    found = kept_settled_of(path)
    lines = worked(found)
    line = next(line for line in lines if line.settles == asked)
    assert formula(line.parts, plain).partition(":  ")[2].startswith(told)
    assert not Checked(found, lines).wrong
