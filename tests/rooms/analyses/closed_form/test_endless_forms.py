"""Frequencies of a member in letters: those of the same scene in numbers, by the number of the mode."""

import re
from itertools import combinations_with_replacement

import pytest
from support.printed_equations import printed
from support.scenes import problem

from vibcli.api.expressions import node_of
from vibcli.api.values import quantity_value
from vibcli.base.errors import NotInLetters
from vibcli.symbolic.evaluation import Floats, evaluate

VALUES = {"L": 0.6, "EI": 70.0, "EA": 9e5, "mu": 0.27, "S": 80.0, "E": 7e10, "rho": 2700.0, "k": 900.0, "g": 9.81}
BEAM, BAR = "length: L, EI: EI, mass_per_length: mu", "length: L, EA: EA, mass_per_length: mu"
HANGING = "gravity: g\nstrings: {b: {from: [0, 0], to: [0, -L], mass_per_length: mu, left: pinned}}"
SCENES = [
    *(f"beams: {{b: {{{BEAM}, left: {left}, right: {right}}}}}" for left, right in combinations_with_replacement(
        ("clamped", "pinned", "guided", "free"), 2)),
    *(f"bars: {{b: {{{BAR}, left: {left}, right: {right}}}}}" for left in ("clamped", "free") for right in (
        "clamped", "free")),
    f"beams: {{b: {{{BEAM}, foundation: k}}}}",
    f"beams: {{b: {{{BEAM}, left: guided, right: guided, foundation: k, preload: S}}}}",
    f"beams: {{b: {{{BEAM}, left: pinned, right: pinned, preload: -S}}}}",
    f"beams: {{b: {{{BEAM}, left: clamped, attached: [{{at: L, mass: mu*L/2}}]}}}}",
    f"beams: {{b: {{{BEAM}, attached: [{{at: L, mass: mu*L/2}}]}}}}",
    f"bars: {{b: {{{BAR}, left: clamped, attached: [{{at: L, mass: mu*L}}]}}}}",
    "strings: {b: {length: L, preload: S, mass_per_length: mu, left: pinned, right: pinned}}",
    HANGING,
    HANGING.replace("-L", "L").replace("left", "right"),
    HANGING.replace("pinned", "{pinned: cart}") + "\nbodies: {cart: {at: [0, 0], slide: {along: [1, 0], by: s}}}",
]


def in_letters(text):
    names = [name for name in VALUES if re.search(rf"(?<!\w){name}(?![\w:])", re.sub(r"(EI|EA|E):", "", text))]
    return [problem(f"parameters: {{{', '.join(f'{name}: {how(name)}' for name in names)}}}\n{text}\n")
            for how in (lambda name: "", VALUES.get)]


def expression(found, text):
    return quantity_value(found, text).expression


@pytest.mark.parametrize("text", SCENES)
def test_frequencies_are_those_of_numbers(text):
    letters, numbers = in_letters(text)
    modes = numbers.modal.modes
    for number in (1, 2, 3, 4, 21):
        node = node_of(expression(letters, f"omega[{number}]"))
        value, = evaluate([node], Floats, VALUES)
        assert value == pytest.approx(float(modes.numbered(number, number)[0].omega), rel=1e-13, abs=0)


@pytest.mark.parametrize(("text", "asked", "told"), [
    (f"bars: {{b: {{{BAR}, left: clamped}}}}", "omega[2]", "3*pi*sqrt(EA/mu)/(2*L)"),
    (f"bars: {{b: {{{BAR}, left: clamped}}}}", "period[1]", "4*L*sqrt(mu/EA)"),
    (SCENES[2], "omega[1]", "5.59332136201533*sqrt(EI/mu)/L^2"),
    (SCENES[3], "omega[1]", "3.51601526850015*sqrt(EI/mu)/L^2"),
    (SCENES[9], "omega[1]", "0"),
    (HANGING, "omega[1]", "1.20241277884789*sqrt(g/L)"),
    (HANGING, "period[1]", "1.66332230926249*pi*sqrt(L/g)"),
])
def test_expressions_as_textbooks_have_them(text, asked, told):
    letters, _ = in_letters(text)
    assert str(expression(letters, asked)) == told


ONE = "length: 1, EI: 1, mass_per_length: mu, left:"
TUNED = "attached: [{at: 1, oscillator: {mass: mu/1000000, k: 1.236236336832e-5}}]"


@pytest.mark.parametrize("text", [
    f"beams: {{b: {{{ONE} pinned, right: pinned, preload: -59.2, foundation: 900}}}}",
    f"beams: {{b: {{{ONE} clamped, {TUNED}}}}}",
    f"beams: {{b: {{{BEAM}, left: {{k: EI/L^3/10000000}}, right: {{k: EI/L^3/10000000}}}}}}"])
def test_frequencies_whose_order_or_number_no_search_proves_are_refused(text):
    """Two half waves below one, two roots beside a pole, two below the first step."""
    letters, _ = in_letters(text)
    assert letters.closed_forms is None
    assert not any("βL = " in line and "…" in line and "π" not in line for lines in printed(letters) for line in lines)


@pytest.mark.parametrize("more", [", attached: [{at: L, mass: k}]", ", preload: S", "}, c: {length: L, EI: 3*EI, "
                                  "mass_per_length: mu, left: clamped", ", preload: -S, right: pinned"])
def test_what_hangs_on_letters_is_refused(more):
    """A ratio of masses, of a force and a stiffness, another member, whose frequencies may lie between."""
    letters, _ = in_letters(f"beams: {{b: {{{BEAM}, left: clamped{more}}}}}")
    with pytest.raises(NotInLetters, match="found in numbers, as a root of a frequency equation"):
        expression(letters, "omega[1]")
