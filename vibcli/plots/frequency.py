"""A frequency response as a figure: magnitude above, phase lag below; or in the complex plane."""

import cmath
import math
from bisect import bisect
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.plots.figure import Curve, Figure, Mark, Panel
from vibcli.plots.prefixes import labelled, largest, readable, unit_text

if TYPE_CHECKING:
    import numpy as np

_SAME = 1.01


def of_frequency_response(Omega: "Sequence[int] | np.ndarray", H: "Mapping[str, list[float] | np.ndarray]", kind: str,
                          unit: str, peaks: Sequence[float] = (), antiresonances: Sequence[Any] = (),
                          title: str = "") -> Figure:
    """`H`: {label: complex values} at the angular frequencies Omega [rad/s], in one unit (or dimension); `kind`: what
    it is (receptance); `peaks`, `antiresonances`: angular frequencies to be marked.

    The phase is the lag θ = −arg H, X sin(Ωt − θ), in degrees, without jumps by whole turns.
    """
    log = min(Omega, default=0) > 0 and _spans(Omega, 10)
    magnitudes = {label: [abs(h) for h in values] for label, values in H.items()}
    together = [size for values in magnitudes.values() for size in values]
    y_log = _spans(together, 100)
    factor, unit = (1.0, unit_text(unit)) if y_log else readable(largest(together), unit_text(unit))
    marks = [Mark(at, f"{at:.4g}") for at in (*_distinct(peaks), *_distinct(antiresonances))]
    upper = Panel("Ω [rad/s]", labelled(kind, unit), log, y_log, marks=tuple(marks), curves=tuple(
        Curve(label, tuple(Omega), tuple(size * factor for size in values)) for label, values in magnitudes.items()))
    lags = {label: lag(values) for label, values in H.items()}
    lower = Panel("Ω [rad/s]", "phase lag [°]", log, degrees=True, tall=0.6, y_range=_turns(lags.values()),
                  marks=tuple(mark._replace(label="") for mark in marks),
                  curves=tuple(Curve(label, tuple(Omega), values) for label, values in lags.items()))
    return Figure(title, (upper, lower))


def _spans(values: "Sequence[float] | np.ndarray", ratio: float) -> bool:
    """Do the positive values span more than that ratio?"""
    values = [value for value in values if 0 < value < math.inf]
    return bool(values) and max(values) > ratio * min(values)


def _distinct(places: Sequence[float]) -> list[float]:
    """Peaks of several curves at nearly the same place are marked once."""
    found = []
    for place in sorted(places):
        if not found or place > _SAME * found[-1]:
            found.append(place)
    return found


def lag(values: "Sequence[complex] | np.ndarray") -> tuple[float, ...]:
    """−arg of complex numbers in degrees, from the first in (−180, 180] on without jumps of more than half a turn."""
    found, last = [], None
    for h in values:
        if h == 0 or not cmath.isfinite(h):
            found.append(math.nan)
            continue
        angle = -math.degrees(cmath.phase(h))
        angle = angle + 360 if angle < -180 + 1e-9 else angle
        if last is not None and not -180 <= angle - last <= 180:
            turns = (angle - last) / 360
            angle -= 360 * (math.ceil(turns - 0.5 - 1e-9) if turns > 0 else math.floor(turns + 0.5 + 1e-9))
        found.append(angle)
        last = angle
    return tuple(found)


def _turns(lags: Iterable[Any]) -> tuple[float, float]:
    """The range of phases, in whole quarter turns."""
    values = [angle for angles in lags for angle in angles if math.isfinite(angle)]
    low, high = min(values, default=0), max(values, default=180)
    low, high = 90 * math.floor(low / 90 + 1e-3), 90 * math.ceil(high / 90 - 1e-3)
    return (float(low), float(high)) if high > low else (low - 90.0, high + 90.0)


def nyquist(Omega: Any, H: "Mapping[str, list[float] | np.ndarray]", unit: str, at: Any = (),
            title: str = "") -> Figure:
    """The frequency response in the complex plane, {label: complex values}; `at`: angular frequencies whose points
    are marked with their values."""
    factor, unit = readable(largest([h for values in H.values() for h in values]), unit_text(unit))
    curves = [Curve(label, tuple(h.real * factor for h in values), tuple(h.imag * factor for h in values))
              for label, values in H.items()]
    points = [(_nearest(Omega, to), to) for to in _distinct(at)]
    marked = [(values[i] * factor, to) for values in H.values() for i, to in points]
    curves.append(Curve("", tuple(h.real for h, _ in marked), tuple(h.imag for h, _ in marked), "markers",
                        tuple(f"{to:.4g} rad/s" for _, to in marked)))
    panel = Panel(labelled("Re H", unit), labelled("Im H", unit), curves=tuple(curves), equal=True,
                  x_range=_with_zero(x for curve in curves for x in curve.x),
                  y_range=_with_zero(y for curve in curves for y in curve.y))
    return Figure(title, (panel,))


def _nearest(Omega: list[float], to: float) -> int:
    """The number of the one of ascending frequencies that lies nearest."""
    after = bisect(Omega, to)
    return min(range(max(after - 1, 0), min(after + 1, len(Omega))), key=lambda i: abs(Omega[i] - to))


def _with_zero(values: Iterable[float]) -> tuple[float, float] | None:
    values = [value for value in values if math.isfinite(value)]
    low, high = min(values, default=0.0), max(values, default=0.0)
    return (min(low, 0.0), max(high, 0.0)) if high > low else None
