"""The motion of a scene with members by its first modes beside what loads do exactly:

    y(t) = Σ Re(x C e^{λτ}) + ∂ᵏ/∂sᵏ [H(s) F e^{sτ}]        under F τᵏ e^{sτ}

H is exact, so that the sum holds free vibrations alone; the remainder is theirs, of the modes left out.
"""

from collections.abc import Callable, Iterator
from math import comb, factorial, inf
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.disturbances import FALL
from vibcli.analyses.continuous.doubt import aged
from vibcli.analyses.continuous.modal_reads import Read, key_of
from vibcli.analyses.continuous.modal_states import FreeStretch, Stroke, followed, lost_by, moved, next_to, parts
from vibcli.analyses.continuous.remainder import remainder
from vibcli.analyses.continuous.rest_of_transfer import RestOfTransfer
from vibcli.base.work import Work
from vibcli.numerics.sums_of_exponentials import sum_of_exponentials

if TYPE_CHECKING:
    from vibcli.analyses.continuous.complex_modes import ComplexModes
    from vibcli.analyses.continuous.coupled_left_out import CoupledLeftOut
    from vibcli.analyses.continuous.coupled_modes import TiedModes
    from vibcli.analyses.continuous.coupled_transfer import CoupledTransfer
    from vibcli.analyses.continuous.damped_transfer import DampedTransfer
    from vibcli.analyses.continuous.disturbances import Disturbances
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.left_out_motions import LeftOutMotions
    from vibcli.analyses.continuous.real_modes import RealModes
    from vibcli.analyses.excitation.forcing import Forcing, Wave
    from vibcli.analyses.excitation.linear_output import LinearOutput

EPSILON = 2.0**-52
KEPT = 8                        # strokes whose parts are remembered
FIRST = 8                       # stretches on which it is looked how large an output becomes
OCTAVE = 64.0                   # times what is left out, an octave of amplitudes that fall as ω⁻³ at the most shows


