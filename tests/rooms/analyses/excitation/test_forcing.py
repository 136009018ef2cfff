"""Loads of the time in pieces: against the expressions themselves in 40 digits, and by identities."""

import cmath
import math
import random
from fractions import Fraction

import mpmath
import pytest
from support.fourier import coefficients, integral

from vibcli.analyses.excitation.decompose import forcing_of
from vibcli.analyses.excitation.forcing import Forcing, Segment, TooOften, Wave
from vibcli.analyses.excitation.impulses import nearest
from vibcli.analyses.excitation.periods import shortest
from vibcli.analyses.excitation.rounding import Floating
from vibcli.analyses.excitation.tabulated import TabulatedFunction
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import parse
from vibcli.symbolic.sampled_functions import Samples
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import QuantityRef

VALUES = {"F": 5.0, "a": 0.7, "b": 1.3, "W": 31.4, "p": 0.25, "q": 0.8, "c": 0.1, "k": -2.5}


def expression(text, table=None):
    """(node, time) of a text."""
    table = table or Table()
    time = table.time = table.variable("t")
    return lower(parse(text), table, lambda name, primes, tree: time if name == "t" else table.parameter(
        name, VALUES[name] > 0)), time


def forcing(*texts, **options):
    table = Table()
    nodes = {i: expression(text, table)[0] for i, text in enumerate(texts)}
    return forcing_of(nodes, table.time, VALUES, **options)


def at(found, t, channel=0):
    """The value of a channel, from the segments."""
    piece = [piece for piece in found.segments(t + 1) if piece.start <= t][-1]
    tau = mpmath.mpf(t) - piece.start
    return mpmath.fsum((w.coefficient * tau**w.power * mpmath.exp(mpmath.mpc(w.exponent) * tau)).real
                       for w in piece.waves if w.channel == channel)


def exact(node, t):
    values = {name: mpmath.mpf(value) for name, value in VALUES.items()}
    return evaluate([node], multiprecision(), {**values, "t": mpmath.mpf(t)})[0]


def instants(found, generator):
    """Random times, and some just after breaks; a break itself lies within rounding of either side."""
    until = 4.0 if found.period is None else found.since + found.period
    starts = [piece.start for piece in found.segments(until)][:20]
    return [generator.uniform(0, until) for _ in range(30)] + [x + d for x in starts for d in (1e-9, 1e-6, 1e-3)]


def worst(text):
    """(largest error, size) of the pieces of an expression, of those that repeat the first."""
    node, time = expression(text)
    found = forcing_of({0: node}, time, VALUES)
    with mpmath.workdps(40):
        pairs = [(at(found, t), exact(node, t)) for t in instants(found, random.Random(text))]
        return float(max(abs(x - y) for x, y in pairs)), float(max(abs(y) for _, y in pairs))


CASES = [
    "F", "F*step(t)", "F*(step(t) - step(t - p))", "F*ramp(t - p)/q", "F*step(p - t)", "F*ramp(p - t)",
    "F*sin(W*t)", "F*cos(W*t + a)", "F*sin(W*t)*cos(3*W*t - b)", "F*sin(W*t)^3", "(sin(W*t)^2 + cos(W*t)^2)*F",
    "F*exp(-a*t)*sin(W*t)", "F*(1 - exp(-t/p))", "F/exp(t)", "F*sqrt(exp(-a*t))", "t^3 - 2*t*F + (t - q)^5",
    "F*sin(pi*t/p)*(step(t) - step(t - p))", "F*t/p*(step(t) - step(t - p)) + F*step(t - p)", "F*sinh(a*t) + cosh(b*t)",
    "F*square(W*t)", "F*square(W*t + a)", "F*square(-W*t)", "F*square(2*W*t) + F*square(3*W*t)", "sawtooth(W*t)*F",
    "F*sawtooth(a - W*t)", "F*square(W*t)*sawtooth(W*t/2)", "F*square(W*t)*sin(W*t)", "F*(1 + sawtooth(W*t + a))/2",
    "F*square(W*t)*step(t - q)", "F*square(W*t)*(step(t) - step(t - q))", "t*square(W*t)*(step(t) - step(t - q))",
    "abs(F*sin(W*t))", "max(0, F*sin(W*t))", "min(c, sin(W*t))", "abs(cos(W*t) + a*sin(W*t) + c)", "sign(sin(W*t + a))",
    "abs(t - q)", "max(t, q)", "min(1, ramp(t - p)/q)", "abs(min(t, q) - p)", "F*sin(W*ramp(t - p))", "step(sin(W*t))",
    "F*(t - q)^2*(step(t - q) - step(t - 2*q))", "F*exp(-a*(t - q))*sin(W*(t - q))*step(t - q)", "sign(t - q)*t^2",
    "square(W*t) - square(W*t)", "F*exp(k*t)*exp(-k*t)", "step(t - p)^3*F", "square(W*t)^2*F", "1/(2 + a)*t",
    "(exp(-a*t)*sin(W*t) + F)*(exp(-b*t)*cos(3*t) + 2)",
]


