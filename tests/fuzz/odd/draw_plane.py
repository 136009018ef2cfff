"""Bodies in the plane: of every shape, carried by one another, moving in every way."""

import math

from .draw_loads import SMOOTH, wave


def shape(draft, at):
    """The words of a shape whose mass centre, or circle, is at a place; with its radius where it has one."""
    kind = draft.dice.choice(("particle", "disc", "ring", "rod", "rectangle", "ellipse", "sector", "arch", "lump",
                              "parts"))
    mass = {"mass": draft.given("m", 0.5, 4, "kg")}
    if kind == "particle":
        named = {"shape": "particle"} if draft.chance(0.4) else {}
        return {**named, **mass, "inertia": draft.given("J", 0.02, 0.3, "kg*m^2"), "at": draft.spot(*at)}
    if kind == "lump":
        return {**mass, "gyration": draft.given("i", 0.1, 0.4, "m"), "at": draft.spot(*at)}
    if kind == "rod":
        dx, dy = arrow(draft, 0.15, 0.4)
        return {"shape": "rod", **mass, "from": draft.spot(at[0] - dx, at[1] - dy),
                "to": draft.spot(at[0] + dx, at[1] + dy)}
    if kind == "parts":
        return {"parts": [part(draft, (at[0] + arrow(draft, 0.05, 0.3)[0], at[1] + 0.1 * i), i) for i in range(
            draft.dice.choice((2, 3)))]}
    if draft.chance(0.2):
        low, high, unit = (1, 4, "kg/m") if kind in ("ring", "arch") else (5, 20, "kg/m^2")
        mass = {"density": draft.given("sigma", low, high, unit)}
    return {"shape": kind, **mass, **sizes(draft, kind), "at": draft.spot(*at)}


def part(draft, at, number):
    """A piece; those after the first may be cut out of it, being light."""
    if draft.chance(0.15):
        return {"shape": "rod", "mass": draft.given("m", 0.5, 2, "kg"), "from": draft.spot(*at),
                "to": draft.spot(at[0] + 0.3, at[1] + 0.1)}
    kind = draft.dice.choice(("particle", "disc", "ring", "rectangle", "ellipse", "sector", "arch"))
    cut = {"cut": "true"} if number and draft.chance(0.3) else {}
    mass = {"mass": draft.given("m", *((0.02, 0.05) if cut else (0.5, 2)), "kg")}
    if kind in ("disc", "rectangle", "ellipse", "sector") and not cut and draft.chance(0.3):
        mass = {"density": draft.given("sigma", 5, 20, "kg/m^2")}
    return {"shape": kind, **mass, **cut, **sizes(draft, kind), "at": draft.spot(*at)}


def sizes(draft, kind):
    if kind in ("rectangle", "ellipse"):
        one, two = ("width", "height") if kind == "rectangle" else ("a", "b")
        found = {one: draft.given("w", 0.1, 0.5, "m"), two: draft.given("h", 0.1, 0.5, "m")}
    elif kind == "particle":
        return {}
    else:
        found = {"radius": draft.given("r", 0.08, 0.3, "m")}
    if kind in ("sector", "arch"):
        found["half_angle"] = draft.given("alpha", 0.4, 2.5, "rad")
    if kind not in ("disc", "ring") and (kind in ("sector", "arch") or draft.chance(0.5)):
        found["angle"] = draft.given("beta", 0.1, 3, "rad")
    return found


def arrow(draft, low, high):
    size, angle = draft.dice.uniform(low, high), draft.dice.uniform(0, 2 * math.pi)
    return size * math.cos(angle), size * math.sin(angle)


def exact_arrow(draft):
    """A direction whose components are decimals, so that what touches touches exactly."""
    x, y = draft.dice.choice(((1, 0), (0.6, 0.8), (0.8, 0.6), (0.28, 0.96), (0.96, 0.28)))
    return draft.dice.choice((1, -1)) * x, draft.dice.choice((1, -1)) * y


def machine(draft):
    """One to three bodies, each carried by the ground or by one before; held by springs."""
    if draft.chance(0.7):
        draft.sections["gravity"] = draft.given("g", 9.7, 9.9, "m/s^2") if draft.chance(0.8) else [
            f"{draft.some(-5, 5)} m/s^2", f"{draft.some(-9, -2)} m/s^2"]
    for i in range(draft.dice.choice((1, 1, 2, 2, 3))):
        carrier = draft.dice.choice([None, *draft.carriers]) if i else None
        at = place_for(draft, carrier)
        draft.dice.choice((slide, pin, pin, roll, move, on_surface, weld if carrier else pin, swinging_slide))(
            draft, at, carrier)
    if draft.chance(0.25):
        shaken_point(draft)


def place_for(draft, carrier):
    """Where the next body is drawn: apart from the others."""
    x, y = draft.carriers[carrier] if carrier else (1.5 * len(draft.carriers), 0.0)
    dx, dy = arrow(draft, 0.3, 0.6)
    return x + dx, y + dy


