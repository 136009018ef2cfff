"""Poles and zeros of a TransferFunction in floats: eigenvalues of K + sC + s²M, and of the same bordered by b, c and d,

    [ K + sC + s²M   −b(s) ]
    [ c(s)ᵀ           d(s) ].

With s = σ(1 + 1/μ) about a point σ to the right of all poles the leading matrix is regular, masses or none, and what is
at infinity goes to μ = 0. They are starting values: what is told of H is located on H itself.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.ascending import ascending
from vibcli.numerics.fixed_point import count_floats

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.transfer_function import TransferFunction

FAR = 1e-7      # |μ| of what counts as infinite
STEPS, NEAR, STILL = 6, 0.03, 1e-6
SETTLED = 1e-10     # relative: a step of Newton's method after which the next one is lost in rounding
ASIDE = 1e-3
ALIKE = 1e-11   # relative: frequencies that are one but for rounding
APART = 1e-5    # how far from a pole of several modes what they make together is looked at
LONG = 12       # coordinates from which on their structure is looked at
BESIDE = 1e-9   # where Newton's method for a pole starts that rounding hides at its own place


def poles(system: Any) -> np.ndarray:
    """The poles with Im s ≥ 0."""
    if system.n >= LONG:
        from vibcli.analyses.frequency_response.modes_of_matrices import decoupled, reduced_to_unit_mass

        alone = decoupled(system, reduced_to_unit_mass(system))
        if alone is not None:
            result: np.ndarray = _of_modes(*alone[:2])
            return result
        from vibcli.analyses.frequency_response.poles_in_a_row import poles_in_a_row

        found = poles_in_a_row(system)
        if found is not None:
            return found
    return _roots([system.K, system.C, system.M], pace(system))


def _of_modes(squares: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """The s of s² + 2ζω s + ω² with Im s ≥ 0."""
    root = np.sqrt(rates**2 / 4 - squares + 0j)
    far = -rates / 2 - np.where(rates < 0, -1, 1) * np.where(root.imag == 0, root, 0)
    with np.errstate(all="ignore"):
        near = np.where(far == 0, 0, squares / far)
    return np.concatenate([(root - rates / 2)[root.imag > 0], far[root.imag == 0], near[root.imag == 0]])


def zeros(system: Any) -> np.ndarray:
    """The zeros with Im s ≥ 0."""
    cut = _cut_chain(system)
    if cut is not None:
        return _zeros_of_all(system, np.concatenate([np.zeros(0), *(_of_block(system, parts) for parts in cut)]))
    parts = [np.block([[matrix, -b[:, None]], [c[None, :], np.atleast_2d(d)]]) for matrix, b, c, d in
             zip((system.K, system.C, system.M), system.b, system.c, system.d, strict=True)]
    if np.iscomplexobj(parts[0]) and not any(part.imag.any() for part in parts):
        parts = [part.real for part in parts]
    if system.undamped:
        return _zeros_of_all(system, np.sqrt(-_squares(parts[0].real, parts[2].real, pace(system))) * 1j)
    return _zeros_of_all(system, _roots(parts, pace(system)))


def _cut_chain(system: "TransferFunction") -> list[tuple[np.ndarray, ...]] | None:
    """[(K, C, M)] of what is left of coordinates in a row on either side of the way from the input to the output, and
    of the couplings on the way, whose poles are the zeros: H = det D_left · ∏ couplings · det D_right/det D. None of
    other systems; bordered as above, what lies on a long way would drown the others."""
    if system.n < LONG:
        return None
    from vibcli.analyses.frequency_response.coordinates_in_a_row import in_a_row

    ends, parts = in_a_row(system), (system.K, system.C, system.M)
    if ends is None:
        return None
    couples = sum(np.abs(part) for part in parts)
    low, high = sorted(ends)
    if not np.diagonal(couples, 1)[low:high].all() or not np.diagonal(couples, -1)[low:high].all():
        return None
    sides = [tuple(part[side, side] for part in parts) for side in (slice(0, low), slice(high + 1, None))]
    way = dict.fromkeys(tuple(part[i, i + 1] for part in parts) for i in range(low, high))
    blocks = [*sides, *(tuple(np.array([[entry]]) for entry in coupling) for coupling in way if any(coupling[1:]))]
    return [block for block in blocks if len(block[0])]


def _of_block(system: Any, parts: tuple[np.ndarray, ...]) -> np.ndarray:
    """The s with Im s ≥ 0 at which a block is singular."""
    K, C, M = parts
    if system.undamped:
        found: np.ndarray = np.sqrt(-_squares(K, M, pace(system))) * 1j
        return found
    return _roots([K, C, M], pace(system))


def endless(system: Any) -> list[np.ndarray]:
    """(poles, zeros) of H on the axis, without damping: Ω > 0 of the modes that take part, to rounding."""
    marks, dips = system.poles(), system.zeros()
    marks = _kept(system, marks[~_near(marks, dips)], 1)
    several = _near(marks, marks, 2)
    if several.any():
        marks = marks[~several | (_order(system, marks) < -0.5)]
    found = [ascending(places.imag[places.imag > 0]) for places in (marks, dips)]
    return [Omega[np.diff(Omega, prepend=0.0) > ALIKE * Omega] for Omega in found]


def _near(places: np.ndarray, others: np.ndarray, count: int = 1) -> np.ndarray:
    """Which have so many others at the same place but for rounding?"""
    found: np.ndarray = (np.abs(places[:, None] - others) <= ALIKE * np.abs(places)[:, None]).sum(axis=1) >= count
    return found


def _order(system: Any, at: np.ndarray) -> np.ndarray:
    """H′ (s − p)/H at some way from each place p: −1 of a pole, 1 of a zero, whatever modes of one frequency make of
    them together there."""
    off = at * APART
    values, slopes, _ = system.at(at + off, True)
    with np.errstate(all="ignore"):
        found: np.ndarray = (slopes * off / values).real
        return found


def _zeros_of_all(system: "TransferFunction", places: np.ndarray) -> np.ndarray:
    """Those that are zeros of H; where modes have the same frequency, by H beside it."""
    shared = _near(places, system.poles())
    found = np.concatenate([_kept(system, places[~shared]), places[shared]])
    doubtful = _near(found, system.poles())
    if doubtful.any():
        doubtful[doubtful] = ~(_order(system, found[doubtful]) > 0.5)
    result: np.ndarray = found[~doubtful]
    return result


def _kept(system: "TransferFunction", places: np.ndarray, sign: int = -1) -> np.ndarray:
    """Those to which Newton's method on H converges, or with `sign` 1 that on 1/H: rounding scatters zeros at infinity
    anywhere, and a mode that takes no part is no pole of H."""
    at, step, near = places.astype(complex), np.full(len(places), np.inf + 0j), np.arange(len(places))
    if sign == 1 and len(places):
        at = np.where(system.at(at)[2], at, at * (1 + BESIDE))
    for _ in range(STEPS):
        if not len(near):
            break
        values, slopes, resonant = system.at(at[near], True)
        with np.errstate(all="ignore"):
            moved = np.where((values == 0) | resonant, 0.0, sign * values / slopes)
        step[near] = np.where(np.isfinite(moved), moved, np.inf)
        step[near[(values == 0) & ~resonant & _vanishes(system, at[near], values)]] = np.inf
        near = near[np.abs(step[near]) <= NEAR * np.abs(at[near])]      # where the others are they stay
        at[near] += step[near]
        near = near[np.abs(step[near]) > SETTLED * np.abs(at[near])]
    found: np.ndarray = at[(np.abs(step) <= STILL * np.abs(at)) & (np.abs(at - places) <= NEAR * np.abs(places))]
    return found


def _vanishes(system: "TransferFunction", at: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Is H, where its value is 0, 0 beside it too: is it so small that floats do not hold it?"""
    found = np.zeros(len(at), bool)
    if (values == 0).any():
        found[values == 0] = system.at(at[values == 0] * (1 + ASIDE))[0] == 0
    return found


