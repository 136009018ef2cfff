"""How much each mode takes part in a motion."""

from typing import NamedTuple

import numpy as np

from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient.textbook_form import formula


class ModeInTime(NamedTuple):
    """One mode of a motion, coordinate by coordinate amplitude · e^{rate τ} cos(omega τ − phase), times τ^power."""

    omega: float
    rate: float
    power: int
    amplitudes: list
    phases: list
    forced: bool


def modes_in_time(motion, segment=0):
    """The motion of all coordinates as a sum over modes, on a segment: each with an amplitude and a phase for each."""
    n, found = len(motion.M), {}
    for i in range(n):
        for part in formula(motion, LinearOutput(q={i: 1.0}), segment):
            key = next((key for key in found if _near(key, part)), (part.forced, part.omega, part.rate, part.power))
            found.setdefault(key, [(0.0, 0.0)] * n)[i] = part.amplitude, part.phase
    return [ModeInTime(omega, rate, power, *map(list, zip(*each, strict=True)), forced)
            for (forced, omega, rate, power), each in sorted(found.items(), key=lambda item: item[0])]


def _near(key, part):
    forced, omega, rate, power = key
    gap = abs(complex(rate - part.rate, omega - part.omega))
    return (forced, power) == (part.forced, part.power) and gap <= 1e-9 * abs(complex(rate, omega))


def energy_shares(M, modes, q0, v0):
    """The share of each undamped mode in the energy at the start, ½ (φᵀMv₀)² + ½ ω² (φᵀMq₀)² of all; [] at rest."""
    momenta = [np.array([float(x) for x in mode.shape]) @ np.asarray(M, float) for mode in modes]
    energies = [((row @ v0) ** 2 + (float(mode.omega or 0.0) * (row @ q0)) ** 2) / 2
                for mode, row in zip(modes, momenta, strict=True)]
    total = sum(energies)
    return [energy / total for energy in energies] if total else []
