"""Frequency response: against mpmath, against identities of linear systems, and against published values."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.closed_form.frequency_response import formula
from vibcli.analyses.frequency_response import large_systems
from vibcli.analyses.frequency_response.direct import direct, scales
from vibcli.analyses.frequency_response.evaluate import frf, sampled, sloped
from vibcli.analyses.frequency_response.extremes import extremes
from vibcli.analyses.frequency_response.fixed_points import fixed_points
from vibcli.analyses.frequency_response.frequency_grid import adaptive
from vibcli.analyses.frequency_response.peaks import antiresonances, half_power, peaks
from vibcli.analyses.frequency_response.transfer_function import FROM, MANY, TransferFunction, transfer
from vibcli.analyses.frequency_response.value_errors import of_values
from vibcli.analyses.transient.data_errors import of_matrices
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate

EPS = 2.0**-52


def unit(n, i, power=0):
    found = np.zeros((3, n))
    found[power, i] = 1.0
    return found


def chain(weights):
    """The matrix of springs (dampers) of a chain, the first of them to the ground."""
    n = len(weights)
    found = np.zeros((n, n))
    for i, weight in enumerate(weights):
        found[i, i] += weight
        if i:
            found[i - 1, i - 1] += weight
            found[i - 1, i] -= weight
            found[i, i - 1] -= weight
    return found


def random_system(rng, n, kind):
    """Masses, springs and dampers over six decades; `kind` of damping or structure."""
    M, K = np.diag(10 ** rng.uniform(-2, 2, n)), chain(10 ** rng.uniform(0, 6, n))
    C = np.zeros((n, n))
    if kind == "proportional":
        C = 0.01 * M + 1e-4 * K
    elif kind == "damped":
        C = chain(10 ** rng.uniform(-1, 3, n))
    elif kind == "gyroscopic":
        G = rng.normal(size=(n, n)) * 10
        C = chain(10 ** rng.uniform(-1, 1, n)) + G - G.T
    elif kind == "coupled":
        A = rng.normal(size=(n, n))
        M, C = M + A @ A.T, chain(10 ** rng.uniform(-1, 3, n)) + 0.01 * A.T @ A
    elif kind == "massless":
        M[n // 2, n // 2], C = 0.0, chain(10 ** rng.uniform(-1, 3, n))
    b = unit(n, rng.integers(n)) * 3.0
    c = unit(n, rng.integers(n), rng.integers(3))
    return TransferFunction(M, C, K, b, c, (0.1, 0.02, 0.0))


KINDS = ("undamped", "proportional", "damped", "gyroscopic", "coupled", "massless")


def exact(system, Omega):
    """H in 50 digits."""
    with mpmath.workdps(50):
        s, n = mpmath.mpc(0, float(Omega)), system.n
        D = mpmath.matrix([[mpmath.mpf(system.K[i, j]) + s * mpmath.mpf(system.C[i, j]) + s**2 * mpmath.mpf(
            system.M[i, j]) for j in range(n)] for i in range(n)])
        def power(parts, i):
            return sum(mpmath.mpf(float(parts[k, i])) * s**k for k in range(3))
        x = mpmath.lu_solve(D, mpmath.matrix([power(system.b, i) for i in range(n)]))
        found = sum(power(system.c, i) * x[i] for i in range(n))
        return complex(found + sum(mpmath.mpf(float(system.d[k])) * s**k for k in range(3)))


def bound(system, Omega):
    """10 eps × condition: |c| |D⁻¹| (|D| |D⁻¹| |b|) normwise in scaled coordinates."""
    s = np.array([1j * Omega])
    scale = scales(system, s)[0]
    D = (system.K + s[0] * system.C + s[0]**2 * system.M) * np.outer(scale, scale)
    size = (np.abs(system.K) + Omega * np.abs(system.C) + Omega**2 * np.abs(system.M)) * np.outer(scale, scale)
    inverse = np.linalg.inv(D)
    b, c = (np.abs(sum(part[k] * s[0]**k for k in range(3)) * scale) for part in (system.b, system.c))
    direct_part = abs(sum(system.d[k] * s[0]**k for k in range(3)))
    return 10 * EPS * (np.linalg.norm(c @ np.abs(inverse)) * np.linalg.norm(size) * np.linalg.norm(np.abs(inverse) @ b)
                       + c @ np.abs(inverse) @ b + direct_part)


@pytest.mark.sweep
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 5, 12])
def test_few_degrees_against_fifty_digits(kind, n):
    rng, worst = np.random.default_rng(n), 0.0
    for _ in range(5):
        system = random_system(rng, n, kind if n > 1 or kind != "massless" else "damped")
        for Omega in 10 ** rng.uniform(-1, 4, 6):
            worst = max(worst, abs(frf(system, Omega) - exact(system, Omega)) / bound(system, Omega))
    assert worst <= 1.0


@pytest.mark.sweep
@pytest.mark.parametrize("kind", ["undamped", "proportional", "damped", "coupled", "gyroscopic"])
def test_many_degrees_against_fifty_digits(kind):
    rng = np.random.default_rng(7)
    system = random_system(rng, 30, kind)
    method = large_systems.chosen(system)
    assert method is not None
    Omega = 10 ** rng.uniform(-1, 4, 5)
    values, _, resonant = method(system, 1j * Omega)
    assert not resonant.any()
    for k, at in enumerate(Omega):
        assert abs(values[k] - exact(system, at)) <= bound(system, at)


def coupled(rng, n, kind):
    """Masses, full springs and dampers; twice the same and weakly tied, or damped critically, so that modes are as good
    as dependent."""
    half = n if kind == "full" else n // 2
    A, B = rng.normal(size=(2, half, half))
    K, C, M = A @ A.T + half * np.eye(half), 0.05 * B @ B.T, np.diag(rng.uniform(1, 3, half))
    if kind != "full":
        K, C, M = (np.kron(np.eye(2), part) for part in (K, C, M))
        K[0, half] = K[half, 0] = 1e-9
    if kind == "critical":
        M, C = np.eye(n), 2 * np.linalg.cholesky(K + 1e-12 * np.eye(n))
        C = (C + C.T) / 2
        K = C @ C / 4
    return TransferFunction(M, C, (K + K.T) / 2, unit(n, 0) * 3.0, unit(n, n - 1) + unit(n, 1, 1))


@pytest.mark.sweep
@pytest.mark.parametrize("kind", ["full", "twice", "critical"])
def test_modes_with_one_residual_against_fifty_digits(kind):
    """As near as LU, where damping couples the modes; |δH| within what is told of the rounding of each value."""
    system = coupled(np.random.default_rng(5), 16, kind)
    Omega = np.linspace(0.2, 12.0, 9)
    values, _, resonant = large_systems.chosen(system)(system, 1j * Omega)
    told = of_values(system, of_matrices(system.M, system.C, system.K), Omega)
    wanted = np.array([exact(system, at) for at in Omega])
    assert not resonant.any()
    assert (np.abs(values - wanted) <= told).all()
    assert (np.abs(values - wanted) <= [bound(system, at) for at in Omega]).all()


def test_the_method_for_many_frequencies_is_chosen_after_some(monkeypatch):
    """Of few degrees of freedom never, of more of them once so many frequencies were asked for, in one call or many."""
    calls = []
    monkeypatch.setattr(large_systems, "chosen", lambda system: calls.append(system.n))
    for n in (FROM - 1, FROM):
        system = random_system(np.random.default_rng(n), n, "damped")
        for _ in range(MANY):
            sampled(system, np.array([1.0]))
        assert calls == []
        sampled(system, np.linspace(1, 2, 5))
        sampled(system, np.linspace(1, 2, 500))
        assert calls == [n] * (n == FROM)


@pytest.mark.parametrize("kind", KINDS[:5])
def test_methods_agree_with_their_slopes(kind):
    """dH/ds of every method is the difference quotient along the axis."""
    rng = np.random.default_rng(3)
    system = random_system(rng, 40, kind)
    Omega = np.array([3.0, 40.0, 700.0])
    for method in (direct, large_systems.chosen(system)):
        values, slopes, _ = method(system, 1j * Omega, True)
        step = 1e-5 * Omega
        ends = [direct(system, 1j * (Omega + sign * step))[0] for sign in (1, -1)]
        size = np.abs(slopes) + np.abs(values) / Omega
        assert np.abs((ends[0] - ends[1]) / (2j * step) - slopes) == pytest.approx(0 * size, abs=1e-4 * size.max())


@pytest.mark.parametrize("width", [1, 3, 8])
def test_slopes_of_systems_with_a_narrow_band(width):
    """As full matrices give them, near resonances too, where damping turns the phase."""
    rng, n = np.random.default_rng(width), 30
    band = np.abs(np.subtract.outer(np.arange(n), np.arange(n))) <= width
    K, M, C = (np.where(band, rng.uniform(-1, 1, (n, n)), 0.0) for _ in range(3))
    K, M = 50 * (K + K.T) + 200 * width * np.eye(n), 0.1 * (M + M.T) + width * np.eye(n)
    system = TransferFunction(M, C + width * np.eye(n), K, unit(n, 3) * 3.0, unit(n, n - 2), (0.1, 0.02, 0.0))
    assert large_systems._ordered(system)[1] <= large_systems.NARROW
    s = 1j * np.array([0.5, 5.0, 12.0, 14.0, 17.0, 40.0])
    methods = large_systems.chosen(system), direct
    (values, slopes, _), (wanted, steep, _) = (method(system, s, True) for method in methods)
    assert values == pytest.approx(wanted, rel=1e-10)
    assert slopes == pytest.approx(steep, rel=1e-9)


def test_the_bound_rejects_a_wrong_answer():
    system = random_system(np.random.default_rng(1), 5, "damped")
    assert abs(frf(system, 3.0) * (1 + 1e-6) - exact(system, 3.0)) > bound(system, 3.0)


@pytest.mark.parametrize("kind", ["undamped", "proportional", "damped", "coupled"])
def test_reciprocity(kind):
    rng = np.random.default_rng(11)
    system = random_system(rng, 6, kind)
    for i, j in ((0, 5), (2, 3)):
        there, back = (TransferFunction(system.M, system.C, system.K, unit(6, a), unit(6, b))
                       for a, b in ((i, j), (j, i)))
        Omega = 10 ** rng.uniform(-1, 3, 20)
        assert frf(there, Omega) == pytest.approx(frf(back, Omega), rel=1e-9)


def test_sum_of_modes():
    """H = Σ φᵢφⱼ/(ω² − Ω²) with the modes of a scene."""
    scene = problem("""
        parameters: {m: 2 kg, k: 800 N/m}
        bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}, c: {mass: m, slide: z}}
        springs:
          s: {k: k, between: [ground, a]}
          t: {k: 2*k, between: [a, b]}
          u: {k: k, between: [b, c]}
    """)
    Omega = np.array([1.0, 12.0, 33.0])
    total = sum(mode.shape[0] * mode.shape[2] / (mode.omega**2 - Omega**2) for mode in scene.modal.modes)
    assert frf(transfer(scene.configuration, "x", "z"), Omega) == pytest.approx(total, rel=1e-12)


def oscillator(zeta, omega=10.0, order=0):
    return TransferFunction([[1.0]], [[2 * zeta * omega]], [[omega**2]], unit(1, 0), unit(1, 0), order=order)


@pytest.mark.parametrize("zeta", [1e-8, 1e-3, 0.05, 0.3, 0.7])
def test_peak_of_one_degree(zeta):
    """ω√(1 − 2ζ²) and 1/(2ζ√(1 − ζ²)) of receptance; mobility peaks at ω with 1/(2ζω)."""
    (peak,) = peaks(oscillator(zeta))
    assert peak.Omega == pytest.approx(10 * math.sqrt(1 - 2 * zeta**2), rel=4e-16 / max(1 - 2 * zeta**2, zeta))
    assert peak.value == pytest.approx(0.01 / (2 * zeta * math.sqrt(1 - zeta**2)), rel=1e-15 / zeta)
    (peak,) = peaks(oscillator(zeta, order=1))
    assert peak.Omega == pytest.approx(10.0, rel=1e-15 / zeta**0.5)
    (peak,) = peaks(oscillator(zeta, order=2))
    assert peak.Omega == pytest.approx(10 / math.sqrt(1 - 2 * zeta**2), rel=5e-15 / min(zeta, 1 - 2 * zeta**2))


def test_beyond_the_last_peak():
    assert not peaks(oscillator(0.8)) and not peaks(oscillator(3.0))
    assert frf(oscillator(0.8), 0.0) == 0.01


def test_half_power_of_one_degree():
    """Of mobility the half-power points are ω(√(1 + ζ²) ± ζ), so that Q = 1/(2ζ) exactly."""
    for zeta in (0.001, 0.05, 0.4):
        system = oscillator(zeta, order=1)
        (peak,) = peaks(system)
        low, high = half_power(system, peak)
        assert (low, high) == pytest.approx((10 * (math.hypot(1, zeta) - zeta), 10 * (math.hypot(1, zeta) + zeta)),
                                            rel=1e-13)
        assert peak.Omega / (high - low) == pytest.approx(1 / (2 * zeta), rel=1e-12)


def test_what_is_read_off_all_peaks_is_found_together(monkeypatch):
    """H is asked at all places that a round needs at once, and each number is that of its peak alone."""
    text = ABSORBER % ("600 N/m", "2 N*s/m")
    together, alone = (problem(text).frequency_response("x1", "drive") for _ in range(2))
    asked, at = [], TransferFunction.at
    monkeypatch.setattr(TransferFunction, "at", lambda self, s, steep=False: (
        asked.append(len(s)), at(self, s, steep))[1])
    together.find_errors()
    assert len(asked) <= 60 and asked.count(1) <= 8, asked
    for number in (1, 2):
        points = half_power(alone.transfer, alone.peak(number), alone.listed(math.inf).extremes)
        assert together.half_power_of(number) == pytest.approx(points, rel=1e-15)
        assert alone.errors_of_half_power(number) == pytest.approx(together.errors_of_half_power(number), rel=1e-9)
        assert alone.error_of_peak(number) == pytest.approx(together.error_of_peak(number), rel=1e-9)
        assert alone.quality(number) == pytest.approx(together.quality(number), rel=1e-14)


def test_a_peak_without_half_power_points_hides_none_of_the_others():
    curve = problem(ABSORBER % ("900 N/m", "12 N*s/m")).frequency_response("x1", "drive")
    curve.find_errors()
    found = []
    for number in range(1, len(curve.peaks) + 1):
        try:
            found.append(curve.half_power_of(number))
        except PhysicsError as refused:
            found.append(str(refused))
    assert isinstance(found[0], tuple) and "does not fall to peak/√2 below" in found[1], found


def test_no_half_power_point_below_a_flat_peak():
    system = oscillator(0.4)
    (peak,) = peaks(system)
    with pytest.raises(PhysicsError, match="below the peak"):
        half_power(system, peak)


@pytest.mark.sweep
@pytest.mark.parametrize(("method", "n"), [("direct", 3), ("many", 40)])
def test_a_pole_on_the_grid_is_said(method, n):
    """Equal masses and springs between two walls: ω_k = 2√(k/m) sin(kπ/(2(n + 1)))."""
    K = 100 * (2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
    system = TransferFunction(np.eye(n), np.zeros((n, n)), K, unit(n, 0), unit(n, n - 1))
    omega = 20 * np.sin(np.arange(1, n + 1) * np.pi / (2 * n + 2))
    run = direct if method == "direct" else large_systems.chosen(system)
    values, _, resonant = run(system, 1j * np.array([1.0, *omega]))
    assert not resonant[0] and resonant[1:].all() and np.isfinite(values).all()
    with pytest.raises(PhysicsError, match="natural frequency"):
        frf(system, omega)
    assert [one.value for one in peaks(system)] == [None] * n
    assert [one.Omega for one in peaks(system)] == pytest.approx(omega, rel=1e-13)


def test_a_mode_that_is_not_driven_is_left_out():
    """Two equal masses driven alike: the mode in which they move against each other takes no part."""
    K = np.array([[200.0, -100.0], [-100.0, 200.0]])
    b = np.zeros((3, 2))
    b[0] = 1.0
    system = TransferFunction(np.eye(2), np.zeros((2, 2)), K, b, unit(2, 0))
    assert frf(system, math.sqrt(300)) == pytest.approx(1 / (100 - 300), rel=1e-12)
    assert [one.Omega for one in peaks(system)] == pytest.approx([10.0])


def test_rigid_motion_at_rest_is_a_pole():
    system = TransferFunction(np.diag([1.0, 2.0]), np.zeros((2, 2)), [[5.0, -5.0], [-5.0, 5.0]], unit(2, 0), unit(2, 1))
    with pytest.raises(PhysicsError):
        frf(system, 0.0)
    assert np.isfinite(frf(system, 1e-3))


def test_antiresonances_interlace_with_resonances():
    """At the driving point they are the frequencies of the chain held there."""
    rng = np.random.default_rng(5)
    m, k = rng.uniform(1, 3, 6), rng.uniform(50, 200, 6)
    K = chain(k)
    system = TransferFunction(np.diag(m), np.zeros((6, 6)), K, unit(6, 2), unit(6, 2))
    held = np.delete(np.delete(K / np.sqrt(np.outer(m, m)), 2, 0), 2, 1)
    assert [one.Omega for one in antiresonances(system)] == pytest.approx(np.sqrt(np.linalg.eigvalsh(held)), rel=1e-12)
    assert all(one.value == 0.0 for one in antiresonances(system))
    between = [one.Omega for one in peaks(system)]
    assert all(low < one.Omega < high for low, one, high in zip(between, antiresonances(system), between[1:],
                                                                 strict=False))
    assert not antiresonances(TransferFunction(np.diag(m), np.zeros((6, 6)), K, unit(6, 0), unit(6, 5)))


@pytest.mark.sweep
@pytest.mark.parametrize("n", [6, 30])
def test_a_chain_driven_at_its_end_has_no_antiresonance_at_the_other(n):
    """Its numerator is a constant without damping, with dampers beside the springs a product of real zeros."""
    for weak in (0.0, 0.02):
        system = TransferFunction(np.eye(n), chain(np.full(n, weak)), chain(np.linspace(90, 110, n)), unit(n, 0),
                          unit(n, n - 1))
        assert not antiresonances(system)
        assert len(peaks(system)) == n


@pytest.mark.sweep
@pytest.mark.parametrize("order", [0, 1, 2])
def test_a_pole_without_damping_has_no_bound_however_narrow(order):
    for step in range(24):
        tie = 10 ** (-step / 6)
        K = np.array([[300.0 + tie, -tie], [-tie, 7000.0 + tie]])
        system = TransferFunction(np.diag([2.0, 13.0]), np.zeros((2, 2)), K, unit(2, 0), unit(2, 0), order=order)
        assert [one.value for one in extremes(system) if one.maximum] == [None, None], step
        assert [one.value for one in peaks(system)] == [None, None]


def test_a_damped_antiresonance_is_a_minimum():
    system = TransferFunction(np.diag([20.0, 2.0]), chain([1.0, 3.0]), chain([8000.0, 1250.0]), unit(2, 0), unit(2, 0))
    (dip,) = antiresonances(system)
    values = np.abs(frf(system, dip.Omega * np.array([1 - 1e-4, 1, 1 + 1e-4])))
    assert values[1] == dip.value and values[1] < min(values[0], values[2])


@pytest.mark.parametrize("log", [True, False])
@pytest.mark.parametrize("kind", ["undamped", "damped", "proportional"])
def test_the_grid_sees_every_peak(kind, log):
    rng = np.random.default_rng(2)
    for n in (1, 2, 6):
        system = random_system(rng, n, kind)
        system = TransferFunction(system.M, system.C, system.K, system.b, unit(n, 0))
        known = extremes(system)
        top = max((one.Omega for one in known), default=100.0)
        Omega, values = adaptive(system, top / 1e4, 2 * top, log)
        assert np.isfinite(values).all() and (np.diff(Omega) > 0).all() and len(Omega) < 500 * n
        for one in known:
            if one.value:
                near = np.abs(Omega / one.Omega - 1).argmin()
                assert abs(abs(values[near]) - one.value) <= 1e-6 * one.value
        x = np.log(Omega) if log else Omega
        middle = (x[1:] + x[:-1]) / 2
        at = np.exp(middle) if log else middle
        exactly, missing = np.abs(sampled(system, at)[0]), (np.abs(values[1:]) * np.abs(values[:-1])) ** 0.5
        far = np.all([np.abs(at / one.Omega - 1) > 1e-3 for one in known if not one.value] or [at > 0], axis=0)
        assert np.abs(np.log(exactly / missing))[far].max() < 0.15


@pytest.mark.parametrize(("log", "low", "high"), [(True, 2.0, 50.0), (False, 2.0, 18.0)])
def test_the_grid_comes_close_to_a_pole_in_its_middle(log, low, high):
    system = TransferFunction(np.eye(1), np.zeros((1, 1)), 100.0 * np.eye(1), unit(1, 0), unit(1, 0))
    Omega, values = adaptive(system, low, high, log)
    below, above = Omega[Omega < 10.0], Omega[Omega > 10.0]
    assert 10.0 not in Omega and above[0] - below[-1] < 0.01 and np.abs(values).max() > 1e3 * np.abs(values[0])


def test_slopes_of_derivatives():
    for order in (0, 1, 2):
        system = oscillator(0.2, order=order)
        values, slopes, _ = sloped(system, np.array([7.0]))
        ends = frf(system, np.array([7.0 + 1e-6, 7.0 - 1e-6]))
        assert slopes[0] == pytest.approx((ends[0] - ends[1]) / 2e-6j, rel=1e-8)
        assert values[0] == frf(system, 7.0)


# published cases

ABSORBER = """
    parameters: {m1: 20 kg, m2: 2 kg, k1: 8000 N/m, k2: %s, c: %s, F0: 50 N}
    bodies: {machine: {mass: m1, slide: x1}, absorber: {mass: m2, slide: x2}}
    springs: {mount: {k: k1, between: [ground, machine]}, tuned: {k: k2, between: [machine, absorber]}}
    dampers: {d: {c: c, between: [machine, absorber]}}
    forces: {drive: {at: machine, force: F0*sin(25 rad/s*t)}}
