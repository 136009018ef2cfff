"""The words of `find` by what asks for them: `FIND` has all of them."""

from vibcli.analyses import FIND

INSIGHT = ("shares", "sensitivities", "estimates")
RESPONSES = ("response", "frequency_response")
ALWAYS = ("equations", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work")
ON_REQUEST = tuple(word for word in FIND if word not in ALWAYS)         # found only where they are asked for
