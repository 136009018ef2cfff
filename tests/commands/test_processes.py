"""The processes of `--jobs`: an interrupt ends them wherever it falls, what cannot be pickled or read is told."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from support.few_files import files_left

from vibcli.cli.processes import Processes, interrupts_held

ROOT = Path(__file__).parents[2]
DRIVEN = """
import os
import signal
import sys
from contextlib import suppress
from multiprocessing import active_children

from vibcli.__main__ import _raised_anew
from vibcli.cli.jobs import in_processes

sys.unraisablehook = _raised_anew       # as in the program: one that falls into the end of an object comes behind it
OURS = os.getpid()


def opcodes(packages, interrupted=0):
    'How many opcodes there are in these packages; an interrupt comes before the one of that number.'
    seen = 0

    def local(frame, event, arg):
        nonlocal seen
        if event == "opcode":
            seen += 1
            if seen == interrupted:
                sys.settrace(None)
                signal.raise_signal(signal.SIGINT)
        return local

    def entered(frame, event, arg):
        if os.getpid() == OURS and frame.f_globals.get("__name__", "").split(".")[0] in packages:
            frame.f_trace_opcodes = True
            return local

    sys.settrace(entered)
    try:
        list(in_processes(abs, range(4), 2, lambda found: False, None))
    finally:
        sys.settrace(None)
    return seen


opcodes(("threading",))
for packages, most in ((("threading",), 1000), (("vibcli", "multiprocessing", "concurrent"), 150)):
    total = opcodes(packages)
    for number in range(min(total, most)):
        with suppress(KeyboardInterrupt):
            opcodes(packages, 1 + number * total // min(total, most))
print(total > 1000)
for child in active_children():
    child.kill()
"""


@pytest.mark.sweep
def test_an_interrupt_ends_the_processes_wherever_it_falls():
    """Between taking a lock and the block that gives it back, too: nothing waits for ever, nothing is printed."""
    done = subprocess.run([sys.executable, "-c", DRIVEN], capture_output=True, text=True, cwd=ROOT, timeout=300)
    assert (done.returncode, done.stdout, done.stderr) == (0, "True\n", "")


class Unreadable(Exception):
    """An exception that is pickled and cannot be read."""

    def __init__(self, one, two):
        super().__init__(f"{one} {two}")


def raises(error, *given):
    raise error(*given)


def gives_what_cannot_be_pickled():
    return lambda: 0


def test_what_a_task_raises_is_raised_here_and_the_others_are_done():
    with Processes(2, "fork") as pool:
        tasks = [pool.submit(raises, KeyError, "x"), pool.submit(raises, Unreadable, 1, 2),
                 pool.submit(gives_what_cannot_be_pickled), pool.submit(str, Unreadable(1, 2)),
                 pool.submit(lambda: 0), pool.submit(abs, -3)]
        assert tasks[5].result() == 3
        for task, error in zip(tasks, (KeyError, TypeError, TypeError, TypeError, Exception), strict=False):
            with pytest.raises(error):
                task.result()
        assert pool.submit(abs, -4).result() == 4


def test_where_few_files_may_be_opened_there_are_fewer():
    with files_left(15), Processes(6, "fork") as pool:
        tasks = [pool.submit(abs, -number) for number in range(6)]
        assert [task.result() for task in tasks] == list(range(6))
        assert 1 <= len(pool._processes) <= 3


@pytest.mark.sweep
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_they_end_with_the_process_that_began_them(start):
    """Though that is killed: those at work and those that have nothing to do; they have its stdout, which ends so."""
    text = ("import signal\nfrom vibcli.cli.processes import Processes\n"
            f"pool = Processes(3, {start!r})\n"
            "first, *others = [pool.submit(abs, -1), pool.submit(signal.pause), pool.submit(signal.pause)]\n"
            "print(first.result(), flush=True)\nsignal.pause()\n")
    process = subprocess.Popen([sys.executable, "-c", text], cwd=ROOT, text=True, start_new_session=True,
                               stdout=subprocess.PIPE)
    try:
        assert process.stdout.readline() == "1\n"
        process.kill()
        assert process.communicate(timeout=120) == ("", None)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        raise


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_that_is_held_comes_afterwards(number):
    done, before = [], signal.signal(number, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            with interrupts_held():
                signal.raise_signal(number)
                done.append(1)
            done.append(2)
        assert done == [1] and signal.getsignal(number) is signal.default_int_handler
    finally:
        signal.signal(number, before)
