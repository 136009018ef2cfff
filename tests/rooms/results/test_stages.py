"""Cost of what is not asked: zero. Stages that a question does not need are not run."""

import pytest
from support.scenes import problem

from vibcli.analyses.transient import linear_response
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

FOUR_BAR = """
gravity: 9.81 m/s^2
points: {B: {body: crank, at: [0, 1 m]}, C: {body: coupler, at: [3 m, 2 m]}, D: {body: rocker, at: [3 m, 2 m]}}
bodies:
  crank: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, 1 m], pin: {at: [0, 0], by: alpha}}
  coupler: {shape: rod, mass: 2 kg, from: [0, 1 m], to: [3 m, 2 m], pin: {at: B, by: beta}}
  rocker: {shape: rod, mass: 2 kg, from: [4 m, 0], to: [3 m, 2 m], pin: {at: [4 m, 0], by: gamma}}
springs: {s: {torsion: 300 N*m, between: [ground, crank]}}
constraints: {knee: {join: [C, D]}}
"""
DRIVEN = """
points: {S: {at: [0, 0], moves: [2 cm*sin(3 rad/s*t), 0]}}
bodies: {block: {mass: 2 kg, at: [1 m, 0], slide: x}}
springs: {s: {k: 800 N/m, between: [S, block]}}
forces: {f: {at: block, force: [3 N*sin(5 rad/s*t), 0]}}
"""
FREQUENCIES = {"scene", "linearisation", "equilibrium", "linear_system", "modes"}


@pytest.mark.parametrize("text", [FOUR_BAR, DRIVEN], ids=["loop", "driven"])
def test_frequencies_need_neither_equations_nor_reactions(text):
    found = problem(text)
    assert found.modal.modes
    assert set(found.costs) - {"read", "spec"} == FREQUENCIES
    assert "scene_with_multipliers" not in vars(found.system) and "excitation" not in vars(found.symbolic)


def test_equations_find_no_modes():
    found = problem(FOUR_BAR)
    assert found.symbolic.energies
    assert not {"modes", "linear_system", "equilibrium", "reactions"} & set(found.costs)


def test_reactions_find_no_modes():
    found = problem(FOUR_BAR)
    assert found.configuration.reactions
    assert not {"modes", "linear_system", "energies", "equations"} & set(found.costs)


@pytest.mark.parametrize("signal", ["x", "s"])
def test_an_extreme_is_sought_once(signal, monkeypatch):
    sought, seek = [], linear_response.extreme
    monkeypatch.setattr(linear_response, "extreme", lambda *asked: sought.append(asked) or seek(*asked))
    found = problem(DRIVEN + "find: [{response: {until: 2 s}}]\n")
    values = [measure(found, parse(text))[0] for text in (f"max({signal})", f"argmax({signal})", f"max({signal} + 0)")]
    assert len(sought) == 1 and values[0] == values[2]
