"""Formulas of a report keep the units of the numbers that its file holds; its data are in SI units alone."""

import pytest
from support.scenes import problem

from vibcli.report.document import Report
from vibcli.report.formats.text import section_lines

SCENE = """
parameters: {m: 2 kg, L: 1 m, k: 500 N/m, c: 4 N*s/m}
points: {P: {body: rod, at: [0.2 m + L, 0]}}
bodies:
  rod: {shape: rod, mass: m, from: [0, 0], to: [L + 0.3 m, 0], pin: {at: [0, 0], by: phi}}
  block: {mass: 3 kg, slide: x}
springs: {s: {k: k, between: [P, [0.2 m + L, -0.4 m]]}, b: {k: 800 N/m, between: [ground, block]}}
dampers: {d: {c: c, between: [[L/2, -0.3 m], P]}}
"""

MEMBER = """
bars:
  rod: {left: clamped, EA: 3 MN, segments: [{length: 0.3 m, mass_per_length: 2 kg/m},
    {length: 0.45 m, mass_per_length: 3 kg/m}], attached: [{at: 0.6 m, mass: 0.5 kg}, {at: 0.75 m, c: 3 N*s/m}]}
"""


@pytest.fixture(scope="module")
def found():
    return sections(SCENE, "given", "energies", "equations", "matrices", "frequencies")


def sections(text, *names):
    report = Report(problem(text))
    for name in names:
        report.add(name)
    return {section.title: "\n".join(section_lines([section])).replace("\u00a0", " ") for section in report.sections}


@pytest.mark.parametrize(("title", "formula"), [
    ("Kinetic energy", "T = m·(L + 0.3 m)²·φ̇²/6 + (1.5 kg)·ẋ²"),
    ("Potential energy", "V = (400 N/m)·x² + k·(ℓ₁ − 0.4 m)²/2"),
    ("Equations of motion", "x:  (3 kg)·ẍ + (800 N/m)·x = 0"),
    ("Equations of motion", "φ:  m·(L + 0.3 m)²·φ̈/3 + "), ("Given", "m = 2 kg   L = 1 m   k = 500 N/m   c = 4 N·s/m")])
def test_formulas_keep_units(found, title, formula):
    assert formula in found[title]


def test_letters_of_units_are_told_nowhere(found):
    assert not any("1 kg = " in text or "1 m = " in text for text in found.values())


def test_formulas_of_members_keep_units_and_their_modes_are_found_once():
    """At x = 3/5 the jump was 1/2·∂²u/∂t²."""
    told = sections(MEMBER, "energies", "equations")
    assert "(0.25 kg)·rod.u̇(0.6 m)² + ½·∫(2 kg/m)·(∂u/∂t)²·dx (0 < x < 0.3 m)" in told["Kinetic energy"]
    rod = told["Equations of free vibration"]
    assert "(3000000 N)·∂²u/∂x² = (3 kg/m)·∂²u/∂t²     (0.3 m < x < 0.75 m)" in rod
    assert "at x = 0.6 m:  [(3000000 N)·∂u/∂x] = (0.5 kg)·∂²u/∂t²" in rod
    assert "at x = 0.75 m:  (3000000 N)·∂u/∂x = −(3 N·s/m)·∂u/∂t" in rod
    report = Report(problem(MEMBER))
    report.add("frequencies")
    assert "_measured" not in vars(report)


def test_forces_at_rest_and_preloads_keep_them():
    """A plate of 2 kg with a weight beside it on a spring that holds them as drawn, and on one that gives way."""
    text = """
gravity: 9.81 m/s^2
bodies:
  a: {mass: 2 kg, at: [0 m, 1 m], slide: {along: [0, 1], by: y}}
  b: {mass: 3 kg, at: [0.2 m, 0.1 m], weld: a}
springs: {s: {k: 900 N/m, between: [[0 m, 0 m], a]%s}}
"""
    told = {}
    for preload in (", preload: static", ""):
        report = Report(problem(text % preload))
        for name in ("equilibrium", "reactions"):
            report.add(name)
        told[preload] = "\n".join(section_lines(report.sections)).replace("\u00a0", " ")
    held, given_way = told.values()
    assert "static preload of s: −49.05 N" in held and "y = −0.0545 m" in given_way
    assert all("a.reaction.moment = (0.6 kg·m)·ÿ + 5.886 N·m" in one for one in (held, given_way))
