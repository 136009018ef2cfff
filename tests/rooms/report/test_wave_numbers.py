"""β beside the frequencies of members: B β⁴ + N β² + k = μ ω², of members that differ one each."""

import pytest
from support.scenes import problem

from vibcli.report.sections.wave_numbers import wave_numbers

ONE = "length: 1.2, EI: 4000, mass_per_length: 2"
TOLD = {
    f"beams: {{b: {{{ONE}, left: clamped}}}}": (["β [1/m]"], None),
    f"beams: {{b: {{{ONE}, left: clamped, foundation: 9e6}}}}": (["β [1/m]"], "(EI·β⁴ + k = μ·ω²)"),
    f"beams: {{b: {{{ONE}, left: clamped, preload: -2000}}}}": (["β [1/m]"], "(EI·β⁴ + N·β² = μ·ω²)"),
    f"beams: {{b: {{{ONE}, left: clamped, foundation: 9000, preload: 2000}}}}": (
        ["β [1/m]"], "(EI·β⁴ + N·β² + k = μ·ω²)"),
    f"parameters: {{N: 900, k: 9000}}\nbeams: {{b: {{{ONE}, left: clamped, foundation: k, preload: N}}}}": (
        ["β [1/m]"], "(EI·β⁴ + N·β² + k = μ·ω²)"),
    "strings: {c: {length: 2, preload: 900, mass_per_length: 0.1, left: pinned, right: pinned, foundation: 5}}": (
        ["β [1/m]"], "(N·β² + k = μ·ω²)"),
    f"""
    beams: {{b: {{{ONE}, left: clamped}}, d: {{{ONE}, left: pinned, right: pinned}}}}
    shafts: {{s: {{length: 2, GIo: 3, inertia_per_length: 0.1, left: clamped}}}}
    """: (["β of s [1/m]", "β of b, … [1/m]"], None),
    """
    bars: {b: {segments: [{length: 1, EA: 2}, {length: 2, EA: 9}], mass_per_length: 2, left: clamped}}
    """: (["β of b from 0 m [1/m]", "β of b from 1 m [1/m]"], None),
    f"""
    beams: {{b: {{{ONE}, left: clamped}}, d: {{length: 1, EI: 1, mass_per_length: 1, left: clamped}}}}
    shafts: {{s: {{length: 2, GIo: 3, inertia_per_length: 0.1, left: clamped}}}}
    """: (["β of s [1/m]"], None),
}


@pytest.mark.parametrize("text", TOLD, ids=range(len(TOLD)))
def test_each_has_its_own(text):
    found = problem(text)
    modes = found.modal.modes.first(4)
    columns, definition = wave_numbers(found, modes)
    assert ([head for head, _ in columns], definition and "".join(definition.parts)) == TOLD[text]
    pieces = [placed.piece for placed in found.configuration.linear_system.pieces]
    told = [next(piece for piece in pieces if placed_in(head, found, piece)) for head, _ in columns]
    for piece, (_, betas) in zip(told, columns, strict=True):
        for mode, beta in zip(modes, betas, strict=True):
            x2 = float(beta) ** 2
            stiffness = piece.bending * x2 + piece.tension if piece.bending else piece.tension
            assert stiffness * x2 + piece.foundation == pytest.approx(piece.inertia * mode.omega ** 2, rel=2e-5)


def placed_in(head, found, piece):
    """Is a piece that of which a head speaks?"""
    places = [placed for placed in found.configuration.linear_system.pieces if placed.piece is piece]
    name, _, start = head.removeprefix("β of ").removesuffix(" [1/m]").removesuffix(", …").partition(" from ")
    return head == "β [1/m]" or any(placed.owner == name and float(placed.start) == float(start[:-2] or placed.start)
                                    for placed in places)


@pytest.mark.sweep
def test_none_is_told_where_it_is_not_real():
    """A heavy tip draws the first mode below √(k/μ); the tension of a hanging chain varies."""
    heavy = problem(f"beams: {{b: {{{ONE}, foundation: 90000, attached: [{{at: 1.2, mass: 90}}]}}}}")
    (_, betas), = wave_numbers(heavy, heavy.modal.modes.first(3))[0]
    assert betas[0] == "–" and all(float(one) > 0 for one in betas[2:])
    chain = problem("""
        gravity: 9.81
        strings: {c: {from: [0, 0], to: [0, -2], mass_per_length: 3, left: pinned}}
        """)
    assert wave_numbers(chain, chain.modal.modes.first(3)) == ([], None)
