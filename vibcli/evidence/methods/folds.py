"""Folds by SciPy's roots: MINPACK's hybr and lm, with differences for derivatives."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, cast

from vibcli.evidence.methods.static_positions import TOLERANCES
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject
from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    import numpy as np


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Each at tolerances of position, parameter and motion."""
    for method in ("hybr", "lm"):
        for tolerance in TOLERANCES:
            yield MethodRun(f"root {method}", f"{tolerance:.0e}", partial(_found, subject, method, tolerance))


def _found(subject: Subject, method: str, tolerance: float, deadline: Deadline) -> MethodAnswer:
    from scipy.optimize import root

    fold, start, node = subject.data

    def residual(y: "np.ndarray") -> "list[float]":
        deadline.check()
        return cast("list[float]", fold.residual(y.tolist(), Floats))

    found = root(residual, start, method=method, options={"xtol": tolerance}).x.tolist()
    return MethodAnswer([float(fold.read(node, found, Floats))])
