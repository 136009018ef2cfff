"""Shapes of frequencies that are close, beside closed forms; a wrong answer for matrices is told, and no fault."""

import math

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

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


@pytest.mark.sweep
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


@pytest.mark.parametrize("e", ["1e-3", "1e-7", "1e-14", "1e-19"])
def test_of_two_damped_oscillators_that_are_nearly_alike(e):
    """M = 1, C = 1 + e [[0, 1], [1, 3]], K = 100: shapes (1, r) of C alone, r² − 3r − 1 = 0."""
    found = problem(f"""
        parameters: {{e: {e}}}
        coordinates: [x, y]
        matrices: {{M: [[1, 0], [0, 1]], C: [[1, e], [e, 1 + 3*e]], K: [[100, 0], [0, 100]]}}""")
    for number, sense in ((1, -1), (2, 1)):
        value, bound = measure(found, parse(f"mode_d[{number},y]"))
        assert abs(value / ((3 + sense * math.sqrt(13)) / 2) - 1) <= bound < 1e-10
        _, y = found.modal.shape(found.modal.damped.numbered(number, number)[0])
        assert y == pytest.approx((3 + sense * math.sqrt(13)) / 2, rel=1e-12)


@pytest.mark.parametrize("k", ["100 N/m", "sqrt(2)*100 N/m"])
def test_very_weak_damping_is_known_to_the_digits_of_floats(k):
    """ζ = c/(2√(k m)), δ = c/2m; the bound of |λ| says nothing of either."""
    found = problem(f"""
        bodies: {{b: {{mass: 1 kg, slide: x}}}}
        springs: {{s: {{k: {k}, between: [ground, b]}}}}
        dampers: {{d: {{c: 1e-11 N*s/m, between: [ground, b]}}}}""")
    omega = 10.0 * (2**0.25 if "sqrt" in k else 1)
    for asked, exact in (("zeta[1]", 1e-11 / (2 * omega)), ("decay[1]", 5e-12), ("re(eigenvalue[1])", -5e-12)):
        value, bound = measure(found, parse(asked))
        assert abs(value / exact - 1) <= 4e-16
        assert bound < 1e-14


def test_matrices_whose_coordinates_are_tied(tmp_path, capsys):
    """K = 2 − 2·1·2 + 2·4 = 6, M = 1 + 4."""
    path = tmp_path / "two.yaml"
    text = "matrices: {K: [[2, -1], [-1, 2]], M: [[1, 0], [0, 1]]}\ncoordinates: [x, y]\nanswers: {'omega[1]': 5}\n"
    path.write_text(text, encoding="utf-8")
    assert run(["check", "--no-cache", str(path)]) == 1
    assert "found 1" in capsys.readouterr().out
    path.write_text(text.replace("5}", "sqrt(6/5)}") + "constraints: {c: {equation: y = 2*x}}\n", encoding="utf-8")
    assert run(["check", "--no-cache", str(path)]) == 0


def test_what_is_skew_of_tied_coordinates():
    """SᵀGS of (x, y, x + 2y) with G = [[0, 1, 0], [−1, 0, 2], [0, −2, 0]]: G₁₂ = 1 − 2·1 = −1."""
    found = problem("""
        coordinates: [x, y, z]
        matrices: {M: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], K: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
                   C: [[0, 1, 0], [-1, 0, 2], [0, -2, 0]]}
        constraints: {c: {equation: z = x + 2*y}}""")
    M, C, G, K = found.configuration.linear_system.arrays()
    assert (M == [[2, 2], [2, 5]]).all() and (K == M).all() and not C.any()
    assert (G == [[0, -1], [1, 0]]).all()
