"""Numbers of frequency responses: their values at a frequency, peaks, half-power points, fixed points."""

from math import isfinite, pi, tau

from vibcli.base.errors import PhysicsError

ERROR = 1e-12


def wrapped(angle):
    """The angle in (−π, π]."""
    angle = -((-angle + pi) % tau - pi) + 0.0
    return pi if angle == -pi else angle


def frf(problem, tree, args):
    if not tree.args:
        raise PhysicsError(f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
    return problem.frequency_response(*tree.indices).at(args[0])


def _complex_part(part):
    def value(problem, tree, args):
        found, error = args[0]
        return part(found), error
    return value


def _transmissibility(problem, tree, args):
    value, error = frf(problem, tree, args)
    return abs(value), error


def _of_curve(find):
    def value(problem, tree, args):
        curve = problem.frequency_response(*tree.args[0].indices)
        return find(curve, int(tree.indices[0]), tree.component), ERROR
    return value


def _peak(curve, number, attribute):
    Omega, value = _numbered(curve.peaks, number, "peak")
    if attribute != "Omega" and not isfinite(value):
        raise PhysicsError("an undamped peak has no bound", f"add damping, or ask for peak[{number}](…).Omega")
    return Omega if attribute == "Omega" else value


def _fixed_point(problem, tree, args):
    number, damper = tree.indices
    points = problem.frequency_response(*tree.args[0].indices).fixed_points(damper)
    return getattr(_numbered(points, int(number), "fixed point"), tree.component), ERROR


def _numbered(items, number, noun):
    if number > len(items):
        raise PhysicsError(f"this frequency response has {len(items) or 'no'} {noun}{'s' * (len(items) != 1)}",
                           "ask for one that it has")
    return items[number - 1]


def _angle(value):
    import cmath

    return cmath.phase(value)


VALUES = {
    "frf": frf, "transmissibility": _transmissibility, "arg": _complex_part(_angle),
    "re": _complex_part(lambda value: value.real), "im": _complex_part(lambda value: value.imag),
    "phase": _complex_part(lambda value: wrapped(-_angle(value))), "peak": _of_curve(_peak),
    "antiresonance": _of_curve(lambda curve, i, _: _numbered(curve.antiresonances, i, "antiresonance")),
    "half_power": _of_curve(lambda curve, i, _: curve.half_power_of((i + 1) // 2)[(i + 1) % 2]),
    "fixed_point": _fixed_point, "quality": _of_curve(lambda curve, i, _: curve.quality(i)),
}
