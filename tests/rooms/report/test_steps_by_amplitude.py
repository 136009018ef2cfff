"""Steps to backbones: the lines alone give, by other means, what they end with."""

import math
import re

import pytest
from scipy.integrate import quad
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

BLOCK = """
parameters: {m: 2 kg, k: 80 N/m, g2: 120 N/m^2, g3: 500 N/m^3}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + g2*d^2 + g3*d^3, between: [ground, block]}}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 0.8 m, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
"""


def lines_of(text):
    return worked(problem(text))


def told(lines):
    return [re.sub("[\u00a0\u202f]", " ", formula(line.parts, plain)) for line in lines]


@pytest.mark.parametrize("text, name, amplitude", [
    (BLOCK, "x", "20 cm"), (BLOCK, "x", "5 cm"), (PENDULUM, "phi", "120 deg")])
def test_the_period_at_an_amplitude_by_quadrature(text, name, amplitude):
    """ω from the turning places that are printed and the expression of the speed alone, by QUADPACK in the angle θ of
    q = c + h sin θ."""
    asked = f"backbone[1]({name})({amplitude})"
    found = problem(text + f"answers: {{'{asked}': 1 rad/s}}")
    lines = worked(found)
    speed, = (line.node for line in lines if line.settles == f"{name}'^2")
    turns, = (line for line in lines if line.settles == f"turning places of {asked}")
    low, high, E = (float(text.replace("−", "-")) for text in re.findall(r"= (−?[\d.e−-]+)", *told([turns])))
    low, high = (float(f"{end:.6g}") for end in (low, high))
    end, = (line for line in lines if line.settles == asked)

    def square(q):
        return evaluate([speed], Floats, {**found.numeric.floats, name: q, "E": E})[0]

    def rate(theta):
        q = (low + high) / 2 + (high - low) / 2 * math.sin(theta)
        return (high - low) / 2 * math.cos(theta) / math.sqrt(square(q))

    edge = math.pi / 2 - 1e-2       # where the rounding of what is printed tells; there ẍ is about constant
    half = quad(rate, -edge, edge)[0]
    half += 1e-2 * (rate(edge) + rate(-edge))
    assert end.value == pytest.approx(math.pi / half, rel=2e-3)
    assert end.value == pytest.approx(found_by_hand(text, amplitude), rel=1e-9)


def found_by_hand(text, amplitude):
    """ω by the arithmetic-geometric mean for the pendulum, by quadrature of the energy for the block."""
    if text is PENDULUM:
        a, b = 1.0, math.cos(math.radians(120) / 2)
        while abs(a - b) > 1e-15:
            a, b = (a + b) / 2, math.sqrt(a * b)
        return math.sqrt(9.81 / 0.8) * a
    half_range = 0.2 if amplitude == "20 cm" else 0.05

    def V(x):
        return 40 * x**2 + 40 * x**3 + 125 * x**4

    low, high = -1.3 * half_range, 0.0          # the middle of the range, by halving
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if V(middle - half_range) > V(middle + half_range) else (low, middle)
    top = V(low + half_range)

    def rate(theta):
        q = low + half_range * math.sin(theta)
        return half_range * math.cos(theta) / math.sqrt(top - V(q))     # √(2/m) = 1

    return math.pi / quad(rate, -math.pi / 2, math.pi / 2, epsabs=1e-13, epsrel=1e-12)[0]


def test_the_expansion_of_a_spring_that_is_no_odd_one():
    """κ = 3g₃/(8k) − 5g₂²/(12k²) (Nayfeh and Mook 1979, equation 2.3.31)."""
    line = lines_of(BLOCK + "answers: {'backbone[1, x^2]': 1 m^-2}")[-1]
    assert line.settles == "backbone[1, x^2]"
    assert line.value == pytest.approx(3 * 500 / (8 * 80) - 5 * 120**2 / (12 * 80**2), rel=1e-12)


def test_the_expansion_where_the_inertia_changes():
    """A bead on y = x²/2R: κ by the change of its inertia, held against the period at a small
    amplitude."""
    text = """
parameters: {m: 1 kg, R: 0.5 m, g: 9.81 m/s^2}
gravity: g
bodies: {bead: {mass: m, at: [0 m, 0 m], move: [x, x^2/(2*R), 0]}}
"""
    lines = lines_of(text + "answers: {'backbone[1, x^2]': 1 m^-2}")
    assert any("the inertia becomes constant with" in line for line in told(lines))
    small = lines_of(text + "answers: {'backbone[1](x)(1 mm)': 1 rad/s}")[-1]
    omega = math.sqrt(9.81 / 0.5)
    assert small.value / omega - 1 == pytest.approx(lines[-1].value * 1e-6, rel=1e-4)


def test_several_amplitudes_share_the_integral_of_energy():
    lines = lines_of(PENDULUM + "answers: {'backbone[1](phi)(20 deg)': 1 rad/s, 'backbone[1](phi)(90 deg)': 1 rad/s}")
    settled = {line.settles: text for line, text in zip(lines, told(lines), strict=True)}
    assert [line.settles for line in lines].count("integral of energy") == 1
    assert list(settled).index("backbone[1](phi)(20 deg)") < list(settled).index("backbone[1](phi)(90 deg)")
    assert "V = E = 0 J" in settled["turning places of backbone[1](phi)(90 deg)"]       # and not what rounding leaves


def test_letters_alone_have_no_number_of_a_backbone():
    lines = lines_of("""
parameters: {m: {unit: kg}, k: {unit: N/m}, g3: {unit: N/m^3}}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: k*d + g3*d^3, between: [ground, block]}}
answers: {"backbone[1, x^2]": 3*g3/(8*k)}
""")
    assert told(lines)[-1].endswith("= 3·g₃/(8·k)") and lines[-1].value is None
