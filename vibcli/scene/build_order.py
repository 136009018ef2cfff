"""The order in which bodies can be built: each after the bodies that carry it."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from vibcli.elements.rigid_body import carriers

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.spec import Spec


def carriers_first(spec: "Spec", report: "Callable[[Where, str, str], None]") -> list[str]:
    """Names of all bodies, carriers first; a circle is reported and leaves an empty list."""
    bodies = spec.get("bodies") or {}
    needs = {name: carriers(record, spec) for name, record in bodies.items()}
    order, circular = {}, False
    for start in bodies:
        path = [start]
        while path:
            name = path[-1]
            carrier = next((other for other in needs[name] if other not in order), None)
            if carrier is None or name in order:
                order[name] = path.pop()
            elif carrier in path:
                circle = path[path.index(carrier):]
                message = (f"'{name}' carries itself" if carrier == name else
                           "these bodies carry one another: " + " → ".join([*circle, circle[0]]))
                report(bodies[circle[0]].where, message, "one of them must be carried by the ground")
                order.update(dict.fromkeys(circle))
                circular = True
            else:
                path.append(carrier)
    return [] if circular else list(order)
