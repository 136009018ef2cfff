"""Frequency equations of members as they are printed: what they say, read back from the text, holds."""

import pytest
from support.equations_in_mpmath import fulfilled
from support.formulas import plain, value
from support.printed_equations import PrintedEquation, numbers, orthogonality, printed
from support.scenes import problem

from vibcli.analyses.continuous.shapes import shape_along
from vibcli.api.reports import report, solution

BAR, BEAM = "EA: 2 MN, mass_per_length: 2.5 kg/m", "EI: 4 kN*m^2, mass_per_length: 2.5 kg/m"
SHAFT = "GIo: 4 kN*m^2, inertia_per_length: 2 kg*m"
LUMPED = {
    "a block that slides against the axis": f"""
        parameters: {{L: 1.2 m, M: 3 kg}}
        bars: {{rod: {{from: [0, 0], to: [L, 0], {BAR}, left: clamped, right: {{clamped: block}}}}}}
        bodies: {{block: {{mass: M, at: [L, 0], slide: {{along: [-1, 0], by: x}}}}}}
        """,
    "a block below a beam, with another on a spring that slides along the first": f"""
        parameters: {{L: 1.2 m, M: 3 kg, m: 1 kg, k: 4 kN/m}}
        gravity: 9.81 m/s^2
        beams: {{wing: {{from: [0, 0], to: [L, 0], {BEAM}, left: clamped, right: {{pinned: block}}}}}}
        bodies:
          block: {{mass: M, at: [L, 0], slide: {{along: [0, -1], by: y}}}}
          hung: {{mass: m, at: [L, -0.3 m], slide: {{along: [0, 1], by: z, carrier: block}}}}
        springs: {{s: {{between: [block, hung], k: k}}}}
        """,
    "a gear that turns more than its coordinate": f"""
        coordinates: [phi]
        parameters: {{L: 1.2 m, J1: 3 kg*m^2, J2: 1 kg*m^2, kt: 5 kN*m, r: 2}}
        shafts: {{line: {{length: L, {SHAFT}, left: clamped, right: {{clamped: gear}}}}}}
        bodies: {{gear: {{inertia: J1, turn: -r*phi}}, other: {{inertia: J2, turn: psi}}}}
        springs: {{s: {{between: [gear, other], torsion: kt}}}}
        """,
    "a clamped end that moves by a lever": f"""
        coordinates: [phi]
        parameters: {{L: 1.2 m, M: 3 kg, b: 0.4 m}}
        bars: {{rod: {{length: L, {BAR}, left: {{k: 40 kN/m}}, right: {{clamped: block}}}}}}
        bodies: {{block: {{mass: M, slide: -b*phi}}}}
        """,
    "a pendulum below a block at the end of a bar": f"""
        parameters: {{L: 1.2 m, M: 3 kg, m: 1 kg, l: 0.3 m}}
        gravity: 9.81 m/s^2
        bars: {{rod: {{from: [0, 0], to: [L, 0], {BAR}, left: clamped, right: {{clamped: block}}}}}}
        bodies:
          block: {{mass: M, at: [L, 0], slide: {{along: [-1, 0], by: y}}}}
          bob: {{mass: m, at: [L, -l], pin: {{at: [L, 0], carrier: block, by: phi}}}}
        """,
    "masses, inertias and oscillators at an end and within": f"""
        parameters: {{L: 1.2 m, M: 3 kg, m: 1 kg, J: 0.1 kg*m^2}}
        beams: {{wing: {{length: L, {BEAM}, left: clamped, attached: [{{at: L/2, mass: M, inertia: J}},
                        {{at: L, inertia: J}}, {{at: L, oscillator: {{mass: m, k: 500 N/m}}}},
                        {{at: L, oscillator: {{mass: 2*m, k: 500 N/m}}}}]}}}}
        """,
    "a hanging chain with a mass and an oscillator": """
        parameters: {L: 1.2 m, M: 3 kg, m: 1 kg, g: 9.81 m/s^2}
        gravity: g
        strings: {cord: {from: [0, 0], to: [0, -L], mass_per_length: 2.5 kg/m, left: pinned,
                         attached: [{at: L, mass: M}, {at: L, oscillator: {mass: m, k: 30 N/m}}]}}
        """,
    "two bars end to end about a block that slides against both": f"""
        parameters: {{L: 1.2 m, M: 3 kg}}
        bars:
          one: {{from: [0, 0], to: [L, 0], {BAR}, left: clamped, right: {{clamped: block}}}}
          two: {{from: [L, 0], to: [3*L, 0], {BAR}, left: {{clamped: block}}}}
        bodies: {{block: {{mass: M, at: [L, 0], slide: {{along: [-1, 0], by: x}}}}}}
        """,
}


