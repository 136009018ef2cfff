"""How far the instants may be off at which an output is largest, or passes zero: δt = δy / |ẏ|, of a top δẏ / |ÿ|."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion

EPSILON = 2.0**-52
STEEP = 1e3         # times its error: the slope at an end or a kink, not at a top


def of_passage(motion: "LinearMotion", output: "LinearOutput", t: float) -> float:
    """Of a zero; of one that touches by the curvature, √(2 δy / |ÿ|)."""
    return _least(_local(motion, output, t, 0), t)


def of_top(motion: "LinearMotion", output: "LinearOutput", t: float) -> float:
    """Of an extreme; of one at an end, or at a kink or jump of the loads, that of rounding."""
    (slope, doubt), *further = _local(motion, output, t, 1)
    if abs(slope) > STEEP * doubt:
        return 2 * EPSILON * t
    return _least([(slope, doubt), *further], t)


def _local(motion, output, t, order):
    """[(derivative, its error)] of three orders from the given one."""
    at = np.array([t])
    return [(float(motion.values(output, at, k)[0]), float(motion.errors(output, at, k)[0]))
            for k in range(order, order + 3)]


def _least(derivatives, t):
    """δ with δ |y'| − … >= δy, or δ² |y''| / 2 >= δy; all of t where the errors decide it."""
    (_, doubt), (slope, of_slope), (bend, of_bend) = derivatives
    found, steep, bent = [t], abs(slope) - of_slope, abs(bend) - of_bend
    if not doubt:
        return 2 * EPSILON * t
    if steep > 0:
        found.append(2 * doubt / steep)
    if bent > 0:
        found.append(2 * np.sqrt(2 * doubt / bent) + 2 * (abs(slope) / bent if steep <= 0 else 0.0))
    return float(min(found) + 2 * EPSILON * t)
