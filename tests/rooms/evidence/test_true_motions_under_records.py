"""Motions under records of the reference beside closed forms between their samples, and beside Taylor's series."""

from fractions import Fraction
from itertools import pairwise

import mpmath
import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import motion

M, C, K = 1.5, 2.0, 25.0
RECORD = [(0.0, 0.0), (0.125, 3.0), (0.25, -1.5), (0.625, 2.25), (1.0, 0.0)]        # floats without rounding
JUMPING = [(0.0, 1.0), (0.25, 3.0), (0.5, -1.5), (1.0, 0.5)]
SCENE = """
records: {{f: {{file: f.csv, unit: {unit}}}}}
bodies: {{{bodies}b: {{mass: 1.5 kg, slide: x}}}}
springs: {{s: {{k: 25 N/m, between: [{end}, b]}}}}
dampers: {{d: {{c: 2 N*s/m, between: [{end}, b]}}}}
{more}
"""


@pytest.fixture
def scene(tmp_path):
    def made(record, more, unit="N", bodies="", end="ground", text=SCENE):
        (tmp_path / "f.csv").write_text("".join(f"{t},{y}\n" for t, y in record))
        return problem_of(text_source(text.format(unit=unit, more=more, bodies=bodies, end=end), folder=str(tmp_path)))
    return made


def close(found, exact, digits=36):
    return abs(found - exact) <= mpmath.mpf(10) ** -digits * abs(exact)


class Exactly:
    """x and v of M x" + C x' + K x = level + slope·(t - start) between ascending instants, with blows at them."""

    def __init__(self, lines, blows=()):
        self.pieces, x, v = [], mpmath.mpf(0), mpmath.mpf(0)
        for i, (start, level, slope) in enumerate(lines):
            v += sum(size for at, size in blows if at == start) / mpmath.mpf(M)
            self.pieces.append((start, level, slope, x, v))
            if i + 1 < len(lines):
                x, v = self.at(lines[i + 1][0], i)

    def at(self, t, i=-1):
        start, level, slope, x0, v0 = self.pieces[i]
        d, tau = mpmath.mpf(C) / (2 * M), mpmath.mpf(t) - start
        w = mpmath.sqrt(mpmath.mpf(K) / M - d * d)
        rate = mpmath.mpf(slope) / K
        rest = (mpmath.mpf(level) - C * rate) / K
        a = x0 - rest
        b = (v0 - rate + d * a) / w
        e, c, s = mpmath.exp(-d * tau), mpmath.cos(w * tau), mpmath.sin(w * tau)
        return (rest + rate * tau + e * (a * c + b * s),
                rate + e * ((b * w - d * a) * c - (a * w + d * b) * s))


def lines(record, later=0.0, factor=1.0):
    found = [(t + later, factor * y, factor * (v - y) / (u - t))
             for (t, y), (u, v) in pairwise(record)]
    return [(0.0, 0.0, 0.0), *found] * bool(later) + found * (not later) + [(record[-1][0] + later, 0.0, 0.0)]


@pytest.mark.sweep
def test_a_force_as_it_was_measured(scene):
    problem = scene(RECORD, "forces: {F: {at: b, force: -2*f(t - 0.5 s)}}")
    moving = motion.small(problem)
    node = moving.coordinate("x")
    with mpmath.workdps(60):
        known = Exactly(lines(RECORD, 0.5, -2.0))
        for time, piece in ((Fraction(7, 8), 3), (Fraction(3), -1)):
            assert close(motion.at_instant(moving, node, time, problem.work).values[0], known.at(float(time), piece)[0])
        when = mpmath.findroot(lambda t: known.at(t, 3)[1], (0.84, 0.86))
        low = motion.extremes(moving, node, Fraction(1), -1, False, problem.work)
        assert 0.84 < when < 0.86 and close(low.values[0], known.at(when, 3)[0])
        assert close(motion.extremes(moving, node, Fraction(1), -1, True, problem.work).values[0], when, 20)


