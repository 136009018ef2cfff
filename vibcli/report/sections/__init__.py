"""Sections of a report by name: the file whose generator of that name writes it, and what it tells."""

SECTIONS = {
    "given": ("parameters", "what is given"),
    "chosen": ("design_parameters", "the parameters that the scene chose"),
    "coordinates": ("parameters", "the coordinates, and how constraints tie them"),
    "equilibrium": ("equilibrium", "the equilibrium that is reached from the drawn position"),
    "virtual_work": ("statics", "the virtual work of what acts"),
    "energies": ("equations_of_motion", "T, V, Φ and the work of loads"),
    "equations": ("equations_of_motion", "equations of motion, full and for small oscillations"),
    "frequencies": ("spectrum", "natural frequencies"),
    "damping": ("spectrum", "damping ratios and damped frequencies"),
    "modes": ("spectrum", "mode shapes"),
    "equilibria": ("equilibria", "the list of all equilibria"),
    "reactions": ("statics", "reactions in equilibrium and along a motion"),
    "response": ("response", "the motion in time"),
    "frequency_response": ("frequency_response", "resonances, antiresonances and amplitudes"),
    "shares": ("shares", "what each element has of the energy of a mode"),
    "sensitivities": ("sensitivities", "how frequencies change with parameters"),
    "estimates": ("estimates", "estimates of Rayleigh and Dunkerley"),
    "ritz": ("ritz", "bounds of frequencies by assumed shapes"),
    "schematic": ("illustrations", "the figure of the scene"),
    "mode_pictures": ("illustrations", "figures of the mode shapes"),
}
