"""Frequencies and responses of members of the reference beside formulas; what it does not tell apart is refused."""

import re

import mpmath
import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.api.values import checked_quantity
from vibcli.base.errors import PhysicsError
from vibcli.cli.sampled import asked as expression
from vibcli.evidence.asked import NotCompared, subjects
from vibcli.evidence.compared import evidence
from vibcli.evidence.methods import finite_elements
from vibcli.evidence.reference import members
from vibcli.evidence.subject import Deadline

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


PUSHED = """
bars: {b: {length: 2 m, EA: 7 N, mass_per_length: 5 kg/m, left: clamped%s}}
points: {end: {body: b, at: 2 m}}
forces: {F: %s}
"""
AT_END = "{at: end, force: (3 N)*sin((2 rad/s)*t)}"
ALONG = "{body: b, per_length: (3 N/m)*cos((2 rad/s)*t)}"


def asked(more, force, quantity):
    one = problem_of(text_source(PUSHED % (more, force)))
    return next(subjects(one, [checked_quantity(one.spec, expression(quantity, "--of"))]))


@pytest.mark.parametrize(("more", "force", "quantity", "exact"), [
    ("", AT_END, "amplitude(b.u(0.5 m))", lambda k: 3 * mpmath.sin(k / 2) / (7 * k * mpmath.cos(2 * k))),
    ("", AT_END, "amplitude(b.force(0 m))", lambda k: 3 / mpmath.cos(2 * k)),
    ("", AT_END, "frf[b.u(1 m), F](2 rad/s)", lambda k: mpmath.sin(k) / (7 * k * mpmath.cos(2 * k))),
    (", right: {c: 4 N*s/m}", AT_END, "phase(b.u''(2 m))", lambda k: mpmath.pi - mpmath.atan(
        8 * mpmath.sin(2 * k) / (7 * k * mpmath.cos(2 * k)))),
    ("", ALONG, "amplitude(b.u'(2 m))", lambda k: mpmath.mpf(6) / 20 * (1 / mpmath.cos(2 * k) - 1)),
    (", drag: 6 N*s/m^2", AT_END, "amplitude(b.u(2 m))", lambda k: abs(3 * mpmath.tan(2 * mpmath.sqrt(
        k**2 - mpmath.mpc(0, 12) / 7)) / (7 * mpmath.sqrt(k**2 - mpmath.mpc(0, 12) / 7))))])
def test_what_loads_keep_up_in_a_bar(more, force, quantity, exact):
    subject = asked(more, force, quantity)
    with mpmath.workdps(60):
        value, found = exact(2 * mpmath.sqrt(mpmath.mpf(5) / 7)), subject.true.values[0]
        assert min(abs(found - value), abs(found + value)) < mpmath.mpf(10) ** -45 * abs(value)
    ours = subject.ours()
    assert subject.error(ours.values, subject.true) <= ours.bound < 1e-10
    errors = [subject.error(run.run(Deadline(60)).values, subject.true) for run in finite_elements.attempts(subject)]
    assert not errors or errors[5] < errors[2] / 20


@pytest.mark.parametrize(("more", "force", "said"), [
    ("", "{at: end, force: (3 N)*sin((2 rad/s)*t) + (1 N)*sin((3 rad/s)*t)}", "one frequency"),
    ("", "{at: end, force: (3 N)*sin((2 rad/s)*t)^2}", "sums of sines and cosines"),
    ("", "{body: b, per_length: (3 N/m)*sin(x/(1 m))*cos((2 rad/s)*t)}", "no polynomials")])
def test_what_keeps_up_a_bar_otherwise_has_no_reference(more, force, said):
    subject = asked(more, force, "amplitude(b.u(2 m))")
    assert re.search(said, subject.why if isinstance(subject, NotCompared) else "")


def test_a_place_without_inertia():
    """A disc on a light shaft that a spring holds at its middle, ω² = (k − k²/(k + k + kₜ))/J with k = 2 GI_o/L, beside
    a heavy shaft, ω² = (π/2L)² GI_o/j."""
    text = """
shafts:
  light: {length: 2 m, GIo: 3 N*m^2, left: clamped, attached: [{at: 1 m, torsion: 3 N*m}, {at: 2 m, inertia: 5 kg*m^2}]}
  heavy: {length: 2 m, GIo: 3 N*m^2, inertia_per_length: 5 kg*m, left: clamped}
"""
    with mpmath.workdps(60):
        assert near(found(text, 2), [(mpmath.pi / 4) ** 2 * 3 / 5, mpmath.mpf(2) / 5])


@pytest.mark.sweep
def test_damped_modes_of_a_bar_with_a_damper_at_its_end():
    """tanh λL/a = −√(EA μ)/c, and a frequency response at the frequency without it, at which it is √(EA μ)/c real."""
    one = problem_of(text_source(PUSHED % (", right: {c: 4 N*s/m}", AT_END)))
    quantities = [checked_quantity(one.spec, expression(text, "--of")) for text in (
        "eigenvalue[1]", "frf[b.u(2 m), F](omega[1])")]
    modes, response = subjects(one, quantities)
    with mpmath.workdps(60):
        Z, rate = mpmath.sqrt(35), mpmath.sqrt(mpmath.mpf(7) / 5) / 2
        exact = [rate * mpmath.mpc(mpmath.log((Z - 4) / (Z + 4)) / 2, mpmath.pi * (n + mpmath.mpf(1) / 2))
                 for n in range(3)]
        assert near(modes.true.values, exact)
        assert near(response.true.values, [1 / mpmath.mpc(0, 4 * mpmath.pi / 2 * rate)])
    for subject in (modes, response):
        ours = subject.ours()
        assert subject.error(ours.values, subject.true) <= ours.bound < 1e-11
        assert subject.error([x * (1 + 1e-10) for x in ours.values], subject.true) > ours.bound
    errors = [subject.error(run.run(Deadline(60)).values, subject.true)
              for subject in (modes,) for run in list(finite_elements.attempts(subject))[2:5]]
    assert errors[0] > 10 * errors[2]
