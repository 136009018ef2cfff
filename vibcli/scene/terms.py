"""The terms that the elements of a scene add: inertias, springs, dampers, weights, energies, matrices."""

from typing import NamedTuple

from vibcli.algebra.calculus import gradient


class Term(NamedTuple):
    """One scalar function s of the coordinates with its weight; `force` is the tension at s = 0 of a spring, `owner`
    the name of the element that it came from."""

    weight: object
    s: object
    force: object = None
    owner: str = None


class Terms:
    """The part of a Scene that collects what its elements contribute."""

    def start_terms(self):
        self.inertias, self.springs, self.dampers, self.weights = [], [], [], []
        self.energies = {"T": self.table.zero, "V": self.table.zero, "Phi": self.table.zero}
        self.matrices = {}
        self.static_preloads = []
        self.owner = None

    def add_inertia(self, weight, s):
        """½·weight·ṡ² to T; nothing where s does not move or the weight is zero."""
        if s.mask and not weight.is_zero:
            self.inertias.append(Term(weight, s, owner=self.owner))

    def add_weight(self, mass, x, y):
        """−mass·(gₓ x + g_y y) to V."""
        if self.gravity is not None:
            for g, s in zip(self.gravity, (x, y), strict=True):
                if s.mask and not g.is_zero:
                    self.weights.append(Term(-mass * g, s, owner=self.owner))

    def add_spring(self, k, preload, s):
        """preload·s + ½·k·s² to V."""
        self.springs.append(Term(k, s, preload, self.owner))

    def add_damper(self, c, s):
        """½·c·ṡ² to Φ."""
        self.dampers.append(Term(c, s, owner=self.owner))

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
        if key != "V" and not velocities & set(found):
            self.report(record.place(key), f"{key} must depend on a velocity such as {self.coordinates[0]}'"
                        if self.coordinates else f"{key} must depend on a velocity")
        self.energies[key] = self.energies[key] + node

    def add_matrix(self, key, nodes):
        self.matrices[key] = nodes
