"""Work of computer algebra, some steps of which have no bound of their own, within a number of calls.

Calls of functions written in Python are counted, not seconds, so that every machine gives up the same work. As work
takes three times as long where they are, it is done uncounted first, for less time than any machine takes for so many
calls; what is not done by then begins again, and is counted. So no clock decides what is given up.
"""

import sys
from collections.abc import Callable
from typing import Any

from vibcli.base.work import under_way

OFTEN = 100_000     # calls from one telling of progress to the next
GENERATOR = 0x20    # inspect.CO_GENERATOR
IN_GENERATORS = 10_000      # calls more, before a generator is broken off: one that is being closed swallows the end,
#                             and nothing would be counted from then on
QUICKEST = 2e-8     # seconds of the processor that a call takes at least; what is bounded here takes five times as long


class CallsSpent(BaseException):
    """The calls are used up. No Exception, so that nothing on the way catches it by mistake."""


def within(calls: int, work: Callable, otherwise: Any):
    """The result of `work()`, or `otherwise` where it takes more calls, times the patience of the task under way.
    Within another call the nearer of the two ends counts. What the work imports is imported before: an import that is
    broken off leaves modules half made."""
    import sympy  # noqa: F401

    from vibcli.symbolic.alarm import done_in_time

    task, spent, outer = under_way(), CallsSpent(), sys.gettrace()
    calls *= task.work.patience if task else 1
    if done := done_in_time(calls * QUICKEST, work, _counting(0, spent, None, None), CallsSpent):
        return done[0]
    sys.settrace(_counting(calls, spent, task, outer))
    try:
        return work()
    except CallsSpent as error:
        if error is not spent:
            raise
    finally:
        sys.settrace(outer)
    if task:
        task.work.give_up_closed_form()
    return otherwise


def _counting(left, spent, task, outer):
    """What traces calls, and raises when so many were made."""
    def count(frame, event, arg):
        nonlocal left
        left -= 1
        if left < 0 and (left < -IN_GENERATORS or not frame.f_code.co_flags & GENERATOR):
            raise spent
        if task and not left % OFTEN:
            task.tell()
        return outer and outer(frame, event, arg)

    return count
