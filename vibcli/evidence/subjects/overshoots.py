"""How far a signal goes beyond what it comes to, relative to its way there: (max − final)/(final − start), of falling
ones with min."""

from fractions import Fraction
from typing import TYPE_CHECKING

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import at_instant, extremes
from vibcli.evidence.reference.outputs import signal
from vibcli.evidence.subject import Subject, of_signal
from vibcli.evidence.subjects.long_after import limit
from vibcli.evidence.subjects.motions import KINDS, compared_with, followed
from vibcli.quantities.expression import measure

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

ENOUGH = 30         # digits of the difference of what it comes to and where it starts


def overshoot(problem: "Problem", tree: "QuantityRef") -> Subject:
    """overshoot(x); others find its extreme."""
    found, _ = measure(problem, tree)           # refused where there is none
    kind, motion = followed(problem)
    motion, node = signal(problem, motion, tree.args[0])
    end, until = limit(problem, tree).true, Fraction(problem.response.until)
    start = at_instant(motion, node, Fraction(0), problem.work)
    with mpmath.workdps(max(end.working, start.working)):
        way = end.values[0] - start.values[0]
        top = extremes(motion, node, until, 1 if way > 0 else -1, False, problem.work)
        digits = min(end.digits, start.digits, top.digits)
        if abs(way) * mpmath.mpf(10) ** (digits - ENOUGH) < max(end.about, top.about):
            raise PhysicsError("the reference finds too few digits of a signal that ends near where it starts")
        true = top._replace(values=[max(mpmath.mpf(0), (top.values[0] - end.values[0]) / way)], digits=digits,
                            about=found or 1.0)
    plain = compared_with(problem, motion, node, until, "max" if way > 0 else "min")
    last, far = float(end.values[0]), float(way)

    def read(states: np.ndarray, times: np.ndarray) -> float:
        return max(0.0, (plain.read(states, times) - last) / far)

    return of_signal(KINDS[kind], problem, tree, f"of {problem.response.words}", true, plain._replace(read=read))
