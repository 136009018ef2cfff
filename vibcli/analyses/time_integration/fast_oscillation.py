"""A fast oscillation that hardly moves anything, and is stepped over where to follow it would be long work.

Two masses on springs of 1 N/m and 1e9 N/m swing together within seconds, and against one another 7000 times a second,
by 1e-10 of that. Its size is measured while it is followed; afterwards it is part of the error of what is said: of
positions hardly, of velocities more, of accelerations and of the force of the stiff spring as much as it is.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.analyses.time_integration.error_scales import Sizes

SMALL = 1e-6        # of the motion: what moves less may be stepped over
SMOOTH = 2          # degree of what is not fast within a window
SAFETY = 2.0        # a swing that is measured over few periods
ROUGH, LEFT = 1.0, 0.1      # of the amplitude: coefficients while it settles, and later


class Fast(NamedTuple):
    """since [s]: when it was left alone; speed [rad/s]; its amplitudes in each q, q̇, q̈; part: of the motion."""

    since: float
    speed: float
    q: np.ndarray
    v: np.ndarray
    a: np.ndarray
    part: float

    def allowed(self, settling: Any) -> np.ndarray:
        """Which coefficients of q need not be resolved: those of the oscillation as long as it is settling."""
        return (ROUGH if settling > 0 else LEFT) * self.q[:, None]


def fast_part(window: "Window", sizes: "Sizes", scale: np.ndarray) -> Fast | None:
    """The Fast of a window that follows it; None where it is not small beside the motion of size `scale`."""
    c = window.rule.c
    q, v, a = (SAFETY * _left(row, c) for row in window.states(c * window.length))
    part = float((q * sizes.weight).max() / (scale * sizes.weight).max())
    found = Fast(window.start + window.length, 1.0 / sizes.radian, q, v, a, part)
    return found if part <= SMALL else None


def _left(rows: np.ndarray, c: np.ndarray) -> np.ndarray:
    """The largest of each row less a polynomial of low degree."""
    P = np.polynomial.legendre.legvander(2 * c - 1, SMOOTH)
    fit = P @ np.linalg.lstsq(P, rows.T, rcond=None)[0]
    found: np.ndarray = np.abs(rows.T - fit).max(axis=0)
    return found
