"""How far the instants may be off at which an output is largest, or passes zero: δt = δy / |ẏ|, of a top δẏ / |ÿ|."""

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion

EPSILON = 2.0**-52
STEEP = 1e3         # times its error: the slope at an end or a kink, not at a top


def of_passage(motion: "LinearMotion | WaveMotion", output: "LinearOutput", t: float) -> float:
    """Of a zero; of one that touches by the curvature, √(2 δy / |ÿ|)."""
    return _least(motion, output, t, 0)


def of_top(motion: "LinearMotion | WaveMotion", output: "LinearOutput", t: float) -> float:
    """Of an extreme; of one at an end, or at a kink or jump of the loads, that of rounding."""
    slope, doubt = _known(motion, output, t, 1)
    return 2 * EPSILON * t if abs(slope) > STEEP * doubt else _least(motion, output, t, 1)


def _known(motion: "LinearMotion | WaveMotion", output: "LinearOutput", t: float, order: int) -> tuple[float, float]:
    """(a derivative, its error) at an instant."""
    at = np.array([t])
    return float(motion.values(output, at, order)[0]), float(motion.errors(output, at, order)[0])


def _least(motion: "LinearMotion | WaveMotion", output: "LinearOutput", t: float, order: int) -> float:
    """δ with δ |y'| >= 2 δy for the derivative y of an order, or where y' is lost in its error δ² |y''| >= 8 δy; all of
    t where that is lost too."""
    rounding = 2 * EPSILON * t
    doubt = float(motion.errors(output, np.array([t]), order)[0])
    slope, of_slope = _known(motion, output, t, order + 1)
    if not doubt:
        return rounding
    if abs(slope) > 2 * of_slope:
        return 4 * doubt / abs(slope) + rounding
    bend, of_bend = _known(motion, output, t, order + 2)
    bent = abs(bend) - of_bend
    return min(t, 2 * math.sqrt(2 * doubt / bent) + 2 * abs(slope) / bent) + rounding if bent > 0 else t