@pytest.mark.parametrize("text", LUMPED.values(), ids=LUMPED)
def test_modes_are_orthogonal_as_printed(text):
    """Whatever the sense or measure in which what is lumped moves, and however what hangs on it is coupled."""
    scene = problem(text)
    lines, = printed(scene)
    told = next(line for line in lines if "X_i" in line)
    modes = [mode for mode in scene.modal.modes.first(4) if mode.omega]
    for k, mode in enumerate(modes):
        for other in modes[:k]:
            total, size = orthogonality(scene, told, list(scene.scene.members), (mode, other))
            assert size > 0
            assert abs(total) <= 1e-10 * size, told


PAIRS = {
    "bars on both sides of a block": """
        parameters: {L: 1.2 m, M: 3 kg, k: 40 kN/m, m: 1 kg, E: 70 GPa, rho: 2700 kg/m^3, d: 20 mm}
        bars:
          one: {length: L, E: E, rho: rho, section: {circle: d}, left: clamped, right: {clamped: block}}
          two: {length: 2*L, E: E, rho: rho, section: {circle: 2*d}, left: {k: k}, right: {clamped: other},
                attached: [{at: 0, mass: m}]}
        coordinates: [x]
        bodies: {block: {mass: M, slide: x}, other: {slide: -x}}
        springs: {s: {between: [ground, block], k: k}}
        """,
    "shafts through a pair of gears": """
        parameters: {L: 1.2 m, GIo: 4 kN*m^2, j: 0.02 kg*m, J1: 0.01 kg*m^2, J2: 0.2 kg*m^2, r1: 60 mm, r2: 150 mm}
        bodies: {pinion: {inertia: J1, turn: phi1}, wheel: {inertia: J2, turn: phi2}}
        shafts:
          one: {length: L, GIo: GIo, inertia_per_length: j, right: {clamped: pinion}, attached: [{at: 0, inertia: J2}]}
          two: {length: 2*L, GIo: 3*GIo, inertia_per_length: j, left: {clamped: wheel}, right: clamped}
        constraints: {mesh: {equation: r1*phi1 = -r2*phi2}}
        """,
    "beams that a spring ties": """
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, M: 3 kg, k: 40 kN/m}
        beams:
          upper: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {pinned: block}}
          lower: {length: 2*L, EI: 3*EI, mass_per_length: mu, left: {pinned: other}, right: clamped}
        bodies: {block: {mass: M, slide: x}, other: {mass: 2*M, slide: y}}
        springs: {s: {between: [block, other], k: k}}
        """,
    "equal columns under a floor": """
        parameters: {H: 3 m, EI: 4 MN*m^2, mu: 60 kg/m, M: 900 kg}
        beams:
          one: {length: H, EI: EI, mass_per_length: mu, left: clamped, right: {clamped: floor}}
          two: {length: H, EI: EI, mass_per_length: mu, left: clamped, right: {clamped: floor}}
        bodies: {floor: {mass: M, slide: x}}
        """,
    "equal beams on a spring": """
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, k: 40 kN/m}
        coordinates: [x, y]
        beams:
          upper: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {pinned: block}}
          lower: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {pinned: other}}
        bodies: {block: {slide: x}, other: {slide: y}}
        springs: {s: {between: [block, other], k: k}}
        """,
    "a string at the tip of a beam, in a bed, with an oscillator": """
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, S: 900 N, kf: 9 kN/m^2, m: 1 kg, k: 3 kN/m}
        beams: {mast: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: {pinned: tip}, foundation: kf}}
        strings: {cord: {length: 2*L, preload: S, mass_per_length: mu/10, left: {clamped: tip}, right: {k: k},
                         attached: [{at: 2*L, mass: m}]}}
        bodies: {tip: {slide: x}, weight: {mass: m, slide: z}}
        springs: {s: {between: [tip, weight], k: k}}
        """,
    "a string in a bed that a mass at its end draws below what the bed alone would have": """
        parameters: {L: 1.2 m, mu: 0.2 kg/m, S: 900 N, kf: 9 kN/m^2, M: 40 kg}
        strings: {cord: {length: L, preload: S, mass_per_length: mu, left: clamped, foundation: kf,
                         attached: [{at: L, mass: M}]}}
        """,
    "a beam in a bed that a mass at its end draws below what the bed alone would have": """
        parameters: {L: 1.2 m, mu: 2 kg/m, EI: 4 kN*m^2, kf: 90 kN/m^2, M: 90 kg, kt: 2 kN*m}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: {torsion: kt}, foundation: kf,
                    attached: [{at: L, mass: M}]}}
        """,
    "a beam on springs with a mass and an oscillator": """
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, k: 40 kN/m, kt: 2 kN*m, M: 3 kg, m: 1 kg}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: {k: k, torsion: kt},
                    attached: [{at: L, mass: M}, {at: L, oscillator: {mass: m, k: k/40}}]}}
        """,
    "a beam with a body whose mass centre is beyond its tip": """
        parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m, M: 5 kg, J: 0.3 kg*m^2, e: 0.2 m}
        beams: {arm: {from: [0, 0], to: [L, 0], EI: EI, mass_per_length: mu, left: clamped, right: {clamped: motor}}}
        bodies: {motor: {shape: rectangle, width: 2*e, height: e, mass: M, inertia: J, at: [L + e, 0],
                         move: [x, y, psi]}}
        """,
    "a beam whose left end carries such a body": """
        parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m, M: 5 kg, J: 0.3 kg*m^2, e: 0.2 m, k: 9 kN/m}
        beams: {arm: {from: [0, 0], to: [2*L, 0], EI: EI, mass_per_length: mu, left: {clamped: motor}, right: {k: k}}}
        bodies: {motor: {shape: rectangle, width: 2*e, height: e, mass: M, inertia: J, at: [-e, 0], move: [x, y, psi]}}
        """,
    "a beam under a dead load with a mass at its tip": """
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, P: 5 kN, M: 3 kg}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped, preload: -P, attached: [{at: L, mass: M}]}}
        """,
    "a stepped bar with a mass at its step and on a spring": """
        parameters: {L: 1.2 m, EA: 2 MN, mu: 2 kg/m, M: 3 kg, k: 900 kN/m}
        bars: {b: {segments: [{length: L, EA: EA}, {length: 2*L, EA: 3*EA}], mass_per_length: mu, left: {k: k},
                   attached: [{at: L, mass: M}]}}
        """,
}


