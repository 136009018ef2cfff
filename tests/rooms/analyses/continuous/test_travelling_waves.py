"""Travelling waves against d'Alembert by hand and against transfer functions, reflection by reflection, in mpmath."""

from itertools import pairwise
from math import exp, sqrt

import mpmath
import numpy as np
import pytest

from vibcli.analyses.continuous import travelling_waves_march
from vibcli.analyses.continuous.travelling_waves import wave_motion
from vibcli.analyses.continuous.travelling_waves_piece import WavePiece
from vibcli.analyses.continuous.travelling_waves_search import extreme, stretches, zeros
from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Work

HELD = ({}, None)


def at(i):
    return {i: 1.0}, None


def rest(channels=1):
    return Forcing(channels, [Segment(0.0)])


def one_bar(mass=0.0, damper=0.0, pulled=1.0, field=None, length=1.0, tension=1.0, inertia=1.0):
    """A bar, its left end clamped, a mass and a damper at its right end, pulled there and let go."""
    piece = WavePiece(length, tension, inertia, HELD, at(0))
    return wave_motion(np.diag([mass]), np.diag([damper]), np.zeros((1, 1)), [piece], rest(), np.array([pulled]),
                      np.zeros(1), [field])


def u(i, rates=0):
    return LinearOutput(**{"qva"[rates]: {i: 1.0}})


def strain(x, piece=0):
    return LinearOutput(places={FieldPoint(piece, x, 1): 1.0})


def along(motion, output, end):
    return stretches(lambda times: motion.values(output, times), motion.breaks(output, end), 0.0, end, Work())


def test_bar_with_an_equal_mass_pulled_and_let_go():
    motion, tau = one_bar(mass=1.0), np.linspace(0, 2, 301)
    assert np.abs(motion.values(u(0), tau) - (2 - tau - np.exp(-tau))).max() <= 1e-14
    assert np.abs(motion.values(u(0, 1), tau) - (np.exp(-tau) - 1)).max() <= 1e-14
    later = np.linspace(1, 3, 301)
    assert np.abs(motion.values(strain(0.0), later) - (2 * np.exp(1 - later) - 1)).max() <= 1e-14
    assert motion.values(strain(0.0), np.array([0.5]))[0] == 1.0
    t, least = extreme(along(motion, u(0), 10.0), -1)
    assert abs(motion.values(u(0, 1), np.array([t]))[0]) < 1e-12
    assert least == pytest.approx(motion.values(u(0), np.linspace(0, 10, 4001)).min(), abs=1e-6)
    assert zeros(along(motion, u(0), 2.0), 2.0) == pytest.approx([float(mpmath.findroot(
        lambda x: 2 - x - mpmath.exp(-x), 1.8))], abs=1e-14)


@pytest.mark.parametrize(("length", "tension", "inertia"), [(1.0, 1.0, 1.0), (0.7, 2.1e7, 0.785), (1e-3, 3.0, 1e-5)])
def test_matched_damper_ends_the_motion(length, tension, inertia):
    motion = one_bar(damper=sqrt(tension * inertia) * (1 + 2e-16), pulled=0.01, length=length, tension=tension,
                     inertia=inertia)
    end = 2 * length * sqrt(inertia / tension)
    for x in (0.0, 0.3 * length, length):
        for along in (0, 1):
            place = LinearOutput(places={FieldPoint(0, x, along): 1.0})
            found = motion.values(place, end * np.array([0.4, 1.0, 1.5, 7.3]))
            assert np.abs(found[1:]).max() <= 4e-16 * 0.01 * (sqrt(tension / inertia) / length if along else 1.0)
            assert found[0] or not (x or along)


@pytest.mark.parametrize("r", [0.25, 3.0])
def test_unmatched_damper_leaves_a_power_of_its_reflection(r):
    motion = one_bar(damper=r)
    found = motion.values(u(0), np.array([2.0, 4.0, 6.0]) + 1e-13)
    ratio = (1 - r) / (1 + r)
    assert found == pytest.approx([(-1) ** k * ratio**k for k in (1, 2, 3)], abs=4e-13)


