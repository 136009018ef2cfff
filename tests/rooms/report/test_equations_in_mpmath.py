"""Every frequency equation that is printed is zero at the frequencies that counting finds, and not beside them; shapes
that are printed are those of the modes: the nodes of the lines, by mpmath."""

import re
from itertools import combinations, combinations_with_replacement, product
from pathlib import Path

import mpmath
import pytest
from support.equations_in_mpmath import Printed, fulfilled, is_equation
from support.printed_equations import blocks, orthogonality, printed
from support.scenes import kept_settled_of, problem

from vibcli.analyses.continuous.shapes import shape_along
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.sections.hanging_string import ZEROS

VALUES = {"L": "0.6 m", "EI": "70 N*m^2", "EA": "1 MN", "mu": "0.27 kg/m", "N": "90 N", "P": "600 N", "M": "0.05 kg",
          "J": "1 g*m^2", "k": "400 N/m", "kt": "5 N*m", "m": "0.01 kg", "kf": "900 N/m^2", "g": "9.81 m/s^2",
          "a": "0.2 m", "cd": "2 N*s/m", "S": "80 N", "GIo": "7 N*m^2", "j": "1 g*m"}
ENDS = ("clamped", "pinned", "guided", "free", "{k: k}")
PAIRS = tuple(combinations_with_replacement(ENDS[:4], 2))
SPRUNG = (("clamped", "{k: k}"), ("{torsion: kt}", "pinned"), ("guided", "{k: 3*k, torsion: kt}"), ("{k: k}", "free"),
          ("{k: k}", "{torsion: kt}"), ("{torsion: kt}", "{torsion: kt}"),
          ("{k: 3*k, torsion: kt}", "{k: 3*k, torsion: kt}"))
ATTACHED = ("{at: L, mass: M}", "{at: L, mass: M, inertia: J}", "{at: L, oscillator: {mass: m, k: k}}")
PROBLEMS = sorted(Path("problems/8_continuous").glob("*.yaml"))
PLACES = (0.0, 0.21, 0.43, 0.77, 1.0)


@pytest.fixture(autouse=True)
def _without_shapes_in_numbers(monkeypatch):
    """Shapes in numbers, which other tests look at, are left out."""
    monkeypatch.setattr("vibcli.report.sections.frequency_equation.shapes_in_numbers", lambda *_: ())
    yield
    blocks.cache_clear()


def scene(members):
    """A scene of members, with the parameters that these name."""
    used = [f"{name}: {value}" for name, value in VALUES.items()
            if re.search(rf"(?<!\w){name}(?![\w:])", re.sub(r"(EI|EA|GIo):", "", members))]
    return problem(f"parameters: {{{', '.join(used)}}}\n{members}\n")


def beam(left, right, rest):
    return f"beams: {{b: {{length: L, EI: EI, mass_per_length: mu, left: {left}, right: {right}, {rest}}}}}"


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_equations_of_the_problems_hold(path):
    found = kept_settled_of(path)
    if not found.numeric.has_free_symbols:
        assert fulfilled(found) == sum(is_equation(lines) for lines in blocks(found))
        hold_shapes(found)
        hold_orthogonality(found)


def hold_shapes(found):
    """X of the first modes, each apart from others, up to a factor, where one in letters is told; how many are."""
    equations = [Printed(lines) for lines in blocks(found) if is_equation(lines)]
    told = [one for one in equations if one.drawn is not None] if len(found.scene.members) == 1 else []
    modes = [mode for mode in found.modal.modes.first(3) if mode.omega] if told else []
    apart = [mode for mode in modes if all(abs(mode.omega - one.omega) > 1e-9 * mode.omega for one in modes
                                           if one is not mode)]
    for equation, mode in product(told, apart):
        pieces, floats = found.modal.fields(mode).pieces(*found.scene.members), found.numeric.floats
        length = float(pieces[-1].start + pieces[-1].piece.length)
        values = [complex(equation.shape(mode.omega, place, floats)) for place in PLACES]
        moved = shape_along(pieces, [place * length for place in PLACES])[:, 0]
        largest = max(range(len(PLACES)), key=lambda k: abs(moved[k]))
        assert [moved[largest] / values[largest] * one for one in values] == pytest.approx(
            list(moved), abs=1e-9 * abs(moved[largest]))
    return len(told) * len(apart)


def hold_orthogonality(found):
    """What is printed on it, by integrals of the modes."""
    names = list(found.scene.members)
    told = [line for lines in printed(found) for line in lines if "X_i" in line]
    modes = [mode for mode in found.modal.modes.first(3) if mode.omega] if told else []
    for line, (one, other) in product(told, combinations(modes, 2)):
        if abs(one.omega - other.omega) > 1e-9 * one.omega:
            both, *sizes = (orthogonality(found, line, names, pair)[0] for pair in (
                (one, other), (one, one), (other, other)))
            assert both ** 2 <= 1e-18 * sizes[0] * sizes[1]


