"""Where bodies are: the rigid displacement of each from the drawn position, as jets of the coordinates.

A displacement takes a place drawn at p to Rot(angle) p + (x, y).
"""

from . import jets


class Displacement:
    def __init__(self, angle=0, x=0, y=0):
        self.angle, self.x, self.y = angle, x, y
        turned = isinstance(angle, jets.Jet) or angle != 0
        self.c, self.s = (jets.cos(angle), jets.sin(angle)) if turned else (1, 0)

    def turn(self, x, y):
        return (self.c * x - self.s * y, self.s * x + self.c * y)

    def __call__(self, place):
        x, y = self.turn(*place)
        return x + self.x, y + self.y

    def after(self, first):
        """First that displacement, then this one."""
        return Displacement(self.angle + first.angle, *self((first.x, first.y)))


def about(place, angle, to=None):
    """Turned by an angle about a place, which moves to another."""
    turned = Displacement(angle)
    x, y = turned(place)
    to = to or place
    return Displacement(angle, to[0] - x, to[1] - y)


def length(x, y):
    return jets.sqrt(x * x + y * y)


class Bodies:
    """The displacements of all bodies of a figure for one set of values, each found when it is asked for."""

    def __init__(self, figure, known):
        self.figure, self.known, self.found = figure, known, {}

    def change(self, text):
        return self.figure.change(text, self.known)

    def __getitem__(self, name):
        if name not in self.found:
            own = self._displacement(name, self.figure.scene["bodies"][name])
            self.found[name] = self._given_way(name, own)
        return self.found[name]

    def _given_way(self, name, own):
        """Let go by what supports it: moved further, along x and y and about its pin or centre (Figure.gives)."""
        first = self.figure.gives.get(name)
        if first not in self.known:
            return own
        x, y, angle = (self.known[first + i] for i in range(3))
        words, at = self.figure.scene["bodies"][name], self.figure.bodies[name].centre
        if "pin" in words:
            motion = words["pin"]
            at = motion.get("at", at) if isinstance(motion, dict) else at
            at = self.figure.drawn(at) if isinstance(at, str) else self.figure.place(at) if isinstance(at, list) else at
        elif "roll" in words:
            at = self.figure.bodies[name].circle
        px, py = own(at)
        return about((px, py), angle, (px + x, py + y)).after(own)

    def place(self, end):
        """Where a named point or body, or the place [x, y], is."""
        figure = self.figure
        if isinstance(end, list):
            return figure.place(end)
        if end in figure.points:
            words, at = figure.points[end], figure.drawn(end)
            if "moves" in words:
                return at[0] + self.change(words["moves"][0]), at[1] + self.change(words["moves"][1])
            return self[words["body"]](at) if "body" in words else at
        return self[end](figure.drawn(end))

    def circle(self, name):
        """Where the centre of the circle of a body is."""
        return self[name](self.figure.bodies[name].circle)

    def _displacement(self, name, words):
        for kind in ("slide", "pin", "roll", "move", "weld"):
            if kind in words:
                return getattr(self, "_" + kind)(name, words[kind])
        return Displacement()

    def _carrier(self, motion):
        return self[motion["carrier"]] if isinstance(motion, dict) and "carrier" in motion else Displacement()

    def _slide(self, name, motion):
        motion = motion if isinstance(motion, dict) else {"by": motion}
        by = self.change(motion["by"])
        if "surface" in motion:
            return self._slide_on(self.figure.scene["surfaces"][motion["surface"]], by, name)
        x, y = self.figure.place(motion.get("along", ["1", "0"]))
        size = length(x, y)
        return self._carrier(motion).after(Displacement(0, by * (x / size), by * (y / size)))

    def _slide_on(self, surface, by, name):
        under, (x0, y0) = self._carrier({"carrier": surface["body"]} if "body" in surface else {}), (
            self.figure.drawn(name))
        if "line" in surface:
            (ax, ay), (bx, by_) = (self.figure.place(p) for p in surface["line"])
            size = length(bx - ax, by_ - ay)
            return under.after(Displacement(0, by * ((bx - ax) / size), by * ((by_ - ay) / size)))
        if "circle" in surface:
            cx, cy = self.figure.place(surface["circle"])
            turned = Displacement(by / length(x0 - cx, y0 - cy))
            x, y = turned.turn(x0 - cx, y0 - cy)
            return under.after(Displacement(0, x + cx - x0, y + cy - y0))
        height = self.figure.curve(surface, x0 + by) - self.figure.curve(surface, x0)
        return under.after(Displacement(0, by, height))

    def _pin(self, name, motion):
        motion = motion if isinstance(motion, dict) else {"by": motion}
        angle, at = self.change(motion["by"]), motion.get("at")
        if at is None:
            at = self.figure.drawn(name)
        drawn = self.figure.drawn(at) if isinstance(at, str) else self.figure.place(list(at))
        carrier = self._carrier(motion)
        if str(motion.get("relative")).lower() == "true":
            angle = angle + (carrier.angle if "carrier" in motion else self.angle_of_point(at))
        to = self.place(at) if isinstance(at, str) and "carrier" not in motion else carrier(drawn)
        return about(drawn, angle, to)

    def angle_of_point(self, at):
        """Of the body that carries a point."""
        words = self.figure.points.get(at, {"body": at}) if isinstance(at, str) else {}
        return self[words["body"]].angle if "body" in words else 0

    def _move(self, name, motion):
        by = motion["by"] if isinstance(motion, dict) else motion
        x, y, angle = (self.change(text) for text in by)
        x0, y0 = self.figure.drawn(name)
        return self._carrier(motion).after(about((x0, y0), angle, (x0 + x, y0 + y)))

    def _weld(self, name, carrier):
        return self[carrier]

    def _roll(self, name, motion):
        figure, surface = self.figure, self.figure.scene["surfaces"][motion["surface"]]
        under = self._carrier({"carrier": surface["body"]} if "body" in surface else {})
        centre, radius = figure.bodies[name].circle, figure.bodies[name].radius
        radius = figure.number(motion["radius"]) if "radius" in motion else radius
        if "line" in surface:
            (ax, ay), (bx, by) = (figure.place(p) for p in surface["line"])
            size = length(bx - ax, by - ay)
            ex, ey = (bx - ax) / size, (by - ay) / size
            left = 1 if jets.real(ex * (centre[1] - ay) - ey * (centre[0] - ax)) > 0 else -1
            per_turn = -left * radius               # travel to a turn counter-clockwise, both seen from the surface
        else:
            cx, cy = figure.place(surface["circle"])
            distance = length(centre[0] - cx, centre[1] - cy)
            per_turn = radius if surface.get("side", "outside") == "outside" else -radius
        if "travel" in motion:
            travel = self.change(motion["travel"])
        elif "turn" in motion:
            travel = per_turn * (self.change(motion["turn"]) - under.angle)
        else:
            travel = distance * self.change(motion["swing"])
        if "line" in surface:
            to = (centre[0] + ex * travel, centre[1] + ey * travel)
        else:
            to = about((cx, cy), travel / distance)(centre)
        return under.after(about(centre, travel / per_turn, to))