def test_plucked_string_is_the_mean_of_two_that_run():
    a, c, times = 0.3, 2.0, np.linspace(0, 9, 400)
    field = Forcing(2, [Segment(0.0, (Wave(0, 1 / a, 1, 0j),)),
                        Segment(a, (Wave(0, 1.0, 0, 0j), Wave(0, -1 / (1 - a), 1, 0j)))])
    none = np.zeros((0, 0))
    motion = wave_motion(none, none, none, [WavePiece(1.0, 4.0, 1.0, HELD, HELD)], rest(0), np.zeros(0), np.zeros(0),
                        [field])

    def odd(x):
        x = np.mod(x + 1, 2) - 1
        return np.sign(x) * np.minimum(np.abs(x) / a, (1 - np.abs(x)) / (1 - a))

    for x in (0.1, 0.3, 0.85):
        place = LinearOutput(places={FieldPoint(0, x): 1.0})
        assert np.abs(motion.values(place, times) - (odd(x - c * times) + odd(x + c * times)) / 2).max() < 1e-13
    at, both = np.array([0.3, 0.7]), (1 / 0.3 - 1 / 0.7) / 2
    assert motion.values(strain(0.3), at, before=True) == pytest.approx([both, -1 / 0.7])
    assert motion.values(strain(0.3), at) == pytest.approx([-1 / 0.7, both])


def test_bar_against_a_wall_and_bar_against_bar():
    running = Forcing(2, [Segment(0.0, (Wave(1, -1.0, 0, 0j),))])
    motion = one_bar(pulled=0.0, field=running, tension=4.0, inertia=1.0)
    assert motion.values(strain(0.0), np.array([0.0, 0.9, 1.1])) == pytest.approx([-0.5, -0.5, 0.5])
    pieces = [WavePiece(1.0, 1.0, 1.0, at(0), at(1)), WavePiece(1.0, 1.0, 1.0, at(1), at(2))]
    nothing = np.zeros((3, 3))
    right = Forcing(2, [Segment(0.0, (Wave(1, 1.0, 0, 0j),))])
    struck = wave_motion(nothing, nothing, nothing, pieces, rest(3), np.zeros(3), np.zeros(3), [right, None])
    inside = np.array([0.25, 0.75])
    for piece, speed in ((0, 0.0), (1, 1.0)):       # at t = 2 the struck bar has all the velocity
        for x in inside:
            rate = LinearOutput(places={FieldPoint(piece, x, 0, 1): 1.0})
            assert struck.values(rate, np.array([2.0])) == pytest.approx([speed], abs=1e-14)


def test_mass_that_hits_a_bar():
    """M v̇ = −Z v until the wave is back: v = e^{−Zt/M} (Saint-Venant)."""
    piece, mass = WavePiece(2.0, 9.0, 1.0, at(0), at(1)), 0.7
    nothing = np.zeros((2, 2))
    motion = wave_motion(np.diag([mass, 0.0]), nothing, nothing, [piece], rest(2), np.zeros(2), np.array([1.0, 0.0]))
    times = np.linspace(0, 2 * 2.0 / 3.0 * 0.999, 50)
    assert np.abs(motion.values(u(0, 1), times) - np.exp(-3.0 * times / mass)).max() < 1e-14
    assert motion.values(strain(2.0), np.linspace(0, 3, 50)) == pytest.approx(np.zeros(50), abs=1e-14)


def energy(motion, t, masses):
    """½Σ m v² + ½∫(μ u̇² + N u′²)dx by Gauss between the fronts of so many places that none hides."""
    x, w = np.polynomial.legendre.leggauss(12)
    total = sum(m / 2 * motion.values(u(i, 1), np.array([t]))[0]**2 for i, m in masses.items())
    for number, piece in enumerate(motion.pieces):
        delay, cuts = float(motion.march.delays[number]), {0.0, 1.0}
        for end, sign in ((0, 1), (1, -1)):
            starts = motion.march.leaving[2 * number + end].starts
            share = (t - starts[(starts < t) & (starts > t - delay)]) / delay
            cuts |= set((share if sign > 0 else 1 - share).tolist())
        cuts = sorted(cuts)
        for a, b in pairwise(cuts):
            for node, weight in zip(x, w, strict=True):
                place = piece.length * (a + (b - a) * (1 + node) / 2)
                rate, slope = (float(motion.values(LinearOutput(places={FieldPoint(number, place, *kind): 1.0}),
                                                   np.array([t]))[0]) for kind in ((0, 1), (1, 0)))
                total += piece.length * (b - a) / 4 * weight * (piece.inertia * rate**2 + piece.tension * slope**2)
    return total


