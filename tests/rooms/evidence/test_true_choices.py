"""True numbers of parameters that conditions determine: beside closed forms, and within the bounds that are stated."""

from fractions import Fraction

import mpmath
import pytest
from support.scenes import problem

from vibcli.evidence.asked import NotCompared, subjects
from vibcli.evidence.compared import in_numbers
from vibcli.evidence.reference.conditions import Residual, determined
from vibcli.evidence.reference.settled import DoesNotSettle

SWING = """
parameters: {m: 2.3 kg, F0: 3 N%s}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
dampers: {d: {c: c, between: [ground, a]}}
forces: {F: {at: a, force: F0*cos((5 rad/s)*t)}}
choose: {%s}
answers: {%s}
"""
UPRIGHT = """
parameters: {m: 2.3 kg, L: 0.7 m, g: 9.81 m/s^2}
gravity: g
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, L], pin: {at: [0, 0], by: phi}}}
springs: {s: {torsion: k, between: [ground, rod]}}
choose: {k: %s}
answers: {k: 1 N*m}
"""
LEVER = """
parameters: {m: 2.3 kg, a: 0.3 m, b: 0.7 m, g: 9.81 m/s^2}
gravity: g
bodies:
  bar: {shape: rod, mass: m, from: [-a, 0], to: [b, 0], pin: {at: [0, 0], by: phi}}
  weight: {mass: M, at: [-a, 0], weld: bar}
choose: {M: equilibrium}
answers: {M: 1 kg}
"""

@pytest.mark.sweep
@pytest.mark.parametrize(("text", "exact"), [
    (SWING % ("", "k: 'omega_d[1] = 12 rad/s', c: 'zeta[1] = 0.6'", "k: 1 N/m, c: 1 N*s/m"),
     lambda m: [m * 225, m * 18]),
    (SWING % (", c: 4 N*s/m", "k: 'amplitude(x) = 2 cm'", "k: 1 N/m"),
     lambda m: [25 * m + mpmath.sqrt(150**2 - 20**2)]),
    (SWING % (", c: 4 N*s/m", "k: 'omega[1] = 7 rad/s'", "'k[1]': 1 N/m"), lambda m: [49 * m]),
    (UPRIGHT % "stability limit", lambda m: [m * mpmath.mpf(981) / 100 * 35 / 100]),
    (UPRIGHT % "'omega[1] = 3 rad/s'", lambda m: [m * (9 * mpmath.mpf(49) / 300 + mpmath.mpf(981) * 35 / 10000)]),
    (LEVER, lambda m: [m * 2 / 3])])
def test_beside_closed_forms(text, exact):
    one, _ = in_numbers(problem(text))
    found = list(subjects(one, [answer.asked for answer in one.spec.answers], False))
    with mpmath.workdps(60):
        for subject, number in zip(found, exact(mpmath.mpf(23) / 10), strict=True):
            assert abs(subject.true.values[0] / number - 1) <= mpmath.mpf(10) ** -subject.true.digits
            ours = subject.ours()
            assert subject.true.digits >= 40 and subject.error(ours.values, subject.true) <= ours.bound <= 1e-12


def test_letters_are_drawn_where_what_is_chosen_counts():
    """k = (ω² m L² − m g L)/L² is positive only of a quick pendulum."""
    one, drawn = in_numbers(problem("""
        parameters: {m: , L: , g: , w: }
        gravity: g
        bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
        springs: {s: {k: k, stretch: L*phi}}
        choose: {k: "omega[1] = w"}
        answers: {k: m*w^2}
    """))
    subject, = subjects(one, [answer.asked for answer in one.spec.answers], False)
    m, L, g, w = (Fraction(drawn[name]) for name in ("m", "L", "g", "w"))
    exact = m * w**2 - m * g / L
    with mpmath.workdps(60):
        assert exact > 0 and abs(subject.true.values[0] * exact.denominator / exact.numerator - 1) < 1e-40


def test_what_conditions_only_touch_is_none():
    with pytest.raises(DoesNotSettle):
        determined(lambda p: Residual([(p[0] - 1) ** 2], [mpmath.mpf(10) ** -47]), [1 + 1e-9])


@pytest.mark.sweep
def test_a_condition_on_what_has_no_reference_is_told():
    one, _ = in_numbers(problem(SWING % (", k: 90 N/m", "c: 'decrement[1] = 0.5'", "c: 1 N*s/m")))
    found, = subjects(one, [answer.asked for answer in one.spec.answers], False)
    assert isinstance(found, NotCompared) and "reference" in found.why