"""


def test_tuned_absorber():
    """k₂ = m₂Ω² brings the machine to rest, and the absorber moves by −F₀/k₂ (Den Hartog 1956, §3.2)."""
    scene = problem(ABSORBER % ("m2*(25 rad/s)^2", "0 N*s/m"))
    at = transfer(scene.configuration, "x1", "drive")
    assert abs(frf(at, 25.0)) <= 1e-18
    assert frf(transfer(scene.configuration, "x2", "drive"), 25.0) == pytest.approx(-1 / 1250)
    (dip,) = antiresonances(at)
    assert dip.Omega == pytest.approx(25.0, rel=1e-15) and dip.value == 0.0
    assert abs(frf(transfer(scene.configuration, "ground.force", "drive"), 25.0)) <= 1e-14


def test_optimum_absorber():
    """Den Hartog 1956, §3.3: tuned to f = 1/(1 + μ) the fixed points are equally high, √(1 + 2/μ) static deflections,
    at g² = (1 ± √(μ/(2 + μ)))/(1 + μ); with ζ² = 3μ/(8(1 + μ)), c = 2ζm₂ω₁ (for f, ζ referred to ω₁), both peaks are
    nearly there."""
    mu, omega = 0.1, 20.0
    k2 = 2 * (omega / (1 + mu)) ** 2
    free, one = (transfer(problem(ABSORBER % (f"{k2!r} N/m", f"{c} N*s/m")).configuration, "x1", "drive")
                 for c in (0, 1))
    points = fixed_points(free, one)
    ratio = math.sqrt(mu / (2 + mu))
    assert [point.Omega / omega for point in points] == pytest.approx([math.sqrt((1 - ratio) / (1 + mu)),
                                                                       math.sqrt((1 + ratio) / (1 + mu))], rel=1e-12)
    height = math.sqrt(1 + 2 / mu) / 8000
    assert [point.value for point in points] == pytest.approx([height, height], rel=1e-11)
    c = 2 * math.sqrt(3 * mu / (8 * (1 + mu) ** 3)) * 2 * omega
    damped = transfer(problem(ABSORBER % (f"{k2!r} N/m", f"{c!r} N*s/m")).configuration, "x1", "drive")
    found = peaks(damped)
    assert [peak.value for peak in found] == pytest.approx([height, height], rel=0.01)
    assert all(peak.value >= height * (1 - 1e-12) for peak in found)
    for c in (0.5, 30.0, 900.0):
        other = transfer(problem(ABSORBER % (f"{k2!r} N/m", f"{c!r} N*s/m")).configuration, "x1", "drive")
        assert np.abs(frf(other, np.array([point.Omega for point in points]))) == pytest.approx(height, rel=1e-9)


ISOLATED = """
    parameters: {m: 4 kg, k: 900 N/m, c: %s, Y: 1 cm}
    bodies: {base: {slide: Y*sin(4 rad/s*t)}, block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [base, block]}}
    dampers: {d: {c: c, between: [base, block]}}
    forces: {drive: {at: block, force: 5 N}}
