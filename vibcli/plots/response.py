"""Signals in time as a figure: one panel for each unit, the steady part and envelopes with their signal."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.plots.figure import Curve, Figure, Mark, Panel
from vibcli.plots.paper import fewer
from vibcli.plots.prefixes import labelled, largest, readable, unit_text

if TYPE_CHECKING:
    import numpy as np

_LONGEST = 30      # columns of a label that names every curve
_MOST_TURNS = 24   # of signals that share a panel
_BEYOND = 1.25     # of the time that is known: how far the axis goes on at most
_MOST_APART = 6    # signals of a unit that get panels of their own


def of_response(times: "Sequence[float] | np.ndarray",
                series: "Sequence[tuple[str, str | dict[str, Any], list[float] | np.ndarray]]",
                steady: Sequence[Any] | None = None, envelope: Sequence[Any] | None = None, title: str = "",
              until: float = 0.0) -> Figure:
    """`series`: [(label, unit or dimension, values)] at the times [s]; `steady` and `envelope`: for each of them the
    values of its steady part and of its bounds (one array: ±, or a pair: upper and lower), None where it has none.
    until: the end that was asked for [s]; where that is later a line marks up to when the motion is known."""
    steady, envelope = steady or [None] * len(series), envelope or [None] * len(series)
    factor, second = readable(largest(times), "s")
    t = _listed(times, factor)
    groups = {}
    for (label, unit, values), stays, bounds in zip(series, steady, envelope, strict=True):
        groups.setdefault(unit_text(unit) or ("rad" if unit == {} else ""), []).append((label, values, stays, bounds))
    panels = tuple(panel for unit, group in groups.items() for panel in _panels(t, labelled("t", second), unit, group))
    if t and until * factor > t[-1]:
        end, known = min(until * factor, _BEYOND * t[-1]), (Mark(t[-1], f"known up to {times[-1]:.4g} s"),)
        panels = tuple(panel._replace(x_range=(t[0], end), marks=known) for panel in panels)
    return Figure(title, panels)


def _listed(values: "np.ndarray | Sequence[float]", factor: float) -> list[float]:
    """Floats of Python times the factor: an array's own are slow."""
    return [value * factor for value in (values.tolist() if hasattr(values, "tolist") else values)]


def _panels(t: list[float], t_label: str, unit: str,
            group: "list[tuple[str, np.ndarray | list[float], list[float] | None, list[float] | None]]") -> list[Panel]:
    """One panel for the signals of a unit, or one for each, in the same scale, where they turn too often."""
    factor, unit = readable(max(largest(values) for _, values, _, _ in group), unit)
    together = _panel(t, t_label, unit, factor, group)
    if not 1 < len(group) <= _MOST_APART or max(turns(curve.y) for curve in together.curves) <= _MOST_TURNS:
        return [together]
    values = [y for curve in together.curves for y in curve.y if math.isfinite(y)]
    scale = (min(values), max(values)) if values and min(values) < max(values) else None
    return [_panel(t, t_label, unit, factor, [one])._replace(tall=0.6, y_range=scale) for one in group]


def turns(values: Sequence[float]) -> int:
    """How often a signal turns between up and down."""
    steps = [b - a for a, b in pairwise(values)]
    return sum(a * b < 0 for a, b in pairwise(steps))


def _panel(t: list[float], t_label: str, unit: str, factor: float,
           group: "list[tuple[str, np.ndarray | list[float], list[float] | None, list[float] | None]]") -> Panel:
    def curve(label: str, values: Any, kind: str) -> Curve:
        return Curve(label, *fewer(t, _listed(values, factor)), kind)

    several = len(group) > 1
    curves = [curve(label, values, "line") for label, values, _, _ in group]
    for label, _, stays, bounds in group:
        of = f"{label}, " if several else ""
        if stays is not None:
            curves.append(curve(f"{of}steady", stays, "steady"))
        if bounds is not None:
            upper, lower = bounds if len(bounds) == 2 else (bounds, [-value for value in bounds])
            curves += [curve(f"{of}envelope", upper, "envelope"), curve("", lower, "envelope")]
    names = ", ".join(dict.fromkeys(label.removesuffix(", transient") for label, *_ in group))
    label = labelled(names if len(names) <= _LONGEST else "", unit)
    return Panel(t_label, label, curves=tuple(curves))
