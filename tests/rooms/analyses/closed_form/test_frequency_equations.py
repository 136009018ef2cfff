"""Frequency equations in letters: as textbooks print them, and zero at the natural frequencies that counting finds."""

import pytest
from support.scenes import problem

from vibcli.analyses.closed_form.member_frequencies import frequency_equations
from vibcli.analyses.closed_form.textbook_equation import sides
from vibcli.notation.plain import plain
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
]


def _scene(text):
    import re

    used = "".join(f"{name}: {value}, " for name, value in re.findall(r"(\w+): ([^,}]+)", PARAMETERS)
                   if re.search(rf"\b{name}\b(?!:)", text.replace(": EI, ", ": EI , ")))
    return problem(f"parameters: {{{used[:-2]}}}\n{text}\n")


@pytest.mark.parametrize("text", [*TEXTBOOK, *OTHERS])
def test_is_zero_at_the_natural_frequencies(text):
    found = _scene(text)
    equation, = frequency_equations(found.symbolic)
    left, right = sides(equation)
    if text in TEXTBOOK:
        assert f"{plain(left)} = {plain(right)}".replace("\u00a0", " ") == TEXTBOOK[text]
    values, x = found.numeric.floats, equation.wave_number

    def residual(at):
        return float.__sub__(*map(float, evaluate([left, right], Floats, {**values, x.name: at})))

    elastic = [mode for mode in found.modal.modes.first(6) if mode.omega]
    assert elastic
    for mode in elastic:
        low, high = 0.0, 1.0
        square = lambda at: evaluate([equation.square], Floats, {**values, x.name: at})[0]     # noqa: E731
        while square(high) < mode.omega**2:
            high *= 2
        for _ in range(200):
            low, high = (low, middle) if square(middle := (low + high) / 2) > mode.omega**2 else (middle, high)
        assert residual(low * (1 - 1e-9)) * residual(low * (1 + 1e-9)) < 0
