"""H at one frequency: LU of the matrix there, and sums of 1 … n undamped modes, without what couples them in C."""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np

from vibcli.evidence.reference.frequency_response import values
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """LU, and sums of modes where M and K are symmetric."""
    import scipy.linalg  # noqa: F401

    curve, *_ = subject.data
    yield MethodRun("numpy solve", "", lambda _: _found(subject, values(curve, np.array([subject.data[1]]))[0]))
    if (curve.K == curve.K.T).all() and (curve.C == curve.C.T).all():
        for count in range(1, len(curve.M) + 1):
            yield MethodRun("modal superposition", f"{count} mode{'s' * (count > 1)}", partial(_sum, subject, count))


def _sum(subject: Subject, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    curve, Omega, _ = subject.data
    s = 1j * Omega
    b, c = (part[0] + s * (part[1] + s * part[2]) for part in (curve.b, curve.c))
    squares, shapes = scipy.linalg.eigh(curve.K, curve.M)
    H = curve.d[0] + s * (curve.d[1] + s * curve.d[2])
    for square, shape in zip(squares[:count], shapes.T[:count], strict=True):
        H += (c @ shape) * (shape @ b) / (square + s * (shape @ curve.C @ shape) + s * s)
    return _found(subject, H)


def _found(subject: Subject, H: Any) -> MethodAnswer:
    return MethodAnswer([subject.data[2](H)])
