"""Quantities that answers and conditions name: the family to which each belongs, one family a file.

What each quantity is, its indices, arguments and unit stand in quantity.py.
"""

FAMILIES = {
    **dict.fromkeys(("omega", "frequency", "period", "growth_rate", "mode", "zeta", "omega_d", "decay", "eigenvalue",
                     "decrement", "sensitivity", "rayleigh", "dunkerley"), "modal"),
    **dict.fromkeys(("equilibrium", "stable", "equilibria"), "equilibrium"),
    **dict.fromkeys(("M", "C", "G", "K", "J", "centre"), "matrices"),
}
