"""Spec to Scene: every body, spring and damper becomes scalar functions s(q) with their weights.

    T = ½ Σ w ṡ²       V = Σ (N s + ½ k s²) − Σ m (gₓ x + g_y y)       Φ = ½ Σ c ṡ²
"""

from fractions import Fraction

from vibcli import units
from vibcli.algebra.calculus import gradient, substitute
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.expression import Table, reachable
from vibcli.algebra.meaning import lower
from vibcli.algebra.normal import TooLong, expanded, is_zero, reduced, root_of_square, textbook
from vibcli.algebra.parse import ExpressionError
from vibcli.algebra.rationals import ONE
from vibcli.elements import gravity
from vibcli.errors import Diagnostic, SpecError
from vibcli.fields import load
from vibcli.parameters import Parameters, unusable
from vibcli.scene.closing import Freedom, close
from vibcli.scene.ends import Ends
from vibcli.scene.frame import Frame
from vibcli.scene.order import carriers_first
from vibcli.scene.terms import Terms

ATTEMPTS = 12
SAMPLES = range(20, 28)     # where other samples start
SIZES = (1, 0.1, 0.01, 10)  # of what is chosen beside the numbers of a scene


def build_scene(spec, given=None, start=0, loose=False, releasing=False):
    """The Scene of a Spec; SpecError where its geometry contradicts itself.

    A `loose` scene keeps all coordinates: its constraints are held by multipliers. `releasing`: the supports of bodies
    give way by further coordinates, whose generalised forces are the reactions.

    A scene with symbols is drawn with sample values, those that are `given` and others; signs such as that of R − r
    are those of the first sample in which the drawing fits together.
    """
    for attempt in range(start, start + ATTEMPTS):
        try:
            scene = Scene(spec, attempt, given or {}, releasing)
        except SpecError:   # a parameter that this sample leaves without value
            if attempt == start + ATTEMPTS - 1:
                raise
            continue
        try:
            scene.assemble(loose)
        except ExpressionError as error:
            scene.report(None, error.message)
        if not scene.diagnostics or not set(scene.parameters.free) - set(given or {}):
            break
    if scene.diagnostics:
        raise SpecError(scene.diagnostics)
    return scene