PULLED = [
    *(beam(*ends, "preload: N") for ends in SPRUNG),
    *(beam(*ends, "preload: -P, foundation: kf") for ends in PAIRS[1::2]),
    *(beam(left, "free", f"preload: {('N', '-P')[k % 2]}, attached: [{what}]") for k, (what, left) in enumerate(
        list(product(ATTACHED, ENDS))[::2]))]


@pytest.mark.sweep
@pytest.mark.parametrize("text", PULLED)
def test_pulled_and_pressed_beams_with_all_ends(text):
    """α² − β² = N/EI: one equation, of unstable modes too. What springs at both ends add is linear in each of them, so
    that those with all four of them try all other ends."""
    assert fulfilled(scene(text)) == 1


def member(kind, stiffness, inertia, left, right, rest):
    return f"{kind}: {{b: {{length: L, {stiffness}, {inertia}, left: {left}, right: {right}, {rest}}}}}"


BAR, STRING = ("bars", "EA: EA", "mass_per_length: mu"), ("strings", "preload: S", "mass_per_length: mu")
SHAFT, BEAM = ("shafts", "GIo: GIo", "inertia_per_length: j"), ("beams", "EI: EI", "mass_per_length: mu")
HUNG = (*ATTACHED, "{at: a, mass: M}", "{at: a, k: k}", "{at: a, support: pinned}", "{at: a, torsion: kt}",
        "{at: a, oscillator: {mass: m, k: k}}", "{at: a, mass: M}, {at: L, mass: m}")
PLAIN = [
    *(member(*BEAM, *ends, "") for ends in SPRUNG[::2]),
    *(member(*BEAM, *ends, "foundation: kf") for ends in PAIRS[::2]),
    *(member(*BEAM, "free", "free", f"attached: [{what}], foundation: kf") for what in HUNG[::2]),
    *(member(*BEAM, left, "free", f"attached: [{what}]") for left, what in zip(ENDS, HUNG[1::2], strict=False)),
    *(member(*kind, left, "free", f"attached: [{what}]{bed}") for left, bed, whats in (
        ("clamped", "", ("{at: L, mass: M}", "{at: L, mass: M}, {at: L, k: k}", "{at: a, mass: M}")),
        ("{k: k}", ", foundation: kf", ("{at: L, oscillator: {mass: m, k: k}}", "{at: a, k: k}, {at: L, mass: m}",
                                        "{at: a, oscillator: {mass: m, k: k}}")))
      for kind, what in zip((BAR, STRING, BAR), whats, strict=True)),
    member(*SHAFT, "free", "clamped", "attached: [{at: 0*L, inertia: J}]"),
    member(*SHAFT, "{torsion: kt}", "free", "attached: [{at: a, torsion: kt}]"),
    *(f"beams: {{b: {{segments: [{{length: a, EI: EI}}, {{length: L, EI: 3*EI}}], mass_per_length: mu, left: {left}}}}}"
      for left in ENDS[:4:3]),
]


@pytest.mark.sweep
@pytest.mark.parametrize("text", PLAIN)
def test_members_with_all_ends_and_attachments(text):
    """In a bed those with βL = 0 among them, which the lines have to tell."""
    assert fulfilled(scene(text)) == 1


BOTH = "(k₁ + k₂ − M·ω²)·(R₁ + R₂ − J·ω²) = (G₁ + G₂)²"
JOINED = {
    beam("clamped", "free", "preload: N, attached: [{at: a, mass: M, inertia: J}]"): BOTH,
    beam("pinned", "guided", "preload: N, attached: [{at: a, support: pinned}]"): "k₁ + k₂ = 0",
    beam("pinned", "pinned", "preload: -N, foundation: kf, attached: [{at: L/2, mass: M}]"): "2·R·(2·k − M·ω²) = 0",
    beam("clamped", "{k: k}", "attached: [{at: a, oscillator: {mass: m, k: k}}, {at: a, torsion: kt}]"):
        "·(kt + R₁ + R₂) = (G₁ + G₂)²",
    """
beams: {b: {segments: [{length: a, EI: EI}, {length: L, EI: 3*EI}], mass_per_length: mu, left: clamped, preload: N}}
""": "(k₁ + k₂)·(R₁ + R₂) = (G₁ + G₂)²",
    """
beams:
  one: {from: [0, 0], to: [L, 0], EI: EI, mass_per_length: mu, preload: -N, left: clamped, right: {clamped: hub}}
  two: {from: [L + a, 0], to: [L, 0], EI: 2*EI, mass_per_length: mu, left: pinned, right: {clamped: hub}}
bodies: {hub: {mass: M, inertia: J, at: [L, 0], move: [0, y, psi]}}
""": BOTH.replace("+ G₂", "− G₂"),
    """
gravity: g
strings:
  b: {from: [0, 0], to: [0, -L], mass_per_length: mu, left: pinned, attached: [
      {at: a, mass: M}, {at: L, mass: m}, {at: L, oscillator: {mass: m, k: k}}]}
""": "k₁ + k₂ − M·ω² = 0",
    """
gravity: g
strings:
  b: {from: [0, 0], to: [0, L], mass_per_length: mu, right: pinned, attached: [{at: a, mass: M}, {at: a, k: k}]}
""": "k + k₁ + k₂ − M·ω² = 0"}


