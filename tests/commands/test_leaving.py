"""The end of a process that runs the command line: at once, but not of a program that runs it and goes on; told to
end, it leaves as it does where it is interrupted."""

import subprocess
import sys

import pytest

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


@pytest.mark.parametrize("asked", ["SIGTERM", "SIGHUP"])
def test_told_to_end_it_leaves_nothing_half_written(asked, tmp_path):
    text = f"""
import os, signal, sys
from vibcli.__main__ import main
from vibcli.base import output_files
from vibcli.cli import program

def put(beside, path, new):
    signal.raise_signal(signal.{asked})
    os.replace(beside, path)

def run():
    output_files.write_whole({str(tmp_path / "out.txt")!r}, b"whole")
    return 0

output_files._put, program.run = put, run
signal.signal(signal.{asked}, getattr(signal, sys.argv[1]))
main()
"""
    for handler, code, said, left in (("SIG_DFL", 130, "interrupted\n", []), ("SIG_IGN", 0, "", ["out.txt"])):
        done = subprocess.run([sys.executable, "-c", text, handler], capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (code, said)
        assert [one.name for one in tmp_path.iterdir()] == left
