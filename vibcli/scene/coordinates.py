"""The coordinates of a scene: symbols, rates, drawn values; what depends on others, is driven or released."""

from typing import NamedTuple

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import ONE


class Opening(NamedTuple):
    """An input of an opened scene: whose it is, what drives it (None of a load), and of which term of the loads it
    stands beside (None of a displacement, or along a coordinate)."""

    name: str
    node: object = None
    load: int = None


class SceneCoordinates:
    """The part of a Scene that knows its coordinates."""

    def _speeds(self):
        """{x: dx/dt} of coordinates, velocities and the time."""
        return dict(zip((*self.q, *self.v, self.time), (*self.v, *self.a, self.table.one), strict=True))

    def _symbol(self, name, primes, tree):
        if name in self.parameters.in_letters:
            return self.parameters.in_letters[name]
        return self.parameters.nodes[name] if name in self.parameters.nodes else self.symbol(name, primes)

    def symbol(self, name, primes=0):
        """The node of a coordinate, its velocity or acceleration; of a dependent one, what it equals."""
        if primes and (name, primes) not in self._symbols:
            self._symbols[name, primes] = self.rate(self.symbol(name, primes - 1))
        return self._symbols[name, primes]

    def driven_by(self, node, name, drive=None):
        """A displacement of what has this name: where it depends on the time, a symbol that is zero as drawn and stands
        for it until the scene is assembled; of an opened scene an input. Where supports give way its `drive` does."""
        if not node.mask & self.time.mask:
            return node
        slip = self._released(drive) if self.releasing and drive else self.table.zero
        if self.opened and self.waves(node):
            return self.add_input(name, node) + slip
        symbol = self.table.dependent(f"driven {len(self.driven)}", node.mask)
        self.driven[symbol], self._drawn_at_rest[symbol] = node, self.table.zero
        return symbol + slip

    def turns(self, body):
        """Does a body turn, other than by its support giving way?"""
        angle, = substitute([body.frame.angle], dict.fromkeys(self.released, self.table.zero))
        return bool(angle.mask)

    def release(self, body):
        """Let the support of a body give way: by x and y in the fixed axes, and by a rotation."""
        x, y, turn = (self._released(f"{body.name}.reaction.{part}") for part in ("x", "y", "moment"))
        frame = body.frame
        return self.new_frame(frame.drawn, (frame.place[0] + x, frame.place[1] + y), frame.angle + turn)

    @property
    def supports(self):
        """The coordinates by which supports give way, drives apart."""
        return [q for q in self.released if ".reaction." in q.name]

    def _released(self, name):
        self.released.append(self._further(name))
        return self.released[-1]

    def add_input(self, name, node=None):
        """An input as a further coordinate: a displacement that is driven by `node`, or a load beside a given one."""
        symbol = self._further(f"input {len(self.inputs) + 1}")
        self.inputs[symbol] = Opening(name, node)
        return symbol

    def _further(self, name):
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

    def define(self, name, node):
        """Let a dependent coordinate be `node`, wherever its name stands from now on."""
        self._symbols[name, 0] = node
        for primes in (1, 2):
            del self._symbols[name, primes]
        for primes in (0, 1):
            raw = self.table.variable(name + "'" * primes)
            self._drawn_at_rest.pop(raw)
            self.drawn.pop(raw, None)
        if node.op == "symbol" and node in self.drawn:
            self._drawn_at_rest[node] = self.drawn[node]

    def rate(self, node):
        """dnode/dt = Σ (∂node/∂x) ẋ over coordinates, velocities and the time."""
        found = self.table.sum(*((slope * self.speeds[x], ONE) for x, slope in gradient(node).items()
                                 if x in self.speeds))
        if "impulse" in self.table.called and found.mask & self.time.mask:
            from vibcli.symbolic.delta_functions import at_impulses

            return at_impulses(found, self.time)
        return found

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
        places = [body.centre for body in self.bodies.values() if body.frame is not None]
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

    def change(self, expression, part=""):
        """A displacement from the drawn position: how much the terms that hold coordinates have changed since then, and
        what is prescribed in time, which counts as it stands, constants included. `part`: .x, .y or .moment of a body
        that has several."""
        node, drive = self.lower(expression), f"{self.owner}.drive{part}"
        if node.mask == self.time.mask:
            return self.driven_by(node, self.owner, drive)
        drawn, = self.at_drawn(node)
        held = self.terms_with(node, ~self.time.mask) if node.mask & self.time.mask else node
        driven = textbook(node - held)
        if not driven.mask:
            return node - drawn
        at_start, = self.at_drawn(held)
        if drawn.is_zero:
            driven = driven + at_start
        return held - at_start + self.driven_by(driven, self.owner, drive)