@pytest.mark.parametrize("text", CASES)
def test_pieces_are_the_expression(text):
    error, size = worst(text)
    assert error <= 1e-14 * max(size, 1.0)


IRREGULAR = {"square(t) + square(sqrt(2)*t)": "common multiple", "F*square(W*t + a) + exp(-t)": "grows or decays",
             "square(W*t)*t": "grows or decays", "abs(F*sin(W*t)) + t^2*step(t - p)": "grows or decays",
             "(square(W*t) + F)*(sawtooth(b*t) + cos(sqrt(3)*t))*step(t - q)": "common multiple"}


@pytest.mark.sweep
@pytest.mark.parametrize("text", IRREGULAR)
def test_what_never_repeats_itself_is_known_up_to_any_instant(text):
    error, size = worst(text)
    assert error <= 1e-14 * max(size, 1.0)
    with pytest.raises(PhysicsError, match=IRREGULAR[text]):
        forcing(text).segments(math.inf)
    with pytest.raises(PhysicsError, match="too often"):
        forcing(text).segments(1e6)


def piecewise(generator, depth):
    """The text of a random expression that has a closed form; below waves only what is linear."""
    leaf = generator.choice(("t", "F", "a", "3", "step(t - p)", "ramp(q - t)", "sin(W*t)", "cos(b*t - a)", "exp(k*t)",
                             "min(t, q)", "abs(t - p)", "sin(2*t + b)", "step(q - t)", "exp(-a*t)*sin(3*t)"))
    if not depth:
        return leaf
    left, right = piecewise(generator, depth - 1), piecewise(generator, depth - 1)
    return generator.choice((f"({left} + {right})", f"({left})*({right})", f"({left} - a*({right}))", leaf))


@pytest.mark.parametrize("text", ["F*square(W*t + a)", "abs(F*sin(W*t))", "sawtooth(W*t)*square(2*W*t)*step(t - p)"])
def test_later_turns(text):
    """Later turns begin at floats: their waves are those of a time that is off by rounding."""
    node, time = expression(text)
    found = forcing_of({0: node}, time, VALUES)
    with mpmath.workdps(30):
        for t in [random.Random(text).uniform(0, 40) for _ in range(50)]:
            assert float(abs(at(found, t) - exact(node, t))) <= 5 * VALUES["W"] * 4e-16 * 40


@pytest.mark.parametrize("seed", range(60))
def test_random_expressions(seed):
    text = piecewise(random.Random(seed), 3)
    error, size = worst(text)
    assert error <= 1e-14 * max(size, 1.0), text


def test_random_expressions_have_breaks_and_waves():
    found = [forcing(piecewise(random.Random(seed), 3)) for seed in range(60)]
    assert sum(len(f.pieces) > 2 for f in found) > 20
    assert sum(any(w.exponent for piece in f.pieces for w in piece.waves) for f in found) > 30


@pytest.mark.parametrize("text", ["F*sin(W*t)*step(t - p)", "abs(sin(W*t)) + sawtooth(3*W*t)", "exp(-a*t)*cos(W*t)^2"])
def test_more_digits(text):
    node, time = expression(text)
    with mpmath.workdps(30):
        values = {name: mpmath.mpf(value) for name, value in VALUES.items()}
        found = forcing_of({0: node}, time, values, precise=True)
        with mpmath.workdps(45):
            for t in (0.1234, 0.77, 2.9):
                assert abs(at(found, t) - exact(node, t)) < 1e-28


def test_a_late_pulse_is_as_exact_as_an_early_one():
    """5 ms at t = 50 s: nothing is lost by counting from zero."""
    found = forcing("F*sin(pi*(t - 50)/0.005)*(step(t - 50) - step(t - 50.005)) + (t - 50)^4*step(t - 50)")
    assert [piece.start for piece in found.pieces] == [0.0, 50.0, 50.005]
    polynomial = [w for w in found.pieces[1].waves if not w.exponent]
    assert [(w.power, w.coefficient) for w in polynomial] == [(4, 1)]
    sine, = [w for w in found.pieces[1].waves if w.exponent]
    assert sine.coefficient == pytest.approx(-5j, abs=1e-11)