@pytest.mark.sweep
@pytest.mark.parametrize("text", PAIRS.values(), ids=PAIRS)
def test_roots_of_what_is_printed_are_the_frequencies(text):
    """All of them and no others, as its lines are read."""
    scene = problem(text)
    modes = [float(mode.omega) for mode in scene.modal.modes.first(8) if mode.omega]
    lines, = printed(scene)
    found = PrintedEquation(lines).roots(numbers(scene), modes[-1] * (1 + 1e-6))
    assert found == pytest.approx(modes, rel=1e-9)


@pytest.mark.parametrize("text", [text for name, text in PAIRS.items() if name[:6] != "equal "])
def test_what_is_printed_of_pairs_is_orthogonal(text):
    scene = problem(text)
    lines, = printed(scene)
    told = next(line for line in lines if "X_i" in line)
    one, other = [mode for mode in scene.modal.modes.first(4) if mode.omega][:2]
    total, size = orthogonality(scene, told, list(scene.scene.members), (one, other))
    assert abs(total) <= 1e-9 * size


@pytest.mark.parametrize("text", [*PAIRS.values(), *LUMPED.values()])
def test_what_is_printed_is_zero_at_the_frequencies_alone(text):
    """The nodes of the lines, by mpmath."""
    assert fulfilled(problem(text), 4) == 1


