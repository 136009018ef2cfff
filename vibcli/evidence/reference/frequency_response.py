"""H(iΩ) = cᵀ (K + s C + s² M)⁻¹ b + d, s = iΩ, its peaks, minima and half-power points, to many digits by element data.

Extremes are looked for on a grid that is dense about each natural frequency, and refined where d|H|²/dΩ vanishes;
x = D⁻¹ b has the rates D x′ = b′ − D′ x and D x″ = b″ − 2 D′ x′ − D″ x.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, cast

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.results.precise_frequency_response import PreciseCurve

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

BESIDE, ALONG = 400, 4000       # samples about a natural frequency, and along all frequencies
FAR = 100.0                     # times the lowest and the highest of these
STEPS = 60
UNDAMPED, FINEST = 1e-14, 1e-10         # of a frequency: a decay that is none; the width of what has none
BY = 1e-3               # of a frequency: what is as near to it is meant


class Transfer(NamedTuple):
    """M, C, K and the parts of b, c, d by powers of s, in numbers of any kind: matrices of mpmath, or arrays."""

    M: Any
    C: Any
    K: Any
    b: Any
    c: Any
    d: Any


def transfer(problem: "Problem", signal: str, driver: str) -> Transfer:
    """Of a signal to a unit of an input, at the working precision."""
    if problem.configuration.linear_system.pieces:
        raise PhysicsError("no reference is found of frequency responses of members")
    curve = PreciseCurve(problem, signal, driver)
    return Transfer(curve.M, curve.C, curve.K, curve.b, curve.c, curve.d)


def in_floats(exact: Transfer) -> Transfer:
    """The same as arrays."""
    def array(x: mpmath.matrix) -> np.ndarray:
        found = np.array(x.tolist(), dtype=complex)
        return found if found.imag.any() else found.real

    return Transfer(*(array(part) for part in exact[:3]), *([array(part).ravel() for part in parts]
                                                           for parts in exact[3:5]),
                    array(mpmath.matrix(exact.d)).ravel().tolist())


def at(exact: Transfer, Omega: Any) -> list[Any]:
    """[H, dH/ds, d²H/ds²] at s = iΩ."""
    s = mpmath.mpc(0, Omega)
    M, C, K = exact[:3]
    D, slope = K + s * C + s * s * M, C + 2 * s * M
    b, c, d = ([part[0] + s * (part[1] + s * part[2]), part[1] + 2 * s * part[2], 2 * part[2]] for part in exact[3:])
    x = mpmath.lu_solve(D, b[0])
    y = mpmath.lu_solve(D, b[1] - slope * x)
    z = mpmath.lu_solve(D, b[2] - 2 * slope * y - 2 * M * x)
    return [_dot(c[0], x) + d[0], _dot(c[1], x) + _dot(c[0], y) + d[1],
            _dot(c[2], x) + 2 * _dot(c[1], y) + _dot(c[0], z) + d[2]]


def _dot(one: mpmath.matrix, two: mpmath.matrix) -> mpmath.mpc:
    return sum(x * y for x, y in zip(one, two, strict=True))


def value(problem: "Problem", signal: str, driver: str, Omega: Callable[[], Any]) -> TrueValues:
    """H at a frequency, which is evaluated at the working precision."""
    return settled(lambda: ([at(transfer(problem, signal, driver), Omega())[0]], None), DIGITS)


def peak(problem: "Problem", signal: str, driver: str, number: int, place: bool) -> TrueValues:
    """|H| at its peak of that number, or its Ω."""
    near = extremes(in_floats(transfer(problem, signal, driver)), 1)
    if number > len(near):
        raise PhysicsError(f"the reference finds {len(near)} peaks")

    def found() -> "tuple[list[mpmath.mpf], None]":
        exact = transfer(problem, signal, driver)
        Omega = _turn(exact, mpmath.mpf(near[number - 1]))
        return [Omega if place else abs(at(exact, Omega)[0])], None

    return settled(found, DIGITS)


def antiresonance(problem: "Problem", signal: str, driver: str, near: float) -> TrueValues:
    """Ω of the minimum of |H|, of a zero perhaps, next to a frequency; about: its number among all minima."""
    every = extremes(in_floats(transfer(problem, signal, driver)), -1)
    about = min(every, key=lambda Omega: abs(Omega - near), default=0.0)
    if abs(about - near) > BY * near:
        raise PhysicsError(f"the reference finds no minimum near {near:.6g} rad/s")
    true = settled(lambda: ([_turn(transfer(problem, signal, driver), mpmath.mpf(about))], None), DIGITS)
    return true._replace(about=every.index(about) + 1)


def half_power(problem: "Problem", signal: str, driver: str, number: int) -> TrueValues:
    """Ω below and above each peak, counted from 1, at which |H| is 1/√2 of it."""
    curve = in_floats(transfer(problem, signal, driver))
    tops = extremes(curve, 1)
    if (number + 1) // 2 > len(tops):
        raise PhysicsError(f"the reference finds {len(tops)} peaks")
    top = tops[(number - 1) // 2]
    near = fallen(np.abs(values(curve, grid(curve))), grid(curve), top, number % 2 == 1)

    def found() -> "tuple[list[mpmath.mpf], None]":
        exact = transfer(problem, signal, driver)
        level, Omega = abs(at(exact, _turn(exact, mpmath.mpf(top)))[0]) ** 2 / 2, mpmath.mpf(near)
        for _ in range(STEPS):
            H, first, _ = at(exact, Omega)
            step = (abs(H) ** 2 - level) / (2 * mpmath.im(mpmath.conj(H) * first))
            Omega += step
            if abs(step) <= mpmath.eps * 10**8 * Omega:
                return [Omega], None
        raise ValueError("no half-power point is found near by")

    return settled(found, DIGITS)


def fallen(size: np.ndarray, Omega: np.ndarray, top: float, below: bool) -> float:
    """Where samples of |H| pass 1/√2 of that at a peak first, on the straight line between two; RuntimeError where
    they do not."""
    k, step = int(np.searchsorted(Omega, top)), -1 if below else 1
    level = size[k] / np.sqrt(2)
    while size[k] > level:
        k += step
        if not 0 <= k < len(size):
            raise RuntimeError("it does not fall to 1/√2 of its peak on this grid")
    part = (level - size[k]) / (size[k - step] - size[k])
    return float(Omega[k] + part * (Omega[k - step] - Omega[k]))


def extremes(curve: Transfer, sense: int) -> list[float]:
    """The places of all maxima of |H| that the grid shows, or minima (sense −1)."""
    Omega = grid(curve)
    return cast("list[float]", Omega[tops(sense * np.abs(values(curve, Omega)))].tolist())


def tops(samples: np.ndarray) -> np.ndarray:
    """The indices of those that are the largest of three."""
    return np.flatnonzero((samples[1:-1] > samples[:-2]) & (samples[1:-1] >= samples[2:])) + 1


def grid(curve: Transfer) -> np.ndarray:
    """Frequencies that are dense about each natural one, by its decay, and not at those without."""
    poles = [x for x in np.linalg.eigvals(state_matrix(*curve[:3])) if x.imag > 0]
    if not poles:
        raise PhysicsError("the reference finds no peaks: nothing oscillates")
    sizes = np.abs(poles)
    near = np.concatenate([[0.0], np.geomspace(1e-3, 1e4, BESIDE)])
    beside = [x.imag + sign * (-x.real * near if -x.real > UNDAMPED * x.imag else FINEST * x.imag * near[1:])
              for x in poles for sign in (1, -1)]
    every = np.concatenate([*beside, np.geomspace(sizes.min() / FAR, sizes.max() * FAR, ALONG)])
    return np.unique(every[(every > 0) & (every < sizes.max() * FAR)])


def state_matrix(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """A of (q, q̇)' = A (q, q̇)."""
    return np.block([[np.zeros_like(M), np.eye(len(M))], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])


def values(curve: Transfer, Omega: np.ndarray) -> np.ndarray:
    """H at frequencies, by LU of each matrix."""
    s = 1j * Omega[:, None]
    b, c = (part[0] + s * (part[1] + s * part[2]) for part in (curve.b, curve.c))
    D = curve.K + s[:, :, None] * curve.C + s[:, :, None] ** 2 * curve.M
    x = np.linalg.solve(D, b[:, :, None])[:, :, 0]
    s = s[:, 0]
    return cast("np.ndarray", (c * x).sum(axis=1) + curve.d[0] + s * (curve.d[1] + s * curve.d[2]))


def _turn(exact: Transfer, Omega: mpmath.mpf) -> mpmath.mpf:
    """Where |H| has an extreme, by Newton's method: with H′ = dH/ds, d|H|²/dΩ = −2 Im(H̄ H′)."""
    for _ in range(STEPS):
        H, first, second = at(exact, Omega)
        slope = -mpmath.im(mpmath.conj(H) * first)
        bend = abs(first) ** 2 - mpmath.re(mpmath.conj(H) * second)
        step = -slope / bend
        Omega += step
        if abs(step) <= mpmath.eps * 10**8 * Omega:
            return Omega
    raise ValueError("no extreme is found near by")
