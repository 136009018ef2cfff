"""The value of a quantity — omega[1], J[disc, O], K[x, phi] — of a numeric problem, with its error bound."""

from math import isfinite, pi, sqrt

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.mechanics.signals import displacement, force
from vibcli.quantities.quantity import ASKED, IN_FREQUENCY, SEVERAL
from vibcli.reader.quantity_check import coordinate_name, is_choice
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import ExpressionError
from vibcli.symbolic.semantics import lower, quantities_in

ROUNDING = 1e-14


def measure(problem, tree):
    """(value, relative error bound) of a quantity tree."""
    head, indices, attribute = tree[4], tree[5], tree[6]
    if tree[7] or head in IN_FREQUENCY:
        from vibcli.quantities.response import measure_response

        return measure_response(problem, tree)
    if is_choice(problem.spec, tree) and problem.chosen is not None:
        return problem.chosen.value(head, int(indices[0])), ROUNDING
    if head in SEVERAL and len(indices) > len(ASKED[head].indices):
        problem, indices = _about(problem, int(indices[-1])), indices[:-1]
    return _MEASURES[head](problem, indices, attribute)


def value_of(problem, expression):
    """(value, relative error bound) of an expression of parameters and quantities."""
    scene, values, worst, tree = problem.scene, dict(problem.floats), 0.0, expression.tree
    for quantity in quantities_in(tree):
        values[quantity[3]], error = measure(problem, quantity)
        worst = max(worst, error)
    table = scene.table

    def symbol(name, primes, part):
        return table.parameter(name, positive=False) if part[0] == "quantity" else scene.parameters.nodes[name]

    value = evaluate([lowered(expression, table, symbol)], Floats, values)[0]
    if isinstance(value, complex) or not isfinite(value):
        if isinstance(value, complex) and isfinite(abs(value)):
            raise PhysicsError("this is complex: it is compared by its parts", "ask for re, im, abs or arg of it",
                               expression.where)
        raise PhysicsError("this is not a finite real number", "mind the signs under roots, and what may vanish",
                           expression.where)
    return value, worst


def lowered(expression, table, symbol):
    """The node of a parsed expression; SpecError where it divides by zero."""
    try:
        return lower(expression.tree, table, symbol)
    except ExpressionError as error:
        place = expression.scalar.place(error.offset, error.width)
        raise SpecError([Diagnostic(place, error.message, error.hint)]) from None


def _about(problem, number):
    """The problem about one of all its equilibria."""
    if number > _number(problem):
        raise PhysicsError(f"there is no equilibrium {number}: {_number(problem) or 'none'} "
                           f"{'is' if _number(problem) < 2 else 'are'} found within the bounds",
                           "ask for one of these, or give bounds as in find: {equilibria: all, within: …}")
    return problem.about_each[number - 1]


def _number(problem):
    """How many equilibria are found; refused where the search could not be finished."""
    found = problem.equilibria
    if found.cut:
        raise PhysicsError("the search for all equilibria was cut short: their number is not known",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    if found.missed:
        raise PhysicsError(f"more equilibria exist than the {len(found.items)} that were found: by the forces on the "
                           f"bounds their indices sum to {found.indices.degree}, not {found.indices.sum}",
                           "give narrower bounds, as in find: {equilibria: all, within: …}")
    return len(found.items)


def _mode(problem, indices):
    modes = problem.modes
    number = int(indices[0])
    if not modes:
        raise PhysicsError(f"there is no mode {number}: without its dampers nothing would hold what has no "
                           "inertia in this scene",
                           "ask for decay[1] or eigenvalue[1]")
    if number > len(modes):
        raise PhysicsError(f"there is no mode {number}: this scene has {_counted(len(modes), 'mode')}",
                           "ask for one that it has")
    return modes[number - 1]


def number_of(problem, index):
    """The number of an independent coordinate, from 0."""
    name = coordinate_name(problem.spec, index)
    if name not in problem.scene.coordinates:
        raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints: it has no equation of its "
                           "own", "ask for " + " or ".join(f"'{other}'" for other in problem.scene.coordinates[:3]))
    return problem.scene.coordinates.index(name)


def _counted(count, noun):
    return f"one {noun}" if count == 1 else f"{count} {noun}s"


def _oscillating(problem, indices, what):
    mode = _mode(problem, indices)
    if mode.omega is None:
        raise PhysicsError(f"mode {indices[0]} is unstable: it has a growth rate, no {what}",
                           f"ask for growth_rate[{indices[0]}] or stable")
    return mode


def _omega(problem, indices, attribute):
    mode = _oscillating(problem, indices, "frequency")
    return float(mode.omega), mode.error


def _frequency(problem, indices, attribute):
    mode = _oscillating(problem, indices, "frequency")
    return float(mode.omega) / 6.283185307179586, mode.error


def _period(problem, indices, attribute):
    mode = _oscillating(problem, indices, "period")
    if not mode.omega:
        raise PhysicsError(f"mode {indices[0]} is a rigid-body mode: it has no period",
                           f"ask for omega[{indices[0]}]: 0 rad/s")
    return 6.283185307179586 / float(mode.omega), mode.error


def _growth_rate(problem, indices, attribute):
    mode = _mode(problem, indices)
    if mode.growth_rate is None:
        raise PhysicsError(f"mode {indices[0]} does not grow: it is not unstable", f"ask for omega[{indices[0]}]")
    return float(mode.growth_rate), mode.error


def _shape(problem, indices, attribute):
    mode = _mode(problem, indices[:1])
    amplitude = _along(problem, problem.shape(mode), coordinate_name(problem.spec, indices[1]) or indices[1])
    return complex(amplitude) if isinstance(amplitude, complex) and amplitude.imag else float(amplitude.real), 1e-11


