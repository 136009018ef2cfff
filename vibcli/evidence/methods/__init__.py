"""The methods that are compared: {file: (the kinds of subjects that it answers, what it is)}."""

METHODS = {
    "ours": (("modes", "damped modes", "motion", "full motion"), "vibcli itself, from the element data on"),
    "assembled_modes": (("modes",), "eigh and eig of assembled K and M"),
    "state_eigenvalues": (("damped modes",), "eig of the state matrix and of the pencil that is assembled"),
    "integrators": (("motion", "full motion"), "solve_ivp and odeint at tolerances 1e-3 … 1e-13"),
    "mode_sums": (("motion",), "modal superposition with 1 … n undamped modes"),
}
