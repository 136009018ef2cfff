"""Vibrations in signals beside closed forms: how they die out, their beats and envelopes."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.evidence.asked import subjects

DYING = """
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {k: 25 N/m, between: [ground, b]}}
dampers: {d: {c: 2 N*s/m, between: [ground, b]}}
initial: {x: 10 cm, x': 0.5 m/s}
answers: {"amplitude(x)": 0, "phase(x)": 0, "decrement(x)": 0, "time_to[0.1](x)": 0, "cycles_to[0.1](x)": 0,
  "envelope(x)(0.5 s)": 0, "max(envelope(s.force))": 0, "decrement[1]": 0, "re(mode_d[1,x])": 1}
"""
BEATING = """
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {k: 100 N/m, between: [ground, b]}}
forces: {F: {at: b, force: "(3 N)*sin((9 rad/s)*t)"}}
find: [{response: {until: 8 s}}]
%s
"""
OF_BEATS = """
answers: {"beat_period(x)": 0, "max(envelope(x))": 0, "argmax(envelope(x))": 0, "min(envelope(x))": 0,
  "zero[2](envelope(x'))": 0, "envelope(x')(1 s)": 0}
"""
CREEPING = "dampers: {d: {c: 20 N*s/m, between: [ground, b]}}"


def found(text):
    """The Subjects of the answers of a scene."""
    one = problem(text)
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


def beside(each, exact, digits=34):
    """Is the true value that of a closed form, and the program's own within its bound of it?"""
    answer = each.ours()
    return abs(each.true.values[0] - exact) < mpmath.mpf(10) ** -digits and (
        each.error(answer.values, each.true) <= answer.bound < 1e-11)


def test_a_vibration_that_dies_out():
    """x = A e^{−t} cos(ωt − φ), ω² = 24, A cos φ = 0.1, A ω sin φ = 0.6."""
    *one, by_mode = found(DYING)
    with mpmath.workdps(50):
        w = mpmath.sqrt(24)
        A, lag = mpmath.hypot(mpmath.mpf("0.1"), mpmath.mpf("0.6") / w), mpmath.atan(6 / w)
        fall = mpmath.log(10)
        exact = [A, lag, 2 * mpmath.pi / w, fall, fall * w / (2 * mpmath.pi), A / mpmath.sqrt(mpmath.e), 25 * A]
        assert all(beside(each, x) for each, x in zip(one, exact, strict=True))
    assert by_mode.kind == "damped modes"


@pytest.mark.sweep
def test_beats_with_what_a_load_keeps_up():
    """x = X (sin Ωt − Ω/ω sin ωt), X = 3/19 m: the arrows of X and X Ω/ω are opposed after T/2, T = 2π s."""
    one = found(BEATING % OF_BEATS)
    with mpmath.workdps(50):
        X, T = mpmath.mpf(3) / 19, 2 * mpmath.pi
        exact = [T, X * mpmath.mpf("1.9"), T / 2, X / 10, T, 2 * 9 * X * mpmath.sin(mpmath.mpf("0.5"))]
        assert all(beside(each, x) for each, x in zip(one, exact, strict=True))


@pytest.mark.parametrize(("text", "why"), [
    (DYING.replace("dampers: {d: {c: 2 N*s/m, between: [ground, b]}}", CREEPING), "what creeps"),
    (BEATING % "answers: {decrement(x): 0}", "the only vibration")])
def test_what_has_no_reference(text, why):
    assert why in found(text)[0].why


def test_more_vibrations_than_two_have_no_envelope():
    chain = """
    bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}, c: {mass: 2 kg, slide: z}}
    springs: {s: {k: 9 N/m, between: [ground, a]}, r: {k: 9 N/m, between: [a, b]}, q: {k: 7 N/m, between: [b, c]}}
    initial: {x: 1 cm}
    answers: {"envelope(x)(1 s)": 0}
    """
    left, = found(chain)
    assert "3 vibrations" in left.why
