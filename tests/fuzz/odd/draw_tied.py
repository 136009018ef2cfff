"""Mechanisms whose coordinates are tied: ropes over pulleys, gears on an arm, joints, links, points on surfaces."""

import math

from .draw_plane import tie


def hoist(draft):
    """A load on a rope over a pulley to a block that a spring holds; or under a movable pulley as well."""
    movable = draft.chance(0.4)
    r, phi, x, y = draft.some(0.08, 0.2), draft.coordinate("rad"), draft.coordinate("m"), draft.coordinate("m")
    draft.sections["gravity"] = draft.given("g", 9.7, 9.9, "m/s^2")
    draft.bodies["top"] = {"shape": draft.dice.choice(("disc", "ring")), "mass": draft.given("m", 0.5, 3, "kg"),
                           "radius": f"{r} m", "at": ["0 m", "1 m"], "pin": phi}
    draft.bodies["block"] = {"mass": draft.given("m", 1, 4, "kg"), "at": [f"{r} m", "0.2 m"],
                             "slide": {"along": ["0", "1"], "by": y}}
    if movable:
        psi, s = draft.coordinate("rad"), draft.some(0.06, 0.15)
        draft.bodies["low"] = {"shape": "disc", "mass": draft.given("m", 0.5, 3, "kg"), "radius": f"{s} m",
                               "at": [f"{-r - s:.6g} m", "0 m"], "move": ["0", x, psi]}
        draft.constraints["rope"] = {"rope": [[f"{-r - 2 * s:.6g} m", "1.1 m"], {"under": "low"}, {"over": "top"},
                                              "block"]}
        draft.tied |= {phi, y, psi}
        draft.turning += ["low"]
        draft.places["low"] = (-r - s, 0.0)
    else:
        draft.bodies["load"] = {"mass": draft.given("m", 1, 4, "kg"), "at": [f"{-r} m", f"{draft.some(-0.4, 0.4)} m"],
                                "slide": {"along": ["0", "1"], "by": x}}
        draft.constraints["rope"] = {"rope": ["load", {"over": "top"}, "block"]}
        draft.tied |= {x, y}
        draft.places["load"] = (-r, 0.0)
    spring = {"k": draft.given("k", 300, 3000, "N/m"), "between": [[f"{r} m", "-0.5 m"], "block"]}
    if draft.chance(0.5):
        spring["preload"] = draft.given("N", 10, 60, "N")
    draft.springs[draft.new("s")] = spring
    draft.turning.append("top")
    draft.places["block"] = (r, 0.2)
    draft.carriers["block"] = (r, 0.2)


WAYS = {"over": lambda x, y: [x, y], "right_of": lambda x, y: [y, x], "left_of": lambda x, y: [_minus(y), x],
        "under": lambda x, y: [x, _minus(y)]}           # the same figure, mirrored or turned


def _minus(text):
    return text[1:] if text.startswith("-") else "0" if text == "0" else f"-{text}"


def slanted_rope(draft):
    """A rope at an angle from a block on a rail over a pulley to a load: what it gives changes with the place."""
    r, x, phi, y = draft.some(0.05, 0.15), draft.coordinate("m"), draft.coordinate("rad"), draft.coordinate("m")
    side = draft.dice.choice(list(WAYS))
    to, rail, fall = WAYS[side], WAYS[side]("1", "0"), WAYS[side]("0", "1")
    draft.sections["gravity"] = to("0", "-9.81 m/s^2")
    draft.bodies["block"] = {"mass": draft.given("m", 1, 4, "kg"), "at": ["0 m", "0 m"],
                             "slide": x if rail == ["1", "0"] else {"along": rail, "by": x}}
    a, h = draft.given("a", 0.6, 1, "m"), draft.given("h", 0.3, 0.8, "m")
    draft.bodies["wheel"] = {"shape": "disc", "mass": draft.given("m", 0.5, 2, "kg"), "radius": f"{r} m",
                             "at": to(f"({a})", f"({h})"), "pin": phi}
    draft.bodies["load"] = {"mass": draft.given("m", 0.5, 2, "kg"), "at": to(f"(({a}) + ({r} m))", "-0.2 m"),
                            "slide": {"along": fall, "by": y}}
    stop = {side: "wheel"}
    if draft.chance(0.5):
        del draft.bodies["wheel"]["shape"], draft.bodies["wheel"]["radius"]
        draft.bodies["wheel"]["inertia"] = draft.given("J", 0.01, 0.1, "kg*m^2")
        stop["radius"] = f"{r} m"
    draft.constraints["rope"] = {"rope": ["block", stop, "load"]}
    draft.carriers["block"], draft.places["block"] = (0.0, 0.0), (0.0, 0.0)
    draft.turning.append("wheel")
    draft.tied |= {phi, y}
    tie(draft, "block", tuple(map(float, rail)))


