"""Work of computer algebra, some steps of which have no bound of their own, within a number of calls.

Calls of functions written in Python are counted, not seconds, so that every machine gives up the same work.
"""

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from vibcli.base.work import under_way

if TYPE_CHECKING:
    from types import FrameType

Result = TypeVar("Result")
OFTEN = 100_000     # calls from one telling of progress to the next
GENERATOR = 0x20    # inspect.CO_GENERATOR
IN_GENERATORS = 10_000      # calls more, before a generator is broken off: one that is being closed swallows the end,
#                             and nothing would be counted from then on


class CallsSpent(BaseException):
    """The calls are used up. No Exception, so that nothing on the way catches it by mistake."""


def within(calls: int, work: Callable[[], Result], otherwise: Result) -> Result:
    """The result of `work()`, or `otherwise` where it takes more calls, times the patience of the task under way.
    Within another call the nearer of the two ends counts. What the work imports is imported before: an import that is
    broken off leaves modules half made."""
    import sympy  # noqa: F401

    task = under_way()
    outer, left, spent = sys.gettrace(), calls * (task.work.patience if task else 1), CallsSpent()

    def count(frame: "FrameType", event: Any, arg: Any) -> Any:
        nonlocal left
        left -= 1
        if left < 0 and (left < -IN_GENERATORS or not frame.f_code.co_flags & GENERATOR):
            raise spent
        if task and not left % OFTEN:
            task.tell()
        return outer and outer(frame, event, arg)

    sys.settrace(count)
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
