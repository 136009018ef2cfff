"""Smooth functions in place of those that jump, where expressions are compared at random instants.

A pulse of 5 ms is zero at most instants, and so is the difference of a scene with it and one without. The stand-ins
differ everywhere, and keep the symmetries that rewriting uses: ramp u = u·step u, step(−u) = 1 − step u, δ(−u) = δ(u),
square(u + π) = −square u.
"""

from collections.abc import Callable
from functools import partial
from math import pi, sin
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    import numpy as np


def _stand_ins(sin: Callable[..., Any]) -> dict[str, Callable[..., Any]]:
    def step(u: "float | np.ndarray") -> "float | np.ndarray":
        found: float | np.ndarray = (1 + sin(1.7 * u)) / 2
        return found

    def ramp(u: "float | np.ndarray") -> "float | np.ndarray":
        return u * step(u)

    def impulse(u: float, order: float = 0) -> float:
        found: float = sin(1.3 * u + (order + 1) * pi / 2)
        return found

    def square(u: Any, order: int = 0) -> Any:
        return sum(k ** (order - 1) * sin(k * u + order * pi / 2) for k in (1.0, 3.0))

    def sawtooth(u: Any, order: int = 0) -> Any:
        return -sum(k ** (order - 1) * sin(k * u + order * pi / 2) for k in (1.0, 2.0, 3.0))

    return {"step": step, "ramp": ramp, "impulse": impulse, "square": square, "sawtooth": sawtooth}


def _record(sin: Callable[..., Any], name: str, samples: Any) -> Callable[..., Any]:
    """A record as a wave of its own; of one name, one wave."""
    phase = sum(map(ord, name))
    return lambda u, order: sin(1.1 * u + phase + order * pi / 2)


class SmoothFloats(Floats):
    """Floats with the stand-ins."""

    functions = {**Floats.functions, **_stand_ins(sin)}
    record = staticmethod(partial(_record, sin))


def smooth_arrays() -> type[Any]:
    """NumPy arrays with the stand-ins."""
    import numpy as np

    from vibcli.symbolic.array_arithmetic import Arrays

    class SmoothArrays(Arrays):
        functions = {**Arrays.functions, **_stand_ins(np.sin)}
        record = staticmethod(partial(_record, np.sin))

    return SmoothArrays
