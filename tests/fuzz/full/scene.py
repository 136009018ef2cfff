"""A random scene in motion: its text, and its equations as written by hand."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from support.piecewise_motion import Motion

G = Fraction("9.81")
PRIME, UNITS = "'", (("rad", "rad/s"), ("m", "m/s"))    # of angles, of lengths


class Moving(NamedTuple):
    """text: of the scene; names: of the state, coordinates first; start; until [s]; build, mode, turn, times: as those
    of a Motion."""

    kind: str
    text: str
    names: Sequence[str]
    start: Sequence[Any]
    until: Any
    build: Callable
    mode: Any = None
    turn: Callable | None = None
    times: Sequence[Any] = ()

    def motion(self):
        return Motion(self.build, self.names, self.start, self.until, self.mode, self.turn, self.times)


class Draw:
    """Decimals at random; `p`: {name: Fraction} of those that were drawn, `text`: of the parameters of the scene."""

    def __init__(self, random):
        self.random, self.p, self.parts = random, {}, []

    def number(self, low, high, digits=3):
        """A decimal as text, evenly by its logarithm where it has one sign."""
        value = self.random.uniform(low, high) if low <= 0 else low * (high / low) ** self.random.random()
        return f"{value:.{digits}g}" if abs(value) >= 1e-3 else f"{value:.6f}"

    def __call__(self, name, low, high, unit, digits=3):
        """A parameter."""
        text = self.number(low, high, digits)
        self.p[name] = Fraction(text)
        self.parts.append(f"{name}: {text} {unit}".replace("[]", "").strip())
        return self.p[name]

    @property
    def parameters(self):
        return "parameters: {" + ", ".join(self.parts) + "}\n"

    def until(self, low=2, high=12):
        return self.number(low, high, 3)


def initial(names, start):
    """The section of the scene."""
    entries = (f"{name}: {value} {UNITS[name[0] in 'xy'][name.count(PRIME)]}"
               for name, value in zip(names, start, strict=True))
    return "initial: {" + ", ".join(entries) + "}\n"


def sine(tape, u):
    return u.sin_cos()[0]


def cosine(tape, u):
    return u.sin_cos()[1]


def solved(M, right):
    """M x = right, by elimination."""
    n = len(right)
    M, x = [list(row) for row in M], list(right)
    for k in range(n):
        for i in range(k + 1, n):
            factor = M[i][k] / M[k][k]
            for j in range(k + 1, n):
                M[i][j] = M[i][j] - factor * M[k][j]
            x[i] = x[i] - factor * x[k]
    for i in reversed(range(n)):
        for j in range(i + 1, n):
            x[i] = x[i] - M[i][j] * x[j]
        x[i] = x[i] / M[i][i]
    return x
