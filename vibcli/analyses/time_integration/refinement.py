"""Newton's method on all windows of a stretch of a motion at once, from a rough guess of it.

The residual r = f(t, q(A), q̇(A)) − A of collocation (numerics/collocation_rule.py) is taken away, of each window of
length H, by

    δA = B⁻¹ r + S δy        B = 1 − H² K V₂ − H C V₁        B S = (K, H c K + C)        K = ∂f/∂q, C = ∂f/∂q̇

and δy = (δq, δq̇) at its start is what the windows before leave: δy ← Φ δy + (H² b₂, H w) δA. K and C are taken at the
guess once, and B at fewer points, which resolve the change alone; what of r is finer is added as it is, since two
integrals leave little of it. So each iteration but the first costs f at the points and a few products of matrices.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from vibcli.analyses.time_integration.error_scales import EPSILON
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.collocation_rule import Rule, rule

MOST = 10               # iterations
SLOW, CLOSE = 0.5, 30.0  # what falls no faster, and is no more than so many errors that are allowed, is rounding


class JoinedStates(NamedTuple):
    """(q, q̇) of shape (windows + 1, 2n) between the windows; Q, V at points, (windows, n, points); gaps: by how much
    each window ends beyond the next start, (windows, 2n)."""

    ends: np.ndarray
    Q: np.ndarray
    V: np.ndarray
    gaps: np.ndarray


class Linearised(NamedTuple):
    """Of each window, at fewer points: B⁻¹; S of shape (n·points, 2n); Phi."""

    inverse: np.ndarray
    S: np.ndarray
    Phi: np.ndarray


class Grids(NamedTuple):
    """A rule of Gauss, and one of fewer points; V1, V2: integrals of the first at the points of the other; down: values
    at the points to those of their smoother part at the fewer; up: values at these to those at the points."""

    fine: Rule
    rough: Rule
    V1: np.ndarray
    V2: np.ndarray
    down: np.ndarray
    up: np.ndarray


@lru_cache
def grids(points: int, fewer: int) -> Grids:
    """The Grids of so many points."""
    fine, rough = rule(points), rule(fewer)
    P, known = fine.basis_at(rough.c), rough.basis_at(rough.c)[:fewer]
    return Grids(fine, rough, fine.to_series @ fine.once @ P[:-1], fine.to_series @ fine.twice @ P,
                 fine.to_series[:, :fewer] @ known, rough.to_series @ rough.basis_at(fine.c)[:fewer])


class ManyWindows:
    """The windows between instants `edges` [s], from a start (q, q̇); force(t, Q, V): q̈ of shape (n, instants), and
    by_state(t, Q, V, steps): its slopes by (q, q̇), (2n, n, instants). times: the points, and the fewer."""

    def __init__(self, force: Callable[..., np.ndarray], by_state: Callable[..., np.ndarray], chosen: Grids,
                 edges: np.ndarray, start: np.ndarray) -> None:
        self.force, self.by_state, self.grids, self.edges, self.start = force, by_state, chosen, edges, start
        self.lengths = np.diff(edges)
        self.H = self.lengths[:, None, None]
        self.times = [edges[:-1, None] + self.lengths[:, None] * one.c for one in chosen[:2]]

    def refined(self, guess: Callable[..., Any], allowed: np.ndarray,
                steps: np.ndarray) -> tuple[int, np.ndarray, JoinedStates]:
        """(how many windows from the first on are found, q̈ at the points of all, their JoinedStates). guess(t): (Q, V)
        of shape (rows, n, columns); allowed: the error of each coordinate; steps: by how much (q, q̇) are changed to see
        slopes. LinAlgError where there are none."""
        ends, rough, fine = self._guessed(guess)
        A, slopes = self._at(*fine), self._slopes(*rough, steps)
        linear, here = self._linearised(slopes), self._states(ends, A, 1)
        change = np.concatenate(here[1:3], axis=1) - np.concatenate(rough, axis=1)
        return self._iterated(*self._changed(here, A, np.einsum("wijs,wjs->wis", slopes, change), 0.0, linear),
                              linear, allowed)

    def _guessed(self, guess: Callable[..., Any]) -> tuple[
            np.ndarray, tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
        """(the states between the windows, (Q, V) at the fewer points, at the points); the last state does not matter,
        being where the last window comes to."""
        fine, rough = self.times
        Q, V = guess(np.concatenate([self.edges[:-1, None], rough, fine], axis=1))
        starts, count = np.concatenate([Q[:, :, 0], V[:, :, 0]], axis=1), 1 + rough.shape[1]
        ends = np.concatenate([self.start[None], starts[1:], starts[-1:]])
        return ends, (Q[:, :, 1:count], V[:, :, 1:count]), (Q[:, :, count:], V[:, :, count:])

    def _iterated(self, here: JoinedStates, A: np.ndarray, linear: Linearised,
                  allowed: np.ndarray) -> tuple[int, np.ndarray, JoinedStates]:
        """With f at the states, until all windows are found: what is left of each falls by the same part again."""
        found, before = np.zeros(len(A), dtype=bool), np.inf
        rounding = 0.5 * EPSILON * np.arange(1.0, len(A) + 1)[:, None, None]
        for count in range(MOST):
            residual, last = self._at(here.Q, here.V) - A, here.Q
            smooth = _times(residual, self.grids.down)
            here, A = self._changed(here, A, smooth, residual - _times(smooth, self.grids.up), linear)
            change = (np.abs(here.Q - last) / (allowed[:, None] + rounding * np.abs(here.Q))).max(axis=(1, 2))
            part = np.minimum(change / before, 1.0) if count else 1.0
            found |= (change * part <= 1) | ((part > SLOW) & (change <= CLOSE))
            if found.all():
                break
            before = change
        return int(np.cumprod(found).sum()), A, here

    def _at(self, Q: np.ndarray, V: np.ndarray) -> np.ndarray:
        """q̈ at states at the points, all of shape (windows, n, points)."""
        windows, n, points = Q.shape
        rows = (X.transpose(1, 0, 2).reshape(n, -1) for X in (Q, V))
        return self.force(self.times[0].ravel(), *rows).reshape(n, windows, points).transpose(1, 0, 2)

    def _states(self, ends: np.ndarray, A: np.ndarray, which: int = 0) -> JoinedStates:
        """The JoinedStates, at the points or at the fewer, of those between the windows and of q̈ at the points."""
        (fine, rough, *between), H, h, n = self.grids[:4], self.H, self.lengths[:, None], A.shape[1]
        c, V1, V2 = (rough.c, *between) if which else (fine.c, fine.V1, fine.V2)
        q, v = ends[:-1, :n], ends[:-1, n:]
        Q = q[:, :, None] + H * c * v[:, :, None] + H * H * _times(A, V2)
        reached = np.concatenate([q + (h * v + h * h * (A @ fine.b2)), v + h * (A @ fine.w)], axis=1)
        return JoinedStates(ends, Q, v[:, :, None] + H * _times(A, V1), reached - ends[1:])

    def _slopes(self, Q: np.ndarray, V: np.ndarray, steps: np.ndarray) -> np.ndarray:
        """(K, C) at the fewer points, of shape (windows, n, 2n, points)."""
        windows, n, points = Q.shape
        rows = (X.transpose(1, 0, 2).reshape(n, -1) for X in (Q, V))
        found = self.by_state(self.times[1].ravel(), *rows, steps)
        return found.reshape(2 * n, n, windows, points).transpose(2, 1, 0, 3)

    def _linearised(self, slopes: np.ndarray) -> Linearised:
        rough, H, (windows, n, _, points) = self.grids.rough, self.H[..., None], slopes.shape
        K, C = slopes[:, :, :n], slopes[:, :, n:]
        B = -(H * H * K).transpose(0, 1, 3, 2)[..., None] * rough.V2.T[:, None, :]
        B -= (H * C).transpose(0, 1, 3, 2)[..., None] * rough.V1.T[:, None, :]
        B = B.reshape(windows, n * points, n * points)
        B[:, range(n * points), range(n * points)] += 1.0
        inverse = np.linalg.inv(B)
        right = np.concatenate([K, H * rough.c * K + C], axis=2).transpose(0, 1, 3, 2)
        S = inverse @ right.reshape(windows, n * points, 2 * n)
        rows = S.reshape(windows, n, points, 2 * n).transpose(0, 1, 3, 2)
        Phi = np.concatenate([self.H**2 * (rows @ rough.b2), self.H * (rows @ rough.w)], axis=1) + np.eye(2 * n)
        Phi[:, :n, n:] += self.H * np.eye(n)
        return Linearised(inverse, S, Phi)

    def _changed(self, here: JoinedStates, A: np.ndarray, smooth: np.ndarray, rest: float | np.ndarray,
                 linear: Linearised) -> tuple[JoinedStates, np.ndarray]:
        """(the JoinedStates, q̈ at the points) without gaps and without a residual: its smooth part at the fewer points,
        the rest at the points."""
        fine, up, h, (windows, n, _) = self.grids.fine, self.grids.up, self.lengths[:, None], smooth.shape
        own = _times((linear.inverse @ smooth.reshape(windows, -1, 1)).reshape(smooth.shape), up) + rest
        delta, deltas = np.zeros(2 * n), [np.zeros(2 * n)]
        for Phi, end in zip(linear.Phi, np.concatenate([h * h * (own @ fine.b2), h * (own @ fine.w)], 1) + here.gaps,
                            strict=True):
            delta = Phi.dot(delta) + end
            deltas.append(delta)
        moved = np.array(deltas)
        A = A + (own + _times((linear.S @ moved[:-1, :, None]).reshape(smooth.shape), up))
        return self._states(here.ends + moved, A), A


def _times(A: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """A @ matrix as one product."""
    found: np.ndarray = (A.reshape(-1, len(matrix)) @ matrix).reshape(*A.shape[:2], -1)
    return found
