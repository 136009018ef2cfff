"""Bodies on one axis: masses that translate, discs that turn, each tied to those before it."""


def chain(draft):
    """Masses in a row; one of them may be driven, or move as another does."""
    n = draft.dice.choice((1, 2, 2, 3, 4))
    for i in range(n):
        name = draft.new("block")
        if i and draft.chance(0.15):
            other = draft.dice.choice(list(draft.coordinates))
            draft.bodies[name] = {"mass": draft.given("m", 0.5, 5, "kg"), "slide": f"{draft.some(0.3, 2)}*{other}"}
        else:
            draft.bodies[name] = {"mass": draft.given("m", 0.5, 5, "kg"), "slide": draft.coordinate("m")}
        before = draft.dice.choice(["ground", *draft.axis]) if i else "ground"
        ends = [before, name]
        if draft.chance(0.3):
            ends.reverse()
        draft.springs[draft.new("s")] = {"k": draft.given("k", 100, 2000, "N/m"), "between": ends}
        draft.axis.append(name)
    for _ in range(draft.dice.choice((0, 1, 1, 2))):
        ends = draft.dice.sample(["ground", *draft.axis], 2)
        draft.dampers[draft.new("d")] = {"c": draft.given("c", 0.5, 30, "N*s/m"), "between": ends}
    if draft.chance(0.3):
        x = draft.dice.choice(list(draft.coordinates))
        draft.springs[draft.new("s")] = {"k": draft.given("k", 50, 500, "N/m"),
                                         "stretch": f"{draft.some(0.2, 2)}*{x}"}
    if draft.chance(0.2):
        x = draft.dice.choice(list(draft.coordinates))
        draft.dampers[draft.new("d")] = {"c": draft.given("c", 0.5, 9, "N*s/m"), "stretch": f"{draft.some(0.2, 2)}*{x}"}
    if draft.chance(0.3):
        _support(draft)
    if draft.chance(0.2):
        _stop(draft)


def _stop(draft):
    """A spring with play, or one that only pulls or only pushes, not reached as drawn."""
    ends = ["ground", draft.dice.choice(draft.axis)]
    if draft.chance(0.5):
        ends.reverse()
    spring = {"k": draft.given("k", 100, 1000, "N/m"), "between": ends, "gap": draft.given("e", 0.01, 0.05, "m")}
    if draft.chance(0.8):
        spring["acts"] = draft.dice.choice(("tension", "compression"))
    draft.springs[draft.new("s")] = spring
    draft.sections["motion"] = "full"


def _support(draft):
    """A support without mass that moves as prescribed."""
    from .draw_loads import SMOOTH, wave

    name = draft.new("support")
    draft.bodies[name] = {"slide": wave(draft, "Y", 0.01, 0.05, "m", SMOOTH)}
    draft.springs[draft.new("s")] = {"k": draft.given("k", 100, 2000, "N/m"),
                                     "between": [name, draft.dice.choice(draft.axis)]}
    if draft.chance(0.5):
        draft.dampers[draft.new("d")] = {"c": draft.given("c", 0.5, 30, "N*s/m"),
                                         "between": [name, draft.dice.choice(draft.axis)]}


def shaft(draft):
    """Discs on a shaft, geared or belted to one another here and there."""
    n = draft.dice.choice((1, 2, 2, 3))
    for i in range(n):
        name = draft.new("disc")
        J = draft.given("J", 0.02, 0.5, "kg*m^2")
        if i and draft.chance(0.2):
            other = draft.dice.choice(list(draft.coordinates))
            draft.bodies[name] = {"inertia": J, "turn": f"-{draft.some(0.3, 2)}*{other}"}
        else:
            draft.bodies[name] = {"inertia": J, "turn": draft.coordinate("rad")}
        before = draft.dice.choice(["ground", *draft.turning]) if i else "ground"
        draft.springs[draft.new("s")] = {"torsion": draft.given("q", 10, 300, "N*m/rad"), "between": [before, name]}
        draft.turning.append(name)
    if draft.chance(0.25):
        from .draw_loads import SMOOTH, wave

        shaker = draft.new("shaker")
        draft.bodies[shaker] = {"turn": wave(draft, "Y", 0.02, 0.1, "rad", SMOOTH)}
        draft.springs[draft.new("s")] = {"torsion": draft.given("q", 10, 100, "N*m/rad"),
                                         "between": [shaker, draft.dice.choice(draft.turning)]}
    if draft.chance(0.6):
        ends = draft.dice.sample(["ground", *draft.turning], 2)
        draft.dampers[draft.new("d")] = {"torsion": draft.given("b", 0.02, 2, "N*m*s"), "between": ends}
    own = [name for name in draft.turning if draft.bodies[name]["turn"] in draft.coordinates]
    if len(own) > 1 and draft.chance(0.5):
        pair = draft.dice.sample(own, 2)
        draft.tied.add(max((draft.bodies[name]["turn"] for name in pair), key=list(draft.coordinates).index))
        tie = {draft.dice.choice(("gear", "belt")): pair,
               "radii": [draft.given("r", 0.05, 0.2, "m"), draft.given("r", 0.05, 0.2, "m")]}
        if draft.chance(0.4):
            tie["inside" if "gear" in tie else "crossed"] = True
        draft.constraints[draft.new("tie")] = tie
