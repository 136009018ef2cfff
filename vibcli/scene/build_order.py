"""The order in which bodies can be built: each after the bodies that carry it."""

from vibcli.elements.body import MOTIONS, touched


def carriers_first(spec, report):
    """Names of all bodies, carriers first; a circle is reported and leaves an empty list."""
    bodies = spec.get("bodies") or {}
    needs = {name: _carriers(record, spec) for name, record in bodies.items()}
    order, state, circular = [], {}, False
    for start in bodies:
        stack = [start]
        while stack:
            name = stack[-1]
            if state.get(name) == "done":
                stack.pop()
                continue
            state[name] = "open"
            waiting = [other for other in needs[name] if state.get(other) != "done"]
            if not waiting:
                state[name] = "done"
                order.append(name)
                stack.pop()
            elif state.get(waiting[0]) == "open":
                circle = [n for n in stack[stack.index(waiting[0]):] if state[n] == "open"]
                message = (f"'{name}' carries itself" if waiting[0] == name else
                           "these bodies carry one another: " + " → ".join([*circle, circle[0]]))
                report(bodies[circle[0]].where, message, "one of them must be carried by the ground")
                state.update(dict.fromkeys(circle, "done"))
                circular = True
            else:
                stack.append(waiting[0])
    return [] if circular else order


def _carriers(record, spec):
    """Names of the bodies that a body's motion refers to."""
    names = [record["weld"].text] if "weld" in record else []
    motion = next((record[key] for key in MOTIONS if key in record and key != "weld"), {})
    names += [motion[key].text for key in ("carrier", "at") if hasattr(motion.get(key), "text")]
    carried = [spec.get("surfaces")[reference.text] for reference in touched(record)]
    names += [surface["body"].text for surface in carried if "body" in surface]
    points = spec.get("points") or {}
    bodies = [points[n]["body"].text if n in points and "body" in points[n] else n for n in names]
    return [n for n in bodies if n not in points]
