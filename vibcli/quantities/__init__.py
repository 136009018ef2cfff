"""Quantities that answers and conditions name, in the order of the manual: the file in which each is declared."""

FAMILIES = {
    **dict.fromkeys(("omega", "frequency", "period", "growth_rate", "mode", "node", "modal_mass"), "modal"),
    **dict.fromkeys(("zeta", "omega_d", "period_d", "decay", "eigenvalue", "mode_d"), "damped"),
    **dict.fromkeys(("sensitivity", "rayleigh", "dunkerley", "ritz"), "modal"),
    **dict.fromkeys(("equilibrium", "Q", "stable", "equilibria"), "equilibrium"),
    **dict.fromkeys(("equation", "motion"), "energies"),
    **dict.fromkeys(("M", "C", "G", "K"), "matrices"),
    **dict.fromkeys(("stiffness", "damping"), "equivalents"),
    **dict.fromkeys(("T", "V", "Phi"), "energies"),
    **dict.fromkeys(("mass", "J", "centre"), "bodies"),
    **dict.fromkeys(("amplitude", "phase", "max", "min", "argmax", "argmin", "mean", "rms", "final", "overshoot",
                     "decrement", "beat_period", "harmonic", "zero", "time_to", "cycles_to", "steady", "transient",
                     "envelope"), "response"),
    **dict.fromkeys(("frf", "transmissibility", "peak", "antiresonance", "half_power", "fixed_point", "quality", "arg",
                     "re", "im", "modal_frf", "truncation"), "frequency_response"),
    "backbone": "nonlinear", "fold": "nonlinear", "law": "laws", "stiffness_correction": "spring_corrections",
}

# what the same word means otherwise: with indices, with arguments, of a frequency response; "value" is that of x(2 s)
FORMS = {"decrement[]": "damped", "rayleigh[]": "modal", "V[]": "expansions", "T[]": "expansions", "M()": "states",
         "law()": "laws", "backbone()": "nonlinear", "fold()": "nonlinear", "C()": "states", "K()": "states",
         "Q()": "states", "period()": "response", "phase(frf)": "frequency_response", "value": "response"}
