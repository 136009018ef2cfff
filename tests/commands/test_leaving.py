"""The end of a process that runs the command line: at once, but not of a program that runs it and goes on."""

import subprocess
import sys

RUNS = """
import runpy
import sys

def run():
    sys.argv = ["vibcli", "--version"]
    try:
        runpy.run_module("vibcli", run_name="__main__")
    except SystemExit as end:
        print("goes on after", end.code)

run()
"""
ENDS = """
import atexit
import signal
import sys

from vibcli.__main__ import main

sys.argv = ["vibcli", "--version"]
atexit.register(lambda: print(signal.getsignal(signal.SIGINT).name))
signal.signal(signal.SIGINT, HANDLER)
try:
    main()
finally:
    print("taken apart")
"""


def told(text):
    """The last line that a program prints."""
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr
    return done.stdout.splitlines()[-1]


def test_a_program_that_runs_it_goes_on():
    """As profilers and those that count lines, which need not show themselves to Python."""
    assert told(RUNS) == "goes on after 0"


def test_an_interrupt_in_the_last_moments_ends_it_unless_interrupts_are_ignored():
    assert told(ENDS.replace("HANDLER", "signal.default_int_handler")) == "SIG_DFL"
    assert told(ENDS.replace("HANDLER", "signal.SIG_IGN")) == "SIG_IGN"
