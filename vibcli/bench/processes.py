"""Whole processes: processor time and peak memory of commands, run by turns so that all see the same machine.

Processor time (user and system) rather than the clock's, so that a busy machine does not decide; on an idle one the two
agree, since every process has one thread.
"""

import os
import subprocess
import sys
from statistics import median
from typing import Any

VIBCLI = os.path.join(os.path.dirname(sys.executable), "vibcli")
# As installed, with bytecode, and one BLAS thread: threads that wait for a busy core spoil either side by turns.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"} | {
    "OPENBLAS_NUM_THREADS": "1"}


def vibcli(*args: Any):
    """The argument list of a vibcli command."""
    return [VIBCLI, *args] if os.path.exists(VIBCLI) else [sys.executable, "-m", "vibcli", *args]


def python(code: Any, *args: Any):
    return [sys.executable, "-c", code, *args]


class Cost:
    """Medians over the runs: milliseconds of processor time, and mebibytes of peak resident memory."""

    __slots__ = ("memory", "time")

    def __init__(self, runs: Any):
        self.time = median(seconds for seconds, _ in runs) * 1e3
        self.memory = median(kib for _, kib in runs) / 1024


def run(command: Any, expected: Any = (0,)):
    """(processor seconds, peak KiB) of one run; RuntimeError where its exit code is none of those expected.

    The peak counts that of the process which starts it, so this one must stay small.
    """
    nothing = [(os.POSIX_SPAWN_OPEN, stream, os.devnull, os.O_RDWR, 0) for stream in (0, 1, 2)]
    _, status, usage = os.wait4(os.posix_spawn(command[0], command, ENVIRONMENT, file_actions=nothing), 0)
    code = os.waitstatus_to_exitcode(status)
    if code not in expected:
        raise RuntimeError(f"{' '.join(command)} left with exit code {code}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def costs(commands: Any, runs: Any):
    """{name: Cost} of {name: (command, expected exit codes)}, all run once a round; the first round does not count."""
    measured = {name: [] for name in commands}
    for round_ in range(runs + 1):
        for name, (command, expected) in commands.items():
            found = run(command, expected)
            if round_:
                measured[name].append(found)
    return {name: Cost(found) for name, found in measured.items()}


def answer(code: Any, *args: Any):
    """What a fresh process prints."""
    return subprocess.run(python(code, *map(str, args)), check=True, stdout=subprocess.PIPE, text=True,
                          env=ENVIRONMENT).stdout
