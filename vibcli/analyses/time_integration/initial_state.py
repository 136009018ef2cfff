"""Where a motion starts: what is given, and for the rest where the scene is at rest."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.initial_state import at_rest
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene


def start(configuration: "Configuration",
          initial: Mapping[str, float] | None) -> tuple[dict[str, float], dict[str, float]]:
    """({coordinate: float} positions, {coordinate: float} velocities) of all coordinates, those that follow from the
    constraints included."""
    given = {name: float(value) for name, value in (initial or {}).items()}
    known = configuration.scene.coordinates
    for name in given:
        if name.removesuffix("'") not in known:
            raise PhysicsError(f"'{name}' is no coordinate that this scene can start from",
                               "it can start from " + ", ".join(known))
    drawn = configuration.numeric.drawn_floats
    places = {name: value for name, value in given.items() if not name.endswith("'")}
    rest = drawn if set(places) >= set(known) else _rest(configuration)
    q = configuration.numeric.closed_at_start(rest, {**rest, **places})
    v = {name: given.get(name + "'", 0.0) for name in known}
    return _with_dependent(configuration.numeric, q, v)


def _rest(configuration: "Configuration") -> dict[str, float]:
    try:
        return at_rest(configuration)
    except PhysicsError as error:
        given = "give the start of every coordinate under `initial`: " + ", ".join(configuration.scene.coordinates)
        raise error.told(hint=given) from None


def _with_dependent(numeric: "NumericSystem", q: Mapping[str, float],
                    v: Mapping[str, float]) -> tuple[dict[str, float], dict[str, float]]:
    """The same with what follows from the constraints."""
    scene = numeric.scene
    values = {**numeric.floats, scene.time.name: 0.0, **q, **{name + "'": speed for name, speed in v.items()}}
    nodes = list(scene.dependent.values())
    places = evaluate(nodes, Floats, values)
    values |= dict(zip(scene.dependent, places, strict=True))
    speeds = evaluate([scene.rate(node) for node in nodes], Floats, values)
    return ({**q, **dict(zip(scene.dependent, places, strict=True))},
            {**v, **dict(zip(scene.dependent, speeds, strict=True))})


def vectors(scene: "Scene", places: Mapping[str, float], speeds: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """(q, q̇) in the order of the scene's coordinates."""
    return (np.array([places[name] for name in scene.coordinates]),
            np.array([speeds[name] for name in scene.coordinates]))
