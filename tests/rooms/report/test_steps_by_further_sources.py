"""Further worked solutions of examples of the literature beside ours, chosen for what loads that begin, chosen
parameters, starts and answers ask of the lines; the numbers are ours where the source's are not quoted."""

import pytest
from support.scenes import problem

from vibcli.inverse import settled
from vibcli.notation.plain import plain
from vibcli.report.document import Report
from vibcli.report.formats.formula import formula
from vibcli.report.sections.parameters import given
from vibcli.report.steps.worked import worked

SPRING = "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
DAMPED = SPRING + "dampers: {d: {c: c, between: [ground, b]}}\n"
SOURCES = {
    "Khurmi, Theory of Machines, a system of 8 kg, 5.4 N/mm, 40 N at 1 m/s: 0.096 and 1.836": (
        "parameters: {m: 8 kg, k: 5.4 N/mm, c: 40 N*s/m}\n" + DAMPED + """
initial: {x: 1 cm}
answers: {decrement(x): 0.607418, exp(decrement(x)): 1.83569}
""", ("= 0.096225 < 1: under-damped", "decrement(x):  2·π·δ/ω_d = 0.607418", "exp(decrement(x)) = 1.83569")),
    "Filo, solved question: a cannon of 52 kg returns to 5 mm of 50 cm in 0.5 s, critically damped": (
        "parameters: {m: 52 kg, x0: 50 cm, x1: 5 mm, t1: 0.5 s}\n" + DAMPED + """
initial: {x: x0}
choose: {c: {so: "zeta[1] = 1", from: 1 kN*s/m, to: 2 kN*s/m}, k: {so: "x(t1) = x1", from: 5 kN/m, to: 20 kN/m}}
""", ("= 1: critically damped", "x = (B·t + A)·exp(−δ·t)", "B = x₀·δ",
      "so that x(t₁) = x₁:  (t₁·B + A)·exp(−t₁·δ) = x₁,  k = 9166.09 N/m")),
    "Thomson, a trailer whose springs sag by 100 mm on waves of 16 m and 75 mm at 64 km/h": ("""
parameters: {m: , d: 100 mm, Y: 75 mm, l: 16 m, v: 64 km/h, g: 9.81 m/s^2, k: m*g/d, W: 2*pi*v/l}
gravity: g
points: {road: {at: [0, 0], moves: [0, Y*sin(W*t)]}}
bodies: {trailer: {mass: m, at: [0, 1 m], slide: {along: [0, 1], by: x}}}
springs: {s: {k: k, between: [road, trailer], preload: static}}
""", ("ω² = (m·g/d)/m = g/d,  ω = √(9.81/0.1) = 9.90454 rad/s",
      "X = Y·g/(g − d·W²) = 0.075·9.81/(9.81 − 0.1·6.98132²) = 0.149054 m",
      "or, with  r = W/ω = 0.70486:  X = Y/(1 − r²)")),
    "Thomson, on rotating unbalance: an exciter of 0.0921 kg·m on 181.4 kg, a quarter of a turn behind at 900 rpm": ("""
parameters: {m: 181.4 kg, u: 0.0921 kg*m, n: 900 rpm, k: m*n^2, X1: 21.6 mm, c: u*n/X1}
bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: x}}}
springs: {s: {k: k, between: [[0, -1 m], b]}}
dampers: {d: {c: c, between: [[0, -1 m], b]}}
forces: {rotor: {at: b, unbalance: u, speed: n}}
""", ("ζ = δ/ω = c/(2·√(m·k)) = 0.0117527", "= 0.0216 m", "k − m·n² = 0:  θ = 1.5708 rad")),
    "Filo, Duhamel's integral of a rectangular pulse on a mass that starts from rest": (
        "parameters: {m: 20 kg, k: 8 kN/m, P: 300 N, t0: 0.1 s}\n" + SPRING + """
forces: {f: {at: b, force: P*(step(t) - step(t - t0))}}
initial: {x: 0}
""", ("x_step(τ) = (1 − cos(ω·τ))/k", "x = P·x_step(t) − P·x_step(t − t₀)")),
    "Chopra, Dynamics of Structures, chapter 2: a mass falls on a sprung one and stays": ("""
parameters: {m1: 5 kg, m2: 2 kg, k: 3 kN/m, h: 0.4 m, g: 9.81 m/s^2}
gravity: g
bodies: {a: {mass: m1, at: [0, 0], slide: {along: [0, -1], by: u}}, b: {mass: m2, at: [0, 0], weld: a}}
springs: {s: {k: k, between: [[0, -0.5 m], a], preload: -m1*g}}
initial: {u: 0, u': m2*sqrt(2*g*h)/(m1 + m2)}
answers: {max(u): m2*g/k*(1 + sqrt(1 + 2*h*k/((m1 + m2)*g)))}
""", ("u = m₂·g/k = 0.00654 m", "ω² = k/(m₁ + m₂)", "u̇ = v₀ = m₂·√(2·h·g)/(m₁ + m₂) = 0.800408 m/s", "B = v₀/ω",
      "max(u):  m₂·g/k + √(A² + B²) = 0.0457526 m")),
    "Ques10, solved: a cylinder rolls in a round trough, ω² = 2g/(3(R − r))": ("""
parameters: {m: , R: , r: , g: }
gravity: g
surfaces: {trough: {circle: [0, 0], radius: R, side: inside}}
bodies: {c: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: trough, swing: theta}}}
""", ("v_c = (R − r)·θ̇", "T = m·v_c²/2 + m·r²·ω_c²/4 = 3·m·(R − r)²·θ̇²/4", "3·m·(R − r)²·θ̈/2 + m·g·(R − r)·θ = 0",
      "ω² = m·g·(R − r)/(3·m·(R − r)²/2) = 2·g/(3·(R − r))")),
    "Kibble & Berkshire, Classical Mechanics, section 11.3, of equal parts: 2 ∓ √2": ("""
parameters: {m: , a: , g: }
gravity: g
bodies:
  upper: {mass: m, at: [0, -a], pin: {at: [0, 0], by: x}}
  lower: {mass: m, at: [0, -2*a], pin: {at: [0, -a], carrier: upper, by: y}}
""", ("a₂ = m²·a⁴", "ω₁² = (2 − √2)·g/a", "y/x = 2·(g − a·ω²)/(a·ω²)", "in mode 1  y/x = √2")),
    "Testbook, two rotors on a shaft: the node divides it as the other inertias": ("""
parameters: {J1: 0.3 kg*m^2, J2: 0.6 kg*m^2, L: 1.5 m, d: 70 mm, G: 84 GPa, kt: G*pi*d^4/(32*L)}
bodies: {one: {inertia: J1, turn: x}, two: {inertia: J2, turn: y}}
springs: {s: {torsion: kt, between: [one, two]}}
""", ("a₀ = 0", "ω² = 0  or  ω² = a₁/a₂ = 118802/0.18", "ω₂ = 812.41 rad/s", "in mode 2  y/x = −0.5")),
    "Virtual Labs NITK, the tuned absorber: X₁ = 0, X₂ = −F₀/k₂": ("""
parameters: {m1: , k1: , m2: , F0: , w: , k2: m2*w^2}
bodies: {machine: {mass: m1, slide: x1}, absorber: {mass: m2, slide: x2}}
springs: {s1: {k: k1, between: [ground, machine]}, s2: {k: k2, between: [machine, absorber]}}
forces: {drive: {at: machine, force: F0*sin(w*t)}}
""", ("ratio of amplitudes", "ω₁ = ", "Z₂₂ = 0", "D = Z₁₁·Z₂₂ − Z₁₂²", "X₁ = Z₂₂·F₁/D = 0",
      "X₂ = −Z₁₂·F₁/D = −F₀/(m₂·w²)")),
    "Rao, Mechanical Vibrations, Example 5.3: 5/7 and 2/7 of a start of 1, 10/7 of the other": ("""
parameters: {m1: 10 kg, m2: 1 kg, k1: 30 N/m, k2: 5 N/m, X: 1 m}
bodies: {a: {mass: m1, slide: x1}, b: {mass: m2, slide: x2}}
springs: {s1: {k: k1, between: [ground, a]}, s2: {k: k2, between: [a, b]}}
initial: {x1: X}
""", ("K = [k₁ + k₂, −k₂; −k₂, k₂] = [35, −5; −5, 5] N/m",
      "a₂ = m₁·m₂ = 10", "(85 ∓ 35)/20", "ω₁ = 1.58114 rad/s", "x₂/x₁ = 2", "x₂/x₁ = −5",
      "x₁ = 0.714286·cos(ω₁·t) + 0.285714·cos(ω₂·t)   (in m)", "x₂ = 1.42857·cos(ω₁·t) − 1.42857·cos(ω₂·t)   (in m)")),
    "Rao, Vibration of Continuous Systems, chapter 9: the node of a clamped bar's second mode is at 2L/3": ("""
parameters: {L: 1.8 m, A: 4 cm^2, E: 210 GPa, rho: 7850 kg/m^3}
bars: {rod: {length: L, E: E, A: A, rho: rho, left: clamped}}
answers: {"node[2][rod, 1]": 2*L/3}
""", ("cos βL = 0", "node[2][rod, 1] = 1.2 m   (there the mode does not move)")),
}


