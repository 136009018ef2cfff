"""Continued fractions of coordinates in a row, against 60 digits and against the other methods."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.frequency_response.coordinates_in_a_row import Row, in_a_row
from vibcli.analyses.frequency_response.direct import direct
from vibcli.analyses.frequency_response.poles_and_zeros import poles
from vibcli.analyses.frequency_response.transfer_function import TransferFunction
from vibcli.analyses.frequency_response.value_errors import of_values
from vibcli.analyses.transient.data_errors import of_matrices


def uneven(n, seed, driven, seen, kind):
    """A row whose couplings differ by six orders: springs and dampers, masses as well, or gyroscopic terms."""
    rng = np.random.default_rng(seed)
    beside = np.eye(n, k=1)
    K, C = (np.zeros((n, n)) for _ in range(2))
    for matrix, size in ((K, 1e3), (C, 0.1)):
        weights = size * 10**rng.uniform(-3, 3, n)
        rows = np.eye(n) - np.eye(n, k=-1)
        matrix += rows.T @ (weights[:, None] * rows)
    M = np.diag(10**rng.uniform(-2, 2, n))
    if kind == "masses":
        M += 0.1 * M.min() * (beside + beside.T)
    if kind == "gyroscopic":
        C += rng.uniform(-1, 1, n)[:, None] * beside
        C -= np.triu(C, 1).T - np.triu(C.T, 1).T
    b, c = np.zeros((2, 3, n))
    b[0, driven], c[0, seen] = 1.7, -0.3
    return TransferFunction(M, C, K, b, c)


def exact(system, Omega):
    """H = cᵀ x of D x = b, and dH/ds = cᵀ x′ of D x′ = −(C + 2sM) x, by one elimination with pivots."""
    with mpmath.workdps(60):
        s = mpmath.mpc(0, float(Omega))
        K, C, M = (mpmath.matrix(part.tolist()) for part in (system.K, system.C, system.M))
        factors, order = mpmath.mp.LU_decomp(K + s * C + s**2 * M)
        x, found = mpmath.matrix(system.b[0].tolist()), []
        for _ in range(2):
            x = mpmath.mp.U_solve(factors, mpmath.mp.L_solve(factors, x, order))
            found.append(mpmath.fsum(float(c) * x[i] for i, c in enumerate(system.c[0])))
            x = -(C + 2 * s * M) * x
        return found


@pytest.mark.sweep
@pytest.mark.parametrize("kind", ["dampers", "masses", "gyroscopic"])
@pytest.mark.parametrize(("driven", "seen"), [(0, 23), (23, 0), (9, 17), (21, 4), (13, 13)])
def test_values_and_slopes_lie_within_their_bounds(kind, driven, seen):
    system = uneven(24, driven + 31 * seen, driven, seen, kind)
    Omega = np.geomspace(0.3, 3e3, 4)
    row = system._method = Row(system, in_a_row(system), direct)
    values, slopes, resonant = row(system, 1j * Omega, True)
    assert row(system, 1j * Omega)[0] == pytest.approx(values, rel=1e-13)
    told = of_values(system, of_matrices(system.M, system.C, system.K), Omega)
    assert not resonant.any()
    for at, H, steep, bound in zip(Omega, values, slopes, told, strict=True):
        wanted, turned = exact(system, at)
        assert abs(H - complex(wanted)) <= bound < 1e-6 * abs(wanted)
        assert steep == pytest.approx(complex(turned), rel=1e-8)


def even(n, c=0.0):
    """Unit masses between springs of 1, and dampers in proportion; the last one is driven, the first one seen."""
    row = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    b, seen = np.zeros((2, 3, n))
    b[0, -1] = seen[0, 0] = 1.0
    return TransferFunction(np.eye(n), c * row, row, b, seen)


def test_where_a_pivot_is_zero_another_method_tells():
    """At Ω² = 2 every entry of the diagonal is zero; of an even number of masses H = (−1)^{n/2}, of an odd one there is
    a pole. Beside it H passes through floats of any size."""
    for n, wanted in ((40, 1.0), (42, -1.0)):
        system = even(n)
        found, _, resonant = Row(system, in_a_row(system), direct)(system, 1j * np.array([np.sqrt(2.0)]))
        assert found == pytest.approx([wanted], rel=1e-12)
        assert not resonant.any()
    system = even(41)
    assert Row(system, in_a_row(system), direct)(system, 1j * np.array([np.sqrt(2.0)]))[2].all()


def test_what_the_input_does_not_reach_is_zero():
    system = even(20, 0.1)
    for matrix in (system.K, system.C):
        matrix[7, 8] = matrix[8, 7] = 0.0
    values, slopes, resonant = Row(system, in_a_row(system), direct)(system, 1j * np.array([0.3, 1.0, 5.0]), True)
    assert not values.any() and not slopes.any() and not resonant.any()


def test_what_is_no_row():
    assert in_a_row(even(20)) == (19, 0)
    for spoil in (lambda one: one.K.__setitem__((0, 2), 1.0), lambda one: one.c.__setitem__((0, 5), 1.0),
                  lambda one: one.c.__setitem__((1, 0), 1.0)):
        system = even(20)
        spoil(system)
        assert in_a_row(system) is None


def test_poles_of_modes_that_damping_does_not_couple():
    """s² + c ω² s + ω² = 0 with ω = 2 sin(jπ/(2n + 2)); two real ones where c ω > 2."""
    n, c = 24, 1.3
    omega = 2 * np.sin(np.arange(1, n + 1) * np.pi / (2 * n + 2))
    exact = np.concatenate([np.roots([1, c * w**2, w**2]) for w in omega])
    found = np.sort_complex(poles(even(n, c)))
    assert found == pytest.approx(np.sort_complex(exact[exact.imag >= 0]), rel=1e-10)
