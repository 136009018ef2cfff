"""Linear responses against many digits, against closed forms of textbooks, and by the laws they obey."""

import math

import mpmath
import numpy as np
import pytest
from support.responses import EPS, FREE, STEP, case, chain, errors, exact_values, one, q, rates, systems, v

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient import extremes, isolating_intervals
from vibcli.analyses.transient.exponential_differences import differences
from vibcli.analyses.transient.extremes import ExtremeSearch
from vibcli.analyses.transient.high_precision import precise_value, precise_values
from vibcli.analyses.transient.linear_response import linear_motion
from vibcli.base.errors import PhysicsError

# one degree of freedom, m = 1, ω = 3

OMEGA = 3.0
ULP = 2.0**-52
ZETAS = [0.0, 1e-12, 1e-3, 0.3, 1 - 1e-6, 1 - ULP / 2, 1.0, 1 + ULP, 1 + 1e-6, 1.7, 1e3, 1e8, -0.01]
LOADS = {
    "start": FREE, "step": STEP, "impulse": (Segment(0.0, (), ((0, 1.0),)),),
    "ramp": (Segment(0.0, (Wave(0, 1.0, 1, 0j),)),), "harmonic": (Segment(0.0, (Wave(0, 1.0, 0, 2j),)),),
    "resonance": (Segment(0.0, (Wave(0, -1j, 0, 3j),)),),
    "an ulp above": (Segment(0.0, (Wave(0, 1.0, 0, 1j * math.nextafter(3, 4)),)),),
    "an ulp below": (Segment(0.0, (Wave(0, 1.0, 0, 1j * math.nextafter(3, 2)),)),),
    "beat": (Segment(0.0, (Wave(0, 1.0, 0, 3.0000001j),)),),
    "decaying": (Segment(0.0, (Wave(0, 1.0, 2, -3 + 0j),)),),
    "pulse": (Segment(0.0), Segment(1.0, (Wave(0, 2.0, 0, 0j),)), Segment(1.005)),
}


@pytest.mark.sweep
@pytest.mark.parametrize("load", LOADS)
def test_one_degree_to_a_few_roundings(load):
    """Gate A6: 4 eps max(1, ωt) of the envelope, the largest value so far; of the speed likewise with ωx."""
    swept = 0
    times = (1e-6, 0.01, 0.3, 1.0, 1.002, 2.0, 10.0, 100.0, 333.0)
    before = np.concatenate([np.linspace(0, t, 100) for t in times])
    for zeta in ZETAS:
        motion = one(1.0, 6 * zeta, 9.0, LOADS[load], 1.0 if load == "start" else 0.0)
        highest, fastest = (np.maximum.accumulate(np.abs(motion.values(output, before)).reshape(-1, 100).max(axis=1))
                            for output in (q(0), v(0)))
        allowed = 4 * EPS * np.maximum(1.0, OMEGA * np.array(times))
        sizes = np.array([highest, np.maximum(fastest, OMEGA * highest)]) * allowed
        exact = exact_values(motion, [q(0), v(0)], times)
        for i, output in enumerate((q(0), v(0))):
            for t, value, size, numbers in zip(times, motion.values(output, times), sizes[i], exact, strict=True):
                assert abs(value - numbers[i]) <= size, (zeta, t)
                swept += 1
    assert swept == 13 * 9 * 2


# several degrees of freedom

NAMES = [name for name, *_ in systems(np.random.default_rng(0))]


@pytest.mark.sweep
@pytest.mark.parametrize("place", range(len(NAMES)), ids=NAMES)
def test_several_degrees(place):
    """Gate A7: 1e-12 up to ωt = 1e3, then 4 eps ωt, ω the largest rate in the system."""
    rng = np.random.default_rng(1 + place % 2)
    _, M, C, K = systems(rng)[place]
    motion, times, fastest = case(M, C, K, rng)
    assert len(times) >= 3
    for t, error in zip(times, errors(motion, times, fastest), strict=True):
        assert error <= max(1e-12, 4 * EPS * fastest * t), t


@pytest.mark.sweep
def test_the_measure_sees_a_wrong_response():
    rng = np.random.default_rng(1)
    _, M, C, K = systems(rng)[0]
    motion, times, fastest = case(M, C, K, rng)
    motion.C = motion.C * (1 + 1e-9)
    assert max(errors(motion, times, fastest)) > 1e-12


