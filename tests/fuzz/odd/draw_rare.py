"""What few scenes hold: dry friction, laws, energies and matrices written out, coordinates not zero as drawn."""

from .draw_plane import arrow

# of a load or tension along x and its scale L: odd, growing, its slope 1 at 0
SHAPES = ("sinh({u})", "tan({u})", "tanh({u})", "atan({u})", "asin({u})", "log(1 + {u})", "pi/2 - acos({u})",
          "{u}*cosh({u})", "({u} + abs({u})*{u})", "max({u}, 2*{u} - 0.1)", "min({u}, 2*{u} + 0.1)", "atan2({u}, 1)")
BENT = "max", "min"


def shape(draft, u):
    """A nonlinear function of a pure number; where its slope jumps, small motions are none of its."""
    text = draft.dice.choice(SHAPES)
    if text.startswith(BENT):
        draft.sections["motion"] = "full"
    return text.format(u=u)


def rarely(draft):
    """One rare thing or none."""
    if draft.chance(0.5):
        return
    ways = [conservative, conservative]
    if not draft.tied:
        ways += [written, matrices, offset]
    if draft.dampers:
        ways += [lossy, lossy]
    draft.dice.choice(ways)(draft)


def conservative(draft):
    """A generalised force that pulls back."""
    name = draft.dice.choice(list(draft.coordinates))
    length = draft.coordinates[name] == "m"
    k, size = draft.given("k", 5, 60, "N" if length else "N*m"), draft.given("l", 0.8, 2, "m") if length else "2"
    draft.forces[draft.new("f")] = {"coordinate": name, "value": f"-({k})*({shape(draft, f'({name}/({size}))')})"}


def lossy(draft):
    """A damper whose force is a law of the rate."""
    damper = draft.dampers[draft.dice.choice(list(draft.dampers))]
    turns = "torsion" in damper
    b, v = (draft.given("b", 0.1, 2, "N*m*s"), "1 rad/s") if turns else (draft.given("c", 1, 20, "N*s/m"), "1 m/s")
    damper.pop("c", None)
    if turns:
        damper["torsion"] = "true"
    draft.sections["motion"] = "full"
    damper["law"] = f"({b})*v" + draft.dice.choice((
        f" + ({b})*v*abs(v)/({v})", f"*(1 + (v/({v}))^2)"))


def written(draft):
    """Terms of T, V and Φ of a coordinate."""
    name = draft.dice.choice(list(draft.coordinates))
    length = draft.coordinates[name] == "m"
    m, k, c = (("kg", "N/m", "N*s/m") if length else ("kg*m^2", "N*m/rad", "N*m*s"))
    size = 1 if length else 0.1
    stored = [f"({draft.given('k', 100 * size, 400 * size, k)})*{name}^2/2"]
    if length:
        stored += [f"({draft.given('kk', 100, 900, 'N/m^3')})*{name}^4/4"]
    else:
        stored += [f"({draft.given('q', 1, 9, 'N*m')})*(1 - cos({name}))"]
    terms = {"T": f"({draft.given('m', size, 3 * size, m)})*{name}'^2/2", "V": draft.dice.choice(stored),
             "Phi": f"({draft.given('c', size, 3 * size, c)})*{name}'^2/2"}
    kept = draft.dice.sample(list(terms), draft.dice.choice((1, 2, 3)))
    draft.sections["energies"] = {key: terms[key] for key in terms if key in kept}


def matrices(draft):
    """Entries of M, C (its skew part gyroscopic) and K."""
    names, found = list(draft.coordinates), {}
    turns = [draft.coordinates[name] == "rad" for name in names]
    for key, size, unit in (("M", 1, "kg"), ("C", 2, "N*s/m"), ("K", 100, "N/m")):
        if draft.chance(0.6):
            found[key] = [[_entry(draft, key, size, unit, i, j, turns) for j in range(len(names))]
                          for i in range(len(names))]
            for i in range(len(names)):
                for j in range(i):
                    found[key][i][j] = ("-" if key == "C" else "") + found[key][j][i]
    if found:
        draft.sections["coordinates"] = names
        draft.sections["matrices"] = found


def _entry(draft, key, size, unit, i, j, turns):
    size *= (0.1 if i != j else 1) * 0.3 ** (turns[i] + turns[j])
    powers = {0: unit, 1: unit + "*m", 2: unit + "*m^2"}[turns[i] + turns[j]]
    return f"{draft.some(0.3 * size, size)} {powers}"


def offset(draft):
    """Coordinates that are not zero in the drawn position."""
    draft.sections["coordinates"] = {name: {"drawn": f"{draft.some(-0.06, 0.06)} {unit}"} if draft.chance(0.6) else
                                     {"about": "counted from the drawn position"}
                                     for name, unit in draft.coordinates.items()}


def rubbing(draft):
    """Dry friction in place of dampers; the motion is that of the full equations, from a start that is given."""
    if draft.tied:                      # what they hold is found together, and takes long
        return False
    ends = [(["ground", name], False) for name in draft.axis] + [(["ground", name], True) for name in draft.turning]
    for name in (draft.carriers if not ends else ()):
        x, y = draft.carriers[name]
        dx, dy = arrow(draft, 0.6, 0.9)
        ends.append(([draft.spot(x + dx, y + dy), name], False))
    if len(draft.axis) > 1:
        ends.append((draft.dice.sample(draft.axis, 2), False))
    if not ends:
        return False
    for between, turns in draft.dice.sample(ends, min(len(ends), draft.dice.choice((1, 1, 2)))):
        low, high, unit = (0.05, 1.5, "N*m") if turns else (0.5, 6, "N")
        size = draft.given("R", low, high, unit)
        damper = {**({"torsion": "true"} if turns else {}), "friction": size, "between": between}
        if draft.chance(0.4):
            damper["breakaway"] = f"{draft.some(1.05, 1.6)}*{size}"
        if draft.chance(0.3) and not turns:
            damper["c"] = draft.given("c", 0.5, 5, "N*s/m")
        draft.dampers[draft.new("d")] = damper
    draft.sections["motion"] = "full"
    return True
