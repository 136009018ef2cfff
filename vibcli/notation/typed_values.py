"""What was typed, 40 N*s/m, 2*L/3 or abs(frf[y, drive](Omega)), set in print by the symbols of a notation."""

import re
from collections.abc import Callable, Collection

TOKENS = re.compile(r"(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<mode>(?:omega_d|omega|zeta)\[\d+\])|"
                    r"(?P<name>[^\W\d]\w*'*)|(?P<power>\^\s*-?\d+(?![\d.]|\s*\^))|(?P<times>\s*\*\s*)|(?P<minus>-)|"
                    r"(?P<other>.)", re.DOTALL)
PLACED = re.compile(r"(\w+\.)(\w+)\((.*)\)('*)")
DEGREES = re.compile(r"(?<=\d) deg\b")
MICRO = {"um": "µm", "us": "µs", "uN": "µN"}
SUBSCRIPT = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
BARS = "abs"
RATES = {"'": "d/dt\u00a0", "''": "d²/dt²\u00a0"}


def set_in_print(text: str, symbol: Callable[[str], str], known: Collection[str] | None = None) -> str:
    """The text with its signs as they are printed; `symbol(name)` of the names that are `known`, or of all."""
    found, closing = [], []
    for token in TOKENS.finditer(DEGREES.sub("°", " ".join(text.split()))):
        kind, part = token.lastgroup, token.group()
        if kind == "times":
            part = "·"
        elif kind == "power":
            part = part[1:].strip().translate(SUPERSCRIPT)
        elif kind == "minus":
            part = "−"
        elif kind == "mode":
            name, number = part[:-1].split("[")
            if f"{name}{number}" not in (known or ()):      # else that name of the scene looks so
                part = symbol(name) + number.translate(SUBSCRIPT)
        elif kind == "name":
            part = _named(part, symbol, known)
        elif part == "(":
            closing.append("|" if found[-1:] == [BARS] else ")")
            if closing[-1] == "|":
                found[-1] = ""
                part = "|"
        elif part == ")" and closing:
            part = closing.pop()
        found.append(part)
    return "".join(found)


def _named(part: str, symbol: Callable[[str], str], known: Collection[str] | None) -> str:
    if part == "sqrt":
        return "√"
    if part == "log":
        return "ln"
    return symbol(part) if known is None or part.rstrip("'") in known else MICRO.get(part, part)


def placed(name: str, symbol: Callable[[str], str]) -> str:
    """blade.φ̇(2·L/3) of blade.phi(2*L/3)', the name of a motion of a member at a place; others as they are."""
    found = PLACED.fullmatch(name)
    if found is None:
        return name
    owner, part, place, primes = found.groups()
    motion = symbol(part + primes)
    before = RATES[primes] if primes and motion.endswith(primes) else ""        # words have no dots
    return f"{before}{owner}{motion.removesuffix(primes) if before else motion}({set_in_print(place, symbol)})"
