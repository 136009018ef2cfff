"""An output of a linear motion between two instants, and the stretches of time into which its searches divide that."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.exponential_sum import ExponentialSum
    from vibcli.analyses.transient.forcing_arrays import Timeline
    from vibcli.base.work import Task

EPSILON = 2.0**-52
NEWTON = 60
PARTS, LEVELS = 4, 60           # of a division, and divisions
MOST, STEP = 500_000, 1000      # steps of a search, and values of one exponential each that are found in one of them
HAIR = 8                        # roundings of a time within which nothing is told apart
BATCH = 400                     # steps that are done together, so that the memory does not grow with their number


class Cells:
    """Stretches early <= τ <= late of segments."""

    __slots__ = ("early", "late", "segment")

    def __init__(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> None:
        self.segment, self.early, self.late = segment, early, late

    def __len__(self) -> int:
        return len(self.early)

    @property
    def width(self) -> np.ndarray:
        found: np.ndarray = self.late - self.early
        return found

    def where(self, mask: np.ndarray | slice) -> "Cells":
        """Those where the mask holds."""
        return Cells(self.segment[mask], self.early[mask], self.late[mask])

    def divided(self, parts: int) -> "Cells":
        """Each in equal parts."""
        edges = self.early[:, None] + self.width[:, None] * (np.arange(parts + 1) / parts)
        edges[:, -1] = self.late
        return Cells(np.repeat(self.segment, parts), edges[:, :-1].ravel(), edges[:, 1:].ravel())

    def doubling(self, first: float) -> "Cells":
        """Each in parts the first of which is `first` long and every next one twice as long."""
        longest = self.width.max(initial=0.0)
        steps = first * 2.0 ** np.arange(max(0, np.ceil(np.log2(longest / first))) if longest > first else 0)
        cuts = np.minimum(np.append(0.0, steps), np.inf)
        early = self.early[:, None] + cuts
        late = np.minimum(np.append(early[:, 1:], np.full((len(self), 1), np.inf), axis=1), self.late[:, None])
        held = early < self.late[:, None]
        held[:, 0] = True
        return Cells(np.repeat(self.segment, len(cuts))[held.ravel()], early[held], late[held])

    @staticmethod
    def together(parts: "Sequence[Cells]") -> "Cells":
        """All of several."""
        return Cells(*(np.concatenate([getattr(part, name) for part in parts])
                       for name in ("segment", "early", "late")))


class BoundedOutput:
    """An output from `start` to `end`: y, its slope and curvature, each with values `at` and a `bound`; count: of the
    exponentials in it; fastest: the largest magnitude of their exponents; whole: the Cells of the segments, one each.
    """

    __slots__ = ("count", "curvature", "end", "fastest", "slope", "start", "timeline", "whole", "y")

    def __init__(self, pieces: Any, output: "LinearOutput", start: float, end: float) -> None:
        self.timeline, self.start, self.end = pieces.timeline, start, end
        self.y, self.slope, self.curvature = (pieces.terms(output, order) for order in range(3))
        nodes = self.y.nodes()
        self.count, self.fastest = len(nodes), fastest(nodes)
        self.whole = stretches(pieces.timeline, start, end)

    def first_cells(self) -> Cells:
        """Cells that grow with time, the first a part of the fastest wave's period."""
        return self.whole.doubling(1 / self.fastest) if self.fastest else self.whole

    @overload
    def times(self, segment: int, tau: float) -> float: ...

    @overload
    def times(self, segment: np.ndarray, tau: Any) -> np.ndarray: ...

    def times(self, segment: Any, tau: Any) -> Any:
        """Instants so long after the starts of segments."""
        return self.timeline.starts[segment] + tau

    def ends(self, cells: Cells, slope: bool = False) -> list[np.ndarray]:
        """Its values, or slopes, where the cells begin and where they end."""
        curve = self.slope if slope else self.y
        return np.split(curve.at(np.tile(cells.segment, 2), np.concatenate([cells.early, cells.late])), 2)

    def bound(self, cells: Cells) -> np.ndarray:
        """What it does not exceed in each cell."""
        found: np.ndarray = self.y.bound(cells.segment, cells.early, cells.late)
        return found

    def bend(self, cells: Cells) -> np.ndarray:
        """Eight times the most by which it strays from the straight line in each cell."""
        found: np.ndarray = self.curvature.bound(cells.segment, cells.early, cells.late) * cells.width**2
        return found

    def instants(self, cells: Cells) -> np.ndarray:
        """Which of the cells are so short that nothing changes within them but by rounding."""
        return instants(self.timeline, cells, self.fastest)

    def steps(self, cells: Cells) -> float:
        """The steps that looking at the cells takes."""
        return len(cells) * self.count / STEP

    def batches(self, cells: Cells, parts: int = PARTS) -> list[tuple[slice, Cells]]:
        """[(slice of the cells, Cells of its parts)] of all the cells divided."""
        many = max(1, BATCH * STEP // (parts * self.count or 1))
        slices = [slice(i, i + many) for i in range(0, len(cells), many)]
        return [(part, cells.where(part).divided(parts)) for part in slices]

    def turns(self, cells: Cells) -> np.ndarray:
        """The zero of the slope in each cell."""
        return root(self.slope, self.curvature, cells, self.timeline.starts[cells.segment])


def stretches(timeline: "Timeline", start: float, end: float) -> Cells:
    """The Cells of the segments between two times, one each."""
    first, last = timeline.place(np.array([start, end]))[0]
    segment = np.arange(max(first, 0), last + 1)
    starts = timeline.starts[segment]
    return Cells(segment, np.maximum(start - starts, 0.0), np.minimum(timeline.lengths[segment], end - starts))


def fastest(nodes: Sequence[tuple[complex, ...]]) -> float:
    """The largest magnitude of an exponent."""
    return max((abs(node) for part in nodes for node in part), default=0.0)


def instants(timeline: Any, cells: Cells, speed: float) -> np.ndarray:
    """Which of the cells are so short that nothing of this speed changes within them but by rounding."""
    shortest = 1 / speed if speed else 0.0
    found: np.ndarray = cells.width <= HAIR * EPSILON * np.maximum(timeline.starts[cells.segment] + cells.late,
                                                                   shortest)
    return found


def opposite(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Where the signs of two values differ, however large or small these are."""
    found: np.ndarray = np.sign(left) * np.sign(right) < 0
    return found


def root(function: "ExponentialSum", derivative: "ExponentialSum", cells: Cells, starts: np.ndarray) -> np.ndarray:
    """The zero of the function in each cell, by Newton's method held within the bracket, until the instant, counted
    from t = 0 with the starts of the segments, is known to a rounding; where it does not change sign, the end where it
    is least."""
    low, high = cells.early.copy(), cells.late.copy()
    left, right = function.at(cells.segment, low), function.at(cells.segment, high)
    rising, moving = right > left, opposite(left, right)
    with np.errstate(all="ignore"):
        tau = np.where(moving, np.clip(low - left * ((high - low) / (right - left)), low, high), np.where(
            np.abs(left) <= np.abs(right), low, high))
    for _ in range(NEWTON):
        if not moving.any():
            break
        at, here = cells.segment[moving], tau[moving]
        value = function.at(at, here)
        up = (value > 0) == rising[moving]
        high[moving], low[moving] = np.where(up, here, high[moving]), np.where(up, low[moving], here)
        with np.errstate(all="ignore"):
            step = here - value / derivative.at(at, here)
        inside = (step >= low[moving]) & (step <= high[moving])
        step = np.where(value == 0, here, np.where(inside, step, (low[moving] + high[moving]) / 2))
        tau[moving] = step
        found = np.abs(step - here) <= EPSILON * (starts[moving] + np.abs(here))
        moving[np.flatnonzero(moving)[found]] = False
    return tau


def refused(task: "Task", known: str = "") -> PhysicsError:
    """What is said of a search that was given up, and what is known by then."""
    refusal = task.refusal()
    return PhysicsError(refusal.message + known, f"ask for a shorter interval; {refusal.hint}")