@pytest.mark.sweep
@pytest.mark.parametrize("text", JOINED, ids=range(len(JOINED)))
def test_two_stretches_under_an_axial_force(text):
    """Even along each, or that of a string by its weight."""
    found = scene(text)
    assert JOINED[text] in Printed(*blocks(found)).text
    assert fulfilled(found, 4) == 1


def test_zeros_of_what_is_multiplied_that_are_no_frequencies_are_told():
    """Where η = 0, and where θ = iη, of a pressed beam in a bed."""
    found = scene(beam("pinned", "pinned", "preload: -N, foundation: kf, attached: [{at: L/2, mass: M}]"))
    equation, floats = Printed(*blocks(found)), found.numeric.floats
    for bed in (floats["kf"], floats["kf"] - floats["N"] ** 2 / (4 * floats["EI"])):
        omega = (bed / floats["mu"]) ** 0.5
        assert equation.vanishes(omega, floats) and omega < 0.99 * found.modal.modes[0].omega
    assert "where one of θ, η, θ² + η² is 0 it may be 0 too" in equation.told


def test_wave_numbers_of_another_length_have_letters():
    found = scene("beams: {b: {length: 2*L, EI: EI, mass_per_length: mu, left: clamped, preload: N}}")
    lines, = blocks(found)
    assert [formula(one.parts, plain).replace("\u00a0", " ") for one in lines[:4]] == [
        "2·θ²·η² − θ·η·(θ² − η²)·sin θ·sinh η + (θ⁴ + η⁴)·cos θ·cosh η = 0", "θ = 2·L·β", "η = 2·L·α",
        "η = √(4·L²·N/EI + θ²)"]
    assert fulfilled(found) == 1 and hold_shapes(found) == 3


@pytest.mark.sweep
def test_what_is_false_is_seen():
    """The equation of a free tip, and one of another force, where a mass and this force act."""
    loaded, other, bare = (scene(beam("clamped", "free", f"preload: {more}")) for more in (
        "-P, attached: [{at: L, mass: M}]", "-P/2, attached: [{at: L, mass: M}]", "-P"))
    own, *false = (Printed(*blocks(one)) for one in (loaded, other, bare))
    for mode in [mode for mode in loaded.modal.modes.first(4) if mode.omega]:
        assert own.vanishes(mode.omega, loaded.numeric.floats)
        assert not any(one.vanishes(mode.omega, loaded.numeric.floats) for one in false)


TEXTBOOK = {
    ("clamped", "free"): "2·(βL)²·(αL)² − βL·αL·((βL)² − (αL)²)·sin βL·sinh αL + ((βL)⁴ + (αL)⁴)·cos βL·cosh αL = 0",
    ("clamped", "clamped"): "2·βL·αL − ((βL)² − (αL)²)·sin βL·sinh αL − 2·βL·αL·cos βL·cosh αL = 0",
    ("clamped", "pinned"): "tan βL = βL·tanh αL/αL",
    ("clamped", "guided"): "tan βL = −αL·tanh αL/βL",
    ("free", "free"): "2·(βL)³·(αL)³ − 2·(βL)³·(αL)³·cos βL·cosh αL − ((αL)⁶ − (βL)⁶)·sin βL·sinh αL = 0",
    ("pinned", "free"): "tan βL = (αL)³·tanh αL/(βL)³",
    ("guided", "free"): "tan βL = −(βL)³·tanh αL/(αL)³",
    ("pinned", "pinned"): "sin βL = 0",
}


@pytest.mark.parametrize(("left", "right"), TEXTBOOK)
def test_a_pressed_beam_as_textbooks_have_it(left, right):
    found = scene(beam(left, right, "preload: -P"))
    lines, = blocks(found)
    assert Printed(lines).text == TEXTBOOK[left, right]
    assert fulfilled(found, 4) == 1


def chain(rest, up="-", more=""):
    return f"gravity: g\nstrings: {{b: {{from: [0, 0], to: [0, {up}L], mass_per_length: mu, {rest}}}}}\n{more}"


