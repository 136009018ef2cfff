"""Spec to Scene: every body, spring and damper becomes scalar functions s(q) with their weights.

    T = ½ Σ w ṡ²       V = Σ (N s + ½ k s²) − Σ m (gₓ x + g_y y)       Φ = ½ Σ c ṡ²
"""

from fractions import Fraction

from vibcli import units
from vibcli.algebra.calculus import substitute
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.expression import Table
from vibcli.algebra.meaning import lower
from vibcli.algebra.normal import is_zero, root_of_square, textbook
from vibcli.algebra.parse import ExpressionError
from vibcli.elements import gravity
from vibcli.errors import Diagnostic, SpecError
from vibcli.fields import load
from vibcli.parameters import Parameters, unusable
from vibcli.scene.ends import Ends
from vibcli.scene.frame import Frame
from vibcli.scene.order import carriers_first
from vibcli.scene.terms import Terms

ATTEMPTS = 12
SAMPLES = range(20, 28)     # where other samples start
SIZES = (1, 0.1, 0.01, 10)  # of what is chosen beside the numbers of a scene


def build_scene(spec, given=None, start=0):
    """The Scene of a Spec; SpecError where its geometry contradicts itself.

    A scene with symbols is drawn with sample values, those that are `given` and others; signs such as that of R − r
    are those of the first sample in which the drawing fits together.
    """
    for attempt in range(start, start + ATTEMPTS):
        scene = Scene(spec, attempt, given or {})
        try:
            scene.assemble()
        except ExpressionError as error:
            scene.report(None, error.message)
        if not scene.diagnostics or not set(scene.parameters.free) - set(given or {}):
            break
    if scene.diagnostics:
        raise SpecError(scene.diagnostics)
    return scene


class Scene(Terms, Ends):
    """The scalar functions of a scene, and the services by which elements make them."""

    def __init__(self, spec, attempt, given):
        self.spec, self.diagnostics = spec, []
        self.table = table = Table()
        self.coordinates = list(spec.coordinates)
        self.parameters = Parameters(spec, table)
        given = {name: float(value) for name, value in given.items()}
        free = sample_values(self.parameters.free, attempt)
        free |= {name: free[name] * SIZES[attempt % len(SIZES)] for name in spec.choices if name in free}
        self.sample = self.parameters.values(Floats, {**free, **given})
        table.sample = self.sample
        self.q = [table.variable(name) for name in self.coordinates]
        self.v = [table.variable(name + "'") for name in self.coordinates]
        self.a = [table.variable(name + "''") for name in self.coordinates]
        self._symbols = {(name, primes): node for primes, nodes in enumerate((self.q, self.v, self.a))
                         for name, node in zip(self.coordinates, nodes, strict=True)}
        self.drawn = {node: self._drawn_value(name) for name, node in zip(self.coordinates, self.q, strict=True)}
        self._drawn_at_rest = {**self.drawn, **dict.fromkeys(self.v, table.zero)}
        self.surfaces = spec.get("surfaces") or {}
        self.bodies, self.points = {}, {}
        self.ground = Frame((table.zero, table.zero), (table.zero, table.zero), table.zero)
        self.start_terms()

    def assemble(self):
        """Build the bodies, carriers first, then what connects them."""
        spec = self.spec
        self.gravity = gravity.build(spec.get("gravity"), self) if "gravity" in spec.sections else None
        order = carriers_first(spec, self.report)
        for name in order:
            self.bodies[name] = load("body").build(spec.get("bodies")[name], self)
        if self.diagnostics:
            return
        for section, element in (("springs", "spring"), ("dampers", "damper")):
            for record in (spec.get(section) or {}).values():
                try:
                    load(element).build(record, self)
                except ZeroDivisionError:
                    self.report(record.where, f"'{record.name}' divides by zero as drawn", "draw its ends apart")
        for section in ("energies", "matrices"):
            if section in spec.sections:
                load(section).build(spec.get(section), self)

    def report(self, where, message, hint=None):
        self.diagnostics.append(Diagnostic(where, message, hint))

    # expressions

    def lower(self, expression):
        """The node of a parsed field."""
        try:
            node = lower(expression.tree, self.table, self._symbol)
        except ExpressionError as error:
            self.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
            return self.table.one
        problem = None if node.mask or node.op == "symbol" else unusable(self._constant(node), Floats)
        if problem:
            self.report(expression.scalar.place(0, len(expression.text)), "this value is " + problem[0], problem[1])
        return self.table.one if problem else node

    def _constant(self, node):
        return evaluate([node], Floats, self.sample)[0]

    def positive(self, expression, what, zero=False):
        """The node of a field whose value must be positive, or not negative."""
        node = self.lower(expression)
        value = self._constant(node)
        if not (value > 0 or (zero and value == 0)):
            found = f"{value:.6g} {units.text(expression.dimension or {})}".rstrip()
            wanted = "zero or more" if zero else "a positive value"
            self.report(expression.where, f"{what} is {found}, expected {wanted}",
                        "mind the signs" if value < 0 else None)
        return node

    def _symbol(self, name, primes, tree):
        known = self._symbols.get((name, primes))
        return known if known is not None else self.parameters.nodes[name]

    def _drawn_value(self, name):
        record = self.spec.coordinates[name]
        return self.lower(record["drawn"]) if "drawn" in record else self.table.zero

    def at_drawn(self, *nodes):
        """The nodes in the drawn position, at rest."""
        return substitute(nodes, self._drawn_at_rest) if any(node.mask for node in nodes) else list(nodes)

    def change(self, expression):
        """How much an expression has changed since the drawn position."""
        node = self.lower(expression)
        return node - self.at_drawn(node)[0]

    def pair(self, expressions):
        return self.lower(expressions[0]), self.lower(expressions[1])

    def number(self, node):
        """The value of a node as drawn, with sample values for symbols."""
        return evaluate(self.at_drawn(node), Floats, self.sample)[0]

    def sign(self, node):
        return -1 if self.number(node) < 0 else 1

    def agree(self, a, b):
        """Are two expressions the same, by algebra or at the sample?"""
        if a is b or is_zero(a - b):
            return True
        x, y = self.number(a), self.number(b)
        return abs(x - y) <= 1e-9 * max(abs(x), abs(y))

    def require_equal(self, a, b, where, message, hint=None):
        """Report `message` with both values where they differ in the drawn position."""
        if not self.agree(*self.at_drawn(a, b)):
            self.report(where, message.format(f"{self.number(a):.6g}", f"{self.number(b):.6g}"), hint)

    # geometry

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
        root = root_of_square(dx * dx + dy * dy)
        if root is not None:
            return root if self.sign(root) > 0 else -root
        return self.table.sqrt(dx * dx + dy * dy)

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
        drawn, present = load("point").build(record, self)
        return drawn, present, self.carrier(record, "body")


def sample_values(names, attempt):
    """Values for symbols without one: positive, unrelated, and others at each attempt."""
    return {name: 0.6 + 1.7 * ((Fraction(7919 * (i + 1) + 104729 * attempt, 10007) * (attempt + 3)) % 1)
            for i, name in enumerate(names)}


