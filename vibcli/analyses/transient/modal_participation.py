"""How much each mode takes part in a motion."""

import numpy as np


def energy_shares(M, modes, q0, v0):
    """The share of each undamped mode in the energy at the start, ½ (φᵀMv₀)² + ½ ω² (φᵀMq₀)² of all; [] at rest."""
    momenta = [np.array([float(x) for x in mode.shape]) @ np.asarray(M, float) for mode in modes]
    energies = [((row @ v0) ** 2 + (float(mode.omega or 0.0) * (row @ q0)) ** 2) / 2
                for mode, row in zip(modes, momenta, strict=True)]
    total = sum(energies)
    return [energy / total for energy in energies] if total else []
