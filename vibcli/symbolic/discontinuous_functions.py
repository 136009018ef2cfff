"""Functions of time that jump or have corners, and their rates.

    step(u)      0 before u = 0, 1 from there on        ramp(u)       u·step(u)
    impulse(u)   Dirac's δ(u), its n-th rate with order n
    square(u)    the sign of sin u, +1 first            sawtooth(u)   from −1 at u = 0 up to 1 at u = 2π, repeated

The rates of square and sawtooth hold trains of impulses; they are the same functions with the order as a second
argument. A value is that between the impulses; where one acts there is none (NaN).
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import mpmath
    import numpy as np

PULSES = ("step", "ramp", "impulse", "square", "sawtooth")


def step(u: "float | mpmath.mpf") -> float:
    return u if u != u else (1.0 if u >= 0 else 0.0)


def ramp(u: "float | mpmath.mpf") -> "float | mpmath.mpf":
    return u if u >= 0 or u != u else 0.0


def impulse(u: "float | mpmath.mpf", order: int = 0) -> float:
    return 0.0 if u else math.nan


def on(pi: Any, floor: Callable[..., Any]) -> dict[str, Callable[..., Any]]:
    """square and sawtooth in numbers that compare, `floor` being that of their kind."""
    def square(u: "float | mpmath.mpf", order: int = 0) -> float:
        turns = u / pi
        below = floor(turns)
        if order:
            return 0.0 if turns != below else math.nan
        return 1.0 if below % 2 == 0 else -1.0

    def sawtooth(u: "float | mpmath.mpf", order: int = 0) -> "float | mpmath.mpf":
        turns = u / (2 * pi)
        below = floor(turns)
        if order:
            return math.nan if turns == below else 1 / pi if order == 1 else 0.0
        return 2 * (turns - below) - 1
    return {"step": step, "ramp": ramp, "impulse": impulse, "square": square, "sawtooth": sawtooth}


def on_arrays() -> "dict[str, Callable[..., np.ndarray]]":
    """The same for NumPy arrays."""
    import numpy as np

    def impulse(u: "np.ndarray", order: int = 0) -> "np.ndarray":
        return np.where(np.asarray(u) == 0, np.nan, 0.0)

    def square(u: "np.ndarray", order: int = 0) -> "np.ndarray":
        turns = np.asarray(u, dtype=float) / np.pi
        below = np.floor(turns)
        if np.any(order):
            return np.where(turns == below, np.nan, 0.0)
        return np.where(np.mod(below, 2) == 0, 1.0, -1.0)

    def sawtooth(u: "np.ndarray", order: int = 0) -> "np.ndarray":
        turns = np.asarray(u, dtype=float) / math.tau
        below = np.floor(turns)
        if np.any(order):
            return np.where(turns == below, np.nan, (1 / np.pi) * (np.asarray(order) == 1))
        return 2 * (turns - below) - 1

    return {"step": lambda u: np.heaviside(u, 1.0), "ramp": lambda u: np.maximum(u, 0.0), "impulse": impulse,
            "square": square, "sawtooth": sawtooth}
