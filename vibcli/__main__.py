"""What `vibcli` and `python -m vibcli` run. Nothing is imported before an interrupt is provided for."""

import atexit
import gc
import os
import sys
from contextlib import suppress

YOUNG = 100_000     # objects between searches for garbage: what is imported and read is none, and searching it is slow


def main():
    """Run the command line and leave with its exit code; 130 where it is interrupted, while importing too."""
    gc.set_threshold(YOUNG)
    try:
        from vibcli.cli.program import run
        from vibcli.cli.streams import provide

        provide()
        code = run()
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        code = 130
    _leave(code)


def _leave(code):
    """End the process: what waits for its end is done and what was written goes out; modules and objects, which go with
    the process, are not taken apart one by one."""
    if sys.gettrace() or sys.getprofile():      # whoever watches wants to see the end
        sys.exit(code)
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(code)


if __name__ == "__main__":
    main()
