"""What modes that are not counted add to a motion, by the energy that each jump, bend or blow of a load leaves them."""

from collections.abc import Mapping
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.disturbances import FALL, ROUNDING
from vibcli.analyses.continuous.left_out_causes import causes
from vibcli.analyses.continuous.left_out_columns import Column
from vibcli.analyses.continuous.left_out_energy import LeftOutEnergy
from vibcli.analyses.continuous.load_changes import Changes, changes

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.left_out_readings import Reading
    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.analyses.excitation.linear_output import LinearOutput

FALLS, SAFE = 0.6, 2.0      # of one term to the next, τ growing four times: up to there; times what those beyond add


class LeftOutMotions:
    """What modes that a LeftOutEnergy is of leave out of a motion by segments of a load: `bound` of it. ALONE: as
    of Disturbances."""

    ALONE = False

    def __init__(self, energy: LeftOutEnergy, segments: "Sequence[Segment]") -> None:
        self.energy, self.times = energy, np.array([segment.start for segment in segments])
        self._segments, self._finite, self._sizes = segments, {}, {}

    def bound(self, output: "LinearOutput", t: float, order: int = 0) -> float:
        """Of what they add to the order-th rate of an output at an instant; inf where none is known."""
        if not self.bounds(output, t, order):
            return inf
        begun = self.times <= max(t, float(self.times[0]))
        faded = begun * np.exp(-self.energy.fading * np.maximum(t - self.times, 0.0))
        found = sum(self._of(one, faded) for one in self.energy.readings(output, order))
        return found if found < inf else inf

    def bounds(self, output: "LinearOutput", _: float, order: int = 0) -> bool:
        """Is that bound finite?"""
        return not self.energy.flaw and all(map(self._is_bounded, self.energy.readings(output, order)))

    def _of(self, reading: "Reading", faded: np.ndarray) -> float:
        if self._is_finite(reading.level):
            return self.energy.reach(reading) * float(self._sizes_of(reading.level) @ faded)
        return self._by_smoothing(reading, faded)

    def _is_bounded(self, reading: "Reading") -> bool:
        return self._is_finite(reading.level) or self._is_smooth(reading)

    def _is_smooth(self, reading: "Reading") -> bool:
        """Does what is left out have a bound by (τ − A)⁻¹ of it?"""
        k = reading.level
        return reading.rate <= k and self.energy.begun(k) < inf and all(
            self.energy.takes_smooth(*key) for part in self._rated(k) for key in part
            ) and self._by_smoothing(reading, np.ones(len(self.times))) < inf

    def _by_smoothing(self, reading: "Reading", faded: np.ndarray) -> float:
        """With Jτ = τ (τ − A)⁻¹, which tend to 1, [a, z] = [a, J₀ z] + Σ [a, (Jₙ₊₁ − Jₙ) z], each by the energies of

            (Jₙ₊₁ − Jₙ) = (τₙ − τₙ₊₁) A (τₙ₊₁ − A)⁻¹ (τₙ − A)⁻¹

        one (τ − A)⁻¹ with a, the other with z; beyond the last τ these fall as the last of them do."""
        energy, (tau, k) = self.energy, (self.energy.tau, reading.level)
        sizes, reach = self._sizes_of(k, smooth=True) @ faded, energy.reach(reading)
        terms = np.diff(tau) * energy.smooth_reaches(reading)[1:] * sizes[:-1]
        fall = terms[-1] / terms[-2] if terms[-2] else 0.0
        if not fall <= FALLS:
            return inf
        begun = energy.begun(k) * faded[0]
        later = terms.sum() + SAFE * terms[-1] * fall / (1 - fall)
        return float(reach * (begun + tau[0] * sizes[0]) + later)

    def reason(self, output: "LinearOutput") -> str:
        """Why no bound is known of it, in words."""
        return causes(self, output)

    def only(self, start: bool, chosen: "Callable[[int], bool]") -> "LeftOutMotions":
        """Of what starts in fields, or not so, under loads on some channels."""
        energy, none = self.energy, np.zeros(self.energy.n)
        if energy.in_fields and not start:
            energy = LeftOutEnergy(energy.modes, energy.transfer, (none, none))
        return LeftOutMotions(energy, [segment._replace(
            waves=tuple(wave for wave in segment.waves if chosen(wave.channel)),
            impulses=tuple(one for one in segment.impulses if chosen(one[0]))) for segment in self._segments])

    def beyond(self, output: "LinearOutput") -> "set[tuple[int, complex, int]]":
        """(channel, exponent, power) of what leaves what an output reads an energy that is infinite or not known."""
        return {key for part in self._unbounded(output) for key in part if not self.energy.takes(*key)}

    def jumps(self, output: "LinearOutput") -> bool:
        """Is a jump of a driven end among it?"""
        return any(map(self._jumps, self._unbounded(output)))

    def _unbounded(self, output: "LinearOutput") -> list[dict[tuple[int, complex, int], complex]]:
        levels = {one.level for one in self.energy.readings(output, 0) if not self._is_bounded(one)}
        return [part for k in levels for part in self._rated(k)]

    def obstacle(self, _: "LinearOutput", __: float) -> str:
        """Why it is not, where amplitudes tell nothing either."""
        return FALL

    @cached_property
    def _parts(self) -> list[list[dict[tuple[int, complex, int], complex]]]:
        """Of each segment {(channel, exponent, power): coefficient} of the change of the free part at its start."""
        return [[self._begun(number) for number in range(len(self._segments))]]

    def _rated(self, k: int) -> list[dict[tuple[int, complex, int], complex]]:
        """The same of the k-th rate."""
        while len(self._parts) <= k:
            self._parts.append([_rate(part, self.energy.fading) for part in self._parts[-1]])
            if len(self._parts) == 2 and self.energy.in_fields:
                self._parts[1][0] = _with_blows(self._parts[1][0], self.energy.begun_by)
        return self._parts[k]

    def _is_finite(self, k: int) -> bool:
        """Is the energy of all of them known? It is infinite where a driven end jumps."""
        if k not in self._finite:
            self._finite[k] = self.energy.begun(k) < inf and all(
                self.energy.takes(*key) for key in {key for part in self._rated(k) for key in part}) and not any(
                    self._jumps(part) for part in self._rated(k))
        return cast("bool", self._finite[k])

    def _jumps(self, part: Mapping[tuple[int, complex, int], complex]) -> bool:
        """Does a driven end, which the free part leaves at rest?"""
        return any(abs(sum(own)) > ROUNDING * sum(map(abs, own)) for channel in self.energy.loads.driven
                   for own in [[c.real for (at, _, power), c in part.items() if at == channel and not power]])

    def _sizes_of(self, k: int, smooth: bool = False) -> np.ndarray:
        """‖Π Aᵏ z‖ of what begins with each segment; or ‖Π (τ − A)⁻¹ Aᵏ z‖ of the same, (τ, segments)."""
        if (k, smooth) not in self._sizes:
            parts = self._rated(k)
            channels = sorted({channel for part in parts for channel, *_ in part})
            keys = sorted({key for part in parts for key in part}, key=str)
            columns = [Column(channels.index(channel), s, power, imaginary) for channel, s, power in keys
                       for imaginary in ((False, True) if s.imag else (False,))]
            e = np.array([[-c.imag if column.imaginary else c.real for column in columns
                           for c in [part.get((channels[column.slot], column.exponent, column.power), 0j)]]
                          for part in parts])
            if smooth:
                found = self.energy.smooth_norms(channels, columns, e)
            else:
                found = self.energy.norms(channels, columns, e) if columns else np.zeros(len(parts))
                found[0] += self.energy.begun(k)
            self._sizes[k, smooth] = found
        return cast("np.ndarray", self._sizes[k, smooth])

    def _begun(self, number: int) -> dict[tuple[int, complex, int], complex]:
        """That of one."""
        found = changes(self._segments, number)
        for channel in range(self.energy.n if not number else 0):
            found.add((channel, 0j, 0), self.energy.held[channel])
            found.add((channel, 0j, -1), self.energy.struck[channel])
        return found.kept()


def _rate(part: Mapping[tuple[int, complex, int], complex], fading: float) -> dict[tuple[int, complex, int], complex]:
    """Of (s + δ) f̂(s): an onset is a blow of its rate, and what is smoother begins less smoothly."""
    found = Changes()
    for (channel, s, power), c in part.items():
        if power >= 0:
            found.add((channel, s, power), c * (s + fading))
        found.add(*(((channel, s, power - 1), c * power) if power else ((channel, 0j, -1), -c)))
    return found.kept()


def _with_blows(part: Mapping[tuple[int, complex, int], complex],
                blows: np.ndarray) -> dict[tuple[int, complex, int], complex]:
    """A part beside blows on coordinates."""
    found = Changes()
    for key, c in [*part.items(), *(((i, 0j, -1), size) for i, size in enumerate(blows.tolist()) if size)]:
        found.add(key, c)
    return found.kept()