def add(draft, at, motion, words=None):
    """A body with its motion; it can carry others and be loaded."""
    name = draft.new("body")
    draft.bodies[name] = {**(words or shape(draft, at)), **motion}
    draft.carriers[name] = at
    if "from" not in draft.bodies[name]:
        draft.places[name] = at
    if draft.chance(0.7):
        x, y = arrow(draft, 0.1, 0.3)
        point = draft.new("P")
        draft.points[point] = {"body": name, "at": draft.spot(at[0] + x, at[1] + y)}
        draft.places[point] = (at[0] + x, at[1] + y)
    return name


def slide(draft, at, carrier):
    x = draft.coordinate("m")
    motion = {"by": x}
    ex, ey = arrow(draft, 1, 1)
    if draft.chance(0.7):
        motion["along"] = [f"{round(ex, 3)}", f"{round(ey, 3)}"]
    else:
        ex, ey = 1, 0
    if carrier:
        motion["carrier"] = carrier
    name = add(draft, at, {"slide": x if motion == {"by": x} else motion})
    tie(draft, name, (ex, ey))


swinging_slide = slide


def pin(draft, at, carrier):
    phi, relative = draft.coordinate("rad"), False
    motion = {"by": phi}
    if draft.chance(0.8):
        dx, dy = arrow(draft, 0.1, 0.5)
        spot = (at[0] + dx, at[1] + dy)
        motion["at"] = draft.spot(*spot)
        if draft.chance(0.3):
            point = draft.new("O")
            draft.points[point] = {"body": carrier, "at": motion["at"]} if carrier else motion["at"]
            motion["at"] = point
    if carrier and not isinstance(motion.get("at"), str):
        motion["carrier"] = carrier
    if carrier and draft.chance(0.4):
        motion["relative"] = relative = True
    name = add(draft, at, {"pin": motion if draft.chance(0.9) or len(motion) > 1 else phi})
    draft.turning.append(name)
    ends = [carrier if carrier in draft.turning and (relative or draft.chance(0.5)) else "ground", name]
    draft.springs[draft.new("s")] = {"torsion": draft.given("q", 20, 200, "N*m/rad"), "between": ends}


def move(draft, at, carrier):
    x, y = draft.coordinate("m"), draft.coordinate("m")
    by = [x, y, draft.coordinate("rad") if draft.chance(0.7) else "0"]
    name = add(draft, at, {"move": {"by": by, "carrier": carrier} if carrier else by})
    if by[2] != "0":
        draft.turning.append(name)
        draft.springs[draft.new("s")] = {"torsion": draft.given("q", 20, 200, "N*m/rad"), "between": ["ground", name]}
    tie(draft, name, (1, 0))
    tie(draft, name, (0, 1))


def weld(draft, at, carrier):
    name = add(draft, at, {"weld": carrier})
    if draft.chance(0.5):
        pin(draft, place_for(draft, name), name)


def on_surface(draft, at, carrier):
    """A body that slides along a line, a circle or a curve, fixed or carried."""
    x, surface, at = draft.coordinate("m"), draft.new("way"), tuple(round(c, 3) for c in at)
    kind = draft.dice.choice(("line", "circle", "curve"))
    if kind == "line":
        ex, ey = arrow(draft, 1, 1)
        words = {"line": [draft.spot(*at), draft.spot(at[0] + ex, at[1] + ey)]}
    elif kind == "circle":
        ex, ey = arrow(draft, 0.3, 0.8)
        words = {"circle": draft.spot(at[0] + ex, at[1] + ey), "radius": f"{math.hypot(ex, ey):.6g} m"}
    else:
        a = draft.given("p", 0.5, 2, "m")
        words = {"curve": f"u^2/({a})", "in": "u"}
        at = (draft.some(-0.3, 0.3), 0.0)
    if kind != "circle":
        words = {**words, **({"body": carrier} if carrier else {})}
    draft.surfaces[surface] = words
    slide_, at = {"by": x, "surface": surface}, tuple(round(c, 3) for c in at)
    if kind == "circle":
        words["radius"] = f"sqrt(({round(at[0] + ex, 3) - at[0]:.6f} m)^2 + ({round(at[1] + ey, 3) - at[1]:.6f} m)^2)"
    spot = draft.spot(*at)
    if kind == "curve":
        spot[1] = f"({spot[0]})^2/({a})"
    name = add(draft, at, {"slide": slide_}, {"mass": draft.given("m", 0.5, 4, "kg"), "at": spot})
    tie(draft, name, (1, 0) if kind == "curve" else (ex, ey) if kind == "line" else (-ey, ex))