@pytest.mark.parametrize("of", SOURCES)
def test_no_step_of_the_source_is_missing(of):
    """Each in its order, in the lines joined."""
    scene, steps = SOURCES[of]
    lines = worked(settled(problem(scene)))
    text, at = "\n".join(formula(line.parts, plain).replace("\u00a0", " ") for line in lines), 0
    for step in steps:
        assert step in text[at:], f"{of}: {step}\n{text}"
        at = text.index(step, at) + 1


def test_what_letters_define_has_its_number_under_given():
    """A formula, not what is a number as it stands; of letters without numbers the formula alone."""
    scene = problem("parameters: {k: 400 kN/m, M: 1200 kg, z: 0.5, c: 2*z*sqrt(k*M), r: z/2, m: , p: m/2}\n" + DAMPED
                    + "forces: {f: {at: b, force: r*p*sin(t*1 rad/s)*1 m/s^2}}")
    (found,) = given(scene, Report)
    told = "".join(part if isinstance(part, str) else formula(part.parts, plain)
                   for block in found.blocks for item in getattr(block, "items", ()) for part in (*item.term, "; "))
    assert "c = 2·z·√(k·M) = 21908.9 N·s/m; r = z/2 = 0.25; p = m/2; " in told.replace("\u00a0", " ")
