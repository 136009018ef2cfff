"""The stages of a Problem, whose costs are told where that is asked."""

from vibcli.analyses import OF_MODES

STAGES = ("scene", "linearisation", "equilibrium", "linear_system", "modes", "damped", "energies", "equations",
          "closed_forms", "equilibria", "reactions", *OF_MODES)
