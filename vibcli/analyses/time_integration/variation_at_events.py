"""What an event makes of a change of the motion: forces that jump when a switch turns, stick, and blows.

A neighbouring motion meets the switch by δτ = −(∂h/∂X δ + ∂h/∂p δp)/ḣ later, h being what vanishes there, and goes on
until then as before (Aizerman & Gantmakher 1958):

    δ⁺ = δ⁻ + (Ẋ⁻ − Ẋ⁺) δτ
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.rounded_data import DIRECTIONS, STEP
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.analyses.time_integration.rounded_data import Varied
    from vibcli.symbolic.node import Node

SMOOTH = 1e-7           # of accelerations: what changes by less does not jump
BACK = 1e-6             # of a window: over which the rate of what vanishes is seen
SOON = 1e-10            # of a window: shortly after a blow


class Jump(NamedTuple):
    """δ⁺ = M δ⁻ + D δp; later: δ⁺ for each second by which the event comes late."""

    M: np.ndarray
    D: np.ndarray
    later: np.ndarray


def jump(varied: "Varied", before: "Window", after: "Window", steps: np.ndarray, blows: Any = None) -> Jump | None:
    """The Jump between two windows; None where nothing jumps."""
    n, t = len(after.q), after.start
    q, v, a = before.state(before.end)
    a_after = after.state(0.0)[2]
    M, D = np.eye(2 * n), np.zeros((2 * n, DIRECTIONS))
    if blows:
        M, D = _blow(varied, t, q, v, after, steps, blows)
    elif not np.abs(a - a_after).max() > SMOOTH * max(np.abs(a).max(), np.abs(a_after).max()):
        return None
    later = np.concatenate([v - after.v, a - a_after])
    turned = _turned(before, after)
    if blows or turned is None or before.end == before.length:
        return Jump(M, D, later)
    slope, data, rate = _vanishing(varied, before, turned, steps)
    late = -1.0 / rate if rate else 0.0
    return Jump(M + np.outer(later, late * slope), D + np.outer(later, late * data), later)


def _turned(before: "Window", after: "Window") -> int | None:
    """The number of a switch that turned, or began or ended its slide; None where none did."""
    for k, (was, now) in enumerate(zip(before.g, after.g, strict=True)):
        if was != now or (k in before.slides) != (k in after.slides):
            return k
    return None


def _vanishing(varied: "Varied", window: "Window", k: int, steps: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """(its slopes by the state, by the data, its rate) of what vanishes where a switch turns: its argument, or what is
    left to the bound of the σ of one that slides."""
    n, tau = len(window.q), window.end
    back = tau * (1 - BACK)
    q, v, _ = window.states(np.array([tau, back]))
    Q, V = np.repeat(q[:, :1], 2 * n, 1), np.repeat(v[:, :1], 2 * n, 1)
    Q[range(n), range(n)] += steps[:n]
    V[range(n), range(n, 2 * n)] += steps[n:]
    t = window.start + np.concatenate([[tau, back], np.full(2 * n, tau)])

    def h(which: int, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        switching = varied.switchings[which]
        if k not in window.slides:
            found: np.ndarray = switching.values(t, q, v, window.g)[k]
            return found
        place = list(window.slides).index(k)
        sigma = switching.sliding(window.slides, t, q, v, window.g)[1][place]
        result: np.ndarray = switching.bounds[k] - np.sign(sigma[0]) * sigma
        return result

    found = h(0, t, np.concatenate([q, Q], axis=1), np.concatenate([v, V], axis=1))
    data = [(h(r + 1, t[:1], q[:, :1], v[:, :1])[0] - found[0]) / STEP for r in range(DIRECTIONS)]
    return (found[2:] - found[0]) / steps, np.array(data), (found[0] - found[1]) / (t[0] - t[1])


def _blow(varied: "Varied", t: float, q: np.ndarray, v: np.ndarray, after: "Window", steps: np.ndarray,
          blows: "dict[Node, float]") -> tuple[np.ndarray, np.ndarray]:
    """How impulses change with the state just before them, and with the data."""
    n, soon = len(q), t + SOON * after.end

    def struck(which: int, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        sizes = blows if not which else {node: varied.directions[which - 1](size) for node, size in blows.items()}
        return varied.systems[which].struck(soon, q, v, after.g, sizes)

    found, M = struck(0, q, v), np.eye(2 * n)
    for i, step in enumerate(steps):
        unit = step * (np.arange(2 * n) == i)
        M[n:, i] = (struck(0, q + unit[:n], v + unit[n:]) - found) / step
    D = np.zeros((2 * n, DIRECTIONS))
    D[n:] = np.array([(struck(r + 1, q, v) - found) / STEP for r in range(DIRECTIONS)]).T
    return M, D
