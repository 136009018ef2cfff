"""Work within a time: some steps of computer algebra have no bound of their own."""

import signal
import threading
from time import monotonic

SMALL = 60      # where no timer can be set, only work of at most this size is done
SHORTEST = 1e-3


class Late(BaseException):
    """The time is over. No Exception, so that nothing on the way catches it by mistake."""


def within(seconds, work, otherwise, size=0):
    """What `work()` gives, or `otherwise` where it takes longer.

    Timers belong to the main thread. Elsewhere, and where the platform has none, the work is done without a bound if
    its `size` (terms, say) is small. Within another call the nearer of the two ends counts. What the work imports is
    imported before: an import that is broken off leaves modules half made.
    """
    import sympy  # noqa: F401

    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        return work() if size <= SMALL else otherwise
    left = signal.getitimer(signal.ITIMER_REAL)[0]
    if 0 < left <= seconds:
        return work()
    late = Late()

    def ring(signum, frame):
        raise late

    handler, started = signal.signal(signal.SIGALRM, ring), monotonic()
    try:
        try:
            signal.setitimer(signal.ITIMER_REAL, seconds)
            return work()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except Late as error:
        if error is not late:
            raise
        return otherwise
    finally:
        signal.signal(signal.SIGALRM, handler)
        if left:
            signal.setitimer(signal.ITIMER_REAL, max(left - (monotonic() - started), SHORTEST))
