"""What drives a scene, and where its motion starts."""

from .draft import UNITS

SMOOTH = "sin", "cos", "versine", "decay", "two", "record"
ALL = ("sin", "cos", "sum", "versine", "decay", "step", "ramp", "pulse", "square", "sawtooth", "impulse", "rectified",
       "half", "switched", "record", "record")


def wave(draft, letter, low, high, unit, kinds=ALL):
    """A function of the time: harmonic, decaying or a pulse; those of SMOOTH have no jumps, for displacements."""
    size, speed = draft.given(letter, low, high, unit), draft.given("W", 2, 12, "rad/s")
    if " " in size:
        size = f"({size})"
    if " " in speed:
        speed = f"({speed})"
    kind = draft.dice.choice(kinds)
    if kind == "record":
        return record(draft, low, high, unit, size, kinds is SMOOTH)
    late = f"({draft.some(0.05, 0.4)} s)"
    span = f"({draft.some(0.1, 0.5)} s)"
    return {"sin": f"{size}*sin({speed}*t)", "cos": f"{size}*cos({speed}*t)",
            "versine": f"{size}*(1 - cos({speed}*t))", "two": f"{size}*(sin({speed}*t) + cos(2*{speed}*t)/3)",
            "sum": f"{size}*sin({speed}*t) + {size}*cos(3*{speed}*t)/2",
            "decay": f"{size}*(1 - exp(-t/{span}))", "step": f"{size}*step(t - {late})",
            "ramp": f"{size}*(ramp(t - {late}) - ramp(t - {late} - {span}))/{span}",
            "pulse": f"{size}*sin(pi*t/{span})*(step(t) - step(t - {span}))",
            "square": f"{size}*square({speed}*t)", "sawtooth": f"{size}*sawtooth({speed}*t)",
            "rectified": f"{size}*abs(sin({speed}*t))", "half": f"{size}*max(0, sin({speed}*t))",
            "switched": f"{size}*sign(t - {late})",
            "impulse": f"({draft.some(0.1, 1)} s)*{size}*impulse(t - {late})"}[kind]


def record(draft, low, high, unit, size, smooth):
    """A measured function, pure numbers or in a unit; of one that is smooth the ends are zero."""
    name, draws = draft.new("ag"), draft.dice
    written, factor = draws.choice((("", None), *UNITS.get(unit, ((unit, 1),))))
    n, step = draws.randrange(4, 7), draws.choice((0.05, 0.08, 0.1))
    values = [float(f"{draws.uniform(-1, 1) * (high * factor if factor else 1):.4g}") for _ in range(n)]
    if smooth:
        values[0] = values[-1] = 0.0
    words = {"file": f"{name}_{draft.seed}.csv", **({"unit": written} if written else {})}
    way = draws.choice(("plain", "named", "every", "blanks"))
    gap, head = {"plain": ",", "named": ";", "every": ",", "blanks": " "}[way], []
    times = [round(i * step * draws.uniform(0.6, 1) if i and way != "every" else i * step, 4) for i in range(n)]
    times.sort()
    if way == "every":
        rows, words = [[value] for value in values], {**words, "every": f"{step} s"}
    elif way == "named":
        head, rows = ["clock", "other", "size"], [[1000 * t, i, x] for i, (t, x) in enumerate(zip(
            times, values, strict=True))]
        words |= {"time": "clock", "value": "size", "time_unit": "ms"}
    else:
        rows = [[t, x] for t, x in zip(times, values, strict=True)]
    draft.files[words["file"]] = "\n".join(gap.join(map(str, row)) for row in [head, *rows] if row) + "\n"
    draft.records[name] = words if len(words) > 1 or draft.chance(0.5) else words["file"]
    call = f"{name}(t - ({draft.some(0.03, 0.2)} s))"
    return call if written else f"{size}*{call}"


