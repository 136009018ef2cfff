"""Frequency equations in letters: as textbooks print them, and zero at the natural frequencies that counting finds."""

import re
from math import pi

import pytest
from support.scenes import problem

from vibcli.analyses.closed_form.member_frequencies import frequency_equations
from vibcli.analyses.closed_form.member_shapes import roots, shape
from vibcli.analyses.closed_form.textbook_equation import by_letters, sides
from vibcli.notation.plain import plain
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate

PARAMETERS = "{L: 0.6 m, EI: 70 N*m^2, EA: 1 MN, S: 100 N, mu: 0.27 kg/m, M: 0.05 kg, J: 1 g*m^2, k: 400 N/m, " \
             "kt: 5 N*m, m: 0.01 kg, a: 0.2 m, kf: 900 N/m^2}"
BEAM, BAR = "length: L, EI: EI, mass_per_length: mu", "length: L, EA: EA, mass_per_length: mu"
TEXTBOOK = {
    f"beams: {{b: {{{BEAM}, left: clamped}}}}": "cos βL·cosh βL = −1",
    f"beams: {{b: {{{BEAM}}}}}": "cos βL·cosh βL = 1",
    f"beams: {{b: {{{BEAM}, left: pinned, right: pinned}}}}": "sin βL = 0",
    f"beams: {{b: {{{BEAM}, left: clamped, right: pinned}}}}": "tan βL = tanh βL",
    f"beams: {{b: {{{BEAM}, left: clamped, right: guided}}}}": "tan βL = −tanh βL",
    f"beams: {{b: {{{BEAM}, left: pinned, right: guided}}}}": "cos βL = 0",
    f"beams: {{b: {{{BEAM}, left: pinned, right: pinned, preload: -S}}}}": "sin βL = 0",
    f"beams: {{b: {{{BEAM}, left: guided, right: pinned, preload: S, foundation: kf}}}}": "cos βL = 0",
    f"bars: {{b: {{{BAR}, left: clamped}}}}": "cos βL = 0",
    f"bars: {{b: {{{BAR}, left: clamped, right: clamped}}}}": "sin βL = 0",
    f"bars: {{b: {{{BAR}, left: clamped, attached: [{{at: L, mass: M}}]}}}}": "βL·tan βL = L·μ/M",
    f"bars: {{b: {{{BAR}, left: clamped, right: {{k: k}}}}}}": "tan βL = −EA·βL/(L·k)",
}
OTHERS = [
    f"beams: {{b: {{{BEAM}, left: clamped, attached: [{{at: L, mass: M, inertia: J}}]}}}}",
    f"beams: {{b: {{{BEAM}, left: {{k: k, torsion: kt}}, right: {{k: k}}}}}}",
    f"beams: {{b: {{{BEAM}, left: pinned, right: pinned, attached: [{{at: a, mass: M}}, {{at: L, torsion: kt}}]}}}}",
    f"beams: {{b: {{{BEAM}, left: clamped, right: pinned, attached: [{{at: a, support: pinned}}]}}}}",
    f"beams: {{b: {{{BEAM}, left: clamped, foundation: kf, attached: [{{at: L, mass: M}}]}}}}",
    f"beams: {{b: {{{BEAM}, left: clamped, attached: [{{at: L, oscillator: {{mass: m, k: k}}}}]}}}}",
    f"bars: {{b: {{{BAR}, left: {{k: k}}, attached: [{{at: L, mass: M}}, {{at: L, k: k}}, {{at: 0 m, mass: m}}]}}}}",
    "bars: {b: {segments: [{length: a, EA: EA}, {length: L, EA: 3*EA}], mass_per_length: mu, left: clamped}}",
    "strings: {b: {length: L, preload: S, mass_per_length: mu, left: clamped, right: clamped, "
    "attached: [{at: a, mass: M}]}}",
    "beams: {b: {segments: [{length: a, EI: EI}, {length: L, EI: 3*EI}], mass_per_length: mu, left: clamped, "
    "attached: [{at: a, mass: M}, {at: a + L, k: k}]}}",
    f"bars: {{b: {{{BAR}, left: clamped, right: {{clamped: c, at: 0*L}}}}, "
    "c: {length: a, EA: 2*EA, mass_per_length: 3*mu}}",
]


def _scene(text):
    used = "".join(f"{name}: {value}, " for name, value in re.findall(r"(\w+): ([^,}]+)", PARAMETERS)
                   if re.search(rf"\b{name}\b(?!:)", text.replace(": EI, ", ": EI , ")))
    return problem(f"parameters: {{{used[:-2]}}}\n{text}\n")


@pytest.mark.parametrize("text", [*TEXTBOOK, *OTHERS])
def test_is_zero_at_the_natural_frequencies(text):
    found = _scene(text)
    equation, = frequency_equations(found.symbolic)
    left, right = sides(equation)
    plain_sides = equation.by_wave_number(left, right)
    if text in TEXTBOOK:
        assert f"{plain(left)} = {plain(right)}".replace("\u00a0", " ") == TEXTBOOK[text]
    values, x = found.numeric.floats, equation.wave_number

    def residual(at):
        return float.__sub__(*map(float, evaluate(plain_sides, Floats, {**values, x.name: at})))

    elastic = [mode for mode in found.modal.modes.first(6) if mode.omega]
    assert elastic
    for mode in elastic:
        at = _wave_number(equation, values, mode.omega)
        assert residual(at * (1 - 1e-9)) * residual(at * (1 + 1e-9)) < 0


