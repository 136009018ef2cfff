"""The grid on which a motion by modes is searched: between instants of it no state that is still felt turns far, so
that it is fine where fast modes begin and wide once these have died out.
"""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.base.work import Task

TURN = 0.4          # of the fastest state that is felt, from place to place
FELT = 1e-15        # of all amplitudes: what is felt
FEWEST = 16         # cells
AT_ONCE, LEAST = 100_000, 12    # values of one mode each in a step; so many a cell counts for at least


def divided(cells: np.ndarray, motion: "ModalMotion", output: "LinearOutput", count: int,
            task: "Task | None" = None) -> np.ndarray:
    """Cells of time (…, 2), in order, in parts as narrow as the first modes need; none reaches over a jump or bend of
    the loads. task: what counts their values before there are any."""
    edges, steps = _steps(motion, output, cells[0, 0], cells[-1, 1], count)
    places = np.unique(np.concatenate([cells.ravel(), edges[(edges > cells[0, 0]) & (edges < cells[-1, 1])]]))
    low, high = places[:-1], places[1:]
    middle = (low + high) / 2
    within = middle < cells[np.searchsorted(cells[:, 0], middle, side="right") - 1, 1]
    low, high, middle = low[within], high[within], middle[within]
    parts = np.ceil((high - low) / steps[np.searchsorted(edges, middle, side="right") - 1]).astype(int)
    if task is not None:
        task.step(steps=float(parts.sum()) * max(count, LEAST) / AT_ONCE)
    number = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
    low, width = np.repeat(low, parts), np.repeat((high - low) / parts, parts)
    last = number + 1 == np.repeat(parts, parts)
    return np.stack([low + number * width, np.where(last, np.repeat(high, parts), low + (number + 1) * width)], axis=1)


def _steps(motion: "ModalMotion", output: "LinearOutput", start: float, end: float,
           count: int) -> tuple[np.ndarray, np.ndarray]:
    """(edges, steps): the step from each edge on."""
    states, widest = motion.states, (end - start) / FEWEST
    chosen = np.flatnonzero(states.modes < count)
    order = chosen[np.argsort(-np.abs(states.rates[chosen]))]
    rows, found = motion.rows_of(output)[0], []
    weights = np.abs(sum(rows[m, order] * states.rates[order]**m for m in range(len(rows))))
    for stretch in motion.stretches(end):
        loads = max((abs(stroke.exponent) for stroke in stretch.strokes), default=0.0)
        slowest = max(loads, TURN / widest)
        for tau, pace in paces(states.rates[order], weights * np.abs(stretch.free[order])):
            found.append((stretch.start + tau, TURN / max(pace, slowest)))
    edges, steps = np.array(found).T
    return edges, np.minimum(steps, widest)


def paces(rates: np.ndarray, sizes: np.ndarray) -> list[tuple[float, float]]:
    """(τ, |λ| of the fastest state that is felt from there on) of states in order, the fastest first."""
    speed, floor = np.abs(rates), FELT * sizes.sum()
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = np.where(sizes > floor, np.log(sizes / floor) / np.maximum(-rates.real, 0.0), 0.0)
    felt, found, at = np.maximum.accumulate(ends), [], 0.0
    while True:
        alive = np.flatnonzero(felt > at)
        if not len(alive):
            return [*found, (at, 0.0)]
        pace = speed[alive[0]]
        found.append((at, pace))
        slower = np.flatnonzero(speed < pace / 2)
        at = felt[slower[0] - 1] if len(slower) else felt[-1]
        if not np.isfinite(at):
            return found