def test_what_cancels_leaves_nothing():
    found = forcing("F*(step(t) - step(t - p))*(sin(W*t)^2 + cos(W*t)^2 - 1) + exp(a*t)*exp(-a*t) - 1")
    assert [piece.waves for piece in found.pieces] == [()]
    after = forcing("F*sin(W*t)*(step(t) - step(t - p))").pieces
    assert [len(piece.waves) for piece in after] == [1, 0]


def test_sums_and_shifts():
    """The pieces of a sum are the sums of the pieces; what starts later is the same, later."""
    one, other = "F*sin(W*t)*step(t - p)", "max(0, sin(W*t))"
    both, apart = forcing(f"{one} + {other}"), forcing(one, other)
    generator = random.Random(3)
    for t in [generator.uniform(0, 3) for _ in range(40)]:
        assert float(at(both, t) - at(apart, t, 0) - at(apart, t, 1)) == pytest.approx(0, abs=1e-13)
    early = forcing("F*exp(-a*t)*sin(W*t)*(step(t) - step(t - q))").pieces
    late = forcing("F*exp(-a*(t - 1))*sin(W*(t - 1))*(step(t - 1) - step(t - 1 - q))").pieces
    assert [piece.start for piece in late] == [0.0, 1.0, 1.8]
    for x, y in zip(early, late[1:], strict=True):
        assert [tuple(w) for w in x.waves] == [pytest.approx(tuple(w), abs=1e-13) for w in y.waves]


@pytest.mark.parametrize(("text", "period"), [
    ("square(W*t)", 1), ("abs(sin(W*t))", 0.5), ("sawtooth(2*W*t) + square(3*W*t)", 1), ("max(0, sin(W*t))", 1),
    ("square(W*t) + sin(W*t/3)", 3), ("square(W*t)^2*sin(W*t)*square(W*t)", 0.5), ("abs(cos(W*t)) + F", 0.5)])
def test_periods(text, period):
    assert forcing(text).period == pytest.approx(period * 2 * math.pi / VALUES["W"], rel=1e-14)


def test_periodic_from_some_time_on():
    found = forcing("square(W*t)*step(t - p) + F*(step(t) - step(t - q))")
    assert found.pieces[0].start == 0.0
    assert 0.8 <= found.since < 0.8 + found.period
    assert found.period == pytest.approx(2 * math.pi / VALUES["W"])


# impulses


def blows(text, channel=0):
    return [(piece.start, size) for piece in forcing(text).pieces for which, size in piece.impulses]


@pytest.mark.parametrize(("text", "expected"), [
    ("F*impulse(t)", [(0, 5)]), ("F*impulse(t - p)*cos(W*t)", [(0.25, 5 * math.cos(7.85))]),
    ("impulse(2*t - q)*t", [(0.4, 0.2)]), ("impulse(p - t)", [(0.25, 1)]), ("impulse(t + p)", []),
    ("impulse(t - p) + impulse(t - p)", [(0.25, 2)]), ("step(t)*impulse(t - p)", [(0.25, 1)]),
    ("impulse(t - p)*ramp(t - p)", [])])
def test_impulses(text, expected):
    assert blows(text) == [pytest.approx(pair, rel=1e-13) for pair in expected]


def test_an_impulse_belongs_to_the_cut_that_is_nearest():
    """Of instants that rounding has moved either way."""
    generator = random.Random("cuts")
    for n in (1, 2, 3, 50):
        cuts = sorted(Fraction(generator.randrange(10**6), 1000) for _ in range(n))
        for cut in cuts:
            for moved in (0, Fraction(1, 10**9), -Fraction(1, 10**9)):
                assert cuts[nearest(cuts, cut + moved)] == cut
        assert nearest(cuts, cuts[-1] + 1) == n - 1 and nearest(cuts, cuts[0] - 1) == 0


RATES = ["F*step(t - p)", "F*sin(pi*t/p)*(step(t) - step(t - p))", "F*(ramp(t) - ramp(t - p))", "square(W*t)",
         "sawtooth(W*t)*F", "t*step(t - p)", "abs(t - p)", "F*cos(W*t)*step(t - p)"]


@pytest.mark.parametrize("text", RATES)
def test_rates_hold_the_jumps(text):
    """f(b) − f(a) is the integral of the rate, its impulses included."""
    node, time = expression(text)
    found = forcing_of({0: gradient(node)[time]}, time, VALUES)
    a, b = 0.0137, 0.7531
    total, segments = 0.0, found.segments(b)
    for piece, end in zip(segments, [*[s.start for s in segments[1:]], b], strict=True):
        low, high = max(a, piece.start), min(b, end)
        if piece.start > a:
            total += sum(size for _, size in piece.impulses)
        for _, c, k, s in piece.waves if high > low else ():
            total += (c * (integral(k, s, high - piece.start) - integral(k, s, low - piece.start))).real
    assert total == pytest.approx(float(exact(node, b) - exact(node, a)), abs=1e-12)


