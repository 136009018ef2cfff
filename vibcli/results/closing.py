"""Coordinates that close loops, as the free ones move."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import mpmath
    import numpy as np


class Closing:
    """Coordinates that close loops, as functions of the time: of the free ones, whose signals are {name: signal}."""

    def __init__(self, loops: Any, rest: "Mapping[str, float | mpmath.mpf]", free: Any) -> None:
        self.loops, self.rest, self.free = loops, rest, free

    def values(self, times: Any, known: Any) -> "dict[str, np.ndarray]":
        """{name: array}, `known` being the values of parameters and of the time, and of free coordinates perhaps."""
        free = {name: one.values(times) for name, one in self.free.items() if name not in known}
        found: dict[str, np.ndarray] = self.loops.along(self.rest, {**known, **free})
        if found is None:
            raise PhysicsError("the loops of this scene cannot close along its small oscillations",
                               "mind how large they are, or write motion: full")
        return found
