"""The motion in time of bars, shafts and strings whose waves drag or a foundation in proportion to their mass disperse:
values at instants without any series, as long as fronts stay few."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.results.wave_response import WaveResponse

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.continuous.dispersed_waves import DispersedMotion
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.excitation.forcing import Forcing, Wave
    from vibcli.results.modal_response import ModalResponse
    from vibcli.results.responses import Terms
    from vibcli.results.signal import Signal
    from vibcli.results.wave_signals import DispersedSignal
    from vibcli.symbolic.syntax import NameRef

ALIKE = 1e-14       # relative difference of rates that are one
NEAR = 1e-6         # of δ²: a σ² next to 0, where what two exponentials leave of one another rounds


class DispersedWaveResponse(WaveResponse):
    """Small oscillations about the equilibrium. NotByWaves where anything but members has mass or dampers, of
    accelerations, of forces beside shaken ends, and of what is read of loads themselves."""

    @cached_property
    def alone(self) -> "DispersedMotion":
        """The DispersedMotion under the excitation."""
        from vibcli.analyses.continuous.dispersed_waves import DispersedMotion, WaveSource
        from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave

        (delta, kappa), forces, (q, v) = self._rates, self._forces, self.deviations
        plain = self._pieces([one._replace(piece=one.piece._replace(drag=0, foundation=0)) for one in self.placed])
        displaced, moving = (_fields(self.fields, number) for number in range(2))

        def under(waves: "tuple[Wave, ...]", start: "tuple[np.ndarray, np.ndarray]",
                  fields: "list[Forcing] | None") -> "WaveMotion":
            return self._followed(plain, Forcing(forces.channels, [Segment(0.0, waves)]), start, fields)

        found = [WaveSource(under((Wave(channel, 1.0, 0, 0j),), (0 * q, 0 * v), None).under(forces), channel)
                 for channel, node in self._moving.items() if not node.is_zero]
        if kappa and q.any() and None in self.fields:       # at rest on its foundation between its ends, not straight
            raise _refusal()
        if q.any() or displaced is not None:
            start = Forcing(1, [Segment(0.0, tuple(Wave(0, *wave) for wave in _letting_go(delta, kappa)))])
            found.append(WaveSource(under((), (q, 0 * v), displaced).under(start), 0))
        if moving is not None:
            found.append(WaveSource(under((), (0 * q, v), moving), 0, velocity=True))
        elif v.any():
            raise _refusal()
        return DispersedMotion(found, delta, delta**2 - kappa, self.problem.work)

    def reach(self, until: float) -> None:
        self.alone.reach(until)

    @property
    def _rates(self) -> "np.ndarray":
        """δ and κ: half of c/μ, and k/μ."""
        import numpy as np

        (M, C, _), damping = self.matrices, self.problem.spec.get("damping")
        rates = np.array([[float(x) for x in (one.piece.drag, one.piece.foundation, one.piece.inertia)]
                          for one in self.placed])
        if any(one.piece.bending for one in self.placed) or not rates[:, 2].all() or M.any() or C.any():
            raise _refusal()
        if damping is not None:
            raise _refusal()
        found = rates[:, :2] / rates[:, 2:]
        if (np.ptp(found, axis=0) > ALIKE * found.max(axis=0)).any():
            raise _refusal()
        result: np.ndarray = found[0] / (2, 1)
        return result

    def without_bound(self, constant: float, terms: "Terms",
                      motion: "ModalMotion", asked: "tuple[ModalResponse, NameRef]") -> "Signal | None":
        from vibcli.results.boundless_signal import BoundlessSignal

        try:
            self.alone.search(self.until)
            found = self._linear(constant, terms)
        except NotByWaves:
            return None
        return BoundlessSignal(found.waves, found.reads, motion, asked)

    def _linear(self, constant: float, terms: "Terms", source: tuple[Any, ...] = ()) -> "DispersedSignal":
        from vibcli.results.wave_signals import DispersedSignal

        shaken = any(channel is not None for _, channel, _ in self._numbered_ends)
        for _, (output, node) in terms:
            if node is not None or output.a or output.channels or any(
                    place.rates > 1 or (place.along and shaken) for place in output.places):
                raise _refusal()
        return DispersedSignal(*self._driven(constant, terms))


def _fields(fields: "Sequence[Forcing | None]", number: int) -> "list[Forcing] | None":
    """What pieces start with on one channel alone; None where it is nothing."""
    from vibcli.analyses.excitation.forcing import Forcing

    found = [None if field is None else Forcing(field.channels, [
        piece._replace(waves=tuple(wave for wave in piece.waves if wave.channel == number)) for piece in field.pieces])
        for field in fields]
    return found if any(piece.waves for field in found if field is not None for piece in field.pieces) else None


def _letting_go(delta: float, kappa: float) -> tuple[tuple[complex, int, complex], tuple[complex, int, complex]]:
    """(coefficient, power, exponent) of the waves of (s + 2δ)/(s² + 2δs + κ)."""
    square = delta**2 - kappa
    if not square:
        return (1.0, 0, complex(-delta)), (delta, 1, complex(-delta))
    if abs(square) <= NEAR * delta**2:
        raise _refusal()
    root = complex(square) ** 0.5
    slow, fast = -delta + root, -delta - root
    return (-fast / (2 * root), 0, slow), (slow / (2 * root), 0, fast)


def _refusal() -> NotByWaves:
    return NotByWaves("its waves are not followed as they disperse")