def crank(draft):
    """Crank, connecting rod and piston, joined at the crank pin; or a link without mass for the rod."""
    r, length = draft.some(0.08, 0.2), draft.some(0.4, 0.7)
    angle = draft.dice.uniform(0.4, 2.6)
    px, py = round(r * math.cos(angle), 4), round(r * math.sin(angle), 4)
    b = round(px + math.sqrt(length**2 - py**2), 4)
    phi, x = draft.coordinate("rad"), draft.coordinate("m")
    draft.points["P"] = {"body": "crank", "at": [f"{px} m", f"{py} m"]}
    draft.bodies["crank"] = {"inertia": draft.given("J", 0.01, 0.1, "kg*m^2"), "at": ["0 m", "0 m"], "pin": phi}
    draft.bodies["piston"] = {"mass": draft.given("m", 0.5, 3, "kg"), "at": [f"{b} m", "0 m"], "slide": x}
    draft.tied.add(x)
    if draft.chance(0.5):
        psi = draft.coordinate("rad")
        draft.points["A"] = {"body": "rod", "at": draft.points["P"]["at"]}
        draft.bodies["rod"] = {"shape": "rod", "mass": draft.given("m", 0.3, 2, "kg"), "from": [f"{b} m", "0 m"],
                               "to": draft.points["P"]["at"], "pin": {"at": "piston", "by": psi}}
        draft.constraints["pin"] = {"join": ["P", "A"]}
        draft.tied.add(psi)
    else:
        draft.constraints["rod"] = {"link": ["P", "piston"]}
    draft.carriers["piston"], draft.places["piston"], draft.places["P"] = (b, 0.0), (b, 0.0), (px, py)
    draft.turning.append("crank")
    tie(draft, "piston", (1, 0))
    draft.springs[draft.new("s")] = {"torsion": draft.given("q", 20, 100, "N*m/rad"), "between": ["ground", "crank"]}


def planets(draft):
    """A sun wheel, a planet on an arm, perhaps a ring around them."""
    r1, r2 = draft.given("r", 0.05, 0.1, "m"), draft.given("r", 0.03, 0.06, "m")
    alpha, beta, psi = (draft.coordinate("rad") for _ in range(3))
    r1, r2 = (f"({r})" for r in (r1, r2))
    draft.bodies.update(
        sun={"inertia": draft.given("J", 0.01, 0.1, "kg*m^2"), "at": ["0 m", "0 m"], "pin": alpha},
        arm={"inertia": draft.given("J", 0.02, 0.1, "kg*m^2"), "at": ["0 m", "0 m"], "pin": beta},
        planet={"shape": "disc", "mass": draft.given("m", 0.5, 2, "kg"), "radius": r2, "at": [f"{r1} + {r2}", "0 m"],
                "pin": {"carrier": "arm", "by": psi}})
    draft.constraints["inner"] = {"gear": ["sun", "planet"], "radii": [r1, r2], "carrier": "arm"}
    draft.tied.add(psi)
    if draft.chance(0.6):
        draft.bodies["ring"] = {"at": ["0 m", "0 m"]}
        draft.constraints["outer"] = {"gear": ["ring", "planet"], "radii": [f"{r1} + 2*{r2}", r2], "inside": True,
                                      "carrier": "arm"}
        draft.tied.add(beta)
    for body in ("sun", "arm"):
        draft.springs[draft.new("s")] = {"torsion": draft.given("q", 20, 100, "N*m/rad"), "between": ["ground", body]}
    draft.turning += ["sun", "arm", "planet"]
    if draft.chance(0.6):
        draft.sections["gravity"] = "9.81 m/s^2"


def kept(draft):
    """A body whose point stays on a line or a circle."""
    x, y, phi = draft.coordinate("m"), draft.coordinate("m"), draft.coordinate("rad")
    draft.bodies["plate"] = {"shape": "rectangle", "mass": draft.given("m", 1, 4, "kg"), "width": "0.6 m",
                             "height": draft.given("h", 0.1, 0.4, "m"), "at": ["0 m", "0 m"], "move": [x, y, phi]}
    draft.points["Q"] = {"body": "plate", "at": ["0.3 m", "0.1 m"]}
    if draft.chance(0.5):
        draft.surfaces["track"] = {"line": [["0.3 m", "0.1 m"], draft.spot(*(
            0.3 + draft.some(0.2, 0.6), 0.1 + draft.some(-0.3, 0.3)))]}
    else:
        dx, dy = draft.dice.choice(((0.3, 0.4), (-0.4, 0.3), (0.6, -0.8)))
        draft.surfaces["track"] = {"circle": draft.spot(0.3 + dx, 0.1 + dy), "radius": f"{math.hypot(dx, dy):.6g} m"}
    draft.constraints["held"] = {"point": "Q", "surface": "track"}
    draft.tied |= {y, phi}
    draft.carriers["plate"], draft.places["plate"], draft.places["Q"] = (0.0, 0.0), (0.0, 0.0), (0.3, 0.1)
    draft.turning.append("plate")
    tie(draft, "plate", (1, 0))
    tie(draft, "plate", (0, 1))
    draft.springs[draft.new("s")] = {"torsion": draft.given("q", 20, 100, "N*m/rad"), "between": ["ground", "plate"]}
    if draft.chance(0.5):
        draft.sections["gravity"] = "9.81 m/s^2"


