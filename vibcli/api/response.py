"""Motions in time and frequency responses as arrays of NumPy, in SI units."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.api import given
from vibcli.api.values import given_expression
from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.language.document.mapping import text_of
from vibcli.reader.sections.find import RESPONSE
from vibcli.report.sections.requested_signals import curves_asked, trees_asked
from vibcli.report.sections.response import unknown
from vibcli.report.sections.sampled_series import sampled
from vibcli.report.wanted import Wanted

if TYPE_CHECKING:
    from numpy import ndarray
    from numpy.typing import ArrayLike

    from vibcli.report.sections.sampled_series import SampledSignal
    from vibcli.results.problem import Problem

END = "a time, as in 2 or '500 ms'"


class SampledResponse(Mapping[str, Any]):
    """A motion in time: `t`, an array of n instants [s], and for each signal an array of n values in SI units. The keys
    are the signals that `find` of the file asks for, else the coordinates; any other signal may be asked for."""

    def __init__(self, problem: "Problem", points: int = 1001) -> None:
        self._problem, self._points = problem, points
        self._series: dict[str, SampledSignal] = {}
        self.t: ndarray = self._sampled(next(iter(self))).times

    def _sampled(self, signal: str) -> "SampledSignal":
        if signal not in self._series:
            wanted = Wanted((given_expression(signal, "the signal"),), points=self._points)
            self._series[signal], = sampled(self._problem, wanted)
        return self._series[signal]

    def __getitem__(self, signal: str) -> "ndarray":
        values: ndarray = self._sampled(signal).values
        return values

    def __iter__(self) -> Iterator[str]:
        return (text for text, _ in trees_asked(self._problem, RESPONSE))

    def __len__(self) -> int:
        return len(trees_asked(self._problem, RESPONSE))

    def unit(self, signal: str) -> str:
        """The unit of the values of a signal."""
        return self._sampled(signal).unit

    @property
    def unknown(self) -> str | None:
        """Why the motion is not known up to the end asked for; None where it is."""
        refusal = unknown(self._problem, Wanted())
        return refusal.message if refusal else None


def response(problem: "Problem", until: float | str | None = None, points: int = 1001) -> SampledResponse:
    """The motion up to an instant: seconds, or a text with its unit."""
    if until is not None:
        problem = problem.until(instant(until))
    return SampledResponse(problem, points)


def instant(until: float | str) -> float:
    """An end of a motion [s]; SpecError where it is none."""
    try:
        return float(given.size(text_of(until) or "", "s", END))
    except ValueError as error:
        raise SpecError([Diagnostic(Where(f"until {until}", 1, 1, 0), str(error))]) from None


def frequency_response(problem: "Problem", signal: str, driver: str, omega: "ArrayLike | None" = None,
                       f: "ArrayLike | None" = None) -> "ndarray":
    """Complex H(iΩ) of a signal to a unit of an input, of the shape of `omega` [rad/s] or of `f` [Hz]."""
    import numpy as np

    if (omega is None) == (f is None):
        raise TypeError("give either omega=, angular frequencies in rad/s, or f=, frequencies in Hz")
    Omega = np.asarray(omega if f is None else 2 * np.pi * np.asarray(f, dtype=float), dtype=float)
    if not (np.isfinite(Omega) & (Omega >= 0)).all():
        raise ValueError("frequencies are finite and not negative")
    wanted = Wanted((given_expression(signal, "the signal"),), given_expression(driver, "the input"))
    (name, to, _), = curves_asked(problem, wanted)
    return problem.frequency_response(name, to).values(Omega.ravel()).reshape(Omega.shape)
