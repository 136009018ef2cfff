"""Energies and equations of motion: functions of coordinates and velocities, compared as such."""

from vibcli.base.errors import PhysicsError
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import EQUATION, FUNCTION, Declaration


def _require_no_damping(problem):
    if problem.spec.get("damping") is not None:
        raise PhysicsError("`damping` of a scene acts in its small oscillations: the full equations are without it",
                           "ask for equation[…] or C[…]")


def _motion(problem, tree):
    from vibcli.mechanics.lagrange import equation_of

    _require_no_damping(problem)
    if problem.spec.expanded:
        return problem.symbolic.expanded_equations[0][coordinate_number(problem, tree.indices[0])]
    return equation_of(problem.scene, coordinate_number(problem, tree.indices[0]))


def _energy(problem, tree):
    from vibcli.mechanics.energies import dissipation, kinetic, potential

    if tree.head == "Phi":
        _require_no_damping(problem)
    return {"T": kinetic, "V": potential, "Phi": dissipation}[tree.head](problem.scene)


def _scalar(about, unit):
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
