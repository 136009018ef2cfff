"""Numbers of frequency responses: their values at a frequency, peaks, half-power points, fixed points."""

from math import isfinite, pi

from vibcli.base.errors import PhysicsError
from vibcli.reader.cycle_check import counts_cycles
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.semantics import lower, quantities_in

TURN, ERROR = 2 * pi, 1e-12


def number_of(problem, tree):
    """The value of an argument: an instant or an angular frequency; cycles count as 2π."""
    from vibcli.quantities.modal import measure

    values = dict(problem.floats)
    for quantity in quantities_in(tree):
        values[quantity[3]] = measure(problem, quantity)[0]
    table = problem.scene.table

    def symbol(name, primes, part):
        return table.parameter(name, positive=False) if part[0] == "quantity" else problem.scene.parameters.nodes[name]

    value = evaluate([lower(tree, table, symbol)], Floats, values)[0]
    return value * TURN if counts_cycles(problem.spec, tree) else value


def wrapped(angle):
    """The angle in (−π, π]."""
    angle = -((-angle + pi) % TURN - pi) + 0.0
    return pi if angle == -pi else angle


def frf(problem, tree):
    if not tree[7]:
        raise PhysicsError(f"'{tree[3]}' is a function of frequency", f"write {tree[3]}(5 Hz)")
    return problem.frequency_response(*tree[5]).at(number_of(problem, tree[7][0]))


def _complex_part(part):
    def value(problem, tree):
        from vibcli.quantities.modal import measure

        found, error = measure(problem, tree[7][0])
        return part(found), error
    return value


def _transmissibility(problem, tree):
    value, error = frf(problem, tree)
    return abs(value), error


def _of_curve(find):
    def value(problem, tree):
        curve = problem.frequency_response(*tree[7][0][5])
        return find(curve, int(tree[5][0]), tree[6]), ERROR
    return value


def _peak(curve, number, attribute):
    Omega, value = _numbered(curve.peaks, number, "peak")
    if attribute != "Omega" and not isfinite(value):
        raise PhysicsError("an undamped peak has no bound", f"add damping, or ask for peak[{number}](…).Omega")
    return Omega if attribute == "Omega" else value


def _fixed_point(problem, tree):
    number, damper = tree[5]
    points = problem.frequency_response(*tree[7][0][5]).fixed_points(damper)
    return getattr(_numbered(points, int(number), "fixed point"), tree[6]), ERROR


def _numbered(items, number, noun):
    if number > len(items):
        raise PhysicsError(f"this frequency response has {len(items) or 'no'} {noun}{'s' * (len(items) != 1)}",
                           "ask for one that it has")
    return items[number - 1]


def _angle(value):
    import cmath

    return cmath.phase(value)


OF_FREQUENCY = {
    "frf": frf, "transmissibility": _transmissibility, "arg": _complex_part(_angle),
    "re": _complex_part(lambda value: value.real), "im": _complex_part(lambda value: value.imag),
    "phase": _complex_part(lambda value: wrapped(-_angle(value))), "peak": _of_curve(_peak),
    "antiresonance": _of_curve(lambda curve, i, _: _numbered(curve.antiresonances, i, "antiresonance")),
    "half_power": _of_curve(lambda curve, i, _: curve.half_power_of((i + 1) // 2)[(i + 1) % 2]),
    "fixed_point": _fixed_point, "quality": _of_curve(lambda curve, i, _: curve.quality(i)),
}
