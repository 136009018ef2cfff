"""Damped modes of floats bettered by their residuals, against enclosures in integers and Newton's method in mpmath."""

import mpmath
import numpy as np
import pytest

from vibcli.analyses.modal.damped import EXACT, GOAL, WANTED, CertifiedEigenvalues, damped
from vibcli.analyses.modal.damped_large import damped_floats
from vibcli.analyses.modal.damped_modes import collected
from vibcli.analyses.modal.mode_numbers import NearestFloats
from vibcli.api.source import problem_of, text_source
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.numerics.symmetric_eigenvalues import radii
from vibcli.results.certificate import ROUNDING, certificate

KINDS = {"light": (-8, 0.3), "near critical": (0, 1), "heavy": (3, 1), "very heavy": (6, 2), "of all sizes": (0, 8)}


def chain(n, seed, stiff, heavy, centre, spread, free=0, loose=0):
    """Springs, masses and dampers in a row over so many powers of ten each, held at one end but for so many springs and
    dampers."""
    random = np.random.default_rng(seed)
    between = [{i: 1.0, **({i - 1: -1.0} if i else {})} for i in range(n)]
    springs, dampers = ([(10 ** random.uniform(*powers), row) for row in between]
                        for powers in ((0, stiff), (centre - spread, centre + spread)))
    return FactoredSystem(n, [(10 ** random.uniform(0, heavy), {i: 1.0}) for i in range(n)], springs[free:],
                          dampers=dampers[loose:])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("stiff", "heavy"), [(0, 0), (6, 0), (8, 8), (14, 0)])
def test_bounds_hold_and_none_is_found_twice(kind, stiff, heavy):
    found = _all_within_bounds(chain(14, 3, stiff, heavy, *KINDS[kind]))
    if stiff < 8:
        assert max(mode.error for mode in found) <= 5e-13


@pytest.mark.parametrize("kind", ["light", "near critical", "heavy"])
@pytest.mark.parametrize("loose", [0, 1])
@pytest.mark.parametrize("stiff", [0, 4])
def test_of_what_is_free_they_hold_too(kind, loose, stiff):
    found = _all_within_bounds(chain(14, 3, stiff, 0, *KINDS[kind], free=1, loose=loose))
    assert sum(not mode.eigenvalue for mode in found) == 1 + loose
    if kind != "light":
        assert max(mode.error for mode in found) <= 5e-13


def _all_within_bounds(elements):
    """The modes in floats, each next to another one of those in integers, no farther than its bound."""
    found = damped_floats(elements)
    enclosed = CertifiedEigenvalues(elements, elements, GOAL, WANTED, EXACT)
    exact = np.array([mode.eigenvalue for mode in collected(enclosed, NearestFloats, enclosed.shapes())])
    values = np.array([mode.eigenvalue for mode in found])
    off = abs(values[:, None] - exact[None, :])
    assert sorted(off[values != 0].argmin(axis=1).tolist()) == np.flatnonzero(exact).tolist()
    assert len(values) == len(exact)
    assert (off.min(axis=1) <= [(mode.error + 2**-52) * abs(mode.eigenvalue) for mode in found]).all()
    return found


@pytest.mark.sweep
def test_the_farthest_and_the_nearest_by_newtons_method():
    elements = chain(24, 5, 2, 2, 3, 1)
    found = damped_floats(elements)
    with mpmath.workdps(40):
        for mode in (found[0], found[-1], found[len(found) // 2]):
            off = abs(_by_newton(elements, mode) - mpmath.mpmathify(mode.eigenvalue))
            assert off <= mode.error * abs(mode.eigenvalue)
            assert mode.error <= 1e-12


def _by_newton(elements, mode):
    """λ of (λ²M + λC + K)x = 0, with one component of x fixed, from that of floats."""
    n = elements.n
    M, C, K = (mpmath.zeros(n) for _ in range(3))
    for matrix, terms in ((M, elements.inertias), (C, elements.dampers), (K, elements.springs)):
        for weight, row in terms:
            for i, x in row.items():
                for j, y in row.items():
                    matrix[i, j] += mpmath.mpf(weight) * mpmath.mpf(x) * mpmath.mpf(y)
    lead, rate = int(np.argmax(abs(mode.shape))), mpmath.mpmathify(mode.eigenvalue)
    x = mpmath.matrix([mpmath.mpmathify(complex(value / mode.shape[lead])) for value in mode.shape])
    for _ in range(4):
        whole, slope = rate**2 * M + rate * C + K, (2 * rate * M + C) * x
        system, right = whole.copy(), -(whole * x)
        for i in range(n):
            system[i, lead] = slope[i]
        step = mpmath.lu_solve(system, right)
        rate += step[lead]
        step[lead] = 0
        x += step
    return rate


@pytest.mark.sweep
def test_what_is_left_of_heavily_damped_modes_is_rounding():
    n = 84
    text = "bodies:\n" + "".join(f"  b{i}: {{mass: {1 + i % 3} kg, slide: x{i}}}\n" for i in range(1, n + 1))
    for group, key, size in (("springs", "k", "{} N/m"), ("dampers", "c", "{}e3 N*s/m")):
        text += f"{group}:\n" + "".join(
            f"  {key}{i}: {{{key}: {size.format(1 + i % 7)}, between: [{f'b{i - 1}' if i > 1 else 'ground'}, b{i}]}}\n"
            for i in range(1, n + 1))
    problem = problem_of(text_source(text))
    assert max(mode.error for mode in problem.modal.damped) <= 1e-9      # 1e-6 by floats alone, on any processor
    assert certificate(problem)["damped modes"] <= ROUNDING


@pytest.mark.sweep
def test_weak_damping_of_many_coordinates_is_known_to_its_own_digits():
    """A row of equal masses and springs, in which c at one mass damps mode i by c φ²/(2 ω φᵀφ) up to squares of c;
    floats know Re λ to the rounding of |λ| alone."""
    n, at, c = 41, 12, 1e-9
    elements = FactoredSystem(n, [(1.0, {i: 1.0}) for i in range(n)],
                              [(1.0, {i: 1.0, **({i - 1: -1.0} if i else {})}) for i in range(n)],
                              dampers=[(c, {at: 1.0})])
    assert max(mode.bounds[0] for mode in damped_floats(elements)) > 1e-6
    for i, mode in enumerate(damped(elements), 1):
        shape = np.sin((2 * i - 1) * np.pi / (2 * n + 1) * np.arange(1, n + 1))
        omega = 2 * np.sin((2 * i - 1) * np.pi / (4 * n + 2))
        assert mode.zeta == pytest.approx(c * shape[at] ** 2 / (2 * omega * (shape @ shape)), rel=1e-12)
        assert mode.bounds[0] < 1e-15


def test_discs_in_the_plane_that_overlap_are_one():
    values = np.array([0j, 1j, 1 + 0j, 9 + 0j])
    off = np.array([[0.1, 0.3, 0.3, 0], [0.3, 0.1, 0.3, 0], [0.3, 0.3, 0.1, 0], [0.1, 0, 0, 0.1]])
    reach = radii(values, abs(values[:, None] - values[None, :]), off)
    assert reach[:3] == pytest.approx([3.5] * 3) and 0.1 <= reach[3] <= 0.2
    random = np.random.default_rng(2)
    for _ in range(200):
        entries = off * random.uniform(-1, 1, off.shape)
        exact = np.linalg.eigvals(np.diag(values) + entries)
        assert (abs(exact[:, None] - values[None, :]).min(axis=0) <= reach).all()
