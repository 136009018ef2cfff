"""Whether a digit is known of what is read off a motion: none is where the bound of its error, certain or estimated, is
as large as the signal becomes at all.

A value next to a passage through zero is small beside its bound, and is known where this is small beside the motion;
what is zero all along where it is small beside others of its kind.
"""

from contextlib import suppress
from math import inf
from typing import TYPE_CHECKING

from vibcli.base.errors import NoDigit, PhysicsError
from vibcli.notation.numbers import figure, rounded_up

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.results.signal import Signal

SAMPLES = 65
SMALL = 1e-3        # of terms as large as the largest coordinate: a bound as small tells that there is none


def require_digit(value: float, error: float, size: float, hint: str, what: str = "value") -> None:
    """NoDigit of a value whose error has a bound no less than the `size` of what it is one of, if any is known of this:
    what is zero all along tells none."""
    if error < abs(value) or not error:
        return
    if size and not error < size:
        told = f"may be off by {figure(rounded_up(error))}" if error < inf else "has an error without bound"
        raise NoDigit(f"no digit of this {what} is known: it {told}, and nothing it is one of is larger than "
                      f"{figure(size, digits=2)}", hint)


def require_value(signal: "Signal", t: float, value: float, error: float) -> None:
    """NoDigit of the value of a signal at an instant, or of an extreme there."""
    if error >= abs(value) and error:
        require_digit(value, error, size_of(signal, t), signal.MORE)


def size_of(signal: "Signal", t: float) -> float:
    """The largest of samples of a signal up to an instant and up to the end of its motion, or what tells its zeros."""
    try:
        found = signal.whole.told_zero(t)
    except PhysicsError:        # more than is known of it
        return 0.0
    return max(found, largest(signal, t)) if found < inf else found


def largest(signal: "Signal", t: float) -> float:
    """The largest of samples of a signal up to an instant and, as far as that is known, up to the end of its motion."""
    import numpy as np

    signal, found = signal.whole, 0.0
    with suppress(PhysicsError):
        for further in (False, True):
            end = max(t, signal.end or 0.0) if further else t
            found = max(found, float(np.abs(signal.values(np.linspace(0.0, end, SAMPLES))).max()))
    return found


def size_beside(signal: "Signal", t: float) -> float:
    """What a value is small beside that is lost in its error: a finite size_of, else the largest."""
    found = size_of(signal, t)
    return found if found < inf else largest(signal, t)


def share_of_terms(motion: "LinearMotion", output: "LinearOutput", t: float) -> float:
    """A bound that is small beside an output's terms, were they as large as those of the largest coordinate."""
    import numpy as np

    from vibcli.analyses.excitation.linear_output import LinearOutput

    times, found = np.linspace(0.0, t, SAMPLES), 0.0
    for order, row in enumerate((output.q, output.v, output.a)):
        if any(row.values()):
            sizes = [np.abs(motion.values(LinearOutput(q={i: 1.0}), times, order)).max() for i in range(len(motion.M))]
            found += float(max(sizes)) * sum(map(abs, row.values()))
    return SMALL * found


def known_alone(signal: "Signal", times: "np.ndarray", values: "np.ndarray") -> "np.ndarray":
    """Samples of a signal, NaN where no digit is known of those about them; NoDigit where none is known anywhere. What
    is zero all along is told."""
    import numpy as np

    parts = signal.LOOKED
    if not parts or not values.any():
        return values
    at = np.linspace(float(times[0]), float(times[-1]), parts + 1)
    errors, size = np.array([_error(signal, t) for t in at.tolist()]), float(np.abs(values).max())
    bad = ~(errors < size) & (errors > 0)
    if bad.any():
        bad = ~(errors < max(size, signal.told_zero(float(at[-1])))) & (errors > 0)
    if not bad.any():
        return values
    if bad.all():
        require_digit(0.0, float(errors.min()), size, signal.MORE)
    part = np.clip(np.searchsorted(at, times, side="right") - 1, 0, parts - 1)
    return np.where(bad[part] | bad[part + 1], np.nan, values)


def _error(signal: "Signal", t: float) -> float:
    try:
        return signal.error(t)
    except PhysicsError:
        return inf
