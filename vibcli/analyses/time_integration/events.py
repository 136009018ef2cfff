"""The first instant within a window at which a switch changes its sense, or leaves its slide."""

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.root_finding import last_place

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.mechanics.switching import Switching

ROUNDS = 100
NEAR = 4 * 2.0**-52
WITHIN = 1e-10         # of a window


@lru_cache
def _places(points):
    """(c, Legendre polynomials there): 2s places of Chebyshev, ending at 1."""
    c = 0.5 * (1 - np.cos(np.pi * np.arange(1, 2 * points + 1) / (2 * points)))
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
    low = tau[first - 1] if first else 0.0
    found = [(_zero(switching, window, k, low, tau[first]), int(k)) for k in np.flatnonzero(wrong[:, first])]
    instant = min(found)[0]
    return instant, tuple(k for time, k in found if time - instant <= 1e-12 * (window.start + window.length))


def _room(switching, window, t, q, v):
    """σ g of each switch, or σ₀ − |σ| of those that slide: negative where it has to change."""
    g = np.array(window.g)
    room = g[:, None] * switching.values(t, q, v, window.g)
    if window.slides:
        _, sigma = switching.sliding(window.slides, t, q, v, window.g)
        which = list(window.slides)
        room[which] = switching.bounds[which][:, None] - np.abs(sigma)
    return room


def _zero(switching, window, k, low, high):
    """The instant at which the room of a switch vanishes, by false position with bisection (Illinois)."""
    def room(tau):
        q, v, _ = window.states(np.array([tau]))
        return _room(switching, window, np.array([window.start + tau]), q, v)[k, 0]

    below, above = room(low), room(high)
    if below <= 0:
        return low if low else _after_start(room, high)
    side = 0
    for _ in range(ROUNDS):
        middle = (low * above - high * below) / (above - below)
        if not low < middle < high:
            middle = 0.5 * (low + high)
        value = room(middle)
        if high - low <= NEAR * (window.start + high) or value == 0:
            break
        if value < 0:
            high, above = middle, value
            below = 0.5 * below if side < 0 else below
            side = -1
        else:
            low, below = middle, value
            above = 0.5 * above if side > 0 else above
            side = 1
    return middle


def _after_start(room, high):
    """A switch that has just changed may start from zero: where it comes back to it, 0.0 where it never left."""
    low = high
    for _ in range(60):
        low *= 0.5
        if room(low) > 0:
            return last_place(lambda tau: room(tau) > 0, low, high, ROUNDS)[1]
    return 0.0
