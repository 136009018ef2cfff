"""Envelopes of two vibrations against the arrows that turn, c₁e^{λ₁t} + c₂e^{λ₂t}, in mpmath."""

import math

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

UNTIL = 6.0
PAIR = """
bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 1 kg, slide: y}}}}
springs: {{s: {{k: {k[0]!r} N/m, between: [ground, a]}}, r: {{k: {k[1]!r} N/m, between: [ground, b]}}}}
dampers: {{d: {{c: {c[0]!r} N*s/m, between: [ground, a]}}, e: {{c: {c[1]!r} N*s/m, between: [ground, b]}}}}
initial: {{x: {x[0]!r} m, y: {x[1]!r} m, x': {v[0]!r} m/s, y': {v[1]!r} m/s}}
find: [{{response: {{until: {until} s}}}}]
"""


def drawn(seed):
    """Stiffnesses, dampings, places and speeds of two blocks that nothing couples; x + y holds any two vibrations."""
    dice = np.random.default_rng(seed)
    k = dice.uniform(80, 120, 2)
    if seed % 4 == 1:
        k[1] = k[0] * (1 + 1e-8 * dice.uniform(1, 2))       # a beat lasts years
    c = dice.uniform(0, 1, 2) * (seed % 3 > 0)
    return {name: values.tolist() for name, values in (("k", k), ("c", c), ("x", dice.uniform(-0.1, 0.1, 2)),
                                                       ("v", dice.uniform(-1, 1, 2)))}


def arrow(k, c, x, v):
    """(c, λ) of x = Re c e^{λt}."""
    k, c, x, v = map(mpmath.mpf, (k, c, x, v))
    rate = mpmath.mpc(-c / 2, mpmath.sqrt(k - c * c / 4))
    return mpmath.mpc(x, (rate.real * x - v) / rate.imag), rate


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(12))
def test_an_envelope_is_the_length_of_two_arrows(seed):
    given = drawn(seed)
    scene = problem(PAIR.format(until=UNTIL, **given))
    with mpmath.workdps(30):
        arrows = [arrow(*(values[i] for values in given.values())) for i in (0, 1)]

        def exact(t):
            return abs(sum(c * mpmath.exp(rate * t) for c, rate in arrows))
        size = float(sum(abs(c) for c, _ in arrows))
        times = np.linspace(0, UNTIL, 1201)
        values = np.array([float(exact(mpmath.mpf(t))) for t in times])
        signal = scene.response.signal(parse("envelope(x + y)"))
        assert np.abs(signal.values(times) - values).max() <= 1e-12 * size
        assert (np.abs(scene.response.signal(parse("x + y")).values(times)) <= values + 1e-12 * size).all()
        for sense, word in ((1, "max"), (-1, "min")):
            found, instant = (measure(scene, parse(f"{head}{word}(envelope(x + y))"))[0] for head in ("", "arg"))
            assert float(exact(mpmath.mpf(instant))) == pytest.approx(found, rel=1e-11, abs=1e-12 * size)
            assert sense * found >= (sense * values).max() - 1e-12 * size
            assert sense * found <= (sense * values).max() + 1e-3 * size
            assert measure(scene, parse(f"{word}(1*envelope(x + y) + 1 cm)"))[0] == pytest.approx(
                found + 0.01, rel=1e-11, abs=1e-12 * size)


def test_equal_arrows_vanish_where_they_are_opposed():
    scene = problem(PAIR.format(until=20, k=[100, 121], c=[0, 0], x=[0.1, 0.1], v=[0, 0]))
    for number in range(1, 4):
        assert measure(scene, parse(f"zero[{number}](envelope(x + y))"))[0] == pytest.approx(math.pi * (2 * number - 1))
    signal = scene.response.signal(parse("envelope(x + y)"))
    assert signal.period == pytest.approx(2 * math.pi) and len(signal.zeros(0, 20)) == 3


def test_of_endless_zeros_no_more_than_are_asked_are_listed():
    scene = problem(PAIR.format(until=1e11, k=[100, 121], c=[0, 0], x=[0.1, 0.1], v=[0, 0]))
    assert measure(scene, parse("zero[3](envelope(x + y))"))[0] == pytest.approx(5 * math.pi)


def test_beats_are_heard_of_frequencies_that_are_nearly_one():
    scene = problem(PAIR.format(until=20, k=[100, 100.000002], c=[0, 0], x=[0.1, 0.1], v=[0, 0]))
    assert measure(scene, parse("beat_period(x + y)"))[0] == pytest.approx(2 * math.pi / 1e-7, rel=1e-7)
