"""What is compared of a scene: {quantity: (file, the function there that makes its Subject)}."""

NATURAL = ("eigenvalues", "natural")
DAMPED = ("eigenvalues", "damped")
SUBJECTS = {
    "omega": NATURAL, "frequency": NATURAL, "period": NATURAL, "growth_rate": NATURAL,
    "mode": NATURAL, "modal_mass": NATURAL,
    "zeta": DAMPED, "omega_d": DAMPED, "period_d": DAMPED, "decay": DAMPED, "eigenvalue": DAMPED, "mode_d": DAMPED,
    "value": ("motions", "of_motion"), "max": ("motions", "of_motion"), "min": ("motions", "of_motion"),
    "argmax": ("motions", "of_motion"), "argmin": ("motions", "of_motion"), "zero": ("motions", "of_motion"),
    "period()": ("motions", "period"), "phase(frf)": ("frequency_responses", "of_part"),
    "decrement[]": DAMPED, "beat_period": ("beats", "between_modes"),
    "final": ("long_after", "limit"),
    "decrement": ("vibrations", "of_one"), "time_to": ("vibrations", "of_one"), "cycles_to": ("vibrations", "of_one"),
    "M": ("matrices", "of_entry"), "C": ("matrices", "of_entry"), "G": ("matrices", "of_entry"),
    "K": ("matrices", "of_entry"),
    "V[]": ("expansions", "of_energy"), "T[]": ("expansions", "of_energy"),
    "stiffness_correction": ("expansions", "of_correction"),
    "stiffness": ("equivalents", "of_place"), "damping": ("equivalents", "of_place"),
    "law": ("laws", "of_power"), "law()": ("laws", "force"),
    "backbone()": ("backbones", "by_amplitude"),
    "M()": ("states", "of_state"), "K()": ("states", "of_state"), "C()": ("states", "of_state"),
    "Q()": ("states", "of_state"),
    "mass": ("bodies", "moment"), "centre": ("bodies", "moment"), "J": ("bodies", "moment"),
    "sensitivity": ("sensitivities", "sensitivity"),
    "equilibrium": ("static_positions", "at_rest"),
    "frf": ("frequency_responses", "at_frequency"), "transmissibility": ("frequency_responses", "at_frequency"),
    "re": ("frequency_responses", "of_part"), "im": ("frequency_responses", "of_part"),
    "arg": ("frequency_responses", "of_part"), "peak": ("frequency_responses", "of_curve"),
    "antiresonance": ("frequency_responses", "of_curve"), "half_power": ("frequency_responses", "of_curve"),
    "amplitude": ("steady_states", "of_wave"), "phase": ("steady_states", "of_wave"),
    "harmonic": ("steady_states", "harmonic"),
    "mean": ("steady_states", "over_a_period"), "rms": ("steady_states", "over_a_period"),
}
