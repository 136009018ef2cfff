"""The order in which bodies can be built: each after the bodies that carry it."""


def carriers_first(spec, report):
    """Names of all bodies, carriers first; a circle is reported and leaves an empty list."""
    bodies = spec.get("bodies") or {}
    needs = {name: _carriers(record, spec) for name, record in bodies.items()}
    order, state = [], {}
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
            elif any(state.get(other) == "open" for other in waiting):
                report(bodies[name].where, f"'{name}' and '{waiting[0]}' carry each other", "one of them must be carried "
                       "by the ground")
                return []
            else:
                stack.append(waiting[0])
    return order


def _carriers(record, spec):
    """Names of the bodies that a body's motion refers to."""
    names = []
    for key in ("slide", "pin", "roll", "move"):
        motion = record.get(key)
        if motion is None:
            continue
        names += [motion[k].text for k in ("carrier",) if k in motion]
        at = motion.get("at")
        if hasattr(at, "text"):
            names.append(at.text)
        if key == "roll":
            surface = (spec.get("surfaces") or {})[motion["surface"].text]
            names += [surface["body"].text] if "body" in surface else []
    if "weld" in record:
        names.append(record["weld"].text)
    points = spec.get("points") or {}
    bodies = [points[n]["body"].text if n in points and "body" in points[n] else n for n in names]
    return [n for n in bodies if n not in points]