def _along(problem, shape, signal):
    """How far a signal moves where the coordinates move by `shape`: Σ (∂s/∂qᵢ) φᵢ."""
    scene = problem.scene.resting
    if signal in scene.coordinates:
        return shape[scene.coordinates.index(signal)]
    node = displacement(scene, signal)
    if node is None:
        raise PhysicsError(f"'{signal}' is a force: it has no amplitude in a mode", "ask for a place, turn or stretch")
    slopes = gradient(node)
    values = evaluate([slopes.get(q, scene.table.zero) for q in scene.q], Floats, problem.at_rest)
    return sum(slope * x for slope, x in zip(values, shape, strict=True))


def damped_mode(problem, indices):
    """The damped mode of an index; a scene without dampers has none."""
    modes = problem.damped
    if modes is None:
        raise PhysicsError("nothing damps this scene: it has no damped modes", "add a damper")
    number = int(indices[0])
    found = [mode for mode in modes if mode.index == number]
    if not found:
        raise PhysicsError(f"there is no damped mode {number}: this scene has "
                           f"{_counted(modes[-1].index, 'damped mode')}", "ask for one that it has")
    return found[0]


def _of_damped(attribute_name, words):
    def value(problem, indices, attribute):
        mode = damped_mode(problem, indices)
        number = getattr(mode, attribute_name)
        if number is None:
            raise PhysicsError(f"damped mode {indices[0]} has no {words}", "see `vibcli frequencies` for what it has")
        return float(number), mode.error
    return value


def _eigenvalue(problem, indices, attribute):
    mode = damped_mode(problem, indices)
    return complex(mode.eigenvalue), mode.error


def _decrement(problem, indices, attribute):
    zeta, error = _MEASURES["zeta"](problem, indices, attribute)
    if not zeta < 1:
        raise PhysicsError(f"damped mode {indices[0]} does not oscillate: it has no logarithmic decrement",
                           f"ask for decay[{indices[0]}]")
    return 2 * pi * zeta / sqrt((1 - zeta) * (1 + zeta)), 4 * error


def _sensitivity(problem, indices, attribute):
    mode, name = _oscillating(problem, indices[:1], "sensitivity"), indices[1]
    if mode.rigid:
        raise PhysicsError(f"mode {indices[0]} is a rigid-body mode: its frequency has no sensitivity",
                           "ask for that of a mode which oscillates")
    found = problem.sensitivities
    if name in found.refused:
        raise PhysicsError(found.refused[name], "see `vibcli solve --insight`")
    rate = found.omega[name][mode.index]
    if rate is None:
        raise PhysicsError(f"mode {indices[0]} coincides with another one, and they are gyroscopic",
                           "derivatives of such modes are not found")
    return rate, ROUNDING


def _estimate(which):
    def value(problem, indices, attribute):
        return getattr(problem.estimates, which), ROUNDING
    return value


def _equilibrium(problem, indices, attribute):
    signal = coordinate_name(problem.spec, indices[0]) or indices[0]
    node = displacement(problem.scene.resting, signal)
    if node is None:
        return force(problem, signal), ROUNDING
    return evaluate([node], Floats, problem.at_rest)[0], ROUNDING


def is_stable(problem):
    """Does nothing grow about the equilibrium? Motion that costs no energy counts as stable."""
    from vibcli.analyses.modal.stability import stability

    return stability(problem).stable


def _stable(problem, indices, attribute):
    return is_stable(problem), 0.0


def _matrix(which):
    def value(problem, indices, attribute):
        matrices = dict(zip("MCGK", problem.elements.matrices(), strict=True))
        i, j = (number_of(problem, index) for index in indices)
        return float(matrices[which].get((i, j), 0.0)), ROUNDING
    return value


def inertia_node(scene, indices):
    """J about the mass centre, or by the parallel axis theorem about a point as drawn."""
    body = scene.bodies[indices[0]]
    node = body.inertia if body.inertia is not None else scene.table.zero
    if len(indices) == 2:
        x, y = _drawn(scene, indices[1])
        mass = body.mass if body.mass is not None else scene.table.zero
        node = node + mass * ((x - body.centre[0]) ** 2 + (y - body.centre[1]) ** 2)
    return scene.at_drawn(node)[0]


def _inertia(problem, indices, attribute):
    return evaluate([inertia_node(problem.scene, indices)], Floats, problem.floats)[0], ROUNDING


def _drawn(scene, name):
    if name in scene.bodies:
        return scene.bodies[name].centre
    return scene.pair(scene.spec.get("points")[name]["at"])


def centre_node(scene, indices, attribute):
    return scene.bodies[indices[0]].centre["xy".index(attribute)]


def _centre(problem, indices, attribute):
    return evaluate([centre_node(problem.scene, indices, attribute)], Floats, problem.floats)[0], ROUNDING


_MEASURES = {
    "omega": _omega, "frequency": _frequency, "period": _period, "growth_rate": _growth_rate, "mode": _shape,
    "zeta": _of_damped("zeta", "damping ratio"), "omega_d": _of_damped("omega_d", "damped frequency"),
    "decay": _of_damped("decay", "decay"), "eigenvalue": _eigenvalue, "decrement": _decrement,
    "sensitivity": _sensitivity, "rayleigh": _estimate("rayleigh"),
    "dunkerley": _estimate("dunkerley"), "equilibrium": _equilibrium, "stable": _stable,
    "equilibria": lambda problem, indices, attribute: (_number(problem), 0.0),
    "M": _matrix("M"), "C": _matrix("C"), "G": _matrix("G"), "K": _matrix("K"), "J": _inertia, "centre": _centre,
}
