"""One output of a motion as a sum over exponentials, its values and bounds of them."""

import math
from functools import partial

import numpy as np

from vibcli.analyses.transient.forced import fractions
from vibcli.analyses.transient.markov_parameters import direct, markov
from vibcli.analyses.transient.modal_block import paths
from vibcli.base.errors import PhysicsError
from vibcli.numerics.exponential_differences import bounds, differences, real_wave


class ExponentialSum:
    """The order-th derivative of an output, real parts of sums with coefficients by segment.

    free: (λ, coefficients) of e^{λτ}; linked: (nodes, coefficients) of E[nodes](τ); near: (nodes, segments,
    coefficients) of driven parts; waves: {…: (power, s, segments, coefficients)} of τᵏe^{sτ}. since: before this τ
    the split of driven parts into free ones and waves cancels, and the unsplit sum is taken.
    """

    __slots__ = ("_early", "count", "free", "linked", "near", "since", "waves")

    def __init__(self, pieces, output, order, split=True):
        self.free, self.linked, self.near, self.waves = [], [], [], {}
        self.since = max((drive.after for drives in pieces.drives for drive in drives if drive.after < math.inf),
                         default=0.0) if split else 0.0
        self._early = partial(ExponentialSum, pieces, output, order, False) if self.since else None
        self.count = len(pieces.timeline.starts)
        for block, found, states in zip(pieces.motion.blocks, pieces.drives, pieces.states, strict=True):
            row = block.rows(output, order)
            for i, j, product, nodes in paths(block.B) if row.any() else ():
                if row[i]:
                    self._add_path(nodes, row[i] * product, states[:, j], found, j, split)
        if output.constant and pieces.motion.constants and not order:
            self._add_wave(0, 0j, np.arange(self.count), output.constant)
        if output.a or output.channels or (order and output.v) or order > 1 or pieces.motion.system is not None:
            self._add_direct(pieces, output, order)

    def _add_path(self, nodes, factor, states, drives, j, split):
        given = factor * states
        for drive in drives:
            if drive.after < math.inf and split:
                for power, inputs in fractions(drive, nodes[0]):
                    part = factor * inputs[:, 0]
                    self._add_wave(power, drive.exponent, drive.at, part)
                given[drive.at] -= part
            else:
                inputs = factor * math.factorial(drive.power) * drive.inputs[:, j]
                self.near.append((nodes + drive.nodes, drive.at, inputs))
        (self.free if len(nodes) == 1 else self.linked).append((nodes, given))

    def _add_wave(self, power, s, at, coefficients):
        if s.imag < 0:
            s, coefficients = s.conjugate(), np.conj(coefficients)
        new = power, s, at, np.zeros(len(at), complex if s.imag else float)
        row = self.waves.setdefault((power, s, at.tobytes()), new)[3]
        row += coefficients if s.imag else np.real(coefficients)

    def _add_direct(self, pieces, output, order):
        motion = pieces.motion
        H = markov(motion, order + 2)
        for i, row in direct(output, order, H, motion.forcing.channels).items():
            for waves in pieces.timeline.waves:
                given = waves.coefficients @ row
                for power, factor in waves.derivative(i).items() if given.any() else ():
                    self._add_wave(power, waves.exponent, waves.at, factor * given)

    def nodes(self):
        """The nodes of each exponential in the sum."""
        return ([nodes for nodes, _ in self.free + self.linked] + [nodes for nodes, _, _ in self.near]
                + [(s,) for _, s, _, _ in self.waves.values()])

    def on(self, segment):
        """(nodes, factor) of all on one segment: the output is Re Σ factor · E[nodes](τ)."""
        found = [(nodes, row[segment]) for nodes, row in self.free + self.linked]
        parts = self.near + [((s,) * (power + 1), at, math.factorial(power) * row)
                             for power, s, at, row in self.waves.values()]
        return found + [(nodes, row[np.searchsorted(at, segment)]) for nodes, at, row in parts if segment in at]

    def early(self):
        """The same sum with no driven part split."""
        if isinstance(self._early, partial):
            self._early = self._early()
        return self._early

    def at(self, segment, tau):
        """The values at the times `tau` after the starts of the segments."""
        late = tau >= self.since
        with np.errstate(all="ignore"):
            if late.all():
                y = self._at(segment, tau)
            else:
                y = np.empty(len(tau))
                y[late], y[~late] = self._at(segment[late], tau[late]), self.early()._at(segment[~late], tau[~late])
        if not np.isfinite(y).all():
            raise PhysicsError("the motion grows beyond the range of floating-point numbers",
                               hint="ask for an earlier time: the system is unstable")
        return y

    def _at(self, segment, tau):
        y = np.zeros(len(tau))
        for (node,), row in self.free:
            y += real_wave(self._of(row, segment), node, tau)
        for nodes, row in self.linked:
            y += np.real(self._of(row, segment) * differences(nodes, tau))
        for nodes, at, row in self.near:
            inside, place = self._within(at, segment)
            y[inside] += np.real(row[place] * differences(nodes, tau[inside]))
        for power, s, at, row in self.waves.values():
            inside, place = self._within(at, segment)
            here = tau[inside]
            wave = real_wave(row[place], s, here)
            y[inside] += here**power * wave if power else wave
        return y

    def bound(self, segment, early, late):
        """Upper bounds of the magnitude on the intervals early <= τ <= late of the segments."""
        whole = early >= self.since
        with np.errstate(all="ignore"):
            if whole.all():
                return self._bound(segment, early, late)
            total = np.empty(len(early))
            total[whole] = self._bound(segment[whole], early[whole], late[whole])
            total[~whole] = self.early()._bound(segment[~whole], early[~whole], late[~whole])
            return total

    def _bound(self, segment, early, late):
        total = np.zeros(len(early))
        for nodes, row in self.free + self.linked:
            total += np.abs(self._of(row, segment)) * bounds(nodes, early, late)
        for nodes, at, row in self.near:
            inside, place = self._within(at, segment)
            total[inside] += np.abs(row[place]) * bounds(nodes, early[inside], late[inside])
        for power, s, at, row in self.waves.values():
            inside, place = self._within(at, segment)
            total[inside] += np.abs(row[place]) * (late**power * bounds((s,), early, late))[inside]
        return total

    def _of(self, row, segment):
        return row[0] if self.count == 1 else row[segment]

    def _within(self, at, segment):
        """Which of the times lie in the segments `at`, and in which of them."""
        if len(at) == self.count:
            return slice(None), 0 if self.count == 1 else segment
        row = np.full(self.count, -1)
        row[at] = np.arange(len(at))
        place = row[segment]
        inside = place >= 0
        return inside, place[inside]
