"""The quantity that is most likely meant by a word that is none: hints of messages."""

import re

from vibcli.base.spelling import near
from vibcli.quantities import FAMILIES
from vibcli.quantities.quantity import ALL, named
from vibcli.symbolic.parser import plain_name

_LETTERS = {"w": "omega", "wn": "omega", "wd": "omega_d", "f": "frequency", "xi": "zeta", "T": "period",
            "tau": "period", "delta": "decay", "Theta": "decrement", "lambda": "eigenvalue", "X": "amplitude",
            "A": "amplitude", "theta": "phase", "frequencies": "frequency", "I": "J", "H": "frf"}


def quantity_meant(asked: str, otherwise: str | None = ALL) -> str | None:
    """The hint for what is asked and is no quantity: omega_1 and omega_n mean omega[1], f[1] means frequency[1];
    `otherwise` where it is like none."""
    name = plain_name(asked)
    numbered = re.fullmatch(r"(\w*?[A-Za-z])(?:_?(\d{1,3})|_?([n0]))", name)
    head = numbered and _LETTERS.get(numbered[1], numbered[1])
    if head in FAMILIES and len(named(head).indices) == 1:
        return f"write {head}[{int(numbered[2] or 1) or 1}]"
    word = _LETTERS.get(name) or near(name, FAMILIES)
    return f"did you mean '{word}'?" if word else otherwise
