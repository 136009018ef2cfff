"""Work that is left when a time of the processor is over, at the next call of a function written in Python."""

import sys
from collections.abc import Callable
from signal import getsignal, signal
from threading import current_thread, main_thread
from typing import Any

try:
    from signal import ITIMER_VIRTUAL, SIGVTALRM, getitimer, setitimer
except ImportError:         # Windows
    ITIMER_VIRTUAL = None

LEAST = 0.02        # seconds, which processors are not told shorter


def done_in_time(seconds: float, work: Callable, leave: Callable, end: type[BaseException]) -> list[Any]:
    """[the result of `work()`], where it is there within so many seconds of the processor; else, and where no alarm can
    be set, nothing. `leave(frame, event, arg)` traces calls when these are over, and raises an `end`."""
    if seconds < LEAST or ITIMER_VIRTUAL is None or sys.gettrace() or current_thread() is not main_thread():
        return []
    around = getsignal(SIGVTALRM)
    if isinstance(around, _Alarm):
        return around.part(seconds, work)
    return [] if getitimer(ITIMER_VIRTUAL)[0] or around is None else _Alarm(leave, end).done(seconds, work, around)


class _Alarm:
    """rung: is the time over?"""

    __slots__ = ("end", "leave", "rung", "set")

    def __init__(self, leave: Callable, end: type[BaseException]):
        self.leave, self.end, self.rung, self.set = leave, end, False, True

    def __call__(self, number, frame):
        if self.set:
            self.rung = True
            sys.settrace(self.leave)

    def done(self, seconds: float, work: Callable, before: Any) -> list[Any]:
        """The same; before: who is told of the signal else. It rings again, as the first time may not be heard."""
        signal(SIGVTALRM, self)
        setitimer(ITIMER_VIRTUAL, seconds, seconds)
        try:
            found = [work()]
        except (Exception, self.end):
            if not self.rung:
                raise
        finally:
            self.set = False
            sys.settrace(None)
            setitimer(ITIMER_VIRTUAL, 0)
            signal(SIGVTALRM, before)
        return [] if self.rung else found

    def part(self, seconds: float, work: Callable) -> list[Any]:
        """The same of a part of the work, for which no alarm of its own is set."""
        start = getitimer(ITIMER_VIRTUAL)[0]

        def late():
            return self.rung or start - getitimer(ITIMER_VIRTUAL)[0] > seconds

        try:
            found = [work()]
        except Exception:
            if not late():
                raise
        return [] if late() else found
