"""Mass, mass centre and moment of inertia of uniform plane shapes, by the integrals that handbooks list."""

from . import jets


def shape_of(words, number, place, pi):
    """(mass, centre x, y, moment about the centre, circle's centre or None, its radius) of one shape.

    `number(text)`: a value; `place(pair)`: two of them.
    """
    def given(key, otherwise=0):
        return number(words[key]) if key in words else otherwise

    kind, radius = words.get("shape", "particle"), given("radius")
    at = place(words["at"]) if "at" in words else None
    size, k2, centre = 0, 0, at
    if kind == "disc":
        size, k2 = pi * radius**2, radius**2 / 2
    elif kind == "ring":
        size, k2 = 2 * pi * radius, radius**2
    elif kind == "rod":
        (x1, y1), (x2, y2) = place(words["from"]), place(words["to"])
        size = jets.sqrt((x2 - x1) ** 2 + (y2 - y1) ** 2)
        k2, centre = size**2 / 12, ((x1 + x2) / 2, (y1 + y2) / 2)
    elif kind == "rectangle":
        size, k2 = given("width") * given("height"), (given("width") ** 2 + given("height") ** 2) / 12
    elif kind == "ellipse":
        size, k2 = pi * given("a") * given("b"), (given("a") ** 2 + given("b") ** 2) / 4
    elif kind in ("sector", "arch"):
        half, turned = given("half_angle"), given("angle")
        out = radius * jets.sin(half) / half * (2 / number("3") if kind == "sector" else 1)
        size = radius**2 * half if kind == "sector" else 2 * radius * half
        k2 = radius**2 / (2 if kind == "sector" else 1) - out**2
        centre = (at[0] + out * jets.cos(turned), at[1] + out * jets.sin(turned))
    mass = given("mass") if "mass" in words else given("density") * size
    circle = at if kind in ("disc", "ring", "sector", "arch") else None
    return mass, *centre, mass * k2, circle, radius


def body_of(words, number, place, pi):
    """The same of a body, whose parts may be several; `inertia` and `gyration` override."""
    if "parts" not in words:
        mass, x, y, J, circle, radius = shape_of(words, number, place, pi)
    else:
        pieces = []
        for part in words["parts"]:
            m, x, y, J, *_ = shape_of(part, number, place, pi)
            sign = -1 if part.get("cut") else 1
            pieces.append((sign * m, x, y, sign * J))
        mass = sum(m for m, *_ in pieces)
        x, y = sum(m * x for m, x, *_ in pieces) / mass, sum(m * y for m, _, y, _ in pieces) / mass
        J = sum(J + m * ((px - x) ** 2 + (py - y) ** 2) for m, px, py, J in pieces)
        circle, radius = None, 0
    if "inertia" in words:
        J = number(words["inertia"])
    if "gyration" in words:
        J = mass * number(words["gyration"]) ** 2
    return mass, x, y, J, circle or (x, y), radius
