"""Orbits in the phase plane of one degree of freedom by the rule of Dormand and Prince (1980), of the fifth order with
an error estimate of the fourth: all at once, each with steps of its own, forwards and backwards in time."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.state_field import StateField

STAGES = ((), (1 / 5,), (3 / 40, 9 / 40), (44 / 45, -56 / 15, 32 / 9),
          (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
          (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
          (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84))
ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
ACCURACY = 1e-9        # of a step, relative to the frame
STRIDE = 0.02          # of the frame, at most: so an orbit is a smooth line
MOST_STEPS, ROUNDS = 2500, 4000
NEAR = 1.2e-2           # of the frame: an orbit so near to where it ends is there
SHORTEST = 1e-14        # of the time of a stride
STILL = 1e-10           # of half the frame: a step so short is none


class PhaseFrame(NamedTuple):
    """What is shown: the ranges of q and of q̇."""

    q: tuple[float, float]
    v: tuple[float, float]

    @property
    def size(self) -> np.ndarray:
        """Half its width and height, of shape (2, 1)."""
        return 0.5 * np.array([[self.q[1] - self.q[0]], [self.v[1] - self.v[0]]])

    def beyond(self, state: np.ndarray, margin: float = 0.05) -> np.ndarray:
        """Which states, of shape (2, n), are outside, or no numbers?"""
        middle = 0.5 * np.array([[sum(self.q)], [sum(self.v)]])
        found: np.ndarray = ~(np.abs((state - middle) / self.size) <= 1 + margin).all(axis=0)
        return found


def followed(field: "StateField", starts: np.ndarray, senses: np.ndarray, frame: PhaseFrame,
             ends: Sequence[tuple[float, float]], lengths: np.ndarray, most: int = MOST_STEPS) -> list[np.ndarray]:
    """The orbits from starts (q, q̇) of shape (2, n), each an array of shape (2, points): forwards in time where its
    sense is 1, backwards where it is −1, until it leaves the frame, comes near to one of `ends`, is as many frames
    long as its length says, or has so many points at `most`."""
    run = _Run(field, starts, senses, frame, ends, lengths, most)
    for _ in range(ROUNDS):
        if not run.active.size:
            break
        run.step()
    return run.orbits()


class _Run:
    def __init__(self, field: "StateField", starts: np.ndarray, senses: np.ndarray, frame: PhaseFrame,
                 ends: Sequence[tuple[float, float]], lengths: np.ndarray, most: int) -> None:
        self.field, self.frame, self.lengths, self.scale = field, frame, lengths, frame.size
        self.state, self.senses = starts.astype(float), senses.astype(float)
        self.ends = np.array(ends, dtype=float).reshape(-1, 2).T
        self.active = np.flatnonzero(~frame.beyond(self.state))
        self.kept = [(np.arange(senses.size), self.state.copy())]
        self.gone, self.left = np.zeros(senses.size), np.full(senses.size, most)
        self.time = np.full(senses.size, np.inf)

    def _rate(self, state: np.ndarray, senses: np.ndarray) -> np.ndarray:
        found: np.ndarray = senses * np.stack((state[1], self.field.acceleration(state[0], state[1])))
        return found

    @np.errstate(all="ignore")      # a step to what is no number is taken back
    def step(self) -> None:
        here = self.active
        state, senses = self.state[:, here], self.senses[here]
        first = self._rate(state, senses)
        pace = np.sqrt(((first / self.scale) ** 2).sum(axis=0))
        stride = STRIDE / np.maximum(pace, 1e-300)
        dt = np.minimum(self.time[here], stride)
        rates = [first]
        for row in STAGES[1:]:
            new = state + dt * sum(c * k for c, k in zip(row, rates, strict=True) if c)
            rates.append(self._rate(new, senses))
        error = np.abs(dt * sum(c * k for c, k in zip(ERROR, rates, strict=True) if c) / self.scale).max(axis=0)
        error = np.where(np.isfinite(error), error / ACCURACY, np.inf)
        way = np.sqrt((((new - state) / self.scale) ** 2).sum(axis=0))
        good = (error <= 1) & (way <= 2 * STRIDE)
        factor = np.clip(0.9 * np.maximum(error, 1e-10) ** -0.2, 0.2, 4.0)
        self.time[here] = dt * np.where(way <= 2 * STRIDE, factor, 0.5)
        self._keep(here[good], new[:, good], way[good])
        stuck = (self.time[here] < SHORTEST * stride) | ~(pace > 0) | (good & (way < STILL))
        self.active = here[~(self._over(here) | stuck)]

    def _keep(self, here: np.ndarray, new: np.ndarray, way: np.ndarray) -> None:
        self.state[:, here] = new
        self.gone[here] += way
        self.left[here] -= 1
        self.kept.append((here, new))

    def orbits(self) -> list[np.ndarray]:
        """The points of each, in order."""
        numbers = np.concatenate([here for here, _ in self.kept])
        order = np.argsort(numbers, kind="stable")
        points = np.concatenate([new for _, new in self.kept], axis=1)[:, order]
        return np.split(points, np.flatnonzero(np.diff(numbers[order])) + 1, axis=1)

    def _over(self, here: np.ndarray) -> np.ndarray:
        state = self.state[:, here]
        over = self.frame.beyond(state) | (self.gone[here] > 2 * self.lengths[here]) | (self.left[here] <= 0)
        if self.ends.size:
            apart = (state[:, :, None] - self.ends[:, None, :]) / self.scale[:, :, None]
            over |= (np.sqrt((apart**2).sum(axis=0)) < NEAR).any(axis=1)
        found: np.ndarray = over
        return found
