"""Energies and equations of motion: functions of coordinates and velocities, compared as such."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import EQUATION, FUNCTION, Declaration

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _require_no_damping(problem: "Problem") -> None:
    if problem.spec.get("damping") is not None:
        raise PhysicsError("`damping` of a scene acts in its small oscillations: the full equations are without it",
                           "ask for equation[…] or C[…]")


def equation_number(problem: "Problem", name: str) -> int:
    """The number of a coordinate among the equations of motion; refused where that is one of a member."""
    i = coordinate_number(problem, name)
    if any(node.mask & problem.scene.q[i].mask for piece in problem.scene.pieces for node in piece.s):
        raise PhysicsError(f"'{name}' moves a member: its equation is a condition at the end of a "
                           "partial differential one, which `vibcli equations` writes out",
                           "ask for frequencies, modes or frequency responses")
    return i


def _motion(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.lagrange import equation_of

    _require_no_damping(problem)
    i = equation_number(problem, tree.indices[0])
    if problem.spec.expanded:
        return problem.symbolic.expanded_equations[0][i]
    return equation_of(problem.scene, i)


def require_sum(problem: "Problem", head: str) -> None:
    """Refuse an energy or Φ that `damping` or members have a part in."""
    if head == "Phi":
        _require_no_damping(problem)
    if any(head != "Phi" or not piece.drag.is_zero for piece in problem.scene.pieces):
        raise PhysicsError(f"{head} of members is an integral along them, which `vibcli equations` writes out",
                           "ask for frequencies, modes or frequency responses")


def _energy(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.energies import dissipation, kinetic, potential

    require_sum(problem, tree.head)
    return {"T": kinetic, "V": potential, "Phi": dissipation}[tree.head](problem.scene)


def _scalar(about: str, unit: str) -> Declaration:
    return Declaration(about, unit, kind=FUNCTION, symbolic=_energy)


QUANTITIES = {
    "equation": Declaration("equation of small oscillations, the coordinates counted from equilibrium",
                            indices=("coordinate",), kind=EQUATION),
    "motion": Declaration("full equation of motion; with motion: {order: 3} the one that is expanded so",
                          indices=("coordinate",), kind=EQUATION, symbolic=_motion),
    "T": _scalar("kinetic energy, as a function of coordinates and velocities", "J"),
    "V": _scalar("potential energy, up to a constant", "J"),
    "Phi": _scalar("dissipation function", "W"),
}
