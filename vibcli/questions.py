"""What may be asked: the quantities that `answers` knows, and the words of `find`."""

from vibcli import units

INSIGHT = ("shares", "sensitivities", "estimates")
ON_REQUEST = ("equilibria", "reactions", *INSIGHT)                    # found only where they are asked for
FIND = ("equations", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work", *ON_REQUEST)


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
    "mode": Asked(("mode", "signal"), None,
                  "amplitude of a coordinate or signal in mode i, the first coordinate that moves being 1"),
    "zeta": Asked(("mode",), "1", "damping ratio of damped mode i, by ascending |λ|"),
    "omega_d": Asked(("mode",), "rad/s", "damped angular frequency of damped mode i"),
    "decay": Asked(("mode",), "1/s", "decay −Re λ of damped mode i"),
    "sensitivity": Asked(("mode", "parameter"), None, "derivative of the natural angular frequency of mode i by a "
                         "parameter p that is not defined by others, the shift of the equilibrium included"),
    "rayleigh": Asked((), "rad/s", "Rayleigh's estimate of omega[1] by the static deflection, an upper bound"),
    "dunkerley": Asked((), "rad/s", "Dunkerley's estimate of omega[1], a lower bound"),
    "equilibrium": Asked(("signal",), None, "a coordinate or signal in equilibrium"),
    "Q": Asked(("coordinate",), None, "generalised force of weights, springs and steady loads at rest, δA = Σ Q δq"),
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
BARE = tuple(head for head, asked in ASKED.items() if not asked.indices)
STATE_FUNCTIONS = ("T", "V", "Phi", "Q", "equation", "motion")
OF_SPEED = {key: units.times(units.parse_unit("J").dimension, units.TIME, power)  # of the matrix times two coordinates
            for key, power in (("M", 2), ("C", 1), ("G", 1), ("K", 0))}


def dimension(head, indices, of):
    """The dimension of a quantity; `of(name)` gives that of a coordinate, signal or parameter. None where any fits."""
    asked = ASKED[head]
    if asked.unit is not None:
        return units.parse_unit(asked.unit).dimension
    if head == "equilibrium":
        return of(indices[0])
    if head == "Q":
        return units.times(OF_SPEED["K"], of(indices[0]), -1)
    if head == "sensitivity":
        return units.times(units.parse_unit("rad/s").dimension, of(indices[1]), -1)
    if head in OF_SPEED:
        return units.times(units.times(OF_SPEED[head], of(indices[0]), -1), of(indices[1]), -1)
    return None