"""


def test_transmissibility_crosses_one_at_root_two():
    """T = √((1 + (2ζr)²)/((1 − r²)² + (2ζr)²)) of displacement and of force; 1 at r = √2 for all ζ (Rao 2018, §3.6)."""
    for c in (5.0, 40.0):
        scene, zeta, r = problem(ISOLATED % f"{c} N*s/m"), c / (2 * 4 * 15.0), np.array([0.3, 1.0, math.sqrt(2), 4.0])
        wanted = np.sqrt((1 + (2 * zeta * r) ** 2) / ((1 - r**2) ** 2 + (2 * zeta * r) ** 2))
        for output, driven_by in (("x", "base"), ("ground.force", "drive")):
            found = frf(transfer(scene.configuration, output, driven_by), 15 * r)
            assert np.abs(found) == pytest.approx(wanted, rel=1e-13)
        assert wanted[2] == pytest.approx(1.0)
    free, one = (transfer(problem(ISOLATED % f"{c} N*s/m").configuration, "x", "base") for c in (0, 1))
    (point,) = fixed_points(free, one)
    assert (point.Omega, point.value) == pytest.approx((15 * math.sqrt(2), 1.0), rel=1e-12)


def test_no_fixed_point_where_something_else_damps():
    system = [TransferFunction(np.diag([20.0, 2.0]), chain([9.0, c]), chain([8000.0, 600.0]), unit(2, 0), unit(2, 0))
              for c in (0.0, 1.0)]
    assert fixed_points(*system) == []


# in letters

ONE = """
    parameters: {m: , k: , c: , Y: , Omega: , me: }
    bodies: {base: {slide: Y*sin(Omega*t)}, block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [base, block]}}
    dampers: {d: {c: c, between: [base, block]}}
    forces: {motor: {at: block, unbalance: me, speed: Omega}}
