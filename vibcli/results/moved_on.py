"""Where motions that nothing holds have led when their loads have ended, as a signal sees it."""

from typing import TYPE_CHECKING

from vibcli.analyses.continuous.modal_reads import Read
from vibcli.base.errors import PhysicsError
from vibcli.results.modal_signals import ModalSignal

if TYPE_CHECKING:
    from vibcli.results.signal import Signal

SEEN = 1e-12        # of what parts of a signal see: rounding


def moved_on(signal: "Signal", last: float, longest: float) -> tuple[float, float]:
    """(value, how far it may be off) from the instant `last` on; PhysicsError where they lead on, so that it is seen
    within a time of the vibrations."""
    if not isinstance(signal, ModalSignal):
        raise PhysicsError("nothing holds these members: where they move on to is not found of functions of signals",
                           "ask for a single signal, or for its value at a time")
    motion, read = signal.modal, Read(signal.modal, signal.reads, 0)
    stretch, (seen, of_rates) = motion.stretches(last)[-1], read.rigid
    (place, rate), (off, drift) = stretch.rigid, stretch.lost
    pushed = sum((abs(motion.modes.rigid_inputs @ stroke.force) for stroke in stretch.strokes), 0.0 * rate)
    size = float(abs(seen) @ abs(place) + (longest * abs(seen) + abs(of_rates)) @ drift
                 + abs(read.states) @ stretch.sizes)
    away = longest * float(abs(seen @ rate) + (longest * abs(seen) + abs(of_rates)) @ pushed)
    if away > SEEN * size or read.states[motion.states.rates == 0].any():
        raise PhysicsError("what nothing holds moves on without end: this signal has neither limit nor mean",
                           "ask for its value at a time, or for a signal that does not see it move")
    return (float(seen @ place + of_rates @ rate),
            float(abs(seen) @ off + abs(of_rates) @ drift) + SEEN * size)
