"""Frequency responses of long chains of masses, springs and dampers, whose far ends hardly feel each other."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.frequency_response.direct import direct
from vibcli.analyses.frequency_response.extremes import extremes
from vibcli.analyses.frequency_response.large_systems import Banded, _ordered, chosen
from vibcli.analyses.frequency_response.modal_solution import modal_solution
from vibcli.analyses.frequency_response.peaks import antiresonances, peaks
from vibcli.analyses.frequency_response.transfer_function import TransferFunction
from vibcli.analyses.frequency_response.value_errors import of_values
from vibcli.analyses.transient.data_errors import of_matrices


def chain(n, c, output=0, driven=-1):
    """Unit masses, springs of 100 and dampers c one after another from the ground on, driven at the end."""
    row = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    row[-1, -1] = 1.0
    b, seen = np.zeros((3, n)), np.zeros((3, n))
    b[0, driven] = seen[0, output] = 1.0
    return TransferFunction(np.eye(n), c * row, 100 * row, b, seen)


def frequencies(n):
    """ω = 2√(k/m) sin((2j − 1)π/(4n + 2))."""
    return 20 * np.sin((2 * np.arange(1, n + 1) - 1) * np.pi / (4 * n + 2))


@pytest.mark.parametrize("c", [1e-3, 1e-9])
def test_every_peak_of_a_chain_with_weak_dampers(c):
    """However fast the springs would creep against the dampers alone, peaks are where the masses are."""
    assert [one.Omega for one in peaks(chain(40, c))] == pytest.approx(frequencies(40), rel=1e-4)


@pytest.mark.sweep
@pytest.mark.parametrize(("output", "driven"), [(42, 119), (119, 42), (60, 60)])
def test_every_antiresonance_of_what_is_cut_off(output, driven):
    """H vanishes where what is left of the way from the input to the output vibrates by itself: j masses between two
    walls have ω = 2√(k/m) sin(iπ/(2j + 2)); what is right of it is free at its end."""
    n, (low, high) = 120, sorted((output, driven))
    walls = 20 * np.sin(np.arange(1, low + 1) * np.pi / (2 * low + 2))
    exact = np.sort(np.concatenate([walls, frequencies(n - 1 - high)]))
    found = [one.Omega for one in antiresonances(chain(n, 1e-6, output, driven))]
    assert found == pytest.approx(exact, rel=1e-6)


@pytest.mark.sweep
def test_what_floats_do_not_hold_is_no_antiresonance():
    """From end to end H = (k + sc)ⁿ⁻¹/det has no zero but far on the left; right of its poles it falls below the least
    float."""
    assert antiresonances(chain(400, 0.02)) == []


def test_what_the_input_does_not_reach_has_no_peaks():
    apart = chain(6, 0.1)
    for matrix in (apart.K, apart.C):
        matrix[2, 3] = matrix[3, 2] = 0.0
    assert extremes(apart) == []


@pytest.mark.sweep
def test_zeros_of_a_long_chain_are_sought_amid_its_frequencies():
    """Far above them H is no float any more, and the eigenvalue problem for zeros none."""
    assert len(peaks(chain(200, 0.0632, output=63))) > 90


def exact(system, Omega):
    """H in 400 digits of a chain of unit masses, by elimination from the ground on."""
    with mpmath.workdps(400):
        s = mpmath.mpc(0, float(Omega))
        beside = s * mpmath.mpf(float(system.C[0, 1])) + mpmath.mpf(float(system.K[0, 1]))
        pivots = []
        for i in range(system.n):
            at = s**2 * system.M[i, i] + s * mpmath.mpf(float(system.C[i, i])) + mpmath.mpf(float(system.K[i, i]))
            pivots.append(at - (beside**2 / pivots[-1] if i else 0))
        found = mpmath.mpf(1)
        for pivot in pivots:
            found /= pivot
        return complex(found * (-beside)**(system.n - 1))


@pytest.mark.parametrize("kind", ["in proportion", "others"])
def test_ends_of_a_chain_that_hardly_feel_each_other(kind):
    """Above the natural frequencies H falls by a power of the number of masses, below what a sum of modes holds."""
    system = chain(80, 0.2)
    if kind == "others":
        system.C[10, 10] += 0.3
    Omega = np.array([0.4, 3.0, 12.0, 19.9, 21.0, 25.0, 40.0])
    method = chosen(system)
    found, slopes, _ = method(system, 1j * np.tile(Omega, 20), True)
    step = 1e-6 * Omega
    difference = (direct(system, 1j * (Omega + step))[0] - direct(system, 1j * (Omega - step))[0]) / (2j * step)
    assert slopes[:len(Omega)] == pytest.approx(difference, rel=1e-5)
    if kind == "in proportion":
        wanted = np.array([exact(system, at) for at in Omega])
        assert (np.abs(found[:len(Omega)] - wanted) <= 1e-11 * np.abs(wanted)).all()
        assert np.abs(wanted[-1]) < 1e-40
    assert found[:len(Omega)] == pytest.approx(direct(system, 1j * Omega)[0], rel=1e-11)


def test_what_modes_lose_is_eliminated(monkeypatch):
    """Of frequencies below and above those of the chain the latter alone."""
    system, asked = chain(80, 0.2), []
    monkeypatch.setattr(Banded, "__call__", lambda self, system, s, steep=False: (
        asked.append(np.abs(s)), direct(system, s, steep))[1])
    method = modal_solution(system, Banded(system, *_ordered(system)))
    method(system, 1j * np.linspace(0.1, 15.0, 300))
    assert not asked
    method(system, 1j * np.array([3.0, 30.0, 50.0]))
    assert [part.tolist() for part in asked] == [[30.0, 50.0]]


@pytest.mark.parametrize("width", [1, 2])
def test_errors_by_elimination_are_those_of_each_matrix(width):
    rng, n = np.random.default_rng(width), 90
    row = np.where(np.abs(np.subtract.outer(range(n), range(n))) <= width, rng.uniform(-1, 1, (n, n)), 0.0)
    system = chain(n, 0.1)
    system.C[:] += 0.01 * (row - row.T)     # gyroscopic, so that D and its transpose differ
    data, Omega = of_matrices(system.M, system.C, system.K), np.linspace(0.3, 25.0, 40)
    wanted = of_values(system, data, Omega)
    system._method = Banded(system, *_ordered(system))
    assert of_values(system, data, Omega) == pytest.approx(wanted, rel=1e-6)
    assert (wanted > 0).all()
