"""`lsim` of SciPy for linear motions: loads are straight lines between equal steps, exact where records have samples
at them."""

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from vibcli.evidence.plain_equations import PlainEquations
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

STEPS = (100, 1000, 10_000, 100_000, 1_000_000)
PARTS = (1, 10, 100)        # of the steps that have all samples of a record among them
MOST = 1_000_000
FEWEST = range(1, 1001)     # parts of the time between two samples, one of which ends where the motion does


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """With more and more steps; those of a record and parts of them, where one drives."""
    import scipy.signal  # noqa: F401

    if subject.data is None or subject.data.linear is None or not subject.data.times[-1]:
        return
    until = subject.data.times[-1]
    for steps in _steps(subject.data.linear.instants, until):
        yield MethodRun("lsim", f"{steps} steps", partial(_held, subject.data, steps))


def _steps(instants: Sequence[float], until: float) -> Sequence[int]:
    """The numbers of steps that are tried: of parts of the shortest time between two samples, where records drive."""
    apart = np.diff(np.unique(instants)) if len(instants) > 1 else np.array([])
    apart = apart[apart > 1e-9 * until]
    if not len(apart):
        return STEPS
    part = next((part for part in FEWEST if _is_whole(until * part / apart.min())), 1)
    least = max(1, round(until * part / apart.min()))
    return [least * part for part in PARTS if least * part <= MOST]


def _is_whole(number: float) -> bool:
    return abs(number - round(number)) < 1e-6 < number


def _held(plain: PlainEquations, steps: int, deadline: Deadline) -> MethodAnswer:
    from scipy.signal import lsim

    A, B, inputs, _ = plain.linear
    times = np.linspace(0.0, plain.times[-1], steps + 1)
    pushed = inputs(times)
    deadline.check()
    states = lsim((A, B, np.eye(len(A)), np.zeros_like(B)), pushed, times, plain.start)[1]
    return MethodAnswer([plain.read(states.reshape(len(times), -1), times)])
