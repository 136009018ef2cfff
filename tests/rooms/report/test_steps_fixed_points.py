"""Fixed points of an absorber as they are worked out, beside Den Hartog's formulas and the equations for several
dampers."""

from pathlib import Path

import mpmath
import pytest
from support.scenes import kept_problem_of, kept_settled_of, problem

from vibcli.report.steps.worked import worked
from vibcli.symbolic.evaluation import Floats, evaluate

ABSORBER = ("parameters: {m1: 20 kg, m2: 3 kg, k1: 8 kN/m, k2: 0.9 kN/m, c: 30 N*s/m, F0: 50 N, Omega: 20 rad/s}\n"
            "bodies:\n  machine: {mass: m1, slide: x1}\n  absorber: {mass: m2, slide: x2}\n"
            "springs:\n  mount: {k: k1, between: [ground, machine]}\n  tuned: {k: k2, between: [machine, absorber]}\n"
            "dampers: {d: {c: c, between: [machine, absorber]}}\n"
            "forces: {drive: {at: machine, force: F0*sin(Omega*t)}}\n")
ASKED = 'answers:\n  "fixed_point[1, d](frf[x1, drive]).Omega": 16.6 rad/s\n'


def told(scene):
    return {line.settles: line for line in worked(scene)}


def height(c, omega, m1=20, m2=3, k1=8000, k2=900, F0=50):
    """|X₁| by (K − ω²M + iωC) X = F."""
    mount, spring = k1 - m1 * omega**2, k2 + 1j * c * omega
    return abs(mpmath.lu_solve(mpmath.matrix([[mount + spring, -spring], [-spring, spring - m2 * omega**2]]),
                               mpmath.matrix([F0, 0]))[0])


def test_no_damper_moves_them():
    lines = told(problem(ABSORBER + ASKED))
    for letter in "PQ":
        omega, size = lines[f"fixed point {letter}"].value, lines[f"height of fixed point {letter}"].value
        for c in (0, 3, 30, 3000):
            assert height(c, omega) == pytest.approx(size, rel=1e-11)
    low, high = sorted(mpmath.polyroots([3 * 43, -(2 * 20 * 900 + 2 * 3 * 8000 + 2 * 3 * 900), 2 * 8000 * 900]))
    assert lines["fixed point P"].value == pytest.approx(float(mpmath.sqrt(low)), rel=1e-13)
    assert lines["fixed point Q"].value == pytest.approx(float(mpmath.sqrt(high)), rel=1e-13)


def test_they_are_told_where_they_are_asked():
    assert "fixed points" not in told(problem(ABSORBER + "answers:\n  amplitude(x1): 0.04 m\n"))


def test_a_load_that_is_another_at_each_frequency_has_none():
    lines = told(problem(ABSORBER.replace("F0*sin", "0.125 kg*m*Omega^2*sin").replace("F0: 50 N, ", "") + ASKED))
    assert "fixed points" not in lines and "amplitude(x1)" in lines


@pytest.mark.sweep
def test_the_spring_that_makes_them_equally_high():
    lines = told(kept_settled_of(Path("vibcli/examples/damped_absorber.yaml")))
    heights = [lines[f"height of fixed point {letter}"].value for letter in "PQ"]
    assert heights == pytest.approx([50 / 8000 * 21**0.5] * 2, rel=1e-12)
    assert lines["one height"].number + 1 == lines["k2"].number


@pytest.mark.sweep
@pytest.mark.parametrize("case", [None, "stronger"])
def test_in_letters_where_the_load_is_at_one_of_them(case):
    """ω² (1 + μ) m₁/k₁ = 1 ∓ √(μ/(2 + μ)), F₀/k₁ √(1 + 2/μ): Den Hartog 1956, section 3.3."""
    scene = kept_problem_of(Path("problems/7_forced_two_degrees/fixed_points_of_a_damped_absorber.yaml"))
    lines = told(scene.case(case) if case else scene)
    values = {"m1": 2.0, "k1": 300.0, "mu": 0.2, "F0": 7.0, "c": 5.0}
    for letter, sign in (("P", -1), ("Q", 1)):
        at, size = evaluate([lines[f"{what}fixed point {letter}"].node for what in ("", "height of ")], Floats, values)
        assert at == pytest.approx(300 / 2 / 1.2 * (1 + sign * (0.2 / 2.2)**0.5), rel=1e-13)
        assert size == pytest.approx(7 / 300 * 11**0.5, rel=1e-13)
