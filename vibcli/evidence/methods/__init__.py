"""The methods that are compared: {file: (the kinds of subjects that it answers, what it is)}."""

METHODS = {
    "ours": (("modes", "damped modes", "motion", "full motion", "steady motion", "response",
              "peak", "member modes", "damped member modes", "member response", "rated response", "member motion",
              "static position", "vibrations", "matrix entry", "derivative", "force law", "moment of a body"),
             "vibcli itself, from the element data on"),
    "assembled_modes": (("modes",), "eigh and eig of assembled K and M"),
    "state_eigenvalues": (("damped modes",), "eig of the state matrix and of the pencil that is assembled"),
    "finite_elements": (("member modes", "damped member modes", "member response"),
                        "members in 1 … 128 elements a piece, and eigh or LU"),
    "elements_in_time": (("member motion",), "members in 1 … 128 elements a piece, by modes and by Newmark's steps"),
    "mode_sums": (("motion", "steady motion"), "modal superposition with 1 … n undamped modes"),
    "held_inputs": (("motion", "steady motion"), "lsim of 100 … 1,000,000 steps, or of a record's and parts"),
    "integrators": (("motion", "full motion", "steady motion"), "solve_ivp and odeint at tolerances 1e-3 … 1e-13"),
    "one_frequency": (("response",), "LU at the frequency, and sums of 1 … n undamped modes"),
    "static_positions": (("static position",), "SciPy's root, hybr and lm, of the forces at rest"),
    "differences": (("matrix entry", "derivative"),
                    "central differences of forces, energies …; kinetic energies of unit velocities"),
    "inner_forces": (("force law",), "SciPy's root, hybr and lm, of the deflections of parts in series"),
    "over_shapes": (("moment of a body",), "sums over 1 … 1000 cells a side of shapes, and Gauss's quadratures"),
    "dense_grids": (("peak",), "grids of 100 … 1,000,000 frequencies, with parabolas and without"),
}