@pytest.mark.sweep
def test_shaft_with_discs_keeps_its_energy_and_momentum():
    pieces = [WavePiece(1.0, 3.0, 1.0, at(0), at(1)), WavePiece(sqrt(2.0), 2.0, 0.5, at(1), at(2))]
    masses = {0: 0.8, 1: 0.3, 2: 1.1}
    nothing = np.zeros((3, 3))
    motion = wave_motion(np.diag(list(masses.values())), nothing, nothing, pieces, rest(3), np.array([0.0, 0.2, -0.1]),
                        np.array([1.0, 0.0, 0.0]))
    first = 0.5 * 0.8 + 0.5 * 3.0 * 0.2**2 + 0.5 * 2.0 * 0.3**2 / sqrt(2.0)
    for t in (0.9, 4.4):
        assert energy(motion, t, masses) == pytest.approx(first, rel=1e-13)


def test_moved_support():
    piece = WavePiece(1.0, 1.0, 1.0, ({}, 1), at(0))
    zero = np.zeros((1, 1))
    swing = wave_motion(zero, zero, zero, [piece], Forcing(2, [Segment(0.0, (Wave(1, -1j, 0, 2j),))]), np.zeros(1),
                       np.zeros(1))
    times = np.array([0.5, 1.5, 2.5])
    assert swing.values(u(0), times) == pytest.approx(np.where(times > 1, 2 * np.sin(2 * (times - 1)), 0.0), abs=1e-15)
    leap = wave_motion(zero, zero, zero, [piece], Forcing(2, [Segment(0.0), Segment(0.5, (Wave(1, 1.0, 0, 0j),))]),
                      np.zeros(1), np.zeros(1))
    assert leap.values(u(0), np.array([1.4, 1.6, 3.4, 3.6])) == pytest.approx([0.0, 2.0, 2.0, 0.0])
    assert leap.values(LinearOutput(places={FieldPoint(0, 0.0): 1.0}), np.array([0.4, 0.6, 2.4, 2.6])) == pytest.approx(
        [0.0, 1.0, 1.0, 1.0])


FIRST, SECOND = (1.0, 2.0, 0.5), (0.7, 1.0, 0.9)        # length, tension, inertia
SPRING, DAMPER, CARRIED = 1.5, 0.2, (0.25, 6.0)


def two_bars(m, M, segment):
    """Clamped, FIRST, a mass m with a spring, SECOND, a mass M with a damper and an oscillator."""
    k = CARRIED[1]
    K = np.array([[SPRING, 0.0, 0.0], [0.0, k, -k], [0.0, -k, k]])
    pieces = [WavePiece(*FIRST, HELD, at(0)), WavePiece(*SECOND, at(0), at(1))]
    return wave_motion(np.diag([m, M, CARRIED[0]]), np.diag([0.0, DAMPER, 0.0]), K, pieces, Forcing(3, [segment]),
                      np.zeros(3), np.zeros(3))


class Reflections:
    """Polynomials {(i, j): factor} in the delays e^{−sT₁}, e^{−sT₂}, cut off at an instant."""

    def __init__(self, until):
        self.T = [mpmath.sqrt(mpmath.mpf(mu) / N) * mpmath.mpf(length) for length, N, mu in (FIRST, SECOND)]
        self.until = until

    def times(self, a, b):
        found = {}
        for (i, j), x in a.items():
            for (p, q), y in b.items():
                if (i + p) * self.T[0] + (j + q) * self.T[1] <= self.until:
                    found[i + p, j + q] = found.get((i + p, j + q), 0) + x * y
        return found

    def plus(self, *parts):
        found = {}
        for part in parts:
            for key, x in part.items():
                found[key] = found.get(key, 0) + x
        return found

    def coth(self, which, factor):
        count = int(self.until / self.T[which]) + 1
        return {tuple(n * (k == which) for k in (0, 1)): factor * (2 if n else 1) for n in range(0, count + 1, 2)}

    def csch(self, which, factor):
        count = int(self.until / self.T[which]) + 1
        return {tuple(n * (k == which) for k in (0, 1)): 2 * factor for n in range(1, count + 1, 2)}

    def receptance(self, m, M, row, s):
        """Of the coordinate `row` to a force at the joint."""
        Z1, Z2 = (mpmath.sqrt(mpmath.mpf(N) * mu) * s for _, N, mu in (FIRST, SECOND))
        mass, k = CARRIED
        held = M * s**2 + DAMPER * s + k - k**2 / (k + mass * s**2)
        a = self.plus({(0, 0): m * s**2 + SPRING}, self.coth(0, Z1), self.coth(1, Z2))
        b, d = self.csch(1, Z2), self.plus({(0, 0): held}, self.coth(1, Z2))
        det = self.plus(self.times(a, d), self.times({(0, 0): -1}, self.times(b, b)))
        first = det.pop((0, 0))
        rest, term = {(0, 0): 1 / first}, {(0, 0): 1 / first}
        while term:
            term = self.times(term, {key: -x / first for key, x in det.items()})
            rest = self.plus(rest, term)
        return self.times((d, b)[row], rest)


