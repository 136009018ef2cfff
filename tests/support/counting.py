"""Work counted, so that no test looks at a clock: how many calls of functions something takes."""

import sys


def calls(work, *args):
    """(what work(*args) gives, the number of functions written in Python that were called meanwhile)."""
    count = 0

    def note(frame, event, arg):
        nonlocal count
        count += 1

    before = sys.gettrace()
    sys.settrace(note)
    try:
        found = work(*args)
    finally:
        sys.settrace(before)
    return found, count
