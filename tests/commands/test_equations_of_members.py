"""Equations and conditions of members as printed, against those that are written by hand from the balance of forces."""

import pytest
from support.scenes import problem

from vibcli.cli.program import main

BEAM = "EI: 1000 N*m^2, mass_per_length: 3 kg/m"
MAST = f"""
parameters: {{L: 1 m, g: 9.81 m/s^2}}
gravity: g
beams: {{mast: {{from: [0, 0], to: [0, L], {BEAM}, left: clamped, attached: [{{at: L, mass: 2 kg}}]}}}}
"""                             # N(x) = -g (2 + 3 (L - x)); at the top EI u''' - N u' = M u.., N(L) = -2 g
CHAIN = """
parameters: {L: 1 m, M: 2 kg, m: 1 kg, g: 9.81 m/s^2, mu: 0.1 kg/m}
gravity: g
strings: {c: {from: [0, L], to: [0, 0], mass_per_length: mu, left: clamped,
              attached: [{at: L, mass: M}, {at: L/2, mass: m}]}}
"""
STEPPED = """
parameters: {L: 1 m, EA: 1 kN, mu: 1 kg/m}
bars: {b: {segments: [{length: L/2, EA: 2*EA}, {length: L/2, EA: EA}], mass_per_length: mu, left: clamped}}
"""
HELD = f"""
parameters: {{L: 1 m}}
beams:
  girder: {{length: L, {BEAM}, left: pinned, right: pinned}}
  arm: {{length: L/2, {BEAM}, left: {{clamped: girder, at: L/2}}}}
"""
PULLED = f"""
parameters: {{L: 1 m, N: 5 kN}}
beams: {{b: {{length: L, {BEAM}, left: clamped, preload: N}}}}
"""
CART = f"""
parameters: {{L: 1 m, M: 2 kg, k: 3 kN/m}}
bodies: {{cart: {{mass: M, slide: PLACE}}}}
springs: {{s: {{between: [ground, cart], k: k}}}}
beams: {{mast: {{length: L, {BEAM}, left: clamped, right: {{pinned: cart}}}}}}
"""                             # where the body moves by x the place along the mast is another letter
ITS_PLACE = CART.replace("PLACE", "x")
BAR = """
points: {tip: {body: rod, at: 2 m}}
springs: {above: {k: 200 N/m, between: [tip, [2 m, 3 m]]}, beyond: {k: 50 N/m, between: [tip, [5 m, 0]]}}
bars: {rod: {from: [0, 0], to: [2 m, 0], EA: 500 N, mass_per_length: 2 kg/m, left: pinned,
             attached: [{at: 0.5 m, k: 30 N/m}]}}
"""                             # as it turns it is a rod of 4 kg, 4 kg/3 at its end


