"""The first instant within a window at which a switch changes its sense, or leaves its slide."""

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.root_finding import last_place

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.mechanics.switching import Switching

ROUNDS = 100
NEAR, SMALL = 4 * 2.0**-52, 64 * 2.0**-52       # of the time gone, of a window: how well an instant is known
WITHIN = 1e-10         # of a window
SPOTS = 12              # of a part of a window in which an argument vanishes


@lru_cache
def _places(points: int) -> tuple[np.ndarray, np.ndarray]:
    """(c, Legendre polynomials there): 2s places of Chebyshev, ending at 1."""
    c = 0.5 * (1 - np.cos(np.pi * np.arange(1, 2 * points + 1) / (2 * points)))
    return c, rule(points).basis(2 * c - 1)


@lru_cache
def _spots(points: int, part: int) -> tuple[np.ndarray, np.ndarray]:
    """The same at the places of Chebyshev of the part of a window that ends at such a place."""
    ends, within = np.append(0.0, _places(points)[0]), 0.5 * (1 - np.cos(np.pi * np.arange(SPOTS) / (SPOTS - 1)))
    c = ends[part] + (ends[part + 1] - ends[part]) * within
    return c, rule(points).basis(2 * c - 1)


def first_event(switching: "Switching", window: "Window", slack: np.ndarray,
                breaks: bool = False) -> tuple[float | None, tuple[int, ...]]:
    """(instant after the window's start, numbers of the switches that change there), (None, ()) where none does.

    slack: how far each argument may be on the wrong side, by rounding; breaks: may what is prescribed turn at another
    speed where the window ends? There it is looked at from within."""
    c, P = _places(window.rule.points)
    tau = c * window.length
    q, v, _ = window.summed(tau, P)
    if breaks:
        tau = tau.copy()
        tau[-1] -= max(WITHIN * window.length, 64 * np.spacing(window.start + window.length))
    room = _room(switching, window, window.start + tau, q, v) + slack[:, None]
    wrong = room < 0
    if not wrong.any():
        return None, ()
    first = int(np.argmax(wrong.any(axis=0)))
    found = [(_zero(switching, window, k, first, tau[first]), k) for k in np.flatnonzero(wrong[:, first]).tolist()]
    instant = min(found)[0]
    return instant, tuple(k for time, k in found if time - instant <= 1e-12 * (window.start + window.length))


def _room(switching: "Switching", window: "Window", t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """σ g of each switch, or σ₀ − |σ| of those that slide: negative where it has to change."""
    g = np.array(window.g)
    room: np.ndarray = g[:, None] * switching.values(t, q, v, window.g)
    if window.slides:
        _, sigma = switching.sliding(window.slides, t, q, v, window.g)
        which = list(window.slides)
        room[which] = switching.bounds[which][:, None] - np.abs(sigma)
    return room


def _zero(switching: "Switching", window: "Window", k: int, part: int, end: float) -> float:
    """The instant at which the room of a switch vanishes in a part of a window that ends so long after its start."""
    def room(tau: float) -> float:
        q, v, _ = window.states(np.array([tau]))
        found: float = _room(switching, window, np.array([window.start + tau]), q, v)[k, 0]
        return found

    c, P = _spots(window.rule.points, part)
    tau = np.minimum(c * window.length, end)
    values = _room(switching, window, window.start + tau, *window.summed(tau, P)[:2])[k]
    if values[0] <= 0:
        return float(tau[0]) if part else _after_start(room, end)
    below = int(np.argmax(values < 0))
    if (np.diff(values) < 0).all():
        at_zero, apart = _inverse(tau, values)
        known = NEAR * (window.start + end) + SMALL * window.length
        if apart <= known and tau[below - 1] <= at_zero <= tau[below]:
            return at_zero
    return last_place(lambda tau: room(tau) > 0, tau[below - 1], tau[below], ROUNDS)[1]


def _inverse(places: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Where a function with these values at places vanishes, by the polynomial of its inverse (Neville), and how far
    apart the last two are that are a degree lower."""
    found, y = places.tolist(), values.tolist()
    before = found
    for order in range(1, len(y)):
        before, found = found, [(y[i + order] * found[i] - y[i] * found[i + 1]) / (y[i + order] - y[i])
                                for i in range(len(y) - order)]
    return found[0], abs(before[1] - before[0])


def _after_start(room: Callable[[float], float], high: float) -> float:
    """A switch that has just changed may start from zero: where it comes back to it, 0.0 where it never left."""
    low = high
    for _ in range(60):
        low *= 0.5
        if room(low) > 0:
            return last_place(lambda tau: room(tau) > 0, low, high, ROUNDS)[1]
    return 0.0
