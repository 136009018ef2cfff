"""How far a motion leaves its constraints G = 0, Ġ = 0 between the instants at which it is put back on them."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.mechanics.numeric_equations import NumericEquations


class Drift(NamedTuple):
    """The largest |G| relative to how far its coordinates move it, and |Ġ| relative to how fast they do."""

    position: float
    velocity: float


def drift(system: "NumericEquations", windows: "Sequence[Window]") -> Drift | None:
    """The Drift at the ends and Gauss points of all windows; None without constraints."""
    if not system.m:
        return None
    worst, reach = np.zeros((2, system.m)), np.zeros((2, system.m))
    start = windows[0].q
    for window in windows:
        tau = np.append(window.rule.c * window.end, window.end)
        q, v, _ = window.states(tau)
        t = window.start + tau
        t[-1] = np.nextafter(t[-1], window.start)       # with the speed that it was driven at
        slopes = np.abs(system.slopes(t, q, v))
        moved = np.abs(q - start[:, None]), np.abs(v)
        for i, (gap, far) in enumerate(zip(system.gaps(t, q, v), moved, strict=True)):
            worst[i] = np.maximum(worst[i], np.abs(gap).max(axis=1))
            reach[i] = np.maximum(reach[i], np.einsum("kit,it->kt", slopes, far).max(axis=1))
    return Drift(*(float(np.max(gap / np.where(size > 0, size, 1.0))) for gap, size in zip(worst, reach, strict=True)))
