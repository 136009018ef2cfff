"""The transfer function of one output to one input, H(s) = c(s)ᵀ (K + s C + s² M)⁻¹ b(s) + d(s), s = iΩ.

An input cos Ωt gives the output Re(H e^{iΩt}) in the steady state: amplitude |H|, lag θ = −arg H.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import is_load
from vibcli.mechanics.inputs_outputs.inputs import direct_part, input_columns, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.configuration import Configuration


class TransferFunction:
    """M, C (gyroscopic terms included), K: (n, n) arrays; b, c: (3, n) coefficients of s⁰, s¹, s², d: (3,); `order`:
    how often the output is differentiated (receptance 0, mobility 1, accelerance 2)."""

    __slots__ = ("C", "K", "M", "_method", "b", "c", "d", "order")

    def __init__(self, M: np.ndarray, C: np.ndarray, K: np.ndarray, b: "Fraction", c: np.ndarray,
                 d: Any = (0.0, 0.0, 0.0), order: int = 0):
        self.M, self.C, self.K = (np.asarray(matrix, dtype=float) for matrix in (M, C, K))
        self.b, self.c, self.d = (np.asarray(part) for part in (b, c, d))
        self.order, self._method = order, None

    @property
    def n(self):
        return len(self.K)

    def evaluated_by(self, choose: Any = None):
        """How it is evaluated at many frequencies; that is chosen once, and None before if nobody chooses."""
        if self._method is None and choose is not None:
            self._method = choose(self)
        return self._method

    @property
    def undamped(self):
        """Are numerator and denominator functions of s² with real coefficients?"""
        odd = self.C.any() or self.b[1].any() or self.c[1].any() or self.d[1]
        return not odd and not any(np.iscomplexobj(part) and part.imag.any() for part in (self.b, self.c, self.d))


def polynomial(coefficients: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Σ coefficientₖ sᵏ; s (N,) gives (N, …)."""
    s = np.asarray(s).reshape(-1, *[1] * (np.ndim(coefficients) - 1))
    return coefficients[0] + s * (coefficients[1] + s * coefficients[2])


def slope(coefficients: np.ndarray, s: np.ndarray) -> np.ndarray:
    """The derivative of the same polynomial."""
    s = np.asarray(s).reshape(-1, *[1] * (np.ndim(coefficients) - 1))
    return coefficients[1] + 2 * s * coefficients[2]


def transfer(configuration: "Configuration", signal: str, driven_by: str, order: int = 0):
    """The TransferFunction of a signal to a named input."""
    if is_load(configuration.spec, signal_name(signal).still.text):
        raise PhysicsError(f"'{signal}' is that of a load, and no response to one", "ask for a coordinate, a place or "
                           "the force of a spring")
    row, chosen = linear_row(configuration, signal), named_input(configuration, driven_by)
    n = len(configuration.scene.q)
    M, C, K = system(configuration)
    b = _dense(input_columns(configuration, chosen), n)
    c = _dense((row.q, row.v, row.a), n)
    return TransferFunction(M, C, K, b, c, np.array(direct_part(row, chosen)), order)


def system(configuration: "Configuration"):
    """(M, C + G, K) of the small oscillations as arrays."""
    M, C, G, K = configuration.linear_system.arrays()
    return M, C + G, K


def _dense(parts, n):
    kind = complex if any(isinstance(x, complex) for part in parts for x in part.values()) else float
    found = np.zeros((3, n), kind)
    for power, part in enumerate(parts):
        for i, x in part.items():
            if i < n:
                found[power, i] = x
    return found
