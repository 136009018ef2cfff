"""Numbers that are read off free vibrations: decrement, decay, beats, and the share of each mode."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.textbook_form import formula, told_apart

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.textbook_form import Part

EQUAL, CLOSE = 0.2, 0.25
ALONE = 1e-10       # amplitude of another vibration, relative to the largest, that counts as none


def decrement(rate: float, omega_d: float) -> float:
    """δ = ln(x_k / x_{k+1}) = 2π · decay / ω_d of e^{rate t} cos(ω_d t)."""
    return -math.tau * rate / omega_d


def time_to(fraction: float, rate: float) -> float:
    """The time in which e^{rate t} falls to a fraction."""
    return math.log(fraction) / rate


def cycles_to(fraction: float, delta: float) -> float:
    """The number of cycles in which the amplitude falls to a fraction."""
    return -math.log(fraction) / delta


def vibrations(motion: "LinearMotion", output: "LinearOutput", segment: int = -1) -> "list[Part]":
    """The Parts of an output that vibrate, but for those next to which they are nothing."""
    parts = [part for part in formula(motion, output, segment, told_apart(motion)) if part.omega]
    largest = max((abs(part.amplitude) for part in parts), default=0.0)
    return [part for part in parts if abs(part.amplitude) > ALONE * largest]


def beat_period(motion: "LinearMotion", output: "LinearOutput", segment: int = -1) -> float | None:
    """2π/|ω₁ − ω₂| of the two largest vibrations in the output; None where one hears no beat.

    A beat is named where the lesser amplitude is at least EQUAL of the greater, the frequencies differ by less than
    CLOSE of their mean, and neither dies out (falls to 1/e) within one beat.
    """
    parts = sorted((part for part in vibrations(motion, output, segment) if not part.power),
                   key=lambda part: -part.amplitude)[:2]
    if len(parts) < 2 or parts[1].amplitude < EQUAL * parts[0].amplitude:
        return None
    apart = abs(parts[0].omega - parts[1].omega)
    if not 0 < apart < CLOSE * (parts[0].omega + parts[1].omega) / 2:
        return None
    period = math.tau / apart
    return period if all(-part.rate * period < 1 for part in parts) else None


def energy_shares(M: np.ndarray, modes: "Sequence[Mode]", q0: np.ndarray, v0: np.ndarray) -> list[float]:
    """The share of each undamped mode in the energy at the start, ½ (φᵀMv₀)² + ½ ω² (φᵀMq₀)² of all; [] at rest."""
    momenta = [np.array([float(x) for x in mode.shape]) @ np.asarray(M, float) for mode in modes]
    energies = [((row @ v0) ** 2 + (float(mode.omega or 0.0) * (row @ q0)) ** 2) / 2
                for mode, row in zip(modes, momenta, strict=True)]
    total = sum(energies)
    return [energy / total for energy in energies] if total else []
