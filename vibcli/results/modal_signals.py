"""Signals of motions by modes, with the bound of the modes that are left out."""

from math import inf
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.results.signal import Signal
from vibcli.results.without_bound import why_estimated, without_bound

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np

    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.results.modal_response import ModalResponse
    from vibcli.symbolic.syntax import NameRef

SAMPLES, ZERO = 65, 1e-3        # of what is alike on members: a bound as small tells a zero
SHARES = 1 / 64, 1 / 16, 1 / 4      # of the time in which zeros are looked for


class ModalSignal(Signal):
    """A linear output of a ModalMotion; asked: the response and the tree that it was asked as; finest(motion, output):
    the motion that instants are read of; whole: the signal that it is an instant of."""

    KIND = "a motion that is followed by modes of members"
    LOOKED = 32
    MORE = "let loads rise within a time; bounds of displacements are smaller than those of forces and rates"

    def __init__(self, motion: "ModalMotion", output: "LinearOutput",
                 asked: tuple[Any, ...] = (),
                 finest: "Callable[..., Any] | None" = None, whole: "ModalSignal | None" = None) -> None:
        self.modal, self.reads, self.work, self.asked, self._finest = motion, output, motion.work, asked, finest
        self._whole = whole
        self._tops: dict[tuple[float, ...], tuple[ModalMotion, tuple[float, float]]] = {}
        self._of_waves: dict[tuple[float, float], Signal] = {}      # tops that waves tell

    def read_at(self, t: float) -> Signal:
        found = by_waves(self, self.asked, t)
        if found is not self or self._finest is None:
            return found
        return ModalSignal(self._finest(self.modal, self.reads, t), self.reads, whole=self)

    @property
    def whole(self) -> Signal:
        return self._whole or self

    @property
    def coarse(self) -> Signal:
        return ModalSignal(self.modal, self.reads, self.asked)

    def beside(self, shift: float, constant: float) -> Signal:
        """The same so far to the right on its piece, by as many modes; constant: what it is at rest there."""
        return ModalSignal(self.modal, self.shifted(shift, constant))

    def shifted(self, shift: float, constant: float) -> "LinearOutput":
        """What it reads, so far to the right."""
        (point, factor), = self.reads.places.items()
        return self.reads._replace(constant=constant, places={point._replace(x=point.x + shift): factor})

    def values(self, times: "np.ndarray", order: int = 0) -> "np.ndarray":
        self.require_bound(float(max(times, default=0.0)) if hasattr(times, "__len__") else float(times), order)
        return self.modal.values(self.reads, times, order)

    def require_bound(self, t: float, order: int = 0) -> None:
        """NoBound where what the modes left out add has no bound."""
        if not self.modal.is_bounded(self.reads, t, order):
            raise without_bound(self.modal, self.reads, t)

    def error(self, t: float) -> float:
        import numpy as np

        return float(self.modal.errors(self.reads, np.array([t]))[0])

    @property
    def is_estimated(self) -> bool:
        return self.modal.is_estimated(self.reads)

    @property
    def why_estimated(self) -> str:
        return why_estimated(self.modal, self.reads)

    def told_zero(self, t: float) -> float:
        """A share of what is alike elsewhere on the members."""
        import numpy as np

        from vibcli.analyses.continuous.modal_reads import elsewhere

        times = np.linspace(0.0, t, SAMPLES)
        return ZERO * max((float(np.abs(self.modal.values(one, times)).max())
                           for one in elsewhere(self.reads, self.modal.transfer.pieces)), default=0.0)

    def error_of_mean(self, start: float, end: float) -> float:
        """Of its mean: what modes left out add are free vibrations on each stretch, |∫ e^{λt} dt| ≤ 2/|λ|; of what is
        bounded by energies no amplitudes are known."""
        from vibcli.analyses.continuous.real_modes import RealModes

        by_energy = not isinstance(self.modal.modes, RealModes) and not self.is_estimated
        slowest = 0.0 if by_energy else min(self.modal.modes.left_out)
        begins = [start, *(one.start for one in self.modal.stretches(end) if start < one.start < end)]
        left = [self.modal.bound(self.reads, t) for t in begins]
        rounding = self.error(end) - self.modal.bound(self.reads, end)
        return min(max(left), 2 * sum(left) / (slowest * (end - start)) if slowest else inf) + rounding

    def off(self, times: "np.ndarray", end: float, modes: int) -> "np.ndarray":
        """Bounds of the errors of its values by so many modes at instants up to an end."""
        from vibcli.analyses.continuous.modal_search import off_along

        return off_along(self.modal, self.reads, times, end, modes)

    def error_of_extreme(self, start: float, end: float, top: tuple[float, float], sense: int) -> float:
        from vibcli.analyses.continuous.modal_search import error_of_extreme

        if top in self._of_waves:
            return self._of_waves[top].error(top[0])
        motion, known = self._tops.get((start, end, sense), (self.modal, top))
        found = error_of_extreme(motion if known == top else self.modal, self.reads, start, end, top, sense)
        if found == inf:
            raise without_bound(motion, self.reads, start)
        return found

    def error_of_time(self, t: float) -> float:
        from vibcli.analyses.continuous.modal_search import width_of_top

        for (instant, _), waves in self._of_waves.items():
            if instant == t:
                return waves.error_of_time(t)
        near = self.modal.values(self.reads, [t * (1 - 1e-6), t, t * (1 + 1e-6)])
        return width_of_top(self.modal, self.reads, t, 1 if 2 * near[1] >= near[0] + near[2] else -1)

    def error_of_zero(self, t: float) -> float:
        from vibcli.analyses.continuous.modal_search import width_of_zero

        return width_of_zero(self.modal, self.reads, t)

    def extreme(self, start: float, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        self.require_bound(end)
        if (start, end, sense) not in self._tops:
            self._tops[start, end, sense] = self._top(start, end, sense)
        return self._tops[start, end, sense][1]

    def _top(self, start: float, end: float, sense: int) -> "tuple[ModalMotion, tuple[float, float]]":
        """The motion that the extreme is read of, and it."""
        from vibcli.analyses.continuous.fine_search import highest
        from vibcli.analyses.continuous.modal_search import candidates, extreme
        from vibcli.results.wave_signals import DispersedSignal

        waves, found = by_waves(self, self.asked, end), None
        if isinstance(waves, DispersedSignal):
            found = waves.highest(candidates(self.modal, self.reads, start, end, sense), sense)
        if found is not None:
            self._of_waves[found] = waves
            return self.modal, found
        finest = self.modal if self._finest is None else self._finest(self.modal, self.reads)
        if finest is not self.modal:
            cells = candidates(self.modal, self.reads, start, end, sense)
            found = highest(finest, self.reads, cells, self.modal.count, sense)
        return (self.modal, extreme(self.modal, self.reads, start, end, sense)) if found is None else (finest, found)

    def zeros(self, start: float, end: float) -> list[float]:
        """Instants at which it passes or touches zero."""
        from vibcli.analyses.continuous.modal_search import zeros

        self.require_bound(end)
        return zeros(self.modal, self.reads, start, end)

    def first_zeros(self, end: float, count: int) -> list[float]:
        """In growing windows, until it has left the last of them."""
        import numpy as np

        from vibcli.analyses.continuous.modal_search import leaves

        self.require_bound(end)
        first = leaves(self.modal, self.reads, 0.0, end)[1]
        if len(first) >= count:
            return first
        for share in SHARES:
            found = self.zeros(0.0, share * end)
            if len(found) >= count and abs(self.values(np.array([share * end]))[0]) > self.error(share * end):
                return found
        return self.zeros(0.0, end)

    def along(self, end: float) -> Any:
        """It has no few parts with known bounds."""
        raise KeyError(self.KIND)

    def final(self) -> float:
        """It is not found."""
        raise PhysicsError(f"the limit of {self.KIND} is not found", "ask for its value at a late instant")


def by_waves(signal: Signal, asked: "tuple[ModalResponse, NameRef]", t: float) -> Signal:
    """The same by waves where these are followed up to an instant."""
    found = asked[0].by_waves(asked[1], t) if asked else None
    return signal if found is None else found.read_at(t)