def by_laplace(m, M, row, load, t, rate):
    """Reflection by reflection: what each leaves is rational in s, and inverted after its delay."""
    total = mpmath.mpf(0)
    one = Reflections(t)
    for i, j in one.receptance(m, M, row, mpmath.mpc(1, 1)):
        tau = t - i * one.T[0] - j * one.T[1]
        total += mpmath.invertlaplace(lambda s, i=i, j=j: one.receptance(m, M, row, s)[i, j] * load(s) * s**rate, tau,
                                      method="talbot", degree=30)
    return float(total)


@pytest.mark.sweep
@pytest.mark.parametrize(("m", "M", "segment", "load"), [
    (0.3, 0.4, Segment(0.0, (Wave(0, 1.0, 0, 0j),)), lambda s: 1 / s),
    (0.0, 0.0, Segment(0.0, (Wave(0, -1j, 0, 3j),)), lambda s: 3 / (s * s + 9)),
    (0.3, 0.0, Segment(0.0, (), ((0, 1.0),)), lambda s: 1),
    (0.0, 0.4, Segment(0.0, (Wave(0, 1.0, 1, -1 + 0j),), ((0, 0.5),)), lambda s: 1 / (s + 1)**2 + mpmath.mpf(0.5)),
], ids=["step", "sine, no masses", "blow on a mass", "blow on a joint"])
def test_two_bars_against_their_transfer_function(m, M, segment, load):
    motion, t = two_bars(m, M, segment), 2.13
    with mpmath.workdps(24):
        for row in (0, 1):
            for rate in (0, 1):
                expected = by_laplace(m, M, row, load, mpmath.mpf(t), rate)
                found = motion.values(u(row), np.array([t]), rate)[0]
                assert abs(found - expected) <= 2e-14
                assert abs(found - expected) <= motion.errors(u(row), np.array([t]), rate)[0] + 1e-16


@pytest.mark.sweep
def test_many_reflections_stay_exact_and_too_many_are_given_up(monkeypatch):
    motion = one_bar()
    assert motion.values(u(0), np.array([200.0, 202.0])) == pytest.approx([1.0, -1.0], abs=1e-13)
    pieces = [WavePiece(sqrt(k), 1.0, float(k), at(i), at(i + 1)) for i, k in enumerate((1, 2, 3, 5, 7, 11))]
    monkeypatch.setattr(travelling_waves_march, "MOST", 400)
    nothing = np.zeros((7, 7))
    many = wave_motion(nothing, nothing, nothing, pieces, rest(7), np.arange(7.0)**2, np.zeros(7))
    with pytest.raises(NotByWaves, match="fronts in this scene multiply"):
        many.values(u(3), np.array([1e4]))


def test_a_blow_on_what_nothing_holds_back_is_refused():
    piece = WavePiece(1.0, 1.0, 1.0, HELD, at(0))
    K = np.array([[1.0, -1.0], [-1.0, 2.0]])
    motion = wave_motion(np.zeros((2, 2)), np.zeros((2, 2)), K, [piece], Forcing(2, [Segment(0.0, (), ((1, 1.0),))]),
                        np.zeros(2), np.zeros(2))
    with pytest.raises(PhysicsError, match="displaced without bound"):
        motion.values(u(0), np.array([1.0]))


def test_velocity_of_a_matched_end_is_that_of_the_pull():
    assert one_bar(damper=1.0).values(u(0, 1), np.array([0.0, 1.9, 2.0])) == pytest.approx([-0.5, -0.5, 0.0])
    assert exp(0.0) == one_bar(damper=1.0).values(u(0), np.array([0.0]))[0]


def test_late_values_are_as_resolved_as_their_instants_tell():
    """At t = 30 s an instant is rounded by 4e-15 s, so that no part of a stretch resolves it any better."""
    parts = stretches(lambda times: np.sin(2000 * times), np.arange(30.0, 30.02, 1e-3), 30.0, 30.02, Work())
    assert len(parts.starts) <= 40
    assert extreme(parts, 1)[1] == pytest.approx(1.0, abs=1e-10)
