"""The transfer function of one output to one input, H(s) = c(s)ᵀ (K + s C + s² M)⁻¹ b(s) + d(s), s = iΩ."""

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.frequency_response import poles_and_zeros
from vibcli.analyses.frequency_response.direct import SINGULAR, direct, scales
from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import is_load
from vibcli.mechanics.inputs_outputs.inputs import direct_part, input_columns, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.numerics.ascending import median

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.beside_rigid_motions import AtRest
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.mechanics.configuration import Configuration

FROM, MANY = 12, 64     # degrees of freedom and frequencies beyond which another method than LU of each takes less time
ERROR, ROUNDING = 1e-12, 1e-15


class TransferFunction(FrequencyResponseFunction):
    """M, C (gyroscopic terms included), K: (n, n) arrays; b, c: (3, n) coefficients of s⁰, s¹, s², d: (3,); modal: the
    ModalAnalysis of the scene it is of, which its errors are asked of."""

    __slots__ = ("C", "K", "M", "_asked", "_data", "_magnitudes", "_marks", "_method", "_modal", "b", "c", "d")

    def __init__(self, M: np.ndarray, C: np.ndarray, K: np.ndarray, b: np.ndarray, c: np.ndarray,
                 d: Any = (0.0, 0.0, 0.0), order: int = 0, modal: "ModalAnalysis | None" = None) -> None:
        super().__init__(order)
        self.M, self.C, self.K = (np.asarray(matrix, dtype=float) for matrix in (M, C, K))
        self.b, self.c, self.d = (np.asarray(part) for part in (b, c, d))
        self._modal = modal
        self._method: Any = None
        self._asked = 0
        self._data: Any = None
        self._magnitudes: Any = None
        self._marks: dict[Any, Any] = {}

    @property
    def n(self) -> int:
        return len(self.K)

    @property
    def magnitudes(self) -> tuple[list[np.ndarray], list[np.ndarray]]:
        """|diagonal| of K, C and M, and the largest of each row."""
        if self._magnitudes is None:
            parts = [np.abs(matrix) for matrix in (self.K, self.C, self.M)]
            self._magnitudes = [np.diag(part) for part in parts], [part.max(axis=1) for part in parts]
        return cast("tuple[list[np.ndarray], list[np.ndarray]]", self._magnitudes)

    @property
    def undamped(self) -> bool:
        odd = self.C.any() or self.b[1].any() or self.c[1].any() or self.d[1]
        return not odd and not any(np.iscomplexobj(part) and part.imag.any() for part in (self.b, self.c, self.d))

    @property
    def pace(self) -> float:
        return poles_and_zeros.pace(self)

    def at(self, s: np.ndarray, steep: bool = False) -> "tuple[np.ndarray, np.ndarray | None, np.ndarray]":
        """The method for many frequencies is chosen once and kept, of coordinates in a row at once."""
        if self._method is None and self.n >= FROM:
            from vibcli.analyses.frequency_response.coordinates_in_a_row import in_a_row

            self._asked += len(s)
            if self._asked > MANY or in_a_row(self):
                from vibcli.analyses.frequency_response.large_systems import chosen

                self._method = chosen(self) or direct
        found = (self._method or direct)(self, s, steep)
        for k in np.flatnonzero(s == 0):
            rest = self._once(TransferFunction._resting)
            if rest is not None:
                for part, value in zip(found, (rest.value, rest.slope, rest.resonant), strict=True):
                    if part is not None:
                        part[k] = value
        return found

    def fields(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc) at complex s, (N, n) each; of least squares where D is singular."""
        return (self._method or direct).fields(self, s)

    def poles(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        return _within(self._once(poles_and_zeros.poles), low, high)

    def zeros(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        return _within(self._once(poles_and_zeros.zeros), low, high)

    def endless(self, low: float = 0.0, high: float = math.inf) -> list[np.ndarray]:
        return [marks[(marks >= low) & (marks <= high)] for marks in self._once(poles_and_zeros.endless)]

    def _once(self, find: Callable[..., Any]) -> Any:
        if find not in self._marks:
            self._marks[find] = find(self)
        return self._marks[find]

    def _resting(self) -> "AtRest | None":
        """The AtRest of what nothing holds; None of what is held. No place of the circle is much nearer to a pole than
        the one on the axis, by which its error is bounded."""
        scale, = scales(self, np.zeros(1))
        if self._modal is None or np.linalg.cond(self.K * scale[:, None] * scale) < 1 / SINGULAR:
            return None
        from vibcli.analyses.frequency_response.beside_rigid_motions import at_rest, next_to_zero
        from vibcli.analyses.frequency_response.value_errors import of_values

        next_pole = next_to_zero(self._modal)
        return None if next_pole is None else at_rest(
            self, next_pole, lambda s: 2 * float(of_values(self, self.data, np.abs(s[:1]))[0]))

    @property
    def data(self) -> "DataErrors":
        """The DataErrors of the matrices, for what does not start."""
        if self._data is None:
            from vibcli.analyses.transient.data_errors import of_elements

            still = np.zeros(self.n)
            linear = self._modal.configuration.linear_system
            self._data = of_elements(linear, (self.M, self.C, self.K), (still, still), still)
        return cast("DataErrors", self._data)

    def error(self, Omega: float) -> float:
        return float(self.errors(np.array([Omega]))[0])

    def errors(self, Omega: np.ndarray) -> np.ndarray:
        from vibcli.analyses.frequency_response.value_errors import of_values

        found = of_values(self, self.data, Omega)
        rest = self._once(TransferFunction._resting) if (Omega == 0).any() else None
        return found if rest is None else np.where(Omega == 0, rest.error, found)

    def error_of_pole(self, Omega: float) -> float:
        modes = [mode for mode in self._modal.modes or () if mode.omega]
        near = min(modes, key=lambda mode: abs(float(mode.omega) - Omega), default=None)
        return Omega * (ERROR if near is None else max(float(near.error), ROUNDING))

    def natural(self) -> list[float]:
        modes = self._modal.modes or self._modal.damped or ()
        return [float(mode.omega) for mode in modes if mode.omega]

    def with_damper(self, other: Any, c: float) -> "TransferFunction":
        def part(name: str) -> np.ndarray:
            zero = getattr(self, name)
            return cast("np.ndarray", zero + c * (getattr(other, name) - zero))

        M, C, K, b, seen, d = map(part, ("M", "C", "K", "b", "c", "d"))
        return TransferFunction(M, C, K, b, seen, d, self.order)

    def felt(self, other: Any) -> float:
        """Such that c Ω is of the size of K."""
        added = np.abs(np.diag(other.C - self.C))
        stiff = np.abs(np.diag(self.K))
        both = (added > 0) & (stiff > 0)
        return median(stiff[both] / added[both]) / self.pace if both.any() else 1.0


def _within(marks: np.ndarray, low: float, high: float) -> np.ndarray:
    return marks[(marks.imag >= low) & (marks.imag <= high)]


def transfer(configuration: "Configuration", signal: str, driven_by: str, order: int = 0,
             modal: "ModalAnalysis | None" = None) -> FrequencyResponseFunction:
    """The FrequencyResponseFunction of a signal to a named input; modal: the ModalAnalysis about the same state."""
    if is_load(configuration.spec, signal_name(signal).still.text):
        raise PhysicsError(f"'{signal}' is that of a load, and no response to one", "ask for a coordinate, a place or "
                           "the force of a spring")
    if configuration.linear_system.pieces:
        from vibcli.analyses.frequency_response.member_transfer import member_transfer

        return member_transfer(configuration, signal_name(signal), driven_by, order, modal)
    row, chosen = linear_row(configuration, signal), named_input(configuration, driven_by)
    n = len(configuration.scene.q)
    M, C, K = configuration.linear_system.coefficients()
    b = _dense(input_columns(configuration, chosen), n)
    c = _dense((row.q, row.v, row.a), n)
    return TransferFunction(M, C, K, b, c, np.array(direct_part(row, chosen)), order, modal)


def _dense(parts: Sequence[dict[int, complex]], n: int) -> np.ndarray:
    kind = complex if any(isinstance(x, complex) for part in parts for x in part.values()) else float
    found = np.zeros((3, n), kind)
    for power, part in enumerate(parts):
        for i, x in part.items():
            if i < n:
                found[power, i] = x
    return found