@pytest.mark.sweep
def test_derivatives_and_mixed_outputs():
    rng = np.random.default_rng(4)
    _, M, C, K = systems(rng)[0]
    motion, times, _ = case(M, C, K, rng)
    times = times[::2]
    output = LinearOutput(0.7, q={0: 1.0}, v={1: 0.4}, a={0: -0.2, 1: 1.0}, channels={1: 0.3})
    lists = [matrix.tolist() for matrix in (M, C, K)]
    for order in range(4):
        exact = [precise_value(*lists, motion.forcing, motion.q0, motion.v0, output, t, 20, order) for t in times]
        size = max(map(abs, exact))
        found = motion.values(output, times, order)
        assert max(abs(x - y) for x, y in zip(found, exact, strict=True)) <= 1e-12 * size


def test_differences_where_nodes_meet():
    mpmath = pytest.importorskip("mpmath")
    t = np.array([1e-8, 1e-3, 0.5, 1.0, 3.0, 40.0])
    swept = 0
    for nodes in ((0, 0), (1j, -1j), (1j, 1j + 1e-9, -1j), (-1, -1 - 1e-8, -1 + 1e-8j, 0), (0, 0, 0, 0), (-1e-6, 0, 0),
                  (1j, -1j, 0, 0, 0), (-2 + 1j, -2 - 1j, 1j, 1j, 1j), (-1e8, -1e-8, 0)):
        with mpmath.workdps(300):
            for at, found in zip(t, differences(nodes, t), strict=True):
                apart = [mpmath.mpc(node) + i * mpmath.mpf(10) ** -40 for i, node in enumerate(nodes)]
                exact = sum(mpmath.exp(a * mpmath.mpf(at)) / mpmath.fprod(a - b for b in apart if b is not a)
                            for a in apart)
                assert abs(exact - complex(found)) <= 1e-14 * max(abs(exact), float(bound(nodes, at))), (nodes, at)
                swept += 1
    assert swept == 54


def bound(nodes, t):
    """What E[nodes](t) grows to: tᵐ⁻¹/(m−1)! or, where nodes lie apart, less."""
    from vibcli.analyses.transient.exponential_differences import bounds

    return bounds(tuple(map(complex, nodes)), np.array([t]), np.array([t]))[0]


@pytest.mark.parametrize("gap", [1e-11, -0.05, 0.1j, 1e-3 + 0.02j])
def test_nodes_that_beat_stay_within_their_bounds(gap):
    """Nowhere above them, and for short times no more than these are long below."""
    from vibcli.analyses.transient.exponential_differences import bounds

    nodes, early = (-1e-3 + 1j, -1e-3 + 1j + gap), np.linspace(0, 400, 4001)
    inside = np.abs([differences(nodes, early + part * 0.1) for part in np.linspace(0, 1, 11)]).max(axis=0)
    bound = bounds(nodes, early, early + 0.1)
    assert (inside <= bound * (1 + 1e-12)).all()
    assert (bound <= inside + 0.101 * np.maximum(1.0, np.exp((gap.real - 1e-3) * early))).all()


# textbook forms

def test_textbook_forms():
    t = np.linspace(0, 8, 81)
    zeta, wd = 0.2, 3 * math.sqrt(1 - 0.04)
    free = one(1.0, 1.2, 9.0, FREE, 1.0, 2.0).values(q(0), t)
    expected = np.exp(-0.6 * t) * (np.cos(wd * t) + (2 + 0.6) / wd * np.sin(wd * t))
    assert np.abs(free - expected).max() < 1e-15
    step = one(1.0, 1.2, 9.0, STEP).values(q(0), t)
    expected = (1 - np.exp(-0.6 * t) * (np.cos(wd * t) + zeta / math.sqrt(1 - zeta**2) * np.sin(wd * t))) / 9
    assert np.abs(step - expected).max() < 1e-15
    grows = one(1.0, 0.0, 9.0, LOADS["resonance"]).values(q(0), t)
    assert np.abs(grows - (np.sin(3 * t) - 3 * t * np.cos(3 * t)) / 18).max() < 1e-15
    thrown = one(2.0, 0.0, 0.0, (Segment(0.0, (Wave(0, 4.0, 0, 0j),)),), 1.0, 3.0).values(q(0), t)
    assert np.abs(thrown - (1 + 3 * t + t**2)).max() < 1e-13


# laws

