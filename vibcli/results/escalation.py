"""Values and extremes of signals with their bounds, computed in more digits where the bound of the floats exceeds what
is asked."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import Spent
from vibcli.results.known_digits import require_value

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.results.signal import Signal
    from vibcli.results.signals import LinearSignal

Found = TypeVar("Found")

ASKED = 1e-9            # of the largest value up to an instant: what a bound may be
DIGITS, MOST = 25, 40   # in which more are computed; steps of a million products that this may take by itself
ROUNDED = 2.0**-53      # relative: of the nearest float
FLAT = 1e-9             # relative: a change that rounds
SAMPLES = 65


class BoundedExtreme(NamedTuple):
    """Its instant and value, and the bounds of their errors."""

    time: float
    value: float
    error_of_time: float
    error: float

    def tells_instant(self, length: float) -> bool:
        """Is the instant known at all, of so long a time?"""
        return self.error_of_time < length


def is_constant(largest: Any, smallest: Any) -> bool:
    """Do the BoundedExtremes of a signal tell no more of its change than what rounds? No words in their stead do."""
    if not isinstance(largest, BoundedExtreme) or not isinstance(smallest, BoundedExtreme):
        return False
    gap, bound = largest.value - smallest.value, largest.error + smallest.error
    return gap == 0 or gap <= bound <= FLAT * max(abs(largest.value), abs(smallest.value))


def value_of_signal(signal: "Signal", t: "Fraction | float") -> tuple[float, float]:
    """(value, bound of its error) at an instant."""
    import numpy as np

    at = float(t)
    value, error = float(signal.values(np.array([at]))[0]), signal.error(at)
    size = _exceeded(signal, at, value, error)
    if size is None:
        return _known(signal, at, value, error)

    def finer() -> float:
        from fractions import Fraction

        from vibcli.analyses.transient.descriptor_system import real
        from vibcli.results.precise_instants import value_when

        return float(value_when(signal, lambda: real(Fraction(t)), DIGITS, MOST, size))

    found = _found(finer)
    return _known(signal, at, value, error) if found is None else (found, ROUNDED * abs(found) + size * 10.0**-DIGITS)


def _known(signal: "Signal", t: float, value: float, error: float) -> tuple[float, float]:
    """Both, where they tell a digit."""
    require_value(signal, t, value, error)
    return value, error


def extreme_of_signal(signal: "Signal", start: float, end: float, sense: int) -> BoundedExtreme:
    """The largest (sense 1) or smallest (−1) value between two instants."""
    time, value = signal.extreme(start, end, sense)
    error = signal.error_of_extreme(start, end, (time, value), sense)
    size = _exceeded(signal, time, value, error)
    if size is not None:
        from vibcli.results.precise_instants import extreme_to

        found = _found(lambda: extreme_to(signal, start, end, sense, DIGITS, size, MOST))
        if found is not None:
            time, value = map(float, found)
            return BoundedExtreme(time, value, ROUNDED * time, ROUNDED * abs(value))
    require_value(signal, end, value, error)
    return BoundedExtreme(time, value, signal.error_of_time(time), error)


def phasors_of_signal(signal: "LinearSignal") -> list[tuple[float, complex, float]]:
    """[(Ω, X, |δX|)] of the steady state Re Σ X e^{iΩt} of finitely many harmonics, by ascending Ω."""
    from vibcli.results.feature_errors import phasors

    errors = phasors(signal)
    found = [(Omega, X, errors.get(Omega, 0.0)) for Omega, X in signal.phasors]
    size = max((abs(X) for _, X, _ in found), default=0.0)
    if signal.source and any(error > ASKED * size for _, _, error in found):
        finer = _found(lambda: _finer_phasors(signal, found, size))
        return found if finer is None else finer
    return found


def _finer_phasors(signal: "LinearSignal", found: Sequence[tuple[float, complex, float]],
                   size: float) -> list[tuple[float, complex, float]]:
    from vibcli.results.precise_features import phasors
    from vibcli.results.precise_signals import agreed, precise_signal

    def parts() -> "list[mpmath.mpf]":
        return [part for _, X in phasors(precise_signal(signal.source)) for part in (X.real, X.imag)]

    numbers = iter(map(float, agreed(parts, DIGITS, size)))
    speeds = sorted({0.0, *(Omega for Omega, *_ in found)})
    finer = {Omega: complex(re, im) for Omega, re, im in zip(speeds, numbers, numbers, strict=True)}
    return [(Omega, finer[Omega], 2 * ROUNDED * abs(finer[Omega])) for Omega, *_ in found]


def _exceeded(signal: "Signal", t: float, value: float, error: float) -> float | None:
    """The largest of samples of a signal up to an instant, where the bound of its value there exceeds what is asked and
    more digits are found; else None."""
    if error <= ASKED * abs(value) or not signal.source:
        return None
    size = largest(signal, t)
    return size if error > ASKED * size else None


def largest(signal: "Signal", t: float) -> float:
    """The largest of samples of a signal up to an instant."""
    import numpy as np

    return float(np.abs(signal.values(np.linspace(0.0, t, SAMPLES))).max())


def _found(compute: Callable[[], Found]) -> Found | None:
    """What is computed; None where that is refused."""
    try:
        return compute()
    except (PhysicsError, Spent):
        return None
