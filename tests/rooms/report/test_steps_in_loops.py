"""Forces in closed loops are told along small motions too, by the multipliers of the conditions to the first order."""

import re

import pytest
from support.scenes import problem

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import UNITS

CRANK = """
parameters: {{J: 0.01 kg*m^2, m: 0.8 kg, M: 1.5 kg, r: 10 cm, l: 26 cm, b: sqrt(l^2 - r^2), k: 5 kN/m, c: 9 N*s/m}}
points: {{P: {{body: crank, at: [0, r]}}, A: {{body: rod, at: [0, r]}}}}
bodies:
  crank: {{inertia: J, at: [0, 0], pin: phi}}
  piston: {{mass: M, at: [b, 0], slide: x}}
  rod: {{shape: rod, mass: m, from: [b, 0], to: [0, r], pin: {{at: piston, by: psi}}}}
springs: {{s: {{k: k, between: [piston, [2*b, 0]]}}}}
dampers: {{d: {{c: c, between: [piston, [2*b, 0]]}}}}
constraints: {{pin: {{join: [P, A]}}}}
initial: {{phi: 2 deg}}
{more}
answers: {{{answers}}}
"""
LOADED = """
gravity: 9.81 m/s^2
forces: {push: {at: A, force: [0, 5 N]}, drive: {at: A, force: [3 N*sin(30 rad/s*t), 0]}}
"""
AT = "0.2 s"
SIGNALS = {"phi": "", "phi'": " rad/s", "phi''": " rad/s^2", "pin.force.x": " N", "pin.force.y": " N"}


@pytest.mark.sweep
@pytest.mark.parametrize("more", ["", LOADED])
def test_forces_along_small_motions_follow_from_multipliers(more):
    """Held against what the engine finds by its own way."""
    answers = ", ".join(f'"{name}({AT})": 0{unit}' for name, unit in SIGNALS.items())
    found = problem(CRANK.format(more=more, answers=answers))
    lines = {line.settles: line for line in worked(found)}
    values = {name: lines[f"{name}({AT})"].value for name in SIGNALS}
    known = {**found.numeric.floats, **values, **dict.fromkeys(UNITS.values(), 1.0), found.scene.time.name: 0.2}
    for name in ("pin.force.x", "pin.force.y"):
        assert evaluate([lines[name].node], Floats, known)[0] == pytest.approx(values[name], rel=1e-9)
        assert re.search(rf"{name} = −λ_pin_{name[-1]} = ", formula(lines[name].parts, plain))
    assert sum(name.startswith("balance[") for name in lines) == 2 and "multipliers" not in lines