@pytest.mark.sweep
def test_what_has_no_equation_in_closed_form_tells_its_determinant():
    (line,), = printed(problem("""
        parameters: {L: 1.2 m, EI: 4 kN*m^2, mu: 2 kg/m, M: 3 kg}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped, preload: 300 N,
                    attached: [{at: L/3, mass: M}, {at: 2*L/3, mass: M}]}}
        """))
    assert line.startswith("det D(ω) = 0,  6 × 6")
    (line, why, *_), = printed(problem("""
        gravity: 9.81
        beams: {mast: {from: [0, 0], to: [0, 2], EI: 400, mass_per_length: 2, left: clamped}}
        """))
    assert line.startswith("det D(ω) = 0,  2 × 2") and "no shape in elementary functions" in why


SHAPED = {**{name: text for name, text in PAIRS.items() if name.startswith(("a beam", "a string in"))},
          "a bar on a spring with a mass and an oscillator": """
        parameters: {L: 1.2 m, EA: 2 MN, mu: 2 kg/m, k: 900 kN/m, M: 3 kg, m: 1 kg}
        bars: {b: {length: L, EA: EA, mass_per_length: mu, left: {k: k}, right: {k: 2*k},
                   attached: [{at: 0 m, mass: M}, {at: 0 m, oscillator: {mass: m, k: k/40}}]}}
        """}


@pytest.mark.parametrize("text", SHAPED.values(), ids=SHAPED)
def test_shapes_are_those_that_are_printed(text):
    """X(x) at any left end, up to a factor."""
    scene = problem(text)
    (lines,), (name,) = printed(scene), scene.scene.members
    equation, values = PrintedEquation(lines), numbers(scene)
    if "X(x)" not in equation.means:
        assert "left end carries such a body" in next(key for key, one in SHAPED.items() if one is text)
        return
    for mode in [mode for mode in scene.modal.modes.first(5) if mode.omega]:
        root = equation.at(float(mode.omega), values)
        pieces = scene.modal.fields(mode).pieces(name)
        length = pieces[-1].start + pieces[-1].piece.length
        shares = [0.0, 0.21, 0.43, 0.77, 1.0]
        told = [equation.shape(root, share, values) for share in shares]
        moved = shape_along(pieces, [share * length for share in shares])[:, 0]
        largest = max(range(5), key=lambda k: abs(moved[k]))
        factor = moved[largest] / told[largest]
        assert [factor * one for one in told] == pytest.approx(list(moved), abs=1e-7 * abs(moved[largest]))


@pytest.mark.parametrize("left", ["clamped", "free"])
def test_shapes_on_both_sides_of_an_inner_place_are_those_of_numbers(left):
    """In letters, by θ₁ and θ₂ and the lengths."""
    text = "bars: {b: {segments: [{length: a, EA: EA}, {length: L, EA: 2*EA}], mass_per_length: mu, " \
        f"left: {left}, right: {{k: k}}}}}}"
    values = {"L": "0.7 m", "a": "0.3 m", "EA": "9 kN", "mu": "2 kg/m", "k": "900 N/m"}
    letters, found = (problem("parameters: {" + ", ".join(f"{name}: {how(name)}" for name in values) + "}\n" + text)
                      for how in (lambda _: "", values.get))
    (lines,), known = printed(letters), numbers(found)
    equation = PrintedEquation(lines)
    shapes = [line.partition(" = ")[2].partition("   ")[0] for line in lines if line.startswith("X(x)")]
    for mode in [mode for mode in found.modal.modes.first(4) if mode.omega]:
        names = equation.names(equation.at(float(mode.omega), known), known)
        left, right = (value(plain(shape), lambda name, x=x, names=names: x if name == "x" else names(name))
                       for shape, x in zip(shapes, (0.1, 0.8), strict=True))
        moved = shape_along(found.modal.fields(mode).pieces("b"), [0.1, 0.8])[:, 0]
        assert left * moved[1] == pytest.approx(right * moved[0], rel=1e-7)