"""
TWO = """
    parameters: {m1: , m2: , k1: , k2: , c: , F0: , Omega: }
    bodies: {machine: {mass: m1, slide: x1}, absorber: {mass: m2, slide: x2}}
    springs: {mount: {k: k1, between: [ground, machine]}, tuned: {k: k2, between: [machine, absorber]}}
    dampers: {d: {c: c, between: [machine, absorber]}}
    forces: {drive: {at: machine, force: F0*sin(Omega*t)}}
"""
NUMBERS = {"m": 2.0, "k": 300.0, "c": 7.0, "Y": 0.1, "me": 0.3, "m1": 5.0, "m2": 1.5, "k1": 900.0, "k2": 250.0,
           "F0": 3.0}


@pytest.mark.parametrize(("scene", "signal", "driven_by", "order"), [
    (ONE, "x", "base", 0), (ONE, "s.stretch", "base", 0), (ONE, "x", "motor", 0), (ONE, "s.force", "motor", 0),
    (ONE, "x''", "base", 0), (ONE, "x", "x", 1), (TWO, "x1", "drive", 0), (TWO, "x2", "drive", 0),
    (TWO, "tuned.stretch", "drive", 0), (TWO, "x1", "x2", 2), (TWO.replace("dampers", "# dampers").replace(
        " c: ,", ""), "x1", "drive", 0), (TWO.replace("dampers", "# dampers").replace(" c: ,", ""), "x2", "drive", 2)])
def test_formulas_have_the_values_of_the_response(scene, signal, driven_by, order):
    lettered = problem(scene)
    given = {name: value for name, value in NUMBERS.items() if name in lettered.spec.parameters}
    for Omega in (3.0, 13.0, 61.0):
        numeric = lettered.with_values({name: Fraction(x) for name, x in {**given, "Omega": Omega}.items()})
        value = frf(transfer(numeric.configuration, signal, driven_by, order), Omega)
        found = formula(lettered.symbolic, signal, driven_by, order=order)
        amplitude, tangent = evaluate([found.amplitude, found.tangent], Floats, {**given, "Omega": Omega})
        assert abs(amplitude) == pytest.approx(abs(value), rel=1e-12)
        undifferentiated = value / (1j * Omega) ** order
        assert tangent == pytest.approx(-undifferentiated.imag / undifferentiated.real, rel=1e-11, abs=1e-14)


def test_formula_of_the_absorber():
    found = formula(problem(TWO.replace("dampers", "# dampers").replace(" c: ,", "")).symbolic, "x1", "drive")
    given = NUMBERS | {"Omega": 9.0}
    assert evaluate([found.zeros], Floats, given)[0] == pytest.approx(math.sqrt(250 / 1.5))
    assert found.undamped and found.poles is None
    assert formula(problem(ONE).symbolic, "x", "motor").zeros is None


def test_three_degrees_have_no_formula():
    scene = problem("""
        parameters: {m: , k: }
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
        springs: {s: {k: k, between: [ground, a]}, t: {k: k, between: [a, b]}, u: {k: k, between: [b, c]}}
    """)
    with pytest.raises(NotInLetters):
        formula(scene.symbolic, "x", "y")


@pytest.mark.parametrize("damper", ["", "dampers: {d: {c: 3 N*s/m, between: [ground, a]}}"])
@pytest.mark.parametrize("order", ["a, b", "b, a"])
def test_what_is_not_coupled_plays_no_part(damper, order):
    """An oscillator beside the one that is driven: neither a zero nor a pole of its response, which itself has none."""
    bodies = {"a": "a: {mass: m, slide: x}", "b": "b: {mass: m, slide: y}"}
    scene = """