@pytest.mark.parametrize("place", [0, 4, 8, 12, 16], ids=[NAMES[i] for i in (0, 4, 8, 12, 16)])
def test_superposition_and_shift_in_time(place):
    rng = np.random.default_rng(7)
    _, M, C, K = systems(rng)[place]
    n, fastest = len(M), np.abs(rates(M, C, K)).max()
    t = np.linspace(0, 20 / fastest, 50)
    load = (Wave(0, 1 - 2j, 0, 1.3j * fastest), Wave(1, 0.4, 1, complex(-fastest)))
    other = (Wave(1, 2.0, 2, 0j), Wave(0, 1.0, 0, 0.2j * fastest))
    start, rest = rng.normal(size=n), np.zeros(n)

    def motion(waves, q0, at=0.0):
        pieces = [Segment(at, tuple(waves))] if not at else [Segment(0.0), Segment(at, tuple(waves))]
        return linear_motion(M, C, K, Forcing(n, pieces), q0, rest)

    def size(y):
        return 1e-13 * np.abs(y).max()

    both = motion(load + other, start).values(q(1), t)
    parts = sum(motion(waves, q0).values(q(1), t) for waves, q0 in ((load, rest), (other, rest), ((), start)))
    assert np.abs(both - parts).max() <= size(both)
    early, late = motion(load, rest).values(q(1), t), motion(load, rest, 5 / fastest).values(q(1), t + 5 / fastest)
    assert np.abs(early - late).max() <= 4 * size(early)


def test_energy_balance():
    """Work of the load = energy gained + energy dissipated, by Gauss quadrature of power."""
    rng = np.random.default_rng(5)
    _, M, C, K = systems(rng)[0]
    n, T = len(M), 10.0
    forcing = Forcing(n, [Segment(0.0, (Wave(0, 1.0, 0, 1.1j),))])
    motion = linear_motion(M, C, K, forcing, rng.normal(size=n), rng.normal(size=n))
    x, w = np.polynomial.legendre.leggauss(30)
    t = (np.arange(60)[:, None] + (x + 1) / 2).ravel() * T / 60
    speed = np.array([motion.values(v(i), t) for i in range(n)])
    weights = np.tile(w, 60) * T / 120
    work, lost = weights @ (speed[0] * np.cos(1.1 * t)), weights @ np.einsum("it,ij,jt->t", speed, C, speed)

    def energy(at):
        x, u = (np.array([motion.values(output(i), [at])[0] for i in range(n)]) for output in (q, v))
        return (u @ M @ u + x @ K @ x) / 2

    assert abs(energy(T) - energy(0.0) + lost - work) <= 1e-13 * (abs(lost) + energy(0.0))


@pytest.mark.parametrize("place", range(len(NAMES)), ids=NAMES)
def test_units_change_no_bit(place):
    """Gate A17: lengths, masses and times counted in units of powers of two."""
    rng = np.random.default_rng(11)
    _, M, C, K = systems(rng)[place]
    n, mass, time = len(M), 2.0**6, 2.0**-5
    length = 2.0 ** rng.integers(-8, 8, n)
    t = np.linspace(0, 7, 30) / (np.abs(rates(M, C, K)).max() or 1.0)
    q0, v0 = rng.normal(size=n), rng.normal(size=n)
    plain = linear_motion(M, C, K, Forcing(n, STEP), q0, v0)
    scale = mass * length[:, None] * length
    pieces = (Segment(0.0, (Wave(0, mass * length[0] / time**2, 0, 0j),)),)
    scaled = linear_motion(scale * M, scale * C / time, scale * K / time**2, Forcing(n, pieces), q0 / length,
                           v0 / length / time)
    for i in range(n):
        assert (plain.values(q(i), t) == scaled.values(q(i), t * time) * length[i]).all()


@pytest.mark.parametrize("place", range(len(NAMES)), ids=NAMES)
def test_nothing_but_finite_numbers(place, recwarn):
    """Gate A18, with times far beyond any use."""
    rng = np.random.default_rng(13)
    _, M, C, K = systems(rng)[place]
    motion, times, _ = case(M, C, K, rng)
    stable = rates(M, C, K).real.max() < 1e-9
    for output in (q(0), v(1), LinearOutput(a={0: 1.0})):
        found = motion.values(output, [0.0, *times, *([1e9] if stable else ())])
        assert found.dtype == float and np.isfinite(found).all()
        assert np.isfinite(motion.values(output, times, 2)).all()
    assert not recwarn.list


def test_growth_beyond_numbers_is_said():
    with pytest.raises(PhysicsError, match="grows beyond the range"):
        one(1.0, -1.0, 9.0, FREE, 1.0).values(q(0), [2000.0])


@pytest.mark.parametrize("M", [[[1.0, 1.0], [1.0, 1.0]], [[1.0, 0.0], [0.0, -1.0]], [[0.0, 1.0], [1.0, 1.0]]])
def test_without_inertia_there_is_no_motion(M):
    n = len(M)
    with pytest.raises(PhysicsError, match="no positive inertia"):
        linear_motion(M, np.zeros((n, n)), np.eye(n), Forcing(n, FREE), np.zeros(n), np.zeros(n))


def test_what_is_not_finite_is_refused():
    with pytest.raises(PhysicsError, match="not a finite number"):
        one(1.0, math.nan, 9.0)


# many segments

