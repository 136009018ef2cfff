"""Whole processes: processor time and peak memory of commands, run by turns so that all see the same machine; what
child processes print.

Processor time (user and system) rather than the clock's, so that a busy machine does not decide; on an idle one the two
agree, since every process has one thread.
"""

import os
import subprocess
import sys
from importlib.util import find_spec
from statistics import median
from time import perf_counter
from typing import Any

VIBCLI = os.path.join(os.path.dirname(sys.executable), "vibcli")
# As installed, with bytecode, and one BLAS thread: threads that wait for a busy core spoil either side by turns.
# Results that were kept are not taken.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"} | {
    "OPENBLAS_NUM_THREADS": "1", "VIBCLI_NO_CACHE": "1"}


def vibcli(*args: Any) -> list[str]:
    """The argument list of a vibcli command."""
    return [VIBCLI, *args] if os.path.exists(VIBCLI) else [sys.executable, "-m", "vibcli", *args]


def installed(package: str) -> bool:
    """Is a peer there? (`pip install -e ".[bench]"`)"""
    return find_spec(package) is not None


def python(code: Any, *args: Any) -> list[str]:
    return [sys.executable, "-c", code, *args]


class Cost:
    """Medians over the runs: milliseconds of processor time and of the clock, mebibytes of peak resident memory."""

    __slots__ = ("elapsed", "memory", "time")

    def __init__(self, runs: Any):
        self.time, self.elapsed = (median(run[i] for run in runs) * 1e3 for i in (0, 2))
        self.memory = median(run[1] for run in runs) / 1024


def run(command: Any, expected: Any = (0,)) -> tuple[float, int, float]:
    """(processor seconds, peak KiB, seconds) of one run; RuntimeError where its exit code is none of those expected.

    The peak counts that of the process which starts it, so this one must stay small.
    """
    nothing = [(os.POSIX_SPAWN_OPEN, stream, os.devnull, os.O_RDWR, 0) for stream in (0, 1, 2)]
    start = perf_counter()
    _, status, usage = os.wait4(os.posix_spawn(command[0], command, ENVIRONMENT, file_actions=nothing), 0)
    code = os.waitstatus_to_exitcode(status)
    if code not in expected:
        raise RuntimeError(f"{' '.join(command)} left with exit code {code}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss, perf_counter() - start


def costs(commands: Any, runs: Any, warm: bool = False) -> dict[str, Cost]:
    """{name: Cost} of {name: (command, expected exit codes)}, all run once a round; the first round does not count,
    unless all is `warm` already."""
    measured = {name: [] for name in commands}
    for round_ in range(warm, runs + 1):
        for name, (command, expected) in commands.items():
            found = run(command, expected)
            if round_:
                measured[name].append(found)
    return {name: Cost(found) for name, found in measured.items()}


def answer(code: Any, *args: Any) -> str:
    """What a fresh process prints; RuntimeError with the last that it says where it fails."""
    done = subprocess.run(python(code, *map(str, args)), capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode:
        raise RuntimeError((done.stderr.strip() or f"exit code {done.returncode}").splitlines()[-1])
    return done.stdout