class ModalMotion:
    """Of RealModes or ComplexModes under a Forcing whose channels are those of an ExactTransfer, which knows their
    damping; reads: the Forcing whose channels outputs read."""

    def __init__(self, modes: "RealModes | ComplexModes | TiedModes",
                 transfer: "ExactTransfer | DampedTransfer | CoupledTransfer", forcing: "Forcing",
                 work: Work | None = None, reads: "Forcing | None" = None) -> None:
        self.modes, self.transfer, self.forcing, self.work = modes, transfer, forcing, work or Work()
        self.reads = forcing if reads is None else reads
        self.states, self.count = modes.states, modes.count
        self._rest = RestOfTransfer(modes, transfer)
        self.fastest = float(np.abs(self.states.rates).max(initial=0.0))
        self.slowest = float(np.abs(self.states.rates).min(initial=self.fastest, where=self.states.rates != 0))
        self._rows: dict[Any, Any] = {}
        self._known: dict[int, tuple[Stroke, list[Any]]] = {}        # {id: (stroke, its parts)}, the oldest first
        self._until, self._stretches, self._aged = -1.0, [], []
        self._disturbances: Disturbances | LeftOutMotions | CoupledLeftOut | None = None

    def under(self, forcing: "Forcing") -> "ModalMotion":
        """The same motion, whose outputs read further channels of the loads."""
        if forcing is self.reads:
            return self
        return ModalMotion(self.modes, self.transfer, self.forcing, self.work, forcing)

    def stretches(self, until: float) -> list[FreeStretch]:
        """Up to an instant."""
        if until > self._until:
            self._until = inf if self.forcing.listed else max(until, 2 * self._until)
            segments = self.forcing.segments(self._until if self._until == inf else np.nextafter(self._until, inf),
                                             self.work)
            channels = self.states.inputs.shape[1]
            with self.work.task("the motion from one jump or bend of its loads to the next", 20_000) as task:
                task.step(steps=len(segments) * self.count / 10_000)
                self._stretches = followed(self.states, self.modes.rigid_inputs, self.modes.rigid_start, segments,
                                           channels)
            self._aged = []
            self._disturbances = self.modes.disturbed(segments) if self.modes.disturbed else None
        return self._stretches

    def rows_of(self, output: "LinearOutput") -> tuple[np.ndarray, np.ndarray]:
        """What an output reads of each state, its rate and acceleration, (3, states), and of what nothing holds."""
        key = key_of(output)
        if key not in self._rows:
            self._rows[key] = self.modes.rows(output)
        return cast("tuple[np.ndarray, np.ndarray]", self._rows[key])

    def off_of(self, output: "LinearOutput") -> np.ndarray:
        """What rounding leaves of the same, (3, states)."""
        key = "off", key_of(output)
        if key not in self._rows:
            self._rows[key] = self.modes.lost_rows(output)
        return cast("np.ndarray", self._rows[key])

    def values(self, output: "LinearOutput", times: Any, order: int = 0, modes: int | None = None) -> np.ndarray:
        """The order-th rate of the output at instants, just after what jumps there; modes: of so many alone."""
        times = np.asarray(times, float)
        t, back = np.unique(times, return_inverse=True)
        found = np.full(len(t), output.constant if not order else 0.0)
        read = Read(self, output, order)
        for stretch, _, at in self._placed(t):
            found[at] += self._on(read, stretch, t[at] - stretch.start, modes)
        return (found + self._direct(output, t, order))[back.reshape(times.shape)]

    def _placed(self, t: np.ndarray) -> Iterator[tuple[FreeStretch, int, np.ndarray]]:
        stretches = self.stretches(float(t.max(initial=0.0)))
        which = np.searchsorted([stretch.start for stretch in stretches], t, side="right") - 1
        for number in np.unique(which).tolist():
            yield stretches[max(number, 0)], max(number, 0), which == number

    def _on(self, read: Read, stretch: FreeStretch, tau: np.ndarray, modes: int | None) -> Any:
        """Without constants and channels, at instants in order on one stretch."""
        return sum_of_exponentials(*self._swings(read, stretch, modes), tau) + self._carried(read, stretch, tau)

    def _swings(self, read: Read, stretch: FreeStretch, modes: int | None) -> tuple[np.ndarray, np.ndarray]:
        weights, states = read.states * stretch.free, self.states
        chosen = np.flatnonzero((weights != 0) & (states.modes < (self.count if modes is None else modes)))
        return weights[chosen], states.rates[chosen]

    def _carried(self, read: Read, stretch: FreeStretch, tau: np.ndarray) -> np.ndarray:
        found = self._driven(read, stretch, tau)
        for order in range(2):
            if read.rigid[order].any():
                found += moved(self.modes.rigid_inputs, stretch, tau, order) @ read.rigid[order]
        return found

    def swings(self, output: "LinearOutput", stretch: FreeStretch, modes: int) -> tuple[np.ndarray, np.ndarray]:
        """(c, λ) of the first modes, an output on a stretch being Re Σ c e^{λτ} beside `without_swings`."""
        return self._swings(Read(self, output, 0), stretch, modes)

    def without_swings(self, output: "LinearOutput", stretch: FreeStretch, t: np.ndarray) -> np.ndarray:
        """What an output is at instants of a stretch but for free vibrations."""
        return output.constant + self._carried(Read(self, output, 0), stretch, t - stretch.start) + self._direct(
            output, t, 0)

    def _driven(self, read: Read, stretch: FreeStretch, tau: np.ndarray) -> np.ndarray:
        found = np.zeros(len(tau))
        for stroke in stretch.strokes:
            k, g, near = stroke.power, self._rest.of_powers(read, stroke)[0], self._rest.near(stroke.exponent)
            found += np.real(np.exp(stroke.exponent * tau) * np.polynomial.polynomial.polyval(tau, g))
            for s, own, at, a in self._parts(stroke):
                sums = own[:, near] @ read.states[near]
                found += np.real(np.exp(s * tau) * np.polynomial.polynomial.polyval(tau, sums))
                for j, x in zip(at, a, strict=True):
                    found += np.real(read.states[j] * x * next_to(self.states.rates[j], s, k, tau))
        return found

    def _parts(self, stroke: Stroke) -> list[tuple[complex, np.ndarray, np.ndarray, np.ndarray]]:
        """Those of a stroke, which does not hang on what is read, nor when."""
        entry = self._known.get(id(stroke))
        if entry is None:
            entry = self._known[id(stroke)] = stroke, list(parts(self.states, stroke))
            if len(self._known) > KEPT:
                self._known.pop(next(iter(self._known)))
        return entry[1]

    def _direct(self, output: "LinearOutput", t: np.ndarray, order: int) -> np.ndarray | float:
        """What loads add of themselves."""
        if not any(output.channels.values()):
            return 0.0
        segments = self.reads.segments(np.nextafter(t.max(initial=0.0), inf), self.work)
        which = np.maximum(np.searchsorted([one.start for one in segments], t, side="right") - 1, 0)
        found = np.zeros(len(t))
        for number in np.unique(which).tolist():
            here = which == number
            tau = t[here] - segments[number].start
            for wave in segments[number].waves:
                factor = output.channels.get(wave.channel, 0.0)
                if factor:
                    found[here] += factor * _rate(wave, tau, order)
        return found

    def bound(self, output: "LinearOutput", t: float, order: int = 0, modes: int | None = None) -> float:
        """What modes beyond those counted, or beyond the first `modes`, can add at an instant."""
        read, (stretch, *_) = Read(self, output, order), next(iter(self._placed(np.array([float(t)]))))
        rest = self._uncounted(read, stretch, t)
        return rest if modes is None else rest + float(self._amplitudes(read, stretch)[modes:].sum())

    def _estimates(self, output: "LinearOutput", t: float, order: int) -> bool:
        """Is what is left out estimated?"""
        known = self._disturbances
        return known is None or not (known.ALONE or known.bounds(output, t, order))

    def is_estimated(self, output: "LinearOutput") -> bool:
        """Is that an estimate and no bound, at an instant at least?"""
        known = self.modes.disturbed(self.forcing.pieces) if self.modes.disturbed else None
        return known is None or not (known.ALONE or known.bounds(output, inf))

    def is_bounded(self, output: "LinearOutput", t: float, order: int = 0) -> bool:
        """Is that bound finite?"""
        self.stretches(float(t))
        quick = self._disturbances is not None and self._disturbances.bounds(output, t, order)
        return quick or self.bound(output, t, order) < inf

    def obstacle(self, output: "LinearOutput", t: float) -> str:
        """Why it is not, where it is not."""
        self.stretches(float(t))
        return FALL if self._disturbances is None else self._disturbances.obstacle(output, t)

    def left(self, output: "LinearOutput", start: float, t: float, modes: int) -> float:
        """What those counted beyond the first `modes` can add from an instant on, on the stretch from `start`."""
        read, states = Read(self, output, 0), self.states
        stretch = next(one for one in self.stretches(t) if one.start == start)
        beyond = states.modes >= modes
        sizes = np.abs(read.states * stretch.free)[beyond]
        return float(sizes @ np.exp(states.rates.real[beyond] * (t - start)))

    def changes(self, output: "LinearOutput", t: float, period: float) -> tuple[np.ndarray, np.ndarray]:
        """(by how much what an output reads of each state is another a period later, λ)."""
        read, found = Read(self, output, 0), []
        for at in (t, t + period):
            stretch = next(iter(self._placed(np.array([at]))))[0]
            found.append(read.states * stretch.free * np.exp(self.states.rates * (at - stretch.start)))
        return np.abs(found[1] - found[0]), self.states.rates

    def _uncounted(self, read: Read, stretch: FreeStretch, t: float) -> float:
        """A bound of what is left out; where none is known how amplitudes fall."""
        if not self._estimates(read.output, t, read.order):
            return self._disturbances.bound(read.output, t, read.order)
        rounded = float((read.off * np.abs(stretch.free))[self.states.modes >= self.count // 2].max(initial=0.0))
        rest = remainder(self._amplitudes(read, stretch), rounded)
        return rest * float(np.exp(self.modes.fading * (t - stretch.start))) if 0 < rest < inf else rest

    def left_share(self, output: "LinearOutput", t: float | None = None) -> float:
        """The remainder, at an instant or the largest on the first stretches, as a share of how large the output
        becomes on these."""
        read, shares, most = Read(self, output, 0), [], 0.0
        for stretch in self.stretches(0.0)[:FIRST]:
            tau = np.linspace(0, 2 * np.pi / (self.slowest or 1.0), 65)
            size = float(np.abs(self._on(read, stretch, tau, 64)).max())
            left = self._uncounted(read, stretch, stretch.start)
            most = max(most, size)
            shares.append(left / size if size else inf if left else 0.0)
        if t is None:
            return max(shares, default=0.0)
        left = self.bound(output, t)
        return left / most if most else inf if left else 0.0

    def shows_more(self, output: "LinearOutput", share: float) -> bool:
        """Does the last octave of the modes that are counted show so much of an output on its first stretches that the
        share which is left out is surely larger?"""
        read, last = Read(self, output, 0), self.count // 2
        for stretch in self.stretches(0.0)[:FIRST]:
            sizes = self._amplitudes(read, stretch)
            if sizes[last:].sum() > OCTAVE * share * sizes.sum():
                return True
        return False

    def _amplitudes(self, read: Read, stretch: FreeStretch) -> np.ndarray:
        """That of each mode on a stretch, in order of frequency."""
        sizes = np.zeros(self.count)
        np.add.at(sizes, self.states.modes, np.abs(read.states * stretch.free))
        return sizes

    def errors(self, output: "LinearOutput", times: Any, order: int = 0) -> np.ndarray:
        """Bounds of the errors of the same values: the remainder, and rounding."""
        times, read = np.asarray(times, float), Read(self, output, order)
        lost, found = self.modes.lost * np.abs(read.states), np.full(times.shape, EPSILON * abs(output.constant))
        for stretch, which, at in self._placed(times):
            self._aged = self._aged or aged(self.modes.doubt, self.states.rates, self._stretches)
            rounded = self._rounded(read, stretch, self._aged[which])
            for number in np.flatnonzero(at):
                found[number] += self.bound(output, times[number], order) + rounded(times[number] - stretch.start)
                found[number] += float(lost @ np.exp(self.states.rates.real * times[number]))
        return found

    def _rounded(self, read: Read, stretch: FreeStretch, old: np.ndarray) -> Callable[[float], float]:
        """What rounding and mixed shapes leave of a stretch, by the time since it began; old: how far C was off."""
        doubt, rates = self.modes.doubt, self.states.rates
        driven = []
        for stroke in stretch.strokes:
            own, k, near = self._rest.of_powers(read, stroke)[1], stroke.power, self._rest.near(stroke.exponent)
            for _, part, at, a in self._parts(stroke):
                for i, g in enumerate(part):
                    own[i] += float(read.off[near] @ np.abs(g[near])) + doubt.of(rates, read.states, near * g)[0]
                    own[i] += 16 * EPSILON * abs(complex(g[near] @ read.states[near]))
                felt = np.abs(read.states[at] * a) / (k + 1)        # of k! E, by τᵏ⁺¹ of what fades most slowly
                rounds = 16 * EPSILON * felt.sum(), float((doubt.phase * np.abs(rates))[at] @ felt)
                slowest = max(stroke.exponent.real, float(rates.real[at].max(initial=-inf)))
                driven.append((slowest, np.append(np.zeros(k + 1), rounds)))
            driven.append((stroke.exponent.real, own))
        polynomial = np.polynomial.polynomial.polyval

        def rounded(tau: float) -> float:
            early, late = doubt.of(rates, read.states, stretch.free, tau)
            early += float((read.off * np.abs(stretch.free) + np.abs(read.states) * old) @ np.exp(rates.real * tau))
            early += sum(float(lost_by(self.modes.rigid_inputs, stretch, np.array([tau]), order)[0] @ np.abs(row))
                         for order, row in enumerate(read.rigid) if row.any())
            return early + late * tau + sum(float(np.exp(pace * tau) * polynomial(tau, own)) for pace, own in driven)
        return rounded


def _rate(wave: "Wave", tau: np.ndarray, order: int) -> np.ndarray:
    """The order-th derivative of a wave."""
    found, s = np.zeros(len(tau), complex), complex(wave.exponent)
    for i in range(min(order, wave.power) + 1):
        fall = factorial(wave.power) / factorial(wave.power - i)
        found += comb(order, i) * fall * tau ** (wave.power - i) * s ** (order - i)
    return np.real(wave.coefficient * found * np.exp(s * tau))