def pace(system: Any) -> float:
    """A frequency between the lowest and the highest: the geometric mean of √(Kᵢᵢ/Mᵢᵢ), of Kᵢᵢ/Cᵢᵢ without inertia."""
    K, M, C = (np.abs(np.diag(matrix)) for matrix in (system.K, system.M, system.C))
    both, slow = (K > 0) & (M > 0), (K > 0) & (C > 0) & (M == 0)
    rates = [*np.sqrt(K[both] / M[both]), *(K[slow] / C[slow])]
    return float(np.exp(np.mean(np.log(rates)))) if rates else 1.0


def _roots(parts: Sequence[np.ndarray], pace: float) -> np.ndarray:
    """s with Im s ≥ 0 of A₀ + s A₁ + s² A₂."""
    A0, A1, A2 = _balanced([part * pace**k for k, part in enumerate(parts)])
    n, shift = len(A0), 1.0
    at, steep = A0 + shift * (A1 + shift * A2), A1 + 2 * shift * A2
    try:
        lower = np.linalg.solve(at, np.hstack([steep, A2]))
    except np.linalg.LinAlgError:
        return np.zeros(0, complex)
    if not np.isfinite(lower).all():
        return np.zeros(0, complex)
    companion = np.vstack([-lower, np.eye(n, 2 * n)])
    count_floats(2 * n)
    inverse = np.linalg.eigvals(companion)
    inverse = inverse[np.abs(inverse) > FAR]
    found = pace * (shift + 1 / inverse)
    return found[found.imag >= 0]


def _squares(A0: np.ndarray, A2: np.ndarray, pace: float) -> np.ndarray:
    """s² of A₀ + s² A₂ where it is real and negative."""
    A0, A2 = _balanced([A0, A2 * pace**2])
    try:
        inverse = np.linalg.eigvals(np.linalg.solve(A0 + A2, -A2))
    except np.linalg.LinAlgError:
        return np.zeros(0)
    inverse = inverse[(np.abs(inverse) > FAR) & (np.abs(inverse.imag) <= 1e-3 * np.abs(inverse))].real
    found = pace**2 * (1 + 1 / inverse)
    return found[found < 0]


def _balanced(parts: list[np.ndarray]) -> list[np.ndarray]:
    """The same with rows and columns of one size."""
    parts = [part.copy() for part in parts]
    for _ in range(3):
        for axis in (0, 1):
            size = sum(np.abs(part) for part in parts).max(axis=1 - axis)
            factor = np.where(size > 0, np.exp2(-np.round(np.log2(np.where(size > 0, size, 1.0)))), 1.0)
            factor = factor[:, None] if axis == 0 else factor[None, :]
            parts = [part * factor for part in parts]
    return parts
