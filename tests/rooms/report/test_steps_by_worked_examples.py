"""Worked solutions of the literature and of courses beside ours: loads in pieces, resonance and half power, modes under
pieces of loads; the numbers are those of the source where it quotes any."""

import pytest
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked

SPRING = "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
DAMPED = SPRING + "dampers: {d: {c: c, between: [ground, b]}}\n"
ROAD = """
points: {road: {at: [0, 0], moves: [0, Y*sin(2*pi*v/l*t)]}}
bodies: {car: {mass: m, at: [0, 1 m], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [road, car]}}
dampers: {d: {c: c, between: [road, car]}}
"""
SOURCES = {
    "Masroor, ENGR 12 at Swarthmore, problem set 11: m = 1, b = 2, k = 5, √5, 1/√5, 2 and √3 rad/s": (
        "parameters: {m: 1 kg, c: 2 N*s/m, k: 5 N/m, F: 1 N, w: 2 rad/s}\n" + DAMPED + """
forces: {f: {at: b, force: F*sin(w*t)}}
answers: {"peak[1](frf[x, f]).Omega": 1.732 rad/s, "peak[1](frf[x, f]).value": 0.25 m/N}
""", ("ω = √(5/1) = 2.23607 rad/s", "= 0.447214 < 1: under-damped", "= 2 rad/s",
      "√(k/m − c²/(2·m²)) = 1.73205 rad/s", "1/(c·ω_d) = 0.25 m/N")),
    "Hawley, PHY 2010 at Belmont, problem 10: 221 Hz and Q = 8.27, 26.7 Hz and 208 Hz, of the speed": (
        "parameters: {m: 1 kg, f0: 221 Hz, q: 8.27, k: m*(2*pi*f0)^2, c: sqrt(k*m)/q, F: 1 N, w: 100 rad/s}\n" + DAMPED
        + """
forces: {f: {at: b, force: F*sin(w*t)}}
answers: {"half_power[1](frf[x', f])": 1307 rad/s, "half_power[1](frf[x', f])/(2*pi)": 208 Hz,
          "(half_power[2](frf[x', f]) - half_power[1](frf[x', f]))/(2*pi)": 26.7 Hz}
""", ("at Ω_h  with  (ω² − Ω_h²)² = 4·δ²·Ω_h²", "√(ω² + δ²) − δ = 1307.17 rad/s", "= 208.042",
      "= 26.7231")),
    "Bower, EN 40 at Brown: a car of 0.5 Hz and ζ = 0.2 on waves of 10 m and 20 cm, fastest at 4.8 m/s": (
        "parameters: {m: 1 Mg, f: 0.5 Hz, k: m*(2*pi*f)^2, c: 0.4*sqrt(k*m), l: 10 m, v: 5 m/s, Y: 0.2 m}" + ROAD + """
answers: {"peak[1](frf[y, road]).Omega": 3 rad/s, "Y*peak[1](frf[y, road]).value": 0.55 m}
""", ("= 0.2 < 1: under-damped", "ω²·√(√(8·δ²/ω² + 1) − 1)/(2·δ) = 3.03079 rad/s", "= 0.546784 m")),
    "Ques10, solved: a vehicle of 1200 kg and 400 kN/m, ζ = 0.5, at 20 km/h on waves of 6 m, 0.05 m: 0.0550 m": (
        "parameters: {m: 1200 kg, k: 400 kN/m, c: sqrt(k*m), v: 20 km/h, l: 6 m, Y: 0.05 m}" + ROAD, (
            "ω = √(400000/1200) = 18.2574 rad/s", "= 0.5 < 1: under-damped", "= 0.0550481 m",
            "or, with  r = ", "= 0.318652:  X = Y·√((4·ζ²·r² + 1)/(4·ζ²·r² + (r² − 1)²))")),
    "Filo, solved: a rectangular pulse on an undamped mass, free behind it from where and how fast it is then": (
        "parameters: {m: , k: , P: , td: }\n" + SPRING + """
forces: {f: {at: b, force: P*(step(t) - step(t - td))}}
answers: {x(td): P/k, x'(td): 1 m/s}
""", ("x = P·x_step(t) − P·x_step(t − td)", "from  t = td on  with  τ = t − td:  x = A₂·cos(ω·τ) + B₂·sin(ω·τ)",
      "A₂ = P·x_step(td)", "B₂ = P·ẋ_step(td)/ω", "x(td):  P·(1 − cos(td·ω))/k", "ẋ(td):  P·ω·sin(td·ω)/k")),
    "Filo, solved: a step that falls off evenly from t₁ to t₂, in three intervals": (
        "parameters: {m: 5 kg, k: 2 kN/m, P: 100 N, t1: 0.1 s, t2: 0.25 s}\n" + SPRING + """
forces: {f: {at: b, force: P*(step(t) - ramp(t - t1)/(t2 - t1) + ramp(t - t2)/(t2 - t1))}}
answers: {x(t1): 0 m, x(t2): 0 m, max(x): 0 m, min(x): 0 m}
""", ("x = P·x_step(t) − P/(t₂ − t₁)·x_ramp(t − t₁) + P/(t₂ − t₁)·x_ramp(t − t₂)", "from  t = t₂ on",
      "A₃ = P·x_step(t₂) − P/(t₂ − t₁)·x_ramp(t₂ − t₁) = −0.0118311 m", "min(x):  −√(A₃² + B₃²) = −0.0819711 m",
      "x(t₁):  P·(1 − cos(t₁·ω))/k = 0.0708073 m", "(by a search)", "max(x):  P·x_step(t₁′)", "= 0.0968604 m")),
    "Chopra, Dynamics of Structures, problem 4.16: half a sine as two that begin, free behind it": (
        "parameters: {m: , k: , p0: , td: }\n" + SPRING + """
forces: {f: {at: b, force: p0*sin(pi*t/td)*(step(t) - step(t - td))}}
answers: {x(td): p0/k}
""", ("x_sin(τ) = (sin(Ω·τ) − Ω·sin(ω·τ)/ω)/R", "x = p₀·x_sin(t) + p₀·x_sin(t − td)", "from  t = td on",
      "A₂ = p₀·x_sin(td)", "x(td):  −p₀·Ω·sin(td·ω)/(ω·R)")),
    "Chopra, section 4.8: half a sine of half a period, (sin ωτ − ωτ cos ωτ)/2": (
        "parameters: {m: , k: , p0: , w: sqrt(k/m)}\n" + SPRING + """
forces: {f: {at: b, force: p0*sin(w*t)*(step(t) - step(t - pi/w))}}
answers: {x(pi/w): pi*p0/(2*k)}
""", ("sin ωτ, begun at τ = 0 brings about from rest  x_sin(τ) = (sin(ω·τ) − ω·τ·cos(ω·τ))/(2·k)",
      "x(π/w):  p₀·x_sin(π/w) = π·p₀/(2·k)")),
    "WizEdu, solved: 2 kg, 67.882 N·s/m, 400 N/m from −1 m at 40 m/s, −0.5141 m after 15 ms": (
        "parameters: {m: 2 kg, c: 67.882 N*s/m, k: 400 N/m}\n" + DAMPED + """
initial: {x: -1 m, x': 40 m/s}
answers: {x(0.015 s): -0.5141 m, argmax(x): 0.112 s, "zero[1](x)": 0.046 s}
""", ("= 1.2 > 1: over-damped", "s₁ = √(δ² − ω²) − δ = −7.58978 1/s", "x = A·exp(s₁·t) + B·exp(s₂·t)",
      "x(0.015 s) = −0.514255 m", "ln(−B·s₂/(A·s₁))/(s₁ − s₂) = 0.11244 s", "ln(−B/A)/(s₁ − s₂) = 0.0460958 s")),
    "Modal analysis, a question of eight marks: M = (1, 2), K = (3, −2; −2, 2), shapes (1, 1.366) and (1, −0.366)": ("""
parameters: {m1: 1 kg, m2: 2 kg, k1: 1 N/m, k2: 2 N/m}
bodies: {a: {mass: m1, slide: x1}, b: {mass: m2, slide: x2}}
springs: {s1: {k: k1, between: [ground, a]}, s2: {k: k2, between: [a, b]}}
initial: {x1: 1 m}
answers: {x1(3 s): 0.7 m}
""", ("in mode 1  x₂/x₁ = 1.36603", "in mode 2  x₂/x₁ = −0.366025", "p₁(0) = u₁·M·q(0)/(u₁·M·u₁) = 0.211325 m",
      "so  x₁ = 0.211325·cos(ω₁·t) + 0.788675·cos(ω₂·t)",
      "with  t = 3 s:  0.211325·cos(ω₁·t) + 0.788675·cos(ω₂·t) = 0.70053 m")),
    "University of Alberta, Advanced Dynamics, transient vibrations: a step, F₀/k + A sin + B cos from rest": (
        "parameters: {m: , k: , c: , F0: }\n" + DAMPED + """
forces: {f: {at: b, force: F0*step(t)}}
answers: {max(x): F0/k, argmax(x): 1 s, final(x): F0/k}
""", ("x_step(τ) = (1 − (δ·sin(ω_d·τ)/ω_d + cos(ω_d·τ))·exp(−δ·τ))/k", "zero first at  t = π/ω_d",
      "max(x):  F₀/k + F₀·exp(−π·δ/ω_d)/k", "final(x):  F₀/k")),
    "CE 634 Structural Dynamics, homework: two storeys under a blast that falls off evenly, mode by mode": ("""
parameters: {m: 18 Mg, k: 9 MN/m, F1: 320 kN, F2: 200 kN, td: 0.1 s}
bodies: {lower: {mass: m, slide: x1}, upper: {mass: m, slide: x2}}
springs: {s1: {k: k, between: [ground, lower]}, s2: {k: k, between: [lower, upper]}}
forces: {f: {at: lower, force: F1*(1 - t/td)*(step(t) - step(t - td))},
         g: {at: upper, force: F2*(1 - t/td)*(step(t) - step(t - td))}}
answers: {max(x1): 0 m, x2(td): 0 m, max(s2.force): 0 N}
""", ("with the shape of mode 1  u₁ = (1, 1.61803):  p̈₁ + ω₁²·p₁ = u₁·Q/(u₁·M·u₁) = ",
      "s_k(τ) = (1 − cos(τ·ω_k))/ω_k²", "r_k(τ) = (τ − sin(τ·ω_k)/ω_k)/ω_k²", "so by superposition  p₁ = ",
      "x₁ = p₁ + p₂,  x₂ = 1.61803·p₁ − 0.618034·p₂",
      "max(x₁):  p₁(t₁) + p₂(t₁)", "x₂(td):  1.61803·p₁(td) − 0.618034·p₂(td)", "max(s2.force):  −k·x₁(")),
}


@pytest.mark.parametrize("of", SOURCES)
def test_no_step_of_the_source_is_missing(of):
    """Each in its order, in the lines joined."""
    text, steps = SOURCES[of]
    told = ",  ".join(formula(line.parts, plain) for line in worked(problem(text)) if line.parts).replace("\u00a0", " ")
    place = 0
    for step in steps:
        found = told.find(step, place)
        assert found >= 0, f"{step}\n  is not in\n{told[place:]}"
        place = found
