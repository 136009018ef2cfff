"""Frequencies of members of the reference beside formulas; what it does not tell apart is refused."""

import mpmath
import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.evidence.compared import evidence
from vibcli.evidence.reference import members

BEAM = "beams: {{b: {{length: 2 m, EI: 3 N*m^2, mass_per_length: 5 kg/m{more}}}}}\n"
BAR = "bars: {{b: {{length: 2 m, EA: 7 N, mass_per_length: 5 kg/m{more}}}}}\n"


def found(text, count):
    return members.squares(problem_of(text_source(text)).configuration.precise_system, count).values


def near(values, exact):
    return all(abs(x - y) <= mpmath.mpf(10) ** -45 * abs(y) for x, y in zip(values, exact, strict=True))


@pytest.mark.sweep
@pytest.mark.parametrize(("more", "equation", "starts"), [
    (", left: pinned, right: pinned", mpmath.sin, (3.1, 6.3, 9.4)),
    (", left: clamped", lambda x: mpmath.cos(x) * mpmath.cosh(x) + 1, (1.88, 4.69, 7.85)),
    (", left: clamped, attached: [{at: 2 m, mass: 5 kg}]", lambda x: 1 + mpmath.cos(x) * mpmath.cosh(x) + x / 2 * (
        mpmath.cos(x) * mpmath.sinh(x) - mpmath.sin(x) * mpmath.cosh(x)), (1.42, 4.11, 7.19))])
def test_beams(more, equation, starts):
    with mpmath.workdps(60):
        roots = [mpmath.findroot(equation, mpmath.mpf(x)) for x in starts]
        assert near(found(BEAM.format(more=more), 3), [(x / 2) ** 4 * mpmath.mpf(3) / 5 for x in roots])


def test_a_free_beam_has_two_rigid_motions():
    with mpmath.workdps(60):
        root = mpmath.findroot(lambda x: mpmath.cos(x) * mpmath.cosh(x) - 1, mpmath.mpf("4.73"))
        assert near(found(BEAM.format(more=""), 3), [0, 0, (root / 2) ** 4 * mpmath.mpf(3) / 5])


@pytest.mark.sweep
def test_bars_and_a_string_under_tension():
    with mpmath.workdps(60):
        clamped = found(BAR.format(more=", left: clamped"), 3)
        assert near(clamped, [((2 * i + 1) * mpmath.pi / 4) ** 2 * mpmath.mpf(7) / 5 for i in range(3)])
        tied = found(BEAM.format(more=", left: pinned, right: pinned, preload: 4 N"), 2)
        waves = [i * mpmath.pi / 2 for i in (1, 2)]
        assert near(tied, [(3 * k**4 + 4 * k**2) / 5 for k in waves])


@pytest.mark.parametrize(("text", "said"), [
    (BEAM.format(more=", foundation: 3 N/m^2"), "so close"),
    ("gravity: 9.81 m/s^2\nstrings: {c: {from: [0, 0], to: [0, -2 m], mass_per_length: 5 kg/m, left: pinned}}\n",
     "end without tension"),
    (BEAM.format(more=", left: clamped, attached: [" + ", ".join(
        f"{{at: {i / 10} m, mass: 1 kg}}" for i in range(1, 20)) + "]"), "takes too long")])
def test_what_has_no_reference_is_refused(text, said):
    with pytest.raises(PhysicsError, match=said):
        found(text, 3)


@pytest.mark.sweep
def test_elements_come_nearer_and_the_bound_is_kept():
    problem = problem_of(text_source(BEAM.format(more=", left: clamped")))
    one, = evidence(problem, (), 1).compared
    ours, *elements = one.points
    assert ours.error <= ours.bound <= 1e-14 and one.subject.kind == "member modes"
    errors = {point.setting: point.error for point in elements}
    assert errors["4 a piece"] > 10 * errors["8 a piece"] > 100 * errors["16 a piece"]
