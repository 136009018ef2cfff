"""What modes that are not counted add to a motion, by the energy that each jump, bend or blow of a load leaves them."""

from functools import cached_property
from math import comb, inf
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.disturbances import FALL
from vibcli.analyses.continuous.left_out_energy import Column, LeftOutEnergy

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.analyses.excitation.linear_output import LinearOutput


ROUNDED = 1e-12     # of what adds up to where an end is: no jump


class LeftOutMotions:
    """What modes that a LeftOutEnergy is of leave out of a motion by segments of a load: `bound` of it. ALONE: as
    of Disturbances."""

    ALONE = False

    def __init__(self, energy: LeftOutEnergy, segments: "Sequence[Segment]"):
        self.energy, self.times = energy, np.array([segment.start for segment in segments])
        self._segments = segments

    def bound(self, output: "LinearOutput", t: float, order: int = 0) -> float:
        """Of what they add to the order-th rate of an output at an instant; inf where none is known."""
        if not self.bounds(output, t, order):
            return inf
        number = int(np.searchsorted(self.times, t, side="right")) - 1
        found = self.energy.reach(output, order) * float(self._sums[max(0, number)])
        return found if found < inf else inf

    def bounds(self, output: "LinearOutput", _: float, order: int = 0) -> bool:
        """Is that bound finite?"""
        return self.energy.valid and self.energy.has_reach(output, order) and self._taken

    def obstacle(self, _: "LinearOutput") -> str:
        """Why it is not, where amplitudes tell nothing either."""
        return FALL

    @cached_property
    def _parts(self):
        """Of each segment {(channel, exponent, power): coefficient} of the change of the free part at its start."""
        return [self._begun(number) for number in range(len(self._segments))]

    @cached_property
    def _taken(self):
        """Is the energy of all of them known? It is infinite where a driven end jumps."""
        return all(self.energy.takes(*key) for key in {key for part in self._parts for key in part}) and not any(
            self._jumps(part) for part in self._parts)

    def _jumps(self, part):
        """Does a driven end, which the free part leaves at rest?"""
        return any(abs(sum(own)) > ROUNDED * sum(map(abs, own)) for channel in self.energy.loads.driven
                   for own in [[c.real for (at, _, power), c in part.items() if at == channel and not power]])

    @cached_property
    def _sums(self):
        """Σ ‖Π z‖ of what begins with each segment and those before."""
        channels = sorted({channel for part in self._parts for channel, *_ in part})
        keys = sorted({key for part in self._parts for key in part}, key=str)
        columns = [Column(channels.index(channel), s, power, imaginary) for channel, s, power in keys
                   for imaginary in ((False, True) if s.imag else (False,))]
        e = np.array([[-c.imag if column.imaginary else c.real for column in columns
                       for c in [part.get((channels[column.slot], column.exponent, column.power), 0j)]]
                      for part in self._parts])
        return self.energy.begun + (np.cumsum(self.energy.norms(channels, columns, e)) if columns else np.zeros(len(e)))

    def _begun(self, number):
        """That of one."""
        found: dict[tuple[int, complex, int], complex] = {}

        def add(channel, s, power, c):
            if c:
                found[channel, s, power] = found.get((channel, s, power), 0j) + c

        segment = self._segments[number]
        for wave in segment.waves:
            add(wave.channel, complex(wave.exponent), wave.power, -wave.coefficient)
        for channel, size in segment.impulses:
            add(channel, 0j, -1, size)
        if not number:
            for channel in range(self.energy.n):
                add(channel, 0j, 0, self.energy.held[channel])
                add(channel, 0j, -1, self.energy.struck[channel])
            return found
        tau = segment.start - self._segments[number - 1].start
        for wave in self._segments[number - 1].waves:
            s = complex(wave.exponent)
            for i in range(wave.power + 1):
                add(wave.channel, s, i, comb(wave.power, i) * tau ** (wave.power - i) * np.exp(s * tau)
                    * wave.coefficient)
        return found
