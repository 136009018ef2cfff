"""Frequency equations of members as they are printed: what they say, read back from the text, holds."""

import pytest
from support.printed_equations import orthogonality, printed
from support.scenes import problem

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
