"""The terms that the elements of a scene add: inertias, springs, dampers, weights, energies, matrices."""

from vibcli.scene.bounded_motion import stays_bounded
from vibcli.scene.constraints import Constraint
from vibcli.scene.energy_terms import AppliedLoad, Damper, Inertia, Spring, Weight
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.rationals import ONE

SHAKEN = ("inertias", "springs", "dampers", "weights", "forces", "laws")  # kept as functions of driven displacements
CONNECTIONS = ("springs", "dampers", "laws")


class Terms:
    """The part of a Scene that collects what its elements contribute."""

    def start_terms(self):
        self.inertias, self.springs, self.dampers, self.weights, self.forces = [], [], [], [], []
        self.energies = {"T": self.table.zero, "V": self.table.zero, "Phi": self.table.zero}
        self.matrices = {}
        self.static_preloads, self.laws = [], []
        self.owner, self.shaken = None, {}

    def add_inertia(self, weight, s):
        """½·weight·ṡ² to T; nothing where s does not move or the weight is zero."""
        if s.mask and not weight.is_zero:
            self.inertias.append(Inertia(weight, s, owner=self.owner))

    def add_weight(self, mass, x, y):
        """−mass·(gₓ x + g_y y) to V."""
        if self.gravity is not None:
            for g, s in zip(self.gravity, (x, y), strict=True):
                if s.mask and not g.is_zero:
                    self.weights.append(Weight(-mass * g, s, owner=self.owner))

    def add_spring(self, k, preload, s):
        """preload·s + ½·k·s² to V."""
        self.springs.append(Spring(k, s, preload, self.owner))

    def add_damper(self, c, s):
        """½·c·ṡ² to Φ."""
        self.dampers.append(Damper(c, s, owner=self.owner))

    def add_force(self, steady, in_time, s):
        """The virtual work δA = force·δs of a load in two parts, which depend on coordinates and velocities as they
        like."""
        if (s.mask or self.opened) and not (steady.is_zero and in_time.is_zero):
            self.forces.append(AppliedLoad(steady + in_time, s, None if in_time.is_zero else steady, self.owner))

    def terms_of(self, name, *kinds, undriven=False):
        """The springs, dampers and laws of an element, or those of the given kinds; `undriven`: as functions of the
        symbols of driven displacements."""
        return [term for kind in kinds or CONNECTIONS
                for term in (self.undriven(kind) if undriven else getattr(self, kind)) if term.owner == name]

    def force_of(self, name):
        """The force of a spring or damper, of a spring without free length its magnitude; None of another element."""
        forces = [term.force(self) for term in self.terms_of(name)]
        if len(forces) > 1:
            return self.table.sqrt(self.table.sum(*((force * force, ONE) for force in forces)))
        return forces[0] if forces else None

    def add_constraint(self, record, node, form, part=""):
        """The condition node = 0."""
        self.constraints.append(Constraint(record.name + part, node, record.where, form))

    def replace(self, values):
        """Every expression of the scene with symbols replaced, {symbol: node}."""
        groups = [self.__dict__] * 5 + [self.shaken] * len(self.shaken)
        kinds = ("inertias", "springs", "dampers", "weights", "forces", *self.shaken)
        lists = list(zip(groups, kinds, strict=True))
        terms = [term for group, kind in lists for term in group[kind]]
        frames = {id(body.frame): body.frame for body in self.bodies.values() if body.frame is not None}.values()
        lumps = [body for body in self.bodies.values() if body.lumped is not None]
        nodes = [node for term in terms for node in term.nodes]
        nodes += [node for frame in frames for node in (*frame.place, frame.angle)]
        nodes += [body.lumped[1] for body in lumps] + list(self.energies.values())
        nodes += [constraint.node for constraint in self.constraints] + [law.s for law in self.laws]
        touching = [body for body in self.bodies.values() if body.normal is not None]
        nodes += [node for body in touching for node in body.normal]
        nodes += [node for _, place in self.points.values() for node in place]
        new = dict(zip(nodes, self.unrooted(substitute(nodes, values)), strict=True))
        for group, kind in lists:
            group[kind] = [term.over(new) for term in group[kind]]
        for frame in frames:
            frame.place, frame.angle = tuple(new[node] for node in frame.place), new[frame.angle]
        for body in lumps:
            body.lumped = body.lumped[0], new[body.lumped[1]]
        for body in touching:
            body.normal = tuple(new[node] for node in body.normal)
        self.points = {name: (drawn, tuple(new[node] for node in place)) for name, (drawn, place)
                       in self.points.items()}
        self.energies = {key: new[node] for key, node in self.energies.items()}
        self.laws = [law.over(new) for law in self.laws]
        self.constraints = [constraint._replace(node=new[constraint.node]) for constraint in self.constraints]

    def put(self, values):
        """The same throughout the scene and the scene at rest."""
        for scene in (self,) if self.resting is self else (self, self.resting):
            scene.replace(values)

    def loads_at_still(self):
        """The loads, the steady ones with the driven displacements that oscillate left out; beside each of them what of
        it is a load in time, as it is."""
        if not any(map(self.oscillates, self.driven)):
            return self.forces
        found, zero = [], self.table.zero
        for still, term in zip(self.at_still("forces"), self.forces, strict=True):
            if term.offset is None:
                found.append(still)
                continue
            if not still.offset.is_zero:
                found.append(still._replace(weight=still.offset, offset=None))
            found.append(term._replace(weight=term.weight - term.offset, offset=zero))
        return found

    @property
    def vibrating(self):
        """The scene whose small oscillations are those of this one: itself; but the one at rest where constraints tie
        its coordinates to what is driven to and fro."""
        tied = self.resting is not self and any(node.mask & self.time.mask for node in self.dependent.values())
        return self.resting if tied else self

    def keep_shaken(self):
        """Keep the terms and the laws as functions of the symbols of driven displacements."""
        return {kind: list(getattr(self, kind)) for kind in SHAKEN}

    def undriven(self, kind):
        """Terms, or laws, as functions of the symbols of driven displacements, which are zero as drawn."""
        return self.shaken[kind] if self.shaken else getattr(self, kind)

    def at_still(self, kind):
        """The springs, dampers, inertias or loads with the driven displacements that oscillate left out; those in
        `shaken` are functions of them."""
        if not self.shaken:
            return getattr(self, kind)
        held = dict.fromkeys(filter(self.oscillates, self.driven), self.table.zero)
        moved = {symbol: node for symbol, node in self.driven.items() if symbol not in held}
        found = []
        for term in self.shaken[kind]:
            new = dict(zip(term.nodes, substitute(term.nodes, {**held, **moved}), strict=True))
            found.append(term.over(new))
        return found

    def oscillates(self, symbol):
        """Does a driven displacement come and go, so that it counts as a small one?"""
        return self.waves(self.driven[symbol])

    def waves(self, node):
        """Does a function of the time stay bounded?"""
        return stays_bounded(node, self.time, self.sample)

    def open_loads(self):
        """A load as an input beside each that is given, and one along each coordinate."""
        for k, term in enumerate(list(self.forces)):
            self._open(term.owner, term.s, k)
        for name in self.spec.coordinates:
            self._open(name, self.symbol(name), None)

    def _open(self, name, s, load):
        symbol = self.add_input(name)
        self.inputs[symbol] = self.inputs[symbol]._replace(load=load)
        self.forces.append(AppliedLoad(symbol, s, owner=name))

    def depends_on_time(self):
        """Does anything in the scene depend on the time explicitly?"""
        terms = (*self.inertias, *self.springs, *self.dampers, *self.weights, *self.forces)
        nodes = [node for term in terms for node in term.nodes] + list(self.energies.values())
        return any(node.mask & self.time.mask for node in nodes)

    def static_preload(self, record):
        """The unknown tension that keeps the drawn position in equilibrium, as a symbol `name.preload`."""
        node = self.table.parameter(record.name + ".preload", positive=False)
        self.static_preloads.append((node, record))
        return node

    def add_energy(self, key, node):
        record = self.spec.get("energies")
        velocities = set(self.v)
        found = gradient(node)
        if key == "V" and velocities & set(found):
            self.report(record.place(key), "V depends on the coordinates alone, not on velocities")
        if set(self.a) & set(found):
            self.report(record.place(key), "energies do not depend on accelerations")
        moving = {"T": {*velocities, *self.q}, "Phi": velocities}
        if key in moving and not moving[key] & set(found):
            self.report(record.place(key), f"{key} must depend on a velocity such as {self.coordinates[0]}'"
                        if self.coordinates else f"{key} must depend on a velocity")
        self.energies[key] = self.energies[key] + node

    def add_matrix(self, key, nodes):
        self.matrices[key] = nodes