CART = "bodies: {cart: {mass: M, at: [0, 0], slide: {along: [1, 0], by: x}}}"
HANGING = {
    "J₀(z) = 0": chain("left: pinned"),
    "J₁(z) = −M·z·J₀(z)/(2·L·μ)": chain("left: {pinned: cart}", "-", CART),
    "J₀(z₁)·Y₁(z₂) − Y₀(z₁)·J₁(z₂) = z₂·(J₀(z₁)·Y₀(z₂) − Y₀(z₁)·J₀(z₂))/2":
        chain("left: pinned, attached: [{at: L, mass: M}]"),
    "J₁(z₁)·Y₀(z₂) − Y₁(z₁)·J₀(z₂) = z₁·(J₀(z₁)·Y₀(z₂) − Y₀(z₁)·J₀(z₂))/2":
        chain("right: pinned, attached: [{at: 0, mass: M}]", ""),
    "J₀(z₁)·Y₁(z₂) − Y₀(z₁)·J₁(z₂) = 2·Z·(Y₀(z₁)·J₀(z₂) − J₀(z₁)·Y₀(z₂))/(μ·g·z₂)":
        chain("left: pinned, attached: [{at: L, mass: M}, {at: L, k: k}, {at: L, oscillator: {mass: m, k: k}}]"),
    "J₀(z₁)·Y₀(z₂) − Y₀(z₁)·J₀(z₂) = 0": chain("left: pinned, right: pinned, preload: N"),
    "J₁(z₁)·Y₁(z₂) − Y₁(z₁)·J₁(z₂) = M·z₁·z₂·(J₀(z₁)·Y₀(z₂) − Y₀(z₁)·J₀(z₂))/(4·(L·μ + m)) + "
    "z₂·(J₁(z₁)·Y₀(z₂) − Y₁(z₁)·J₀(z₂))/2 − M·z₁·(J₀(z₁)·Y₁(z₂) − Y₀(z₁)·J₁(z₂))/(2·(L·μ + m))":
        chain("left: {pinned: cart}, attached: [{at: L, mass: m}]", "-", CART),
}


@pytest.mark.sweep
@pytest.mark.parametrize("told", HANGING, ids=range(len(HANGING)))
def test_strings_whose_tension_varies(told):
    """Bessel functions of z = 2ω√(μT)/|γ|."""
    found = scene(HANGING[told])
    lines, = blocks(found)
    assert Printed(lines).text == told
    assert fulfilled(found) == 1 and hold_shapes(found) > 1


def test_a_parameter_with_the_name_of_a_bessel_function_is_none():
    found = problem("parameters: {L: 1, J0: 2, g: 9.81}\n" + chain("left: pinned").replace("mu", "J0"))
    assert not any(map(is_equation, blocks(found)))


def test_a_hanging_chain_as_textbooks_have_it():
    """D. Bernoulli: ω = j/2·√(g/L), j the zeros of J₀."""
    lines, = blocks(scene(HANGING["J₀(z) = 0"]))
    zeros, omega, shape = (formula(one.parts, plain) for one in lines[1:4])
    assert zeros == f"z = {ZEROS['J0']}, …" and omega == "ω = z·√(g/L)/2" and shape == "X(x) = J₀(z·√((L − x)/L))"


@pytest.mark.parametrize("order", [0, 1])
def test_zeros_of_bessel_functions(order):
    for number, told in enumerate(ZEROS[f"J{order}"].split(", "), 1):
        assert told == mpmath.nstr(mpmath.besseljzero(order, number), 10, strip_zeros=False)


@pytest.mark.parametrize("text", [
    beam("clamped", "free", "preload: -P, attached: [{at: L, mass: M}]"),
    beam("free", "free", "preload: N"),
    beam("{k: k, torsion: kt}", "{k: k}", "preload: N, attached: [{at: L, inertia: J}]"),
    beam("guided", "free", "preload: -N, foundation: kf, attached: [{at: L, mass: M}]"),
    beam("pinned", "{torsion: kt}", "preload: N")])
def test_shapes_are_those_of_their_modes(text):
    assert hold_shapes(scene(text)) > 1


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "told"), [(BEAM, "cos βL·cosh βL = −1"), (BAR, "cos βL = 0"), (STRING, "cos βL = 0")])
def test_stretches_on_both_sides_of_a_place_where_nothing_acts_are_one(kind, told):
    """Dampers, which leave the undamped system alone."""
    found = scene(member(*kind, "clamped", "free", "attached: [{at: a, c: cd}, {at: L/2, c: 2*cd}]"))
    lines, = blocks(found)
    assert Printed(lines).text == told and fulfilled(found) == 1
