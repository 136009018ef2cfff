"""The phase plane as a figure: orbits with arrows of their direction, lines that are told apart, equilibria by name."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.plots.figure import Curve, Figure, Panel
from vibcli.plots.prefixes import labelled, readable

TALL = 1.3
INSIDE = 0.96           # of the frame: where arrows may stand
EARLY = 0.9             # of half the frame: from where an orbit begins to its arrow, at most
HEAD = 0.02             # likewise: how long an arrow is
TRIALS = (0, 1, -1, 2, -2, 3, -3)       # steps along the line to where an arrow is clear of others
MOST_NAMED, NEAREST = 7, 0.07           # points with names beside them; of the width: how near they may be
CLEAR = 0.09            # likewise: how far arrows are from each other and from points


class PlaneLines(NamedTuple):
    """What one entry of the legend stands for: lines (q, q̇) in the order of time; `kind`: that of a Curve; at_end: do
    its arrows stand near where they end? None: it has none. One without lines keeps its colour free."""

    label: str
    lines: list[Any]
    kind: str = "line"
    at_end: bool | None = False


def of_phase_plane(names: tuple[str, str], units: tuple[str, str], ends: tuple[float, float], speed: float,
                   lines: Sequence[PlaneLines], points: Sequence[Sequence[tuple[float, str]]], title: str) -> Figure:
    """`names` and SI units of q and q̇; `ends` of q; up to which speed; points: [(q, its name)] of each
    marker."""
    fx, x_unit = readable(max(map(abs, ends)), units[0])
    fy, y_unit = readable(speed, units[1])
    scale = np.array([[0.5 * (ends[1] - ends[0])], [speed]])
    middle = np.array([[0.5 * sum(ends)], [0.0]])
    taken = [(np.array([[q], [0.0]]) - middle) / scale for found in points for q, _ in found]
    shown = [(line, one.at_end) for one in lines if one.at_end is not None for line in one.lines]
    arrows = [arrow for line, at_end in shown for arrow in _arrows(line, middle, scale, at_end, taken)]
    curves = [_joined(one, fx, fy) for one in lines]
    curves += [Curve("", tuple(fx * arrow[0]), tuple(fy * arrow[1]), "arrow") for arrow in arrows]
    curves += [_markers(found, fx, _is_crowded(points, ends)) for found in points]
    return Figure(title, (Panel(
        labelled(names[0], x_unit), labelled(names[1], y_unit), curves=tuple(curves), tall=TALL,
        x_range=(fx * ends[0], fx * ends[1]), y_range=(-fy * speed, fy * speed)),))


def _is_crowded(points: Sequence[Sequence[tuple[float, str]]], ends: tuple[float, float]) -> bool:
    """Is there no room for names beside points?"""
    places = sorted(q for found in points for q, name in found if name)
    near = NEAREST * (ends[1] - ends[0])
    return len(places) > MOST_NAMED or any(b - a < near for a, b in pairwise(places))


def _markers(found: Sequence[tuple[float, str]], factor: float, crowded: bool) -> Curve:
    """Points with names beside them, or in the legend."""
    names = tuple(name for _, name in found)
    told = " / ".join(dict.fromkeys(name for name in names if name)) if crowded else ""
    return Curve(told, tuple(factor * q for q, _ in found), (0.0,) * len(found), "markers", () if crowded else names)


def _joined(one: PlaneLines, fx: float, fy: float) -> Curve:
    """All lines of an entry as one Curve, NaN between."""
    x, y = [], []
    for q, v in one.lines:
        x += [*(fx * np.asarray(q)).tolist(), np.nan]
        y += [*(fy * np.asarray(v)).tolist(), np.nan]
    return Curve(one.label, tuple(x), tuple(y), one.kind)


def _arrows(line: tuple[np.ndarray, np.ndarray], middle: np.ndarray, scale: np.ndarray, at_end: bool,
            taken: list[np.ndarray]) -> Iterator[np.ndarray]:
    """[array of the two points of an arrow] along a line, no nearer to what is `taken` than they may be; they are added
    to it."""
    path = (np.stack(line) - middle) / scale
    closed = path.shape[1] > 2 and bool(np.abs(path[:, 0] - path[:, -1]).max() < 1e-9)
    path = path if closed else _inside(path)
    ways = np.concatenate(([0.0], np.cumsum(np.sqrt((np.diff(path) ** 2).sum(axis=0)))))
    if not ways[-1] > 4 * HEAD:
        return
    half = min(0.5 * ways[-1], EARLY)
    for way in (0.25 * ways[-1], 0.75 * ways[-1]) if closed else (ways[-1] - half if at_end else half,):
        near = [way + step * CLEAR for step in TRIALS]
        trials = [(one, _at(path, ways, one)) for one in near if HEAD < one < ways[-1]]
        found = next(((one, place) for one, place in trials if _is_clear(place, taken)), None)
        if found is not None:
            taken.append(found[1])
            yield middle + scale * np.concatenate((_at(path, ways, found[0] - HEAD), found[1]), axis=1)


def _is_clear(place: np.ndarray, taken: list[np.ndarray]) -> bool:
    return np.abs(place).max() <= INSIDE and not any(((place - other) ** 2).sum() < CLEAR**2 for other in taken)


def _at(path: np.ndarray, ways: np.ndarray, way: float) -> np.ndarray:
    return np.array([[np.interp(way, ways, row)] for row in path])


def _inside(path: np.ndarray) -> np.ndarray:
    """The longest part of it within the frame."""
    inside = (np.abs(path) <= 1).all(axis=0)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], inside, [False])).astype(int)))
    starts, ends = edges[::2], edges[1::2]
    if not starts.size:
        return path[:, :1]
    k = int((ends - starts).argmax())
    return path[:, starts[k]:ends[k]]
