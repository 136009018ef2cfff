"""The words of `find`."""

INSIGHT = ("shares", "sensitivities", "estimates")
RESPONSES = ("response", "frequency_response")
ON_REQUEST = ("equilibria", "reactions", *RESPONSES, *INSIGHT)                    # found only where they are asked for
FIND = ("equations", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work", *ON_REQUEST)
