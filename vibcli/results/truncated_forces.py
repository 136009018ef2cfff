"""Series of the forces of springs beside the forces themselves, where a motion starts."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.characteristics import characteristic
from vibcli.mechanics.signals import moving
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import called_functions

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


class TruncatedForce(NamedTuple):
    """The deflection of a spring, its force there, and what its series about zero deflection gives."""

    spring: str
    deflection: float
    force: float
    series: float


def truncated_forces(problem: "Problem", order: int) -> list[TruncatedForce]:
    """Of springs whose force is no polynomial but has a series to the power `order`, where `initial` deflects them."""
    if problem.numeric.has_free_symbols or not problem.spec.get("initial"):
        return []
    found = [_truncated(problem, name, order) for name in problem.spec.get("springs") or ()]
    return [one for one in found if one is not None]


def _truncated(problem: "Problem", name: str, order: int) -> TruncatedForce | None:
    floats = problem.numeric.floats
    try:
        law = characteristic(problem.scene, name)
        if not called_functions([law.force]):
            return None
        factors = [law.coefficient(n, Floats, floats) for n in range(order + 1)]
        place, _ = problem.initial.start
        D, = evaluate([moving(problem.system, f"{name}.deflection")], Floats, {**floats, **place})
    except PhysicsError:
        return None
    force = law.at(Floats, floats, D)
    return TruncatedForce(name, D, force, sum(c * D**n for n, c in enumerate(factors))) if D else None
