"""Worked solutions of examples of the literature: the steps on the way to what each asks are in lines of ours, in
order, in our form. Beside each scene stands where its example is from; of several sources the statement alone was at
hand, and of others an excerpt: the numbers of these are ours where the source's are not quoted."""

import re
from typing import NamedTuple

import pytest
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked


class Source(NamedTuple):
    """An example: where it is from, the scene, and the steps to what it asks, as they stand in our lines."""

    of: str
    scene: str
    steps: tuple


PENDULUMS = """
parameters: {m: , L: , a: , k: , g: , A: }
gravity: g
points: {P: {body: left, at: [0, -a]}, Q: {body: right, at: [1 m, -a]}}
bodies:
  left: {mass: m, at: [0, -L], pin: {at: [0, 0], by: x}}
  right: {mass: m, at: [1 m, -L], pin: {at: [1 m, 0], by: y}}
springs: {s: {k: k, between: [P, Q]}}
initial: {x: START}
"""
OSCILLATOR = "parameters: {%s}\nbodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
DAMPED = OSCILLATOR + "dampers: {d: {c: c, between: [ground, b]}}\n"
SOURCES = {
    "weakly_coupled_pendulums": Source(
        "Greiner, Classical Mechanics: Systems of Particles, Exercise 7.2", PENDULUMS.replace("START", "0, y: A"), (
            "x:  m·L²·ẍ + ", "y:  m·L²·ÿ − ", "ω₁² = g/L", "ω₂² = ", "in mode 1  y/x = 1", "in mode 2  y/x = −1",
            "p₁(0) = u₁·M·q(0)/(u₁·M·u₁) = A/2", "p₂(0) = u₂·M·q(0)/(u₂·M·u₂) = −A/2",
            "x = A·cos(ω₁·t)/2 − A·cos(ω₂·t)/2", "x = A·sin((ω₂ − ω₁)·t/2)·sin((ω₁ + ω₂)·t/2)",
            "y = A·cos(ω₁·t)/2 + A·cos(ω₂·t)/2", "y = A·cos((ω₂ − ω₁)·t/2)·cos((ω₁ + ω₂)·t/2)")),
    "beating_pendulums": Source(
        "Thomson, Theory of Vibration with Applications, Example 5.2-2", PENDULUMS.replace("START", "A, y: 0"), (
            "x = A·cos(ω₁·t)/2 + A·cos(ω₂·t)/2", "x = A·cos((ω₂ − ω₁)·t/2)·cos((ω₁ + ω₂)·t/2)",
            "y = A·cos(ω₁·t)/2 − A·cos(ω₂·t)/2", "y = A·sin((ω₂ − ω₁)·t/2)·sin((ω₁ + ω₂)·t/2)")),
    "pendulums_that_change_over": Source(
        "King, Vibrations and Waves, coupled pendulums (0.3 m, 0.95 kg, 1.5 N/m): at rest after about 12 s", """
parameters: {m: 0.95 kg, L: 0.3 m, k: 1.5 N/m, g: 9.81 m/s^2, A: 10 mm}
gravity: g
bodies:
  left: {mass: m, at: [0, 0], slide: x}
  right: {mass: m, at: [1 m, 0], slide: y}
springs:
  one: {k: m*g/L, between: [[-1 m, 0], left]}
  two: {k: m*g/L, between: [right, [2 m, 0]]}
  s: {k: k, between: [left, right]}
initial: {x: A, y: 0}
""", ("ω₁ = 5.71839 rad/s", "ω₂ = 5.98815 rad/s", "x = 0.005·cos(ω₁·t) + 0.005·cos(ω₂·t)",
      "x = 0.01·cos((ω₂ − ω₁)·t/2)·cos((ω₁ + ω₂)·t/2)", "2·π/(ω₂ − ω₁) = 23.29")),
    "pendulum_with_a_tip_mass": Source(
        "Inman, Engineering Vibration, Problem 1.65", """
parameters: {m: , mt: , l: , g: }
gravity: g
points: {B: {body: bar, at: [0, -l]}}
bodies:
  bar: {shape: rod, mass: m, from: [0, 0], to: [0, -l], pin: {at: [0, 0], by: theta}}
  tip: {mass: mt, at: [0, -l], weld: bar}
find: [equations]
""", ("m·l²/3", "T_bar = ", "T_tip = ", "V", "cos θ", "l²·(m/3 + mt)·θ̈ + l·g·(m/2 + mt)·sin θ = 0",
      "to the first order", "ω² = l·g·(m/2 + mt)/(l²·(m/3 + mt)) = 3·g·(m + 2·mt)/(2·l·(m + 3·mt))")),
    "harmonic_force": Source(
        "Vibration lecture notes, chapter 11: F sin ωt on mass, spring and dashpot by the force polygon",
        DAMPED % "m: , k: , c: , F: , w: " + "forces: {f: {at: b, force: F*sin(w*t)}}\n", (
            "m·ẍ + c·ẋ + k·x = F·sin(w·t)", "δ = c/(2·m)", "ζ = δ/ω = c/(2·√(m·k))", "x = X·sin(w·t − θ)",
            "X = F/√(", "tan θ = c·w/(k − m·w²)")),
    "rolling_cylinder": Source(
        "Filo, solved question: a cylinder of 4 kg and 15 cm rolls on a spring of 4000 N/m: 25.8 rad/s, 4.11 Hz", """
parameters: {m: 4 kg, r: 15 cm, k: 4000 N/m}
bodies: {b: {shape: disc, mass: m, radius: r, at: [0, r], roll: {surface: floor, travel: x}}}
surfaces: {floor: {line: [[0, 0], [1 m, 0]]}}
springs: {s: {k: k, between: [[-1 m, r], b]}}
""", ("ω_b = −ẋ/r", "T = m·v_b²/2 + m·r²·ω_b²/4 = 3·m·ẋ²/4", "V = k·Δ²/2 = k·x²/2", "3·m·ẍ/2 + k·x = 0",
      "ω² = k/(3·m/2) = 2·k/(3·m)", "25.8199 rad/s", "f = ω/(2·π) = 4.10936 Hz")),
    "rolling_cylinder_in_letters": Source(
        "Rao, Mechanical Vibrations, Figure 2.106: a cylinder of moment of inertia J on a spring rolls", """
parameters: {m: , J: , R: , k: }
bodies: {b: {shape: disc, mass: m, inertia: J, radius: R, at: [0, R], roll: {surface: floor, travel: x}}}
surfaces: {floor: {line: [[0, 0], [1 m, 0]]}}
springs: {s: {k: k, between: [[-1 m, R], b]}}
""", ("ω_b = −ẋ/R", "T = m·v_b²/2 + J·ω_b²/2 = (m·R² + J)·ẋ²/(2·R²)", "V = k·Δ²/2", "∂T/∂ẋ",
      "∂V/∂x = k·x", "(m·R² + J)·ẍ/R² + k·x = 0", "ω² = R²·k/(m·R² + J)")),
    "car_on_a_wavy_road": Source(
        "Ques10, solved: 1200 kg, 400 kN/m, ζ = 0.5, 20 km/h over waves of 6 m and 5 cm: 5.5 cm", """
parameters: {m: 1200 kg, k: 400 kN/m, zeta: 0.5, c: 2*zeta*sqrt(m*k), Y: 0.05 m, v: 20 km/h, l: 6 m, w: 2*pi*v/l}
points: {S: {at: [0, -1 m], moves: [0, Y*sin(w*t)]}}
bodies: {car: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [S, car]}}
dampers: {d: {c: c, between: [S, car]}}
""", ("ω = √(400000/1200) = 18.2574 rad/s", "0.5 < 1: under-damped", "y = X·sin(", "X = ", "0.0550")),
    "stepped_pulley": Source(
        "Filo, solved question: spring on the small radius, mass on the large one of a pulley, by energies", """
parameters: {m: , J: , r1: , r2: , k: , g: }
gravity: g
bodies:
  pulley: {inertia: J, at: [0, 0], pin: {at: [0, 0], by: theta}}
  load: {mass: m, at: [r2, -1 m], slide: {along: [0, 1], by: r2*theta}}
points: {P: {body: pulley, at: [-r1, 0]}}
springs: {s: {k: k, stretch: r1*theta, preload: static}}
""", ("T_pulley = J·θ̇²/2", "v_load = r₂·θ̇,  T_load = m·v_load²/2", "Δ_s = r₁·θ", "V_s = ", "T = T_pulley + T_load",
      "ω² = r₁²·k/(m·r₂² + J)")),
    "block_over_a_pulley": Source(
        "Physics Forums 716201: a block on a rope over a pulley of mass M, a spring: ω² = 2k/(M + 2m)", """
parameters: {m: , M: , R: , k: , g: }
gravity: g
bodies:
  pulley: {shape: disc, mass: M, radius: R, at: [0, 0], pin: {at: [0, 0], by: y/R}}
  block: {mass: m, at: [R, -1 m], slide: {along: [0, -1], by: y}}
springs: {s: {k: k, stretch: y, preload: static}}
""", ("T_block = m·v_block²/2 = m·ẏ²/2", "V_s = k·Δ_s²/2 + N_s·Δ_s", "N_s = m·g", "ω² = 2·k/(2·m + M)")),
    "clamped_beam": Source(
        "Hadley, TU Graz, Cantilever: cos kL cosh kL = −1, 1.875, 4.694, 7.855, ω = √(EI/μ) k²", """
parameters: {L: 1 m, EI: 400 N*m^2, mu: 1 kg/m}
beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
""", ("EI", "cosh", "1.8751", "4.69409", "7.85476")),
    "slab_with_a_roller": Source(
        "Moloney, Rose-Hulman PH314: a cylinder rolls on a slab that a spring holds", """
parameters: {m: , M: , k: }
coordinates: {x: the slab to the right, z: the cylinder along the slab}
energies:
  T: (m + M)/2*x'^2 + M*x'*z' + 3/4*M*z'^2
  V: k*x^2/2
""", ("T_given = ", "V_given = k·x²/2", "x:  (m + M)·ẍ + M·z̈ + k·x = 0", "z:  M·ẍ + 3·M·z̈/2 = 0", "ω₁ = 0",
      "ω₂ = √(3·k/(3·m + M))")),
    "machine_on_its_mounts": Source(
        "TutorsGlobe, statement: 70 kg, 30 kN/m, ζ = 0.2, 450 N at 13 rad/s",
        DAMPED % "m: 70 kg, k: 30000 N/m, c: 0.4*sqrt(m*k), F: 450 N, w: 13 rad/s"
        + "forces: {f: {at: b, force: F*sin(w*t)}}\n", (
            "ω = √(30000/70) = 20.702 rad/s", "ζ = δ/ω", "0.2 < 1: under-damped", "x = X·sin(w·t − θ)", "X = F/√(",
            "= 0.0228768 m", "tan θ = ", "θ = 0.393134")),
    "unbalanced_machine": Source(
        "Numerade 12116: 2495 kg, 1 MN/m, 3 kN·s/m, 5 kg at 0.7 m with 30 rad/s: 2.5 mm", """
parameters: {m: 2495 kg, k: 1 MN/m, c: 3000 N*s/m, U: 3.5 kg*m, w: 30 rad/s}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [[0, -1 m], b]}}
dampers: {d: {c: c, between: [[0, -1 m], b]}}
forces: {rotor: {at: b, unbalance: U, speed: w}}
""", ("m·ÿ + c·ẏ + k·y = ", "y = X·", "X = ", "= 0.00252", "tan θ = ")),
    "rod_on_two_springs": Source(
        "SolutionInn 4687035: a rod on springs at its ends, √(2k/M) and √(6k/M)", """
parameters: {M: , L: , k: }
points: {A: {body: rod, at: [-L/2, 0]}, B: {body: rod, at: [L/2, 0]}}
bodies: {rod: {shape: rod, mass: M, from: [-L/2, 0], to: [L/2, 0], move: [0, y, theta]}}
springs: {a: {k: k, between: [[-L/2, 1 m], A]}, b: {k: k, between: [[L/2, 1 m], B]}}
""", ("T = M·", "V = V_a + V_b", "y:  M·ÿ + 2·k·y = 0", "θ:  M·L²·θ̈/12 + L²·k·θ/2 = 0", "ω₁² = 2·k/M", "ω₂² = 6·k/M")),
    "two_masses_under_a_force": Source(
        "AnswerHappy 246254: m, 2m on springs 2k, k with 500 N sin 10t on the first", """
parameters: {m: 1 kg, k: 100 N/m, F: 500 N, w: 10 rad/s}
bodies: {one: {mass: m, slide: x1}, two: {mass: 2*m, slide: x2}}
springs: {a: {k: k, between: [ground, one]}, b: {k: k, between: [one, two]}}
forces: {f: {at: one, force: F*sin(w*t)}}
""", ("x₁:  m·ẍ₁ + 2·k·x₁ − k·x₂ = F·sin(w·t)", "x₂:  2·m·ẍ₂ − k·x₁ + k·x₂ = 0", "a₂ = 2·m²", "a₁ = 5·m·k", "a₀ = k²",
      "ω₁ = 4.68213 rad/s", "ω₂ = 15.1022 rad/s", "x₂/x₁", "(K − w²·M)·X = F", "of x₁:  X₁ = ", "of x₂:  X₂ = ")),
    "three_masses": Source(
        "Transtutors 13233519: 4, 2 and 1 kg on 300, 100 and 100 N/m; λ = 100 is a root", """
parameters: {m1: 4 kg, m2: 2 kg, m3: 1 kg, k1: 300 N/m, k2: 100 N/m, k3: 100 N/m}
bodies: {a: {mass: m1, slide: x1}, b: {mass: m2, slide: x2}, c: {mass: m3, slide: x3}}
springs: {p: {k: k1, between: [ground, a]}, q: {k: k2, between: [a, b]}, r: {k: k3, between: [b, c]}}
""", ("mass matrix, in the order  x₁, x₂, x₃:", "stiffness matrix:", "a₃·ω⁶ − a₂·ω⁴ + a₁·ω²",
         "a₃ = ", "a₀ = ", "ω₂ = 10 rad/s", "1 : 0 : −1")),
    "over_damped": Source(
        "WizEdu 345317: 4 kg, 36 N·s/m, 72 N/m, from −3 m with 4 m/s: roots −3 and −6, constants −14/3 and 5/3",
        DAMPED % "m: 4 kg, k: 72 N/m, c: 36 N*s/m" + "initial: {x: -3 m, x': 4 m/s}\n", (
            "m·ẍ + c·ẋ + k·x = 0", "over-damped", "s₁ = √(δ² − ω²) − δ = −3 1/s",
            "s₂ = −δ − √(δ² − ω²) = −6 1/s", "x = A·exp(s₁·t) + B·exp(s₂·t)", "A = ", "−4.66667 m", "B = ",
            "1.66667 m")),
    "critically_damped": Source(
        "Solved example on critical damping: 2 kg, 250 N/m from 0.1 m with −5 m/s: (0.1 − 3.882t)e^(−11.18t)",
        DAMPED % "m: 2 kg, k: 250 N/m, c: 2*sqrt(m*k)" + "initial: {x: 100 mm, x': -5 m/s}\n", (
            "δ = ", "11.1803 1/s", "critically damped", "(B·t + A)·exp(−δ·t)", "A = ", "0.1 m", "B = ",
            "−3.88197 m/s")),
    "tight_string": Source(
        "VTU 10ME72, Vibration of String: c² ∂²y/∂x² = ∂²y/∂t², sin(ωl/c) = 0, ω = nπc/l", """
parameters: {L: 0.65 m, T: 72 N, mu: 4.5 g/m}
strings: {s: {length: L, preload: T, mass_per_length: mu, left: clamped, right: clamped}}
""", ("∂²", "sin", "= 0", "π", "ω₁ = ", "ω₂ = ")),
}


def told(scene):
    return [formula(line.parts, plain).replace("\u00a0", " ") for line in worked(problem(scene))]


@pytest.mark.parametrize("name", SOURCES)
def test_no_step_of_the_source_is_missing(name):
    """Each of its steps, in its order, in the lines joined."""
    source = SOURCES[name]
    text, at = "\n".join(told(source.scene)), 0
    for step in source.steps:
        found = re.compile(re.escape(step)).search(text, at)
        assert found, f"{source.of}: {step}\n{text}"
        at = found.start() + 1


def test_there_are_twenty_sources():
    assert len({source.of for source in SOURCES.values()}) == len(SOURCES) == 20