def equated(draft):
    """Sliding blocks tied by an equation, which may hold the time."""
    from .draw_loads import wave

    x, y = draft.coordinate("m"), draft.coordinate("m")
    for name, coordinate, at in (("one", x, (0.0, 0.0)), ("two", y, (0.2, 0.5))):
        draft.bodies[name] = {"mass": draft.given("m", 0.5, 3, "kg"), "at": draft.spot(*at), "slide": coordinate}
        draft.carriers[name] = draft.places[name] = at
        tie(draft, name, (1, 0.3))
    if draft.chance(0.4):
        right = f"{x} + {x}^2/(2 m)"
    else:
        right = f"{draft.some(0.5, 2)}*{x}"
        right += " + " + wave(draft, "Y", 0.005, 0.03, "m", ("sin", "versine", "decay")) if draft.chance(0.5) else ""
    tie_ = f"{y} = {right}"
    draft.constraints["tied"] = {"equation": tie_} if draft.chance(0.4) else tie_
    draft.tied.add(y)


def spun(draft):
    """Blocks on a rotor that turns steadily, held in it by springs."""
    W = draft.given("W", 1, 4, "rad/s")
    draft.bodies["rotor"] = {"inertia": draft.given("J", 0.1, 1, "kg*m^2"), "at": ["0 m", "0 m"],
                             "pin": f"({W})*t" if " " in W else f"{W}*t"}
    draft.points["O"] = {"body": "rotor", "at": ["0 m", "0 m"]}
    for _ in range(draft.dice.choice((1, 1, 2))):
        name, x = draft.new("block"), draft.coordinate("m")
        px, py = draft.some(0.2, 0.5), draft.some(-0.3, 0.3)
        along = draft.dice.choice((["1", "0"], ["0.6", "0.8"], ["0", "1"]))
        draft.bodies[name] = {"mass": draft.given("m", 0.5, 3, "kg"), "at": draft.spot(px, py),
                              "slide": {"along": along, "by": x, "carrier": "rotor"}}
        end = draft.new("B")
        ex, ey = (draft.some(0.4, 0.8) * float(c) for c in along)
        draft.points[end] = {"body": "rotor", "at": draft.spot(px + ex, py + ey)}
        draft.springs[draft.new("s")] = {"k": draft.given("k", 300, 2000, "N/m"), "between": [end, name]}
        if draft.chance(0.5):
            draft.springs[draft.new("s")] = {"k": draft.given("k", 50, 300, "N/m"), "between": ["O", name]}
        if draft.chance(0.6):
            draft.dampers[draft.new("d")] = {"c": draft.given("c", 0.5, 8, "N*s/m"), "between": [end, name]}
        if draft.chance(0.6):
            draft.forces[draft.new("f")] = {"at": name, "carrier": "rotor", "force": [
                draft.given("F", 1, 6, "N"), "-" + draft.given("F", 1, 6, "N")]}


def shaken(draft):
    """A cart that moves as prescribed carries a block on a spring, or a pendulum, which carries another body."""
    from .draw_loads import SMOOTH, wave
    from .draw_plane import pin, place_for

    by, way = wave(draft, "Y", 0.005, 0.03, "m", SMOOTH), draft.dice.choice(("slide", "slide", "move", "roll"))
    draft.bodies["cart"] = {"mass": draft.given("m", 1, 4, "kg"), "at": ["0 m", "0 m"]}
    if way == "slide":
        draft.bodies["cart"]["slide"] = {"along": draft.dice.choice((["1", "0"], ["0.6", "0.8"])), "by": by}
    elif way == "move":
        draft.bodies["cart"]["move"] = [by, "0", wave(draft, "Y", 0.01, 0.05, "rad", SMOOTH)]
    else:
        draft.surfaces["floor"] = {"line": [["0 m", "-0.2 m"], ["1 m", "-0.2 m"]]}
        draft.bodies["cart"].update(shape="ring", radius="0.2 m", roll={"surface": "floor", "travel": by})
    if draft.chance(0.5):
        draft.sections["gravity"] = draft.given("g", 9.7, 9.9, "m/s^2")
    draft.carriers["cart"] = 0.0, 0.0
    if draft.chance(0.5):
        x = draft.coordinate("m")
        draft.bodies["block"] = {"mass": draft.given("m", 0.5, 3, "kg"), "at": ["0 m", "0.5 m"],
                                 "slide": {"along": ["1", "0"], "by": x, "carrier": "cart"}}
        draft.points["C"] = {"body": "cart", "at": [f"-{draft.some(0.3, 0.7)} m", "0.5 m"]}
        draft.springs[draft.new("s")] = {"k": draft.given("k", 200, 2000, "N/m"), "between": ["C", "block"]}
        draft.dampers[draft.new("d")] = {"c": draft.given("c", 0.5, 9, "N*s/m"), "between": ["C", "block"]}
        draft.carriers["block"] = 0.0, 0.5
    pin(draft, place_for(draft, "cart"), draft.dice.choice(list(draft.carriers)))


def mechanism(draft):
    draft.dice.choice((hoist, slanted_rope, crank, crank, planets, kept, equated, spun, spun, shaken))(draft)
