"""Places, directions and distances of a scene."""

from vibcli.language.fields import load
from vibcli.scene.frame import Frame
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, root_of_square, textbook
from vibcli.symbolic.rationals import ONE


class Geometry:
    """The part of a Scene that turns what is drawn into expressions."""

    def unit(self, dx, dy, where=None):
        """The unit vector along (dx, dy), constants."""
        length = self.distance(dx, dy)
        if abs(self.number(length)) == 0:
            self.report(where, "this direction has no length", "give one such as [0, 1], or two different places")
            return self.table.one, self.table.zero
        return dx / length, dy / length

    def direction(self, expressions):
        return self.unit(*self.pair(expressions), expressions[0].where)

    def distance(self, dx, dy):
        """√(dx² + dy²), rational where the direction never changes: there it is ±dx, ±dy or their projection."""
        dx0, dy0 = self.at_drawn(dx, dy)
        for along, across in ((dx, dy), (dy, dx)):
            if is_zero(across):
                return along if self.sign(along) > 0 else -along
        if not dx.mask and not dy.mask:
            return self.table.sqrt(textbook(dx * dx + dy * dy))
        if is_zero(dx * dy0 - dy * dx0):
            return (dx * dx0 + dy * dy0) / self.distance(dx0, dy0)
        square = dx * dx + dy * dy
        root = root_of_square(square)
        if root is not None:
            return root if self.sign(root) > 0 else -root
        return self.table.sqrt(textbook(square) if square.mask & self.time.mask else square)

    def unrooted(self, nodes):
        """The nodes with √(L² cos² θ) as L cos θ, with its sign as drawn."""
        simpler = {}
        for part in reachable(nodes):
            roots = {base: root_of_square(base) for base, e in part.args
                     if e.denominator == 2 and base.mask} if part.op == "product" else {}
            if any(root is not None for root in roots.values()):
                factors = [(base, e) if (root := roots.get(base)) is None else
                           (root if self.sign(root) > 0 else -root, 2 * e) for base, e in part.args]
                simpler[part] = self.table.product((self.table.number(part.coefficient), ONE), *factors)
        return substitute(nodes, simpler) if simpler else nodes

    def frame(self, name):
        frame = self.bodies[name.text].frame
        if frame is None:
            self.report(name.where, f"'{name.text}' has no place, so it carries nothing",
                        "say where it is drawn with `at: [x, y]`")
        return frame or self.ground

    def carrier(self, record, key="carrier"):
        return self.frame(record[key]) if key in record else self.ground

    def new_frame(self, drawn, place, angle):
        return Frame(drawn, place, angle)

    def still(self, drawn):
        return Frame(drawn, drawn, self.table.zero)

    def rim(self, body, where):
        """The centre as drawn of the circle about which a body rolls, meshes and carries ropes; of one that is not
        round its pin, or else its mass centre."""
        if len(body.rims) > 1:
            self.report(where, f"which circle of '{body.name}' is meant is not clear: its parts have several",
                        "give the body, beside its `parts`, the centre of that circle: `at: [x, y]`")
        if body.rims:
            return body.rims[0]
        return body.frame.drawn if "pin" in body.record else body.centre

    def place_of(self, end):
        """Where an end is now: a place [x, y], or a named point or body."""
        return self.pair(end) if isinstance(end, list) else self.place(end)[1]

    def height_of(self, surface, x):
        """f(x) of a curve y = f(x)."""
        return self.lower(surface["curve"], (surface["in"], x))

    def unit_normal(self, y, u):
        """The upward normal (−y′, 1)/√(1 + y′²) of a curve, y being a function of the displacement u."""
        slope = self.table.zero
        for x, partial in gradient(y).items():
            if x in gradient(u):
                slope = partial / gradient(u)[x]
        length = self.table.sqrt(slope * slope + 1)
        return -slope / length, 1 / length

    def pivot(self, pin, body):
        """(pin as drawn, pin now, frame that carries it)."""
        carrier = self.carrier(pin)
        at = pin.get("at")
        if at is None:
            drawn = body.centre
        elif isinstance(at, list):
            drawn = self.pair(at)
        else:
            drawn, place, frame = self.place(at)
            if "carrier" not in pin:
                return drawn, place, frame
        return drawn, carrier.point(*drawn), carrier

    def place(self, name):
        """(drawn, present, carrying frame) of a named point or body."""
        if name.text in self.bodies:
            body = self.bodies[name.text]
            if body.frame is None:
                self.report(name.where, f"'{name.text}' has no place", "say where it is drawn with `at: [x, y]`")
                return self.ground.drawn, self.ground.drawn, self.ground
            return body.centre, body.frame.point(*body.centre), body.frame
        record = self.spec.get("points")[name.text]
        drawn, present = self.points[name.text] = (self.points.get(name.text)
                                                   or load("point").build(record, self))
        return drawn, present, self.carrier(record, "body")
