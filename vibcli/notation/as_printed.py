"""A value as it was typed, 40 N*s/m, as it is set in print: 40 N·s/m, 30°, 9.81 m/s², √(2)·π·f₁."""

import re
from collections.abc import Collection

from vibcli.notation.plain import plain

TOKENS = re.compile(r"(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d]\w*)|(?P<power>\^\s*-?\d+(?!\.))"
                    r"|(?P<times>\s*\*\s*)|(?P<minus>-)|(?P<other>.)", re.DOTALL)
DEGREES = re.compile(r"(?<=\d) deg\b")
MICRO = {"um": "µm", "us": "µs", "uN": "µN"}
SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def as_printed(text: str, names: Collection[str] = ()) -> str:
    """The text with its signs as they are printed; `names`: those of the scene, letters of the field among them."""
    known = {"pi", *names}
    found = []
    for token in TOKENS.finditer(DEGREES.sub("°", " ".join(text.split()))):
        kind, part = token.lastgroup, token.group()
        if kind == "times":
            part = "·"
        elif kind == "power":
            part = part[1:].strip().translate(SUPERSCRIPT)
        elif kind == "minus":
            part = "−"
        elif kind == "name" and part == "sqrt":
            part = "√"
        elif kind == "name":
            part = plain.symbol(part) if part in known else MICRO.get(part, part)
        found.append(part)
    return "".join(found)
