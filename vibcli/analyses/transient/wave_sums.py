"""Signals that last, as sums of c e^{iωt} over positive and negative ω, and the arithmetic of their sums and products.

Of a wave Re X e^{iΩt} the c of ±Ω are X/2 and its conjugate, of a constant it is the constant itself; a product has the
sums of the ω of its factors. What stands at ω = 0 is the mean over all times, whether there is a common period or not.
Each c has a first-order bound of its error: sums have the sum, products c₁c₂ have |c₁| δ₂ + |c₂| δ₁, and a rounding.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.sampled_functions import Samples

SAME = 1e-12        # distance of frequencies that are one, relative to the largest
MOST = 2_000_000    # products of waves at once
ROUNDING = 2.0**-51


class WaveSum:
    """`speeds`: the ω, ascending; `sizes`: the c; `errors`: their bounds |δc|."""

    __slots__ = ("errors", "sizes", "speeds")

    def __init__(self, speeds: np.ndarray, sizes: np.ndarray, errors: np.ndarray) -> None:
        order = np.argsort(speeds)
        speeds, sizes, errors = speeds[order], sizes[order], errors[order] + ROUNDING * np.abs(sizes[order])
        apart = np.diff(speeds) > SAME * np.abs(speeds).max(initial=0.0)
        first = np.flatnonzero(np.append(True, apart)[:len(speeds)])
        self.speeds = speeds[first]
        self.sizes, self.errors = (np.add.reduceat(row, first) if len(first) else row for row in (sizes, errors))

    @classmethod
    def of(cls, waves: Sequence[tuple[float, complex]], errors: Sequence[float]) -> "WaveSum":
        """Of [(Ω, X)], Ω = 0 of a constant, and the bounds |δX|."""
        speeds = [sign * speed for speed, _ in waves for sign in (1, -1)]
        sizes = [part / 2 for _, X in waves for part in (complex(X), complex(X).conjugate())]
        return cls(np.array(speeds), np.array(sizes, complex), np.repeat(np.array(errors, float) / 2, 2))

    def __add__(self, other: "WaveSum | float") -> "WaveSum":
        other = wave_sum(other)
        return WaveSum(np.append(self.speeds, other.speeds), np.append(self.sizes, other.sizes),
                       np.append(self.errors, other.errors))

    def __mul__(self, other: "WaveSum | float") -> "WaveSum":
        other = wave_sum(other)
        if len(self.speeds) * len(other.speeds) > MOST:
            raise PhysicsError("the products of these vibrations are too many to take their mean", "take a lower power")
        errors = (np.multiply.outer(self.errors, np.abs(other.sizes) + other.errors)
                  + np.multiply.outer(np.abs(self.sizes), other.errors))
        return WaveSum(np.add.outer(self.speeds, other.speeds).ravel(),
                       np.multiply.outer(self.sizes, other.sizes).ravel(), errors.ravel())

    __radd__, __rmul__ = __add__, __mul__

    def values(self, times: np.ndarray) -> np.ndarray:
        return np.real(np.exp(1j * np.multiply.outer(times, self.speeds)) @ self.sizes)

    @property
    def mean(self) -> tuple[float, float]:
        """(value, absolute bound of its error) over all times."""
        still = np.abs(self.speeds) <= SAME * np.abs(self.speeds).max(initial=0.0)
        return float(self.sizes[still].real.sum()), float(self.errors[still].sum())


def wave_sum(value: "WaveSum | float") -> WaveSum:
    """The same; of a number a constant."""
    return value if isinstance(value, WaveSum) else WaveSum(np.zeros(1), np.array([value], complex),
                                                                   np.array([ROUNDING * abs(value)]))


def _of_constants(function: Callable[..., Any]) -> Callable[..., Any]:
    def call(*args: Any) -> Any:
        if any(isinstance(arg, WaveSum) for arg in args):
            raise KeyError(function)
        return function(*args)
    return call


class WaveSums:
    """The arithmetic of `evaluate`, constants being floats; KeyError of what is no polynomial of signals."""

    pi, number = Floats.pi, staticmethod(Floats.number)
    functions = {name: _of_constants(function) for name, function in Floats.functions.items()}

    @staticmethod
    def record(name: str, samples: "Samples") -> Callable[..., float]:
        return _of_constants(samples.at)

    @staticmethod
    def called(function: "DefinedFunction") -> Callable[..., float]:
        return _of_constants(function.at)

    @staticmethod
    def power(base: "WaveSum | float", exponent: Fraction) -> "WaveSum | float":
        if not isinstance(base, WaveSum):
            return Floats.power(base, exponent)
        if exponent < 0 or exponent.denominator > 1:
            raise KeyError(exponent)
        found = base
        for _ in range(int(exponent) - 1):
            found = found * base
        return found