@pytest.mark.parametrize("text", OTHERS)
def test_letters_stand_for_the_arguments_of_several_pieces(text):
    """The equation with them is the same; they are none of the letters of the scene."""
    equation, = frequency_equations(_scene(text).symbolic)
    named, letters = by_letters(equation, {"theta2"})
    arguments = ["eta1", "eta2"] if len(equation.pieces) > 1 else []
    whole = [] if equation.wave_number.name == "βL" else ["theta"]
    impedances = {0: [], 1: ["Z"], 2: ["Z1", "Z2"]}[len(equation.letters)]
    assert [letter.name for letter, _ in letters] == [*arguments, *whole, *impedances]
    given = {letter: meant for letter, meant in letters if letter is not equation.wave_number}
    for one, other in zip(sides(equation), sides(named), strict=True):
        assert (substitute([one], given)[0] - substitute([other], given)[0]).is_zero


def _wave_number(equation, values, omega):
    """βL of a frequency, by bisection of ω² as it is printed."""
    def square(at):
        return evaluate([equation.square], Floats, {**values, equation.wave_number.name: at})[0]

    low, high = 0.0, 1.0
    while square(high) < omega**2:
        high *= 2
    for _ in range(200):
        low, high = (low, middle) if square(middle := (low + high) / 2) > omega**2 else (middle, high)
    return low


@pytest.mark.parametrize("text", [text for text in TEXTBOOK if "M}" not in text and "k}" not in text])
def test_roots_without_letters(text):
    """The first roots of what holds no letter are those of the natural frequencies (sin βL = 0 also has n·π)."""
    found = _scene(text)
    equation, = frequency_equations(found.symbolic)
    elastic = [mode for mode in found.modal.modes.first(6) if mode.omega][:4]
    expected = [_wave_number(equation, found.numeric.floats, mode.omega) for mode in elastic]
    assert roots(equation, 4) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("left", ["clamped", "pinned", "guided", "free"])
@pytest.mark.parametrize("right", ["clamped", "pinned", "guided", "free"])
@pytest.mark.parametrize("kind", [f"beams: {{b: {{{BEAM}, ", f"bars: {{b: {{{BAR}, ",
                                  "strings: {b: {length: L, preload: S, mass_per_length: mu, "])
def test_what_moves_as_a_whole_on_a_foundation_is_a_root_too(kind, left, right):
    """EI β⁴ + k = μ ω² has as many β = 0 as a bare member has rigid motions: the roots are all frequencies."""
    if "guided" in (left, right) and "beams" not in kind:
        return
    found = _scene(f"{kind}left: {left}, right: {right}, foundation: kf}}}}")
    equation, = frequency_equations(found.symbolic)
    values, wave_numbers = found.numeric.floats, roots(equation, 5)
    squares = [evaluate([equation.square], Floats, {**values, "βL": at})[0] for at in wave_numbers]
    assert [mode.omega for mode in found.modal.modes.first(5)] == pytest.approx([x**0.5 for x in squares], rel=1e-12)
    assert len(found.modal.modes.up_to(squares[-1]**0.5 * (1 + 1e-8))) == 5


@pytest.mark.parametrize("left", ["clamped", "pinned", "guided", "free"])
@pytest.mark.parametrize("right", ["clamped", "pinned", "guided", "free", "{k: k}"])
def test_shapes_fulfil_what_holds_at_both_ends(left, right):
    found = _scene(f"beams: {{b: {{{BEAM}, left: {left}, right: {right}}}}}")
    equation, = frequency_equations(found.symbolic)
    told, values = shape(equation), found.numeric.floats
    omega = next(mode.omega for mode in found.modal.modes.first(4) if mode.omega and mode.index > 1)
    at = _wave_number(equation, values, omega)

    def X(z):
        def value(node, name, place):
            return evaluate([node], Floats, {name: place})[0]

        sigma = 0 if told.sigma is None else value(told.sigma[0], "βL", at) / value(told.sigma[1], "βL", at)
        return value(told.first, "βx", z * at) - sigma * value(told.second, "βx", z * at)

    h = 1e-3
    for end, way, what in ((0.0, 1, left), (1.0, -1, right)):
        u = [X(end + way * i * h) for i in range(6)]
        slopes = {0: u[0], 1: (u[1] - u[0]) / h, 2: (u[2] - 2 * u[1] + u[0]) / h**2,
                  3: (u[3] - 3 * u[2] + 3 * u[1] - u[0]) / h**3}
        vanish = {"clamped": (0, 1), "pinned": (0, 2), "guided": (1, 3), "free": (2, 3), "{k: k}": (2,)}[what]
        size = max(abs(X(i / 20)) for i in range(21))
        for order in vanish:
            assert abs(slopes[order]) < 0.03 * size * max(at, pi) ** order


def test_members_that_share_a_motion_have_no_equation_of_their_own():
    found = problem(f"""
        parameters: {{L: 0.6 m, EI: 70 N*m^2, mu: 0.27 kg/m, M: 0.05 kg}}
        bodies: {{block: {{mass: M, slide: x}}}}
        beams:
          one: {{{BEAM}, left: clamped, right: {{clamped: block}}}}
          two: {{{BEAM}, left: clamped, right: {{pinned: block}}}}
          three: {{{BEAM}, left: clamped}}
        """)
    assert [equation and equation.members for equation in frequency_equations(found.symbolic)] == [
        None, None, ("three",)]
