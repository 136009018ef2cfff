"""An interrupt at each step of what Python does: raised where the signal could be, with nothing left to chance."""

import signal
import sys
from collections.abc import Callable, Iterator, Sequence


def at_each_step(work: Callable[[], object], files: Sequence[str], limit: int = 5_000) -> Iterator[str]:
    """Do work() with an interrupt at the first opcode in such files, then at the second, and so on to its end; yields
    where each was, after it. The work must begin anew each time."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)       # ignored in what a shell put behind it
    try:
        for number in range(limit):
            where = _interrupted(work, files, number)
            if where is None:
                return
            yield where
        raise AssertionError(f"more than {limit} steps")
    finally:
        signal.signal(signal.SIGINT, before)


def _interrupted(work, files, number):
    """Where the interrupt was; None where the work had ended before."""
    left, where, outer = number, None, sys.gettrace()

    def trace(frame, event, arg):
        nonlocal left, where
        if not frame.f_code.co_filename.endswith(tuple(files)):
            return None
        frame.f_trace_lines, frame.f_trace_opcodes = False, True
        if event == "opcode":
            left -= 1
            if left < 0 and where is None:
                where = f"{frame.f_code.co_filename}:{frame.f_lineno}"
                sys.settrace(None)
                signal.raise_signal(signal.SIGINT)
        return trace

    try:
        sys.settrace(trace)
        work()
    except KeyboardInterrupt:
        assert where is not None
        return where
    finally:
        sys.settrace(outer)
    assert where is None, f"an interrupt at {where} is lost"
    return None