class Scene(Terms, Ends):
    """The scalar functions of a scene, and the services by which elements make them."""

    def __init__(self, spec, attempt, given, releasing=False):
        self.spec, self.diagnostics, self.attempt, self.releasing = spec, [], attempt, releasing
        self.table = table = Table()
        self.coordinates = list(spec.coordinates)
        self.parameters = Parameters(spec, table)
        given = {name: float(value) for name, value in given.items()}
        free = sample_values(self.parameters.free, attempt)
        free |= {name: free[name] * SIZES[attempt % len(SIZES)] for name in spec.choices if name in free}
        self.sample = self.parameters.values(Floats, {**free, **given})
        table.sample = self.sample
        named = "t" in spec.parameters or "t" in spec.coordinates
        self.time = table.variable("the time" if named else "t")
        self.q, self.v, self.a = ([table.variable(name + primes) for name in self.coordinates]
                                  for primes in ("", "'", "''"))
        self._symbols = {(name, primes): node for primes, nodes in enumerate((self.q, self.v, self.a))
                         for name, node in zip(self.coordinates, nodes, strict=True)}
        self._symbols[self.time.name, 0] = self.time
        self.drawn = {node: self._drawn_value(name) for name, node in zip(self.coordinates, self.q, strict=True)}
        self._drawn_at_rest = {**self.drawn, **dict.fromkeys(self.v, table.zero), self.time: table.zero}
        self.speeds = self._speeds()
        self.constraints, self.loops, self.dependent, self.driven = [], None, {}, {}
        self.freedom = Freedom(len(self.q), 0, ())
        self.surfaces = spec.get("surfaces") or {}
        self.bodies, self.points = {}, {}
        self.ground = Frame((table.zero, table.zero), (table.zero, table.zero), table.zero)
        self.start_terms()

    def _speeds(self):
        """{x: dx/dt} of coordinates, velocities and the time."""
        return dict(zip((*self.q, *self.v, self.time), (*self.v, *self.a, self.table.one), strict=True))

    def assemble(self, loose=False):
        """Build the bodies, carriers first, then what connects them, then close the loops that constraints make."""
        spec = self.spec
        self.gravity = gravity.build(spec.get("gravity"), self) if "gravity" in spec.sections else None
        order = carriers_first(spec, self.report)
        for name in order:
            self.owner = name
            self.bodies[name] = load("body").build(spec.get("bodies")[name], self)
        if self.diagnostics:
            return
        for section, element in (("springs", "spring"), ("dampers", "damper"), ("forces", "force"),
                                 ("constraints", "constraint")):
            for record in (spec.get(section) or {}).values():
                self.owner = record.name
                try:
                    load(element).build(record, self)
                except ZeroDivisionError:
                    self.report(record.where, f"'{record.name}' divides by zero as drawn", "draw its ends apart")
        for section in ("energies", "matrices"):
            if section in spec.sections:
                load(section).build(spec.get(section), self)
        if self.driven:
            shaken = list(self.springs), list(self.dampers)
            self.replace(self.driven)
            self.shaking, (self.shaken, self.shaken_dampers) = True, shaken
            self.points = {name: (drawn, tuple(substitute(place, self.driven)))
                           for name, (drawn, place) in self.points.items()}
        if self.constraints and not loose and not self.diagnostics:
            self.dependent = close(self)
        self.timed = self.depends_on_time()

    def report(self, where, message, hint=None):
        self.diagnostics.append(Diagnostic(where, message, hint))

    # expressions

    def lower(self, expression, local=None):
        """The node of a parsed field; `local`: (name, node) of a name that is good there alone."""
        def symbol(name, primes, tree):
            return local[1] if local and name == local[0] and not primes else self._symbol(name, primes, tree)

        try:
            node = lower(expression.tree, self.table, symbol)
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
        if name in self.parameters.in_letters:
            return self.parameters.in_letters[name]
        return self.parameters.nodes[name] if name in self.parameters.nodes else self.symbol(name, primes)

    def symbol(self, name, primes=0):
        """The node of a coordinate, its velocity or acceleration; of a dependent one, what it equals."""
        if primes == 2 and (name, 2) not in self._symbols:
            self._symbols[name, 2] = self.rate(self._symbols[name, 1])
        return self._symbols[name, primes]

    def driven_by(self, node):
        """A driven displacement: where it depends on the time, a symbol that is zero as drawn and stands for it until
        the scene is assembled."""
        if not node.mask & self.time.mask:
            return node
        symbol = self.table.dependent(f"driven {len(self.driven)}", node.mask)
        self.driven[symbol], self._drawn_at_rest[symbol] = node, self.table.zero
        return symbol

    def release(self, body):
        """Let the support of a body give way: by x and y in the fixed axes, and by a rotation."""
        x, y, turn = (self._released(f"{body.name}.reaction.{part}") for part in ("x", "y", "moment"))
        frame = body.frame
        return self.new_frame(frame.drawn, (frame.place[0] + x, frame.place[1] + y), frame.angle + turn)

    def _released(self, name):
        q, v, a = (self.table.variable(name + primes) for primes in ("", "'", "''"))
        self.coordinates.append(name)
        for nodes, node in ((self.q, q), (self.v, v), (self.a, a)):
            nodes.append(node)
        self.drawn[q] = self._drawn_at_rest[q] = self._drawn_at_rest[v] = self.table.zero
        self.speeds = self._speeds()
        return q

    def rename(self, independent):
        """Keep these coordinates as the independent ones."""
        kept = [self.q.index(q) for q in independent]
        self.coordinates = [self.coordinates[i] for i in kept]
        self.q, self.v, self.a = ([nodes[i] for i in kept] for nodes in (self.q, self.v, self.a))
        self.speeds = self._speeds()

    def define(self, name, node, velocity):
        """Let a dependent coordinate be `node`, wherever its name stands from now on."""
        self._symbols.update({(name, 0): node, (name, 1): velocity})
        del self._symbols[name, 2]
        for primes in (0, 1):
            raw = self.table.variable(name + "'" * primes)
            self._drawn_at_rest.pop(raw)
            self.drawn.pop(raw, None)
        if node.op == "symbol" and node in self.drawn:
            self._drawn_at_rest[node] = self.drawn[node]

    def rate(self, node):
        """dnode/dt = Σ (∂node/∂x) ẋ over coordinates, velocities and the time."""
        return self.table.sum(*((slope * self.speeds[x], ONE) for x, slope in gradient(node).items()
                                if x in self.speeds))

    @property
    def drawn_position(self):
        """{symbol: its value as drawn} of all coordinates and the time."""
        return {**self.drawn, self.time: self.table.zero}

    @property
    def drawn_coordinates(self):
        """{name: node as drawn} of the independent coordinates."""
        return {q.name: self.drawn[q] for q in self.q}

    def extent(self, values):
        """The size of the drawn figure in metres, {name: float} given; 0 where nothing has a place."""
        places = [body.drawn for body in self.bodies.values() if body.frame is not None]
        places += [self.pair(end) for record in (self.spec.get("springs") or {}).values()
                   for end in record.get("between", ()) if isinstance(end, list)]
        found = evaluate([node for place in places for node in place], Floats, values)
        if not found:
            return 0.0
        size = max(max(found[0::2]) - min(found[0::2]), max(found[1::2]) - min(found[1::2]))
        return size or max(map(abs, found))

    def unit_of(self, name):
        """A natural size of a coordinate: 1 of an angle, the extent of the figure of a length."""
        return (self.extent(self.sample) or 1.0) if self.spec.dimensions.of(name) else 1.0

    def _drawn_value(self, name):
        record = self.spec.coordinates[name]
        return self.lower(record["drawn"]) if "drawn" in record else self.table.zero

    def at_drawn(self, *nodes):
        """The nodes in the drawn position, at rest."""
        return substitute(nodes, self._drawn_at_rest) if any(node.mask for node in nodes) else list(nodes)

    def change(self, expression):
        """How much an expression has changed since the drawn position."""
        node = self.lower(expression)
        change = node - self.at_drawn(node)[0]
        return self.driven_by(change) if change.mask == self.time.mask else change

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

    def vanishes(self, node):
        """Is an expression zero in all positions: by algebra, or term by term at the sample?"""
        if is_zero(node):
            return True
        try:
            terms = reduced(expanded(node))
        except (TooLong, ZeroDivisionError):
            return False
        groups = {}
        for monomial, value in terms.items():
            moving = tuple(pair for pair in monomial if pair[0].mask)
            fixed = self.table.product(*(pair for pair in monomial if not pair[0].mask))
            groups.setdefault(moving, []).append(self.table.scaled(fixed, value))
        for parts in groups.values():
            sizes = evaluate(parts, Floats, self.sample)
            if not abs(sum(sizes)) <= 1e-12 * sum(map(abs, sizes)):
                return False
        return True

    def require_equal(self, a, b, where, message, hint=None, size=0.0):
        """Report `message` with both values where they differ in the drawn position by more than `size`."""
        if not self.agree(*self.at_drawn(a, b)) and not abs(self.number(a) - self.number(b)) <= size:
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


def sample_values(names, attempt):
    """Values for symbols without one: positive, unrelated, and others at each attempt."""
    return {name: 0.6 + 1.7 * ((Fraction(7919 * (i + 1) + 104729 * attempt, 10007) * (attempt + 3)) % 1)
            for i, name in enumerate(names)}


