"""Peaks, minima and half-power points of |H| as they are read off a grid of frequencies: 100 … 10⁶ points, LU of each
matrix; the largest of three neighbours, and the top of the parabola through them; the straight line between two."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from vibcli.evidence.reference.frequency_response import fallen, state_matrix, tops, values
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

POINTS = (100, 1000, 10_000, 100_000, 1_000_000)
AT_ONCE = 20_000
PAST = 2.0              # times the highest natural frequency, where the grid ends


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """A grid of each size, and again with parabolas where these tell of a place."""
    straight = subject.data[2] == "half_power"
    for name, bent in (("grid", False), *[("grid with parabolas", True)] * (not straight)):
        for points in POINTS:
            yield MethodRun(name, f"{points} points", partial(_read, subject, points, bent))


def _read(subject: Subject, points: int, bent: bool, deadline: Deadline) -> MethodAnswer:
    curve, number, feature = subject.data
    highest = np.abs(np.linalg.eigvals(state_matrix(*curve[:3]))).max()
    Omega = np.linspace(0.0, PAST * highest, points + 1)[1:]
    parts = []
    for start in range(0, points, AT_ONCE):
        deadline.check()
        parts.append(np.abs(values(curve, Omega[start:start + AT_ONCE])))
    size, which = np.concatenate(parts), (number + 1) // 2 if feature == "half_power" else number
    found = tops(-size if feature == "antiresonance" else size)
    if len(found) < which:
        raise RuntimeError(f"{len(found)} of them on this grid")
    i = found[which - 1]
    if feature == "half_power":
        return MethodAnswer([fallen(size, Omega, Omega[i], number % 2 == 1)])
    low, top, high = size[i - 1:i + 2]
    move = 0.5 * (low - high) / (low - 2 * top + high) if bent else 0.0
    value = top - 0.25 * (low - high) * move
    return MethodAnswer([value if feature == "value" else Omega[i] + move * (Omega[1] - Omega[0])])
