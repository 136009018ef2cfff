"""Integrals over shapes as sums over cells of equal width, and by Gauss's quadratures of few points."""

from collections.abc import Callable, Iterator

import numpy as np

from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

CELLS = (1, 3, 10, 30, 100, 300, 1000)
POINTS = (1, 2, 4, 8, 16, 32)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """With more and more along each side; one of what is no integral."""
    integral, spread = subject.data
    if not spread:
        yield MethodRun("the formula in floats", "", lambda _: MethodAnswer([integral(lambda _: _midpoints(1))]))
        return
    for method, rule, numbers in (("cells", _midpoints, CELLS), ("Gauss", np.polynomial.legendre.leggauss, POINTS)):
        for n in numbers:
            yield MethodRun(method, str(n), _run(integral, rule, n))


def _run(integral: Callable[..., float], rule: Callable[..., tuple[np.ndarray, np.ndarray]],
         n: int) -> Callable[[Deadline], MethodAnswer]:
    def run(_: Deadline) -> MethodAnswer:
        return MethodAnswer([integral(lambda _: rule(n))])

    return run


def _midpoints(n: int) -> tuple[np.ndarray, np.ndarray]:
    return (2 * np.arange(n) + 1) / n - 1, np.full(n, 2 / n)
