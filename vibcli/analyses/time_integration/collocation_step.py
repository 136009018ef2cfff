"""One window of a motion: the polynomials of q̈, q̇ and q from its start, and the iteration that finds them.

Picard's iteration A ← f(q(A), q̇(A)) contracts while a window spans few radians of the fastest oscillation. Of stiff
scenes, whose fast oscillations have died out or were never excited, windows span many: there Newton's method is used,
with the Jacobians of f at every point by differences.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.numerics.collocation_rule import Rule

MOST_PICARD, MOST_NEWTON, PATIENCE = 60, 12, 15
DIFFERENCE, LEAST = 1e-4, 1.0       # of the way that a coordinate goes, or of its value
CLOSE, HOPELESS = 1e3, 1e18         # of the tolerance
TOGETHER = 256          # windows cut short, whose polynomials are looked at at once


class Window:
    """start [s] and length of the polynomials, which hold up to `end` after the start; q, v at the start; values of q̈
    at the points, and `series`, its Legendre coefficients, both of shape (n, points); g: senses of the switches;
    slides: those that slide."""

    __slots__ = ("end", "g", "length", "q", "rule", "series", "slides", "start", "v", "values")

    def __init__(self, rule: "Rule", start: float, length: float, q: np.ndarray, v: np.ndarray, A: np.ndarray,
                 g: Sequence[float], slides: Sequence[Any], end: float | None = None) -> None:
        self.rule, self.start, self.length, self.end = rule, start, length, length if end is None else end
        self.q, self.v, self.g, self.slides = q, v, g, slides
        self.values, self.series = A, A @ rule.to_series

    def until(self, end: float) -> "Window":
        """The same up to an earlier instant alone."""
        return Window(self.rule, self.start, self.length, self.q, self.v, self.values, self.g, self.slides, end)

    def states(self, tau: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(q, q̇, q̈) of shapes (n, instants) at the instants tau [s] after the start."""
        return self.summed(tau, self.rule.basis(2 * tau / self.length - 1))

    def summed(self, tau: Any, P: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The same with the values of the Legendre polynomials at the instants at hand."""
        rule, H = self.rule, self.length
        a = self.series @ P[:-2]
        v = self.v[:, None] + H * ((self.series @ rule.once) @ P[:-1])
        q = self.q[:, None] + tau * self.v[:, None] + H * H * ((self.series @ rule.twice) @ P)
        return q, v, a

    def state(self, tau: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        q, v, a = self.states(np.array([tau]))
        return q[:, 0], v[:, 0], a[:, 0]


def along(windows: Sequence[Window], c: np.ndarray) -> np.ndarray:
    """(q, q̇, q̈), each of shape (n, windows · len(c)), at parts c of what each of some windows holds, one after the
    other."""
    n, groups = len(windows[0].q), {}
    found = np.empty((3, n, len(windows), len(c)))
    for k, window in enumerate(windows):
        groups.setdefault((window.rule, None if window.end == window.length else k // TOGETHER), []).append(k)
    for (rule, cut), members in groups.items():
        some = [windows[k] for k in members]
        series = np.array([window.series for window in some])
        H, end = (np.array(ends)[:, None, None] for ends in zip(*((one.length, one.end) for one in some), strict=True))
        q, v = (np.array(rows)[:, :, None] for rows in zip(*((window.q, window.v) for window in some), strict=True))
        P = rule.basis_at(c) if cut is None else rule.basis((2 * c * (end / H) - 1).ravel()).reshape(
            -1, len(some), len(c)).swapaxes(0, 1)
        found[:, :, members] = np.array([
            q + end * c * v + H * H * (series @ (rule.twice @ P)), v + H * (series @ (rule.once @ P[..., :-1, :])),
            series @ P[..., :-2, :]]).transpose(0, 2, 1, 3)
    return found.reshape(3, n, -1)


def moves(windows: Sequence[Window], count: int) -> np.ndarray:
    """So many Legendre coefficients of q − q₀ − τ q̇₀, of q̇ − q̇₀ and of q̈ of some windows, of shape (windows, 3n,
    count)."""
    n, rules = len(windows[0].q), [window.rule for window in windows]
    found = np.zeros((len(windows), 3, n, count))
    for rule in set(rules):
        of_rule = slice(None) if rules.count(rule) == len(rules) else [one is rule for one in rules]
        members = [window for window in windows if window.rule is rule]
        rows = np.concatenate([one.series for one in members])
        H = np.array([one.length for one in members])[:, None, None]
        found[of_rule, 0, :, :rule.points + 2] = H * H * (rows @ rule.twice).reshape(len(members), n, -1)
        found[of_rule, 1, :, :rule.points + 1] = H * (rows @ rule.once).reshape(len(members), n, -1)
        found[of_rule, 2, :, :rule.points] = rows.reshape(len(members), n, -1)
    return found.reshape(len(windows), 3 * n, count)


def ended(window: Window, q: np.ndarray, v: np.ndarray) -> Window:
    """The window that ends in a state (q, q̇): with a constant and a slope in q̈ for what it lacks."""
    rule, H, A = window.rule, window.length, window.values
    speed = (v - window.v) / H - A @ rule.w
    place = (q - window.q - H * window.v) / H**2 - A @ rule.b2 - speed / 2
    lacking = speed[:, None] - 6 * place[:, None] * (2 * rule.c - 1)
    return Window(rule, window.start, H, window.q, window.v, A + lacking, window.g, window.slides)


class Attempt(NamedTuple):
    """What an iteration came to: A of shape (n, points), None where it failed; the iterations it took; the inverse that
    Newton's method used, for the next window of this length."""

    A: np.ndarray
    iterations: int
    inverse: np.ndarray | None = None


def expected(radians: float, left: float, most: int) -> int:
    """How many of Picard's iterations a window of a swing takes that begins with what holds at its start: until
    (ωH)²ᵏ/(2k)! is no more than may be left."""
    count, part = 0, 1.0
    while part > left and count < most:
        count += 1
        part *= radians**2 / (2 * count * (2 * count - 1))
    return count


def iterated(force: Callable[..., np.ndarray], rule: "Rule", H: float, q: np.ndarray, v: np.ndarray, guess: np.ndarray,
             allowed: np.ndarray, unseen: int = 0, more: int = 0) -> Attempt:
    """Picard's iteration. force(Q, V) gives q̈ at the points; allowed: the error of each coordinate, (n, 1); unseen: how
    many iterations are made before the first look at their change; more: how many after it is small."""
    s = rule.points
    base = np.concatenate([q[:, None] + v[:, None] * (H * rule.c), np.repeat(v[:, None], s, 1)], axis=1)
    integrals = np.concatenate([(H * H) * rule.V2, H * rule.V1], axis=1)
    A, before = guess, np.inf
    state = base + A @ integrals
    for count in range(1, MOST_PICARD + 1):
        A = force(state[:, :s], state[:, s:])
        old, state = state, base + A @ integrals
        if count <= unseen:
            continue
        error = float((np.abs(state[:, :s] - old[:, :s]) / allowed).max())
        if error <= 1 or (count > PATIENCE and error <= CLOSE and error > 0.5 * before):
            for _ in range(more):
                A = force(state[:, :s], state[:, s:])
                state = base + A @ integrals
            return Attempt(A, count)
        if not error < HOPELESS or (count > PATIENCE and error > 0.9 * before):
            break
        before = error
    return Attempt(None, count)


def newton(force: Callable[..., np.ndarray], rule: "Rule", H: float, q: np.ndarray, v: np.ndarray, guess: np.ndarray,
           allowed: np.ndarray, inverse: np.ndarray | None = None, more: int = 0) -> Attempt:
    """Newton's method on f(q(A), q̇(A)) − A = 0; force(Q, V, copies) takes so many copies of the points at once;
    inverse: that of the window before, used as long as it does; more: iterations after its change is small."""
    base, speed = q[:, None] + v[:, None] * (H * rule.c), v[:, None]
    V1, V2 = H * rule.V1, (H * H) * rule.V2
    A, before = guess, np.inf
    for count in range(1, MOST_NEWTON + 1):
        Q, V = base + A @ V2, speed + A @ V1
        fresh = inverse is None
        if fresh:
            residual, inverse = _linearised(force, Q, V, A, V1, V2, H)
            if inverse is None:
                break
        else:
            residual = force(Q, V) - A
        step = (inverse @ residual.ravel()).reshape(A.shape)
        error = float((np.abs(step @ V2) / allowed).max())
        A = A + step
        if error <= 1 or (error <= CLOSE and error > 0.5 * before):
            for _ in range(more):
                A = A + (inverse @ (force(base + A @ V2, speed + A @ V1) - A).ravel()).reshape(A.shape)
            return Attempt(A, count, inverse)
        if not error < HOPELESS or (count > 4 and error > 0.9 * before):
            break
        if error > 0.1 * before and not fresh:
            inverse = None
        before = error
    return Attempt(None, count)


def _linearised(force: Callable[..., np.ndarray], Q: np.ndarray, V: np.ndarray, A: np.ndarray, V1: np.ndarray,
                V2: np.ndarray, H: float) -> tuple[np.ndarray, np.ndarray]:
    """(f − A, (1 − ∂f/∂A)⁻¹) with ∂f/∂A = f_q V₂ᵀ + f_q̇ V₁ᵀ, by differences."""
    n, s = A.shape
    span = np.maximum(np.ptp(Q, axis=1), LEAST * np.abs(Q).max(axis=1))
    steps = DIFFERENCE * np.where(span > 0, span, span.max() or 1.0)
    Qs, Vs = np.tile(Q, 4 * n + 1), np.tile(V, 4 * n + 1)
    for i in range(n):
        for copy, sign in ((4 * i + 1, 1), (4 * i + 2, -1)):
            Qs[i, copy * s:(copy + 1) * s] += sign * steps[i]
            Vs[i, (copy + 2) * s:(copy + 3) * s] += sign * steps[i] / H
    F = force(Qs, Vs, 4 * n + 1).reshape(n, 4 * n + 1, s)
    slopes = (F[:, 1:].reshape(n, n, 2, 2, s)[:, :, :, 0] - F[:, 1:].reshape(n, n, 2, 2, s)[:, :, :, 1]) / 2
    K, C = slopes[:, :, 0] / steps[:, None], slopes[:, :, 1] / (steps[:, None] / H)
    big = np.eye(n * s).reshape(n, s, n, s)
    big = big - K.transpose(0, 2, 1)[:, :, :, None] * V2.T[None, :, None, :]
    big -= C.transpose(0, 2, 1)[:, :, :, None] * V1.T[None, :, None, :]
    if not np.isfinite(big).all():
        return F[:, 0] - A, None
    try:
        return F[:, 0] - A, np.linalg.inv(big.reshape(n * s, n * s))
    except np.linalg.LinAlgError:
        return F[:, 0] - A, None