@pytest.mark.parametrize("scene, told", [
    (BAR, ["at x = 0: u = 0", "at x = 0.5 m: [(500 N)·∂u/∂x] = (30 N/m)·u",
           "at x = 2 m: (500 N)·∂u/∂x = −(50 N/m)·u",
           "(1.33333 kg)·d²/dt² rod.across(2 m) + (200 N/m)·rod.across(2 m) = 0"]),
    (MAST, ["(1000 N·m²)·∂⁴u/∂x⁴ + g·((3 kg/m)·L + 2 kg)·∂²u/∂x² − (3 kg/m)·g·x·∂²u/∂x² − (3 kg/m)·g·∂u/∂x "
            "+ (3 kg/m)·∂²u/∂t² = 0",
            "at x = L: (1000 N·m²)·∂³u/∂x³ + (2 kg)·g·∂u/∂x = (2 kg)·∂²u/∂t², (1000 N·m²)·∂²u/∂x² = 0",
            "V = ½·∫((1000 N·m²)·(∂²u/∂x²)² − g·((3 kg/m)·L + 2 kg)·(∂u/∂x)² + (3 kg/m)·g·x·(∂u/∂x)²)·dx"]),
    (CHAIN, ["at x = L: M·g·∂u/∂x = −M·∂²u/∂t²",
             "at x = L/2: g·(L·μ/2 + M)·∂u/∂x(+) − g·(L·μ/2 + M + m)·∂u/∂x(−) = m·∂²u/∂t²",
             "(+) is what holds right of a place"]),
    (STEPPED, ["at x = L/2: EA·∂u/∂x(+) − 2·EA·∂u/∂x(−) = 0",
               "V = ½·∫2·EA·(∂u/∂x)²·dx (0 < x < L/2) + ½·∫EA·(∂u/∂x)²·dx (L/2 < x < L)",
               "T = ½·∫μ·(∂u/∂t)²·dx"]),
    (HELD, ["at x = L/2: [(1000 N·m²)·∂³u/∂x³] = −(1000 N·m²)·∂³u/∂x³ of arm at x = 0, "
            "[(1000 N·m²)·∂²u/∂x²] = −(1000 N·m²)·∂²u/∂x² of arm at x = 0"]),
    (ITS_PLACE, ["(1000 N·m²)·∂⁴u/∂ξ⁴ + (3 kg/m)·∂²u/∂t² = 0", "at ξ = 0: u = 0, ∂u/∂ξ = 0",
                 "at ξ = L: u = x, (1000 N·m²)·∂²u/∂ξ² = 0",
                 "x: M·ẍ + k·x = (1000 N·m²)·∂³u/∂ξ³ of mast at ξ = L", "½·∫(3 kg/m)·(∂u/∂t)²·dξ",
                 "ξ counts from the left end"]),
    (CART.replace("PLACE", "y"), ["at x = L: u = y, (1000 N·m²)·∂²u/∂x² = 0"]),
    (ITS_PLACE.replace("L: 1 m", "L: 1 m, xi: {value: 1, unused: allowed}"),
     ["at s = L: u = x, (1000 N·m²)·∂²u/∂s² = 0"]),
    (CART.replace("PLACE", "u"), ["at x = L: w = u, (1000 N·m²)·∂²w/∂x² = 0"]),
    (PULLED, ["at x = L: (1000 N·m²)·∂³u/∂x³ − N·∂u/∂x = 0, (1000 N·m²)·∂²u/∂x² = 0"]),
])
def test_forces_on_stations_balance(tmp_path, capsys, scene, told):
    path = tmp_path / "scene.yaml"
    path.write_text("title: one" + scene)
    with pytest.raises(SystemExit) as ended:
        main(["equations", str(path)])
    assert not ended.value.code
    printed = " ".join(capsys.readouterr().out.split())
    assert [text for text in told if text not in printed] == []


def test_steps_tell_the_place_by_another_letter_than_a_coordinate(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("title: one" + ITS_PLACE + "\nfind: [{modes: 1}]\n")
    with pytest.raises(SystemExit) as ended:
        main(["solve", str(path), "--steps"])
    printed = " ".join(capsys.readouterr().out.split())
    assert not ended.value.code
    assert "∂x" not in printed and all(text in printed for text in (
        "u(ξ, t): displacement of mast at ξ, counted from its left end", "motion of an element dξ: ",
        "X(ξ)·sin(ω·t + ε)", "at ξ = L: u = x", "X = C₁·(cosh βξ − cos βξ) + C₂·(sinh βξ − sin βξ)"))


@pytest.mark.parametrize("more, told", [("", "cos βL = 0"), (", preload: EI/L^2", "cos βL = 0"), (
    ", preload: EI/L^2, attached: [{at: L, mass: mu*L}]", "αL = √"), (
    ", preload: EI/L^2, attached: [{at: L/2, mass: mu*L}]", "(k₁ + k₂ − L·μ·ω²)·(R₁ + R₂) = (G₁ + G₂)²"), (
    ", preload: EI/L^2, attached: [{at: L/3, mass: mu*L}, {at: L/2, k: EI/L^3}]", "det D(ω) = 0")])
def test_frequencies_in_letters_stand_below_their_equation(tmp_path, capsys, more, told):
    path = tmp_path / "scene.yaml"
    kind = f"beams: {{b: {{length: L, EI: EI, mass_per_length: mu, left: pinned, right: guided{more}}}}}"
    path.write_text("title: one\nparameters: {L: , EI: , mu: }\n" + kind + "\nfind: [{modes: 2}]\n")
    for command in ("solve", "frequencies"):
        with pytest.raises(SystemExit) as ended:
            main([command, str(path)])
        assert not ended.value.code
        assert capsys.readouterr().out.count(told) == 1


@pytest.mark.parametrize("how", ["first", "largest", "mass"])
def test_the_mode_in_which_a_bar_turns_has_a_shape(how):
    modal = problem("title: one" + BAR).modal
    turning, stretching = modal.modes.first(2)
    assert turning.omega == pytest.approx(150**0.5, rel=1e-14)
    found = [abs(x) for x in modal.shape(turning, how)]
    assert found == pytest.approx([0.75**0.5 if how == "mass" else 1, 0, 0], abs=1e-14)
    assert modal.shape(stretching, how)[0] == 0
