"""SciPy's root for the deflections of parts in series, whose forces are equal; MINPACK's hybr and lm."""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.evidence.reference.laws import LawInNumbers
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

if TYPE_CHECKING:
    import numpy as np

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Each at tolerances of the deflections; one without where nothing is in series."""
    law, D = subject.data
    if not _is_solved(law):
        yield MethodRun("the law in floats", "", lambda _: MethodAnswer([law.at(D)[0]]))
        return
    for method in ("hybr", "lm"):
        for tolerance in TOLERANCES:
            yield MethodRun(f"root {method}", f"{tolerance:.0e}", partial(_found, law, D, method, tolerance))


def _is_solved(law: LawInNumbers) -> bool:
    return law.joined == "series" or any(map(_is_solved, law.parts))


def _found(law: LawInNumbers, D: "np.ndarray", method: str, tolerance: float, deadline: Deadline) -> MethodAnswer:
    return MethodAnswer([_force(law, D, method, tolerance, deadline)])


def _force(law: LawInNumbers, D: Any, method: str, tolerance: float, deadline: Deadline) -> float:
    """Of parts in series that of the first."""
    from scipy.optimize import root

    deadline.check()
    if not law.parts:
        return float(law.at(float(D))[0])

    def forces(d: Sequence[float]) -> list[float]:
        return [_force(part, x, method, tolerance, deadline) for part, x in zip(law.parts, d, strict=True)]

    if law.joined == "parallel":
        return sum(forces([D] * len(law.parts)))

    def residual(d: Sequence[float]) -> list[float]:
        first, *others = forces(d)
        return [sum(d) - D, *(first - other for other in others)]

    start = [D / len(law.parts)] * len(law.parts)
    return forces(root(residual, start, method=method, options={"xtol": tolerance}).x)[0]
