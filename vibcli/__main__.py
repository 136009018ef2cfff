"""What `vibcli` and `python -m vibcli` run. Nothing is imported before an interrupt is provided for."""

import _thread
import atexit
import gc
import os
import sys
from contextlib import suppress
from importlib import import_module

TYPE_CHECKING = False       # that of `typing` would have to be imported
if TYPE_CHECKING:
    from collections.abc import Sequence
    from sys import UnraisableHookArgs

ENDING = "SIGTERM", "SIGHUP"     # what asks for the end as an interrupt does
YOUNG = 1_000_000   # objects, some 100 MB beside arrays, between searches for garbage: imports are none


def main() -> None:
    """Run the command line and leave with its exit code; 130 where it is interrupted or told to end, while importing
    too. An interrupt after that ends the process at once, in silence."""
    gc.set_threshold(YOUNG)
    sys.unraisablehook = _raised_anew
    try:
        _handle(ENDING, "default_int_handler")
        from vibcli.cli.program import run
        from vibcli.cli.streams import provide

        provide()
        code = run()
        _handle(("SIGINT", *ENDING), "SIG_DFL")
    except KeyboardInterrupt:
        _handle(("SIGINT", *ENDING), "SIG_DFL")
        sys.stderr.write("interrupted\n")
        code = 130
    _leave(code)


def _handle(names: "Sequence[str]", handler: str) -> None:
    """Handle signals so, but those that are ignored: by what `signal` gives, without its enumerations."""
    signals = import_module("_signal")
    for number in [getattr(signals, name) for name in names if hasattr(signals, name)]:
        if signals.getsignal(number) is not signals.SIG_IGN:
            signals.signal(number, getattr(signals, handler))


def _leave(code: int) -> None:
    """End the process: what waits for its end is done and what was written goes out; modules and objects, which go with
    the process, are not taken apart one by one."""
    if sys.gettrace() or sys.getprofile() or not _alone():      # whoever watches wants to see the end
        sys.exit(code)
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(code)


def _alone() -> bool:
    """Has Python itself begun the module that calls `main`, and no program, as a profiler, that goes on behind it?"""
    frame = sys._getframe(3)
    while frame.f_back is not None and frame.f_back.f_globals.get("__name__") == "runpy":
        frame = frame.f_back
    return frame.f_back is None


class _Interrupt(int):
    """A signal that comes `again` where that is read: after a call Python would look for signals at once."""

    again = property(_thread.interrupt_main)


def _raised_anew(lost: "UnraisableHookArgs") -> object:
    """An interrupt in a callback, as that of a lock of an import, whose errors go nowhere, comes again behind it."""
    if issubclass(lost.exc_type, KeyboardInterrupt):
        return _Interrupt(2).again
    return sys.__unraisablehook__(lost)


if __name__ == "__main__":
    main()
