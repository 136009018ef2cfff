"""Functions as other books and programs call them: hints of messages."""

import re

from vibcli.base.spelling import near
from vibcli.symbolic.parser import FUNCTIONS

_FUNCTIONS = {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctg": "atan", "tg": "tan", "ln": "log",
              "sqr": "sqrt", "root": "sqrt", "arctan2": "atan2", "heaviside": "step", "sgn": "sign", "fabs": "abs",
              "dirac": "impulse", "sh": "sinh", "ch": "cosh", "th": "tanh"}
_LIBRARY = re.compile(r"(?:np|numpy|math|sp|sympy|m)\.(\w+)")


def function_meant(name: str) -> str | None:
    """The hint for what is called like a function and is none: np.sqrt, arctan, ln; None where it is like none."""
    library = _LIBRARY.fullmatch(name)
    word = library[1] if library else name
    found = _FUNCTIONS.get(word.lower()) or near(word, FUNCTIONS)
    return f"did you mean '{found}'?" if found else None