def test_second_rate_of_a_rectified_sine():
    """|sin|″ = −W²|sin| + impulses of 2W at its corners."""
    node, time = expression("abs(sin(W*t))")
    found = forcing_of({0: gradient(gradient(node)[time])[time]}, time, VALUES)
    sizes = [size for piece in found.pieces for _, size in piece.impulses]
    assert sizes
    assert sizes == [pytest.approx(2 * VALUES["W"])] * len(sizes)


REFUSED = {
    "sin(t^2)": "linear in the time", "exp(-t^2)": "linear in the time", "1/(1 + t)": "denominator",
    "sqrt(t)": "root", "tan(W*t)": "tan", "log(1 + t)": "log", "t^a": "whole number", "step(t^2 - 1)": "closed form",
    "sin(W*square(t))": "again and again", "impulse(t - p)*step(t - p)":
    "not defined", "exp(1000*t)*step(t - 1)": "beyond", "abs(sin(t) + sin(2*t))": "closed form",
    "(1 + t)^500": "high", "square(1e12*t)*(step(t) - step(t - 1))": "too often",
}


@pytest.mark.parametrize("text", REFUSED)
def test_what_has_no_closed_form_is_refused(text):
    with pytest.raises(PhysicsError) as refusal:
        forcing(text)
    assert REFUSED[text] in refusal.value.message + " " + refusal.value.hint


def test_a_rate_of_an_impulse_is_refused():
    node, time = expression("step(t - p)")
    with pytest.raises(PhysicsError, match="rate of an impulse"):
        forcing_of({0: gradient(gradient(node)[time])[time]}, time, VALUES)


# Fourier series


@pytest.mark.parametrize(("text", "coefficient"), [
    ("F*square(W*t)", lambda n: 5 * 2 / (1j * math.pi * n) if n % 2 else 0),
    ("F*sawtooth(W*t)", lambda n: 5 * 1j / (math.pi * n) if n else 0),
    ("abs(sin(W*t/2))", lambda n: 2 / (math.pi * (1 - 4 * n * n))),
    ("max(0, sin(W*t))", lambda n: -0.25j if n == 1 else (1 + (-1) ** n) / (2 * math.pi * (1 - n * n)))])
def test_series(text, coefficient):
    """Textbook series of the square, sawtooth and rectified waves."""
    for n, c in enumerate(coefficients(forcing(text), 0, 9)):
        assert c == pytest.approx(complex(coefficient(n)), abs=1e-14)


def test_series_of_impulses():
    node, time = expression("square(W*t)")
    found = coefficients(forcing_of({0: gradient(node)[time]}, time, VALUES), 0, 3)
    assert found[1] == pytest.approx(2 * VALUES["W"] / math.pi)


@pytest.mark.parametrize("k", [0, 1, 2, 5])
def test_integrals_of_waves(k):
    for z in (0, 1e-12j, 1e-3, 0.3 + 0.4j, 5j, -3 + 2j, 40j, -30 + 100j):
        h = 1.7
        with mpmath.workdps(30):
            wanted = mpmath.mpf(h) ** (k + 1) / (k + 1) * mpmath.hyp1f1(k + 1, k + 2, mpmath.mpc(z) * h)
        assert integral(k, z, h) == pytest.approx(complex(wanted), rel=1e-14)
    assert cmath.isfinite(integral(k, 1j, 0.0))


def test_what_comes_before_a_period_does_not_count_again_and_again():
    pieces = [Segment(i / 1000) for i in range(2001)]
    assert len(Forcing(1, pieces, 1.0, 2.0).segments(1000.0)) == 2001 + 997
    with pytest.raises(TooOften) as refusal:
        Forcing(1, pieces, 1.0, 2.0).segments(1e6)
    assert "before t = 9.9e+04 s" in refusal.value.hint


# records

TIMES, HEIGHTS = (0.0, 0.1, 0.25, 0.3, 0.75, 1.0), (0.0, 1.5, -2.0, 0.5, 3.0, 0.0)


def recorded(text, heights=HEIGHTS):
    table = Table()
    table.records["ag"] = Samples(TIMES, heights)
    time = table.time = table.variable("t")

    def symbol(name, primes, tree):
        if isinstance(tree, QuantityRef):
            return table.call("ag", lower(tree.args[1], table, symbol))
        return time if name == "t" else table.parameter(name, VALUES[name] > 0)

    return lower(parse(text), table, symbol), time


