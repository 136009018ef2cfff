"""Deflections of elastic parts in series: Σ dᵢ = D while all forces Fᵢ(dᵢ) are one f, of rising Fᵢ with Fᵢ(0) = 0.

Newton's method on the logarithms of dᵢ and f, in which powers are straight lines, and where it does not settle nested
bisection: f lies between the least and the largest Fᵢ(D/n). Then Newton's method as it is, to rounding:

    f = Σ wᵢ Fᵢ + (D − Σ dᵢ)/Σ 1/Fᵢ′,  wᵢ = (1/Fᵢ′)/Σ 1/Fⱼ′        dᵢ ← dᵢ + (f − Fᵢ)/Fᵢ′
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

ROUNDS = 60         # of Newton's method on logarithms
FARTHEST = 8.0      # that one of its steps goes
NEAR = 1e-3         # of a logarithm: from there on it needs no guard
POLISHED = 12       # rounds to rounding, each of which doubles the digits
HALVINGS = 64


class NumberKind(NamedTuple):
    """Numbers of a kind: their logarithm, exponential and unit of rounding."""

    log: Callable[..., Any]
    exp: Callable[..., Any]
    unit: float


FLOATS = NumberKind(np.log, np.exp, 2.0**-53)


def deflections(laws: Callable[..., tuple[np.ndarray, np.ndarray]], total: np.ndarray, count: int,
                kind: NumberKind = FLOATS, near: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """(dᵢ of the shape (count, places), f) at the totals D; laws(d): (forces, slopes) of that shape; near: dᵢ at totals
    not far from them. NaN where they are not found."""
    with np.errstate(all="ignore"):
        if near is not None and near.shape[1:] == np.shape(total):
            d, f, settled = _polished(laws, near, total, kind)
            if settled:
                return d, f
        rests = total == 0
        whole = np.where(rests, total + 1, total)
        sense, size = np.where(whole < 0, -1, 1), abs(whole)
        logs = np.array([kind.log(size / count)] * count)
        logs, settled = _by_logarithms(laws, logs, sense, size, kind)
        if not np.all(settled):
            logs = np.where(settled, logs, kind.log(_halved(laws, sense, size, count, kind)))
        d, f, _ = _polished(laws, sense * kind.exp(logs), whole, kind)
        return np.where(rests, 0 * total, d), np.where(rests, 0 * total, f)


def _by_logarithms(laws: Callable[..., tuple[np.ndarray, np.ndarray]], logs: np.ndarray, sense: np.ndarray,
                   size: float | np.ndarray, kind: NumberKind) -> tuple[np.ndarray, bool | np.ndarray]:
    """(log |dᵢ|, where they have settled)"""
    for _ in range(ROUNDS):
        d = kind.exp(logs)
        forces, slopes = laws(sense * d)
        levels, steepness = kind.log(sense * forces), sense * d * slopes / forces
        share = d / d.sum(axis=0)
        level = (kind.log(size / d.sum(axis=0)) + (share * levels / steepness).sum(axis=0)) / (
            share / steepness).sum(axis=0)
        step = (level - levels) / steepness
        logs = logs + np.clip(step, -FARTHEST, FARTHEST)
        settled = np.all(abs(step) < NEAR, axis=0)
        if np.all(settled):
            break
    return logs, settled


def _halved(laws: Callable[..., tuple[np.ndarray, np.ndarray]], sense: np.ndarray, size: float | np.ndarray, count: int,
            kind: NumberKind) -> np.ndarray:
    """|dᵢ| by bisection of the force between those that the parts have at equal deflections."""
    forces = sense * laws(np.array([sense * size / count] * count))[0]
    low, high = forces.min(axis=0), forces.max(axis=0)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        d = _where_force_is(laws, middle, sense, size, count)
        short = d.sum(axis=0) < size
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    return d


def _where_force_is(laws: Callable[..., tuple[np.ndarray, np.ndarray]], force: float | np.ndarray, sense: np.ndarray,
                    size: float | np.ndarray, count: int) -> np.ndarray:
    """|dᵢ| ≤ D at which the parts have a force, by bisection."""
    low, high = np.array([0 * size] * count), np.array([size] * count)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        below = sense * laws(sense * middle)[0] < force
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    found: np.ndarray = (low + high) / 2
    return found


def _polished(laws: Callable[..., tuple[np.ndarray, np.ndarray]], d: np.ndarray, total: np.ndarray,
              kind: NumberKind) -> tuple[np.ndarray, np.ndarray, bool]:
    """(dᵢ, f, has it settled everywhere) to rounding: one round more than brings a step below √u."""
    last = False
    for _ in range(POLISHED):
        forces, slopes = laws(d)
        give = 1 / slopes
        f = (total - d.sum(axis=0) + (forces * give).sum(axis=0)) / give.sum(axis=0)
        step = (f - forces) * give
        d = d + step
        if last:
            break
        last = bool(np.all(abs(step) <= kind.unit**0.6 * abs(d)))
    return d, f, last
