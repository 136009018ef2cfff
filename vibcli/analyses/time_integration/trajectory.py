"""A motion in time: its state at any instant, its energy balance, its events."""

from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import moves
from vibcli.base.errors import Unknown
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium.redundant_friction import Redundancy
from vibcli.numerics.collocation_rule import rule
from vibcli.symbolic.compiled_arrays import Compiled

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.forcing_breaks import Breaks
    from vibcli.analyses.time_integration.time_stepping import March

POINTS = 40             # at most in a window
FEW, SMALL = 4, 20_000  # instants in a window; numbers that are summed each by itself
BESIDE = 1e-9           # of half a window
LATE, CLOSE = 1e-12, 1e-9       # after its end; of a window: from its start


class Event(NamedTuple):
    """Something that happens at an instant: `kind` is what, `name` to which element."""

    time: float
    kind: str
    name: str


class Balance(NamedTuple):
    """E(t) − E(0) = work of the loads − dissipated + work of what drives the motion, at the ends of all windows.

    error: the largest difference of both sides, relative to the largest of all these energies; of what rests, where all
    but T + V are nothing but rounding, to T + V, or to the terms that cancel in it; `driven`: does the motion depend on
    the time by what drives it? The energy then is Σ q̇ ∂T/∂q̇ − T + V."""

    times: np.ndarray
    energy: np.ndarray
    work: np.ndarray
    dissipated: np.ndarray
    driving: np.ndarray
    error: float

    @property
    def gap(self) -> float:
        """The largest difference of both sides [J]."""
        return float(np.abs(self.energy - self.energy[0] - self.work + self.dissipated - self.driving).max())


