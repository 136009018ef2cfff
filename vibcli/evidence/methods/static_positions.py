"""Static positions by SciPy's roots of the forces at rest: MINPACK's hybr and lm, with differences for derivatives."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.evaluation_code import in_floats
from vibcli.symbolic.expression_graph import evaluable

if TYPE_CHECKING:
    import numpy as np

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Each at tolerances of the position."""
    for method in ("hybr", "lm"):
        for tolerance in TOLERANCES:
            yield MethodRun(f"root {method}", f"{tolerance:.0e}", partial(_root, subject, method, tolerance))


def _root(subject: Subject, method: str, tolerance: float, deadline: Deadline) -> MethodAnswer:
    from scipy.optimize import root

    static, node, start = subject.data
    known = dict(subject.problem.numeric.floats)
    function = in_floats(static.residuals, evaluable(static.residuals))

    def residual(x: "np.ndarray") -> "list[float]":
        deadline.check()
        known.update(zip(static.names, map(float, x), strict=True))
        return function(known, None)

    found = root(residual, start, method=method, options={"xtol": tolerance})
    known.update(zip(static.names, map(float, found.x), strict=True))
    return MethodAnswer([float(evaluate([node], Arrays, known)[0])])
