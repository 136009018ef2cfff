"""One output of a motion as a sum over exponentials, its values and bounds of them."""

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.exponential_differences import Known, largest_sum, real_sum
from vibcli.analyses.transient.forced import fractions
from vibcli.analyses.transient.markov_parameters import direct, markov
from vibcli.analyses.transient.modal_block import paths
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.forced import Drive
    from vibcli.analyses.transient.pieces import Pieces


class ExponentialTerm(NamedTuple):
    """Re row · τᵏ E[nodes](τ) with k = power; at: the segments of the rows, None for all."""

    power: int
    nodes: tuple[complex, ...]
    at: np.ndarray | None
    row: np.ndarray


class ExponentialTerms:
    """The Terms of the order-th derivative of an output; split: driven parts into free ones and waves, where that loses
    nothing later on."""

    def __init__(self, pieces: "Pieces", output: "LinearOutput", order: int, split: bool) -> None:
        self.free, self.linked, self.near, self.waves = [], [], [], {}
        for block, found, states in zip(pieces.motion.blocks, pieces.drives, pieces.states, strict=True):
            row = block.rows(output, order)
            for i, j, product, nodes in paths(block.B) if row.any() else ():
                if row[i]:
                    self._add_path(nodes, row[i] * product, states[:, j], found, j, split)
        if output.constant and pieces.motion.constants and not order:
            self._add_wave(0, 0j, np.arange(len(pieces.timeline.starts)), output.constant)
        if output.a or output.channels or (order and output.v) or order > 1 or pieces.motion.system is not None:
            self._add_direct(pieces, output, order)

    def all(self) -> list[ExponentialTerm]:
        """Those of free motion, then of driven parts, then waves."""
        return [*self.free, *self.linked, *self.near, *self.waves.values()]

    def _add_path(self, nodes: tuple[complex, ...], factor: complex, states: np.ndarray, drives: "Sequence[Drive]",
                  j: int, split: bool) -> None:
        given = factor * states
        for drive in drives:
            if drive.after < math.inf and split:
                for power, inputs in fractions(drive, nodes[0]):
                    part = factor * inputs[:, 0]
                    self._add_wave(power, drive.exponent, drive.at, part)
                given[drive.at] -= part
            else:
                inputs = factor * math.factorial(drive.power) * drive.inputs[:, j]
                self.near.append(ExponentialTerm(0, nodes + drive.nodes, drive.at, inputs))
        (self.free if len(nodes) == 1 else self.linked).append(ExponentialTerm(0, nodes, None, given))

    def _add_wave(self, power: int, s: complex, at: np.ndarray, coefficients: float | np.ndarray) -> None:
        if s.imag < 0:
            s, coefficients = s.conjugate(), np.conj(coefficients)
        new = ExponentialTerm(power, (s,), at, np.zeros(len(at), complex if s.imag else float))
        row = self.waves.setdefault((power, s, at.tobytes()), new).row
        row += coefficients if s.imag else np.real(coefficients)

    def _add_direct(self, pieces: "Pieces", output: "LinearOutput", order: int) -> None:
        motion = pieces.motion
        H = markov(motion, order + 2)
        for i, row in direct(output, order, H, motion.forcing.channels).items():
            for waves in pieces.timeline.waves:
                given = waves.onto(row)
                for power, factor in waves.derivative(i).items() if given.any() else ():
                    self._add_wave(power, waves.exponent, waves.at, factor * given)


class ExponentialSum:
    """The order-th derivative of an output, real parts of sums with coefficients by segment. since: before this τ the
    split of driven parts into free ones and waves cancels, and the unsplit sum is taken."""

    def __init__(self, pieces: "Pieces", output: "LinearOutput", order: int, split: bool = True) -> None:
        self.terms, self.count = ExponentialTerms(pieces, output, order, split).all(), len(pieces.timeline.starts)
        self.since = max((drive.after for drives in pieces.drives for drive in drives if drive.after < math.inf),
                         default=0.0) if split else 0.0
        self._of = pieces, output, order

    def nodes(self) -> list[tuple[complex, ...]]:
        """The nodes of each exponential in the sum."""
        return [term.nodes for term in self.terms]

    def on(self, segment: int) -> list[tuple[tuple[complex, ...], complex]]:
        """(nodes, factor) of all on one segment: the output is Re Σ factor · E[nodes](τ)."""
        found = []
        for power, nodes, at, row in self.terms:
            if at is None or segment in at:
                factor = row[segment if at is None else np.searchsorted(at, segment)]
                found.append((nodes * (power + 1), math.factorial(power) * factor))
        return found

    @cached_property
    def unsplit(self) -> "ExponentialSum":
        """The same sum with no driven part split."""
        return ExponentialSum(*self._of, split=False)

    def at(self, segment: np.ndarray, tau: np.ndarray,
           known: Known | None = None) -> np.ndarray:
        """The values at the times `tau` after the starts of the segments; `known`: exponentials that sums of the same
        motion found at the same times."""
        y = self._summed(real_sum, known, segment, tau)
        if not np.isfinite(y).all():
            raise PhysicsError("the motion grows beyond the range of floating-point numbers",
                               hint="ask for an earlier time: the system is unstable")
        return y

    def bound(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray,
              known: Known | None = None) -> np.ndarray:
        """Upper bounds of the magnitude on the intervals early <= τ <= late of the segments; `known`: those of
        exponentials that sums of the same motion found on the same ones."""
        return self._summed(largest_sum, known, segment, early, late)

    def _summed(self, function: Callable[..., np.ndarray],
                known: Known | None,
                segment: np.ndarray, *times: np.ndarray) -> np.ndarray:
        """A function of all terms and times, of the unsplit terms before `since`."""
        late, known = times[0] >= self.since, {} if known is None else known
        with np.errstate(all="ignore"):
            if late.all():
                return function(self._here(segment), known, *times)
            total = np.empty(len(segment))
            for whole, part in ((self, late), (self.unsplit, ~late)):
                of_part = known.setdefault("late" if whole is self else "early", {})
                total[part] = function(whole._here(segment[part]), of_part, *(time[part] for time in times))
        return total

    def _here(self,
              segment: np.ndarray) -> list[tuple[int, tuple[complex, ...], np.ndarray | slice, complex | np.ndarray]]:
        """(power, nodes, which of the times lie where a term acts, its coefficients there) of every term."""
        found = []
        for power, nodes, at, row in self.terms:
            inside, place = self._within(at, segment)
            found.append((power, nodes, inside, row[place]))
        return found

    def _within(self, at: np.ndarray | None, segment: np.ndarray) -> tuple[np.ndarray | slice, int | np.ndarray]:
        """Which of the times lie in the segments `at`, None for all, and in which of them."""
        if at is None or len(at) == self.count:
            return slice(None), 0 if self.count == 1 else segment
        row = np.full(self.count, -1)
        row[at] = np.arange(len(at))
        place = row[segment]
        inside = place >= 0
        return inside, place[inside]
