"""Equations and conditions of members as printed, against those that are written by hand from the balance of forces."""

import pytest

from vibcli.cli import main

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


@pytest.mark.parametrize("scene, told", [
    (MAST, ["1000·∂⁴u/∂x⁴ + g·(3·L + 2)·∂²u/∂x² − 3·g·x·∂²u/∂x² − 3·g·∂u/∂x + 3·∂²u/∂t² = 0",
            "at x = L: 1000·∂³u/∂x³ + 2·g·∂u/∂x = 2·∂²u/∂t², 1000·∂²u/∂x² = 0",
            "V = ½·∫(1000·(∂²u/∂x²)² − g·(3·L + 2)·(∂u/∂x)² + 3·g·x·(∂u/∂x)²)·dx"]),
    (CHAIN, ["at x = L: M·g·∂u/∂x = −M·∂²u/∂t²",
             "at x = L/2: g·(L·μ/2 + M)·∂u/∂x(+) − g·(L·μ/2 + M + m)·∂u/∂x(−) = m·∂²u/∂t²",
             "(+) is what holds right of it"]),
    (STEPPED, ["at x = L/2: EA·∂u/∂x(+) − 2·EA·∂u/∂x(−) = 0",
               "V = ½·∫2·EA·(∂u/∂x)²·dx (0 < x < L/2) + ½·∫EA·(∂u/∂x)²·dx (L/2 < x < L)",
               "T = ½·∫μ·(∂u/∂t)²·dx"]),
    (HELD, ["at x = L/2: [1000·∂³u/∂x³] = −1000·∂³u/∂x³ of arm at x = 0, "
            "[1000·∂²u/∂x²] = −1000·∂²u/∂x² of arm at x = 0"]),
    (PULLED, ["at x = L: 1000·∂³u/∂x³ − N·∂u/∂x = 0, 1000·∂²u/∂x² = 0"]),
])
def test_forces_on_stations_balance(tmp_path, capsys, scene, told):
    path = tmp_path / "scene.yaml"
    path.write_text("title: one" + scene)
    with pytest.raises(SystemExit) as ended:
        main(["equations", str(path)])
    assert not ended.value.code
    printed = " ".join(capsys.readouterr().out.split())
    assert [text for text in told if text not in printed] == []


@pytest.mark.parametrize("more, told", [("", "cos βL = 0"), (", preload: EI/L^2", "no frequency equation is found")])
def test_frequencies_in_letters_stand_below_their_equation(tmp_path, capsys, more, told):
    path = tmp_path / "scene.yaml"
    kind = f"beams: {{b: {{length: L, EI: EI, mass_per_length: mu, left: pinned, right: guided{more}}}}}"
    path.write_text("title: one\nparameters: {L: , EI: , mu: }\n" + kind + "\nfind: [{modes: 2}]\n")
    for command in ("solve", "frequencies"):
        with pytest.raises(SystemExit) as ended:
            main([command, str(path)])
        assert not ended.value.code
        assert capsys.readouterr().out.count(told) == 1