@pytest.mark.parametrize("text", ["ag(t)", "F*ag(t - q)", "ag(q - t)*F", "ag(2*t)*sin(W*t)", "ag(t) - ag(t - 0.05)",
                                  "ag(t)*(step(t - p) - step(t - 0.5))", "ag(t)^2", "ag(t + 0.2)", "ag(min(t, p))"])
def test_records(text):
    node, time = recorded(text)
    found = forcing_of({0: node}, time, VALUES)
    with mpmath.workdps(40):
        for t in instants(found, random.Random(text)):
            assert float(abs(at(found, t) - exact(node, t))) <= 1e-14 * 15


def test_two_looks_at_a_record_are_one_where_all_of_them_is():
    keys = [(samples, a, b, order) for samples in (Samples(TIMES, HEIGHTS), Samples(TIMES, HEIGHTS))
            for a in (1, 2, -1) for b in (0, Fraction(1, 3)) for order in (0, 1, 2)]
    one, other = ([TabulatedFunction(*key, Floating) for key in keys] for _ in range(2))
    assert all((x == y) == (i == j) for i, x in enumerate(one) for j, y in enumerate(other))
    assert len({*one, *other}) == len(keys) and one[0] != keys[0]


@pytest.mark.parametrize("heights", [HEIGHTS, (1.0, 1.5, -2.0, 0.5, 3.0, -1.0)])
def test_rates_of_records(heights):
    """The rate is a staircase, with impulses where the record jumps at its ends."""
    node, time = recorded("ag(2*t - q)", heights)
    found = forcing_of({0: gradient(node)[time]}, time, VALUES)
    assert float(at(found, 0.5)) == pytest.approx(2 * -3.5 / 0.15)
    jumps = [(piece.start, size) for piece in found.pieces for _, size in piece.impulses]
    assert jumps == ([] if heights is HEIGHTS else [(0.4, pytest.approx(1.0)), (0.9, pytest.approx(1.0))])


def test_second_rates_of_records():
    """Impulses at the samples, by the changes of slope."""
    node, time = recorded("ag(t)")
    found = forcing_of({0: gradient(gradient(node)[time])[time]}, time, VALUES)
    slopes = [(b - a) / (v - u) for a, b, u, v in zip(HEIGHTS, HEIGHTS[1:], TIMES, TIMES[1:], strict=False)]
    wanted = [after - before for before, after in zip([0, *slopes], [*slopes, 0], strict=True)]
    assert [size for piece in found.pieces for _, size in piece.impulses] == pytest.approx(wanted)
    node, time = recorded("ag(t)", (1.0, *HEIGHTS[1:]))
    with pytest.raises(PhysicsError, match="rate of an impulse"):
        forcing_of({0: gradient(gradient(node)[time])[time]}, time, VALUES)


@pytest.mark.sweep
def test_a_long_record():
    """As many pieces as samples."""
    generator = random.Random(5)
    table = Table()
    table.records["ag"] = Samples([i * 0.005 for i in range(4000)], [generator.gauss(0, 1) for _ in range(4000)])
    table.time = table.variable("t")
    found = forcing_of({0: table.call("ag", table.time) * 3}, table.time, {})
    assert len(found.pieces) == 4000


@pytest.mark.parametrize("text", ["F*ag(2*t - q)*t", "ag(t)*sin(W*t)", "square(W*t)*ag(t)"])
def test_records_and_their_rates_in_more_digits(text):
    node, time = recorded(text)
    rate = gradient(node)[time]
    with mpmath.workdps(30):
        values = {name: mpmath.mpf(value) for name, value in VALUES.items()}
        found = forcing_of({0: node, 1: rate}, time, values, precise=True)
        floats = forcing_of({0: node, 1: rate}, time, VALUES)
        for x, y in zip(found.pieces, floats.pieces, strict=True):
            assert [float(size) for _, size in x.impulses] == pytest.approx([size for _, size in y.impulses])
        for t in (0.123, 0.47, 0.88):
            assert abs(at(found, t) - exact(node, t)) < 1e-26
            assert float(abs(at(found, t, 1) - at(floats, t, 1))) < 1e-10


def test_pieces_of_more_digits_are_compared_where_the_first_rests():
    pieces = [Segment(mpmath.mpf(0)), Segment(mpmath.mpf(1), (Wave(0, mpmath.mpf(2), 0, 0j),))]
    assert shortest(pieces, mpmath.mpf(2), mpmath.mpf(0), Fraction(1, 10**12)) == (pieces, 2)
