"""What a small change of the state or of the data makes of a motion: the equations linearised along it.

    δ̈ = ∂q̈/∂q δ + ∂q̈/∂q̇ δ̇ + ∂q̈/∂p δp        by collocation, window by window, all windows of a chunk at once

A window takes a change (δ, δ̇) at its start to Φ (δ, δ̇) + Ψ δp at its end.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import Window, along
from vibcli.analyses.time_integration.rounded_data import DIRECTIONS, STEP
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.collocation_rule import rule

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.rounded_data import Varied
    from vibcli.numerics.collocation_rule import Rule

POINTS, STIFF = 12, 8   # of Gauss, of Radau where the motion itself was found by these
CHUNK = 40_000          # instants at which forces are evaluated at once
ENTRIES = 500_000       # of the matrices of windows that are solved at once
NEAR = 1e-6             # of the motion: how far neighbours are from it


class Linear(NamedTuple):
    """A window linearised: of rule `rule` and length `length`; A: values of δ̈ at its points for a unit of each of
    (δ, δ̇) at its start, and of each direction of the data, of shape (n, points, 2n + directions); Phi, Psi of shapes
    (2n, 2n) and (2n, directions)."""

    rule: Any
    length: float
    A: np.ndarray
    Phi: np.ndarray
    Psi: np.ndarray

    def along(self, tau: np.ndarray, starts: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(δ, δ̇, δ̈), each of shape (n, instants, columns), at instants after the start; starts: (δ, δ̇) there of each
        column, those of the directions first."""
        n, count = len(self.A), starts.shape[1]
        A = np.einsum("isj,jk->ksi", self.A[:, :, :2 * n], starts)
        A[:DIRECTIONS] += self.A[:, :, 2 * n:].transpose(2, 1, 0)
        rows = [Window(self.rule, 0.0, self.length, start[:n], start[n:], one.T, (), ()).states(tau)
                for start, one in zip(starts.T, A, strict=True)]
        q, v, a = (np.array([row[i] for row in rows]).reshape(count, n, len(tau)).transpose(1, 2, 0)
                   for i in range(3))
        return q, v, a


def linearised(varied: "Varied", windows: Sequence[Window], steps: np.ndarray) -> list[Linear]:
    """The Linear of each window; steps: how far the state is changed to see the slopes, of shape (2n,)."""
    found: list[Any] = [None] * len(windows)
    groups: dict[Any, list[int]] = {}
    for k, window in enumerate(windows):
        groups.setdefault((tuple(window.slides), window.rule.c[-1] == 1), []).append(k)
    for (slides, stiff), members in groups.items():
        chosen = rule(STIFF, radau=True) if stiff else rule(POINTS)
        unknowns = chosen.points * len(steps) // 2
        size = max(min(CHUNK // (chosen.points * (len(steps) + DIRECTIONS)), ENTRIES // unknowns**2), 1)
        for first in range(0, len(members), size):
            part = members[first:first + size]
            for k, one in zip(part, _chunk(varied, [windows[k] for k in part], chosen, slides, steps), strict=True):
                found[k] = one
    return found


def slopes(varied: "Varied", t: np.ndarray, q: np.ndarray, v: np.ndarray, g: Any, slides: Sequence[int],
           steps: np.ndarray) -> np.ndarray:
    """Of q̈ by q, by q̇ and by the directions of the data, of shape (n, 2n + directions, instants)."""
    n, N = q.shape
    copies = 2 * n + 1
    Q, V = np.tile(q, copies).reshape(n, copies, N), np.tile(v, copies).reshape(n, copies, N)
    for i in range(n):
        Q[i, i] += steps[i]
        V[i, n + i] += steps[n + i]
    many = [np.tile(sense, copies) for sense in g]
    a = varied.accelerations(0, np.tile(t, copies), Q.reshape(n, -1), V.reshape(n, -1), many, slides)
    a = a.reshape(n, copies, N)
    found = np.empty((n, 2 * n + DIRECTIONS, N))
    found[:, :2 * n] = (a[:, :2 * n] - a[:, 2 * n:]) / steps[:, None]
    for r in range(DIRECTIONS):
        found[:, 2 * n + r] = (varied.accelerations(r + 1, t, q, v, g, slides) - a[:, 2 * n]) / STEP
    return found


def _chunk(varied: "Varied", windows: list[Window], chosen: "Rule", slides: tuple[int, ...],
           steps: np.ndarray) -> list[Linear]:
    c, n, s, W = chosen.c, len(windows[0].q), chosen.points, len(windows)
    H = np.array([window.end for window in windows])
    t = np.concatenate([window.start + c * window.end for window in windows])
    q, v, _ = along(windows, c)
    g = [np.repeat(senses, s) for senses in zip(*(window.g for window in windows), strict=True)] if windows[0].g else ()
    F = slopes(varied, t, q, v, g, slides, steps).reshape(n, -1, W, s).transpose(2, 0, 3, 1)    # (W, n, s, columns)
    F = np.where(np.isfinite(F), F, 0.0)
    K, C = F[..., :n], F[..., n:2 * n]
    big = np.eye(n * s).reshape(1, n, s, n, s)
    big = big - (H * H)[:, None, None, None, None] * K[..., None] * chosen.V2.T[:, None, :]
    big -= H[:, None, None, None, None] * C[..., None] * chosen.V1.T[:, None, :]
    right = F.copy()
    right[..., n:2 * n] += K * (H[:, None] * c)[:, None, :, None]
    A = np.linalg.solve(big.reshape(W, n * s, n * s), right.reshape(W, n * s, -1)).reshape(W, n, s, -1)
    H, rows = H[:, None, None], A.transpose(0, 1, 3, 2)
    ends = np.concatenate([H * H * (rows @ chosen.b2), H * (rows @ chosen.w)], axis=1)
    ends[:, :, :2 * n] += np.eye(2 * n)
    ends[:, :n, n:2 * n] += H * np.eye(n)
    return [Linear(chosen, window.end, one, end[:, :2 * n], end[:, 2 * n:])
            for window, one, end in zip(windows, A, ends, strict=True)]
