"""The envelope of a signal, itself a signal."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.results.signal import Signal, part_of

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.transient.envelope import Beats, Decay
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.results.signals import LinearSignal


class Envelope(Signal):
    """A e^{−δt} of the one vibration in a signal; of two, beats, √(A₁² + A₂² + 2A₁A₂ cos(Δω t − Δφ)), each A with its
    own decay."""

    KIND = "an envelope"

    def __init__(self, signal: "LinearSignal") -> None:
        self.signal = signal

    @cached_property
    def found(self) -> "Decay | Beats":
        """That of the vibrations, which are there from t = 0 on."""
        from vibcli.results.signal_features import envelope

        return envelope(self.signal)

    @property
    def source(self) -> tuple[Any, ...]:
        """That of its signal, of which it is a part."""
        return part_of(self.signal.source, "envelope")

    @property
    def parts(self) -> "list[Part]":
        """The vibrations."""
        from vibcli.analyses.transient.free_vibration import vibrations
        from vibcli.results.signal_features import vibration

        found: Any = self.found
        if hasattr(found, "two"):
            return [found.one, found.two]
        return vibrations(self.signal.motion, self.signal.output) or [vibration(self.signal)]

    @property
    def period(self) -> float | None:
        """After which the beats repeat themselves, None where they do not."""
        return self.found.period

    def values(self, times: "np.ndarray", order: int = 0) -> "np.ndarray":
        import numpy as np

        return self.found.values(np.asarray(times, float))

    def along(self, end: float) -> "Decay | Beats":
        return self.found

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        return self.found.extreme(start, end, sense, self.signal.motion.work)

    def zeros(self, start: float, end: float) -> list[float]:
        return self.found.zeros(start, end)

    def first_zeros(self, end: float, count: int) -> list[float]:
        """Of beats, which have as many as there is time for, no more than are asked."""
        return self.found.zeros(0.0, end, count)

    def final(self) -> float:
        return self.found.final()

    def error(self, t: float) -> float:
        from vibcli.results.feature_errors import envelope

        return envelope(self.signal, self.found, t)[0]

    def error_of_time(self, t: float) -> float:
        from vibcli.results.feature_errors import envelope

        return envelope(self.signal, self.found, t)[1]

    def error_of_final(self) -> float:
        return self.error(0.0)
