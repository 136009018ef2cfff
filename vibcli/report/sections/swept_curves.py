"""Quantities over one or two parameters as a figure: curves, contours, the lines of a Campbell diagram."""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from vibcli.base import units
from vibcli.notation.numbers import figure
from vibcli.plots.figure import Curve, Figure, Panel
from vibcli.plots.prefixes import labelled
from vibcli.plots.ticks import ticks
from vibcli.quantities.sweep import Sweep
from vibcli.report.sections.requested_signals import symbol
from vibcli.report.sections.sweep import branches_change, labels, unit_told

ORDERS = (1, 2)         # lines of a Campbell diagram


def sweep_figure(found: Sweep) -> Figure:
    """Curves over one parameter, a panel for each unit; over two, contours of each quantity."""
    panels = _contours(found) if len(found.axes) > 1 else _panels(found)
    return Figure(found.problem.spec.get("title") or "", tuple(panels))


def _panels(found: Sweep) -> Iterator[Panel]:
    axis, groups = found.axes[0], {}
    for number, unit in enumerate(found.units):
        groups.setdefault(unit, []).append(number)
    for unit, numbers in groups.items():
        curves = [curve for number in numbers for curve in _curves(found, number, numbers)]
        names = ", ".join(labels(found)[number] for number in numbers)
        yield Panel(labelled(symbol(axis.name), unit_told(axis)), labelled(names, unit if unit != "1" else ""),
                    axis.by_ratio, axis.by_ratio and _over_decades([y for curve in curves for y in curve.y if y == y]),
                    curves=(*_engine_orders(found, unit, numbers), *curves), x_range=(axis.shown[0], axis.shown[-1]))


def _over_decades(values: Sequence[float]) -> bool:
    """Are all positive, and the largest more than ten times the smallest?"""
    return bool(values) and 0 < 10 * min(values) < max(values)


def _curves(found: Sweep, number: int, together: Sequence[int]) -> list[Curve]:
    """The curve of a quantity; of natural modes that belong to branches, that of the branch of its number."""
    text, expression, x = labels(found)[number], found.asked[number], found.axes[0].shown
    breaks = [one.first for one in found.mode_counts if one.first] if found.numbered(expression) is not None else []
    kinds = {n: found.asked[n].tree.head for n in together if found.numbered(found.asked[n]) is not None}
    own = [n for n in together if kinds.get(n) == kinds.get(number)]
    if number not in kinds or not branches_change(found):
        return [Curve(text, *_broken(x, list(map(float, found.columns[number])), breaks))]
    branch = found.numbered(expression)
    y = [_of_branch(found, own, branch, k) for k in range(len(x))]
    return [Curve(f"{text.rstrip('₀₁₂₃₄₅₆₇₈₉')}, branch {branch}", *_broken(x, y, breaks))]


def _broken(x: Any, y: Any, places: Sequence[int]) -> tuple[Any, Any]:
    """(x, y) of a curve with a gap before each of these places."""
    for k in reversed(places):
        x, y = (*x[:k], x[k], *x[k:]), (*y[:k], math.nan, *y[k:])
    return tuple(x), tuple(y)


def _of_branch(found: Sweep, numbers: Sequence[int], branch: Any, k: int) -> float:
    return next((float(found.columns[n][k]) for n in numbers if found.branch(found.asked[n])[k] == branch),
                float("nan"))


def _engine_orders(found: Sweep, unit: str, numbers: Sequence[int]) -> list[Curve]:
    """The lines ω = Ω and 2Ω of a Campbell diagram, where a rate is swept over."""
    axis = found.axes[0]
    rate = found.problem.spec.dimensions.of(axis.name) == units.RATE
    if unit not in ("rad/s", "Hz") or not rate:
        return []
    top = max((float(np.nanmax(found.columns[n])) for n in numbers if np.isfinite(found.columns[n]).any()), default=0.0)
    per = np.array(axis.in_si) / (2 * np.pi if unit == "Hz" else 1.0)
    lines = []
    for order in ORDERS:
        y = np.where(order * per <= top, order * per, np.nan)
        last = int(np.flatnonzero(np.isfinite(y))[-1]) if np.isfinite(y).any() else 0
        lines.append(Curve(f"{order}×", axis.shown, tuple(map(float, y)), "guide",
                           tuple(f"{order}×" * (k == last) for k in range(len(y)))))
    return lines


def _contours(found: Sweep) -> Iterator[Panel]:
    """Lines of one value each over two parameters."""
    from contourpy import contour_generator

    down, across = found.axes
    for text, unit, values in zip(labels(found), found.units, found.columns, strict=True):
        made, curves = contour_generator(across.shown, down.shown, np.ma.masked_invalid(values)), []
        for level in _levels(values, across.by_ratio):
            x, y = [], []
            for line in made.lines(level):
                places = np.asarray(line)
                x += [*places[:, 0].tolist(), float("nan")]
                y += [*places[:, 1].tolist(), float("nan")]
            curves.append(Curve(f"{text} = {figure(level)}{'' if unit == '1' else ' ' + unit}", tuple(x), tuple(y)))
        yield Panel(labelled(symbol(across.name), unit_told(across)), labelled(symbol(down.name), unit_told(down)),
                    across.by_ratio, down.by_ratio, curves=tuple(curve for curve in curves if curve.x),
                    x_range=(across.shown[0], across.shown[-1]), y_range=(down.shown[0], down.shown[-1]))


def _levels(values: np.ndarray, by_ratio: bool) -> Sequence[float]:
    """Round values within those that are met; over parameters that grow by one ratio, parts of decades."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    if not low < high:
        return []
    decades = by_ratio and _over_decades([low, high])
    ends = (math.log10(low), math.log10(high)) if decades else (low, high)
    places = [place for place, _ in ticks(*ends, lambda found: len(found) <= 6, decades) if ends[0] < place < ends[1]]
    return [10.0 ** place for place in places] if decades else places