def roll(draft, at, carrier):
    """A round body on a line or a circle, fixed or carried."""
    r, surface = draft.some(0.08, 0.3), draft.new("way")
    kind = draft.dice.choice(("line", "inside", "outside"))
    at = tuple(round(c, 3) for c in at)
    if kind == "line":
        e = exact_arrow(draft)
        n = -e[1], e[0]
        side = draft.dice.choice((1, -1))
        foot = (at[0] - side * r * n[0], at[1] - side * r * n[1])
        words = {"line": [[f"{foot[0]:.12f} m", f"{foot[1]:.12f} m"],
                          [f"{foot[0] + e[0]:.12f} m", f"{foot[1] + e[1]:.12f} m"]]}
    else:
        R = draft.some(0.4, 0.9)
        d = R + r if kind == "outside" else R - r
        n = exact_arrow(draft)
        e = -n[1], n[0]
        words = {"circle": [f"{at[0] - d * n[0]:.12f} m", f"{at[1] - d * n[1]:.12f} m"], "radius": f"{R} m",
                 "side": kind}
    if carrier:
        words["body"] = carrier
    draft.surfaces[surface] = words
    ways = ["travel", "turn"] + (["swing"] if kind != "line" and not carrier else [])
    way = draft.dice.choice(ways)
    round_ = draft.dice.choice(("disc", "ring", "sector", "arch"))
    body = {"shape": round_, "mass": draft.given("m", 0.5, 4, "kg"), "radius": f"{r} m"}
    if round_ in ("sector", "arch"):
        body.update(half_angle=draft.given("alpha", 0.8, 2.5, "rad"), angle=draft.given("beta", 0.1, 3, "rad"))
    body["at"] = draft.spot(*at)
    motion = {"surface": surface, way: draft.coordinate("m" if way == "travel" else "rad")}
    if round_ == "disc" and draft.chance(0.4):          # a spool on a part of its own
        del body["shape"], body["radius"]
        body["inertia"] = draft.given("J", 0.02, 0.3, "kg*m^2")
        motion["radius"] = f"{r} m"
    name = add(draft, at, {"roll": motion}, body)
    draft.turning.append(name)
    tie(draft, name, e)


def tie(draft, name, along):
    """A spring that holds a body along a direction, tied to the ground or to another body."""
    x, y = draft.carriers[name]
    size = draft.dice.uniform(0.4, 0.9) * draft.dice.choice((1, -1)) / math.hypot(*along)
    end = draft.spot(x + size * along[0], y + size * along[1])
    spring = {"k": draft.given("k", 300, 3000, "N/m"), "between": [end, name]}
    if "from" in draft.bodies[name] or draft.chance(0.2):
        point = draft.new("A")
        draft.points[point] = {"body": name, "at": draft.spot(x, y)}
        spring["between"] = [point, end]
    if draft.chance(0.3):
        alone = draft.chance(0.4) and len(draft.coordinates) == 1
        spring["preload"] = "static" if alone else draft.given("N", 5, 40, "N")
    elif draft.chance(0.2):
        spring["free_length"] = f"{round(abs(size) * math.hypot(*along) * draft.dice.uniform(0.95, 1.0), 3)} m"
    elif draft.chance(0.15):
        k = draft.given("k", 300, 2000, "N/m")
        cube = draft.given("kk", 1000, 30000, "N/m^3")
        spring = {**spring, "law": f"({k})*d + ({cube})*d^3"}
        del spring["k"]
    draft.springs[draft.new("s")] = spring


def shaken_point(draft):
    """A point that moves as prescribed, tied to some body."""
    if not draft.places:
        return
    name, to = draft.new("S"), draft.dice.choice(list(draft.places))
    x, y = draft.places[to]
    dx, dy = arrow(draft, 0.4, 0.8)
    moves = [wave(draft, "Y", 0.005, 0.03, "m", SMOOTH), "0"]
    if draft.chance(0.5):
        moves.reverse()
    draft.points[name] = {"at": draft.spot(x + dx, y + dy), "moves": moves}
    draft.springs[draft.new("s")] = {"k": draft.given("k", 100, 1000, "N/m"), "between": [name, to]}


def dressed(draft):
    """Further springs and dampers between whatever there is."""
    for _ in range(draft.dice.choice((0, 1, 1, 2))):
        if not draft.places:
            return
        to = draft.dice.choice(list(draft.places))
        x, y = draft.places[to]
        dx, dy = arrow(draft, 0.4, 0.9)
        other = draft.dice.choice([draft.spot(x + dx, y + dy), *(
            p for p in draft.places if math.dist(draft.places[p], (x, y)) > 0.25)])
        if draft.chance(0.6):
            draft.dampers[draft.new("d")] = {"c": draft.given("c", 1, 30, "N*s/m"), "between": [other, to]}
        else:
            draft.springs[draft.new("s")] = {"k": draft.given("k", 50, 500, "N/m"), "between": [other, to]}
    if draft.turning and draft.chance(0.3):
        draft.dampers[draft.new("d")] = {"torsion": draft.given("b", 0.05, 2, "N*m*s"),
                                         "between": ["ground", draft.dice.choice(draft.turning)]}
