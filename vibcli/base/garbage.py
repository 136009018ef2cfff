"""Garbage by its size: the arrays of one record are few objects and hundreds of megabytes."""

import gc
import os

GROWN = 300_000_000     # bytes that the process may grow by between searches


class Garbage:
    """What scenes leave behind in this process."""

    def __init__(self) -> None:
        self._left = 0

    def clear(self) -> None:
        """Search for it where the process has grown since it was searched for, or the system does not tell."""
        held = _resident()
        if held is None or held - self._left > GROWN:
            gc.collect()
            self._left = _resident() or 0


def _resident() -> int:
    """Bytes of memory that the process holds; None where no file tells."""
    try:
        with open("/proc/self/statm", "rb") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return None


GARBAGE = Garbage()
