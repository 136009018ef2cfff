"""What may be asked: the quantities that `answers` knows, and the words of `find`."""

from vibcli import units

FIND = ("equations", "energies", "equilibrium", "equilibria", "frequencies", "modes", "damping")


class Asked:
    """A quantity: the kinds of its indices, the unit of its value (None: settled by its indices), what it is."""

    __slots__ = ("about", "attributes", "indices", "unit")

    def __init__(self, indices, unit, about, attributes=("",)):
        self.indices, self.unit, self.about, self.attributes = indices, unit, about, attributes


ASKED = {
    "omega": Asked(("mode",), "rad/s", "natural angular frequency of mode i, the dampers left out"),
    "frequency": Asked(("mode",), "Hz", "natural frequency of mode i"),
    "period": Asked(("mode",), "s", "period of mode i"),
    "growth_rate": Asked(("mode",), "1/s", "growth rate of unstable mode i"),
    "mode": Asked(("mode", "coordinate"), None,
                  "amplitude of a coordinate in mode i, the first coordinate that moves being 1"),
    "zeta": Asked(("mode",), "1", "damping ratio of damped mode i, by ascending |λ|"),
    "omega_d": Asked(("mode",), "rad/s", "damped angular frequency of damped mode i"),
    "decay": Asked(("mode",), "1/s", "decay −Re λ of damped mode i"),
    "equilibrium": Asked(("coordinate",), None, "a coordinate in equilibrium"),
    "stable": Asked((), "1", "`true` where the equilibrium is stable"),
    "equilibria": Asked((), "1", "number of equilibria within the bounds that `find` gives, or default ones; a line of "
                        "neutral ones counts once"),
    "equation": Asked(("coordinate",), None,
                      "equation of small oscillations, the coordinates counted from equilibrium"),
    "motion": Asked(("coordinate",), None, "full equation of motion"),
    "M": Asked(("coordinate", "coordinate"), None, "entry of the mass matrix"),
    "C": Asked(("coordinate", "coordinate"), None, "entry of the damping matrix"),
    "G": Asked(("coordinate", "coordinate"), None, "entry of the gyroscopic matrix"),
    "K": Asked(("coordinate", "coordinate"), None, "entry of the stiffness matrix"),
    "T": Asked((), "J", "kinetic energy, as a function of coordinates and velocities"),
    "V": Asked((), "J", "potential energy, up to a constant"),
    "Phi": Asked((), "W", "dissipation function"),
    "J": Asked(("body", "place"), "kg*m^2", "moment of inertia of a body about its mass centre, or about a point"),
    "centre": Asked(("body",), "m", "mass centre of a body as drawn", ("x", "y")),
}
SEVERAL = ("omega", "frequency", "period", "growth_rate", "equilibrium", "stable")  # a last index: which equilibrium
STATE_FUNCTIONS = ("T", "V", "Phi", "equation", "motion")
OF_SPEED = {key: units.times(units.parse_unit("J").dimension, units.TIME, power)  # of the matrix times two coordinates
            for key, power in (("M", 2), ("C", 1), ("G", 1), ("K", 0))}


def dimension(head, indices, coordinate):
    """The dimension of a quantity; `coordinate(name)` gives that of a coordinate. None where any fits."""
    asked = ASKED[head]
    if asked.unit is not None:
        return units.parse_unit(asked.unit).dimension
    if head == "equilibrium":
        return coordinate(indices[0])
    if head in OF_SPEED:
        return units.times(units.times(OF_SPEED[head], coordinate(indices[0]), -1), coordinate(indices[1]), -1)
    return None
