"""Limit cycles that motions from unstable equilibria of one degree of freedom end in, by following one until its laps
repeat."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.integrated_orbits import PhaseFrame, followed
from vibcli.analyses.nonlinear.phase_portrait import CYCLE, StatePath

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.state_field import StateField

BESIDE, FAR = 1e-3, 5.0         # of the unit: where a motion starts, how far it is followed
LONG = 1000.0                   # frames
STRETCH, STRETCHES = 500, 10    # points after which it is looked whether laps repeat; how often
REPEATED = 3e-4                 # of a lap's width


def limit_cycles(field: "StateField", places: Sequence[float], unit: float) -> list[StatePath]:
    """The last laps of motions from beside equilibria, each once."""
    found: list[StatePath] = []
    for q in places:
        a_q, a_v = field.slopes(q)
        if not (a_q < 0 < a_v):
            continue
        reach, speed = FAR * unit, FAR * unit * math.sqrt(-a_q)
        lap = _repeated(field, np.array([[q + BESIDE * unit], [0.0]]),
                        PhaseFrame((q - reach, q + reach), (-speed, speed)))
        if lap is not None and not any(_same(lap, other) for other in found):
            found.append(lap)
    return found


def _repeated(field: "StateField", state: np.ndarray, frame: PhaseFrame) -> StatePath | None:
    """The lap that repeats itself; None where none does."""
    for _ in range(STRETCHES):
        path, = followed(field, state, np.ones(1), frame, (), np.array([LONG]), STRETCH)
        lap, state = _last_lap(field, *path), path[:, -1:]
        if lap is not None or path.shape[1] <= STRETCH:
            return lap
    return None


def _last_lap(field: "StateField", q: np.ndarray, v: np.ndarray) -> StatePath | None:
    """From one turning place on the right to the next, closed; None where it is another one than that before."""
    turns = np.flatnonzero((v[:-1] > 0) & (v[1:] <= 0))
    if turns.size < 3:
        return None
    near = np.where(v[turns] < -v[turns + 1], turns, turns + 1)
    ends = q[near] - v[near] ** 2 / (2 * field.acceleration(q[near], v[near]))
    inside = slice(turns[-2] + 1, turns[-1] + 1)
    width = float(np.ptp(q[inside]))
    if not np.all(np.abs(np.diff(ends[-3:])) <= REPEATED * width):
        return None
    places = np.concatenate((ends[-1:], q[inside], ends[-1:]))
    return StatePath(places, np.concatenate(([0.0], v[inside], [0.0])), CYCLE)


def _same(lap: StatePath, other: StatePath) -> bool:
    found: bool = abs(lap.q[0] - other.q[0]) <= 1e-2 * float(np.ptp(other.q))
    return found
