"""Linear functions y = constant + q·δ + v·δ̇ + a·δ̈ + what depends on the time, of coordinates and inputs."""

from vibcli.base.errors import PhysicsError


class LinearFunction:
    """Coefficients {i: number} of the deviations, their rates and accelerations; `time`: [(factor, node of t)]."""

    __slots__ = ("a", "constant", "q", "time", "v")

    def __init__(self, constant=0.0, time=(), q=None, v=None, a=None):
        self.constant, self.time, self.q, self.v, self.a = constant, list(time), q or {}, v or {}, a or {}


def combined(pairs):
    """Σ factor·row of (factor, row) pairs."""
    found = LinearFunction()
    for factor, row in pairs:
        found.constant += factor * row.constant
        found.time += [(factor * weight, node) for weight, node in row.time]
        for kind in ("q", "v", "a"):
            total = getattr(found, kind)
            for i, x in getattr(row, kind).items():
                total[i] = total.get(i, 0.0) + factor * x
    return found


def rate(row, scene):
    """ẏ; PhysicsError where it would need a third derivative."""
    if row.a:
        raise PhysicsError("the rate of a force of inertia is no function of places, velocities and accelerations",
                           "ask for the force itself")
    return LinearFunction(0.0, [(weight, scene.rate(node)) for weight, node in row.time], None, row.q, row.v)


def product(one, two):
    """one·two to first order."""
    if one.time and two.time:
        raise PhysicsError("a product of two driven quantities is not linear", "ask for each of them")
    found = combined([(two.constant, one), (one.constant, two)])
    found.constant = one.constant * two.constant
    return found
