"""Where a motion by modes is largest, smallest or zero: first by few modes on a wide grid, then, where these leave it
open, by more of them on finer grids, the remainder of each level being known.
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.modal_grid import divided

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput

LEVELS = 0, 1, 3, 12, 48, 192, 768      # modes
NARROWED, NARROWEST = 4, 1e-9   # by fewer modes cells are divided again, down to that part of the end,
PARTS, SHRUNK = 4, 0.7          # into so many parts, as long as no more of them is left
FEW = 48                        # modes on a window
MOST = 2_000                    # steps of 100,000 values
BENT = 0.5                      # of the largest second difference beside it: how far a value rises between places
NARROW = 40                     # sections of the last search
TOPS, RUNS = 4, 16              # tops that are looked at by their height, and by their time
LEVEL = 1e-12                   # of its size: what varies by less is at rest
NEAR = 1e-10                    # of an extreme: a bound that is near enough
WINDOWS, HALVES = 8, 40         # stretches whose beginnings are looked at apart, and times that these are halved
OCTAVES = 24                    # of a stretch, at which bounds are looked at
ALIKE = 0.99                    # of a bound: no smaller
BESIDE = 16                     # instants between zeros
NOTHING = 1e-6                  # of later values: an error that tells a start at zero
SMALL = 1e-3                    # of later values: an error that tells that a beam is at rest
FIRST, BY = 24, 16              # octaves from a start on, and parts of each, at which it is looked when it leaves zero


def extreme(motion: "ModalMotion", output: "LinearOutput", start: float, end: float,
            sense: int) -> tuple[float, float]:
    """(t, value) of the largest (sense 1) or smallest (−1) value."""
    cells = candidates(motion, output, start, end, sense)
    values = sense * motion.values(output, cells)
    t, value = first_top(lambda t: sense * motion.values(output, t), cells, values.max(axis=1),
                         BENT * bends(cells, values))
    return t, sense * value


def first_top(curve: "Callable[[np.ndarray], np.ndarray]", cells: np.ndarray, tops: np.ndarray,
              room: np.ndarray) -> tuple[float, float]:
    """(t, value) of the largest value of a curve within cells in order, (…, 2), the first of equal ones; tops: the
    larger value at the ends of each, room: how far the curve rises above it at most."""
    number = np.cumsum(np.append(0, cells[1:, 0] != cells[:-1, 1]))     # of the run of cells without a gap
    order = np.lexsort((-tops, number))
    best = order[np.append(True, np.diff(number[order]) > 0)]           # the best of each run
    likely = best[(tops + room)[best] >= tops.max()][:RUNS]
    chosen = np.union1d(likely, best[np.argsort(-tops[best])[:TOPS]])
    times = np.array([top_between(curve, *_about(cells, number, i)) for i in chosen])
    found = curve(times)
    first = int(np.argmax(found >= found.max() - LEVEL * np.abs(found).max()))
    return float(times[first]), float(found[first])


def _about(cells: np.ndarray, number: np.ndarray, i: int) -> tuple[float, float]:
    """From where to where a top is looked for: in a cell and those beside it in its run, as the highest end is one of
    two cells."""
    ends = [k for k in (i - 1, i + 1) if 0 <= k < len(cells) and number[k] == number[i]]
    return min(cells[k, 0] for k in (i, *ends)), max(cells[k, 1] for k in (i, *ends))


def candidates(motion: "ModalMotion", output: "LinearOutput", start: float, end: float, sense: int) -> np.ndarray:
    """The cells that may hold the largest (sense 1) or smallest (−1) value, whatever modes left out add, (…, 2)."""
    def high(cells: np.ndarray, values: np.ndarray, rest: float) -> np.ndarray:
        if np.ptp(values) + 2 * rest <= LEVEL * np.abs(values).max():
            return cast("np.ndarray", np.arange(len(cells)) == 0)
        tops = (sense * values).max(axis=1)
        return cast("np.ndarray", tops + BENT * bends(cells, values) >= tops.max() - 2 * rest)

    return _searched(motion, output, start, end, high)


def error_of_extreme(motion: "ModalMotion", output: "LinearOutput", start: float, end: float,
                     top: tuple[float, float], sense: int) -> float:
    """Of the value of an extreme `top`, (t, value): that at t, and how far errors elsewhere could lift the signal above
    it. What modes left out add never grows on a stretch; where it dies out, beginnings are looked at apart."""
    t, value = top
    begins = [max(start, low) for low, high in _spans(motion, end) if high > start]
    errors = motion.errors(output, np.array([*begins, t, end]))
    rounding = float(errors[-1]) - motion.bound(output, end)
    most, enough = float(errors.max()) + rounding, float(max(2 * errors[-2], 2 * errors[-1], NEAR * abs(value)))
    early = [(low, high) for low, high in _spans(motion, end) if high > start
             and motion.bound(output, max(start, low)) + rounding > enough]
    if most <= enough or len(early) > WINDOWS:
        return most
    above = [_lifted(motion, output, low, (max(start, low), high), enough, (sense, sense * value))
             for low, high in early]
    return max([enough, *(lifted + rounding for lifted in above)])


def zeros(motion: "ModalMotion", output: "LinearOutput", start: float, end: float) -> list[float]:
    """Instants at which it passes zero, or starts there; where it rests there but for its errors, the instant at which
    it leaves."""
    def near(cells: np.ndarray, values: np.ndarray, rest: float) -> np.ndarray:
        if np.abs(values).max() + rest == 0:
            return np.zeros(len(cells), bool)
        passes = values[:, 0] * values[:, 1] <= 0
        return cast("np.ndarray", passes | (np.abs(values).min(axis=1) <= BENT * bends(cells, values) + rest))

    left, begins = leaves(motion, output, start, end)
    cells = _searched(motion, output, left, end, near)
    if not len(cells):
        return begins
    edges = np.unique(cells)
    values = motion.values(output, edges)
    turns = np.flatnonzero(values[:-1] * values[1:] < 0)
    low, high, below = edges[turns], edges[turns + 1], values[turns]
    for _ in range(60):
        middle = (low + high) / 2
        same = motion.values(output, middle) * below > 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    if edges[0] == start and _starts_at_zero(motion, output, start, end):
        begins = [start]
    found = np.unique([*(low + high) / 2, *edges[values == 0], *begins])
    told = found[_told_apart(motion, output, found, end)].tolist()
    return [*begins, *told[1:]] if left > start else told


def leaves(motion: "ModalMotion", output: "LinearOutput", start: float, end: float) -> tuple[float, list[float]]:
    """(instant up to which a signal of beams stands at zero but for its errors, as octaves from the start on show, what
    it begins with): as waves come at once, its zeros up to there are without end, and are one with the last jump or
    bend of loads before; (start, []) where it does not."""
    if any(one.piece.order == 2 for one in motion.modes.basis.placed):
        return start, []
    times = start + (end - start) * 2.0 ** np.append(-np.inf, np.arange(-FIRST * BY, 1) / BY)
    values, off = np.abs(motion.values(output, times)), off_along(motion, output, times, end, motion.count)
    away = values > off
    if away[:2].any() or not away.any() or off[0] > SMALL * values.max():
        return start, []
    left = float(times[np.argmax(away) - 1])
    return left, [max(t for t in _beginnings(motion, left) if t <= left)]


def _starts_at_zero(motion: "ModalMotion", output: "LinearOutput", start: float, end: float) -> bool:
    """Is its first value zero but for its error, which is nothing beside later ones?"""
    values = np.abs(motion.values(output, np.linspace(start, end, BESIDE)))
    return cast("bool", values[0] <= _error_at(motion, output, start) <= NOTHING * values.max())


def _told_apart(motion: "ModalMotion", output: "LinearOutput", found: np.ndarray, end: float) -> np.ndarray:
    """Which of the zeros count: of those between which no value is larger than its error the last one, unless it stays
    so up to the end."""
    width = np.diff(np.append(found, end))
    times = found[:, None] + width[:, None] * ((np.arange(BESIDE) + 0.5) / BESIDE)
    values = np.abs(motion.values(output, times.ravel()))
    leaves = (values > off_along(motion, output, times.ravel(), end, motion.count)).reshape(times.shape).any(axis=1)
    left = np.flatnonzero(leaves)
    return cast("np.ndarray", leaves | (np.arange(len(found)) > (left[-1] if len(left) else -1)))


def width_of_top(motion: "ModalMotion", output: "LinearOutput", t: float, sense: int) -> float:
    """δ, within which an extreme lies."""
    return width_about(lambda at: motion.values(output, at), _error_at(motion, output, t), t, sense)


def width_of_zero(motion: "ModalMotion", output: "LinearOutput", t: float) -> float:
    """δ, within which a zero lies."""
    return width_about(lambda at: motion.values(output, at), _error_at(motion, output, t), t, 0)


def _error_at(motion: "ModalMotion", output: "LinearOutput", t: float) -> float:
    return float(motion.errors(output, np.array([t]))[0])


def width_about(curve: "Callable[[np.ndarray], np.ndarray]", error: float, t: float, sense: int) -> float:
    """δ, within which an extreme (sense ±1) or a zero (0) lies: of an extreme, a step away, on both sides, the value is
    less by more than its errors, or, at an end of the time that is asked, on one side less and on the other more; of a
    zero it has one sign and the other for certain."""
    away, value = (1e-12 if sense else 1e-15) * t, float(curve(np.array([t]))[0])
    while 0 < away < t:
        beside = curve(np.array([t - away, t + away]))
        less = sense * (value - beside)
        if (less > 4 * error).any() and (np.abs(less) > 4 * error).all() if sense else (
                beside.prod() < 0 and np.abs(beside).min() > 2 * error):
            return away
        away *= 2
    return t


def off_along(motion: "ModalMotion", output: "LinearOutput", times: np.ndarray, end: float, modes: int) -> np.ndarray:
    """Bounds of the errors of values by so many modes at instants up to an end: what modes left out add never grows on
    a stretch, so that it is looked at where stretches begin and, of few, at instants on them, each twice as far on."""
    first = float(np.min(times, initial=end))
    spans = [(low, high) for low, high in _spans(motion, end) if high > max(low, first)] or [(0.0, end)]
    octaves = 2.0 ** -np.arange(OCTAVES if len(spans) <= WINDOWS else 0)
    begins = np.unique([t for low, high in spans for t in (low, *(low + (high - low) * octaves[1:]))])
    rounding = float(motion.errors(output, np.array([end]))[0]) - motion.bound(output, end)
    found = np.array([motion.bound(output, t, modes=modes) for t in begins])
    return found[np.maximum(np.searchsorted(begins, times, side="right") - 1, 0)] + rounding


def _searched(motion: "ModalMotion", output: "LinearOutput", start: float, end: float,
              chosen: "Callable[[np.ndarray, np.ndarray, float], np.ndarray]") -> np.ndarray:
    """The cells left when all modes are counted, `chosen` saying which of those of a level are."""
    cells, total = np.array([[start, end]]), motion.count
    begins = [start, *(t for t in _beginnings(motion, end) if t > start)]
    with motion.work.task("the search along a motion by modes", MOST) as task:
        for count in [*(level for level in LEVELS if level < total), total]:
            cells = divided(cells, motion, output, count, task)
            rest = max(motion.bound(output, t, modes=count) for t in begins)
            while True:
                before = _widths(cells).sum()
                cells = cells[chosen(cells, motion.values(output, cells, modes=count), rest)]
                left = _widths(cells)
                if (count >= NARROWED or not len(cells) or left.min() <= NARROWEST * end
                        or left.sum() > SHRUNK * before):
                    break
                cells = _in_parts(cells)
                task.step(steps=len(cells) / 1e5)
            if not len(cells):
                break
    return cells


def _widths(cells: np.ndarray) -> np.ndarray:
    return cast("np.ndarray", cells[:, 1] - cells[:, 0])


def _in_parts(cells: np.ndarray) -> np.ndarray:
    """Each of the cells in equal parts."""
    edges = cells[:, :1] + _widths(cells)[:, None] * (np.arange(PARTS + 1) / PARTS)
    edges[:, -1] = cells[:, 1]
    return np.stack([edges[:, :-1].ravel(), edges[:, 1:].ravel()], axis=1)


def _lifted(motion: "ModalMotion", output: "LinearOutput", stretch: float, window: tuple[float, float], enough: float,
            top: tuple[float, float]) -> float:
    """How far a signal can come above its top, (sense, value in that sense), on a stretch before what modes left out
    add is small enough: window by window, each half as wide as the next, as it dies out."""
    low, high = window
    highest, least = -np.inf, ALIKE * motion.bound(output, low)
    for _ in range(HALVES):
        middle = low + (high - low) / 2
        rest = motion.bound(output, middle)
        if rest > enough:
            highest = max(highest, min(rest, _reached(motion, output, stretch, (middle, high), top)))
        high = middle
        if rest >= least:
            break
    return max(highest, min(motion.bound(output, low), _reached(motion, output, stretch, (low, high), top)))


def _reached(motion: "ModalMotion", output: "LinearOutput", stretch: float, window: tuple[float, float],
             top: tuple[float, float]) -> float:
    """The same between two instants of a stretch, by its first modes on a grid."""
    count, (sense, value) = min(FEW, motion.count), top
    cells = divided(np.array([window]), motion, output, count)
    values = sense * motion.values(output, cells, modes=count)
    rest = motion.bound(output, window[0]) + motion.left(output, stretch, window[0], count)
    return float((values.max(axis=1) + BENT * bends(cells, values)).max()) + rest - value


def _spans(motion: "ModalMotion", end: float) -> list[tuple[float, float]]:
    """(begin, end) of the stretches up to an end."""
    begins = _beginnings(motion, end)
    return list(zip(begins, [*begins[1:], end], strict=True))


def _beginnings(motion: "ModalMotion", end: float) -> list[float]:
    """Instants at which stretches begin."""
    return [stretch.start for stretch in motion.stretches(end) if stretch.start <= end]


def bends(cells: np.ndarray, values: np.ndarray) -> np.ndarray:
    """How far the second differences beside each cell lie from zero; those at a gap count with the widest."""
    if len(cells) < 3:
        return np.full(len(cells), np.ptp(values))
    width = cells[:, 1] - cells[:, 0]
    inner = np.abs(np.diff((values[:, 1] - values[:, 0]) / width))
    return cast("np.ndarray", width * np.maximum(np.append(inner, inner[-1]), np.append(inner[0], inner)))


def top_between(curve: "Callable[[np.ndarray], np.ndarray]", low: float, high: float) -> float:
    """The place of the largest value between two, by sections; at a flat top by the parabola through its shoulders."""
    for _ in range(NARROW):
        places = np.linspace(low, high, 9)
        values = curve(places)
        at = int(np.argmax(values))
        low, high = places[max(at - 1, 0)], places[min(at + 1, 8)]
        if np.ptp(values) <= 1e-9 * np.abs(values).max():
            break
    if 0 < at < 8:
        fit = np.polyfit(np.linspace(-1, 1, 9), values, 2)
        if fit[0] < 0 and abs(fit[1]) <= 2 * abs(fit[0]):
            return float(places[4] - fit[1] / (2 * fit[0]) * (places[8] - places[0]) / 2)
    return float(places[at])