parameters: {m: 2 kg, k: 800 N/m}
bodies: {BODIES}
springs: {s: {k: k, between: [ground, a]}SECOND}
forces: {f: {at: a, force: (3 N)*sin(5 rad/s*t)}}
""" + damper
    alone = problem(scene.replace("BODIES", bodies["a"]).replace("SECOND", ""))
    both = problem(scene.replace("BODIES", ", ".join(bodies[name] for name in order.split(", ")))
                   .replace("SECOND", ", s2: {k: 2*k, between: [ground, b]}"))
    one, two = (formula(found.symbolic, "x", "f") for found in (alone, both))
    assert str(one.amplitude) == str(two.amplitude)
    assert [str(place) for place in (two.poles, two.zeros)] == [str(place) for place in (one.poles, one.zeros)]
    nothing, curve = formula(both.symbolic, "y", "f"), both.frequency_response("y", "f")
    assert nothing.vanishes and nothing.poles is None and nothing.zeros is None and nothing.peak is None
    assert curve.peaks == [] and curve.antiresonances == []
    peaks_of = [np.ravel(found.frequency_response("x", "f").peaks) for found in (alone, both)]
    assert peaks_of[0] == pytest.approx(peaks_of[1], rel=1e-13)


def test_poles_that_are_all_real_are_none_of_the_axis():
    """K − Ω²M of an equilibrium that tips over, without damping."""
    system = TransferFunction([[2.0]], [[0.0]], [[-8.0]], unit(1, 0), unit(1, 0))
    assert [len(part) for part in system.endless()] == [0, 0] and not peaks(system)


@pytest.mark.parametrize("angle", [0.0, 0.5])
def test_modes_of_one_frequency_are_one_resonance_and_no_antiresonance_there(angle):
    """Two equal oscillators apart, and their axes turned; four in a ring, where the modes of one frequency that reach
    a neighbour cancel there: H = (1/(ω₁² − Ω²) + 2 q/(ω₂² − Ω²) ± 1/(ω₃² − Ω²))/4, q = 1, 0, −1."""
    turned = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    K = turned @ np.diag([100.0, 100.0]) @ turned.T
    apart = TransferFunction(np.eye(2), np.zeros((2, 2)), K, unit(2, 0), unit(2, 0))
    assert [one.Omega for one in peaks(apart)] == pytest.approx([10.0], rel=1e-14) and antiresonances(apart) == []
    ring = 230.0 * np.eye(4) - 100.0 * (np.roll(np.eye(4), 1, 0) + np.roll(np.eye(4), -1, 0))
    found = [TransferFunction(1.3 * np.eye(4), np.zeros((4, 4)), ring, unit(4, 0), unit(4, i)) for i in range(3)]
    omega = np.sqrt(np.array([30.0, 230.0, 430.0]) / 1.3)
    for one, reached in zip(found, ([0, 1, 2], [0, 2], [0, 1, 2]), strict=True):
        assert [top.Omega for top in peaks(one)] == pytest.approx(omega[reached].tolist(), rel=1e-14)
    dips = np.sqrt((230.0 + np.sqrt(2) * np.array([-100.0, 100.0])) / 1.3)
    assert [dip.Omega for dip in antiresonances(found[0])] == pytest.approx(dips.tolist(), rel=1e-14)
    assert antiresonances(found[1]) == [] == antiresonances(found[2])


@pytest.mark.sweep
def test_an_antiresonance_may_have_the_frequency_of_a_mode_that_takes_no_part():
    """A machine with two equal absorbers, which also swing against each other as it rests; a string driven in the
    middle, where its second mode rests."""
    twins = problem("""
        parameters: {M: 10 kg, m: 1 kg, K: 4 kN/m, k: 300 N/m}
        bodies: {a: {mass: M, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
        springs: {s: {k: K, between: [ground, a]}, r: {k: k, between: [a, b]}, t: {k: k, between: [a, c]}}
    """)
    curve = twins.frequency_response("x", "x")
    ends = np.roots([10.0, -(4000.0 + 600.0 + 3000.0), 4000.0 * 300.0]) ** 0.5    # (K + 2k − Mω²)(k − mω²) = 2k²
    assert [Omega for Omega, _ in curve.peaks] == pytest.approx(sorted(ends), rel=1e-13)
    assert len(curve.dips) == 1 and abs(curve.dips[0][0] - math.sqrt(300.0)) <= curve.dips[0][1] < 1e-10
    string = problem("""
        parameters: {L: 1 m, N: 100 N, mu: 10 g/m}
        strings: {p: {length: L, preload: N, mass_per_length: mu, left: pinned, right: pinned}}
        points: {mid: {body: p, at: L/2}}
        forces: {f: {at: mid, force: 1 N}}
    """)
    curve = string.frequency_response("p.u(L/2)", "f")
    assert abs(curve.dips[0][0] - 200 * math.pi) <= curve.dips[0][1] < 1e-9
    assert [Omega for Omega, _ in curve.peaks][:2] == pytest.approx([100 * math.pi, 300 * math.pi], rel=1e-13)


@pytest.mark.parametrize("damper", ["", "dampers: {d: {c: 0.7, between: [a, b]}}"])
def test_what_nothing_holds_under_a_steady_force(damper):
    """1 N on 2 kg of 8 kg: all of it accelerates by 1/8, the springs carry what lies behind them."""
    free = problem(f"""
bodies: {{a: {{mass: 2, slide: x}}, b: {{mass: 1, slide: y}}, e: {{mass: 5, slide: z}}}}
springs: {{s: {{k: 8, between: [a, b]}}, t: {{k: 3, between: [b, e]}}}}
{damper}
""")
    for signal, exact in (("x''", 1 / 8), ("s.stretch", -6 / 64), ("t.force", -5 / 8)):
        (value, error), = free.frequency_response(signal, "x").at_each(np.zeros(1))
        assert abs(value - exact) <= error * abs(exact) < 1e-12
    assert all(np.isnan(free.frequency_response(signal, "x").values(np.zeros(1))[0]) for signal in ("x", "x'"))