def test_a_record_that_runs_backwards(scene):
    problem = scene(RECORD, "forces: {F: {at: b, force: f(1 s - t)}}")
    moving = motion.small(problem)
    with mpmath.workdps(60):
        known = Exactly(lines([(1.0 - t, y) for t, y in reversed(RECORD)]))
        found = motion.at_instant(moving, moving.coordinate("x"), Fraction(3, 2), problem.work)
        assert close(found.values[0], known.at(1.5)[0])


def test_a_base_that_moves_as_it_was_measured_pushes_through_a_damper_and_strikes_where_it_jumps(scene):
    problem = scene(JUMPING, "", "m", "base: {slide: f(t)}, ", "base")
    moving = motion.small(problem)
    rates = [slope for _, _, slope in lines(JUMPING)]
    pushed = [(t, K * y + C * slope, K * slope) for (t, y, slope) in lines(JUMPING)]
    assert len(rates) == len(pushed)
    with mpmath.workdps(60):
        known = Exactly(pushed, [(0.0, C * 1.0), (1.0, -C * 0.5)])
        found = motion.at_instant(moving, moving.coordinate("x"), Fraction(5, 2), problem.work)
        assert close(found.values[0], known.at(2.5)[0])


def test_a_carrier_that_moves_as_it_was_measured_strikes_at_each_sample(scene):
    text = """
records: {{f: {{file: f.csv, unit: m}}}}
bodies: {{base: {{slide: f(t)}}, b: {{mass: 1.5 kg, slide: {{by: x, carrier: base}}}}}}
springs: {{s: {{k: 25 N/m, between: [base, b]}}}}
dampers: {{d: {{c: 2 N*s/m, between: [base, b]}}}}
"""
    problem = scene(RECORD, "", text=text)
    moving = motion.small(problem)
    slopes = [slope for _, _, slope in lines(RECORD)]
    blows = [(t, -M * (after - before)) for (t, _), before, after in zip(RECORD, [0.0, *slopes], slopes, strict=False)]
    with mpmath.workdps(60):
        known = Exactly([(t, 0.0, 0.0) for t, _ in RECORD], blows)
        found = motion.at_instant(moving, moving.coordinate("x"), Fraction(3, 2), problem.work)
        assert close(found.values[0], known.at(1.5)[0])


@pytest.mark.sweep
def test_a_full_motion_under_a_record(scene):
    text = """
records: {{f: {{file: f.csv, unit: N*m}}}}
gravity: 9.81 m/s^2
bodies: {{a: {{mass: 1 kg, at: [0, -1 m], pin: {{at: [0, 0], by: p}}}}}}
forces: {{F: {{body: a, moment: 4*f(t)}}}}
motion: full
"""
    problem = scene(RECORD, "", text=text)
    swinging = motion.full(problem)
    found = motion.at_instant(swinging, swinging.coordinate("p"), Fraction(1, 2), problem.work).values[0]
    with mpmath.workdps(25):
        state = [mpmath.mpf(0), mpmath.mpf(0)]
        for t, y, slope in lines(RECORD)[:3]:
            def rates(s, state, y=y, slope=slope):
                return [state[1], 4 * (y + slope * s) - mpmath.mpf("9.81") * mpmath.sin(state[0])]
            state = mpmath.odefun(rates, 0, state)({0.0: 0.125, 0.125: 0.125, 0.25: 0.25}[t])
        assert abs(found - state[0]) < 1e-20 and abs(state[0]) > 0.1


def test_a_record_at_the_instants_of_another_function_has_no_reference(scene):
    problem = scene(RECORD, "forces: {F: {at: b, force: f(t^2/(1 s))}}")
    with pytest.raises(PhysicsError, match="the record 'f' is asked at other instants"):
        moving = motion.small(problem)
        motion.at_instant(moving, moving.coordinate("x"), Fraction(1), problem.work)
