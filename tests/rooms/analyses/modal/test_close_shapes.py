"""Shapes of frequencies that are close, beside closed forms; a wrong answer for matrices is told, and no fault."""

import math

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run

PAIR = """
parameters: {d: %s N/m, e: %s N/m}
bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
springs: {s: {k: 100 N/m, between: [ground, a]}, t: {k: 100 N/m + d, between: [ground, b]},
  u: {k: e, between: [a, b]}}
"""


@pytest.mark.parametrize(("d", "e"), [("1e-14", "1e-13"), ("3e-7", "1e-12"), ("1e-12", "0")])
def test_of_two_oscillators_that_are_nearly_alike(d, e):
    """y/x = √(1 + (d/2e)²) − d/2e, of no spring between them 0."""
    ratio = float(d) / (2 * float(e)) if float(e) else math.inf
    exact = 1 / (math.hypot(1, ratio) + ratio)
    modal = problem(PAIR % (d, e)).modal
    x, y = modal.shape(modal.modes[0])
    assert y / x == pytest.approx(exact, rel=1e-12, abs=1e-300)


def test_those_of_one_frequency_stay_as_they_are():
    modal = problem(PAIR % ("0", "0")).modal
    assert modal.told_apart(modal.modes[0]) is modal.modes[0]


def test_those_of_members_whose_data_have_no_more_digits_stay_in_floats(monkeypatch):
    """As where a search finds a tension."""
    def refused(*_):
        raise PhysicsError("the tension is known to the digits of floats", "leave --digits out")

    modal = problem("beams: {" + ", ".join(
        f"{name}: {{length: 1, EI: {EI}, mass_per_length: 1, left: clamped, right: {{pinned: {name.upper()}}}}}"
        for name, EI in (("b", "1"), ("d", "1 + 1e-9"))) + "}\nbodies: {B: {mass: 1, slide: x}, D: {mass: 1, slide: y}}"
        "\nsprings: {s: {k: 1e-9, between: [B, D]}}").modal
    first, second = modal.modes.first(2)
    assert 0 < second.omega / first.omega - 1 < 1e-8 and modal.told_apart(first) is not first
    monkeypatch.setattr(modal, "modes_to", refused)
    assert modal.told_apart(first) is first


def test_matrices_whose_coordinates_are_tied_are_refused(tmp_path, capsys):
    path = tmp_path / "two.yaml"
    text = "matrices: {K: [[2, -1], [-1, 2]], M: [[1, 0], [0, 1]]}\ncoordinates: [x, y]\nanswers: {'omega[1]': 5}\n"
    path.write_text(text, encoding="utf-8")
    assert run(["check", "--no-cache", str(path)]) == 1
    assert "found 1" in capsys.readouterr().out
    path.write_text(text + "constraints: {c: {equation: y = 2*x}}\n", encoding="utf-8")
    assert run(["check", "--no-cache", str(path)]) == 3
    assert "no constraint ties these" in capsys.readouterr().err