class Trajectory:
    """names: the coordinates; windows: their polynomials; until: the end asked for, and `end` that which was reached,
    earlier where a rope goes slack; events; balance; drift: the largest gaps of the constraints
    (positions, velocities) relative to the motion, None without closed loops; shared: with a second solution; sizes:
    those of the motion; coarse: are windows in it as coarse as is asked? breaks: of what drives it; struck: (t, q,
    q̇ before, q̇ after) of each blow; fast: the oscillation that was stepped over, None where all is followed; rests: the
    instant up to which it stays in the equilibrium in which it starts."""

    shared: Any

    def __init__(self, march: "March", until: float, events: Sequence[Event], rests: float, breaks: "Breaks",
                 balance: Balance | None = None, drift: Any = None) -> None:
        self.system, self.switching, self.windows = march.system, march.switching, march.windows
        self.breaks, self.struck = breaks, tuple(march.struck)
        self.coarse = march.coarse
        self.names, self.sizes, self.fast = list(march.system.scene.coordinates), march.sizes, march.fast
        self.until, self.end, self.events, self.rests = until, until, tuple(events), rests
        self.balance, self.drift, self.reason, self.advice, self.shared = balance, drift, None, None, None
        self.lengths = np.array([window.length for window in self.windows])
        self.starts = np.array([window.start for window in self.windows])
        self._known = np.zeros(len(self.windows), dtype=bool)

    def at(self, times: Sequence[float] | np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(q, q̇, q̈), each of shape (coordinates, times), at times within 0 and `until` [s]."""
        times = np.atleast_1d(np.asarray(times, dtype=float))
        late = times.max(initial=0.0)
        if late > self.end * (1 + LATE):
            raise self.unknown(late)
        number = self._numbers(times)
        if (number[1:] < number[:-1]).any():
            order = np.argsort(number, kind="stable")
            found = np.empty((3, len(self.names), len(times)))
            found[:, :, order] = self.at(times[order])
            return found[0], found[1], found[2]
        tau, speeds = times - self.starts[number], self._speeds[number].T
        q, v, a = self._summed(number, 2 * tau / self.lengths[number] - 1).reshape(3, len(self.names), -1)
        return q + (self._places[number].T + tau * speeds), v + speeds, a

    def _summed(self, number: np.ndarray, x: np.ndarray) -> np.ndarray:
        """q − q₀ − τ q̇₀, q̇ − q̇₀ and q̈, as rows, at places x in windows of ascending numbers."""
        every, found = rule(POINTS), np.empty((3 * len(self.names), len(x)))
        cuts = np.flatnonzero(np.concatenate([[True], number[1:] != number[:-1], [True]]))
        if len(x) == POINTS * (len(cuts) - 1):
            beside = x.reshape(-1, POINTS) - every.x
            if np.abs(beside).max(initial=0.0) <= BESIDE:       # at the points, but for the rounding of the times
                rows = self._moves(number[cuts[:-1]]).swapaxes(0, 1)
                near: np.ndarray = rows @ every.at_points[0] + (rows @ every.at_points[1]) * beside
                return near.reshape(len(found), -1)
        P = every.basis(x)
        if len(x) <= FEW * len(cuts) and found.size <= SMALL:
            result: np.ndarray = np.einsum("kij,kj->ki", self._moves(number), np.ascontiguousarray(P.T)).T
            return result
        for (first, last), rows in zip(pairwise(cuts.tolist()), self._moves(number[cuts[:-1]]), strict=True):
            np.matmul(rows, P[:, first:last], out=found[:, first:last])
        return found

    @cached_property
    def _places(self) -> np.ndarray:
        return np.array([window.q for window in self.windows])

    @cached_property
    def _speeds(self) -> np.ndarray:
        return np.array([window.v for window in self.windows])

    def _moves(self, numbers: np.ndarray) -> np.ndarray:
        """Legendre coefficients of q − q₀ − τ q̇₀, q̇ − q̇₀ and q̈ of windows, as rows of each."""
        missing = np.unique(numbers[~self._known[numbers]])
        if len(missing):
            self._rows[missing] = moves([self.windows[k] for k in missing.tolist()], POINTS + 2)
            self._known[missing] = True
        found: np.ndarray = self._rows[numbers]
        return found

    @cached_property
    def _rows(self) -> np.ndarray:
        """Those that are known, of all windows."""
        return np.empty((len(self.windows), 3 * len(self.names), POINTS + 2))

    def number(self, t: float) -> int:
        """Of the window in which an instant lies."""
        return int(self._numbers(np.array([t]))[0])

    def about(self, t: float) -> list[int]:
        """Of the windows in which an instant lies, two where one ends and the next begins."""
        k = self.number(t)
        return [k - 1, k] if k and t - self.starts[k] <= CLOSE * self.lengths[k] else [k]

    def _numbers(self, times: np.ndarray) -> np.ndarray:
        """Of the windows in which the times lie."""
        return np.maximum(np.searchsorted(self.starts, times, side="right") - 1, 0)

    def held(self, times: np.ndarray) -> dict[int, np.ndarray]:
        """{number of a switch: σ by which it is held at the times, NaN where it is not}."""
        found, number = {}, self._numbers(times)
        for i in np.unique(number):
            window = self.windows[i]
            if window.slides:
                here = number == i
                q, v, _ = self.at(times[here])
                sigma = self.switching.sliding(window.slides, times[here], q, v, window.g)[1]
                for k, values in zip(window.slides, sigma, strict=True):
                    found.setdefault(k, np.full(times.shape, np.nan))[here] = values
        return self._with_carried(found, number, times) if found and self.friction.possible else found

    @cached_property
    def friction(self) -> Redundancy:
        """The Redundancy of the signs of speeds."""
        return Redundancy(self.system.scene, self.system.parts.h, self.system.parts.slopes)

    def _with_carried(self, found: dict[int, np.ndarray], number: np.ndarray,
                      times: np.ndarray) -> dict[int, np.ndarray]:
        """Those as well whose arguments vanish as others are held: they go on with the sense that they had."""
        scene, parts, none = self.system.scene, self.friction.parts, np.full(times.shape, np.nan)
        places = {name + "'" * primes: row for primes, rows in enumerate(self.at(times)[:2])
                  for name, row in zip(self.names, rows, strict=True)}
        switches = {argument: k for k, argument in enumerate(self.system.switches[:self.switching.count])}
        numbers = [switches.get(part.argument) for part in parts]
        held = np.array([~np.isnan(found.get(k, none)) for k in numbers])
        carried = self.friction.carried({**self.system.floats, scene.time.name: times, **places}, len(times), held)
        for k, before, after in zip(numbers, held, carried, strict=True):
            if k is not None and (after & ~before).any():
                senses = np.array([self.windows[i].g[k] for i in number])
                found[k] = np.where(after & ~before, senses, found.get(k, none))
        return found

    def cut(self, instant: float, name: str) -> None:
        """End at the instant at which a rope goes slack."""
        self.stop(instant, f"the rope '{name}' goes slack at t = {instant:.6g} s",
                  "let the rope be an elastic one: a spring that `acts: tension`")
        self.events = (*(event for event in self.events if event.time <= instant), Event(instant, "slack", name))

    def share(self, shared: Any) -> None:
        """Know what is `shared` with a second solution, and end where that is too little."""
        self.shared, horizon = shared, shared.horizon
        if horizon is not None and horizon != shared.lost_from:
            self.stop(horizon, f"the accuracy {shared.asked:g} that is asked is held up to t = {horizon:.4g} s alone",
                      "ask for earlier instants, or for less accuracy")
        elif horizon is not None:
            why = ("the last digits of its data leave less than three of them" if shared.folding is None else
                   f"neighbouring motions part e-fold every {shared.folding:.1g} s")
            self.stop(horizon, f"digits run out at t ≈ {horizon:.4g} s: {why}", "ask for earlier instants: the motion "
                      "is chaotic, or leaves an unstable place")

    def stop(self, instant: Any, reason: Any, advice: Any) -> None:
        """End at an instant, for a reason that is told where more is asked for."""
        self.end, self.reason, self.advice = instant, reason, advice

    def unknown(self, t: float) -> Unknown:
        """The refusal of an instant after the end."""
        reason = self.reason or f"this motion was followed up to t = {self.end:.6g} s"
        joint = ";" if ": " in reason else ":"
        return Unknown(f"{reason}{joint} its motion is not known at t = {t:.6g} s",
                       self.advice or "follow it for longer")

    def values(self, nodes: Sequence[complex], times: np.ndarray) -> list[np.ndarray]:
        """Expressions of the coordinates, velocities and the time at the times: an array for each."""
        compiled = Compiled(self.system.scene, self.system.floats, None, nodes)
        times = np.atleast_1d(np.asarray(times, dtype=float))
        q, v, _ = self.at(times)
        return [np.broadcast_to(value, times.shape) for value in compiled(times, q, v)]
