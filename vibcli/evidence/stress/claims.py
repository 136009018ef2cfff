"""What is stated of a scene: numbers with bounds of their errors, each beside its true one."""

from typing import Any

import mpmath

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.subject import Subject
from vibcli.quantities.expression import measure
from vibcli.results.problem import Problem

ROUNDED = 2.0**-53


class Claim(NamedTuple):
    """error, bound and rounding of a number, relative to its size or to that of its motion."""

    error: float
    bound: float
    rounding: float = ROUNDED

    def ratio(self) -> tuple[bool, float]:
        """By how much its error exceeds its bound; what is no number first."""
        return not self.error < float("inf"), self.error / max(self.bound, 1e-300)


def claims(problem: Problem, subject: Subject) -> list[Claim]:
    """The Claims of a fresh problem about what a Subject asks; PhysicsError where it refuses."""
    if subject.kind == "modes":
        return _beside([(complex(mode.growth_rate or 0.0, mode.omega or 0.0), mode.error)
                        for mode in problem.modal.modes], subject.true)
    if subject.asked == "omega":
        return _beside([(complex(mode.growth_rate or 0.0, mode.omega or 0.0), mode.error)
                        for mode in problem.modal.modes], subject.true)
    if subject.asked == "eigenvalue":
        return _beside([(complex(mode.eigenvalue), mode.error) for mode in problem.modal.damped], subject.true)
    (asked,) = [answer.asked.tree for answer in problem.spec.answers]
    value, bound = measure(problem, asked)
    size = abs(complex(value))
    scale = subject.scale if subject.kind in ("motion", "full motion") else size
    error = subject.error([value], subject.true)
    return [Claim(error, float(bound) * size / scale, ROUNDED * size / scale)]


def _beside(found: list[tuple[complex, Any]], true: Any) -> list[Claim]:
    """Each λ beside the true one next to it; infinite errors where their counts differ."""
    if len(found) != len(true.values):
        return [Claim(float("inf"), 0.0)]
    with mpmath.workdps(true.working):
        left = list(found)
        claimed = []
        for exact in sorted(true.values, key=abs, reverse=True):
            nearest = min(range(len(left)), key=lambda i: abs(left[i][0] - exact))
            value, bound = left.pop(nearest)
            size = abs(exact) or abs(mpmath.mpmathify(value)) or mpmath.mpf(1)
            claimed.append(Claim(float(abs(value - exact) / size), float(bound)))
        return claimed
