"""What is compared of a scene: {quantity: (file, the function there that makes its Subject)}."""

NATURAL = ("eigenvalues", "natural")
DAMPED = ("eigenvalues", "damped")
SUBJECTS = {
    "omega": NATURAL, "frequency": NATURAL, "period": NATURAL, "growth_rate": NATURAL,
    "mode": NATURAL, "modal_mass": NATURAL,
    "zeta": DAMPED, "omega_d": DAMPED, "period_d": DAMPED, "decay": DAMPED, "eigenvalue": DAMPED, "mode_d": DAMPED,
    "value": ("motions", "of_motion"), "max": ("motions", "of_motion"), "min": ("motions", "of_motion"),
    "argmax": ("motions", "of_motion"), "argmin": ("motions", "of_motion"), "zero": ("motions", "of_motion"),
    "equilibrium": ("static_positions", "at_rest"),
    "frf": ("frequency_responses", "at_frequency"), "transmissibility": ("frequency_responses", "at_frequency"),
    "re": ("frequency_responses", "of_part"), "im": ("frequency_responses", "of_part"),
    "arg": ("frequency_responses", "of_part"), "phase": ("frequency_responses", "of_part"),
    "peak": ("frequency_responses", "peak"), "amplitude": ("frequency_responses", "amplitude"),
    "rms": ("frequency_responses", "amplitude"),
}
