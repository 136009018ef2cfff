"""The force of a spring or damper as a function of its deflection D (of dampers its rate), from the laws of its parts
as the file gives them. Those side by side add up; those in series have one force F, found by Newton's method,

    F ← (D − Σ dᵢ + Σ Fᵢ/Fᵢ′)/Σ 1/Fᵢ′,      dᵢ ← dᵢ + (F − Fᵢ)/Fᵢ′,       as D is followed from 0 on,

in numbers of any kind.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.language.reader import Expression
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem

FOLLOWED, STEPS = 4, 100        # parts of the way to D; steps of Newton's method
JOINED = "series", "parallel"


class LawInNumbers(NamedTuple):
    """A law, or one of parts that are `joined` in series or parallel: force(d) gives (F, dF/dd) of a single one."""

    force: Callable[[Any], tuple[Any, Any]] | None
    joined: str = ""
    parts: "tuple[LawInNumbers, ...]" = ()

    def at(self, D: Any) -> tuple[Any, Any]:
        """(F, dF/dD)"""
        if self.force is not None:
            return self.force(D)
        if self.joined == "parallel":
            F, slopes = zip(*(part.at(D) for part in self.parts), strict=True)
            return sum(F), sum(slopes)
        if not D:
            return D, None
        d = [D / (FOLLOWED * len(self.parts))] * len(self.parts)
        for k in range(1, FOLLOWED + 1):
            d = self._along(d, D * k / FOLLOWED)
        return self._joint(d, D)

    def _along(self, d: list[mpmath.mpf], D: mpmath.mpf) -> list[mpmath.mpf]:
        """The deflections of parts in series that add up to D, from others near by."""
        last = None
        for _ in range(STEPS):
            found = [part.at(x) for part, x in zip(self.parts, d, strict=True)]
            F = self._joint_of(found, d, D)[0]
            steps = [(F - force) / slope for force, slope in found]
            d = [x + step for x, step in zip(d, steps, strict=True)]
            size = max(map(abs, steps))
            if not size or (last is not None and size >= last and size < 1e-8 * abs(D)):
                return d
            last = size
        raise RuntimeError("Newton's method does not end")

    def _joint(self, d: list[mpmath.mpf], D: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
        return self._joint_of([part.at(x) for part, x in zip(self.parts, d, strict=True)], d, D)

    def _joint_of(self, found: Sequence[tuple[mpmath.mpf, mpmath.mpf]], d: Sequence[mpmath.mpf],
                  D: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
        soft = sum(1 / slope for _, slope in found)
        return (D - sum(d) + sum(force / slope for force, slope in found)) / soft, 1 / soft


def law_of(problem: "Problem", record: "Record", arithmetic: Any, known: Mapping[str, Any]) -> LawInNumbers:
    """That of a spring or damper, or of a part of one, in the numbers of an arithmetic."""
    for key in JOINED:
        if key in record:
            return LawInNumbers(None, key, tuple(law_of(problem, part, arithmetic, known) for part in record[key]))
    scene = problem.scene
    x, law = scene.table.variable("the deflection"), record.get("law")
    if law is not None and not isinstance(law, Expression):
        raise PhysicsError("no reference is found of laws from tables")
    if law is not None:
        node = scene.lower(law, ("v" if "c" in record.element.fields else "d", x))
    else:
        node = scene.lower(record[next(key for key in ("k", "c", "torsion") if key in record)]) * x
    nodes = [node, gradient(node).get(x, scene.table.zero)]
    return LawInNumbers(lambda d: tuple(evaluate(nodes, arithmetic, {**known, x.name: d})))


def true_law(problem: "Problem", record: "Record") -> LawInNumbers:
    """The same at the working precision."""
    arithmetic = multiprecision()
    return law_of(problem, record, arithmetic, problem.numeric.values(arithmetic))


def true_force(problem: "Problem", record: "Record", deflection: Callable[[], Any]) -> TrueValues:
    """At a deflection, which is given at the working precision."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        force = true_law(problem, record).at(deflection())[0]
        return [force], abs(force) or mpmath.mpf(1)

    return settled(found, sized=True)
