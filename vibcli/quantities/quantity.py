"""What may be asked: the quantities that `answers` knows, and the words of `find`."""

from vibcli.base import units
from vibcli.symbolic.syntax import NameRef

INSIGHT = ("shares", "sensitivities", "estimates")
RESPONSES = ("response", "frequency_response")
ON_REQUEST = ("equilibria", "reactions", *RESPONSES, *INSIGHT)                    # found only where they are asked for
FIND = ("equations", "energies", "equilibrium", "frequencies", "modes", "damping", "virtual_work", *ON_REQUEST)


class Asked:
    """A quantity: the kinds of its indices and of its arguments in round brackets, the unit of its value (None:
    settled by its indices; SIGNAL: that of its argument), what it is. An argument in `optional` may be left out."""

    __slots__ = ("about", "args", "attributes", "indices", "optional", "unit")

    def __init__(self, indices, unit, about, attributes=("",), args=(), optional=False):
        self.indices, self.unit, self.about, self.attributes = indices, unit, about, attributes
        self.args, self.optional = args, optional


ROUNDING = 1e-14        # relative, of what is evaluated in floats
SIGNAL = "signal"       # the unit of a number of a signal: that of the signal


def _of_signal(unit, about, indices=()):
    return Asked(indices, unit, about, args=("signal",))


def _of_response(unit, about, indices=(), attributes=("",)):
    return Asked(indices, unit, about, attributes, args=("frf",))


