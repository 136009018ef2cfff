"""What all that reads a frequency response asks of it: the face of systems of every kind."""

import math
from typing import Any

import numpy as np


class FrequencyResponseFunction:
    """H(s) of one output to a unit of one input, s = iΩ. An input cos Ωt gives the output Re(H e^{iΩt}) in the steady
    state: amplitude |H|, lag θ = −arg H.

    order: how often the output is differentiated (receptance 0, mobility 1, accelerance 2). Poles and zeros are those
    of the output itself.
    """

    __slots__ = ("_uncounted", "order")

    def __init__(self, order: int = 0) -> None:
        self.order = order
        self._uncounted: set[str] = set()

    def leave_uncounted(self, what: str) -> None:
        """Some of the poles, or zeros, that are told from now on may be missing."""
        self._uncounted.add(what)

    def counts(self, what: str) -> bool:
        """Is none of the poles, or zeros, that were told missing for sure?"""
        return what not in self._uncounted

    @property
    def undamped(self) -> bool:
        """Is H a function of s² with real coefficients, times sᵒʳᵈᵉʳ?"""
        raise NotImplementedError

    @property
    def pace(self) -> float:
        """A typical frequency, in rad/s."""
        raise NotImplementedError

    @property
    def end(self) -> float:
        """Up to where peaks are listed that nobody counts, in rad/s; infinite where there are finitely many."""
        return math.inf

    def at(self, s: np.ndarray, steep: bool = False) -> "tuple[np.ndarray, np.ndarray | None, np.ndarray]":
        """(H, dH/ds or None, whether there is a pole) of the output itself at complex s: (N,)."""
        raise NotImplementedError

    def poles(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        """The poles with Im s ≥ 0 from low to high, complex, with those of modes that take no part in H."""
        raise NotImplementedError

    def zeros(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        """The zeros with Im s ≥ 0 from low to high, complex."""
        raise NotImplementedError

    def endless(self, low: float = 0.0, high: float = math.inf) -> list[np.ndarray]:
        """(poles, zeros) of H on the axis, without damping: Ω > 0 of the modes that take part, to rounding."""
        raise NotImplementedError

    def error(self, Omega: float) -> float:
        """A bound of |δH| at a frequency."""
        raise NotImplementedError

    def errors(self, Omega: np.ndarray) -> np.ndarray:
        """The same at many frequencies."""
        return np.array([self.error(at) for at in Omega.tolist()])

    def noise(self, Omega: np.ndarray) -> np.ndarray:
        """What rounding may leave of an H that is 0 at frequencies."""
        return np.zeros(len(Omega))

    def error_of_pole(self, Omega: float) -> float:
        """A bound of |δΩ| of an undamped natural frequency."""
        raise NotImplementedError

    def natural(self) -> list[float]:
        """The natural frequencies that are shown, in rad/s."""
        raise NotImplementedError

    def with_damper(self, other: Any, c: float) -> "FrequencyResponseFunction":
        """The same with c times the damper that the other has besides."""
        raise NotImplementedError

    def felt(self, other: Any) -> float:
        """How many times this damper is felt, neither weak nor strong."""
        raise NotImplementedError