def load(draft):
    """One load on whatever there is to load; steady, in time, of coordinates or velocities."""
    kinds = []
    if draft.axis:
        kinds += ["on axis", "unbalance on axis"]
    if draft.places:
        kinds += ["force", "force", "follower", "unbalance"]
    if draft.turning:
        kinds += ["moment"]
    if draft.coordinates:
        kinds += ["generalised"]
    if kinds:
        {"on axis": _on_axis, "force": _force, "follower": _follower, "unbalance": _unbalance, "moment": _moment,
         "unbalance on axis": _unbalance_on_axis, "generalised": _generalised}[draft.dice.choice(kinds)](draft)


def _size(draft, unit, scale=1.0):
    """A load: steady or in time."""
    if draft.chance(0.3):
        return ("-" if draft.chance(0.5) else "") + draft.given("F", 1 * scale, 6 * scale, unit)
    return wave(draft, "F", 1 * scale, 6 * scale, unit)


def _on_axis(draft):
    draft.forces[draft.new("f")] = {"at": draft.dice.choice(draft.axis), "force": _size(draft, "N")}


def _unbalance_on_axis(draft):
    draft.forces[draft.new("f")] = {"at": draft.dice.choice(draft.axis),
                                    "unbalance": draft.given("U", 0.005, 0.03, "kg*m"),
                                    "speed": draft.given("W", 2, 12, "rad/s")}


def _force(draft):
    components = [_size(draft, "N"), _size(draft, "N")]
    if draft.chance(0.4):
        components[draft.dice.randrange(2)] = "0"
    draft.forces[draft.new("f")] = {"at": draft.dice.choice(list(draft.places)), "force": components}


def _follower(draft):
    """A force that turns with a body; steady, as one in time would make the stiffness depend on it."""
    _force(draft)
    if draft.turning:
        force = draft.forces[f"f{draft.counts['f']}"]
        force["force"] = [draft.given("F", 1, 6, "N"), "-" + draft.given("F", 1, 6, "N")]
        draft.forces[f"f{draft.counts['f']}"]["carrier"] = draft.dice.choice(draft.turning)


def _unbalance(draft):
    draft.forces[draft.new("f")] = {"at": draft.dice.choice(list(draft.places)),
                                    "unbalance": draft.given("U", 0.005, 0.03, "kg*m"),
                                    "speed": draft.given("W", 2, 12, "rad/s")}


def _moment(draft):
    draft.forces[draft.new("f")] = {"body": draft.dice.choice(draft.turning), "moment": _size(draft, "N*m", 0.3)}


def _generalised(draft):
    name = draft.dice.choice(list(draft.coordinates))
    length = draft.coordinates[name] == "m"
    if draft.chance(0.4):
        c = draft.given("c", 0.2, 2, "N*s/m" if length else "N*m*s")
        value = f"-{c}*{name}'" if " " not in c else f"-({c})*{name}'"
    elif draft.chance(0.4):
        k = draft.given("k", 5, 40, "N/m" if length else "N*m/rad")
        value = f"-{k}*{name}" if " " not in k else f"-({k})*{name}"
    else:
        value = _size(draft, "N" if length else "N*m", 1 if length else 0.3)
    draft.forces[draft.new("f")] = {"coordinate": name, "value": value}


def start(draft, names, whole=False):
    """Where a motion starts; `whole`: every coordinate is given."""
    initial = {}
    for name in names:
        length = draft.coordinates[name] == "m"
        if whole or draft.chance(0.6):
            initial[name] = f"{draft.some(-0.08, 0.08)} {'m' if length else 'rad'}"
        if draft.chance(0.4):
            initial[name + "'"] = f"{draft.some(-0.5, 0.5)} {'m/s' if length else 'rad/s'}"
    if initial:
        draft.sections["initial"] = initial
    if draft.chance(0.05) and "motion" not in draft.sections:
        name = draft.dice.choice(names)
        draft.sections["equilibrium"] = {name: f"{draft.some(-0.02, 0.02)} {draft.coordinates[name]}"}