def test_letters_of_equations_are_none_of_the_scene():
    one, three = printed(problem("""
        parameters: {L: , EA: , mu: , M: , k: , omega: , k1: {unit: N/m}, Z: }
        bars:
          one: {length: L, EA: EA, mass_per_length: mu, left: {k: k}, right: {clamped: b}, attached: [{at: 0, mass: M}]}
          two: {length: L, EA: EA, mass_per_length: mu, left: {clamped: b}}
          three: {length: L, EA: EA*Z, mass_per_length: mu*k1/k, left: {k: k}, right: clamped,
                  attached: [{at: 0, mass: M*omega}]}
        bodies: {b: {mass: M, slide: x}}
        springs: {s: {between: [ground, b], k: k1}}
        """))
    assert one[0] == "k₁ + D₁ + D₂ − M·ν² = 0,  ν the circular frequency" and "Q = k − M·ν²" in one
    assert three[:3] == ["tan\u00a0βL = −EA·Z·βL/(L·Q)", "Q = k − M·ω·ν²", "ν = βL·√(EA·k·Z/(μ·k₁))/L"]


def test_equations_that_are_asked_for_have_the_frequency_equation_with_them():
    found = problem("""
        beams: {wing: {length: 2, EI: 3, mass_per_length: 1, left: clamped}}
        find: [equations]
        """)
    titles = [section.title for section in report(found, solution(found)).sections]
    assert titles[-2:] == ["Equations of free vibration", "Frequency equation"]


def test_what_moves_apart_from_members_is_told():
    """An oscillator on a clamped end."""
    found = problem("""
        beams: {b: {length: 2, EI: 3, mass_per_length: 1, left: clamped, right: clamped,
                    attached: [{at: 2, oscillator: {mass: 1, k: 4}}]}}
        find: [equations]
        """)
    *_, last = report(found, solution(found)).sections[-1].blocks
    assert "".join(part for part in last.parts if isinstance(part, str)).startswith(" moves apart from these members")


BARE = """
bars: {b: {length: 1.5 m, EA: 2 kN, mass_per_length: 0.4 kg/m, left: clamped, attached: [{at: 0.7 m, mass: 3 kg}]}}
beams: {c: {length: 2 m, EI: 200 N*m^2, mass_per_length: 0.4 kg/m, left: clamped, attached: [
  {at: 2 m, mass: 2 kg, inertia: 0.1 kg*m^2}]}}
"""


def test_numbers_of_the_file_keep_their_units():
    """Inertia, places, lengths and the frequency, all without a letter."""
    told = [one for lines in printed(problem(BARE)) for one in lines]
    assert "L = 2\u00a0m" in told and "ω = (5.590169944\u00a0rad/s)·(βL)²" in told
    assert [one.replace("\u00a0", " ") for one in told if "X_i" in one] == [
        "∫(0.4 kg/m)·X_i·X_j·dx + (3 kg)·X_i(0.7 m)·X_j(0.7 m) = 0, ω_i ≠ ω_j",
        "∫(0.4 kg/m)·X_i·X_j·dx + (2 kg)·X_i(2 m)·X_j(2 m) + (0.1 kg·m²)·∂X_i/∂x(2 m)·∂X_j/∂x(2 m) = 0, ω_i ≠ ω_j"]
