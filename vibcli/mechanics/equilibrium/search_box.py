"""Within which bounds equilibria are searched: those of the file, else a turn of angles and twice the figure."""

import math

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium.scaled_forces import typical_length
from vibcli.symbolic.evaluation import Floats, evaluate

REACH = 2.0


def bounds(numeric, forces, rests):
    """{coordinate: (least, greatest)}; `rests`: positions of equilibrium that are known, which are kept within."""
    given, found = given_bounds(numeric), {}
    for name, angle, periodic in zip(forces.names, forces.angle, forces.periodic, strict=True):
        drawn = numeric.drawn_floats[name]
        if name in given:
            low, high = given[name]
            centre = 0.5 * (low + high)
            found[name] = (centre - math.pi, centre + math.pi) if periodic and high - low > math.tau else (low, high)
        elif angle:
            centre = 0.0 if abs(drawn) <= math.pi else drawn
            found[name] = (centre - math.pi, centre + math.pi)
        else:
            reach = REACH * max(typical_length(numeric), *(abs(rest[name] - drawn) for rest in rests), 0.0)
            if not reach:
                far = numeric.spec.example("2 m")
                raise PhysicsError(f"nothing in this scene says how far '{name}' is to be searched for equilibria",
                                   f"give bounds, as in find: {{equilibria: all, within: {{{name}: [-{far}, {far}]}}}}",
                                   numeric.spec.coordinates[name].where)
            found[name] = (drawn - reach, drawn + reach)
    return found


def given_bounds(numeric):
    """{coordinate: (least, greatest)} of the file."""
    asked, found = numeric.spec.get("find"), {}
    for name, pair in (asked.within if asked else {}).items():
        nodes = [numeric.scene.lower(expression) for expression in pair]
        low, high = evaluate(nodes, Floats, numeric.floats)
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise PhysicsError(f"the bounds of '{name}' are {low:.6g} and {high:.6g}, expected the smaller one first",
                               "write [least, most]", pair[0].where)
        found[name] = (low, high)
    return found