@pytest.mark.sweep
def test_a_record_of_many_pieces():
    rng = np.random.default_rng(3)
    n, count = 3, 60
    M, K = np.diag([1.0, 2, 3]), chain([40.0, 30, 20])
    C = 0.02 * K + np.diag([0.1, 0, 0.3])
    at, force = np.linspace(0, 10, count + 1), rng.normal(size=count + 1)
    slopes = np.diff(force) / np.diff(at)
    pieces = [Segment(t, (Wave(0, f, 0, 0j), Wave(0, s, 1, 0j))) for t, f, s in zip(at, force, slopes, strict=False)]
    motion = linear_motion(M, C, K, Forcing(n, [*pieces, Segment(10.0)]), np.zeros(n), np.zeros(n))
    lists = [matrix.tolist() for matrix in (M, C, K)]
    size = np.abs(motion.values(q(2), at)).max()
    for t in (0.09, 4.9, 12.0):
        exact = precise_value(*lists, motion.forcing, motion.q0, motion.v0, q(2), t, 18)
        assert abs(motion.values(q(2), [t])[0] - exact) <= 1e-13 * size


def test_modes_that_are_known_replace_those_of_the_matrices():
    from vibcli.analyses.modal.undamped import undamped
    from vibcli.mechanics.factored_system import FactoredSystem

    stiffnesses = [1e12, 1.0, 1e8, 3.0]
    rows = [{0: 1.0}, *({i - 1: -1.0, i: 1.0} for i in range(1, 4))]
    elements = FactoredSystem(4, inertias=[(1.0, {i: 1.0}) for i in range(4)],
                                  springs=list(zip(stiffnesses, rows, strict=True)))
    modes, K = undamped(elements), chain(stiffnesses)
    for C in (0 * K, 0.01 * np.eye(4)):
        motion = linear_motion(np.eye(4), C, K, Forcing(4, FREE), [0, 1.0, 1.0, 1.0], np.zeros(4), modes)
        assert sum(block.half for block in motion.blocks) == 4
        exact = precise_value(np.eye(4).tolist(), C.tolist(), [[int(x) for x in row] for row in K], motion.forcing,
                              motion.q0, motion.v0, q(3), 5.0, 20)
        assert abs(motion.values(q(3), [5.0])[0] - exact) <= 1e-14


def test_an_extreme_is_found_in_few_looks(monkeypatch):
    """Many stretches of time take little longer than one: so there are many in each look."""
    looks, look = [], ExtremeSearch._look
    monkeypatch.setattr(ExtremeSearch, "_look", lambda *given: looks.append(len(given[-1])) or look(*given))
    t, x = one(1.0, 0.6, 9.0, FREE, 1.0).extreme(q(0), 0.0, 40.0, "min")
    turn = math.pi / math.sqrt(8.91)
    assert abs(t - turn) <= 1e-7 and abs(x + math.exp(-0.3 * turn)) <= 4 * EPS
    assert len(looks) <= 4 and max(looks) <= 500


def test_where_very_much_waits_the_shortest_stretches_come_first(monkeypatch):
    """Then what waits does not grow with the length of the search, and the extreme is the same."""
    load = Segment(0.0, (Wave(0, 1.0, 0, 3.0001j),))
    found, waited, ask = [], [], ExtremeSearch._next

    def asked(search):
        part = ask(search)
        waited[-1].append((sum(len(cells) for *_, cells in search.left), part[1] == max(p[1] for p in search.left)))
        return part

    monkeypatch.setattr(ExtremeSearch, "_next", asked)
    monkeypatch.setattr(isolating_intervals, "BATCH", 0)
    for waiting in (extremes.WAITING, 0):
        monkeypatch.setattr(extremes, "WAITING", waiting)
        waited.append([])
        found.append(one(1.0, 1e-6, 9.0, (load,), 1.0).extreme(q(0), 0.0, 500.0, "max"))
    (many, deep), (fewer, deepest) = (zip(*one, strict=True) for one in waited)
    assert found[0] == found[1] and max(fewer) < max(many)
    assert all(deepest) and not all(deep)


def test_what_has_died_out_is_no_zero_and_what_never_moves_is():
    """x = e^{−20t} (cos 10t + 2 sin 10t); nothing moves the other coordinate."""
    with mpmath.workdps(40):
        exact = mpmath.exp(-600) * (mpmath.cos(300) + 2 * mpmath.sin(300))
    x, other = precise_values(np.eye(2).tolist(), np.diag([40.0, 1.0]).tolist(), np.diag([500.0, 1.0]).tolist(),
                              Forcing(2, FREE), [1.0, 0.0], [0.0, 0.0], [q(0), q(1)], 30.0, 12)
    assert abs(x - exact) <= abs(exact) * 1e-12 and other == 0
