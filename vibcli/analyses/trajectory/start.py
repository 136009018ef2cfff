"""Where a motion starts: what is given, and for the rest the equilibrium, at rest."""

import numpy as np

from vibcli.errors import PhysicsError


def start(problem, initial):
    """({coordinate: float} positions, {coordinate: float} velocities) of all coordinates of the scene."""
    given = {name: float(value) for name, value in (initial or {}).items()}
    known = [*problem.drawn_floats]
    for name in given:
        if name.removesuffix("'") not in known:
            raise PhysicsError(f"'{name}' is no coordinate of this scene", "its coordinates are " + ", ".join(known))
    places = {name: value for name, value in given.items() if not name.endswith("'")}
    rest = problem.drawn_floats if set(places) >= set(problem.scene.coordinates) else _rest(problem)
    return {**rest, **places}, {name: given.get(name + "'", 0.0) for name in known}


def _rest(problem):
    try:
        return problem.equilibrium.values
    except PhysicsError as error:
        names = ", ".join(problem.scene.coordinates)
        error.hint = f"give the start of every coordinate under `initial`: {names}"
        raise


def vectors(scene, places, speeds):
    """(q, q̇) in the order of the scene's coordinates."""
    return (np.array([places[name] for name in scene.coordinates]),
            np.array([speeds[name] for name in scene.coordinates]))