ASKED = {
    "omega": Asked(("mode",), "rad/s", "natural angular frequency of mode i, the dampers left out"),
    "frequency": Asked(("mode",), "Hz", "natural frequency of mode i"),
    "period": Asked(("mode",), "s", "period of mode i; period(x): of the motion of a signal"),
    "growth_rate": Asked(("mode",), "1/s", "growth rate of unstable mode i"),
    "mode": Asked(("mode", "signal"), None,
                  "amplitude of a coordinate or signal in mode i, the first coordinate that moves being 1"),
    "zeta": Asked(("mode",), "1", "damping ratio of damped mode i, by ascending |λ|"),
    "omega_d": Asked(("mode",), "rad/s", "damped angular frequency of damped mode i"),
    "decay": Asked(("mode",), "1/s", "decay ζω of damped mode i: −Re λ, or −(λ₁ + λ₂)/2 where it is over-damped"),
    "eigenvalue": Asked(("mode",), "1/s", "eigenvalue λ = −δ + i ω_d of damped mode i: use re, im, abs or arg of it"),
    "sensitivity": Asked(("mode", "parameter"), None, "derivative of the natural angular frequency of mode i by a "
                         "parameter p that is not defined by others, the shift of the equilibrium included"),
    "rayleigh": Asked((), "rad/s", "Rayleigh's estimate of omega[1] by the static deflection, an upper bound"),
    "dunkerley": Asked((), "rad/s", "Dunkerley's estimate of omega[1], a lower bound"),
    "equilibrium": Asked(("signal",), None, "a coordinate or signal in equilibrium"),
    "Q": Asked(("coordinate",), None, "generalised force of weights, springs and steady loads at rest, δA = Σ Q δq"),
    "stable": Asked((), "1", "`true` where the equilibrium is stable"),
    "equilibria": Asked((), "1", "number of equilibria found within the bounds that `find` gives, or default ones; a "
                        "line of neutral ones counts once"),
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
IN_TIME = {
    "amplitude": _of_signal(SIGNAL, "amplitude of a signal: in the steady state X of its one harmonic, half its range "
                            "where it has several; of a free vibration A of A e^(−δt) cos(ω_d t − φ)"),
    "phase": _of_signal("rad", "lag θ of the steady state X sin(Ωt − θ), −π < θ ≤ π; of a free vibration φ of "
                        "A e^(−δt) cos(ω_d t − φ); of phase(frf[…](…)): −arg"),
    "max": _of_signal(SIGNAL, "largest value from t = 0 on, up to `until` of the response"),
    "min": _of_signal(SIGNAL, "smallest value"),
    "argmax": _of_signal("s", "instant of the largest value"),
    "argmin": _of_signal("s", "instant of the smallest value"),
    "mean": _of_signal(SIGNAL, "mean over a period of the steady state, or of free vibrations that do not die out"),
    "rms": _of_signal(SIGNAL, "root mean square of the same"),
    "final": _of_signal(SIGNAL, "limit for t → ∞"),
    "overshoot": _of_signal("1", "(max − final)/(final − start)"),
    "decrement": _of_signal("1", "logarithmic decrement of a free motion, by successive maxima"),
    "beat_period": _of_signal("s", "period of the beats of two neighbouring frequencies, 2π/|ω₁ − ω₂|"),
    "harmonic": _of_signal(SIGNAL, "amplitude of harmonic n of the periodic steady state", ("number",)),
    "zero": _of_signal("s", "instant of the i-th zero, a start or a touch counting as a passage", ("number",)),
    "time_to": _of_signal("s", "time in which the envelope of a free motion falls to a fraction", ("fraction",)),
    "cycles_to": _of_signal("1", "number of cycles in that time", ("fraction",)),
    "steady": _of_signal(SIGNAL, "steady state of a signal, itself a signal: steady(x)(2 s), max(steady(x))"),
    "transient": _of_signal(SIGNAL, "the rest of a signal, which dies out where the scene is damped"),
    "envelope": _of_signal(SIGNAL, "envelope of a free motion A e^(−δt), itself a signal"),
}
IN_FREQUENCY = {
    "frf": Asked(("output", "input"), None, "complex frequency response of a signal to a unit of a force, of a "
                 "driven point or of the generalised force on a coordinate: use abs, arg, re, im or phase of it",
                 args=("Omega",), optional=True),
    "transmissibility": Asked(("output", "input"), None, "ratio of amplitudes |frf|", args=("Omega",), optional=True),
    "peak": _of_response(None, "i-th peak of |frf|: its place Ω, or its value", ("number",), ("Omega", "value")),
    "antiresonance": _of_response("rad/s", "Ω of the i-th zero of the response, or minimum where it is damped",
                                  ("number",)),
    "half_power": _of_response("rad/s", "Ω at which |frf| is 1/√2 of a peak: 1 and 2 below and above the first peak, 3 "
                                "and 4 the second", ("number",)),
    "fixed_point": _of_response(None, "i-th point through which |frf| passes whatever the damper d is, all else being "
                                "without damping: its place Ω, or its value", ("number", "damper"), ("Omega", "value")),
    "quality": _of_response("1", "quality of the i-th peak, Ω/(Ω₂ − Ω₁) by its half-power points", ("number",)),
    "arg": _of_response("rad", "angle of a complex frequency response"),
    "re": _of_response(None, "real part of a frequency response"),
    "im": _of_response(None, "imaginary part of a frequency response"),
}
ASKED |= IN_TIME | IN_FREQUENCY
INERTIA = Asked(("coordinate", "coordinate"), None, "entry of the mass matrix at an instant", args=("time",))
DECREMENT = Asked(("mode",), "1", "logarithmic decrement of damped mode i, 2πζ/√(1 − ζ²)")
PERIOD = _of_signal("s", "period of the actual motion of a signal")
VALUE = Asked((), SIGNAL, "value of a signal at an instant", args=("signal", "time"))
PARTS = ("steady", "transient", "envelope")      # of signals, signals themselves
SEVERAL = ("omega", "frequency", "period", "growth_rate", "equilibrium", "stable")  # a last index: which equilibrium
BARE = tuple(head for head, asked in ASKED.items() if not asked.indices and not asked.args)
STATE_FUNCTIONS = ("T", "V", "Phi", "Q", "equation", "motion")
OF_SPEED = {key: units.times(units.parse_unit("J").dimension, units.TIME, power)  # of the matrix times two coordinates
            for key, power in (("M", 2), ("C", 1), ("G", 1), ("K", 0))}


def declared(tree):
    """The Asked of a quantity tree; None where there is none."""
    if tree.head == "decrement" and tree.indices:
        return DECREMENT
    if tree.head == "M" and tree.args:
        return INERTIA
    if tree.head == "period" and tree.args:
        return PERIOD
    return VALUE if tree.head == "value" else ASKED.get(tree.head)


ALL = "all of them: vibcli explain quantities"


_INDICES = {"mode": "1", "number": "1", "fraction": "0.1", "output": "x", "input": "F", "damper": "d"}
_ARGS = {"signal": "x", "time": "2 s", "Omega": "5 Hz", "frf": "frf[x, F]"}
OF_VALUES = ("arg", "re", "im")     # take the value of a frequency response


def usage(head):
    """How a quantity is written, with indices and arguments that stand for any."""
    asked = ASKED[head]
    indices = ", ".join(_INDICES.get(kind, kind) for kind in asked.indices)
    args = ", ".join(_ARGS[kind] for kind in asked.args) + (f"({_ARGS['Omega']})" if head in OF_VALUES else "")
    return head + (f"[{indices}]" if indices else "") + (f"({args})" if args else "") + (
        f".{asked.attributes[0]}" if asked.attributes[0] else "")


def dimension(head, indices, of):
    """The dimension of a quantity; `of(name)` gives that of a coordinate, signal or parameter. None where any fits."""
    asked = ASKED[head]
    if asked.unit is not None and asked.unit != SIGNAL:
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


def is_choice(spec, tree):
    """Does a tree ask for a chosen parameter: c, or its second solution c[2]?"""
    choices = spec.get("choose") or ()
    if isinstance(tree, NameRef):
        return tree.name in choices and not tree.primes
    indices = tree.indices
    return tree.head in choices and len(indices) == 1 and indices[0].isdecimal() and (
        tree.head not in ASKED or len(ASKED[tree.head].indices) != 1)
