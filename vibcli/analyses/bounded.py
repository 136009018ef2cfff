"""Work that may take for ever, given up after some seconds: SymPy on equations that it may or may not solve."""

import signal
import threading


class _TimeUp(BaseException):
    """Not an Exception, so that nothing between here and the work keeps it."""


def bounded(seconds, function, *args):
    """What the function gives; None where it takes longer, or where there is no timer to stop it."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        return None

    def stop(number, frame):
        raise _TimeUp

    before = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds)
        try:
            return function(*args)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except _TimeUp:
        return None
    finally:
        signal.signal(signal.SIGALRM, before)
