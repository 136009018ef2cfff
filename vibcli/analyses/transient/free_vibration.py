"""Numbers that are read off free vibrations: decrement, decay, overshoot, beats."""

import math

import numpy as np

from vibcli.analyses.transient.textbook_form import formula

EQUAL, CLOSE = 0.2, 0.25
SETTLED = 40.0


def decrement(rate, omega_d):
    """δ = ln(x_k / x_{k+1}) = 2π · decay / ω_d of e^{rate t} cos(ω_d t)."""
    return -math.tau * rate / omega_d


def decrement_of_peaks(first, later, cycles=1):
    """δ = ln(x_k / x_{k+cycles}) / cycles."""
    return math.log(first / later) / cycles


def zeta_of_decrement(delta):
    """ζ = δ / √(4π² + δ²)."""
    return delta / math.hypot(math.tau, delta)


def time_to(fraction, rate):
    """The time in which e^{rate t} falls to a fraction."""
    return math.log(fraction) / rate


def cycles_to(fraction, delta):
    """The number of cycles in which the amplitude falls to a fraction."""
    return -math.log(fraction) / delta


def beat_period(motion, output, segment=0):
    """2π/|ω₁ − ω₂| of the two largest vibrations in the output; None where one hears no beat.

    A beat is named where the lesser amplitude is at least EQUAL of the greater, the frequencies differ by less than
    CLOSE of their mean, and neither dies out (falls to 1/e) within one beat.
    """
    parts = sorted((part for part in formula(motion, output, segment) if part.omega and not part.power),
                   key=lambda part: -part.amplitude)[:2]
    if len(parts) < 2 or parts[1].amplitude < EQUAL * parts[0].amplitude:
        return None
    apart = abs(parts[0].omega - parts[1].omega)
    if not 0 < apart < CLOSE * (parts[0].omega + parts[1].omega) / 2:
        return None
    period = math.tau / apart
    return period if all(-part.rate * period < 1 for part in parts) else None


def horizon(motion):
    """A time by which the transient has died out, to e^{−SETTLED}; infinite where it never does."""
    starts = motion.pieces(math.inf).timeline.starts if motion.forcing.period is None else [motion.forcing.since]
    slowest = max((node.real for block in motion.blocks for node in block.nodes), default=0.0)
    return float(starts[-1]) - SETTLED / slowest if slowest < 0 else math.inf


def overshoot(motion, output, start=0.0):
    """By how much the output goes beyond its final value, over the whole change from its value at `start`."""
    last = motion.final(output)
    change = last - float(motion.values(output, np.array([start]))[0])
    if not change:
        return None
    _, peak = motion.extreme(output, start, horizon(motion), "max" if change > 0 else "min")
    return max(0.0, (peak - last) / change)


def settling_time(motion, output, within=0.02, start=0.0):
    """The last time the output is further from its final value than `within` of the whole change."""
    last = motion.final(output)
    room = within * abs(last - float(motion.values(output, np.array([start]))[0]))
    if not room:
        return None
    end = horizon(motion)
    times = [motion.crossings(output, last + side * room, start, end) for side in (-1, 1)]
    return float(max((found[-1] for found in times if len(found)), default=start))
