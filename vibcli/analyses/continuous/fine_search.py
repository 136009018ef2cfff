"""The largest value of a motion by very many modes within what fewer of them leave open: windows of time on equidistant
grids, twice as many modes at a time, each window as fine as its modes need and as narrow as those before left it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.modal_grid import FELT, TURN, paces
from vibcli.analyses.continuous.modal_search import BENT, bends, first_top
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.sums_of_exponentials import sum_of_exponentials
from vibcli.numerics.sums_on_grids import SumsOnGrid

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.continuous.modal_states import FreeStretch
    from vibcli.analyses.excitation.linear_output import LinearOutput

MOST, WINDOWS = 1 << 22, 32     # places of a level, and windows
MIXED = 8           # terms by which decays differ within a window at most,
ALIKE = 1e-13       # to this part of all amplitudes
PRODUCTS = 1 << 28  # of places and modes whose decays differ more, summed by products


def highest(motion: "ModalMotion", output: "LinearOutput", cells: np.ndarray, known: int,
            sense: int) -> tuple[float, float] | None:
    """(t, value) of the largest (sense 1) or smallest (−1) value within the cells that `known` modes leave, (…, 2);
    None where these are too many or too wide, or modes decay too differently."""
    counts = [known << k for k in range(1, 32) if known << k < motion.count] + [motion.count]
    values = room = np.zeros(0)
    for count in counts:
        windows = _windows(motion, cells)
        parts = [part for window in windows or () for part in _parts(motion, output, window, count)]
        if windows is None or sum((part.high - part.low) / part.step for part in parts) > MOST:
            return None
        found = [_on_part(motion, output, part, count) for part in parts]
        if any(one is None for one in found):
            return None
        cells, values, room = _left(found, sense)
    t, value = first_top(lambda t: sense * motion.values(output, t), cells, values, room)
    return t, sense * value


def _windows(motion: "ModalMotion", cells: np.ndarray) -> "list[tuple[float, float, FreeStretch]] | None":
    """[(start, end, its stretch)], the narrowest gaps closed; None where stretches are too many."""
    stretches = motion.stretches(float(cells[-1, 1]))
    starts = np.array([one.start for one in stretches])
    number = np.searchsorted(starts, cells.mean(axis=1), side="right") - 1
    gaps, same = cells[1:, 0] - cells[:-1, 1], number[1:] == number[:-1]
    if len(np.unique(number)) > WINDOWS:
        return None
    widest = np.sort(np.where(same, gaps, np.inf))[::-1][:WINDOWS - 1]
    closed = same & (gaps <= (widest[-1] if len(widest) == WINDOWS - 1 else 0.0))
    first = np.flatnonzero(np.append(True, ~closed))
    last = np.append(first[1:], len(cells)) - 1
    return [(float(cells[i, 0]), float(cells[j, 1]), stretches[number[i]]) for i, j in zip(first, last, strict=True)]


class EvenSpan(NamedTuple):
    """A part of a window between bends of the loads, on the stretch they leave, and the step that its states need."""

    low: float
    high: float
    stretch: "FreeStretch"
    step: float


def _parts(motion: "ModalMotion", output: "LinearOutput", window: "tuple[float, float, FreeStretch]",
           count: int) -> list[EvenSpan]:
    """The EvenSpans of a window at whose beginnings fast states have died out."""
    low, high, stretch = window
    weights, rates = motion.swings(output, stretch, count)
    order = np.argsort(-np.abs(rates))
    slowest = max([1 / (high - low), *(abs(stroke.exponent) for stroke in stretch.strokes)])
    begins, speeds = np.array(paces(rates[order], np.abs(weights[order]))).T
    edges = np.clip([*(stretch.start + begins), np.inf], low, high)
    return [EvenSpan(begin, end, stretch, TURN / max(speed, slowest))
            for begin, end, speed in zip(edges[:-1].tolist(), edges[1:].tolist(), speeds, strict=True) if begin < end]


def _on_part(motion: "ModalMotion", output: "LinearOutput", part: EvenSpan,
             count: int) -> tuple[np.ndarray, np.ndarray, float] | None:
    """(cells, values at their ends, rest): by so many modes, rest being what the others can add; None where modes decay
    too differently."""
    low, high, stretch, step = part
    places = max(3, int(np.ceil((high - low) / step)) + 1)
    weights, rates = motion.swings(output, stretch, count)
    weights, sizes = weights * np.exp(rates * (low - stretch.start)), np.abs(weights)
    felt = np.abs(weights) > FELT * sizes.sum()
    tau = (high - low) / (places - 1) * np.arange(places)
    swung = _swung(weights[felt], rates[felt], tau)
    if swung is None:
        return None
    values = swung + motion.without_swings(output, stretch, low + tau)
    cells = np.stack([low + tau[:-1], np.append(low + tau[1:-1], high)], axis=1)
    return cells, np.stack([values[:-1], values[1:]], axis=1), motion.bound(output, low, modes=count)


def _swung(weights: np.ndarray, rates: np.ndarray, tau: np.ndarray) -> np.ndarray | None:
    """Re Σ c e^{λτ} on a grid, as e^{λτ} = e^{(σ + iω)τ} Σ ((Re λ − σ)τ)ᵏ/k!, σ being the slowest decay."""
    sizes, slowest = np.abs(weights), float(rates.real.max()) if len(rates) else 0.0
    apart, left, terms = (slowest - rates.real) * tau[-1], sizes, 0
    while left.sum() > ALIKE * sizes.sum():
        terms += 1
        if terms > MIXED:
            return sum_of_exponentials(weights, rates, tau) if len(tau) * len(rates) <= PRODUCTS else None
        left = left * apart / terms
    found, shares, sums = np.zeros(len(tau)), np.ones(len(tau)), SumsOnGrid(rates.imag, tau[1], len(tau))
    for k in range(terms):
        found += shares * sums.of(weights)
        weights, shares = weights * (rates.real - slowest), shares * tau / (k + 1)
    return found * np.exp(slowest * tau)


def _left(found: Sequence[tuple[np.ndarray, np.ndarray, float]], sense: int) -> tuple[np.ndarray, ...]:
    """The cells that may hold the extreme, in order, the larger value at their ends in that sense, and how far it rises
    between them at most."""
    least = max(float((sense * values).max()) - rest for _, values, rest in found)
    kept = []
    for cells, values, rest in found:
        tops, room = (sense * values).max(axis=1), BENT * bends(cells, values)
        chosen = tops + room + rest >= least
        kept.append((cells[chosen], tops[chosen], room[chosen]))
    return tuple(np.concatenate(parts) for parts in zip(*kept, strict=True))
