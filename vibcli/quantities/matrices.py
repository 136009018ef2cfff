"""Entries of M, C, G and K, moments of inertia and mass centres."""

from vibcli.base.errors import PhysicsError
from vibcli.language.signals import coordinate_name
from vibcli.quantities.quantity import ROUNDING
from vibcli.symbolic.evaluation import Floats, evaluate


def coordinate_number(problem, index):
    """The number of an independent coordinate, from 0."""
    name = coordinate_name(problem.spec, index)
    if name not in problem.scene.coordinates:
        raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints: it has no equation of its "
                           "own", "ask for " + " or ".join(f"'{other}'" for other in problem.scene.coordinates[:3]))
    return problem.scene.coordinates.index(name)


def _matrix(which):
    def value(problem, indices, attribute):
        matrices = dict(zip("MCGK", problem.configuration.linear_system.matrices(), strict=True))
        i, j = (coordinate_number(problem, index) for index in indices)
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
    return evaluate([inertia_node(problem.scene, indices)], Floats, problem.numeric.floats)[0], ROUNDING


def _drawn(scene, name):
    if name in scene.bodies:
        return scene.bodies[name].centre
    return scene.pair(scene.spec.get("points")[name]["at"])


def centre_node(scene, indices, attribute):
    return scene.bodies[indices[0]].centre["xy".index(attribute)]


def _centre(problem, indices, attribute):
    return evaluate([centre_node(problem.scene, indices, attribute)], Floats, problem.numeric.floats)[0], ROUNDING


VALUES = {"M": _matrix("M"), "C": _matrix("C"), "G": _matrix("G"), "K": _matrix("K"), "J": _inertia, "centre": _centre}
