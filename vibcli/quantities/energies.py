"""Energies and equations of motion: functions of coordinates and velocities, compared as such."""

from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import EQUATION, FUNCTION, Declaration


def _motion(problem, tree):
    from vibcli.mechanics.lagrange import equation_of

    return equation_of(problem.scene, coordinate_number(problem, tree.indices[0]))


def _energy(problem, tree):
    from vibcli.mechanics.energies import dissipation, kinetic, potential

    return {"T": kinetic, "V": potential, "Phi": dissipation}[tree.head](problem.scene)


def _scalar(about, unit):
    return Declaration(about, unit, kind=FUNCTION, symbolic=_energy)


QUANTITIES = {
    "equation": Declaration("equation of small oscillations, the coordinates counted from equilibrium",
                            indices=("coordinate",), kind=EQUATION),
    "motion": Declaration("full equation of motion", indices=("coordinate",), kind=EQUATION, symbolic=_motion),
    "T": _scalar("kinetic energy, as a function of coordinates and velocities", "J"),
    "V": _scalar("potential energy, up to a constant", "J"),
    "Phi": _scalar("dissipation function", "W"),
}
