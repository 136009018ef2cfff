"""NumPy arithmetic for `evaluate`: one walk over the expressions for many states at once."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.symbolic import discontinuous_functions
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.sampled_functions import Samples


class Arrays:
    """Float arrays; what has no real value is NaN, for the caller to refuse."""

    pi = np.pi
    functions: dict[str, Callable[..., Any]] = {
        "sin": np.sin, "cos": np.cos, "tan": np.tan, "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan,
        "atan2": np.arctan2, "sinh": np.sinh, "cosh": np.cosh, "tanh": np.tanh, "exp": np.exp, "log": np.log,
        "abs": np.abs, "sign": np.sign, "min": np.minimum, "max": np.maximum, "power": np.power,
        **discontinuous_functions.on_arrays()}

    @staticmethod
    def record(name: str, samples: "Samples") -> Callable[..., np.ndarray]:
        return samples.on_arrays

    @staticmethod
    def called(function: "DefinedFunction") -> Callable[..., np.ndarray]:
        return function.on_arrays

    @staticmethod
    def number(value: "Fraction | int") -> float:
        return value.numerator / value.denominator

    @staticmethod
    def power(base: float | np.ndarray, exponent: "Fraction | int") -> float | np.ndarray:
        if exponent == HALF:
            return np.sqrt(base)
        if exponent.denominator == 1:
            found: float | np.ndarray = np.power(np.asarray(base, dtype=float), exponent.numerator)
            return found
        return np.power(base, exponent.numerator / exponent.denominator)
