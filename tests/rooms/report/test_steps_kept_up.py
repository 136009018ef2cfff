"""What worked solutions tell in letters of what a load keeps up: peaks, half-power points and lags, also of scenes in
numbers."""

import pytest
from numpy import roots
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

DRIVEN = """
parameters: {{m: {m}, k: {k}, c: {c}, F0: {F}, w: {w}}}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
dampers: {{d: {{c: c, between: [ground, b]}}}}
forces: {{f: {{at: b, force: F0*{wave}(w*t)}}}}
answers: {{{asked}}}
"""
SHAKEN = """
parameters: {m: 2 kg, k: 800 N/m, c: 9 N*s/m, Y: 1 mm, w: 7 rad/s}
points: {base: {at: [0, 0], moves: [0, Y*sin(w*t)]}}
bodies: {b: {mass: m, at: [0, 1 m], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [base, b]}}
dampers: {d: {c: c, between: [base, b]}}
answers: {"peak[1](frf[s.stretch, base]).Omega": 1 rad/s, "half_power[1](frf[s.stretch, base])": 1 rad/s,
          "half_power[2](frf[s.stretch, base])": 1 rad/s, phase(s.stretch): 0}
"""
LETTERS = dict.fromkeys("mkcFw", "")
NUMBERS = {"m": "2 kg", "k": "800 N/m", "c": "9 N*s/m", "F": "3 N", "w": "7 rad/s"}


def told(text):
    return {line.settles: line for line in worked(problem(text))}


def shown(line):
    return formula(line.parts, plain).replace("\u00a0", " ")


def halves(power, m=2.0, k=800.0, c=9.0):
    """(Ω of the peak, [Ω] of half its square) of uⁿ/((k − m u)² + c² u), u = Ω², n being 0 or 2."""
    below = [m * m, c * c - 2 * m * k, k * k]
    top = -below[1] / (2 * below[0]) if power == 0 else -2 * below[2] / below[1]
    half = top**power / (below[0] * top * top + below[1] * top + below[2]) / 2
    left = [half * factor for factor in below]
    left[2 - power] -= 1
    return top**0.5, sorted(u.real**0.5 for u in roots(left))


PEAK = {"peak[1](frf[x, f]).Omega": "1 rad/s", "half_power[1](frf[x, f])": "1 rad/s",
        "half_power[2](frf[x, f])": "1 rad/s"}


def asked(record):
    return ", ".join(f'"{key}": {value}' for key, value in record.items())


@pytest.mark.sweep
def test_half_power_points_are_told_by_the_letters_of_the_damped_oscillation():
    of = told(DRIVEN.format(**LETTERS, wave="sin", asked=asked(PEAK)))
    assert shown(of["half_power[1](frf[x, f])"]) == (
        "half_power[1](frf[x, f]):  |H|² is half of that at its peak at Ω_h  with  (ω² − 2·δ² − Ω_h²)² = 4·δ²·ω_d²:  "
        "√(ω² − 2·δ² − 2·δ·ω_d)")
    assert shown(of["half_power[2](frf[x, f])"]) == "half_power[2](frf[x, f]):  √(ω² − 2·δ² + 2·δ·ω_d)"


@pytest.mark.parametrize(("scene", "power"), [
    (DRIVEN.format(**NUMBERS, wave="sin", asked=asked(PEAK)), 0), (SHAKEN, 2)], ids=["driven", "shaken"])
def test_peaks_and_half_power_points_of_scenes_in_numbers_have_letters(scene, power):
    top, sides = halves(power)
    found = {key.split("(")[0]: line for key, line in told(scene).items() if "(frf" in key}
    for key, value in zip(("peak[1]", "half_power[1]", "half_power[2]"), (top, *sides), strict=True):
        assert found[key].value == pytest.approx(value, rel=1e-9) and found[key].unit == "rad/s"
        assert any(letter in shown(found[key]) for letter in ("ω", "√"))


@pytest.mark.parametrize(("wave", "wanted"), [("sin", ""), ("cos", "phase(x):  θ − π/2 = ")])
def test_the_lag_of_a_coordinate_is_told_once_by_its_letter(wave, wanted):
    of = told(DRIVEN.format(**NUMBERS, wave=wave, asked="phase(x): 0"))
    lines = [shown(line) for line in of.values() if line.number == of["phase(x)"].number]
    assert shown(of["phase(x)"]).startswith(wanted) and of["theta"].value > 0 and of["phase(x)"].node is not None
    assert sum("θ = 0." in line for line in lines) == (wave == "sin") == (shown(of["phase(x)"]) == "")
    assert of["phase(x)"].value == pytest.approx(of["theta"].value - (wave == "cos") * 1.5707963267948966, rel=1e-9)


@pytest.mark.sweep
def test_a_lag_whose_expression_fills_more_than_three_lines_is_told_by_its_number():
    of = told("""
        parameters: {m: 2 kg, k1: 800 N/m, k2: 300 N/m, c1: 9 N*s/m, c2: 7 N*s/m, Y: 1 mm, Z: 2 mm, w: 7 rad/s,
                     p: 20 deg}
        points: {left: {at: [0, 0], moves: [Y*sin(w*t), 0]}, right: {at: [3 m, 0], moves: [Z*sin(w*t + p), 0]}}
        bodies: {b: {mass: m, at: [1 m, 0], slide: x}}
        springs: {s: {k: k1, between: [left, b]}, r: {k: k2, between: [b, right]}}
        dampers: {d: {c: c1, between: [left, b]}, e: {c: c2, between: [b, right]}}
        answers: {phase(s.force + e.force): 0}
        """)
    line = of["phase(s.force + e.force)"]
    assert line.node is None and shown(line).startswith("phase(s.force + e.force) = ")
