"""Where a motion starts: the values of `initial`, else at rest in the equilibrium without loads that depend on time."""

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.elements.initial import RELEASED
from vibcli.errors import PhysicsError


def start(problem):
    """({coordinate: value}, {coordinate: velocity}) at t = 0 of the independent coordinates."""
    scene, record = problem.scene, problem.spec.get("initial")
    places = dict((problem.before or problem).equilibrium.values)
    places = {name: places[name] for name in scene.coordinates}
    speeds = dict.fromkeys(scene.coordinates, 0.0)
    for key, expression in record.values.items() if record is not None else ():
        if key == RELEASED:
            continue
        name = key.rstrip("'")
        if name not in places:
            raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints", "start "
                               + " or ".join(f"'{other}'" for other in scene.coordinates[:3]), record.place(key))
        value, = evaluate([scene.lower(expression)], Floats, problem.floats)
        (speeds if key != name else places)[name] = value
    return places, speeds
