"""A scene with its inputs as further coordinates u: displacements that drive it, and unit loads.

Linearised like any other, its matrices hold beside those of the coordinates q the columns of the inputs:

    M q̈ + C q̇ + K q = −(M_u ü + C_u u̇ + K_u u) + excitation,        y = y₀ + y_q δ + y_v δ̇ + y_a δ̈ + the same of u.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.autonomous import INSTANTS, SAME, matrices_at
from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction
from vibcli.mechanics.linearise import without_time
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.symbolic.node import Node


class SystemWithInputs:
    """scene; n: how many of its coordinates are none of its inputs, which stand last; timed, form: its Linearisation
    with and without excitation; varies: may its matrices depend on the time? kind: of arrays of its numbers."""

    def __init__(self, configuration: "Configuration", releasing: bool = False) -> None:
        self.configuration, self.arithmetic = configuration, configuration.arithmetic
        self.kind = float if self.arithmetic is Floats else object
        system = configuration.system
        opened = system.released_with_inputs if releasing else system.with_inputs
        self.scene, self.timed, self.form, self.varies = opened
        self.n = len(self.scene.q) - len(self.scene.inputs)

    @cached_property
    def values(self) -> "dict[str, float | mpmath.mpf]":
        """{name: float} of every symbol in equilibrium."""
        known = self.configuration
        return {**self.at_zero, **known.dependent_values, **known.at_rest}

    @property
    def at_zero(self) -> dict[str, float]:
        """{name: 0} of every coordinate, input, velocity and acceleration."""
        return {node.name: 0.0 for nodes in (self.scene.q, self.scene.v, self.scene.a) for node in nodes}

    @cached_property
    def sample(self) -> "dict[str, float | mpmath.mpf]":
        """The same as drawn where the scene has letters, with sample values for them."""
        symbolic = self.configuration.numeric.has_free_symbols
        return {**self.at_zero, **self.scene.drawn_values} if symbolic else self.values

    @property
    def place(self) -> "dict[Node, Node]":
        """{coordinate: its number in equilibrium as a node}, rates and inputs zero."""
        values, scene = self.values, self.scene
        symbols = [*scene.drawn, *scene.v, *scene.a]
        return {symbol: scene.table.number(fraction_of(values[symbol.name])) for symbol in symbols}

    @cached_property
    def numbers(self) -> "Numbers":
        """The Numbers of the Linearisation in equilibrium."""
        return in_numbers(self.form, self.arithmetic, self.values)

    @cached_property
    def elements(self) -> "FactoredSystem":
        """The element data of these, with `damping:` that stands beside what couples the modes of members."""
        carried = [j for j, opening in enumerate(self.scene.inputs.values(), self.n) if opening.node is not None]
        return self.configuration.damped_as_a_whole(self.numbers.elements, [*range(self.n), *carried])

    @cached_property
    def turning(self) -> set[int]:
        """The numbers of the coordinates and inputs whose columns are others at other instants."""
        if not self.scene.timed or not self.varies:
            return set()
        wanted, columns = matrices_at(self.form, self.values), set()
        for instant in INSTANTS:
            found = matrices_at(self.timed, {**self.values, self.scene.time.name: instant})
            for key in "MCGK":
                columns |= self._others(wanted[key], found[key], found["size"] if key == "K" else {})
        return columns

    def _others(self, one: Mapping[tuple[int, int], float], two: Mapping[tuple[int, int], float],
                size: Mapping[tuple[int, int], float]) -> set[int]:
        """The columns in which two matrices differ."""
        largest = max(map(abs, (*one.values(), *two.values())), default=0.0)
        return {pair[1] for pair in {*one, *two} if pair[0] < self.n
                and not abs(one.get(pair, 0.0) - two.get(pair, 0.0)) <= SAME * max(
                    abs(two.get(pair, 0.0)), size.get(pair, 0.0), 1e-6 * largest)}

    def require_steady(self, weights: "Mapping[int, complex | Node]") -> None:
        """PhysicsError where what these inputs {number: weight} do depends on the time."""
        if self.turning & {*range(self.n), *(j for j, weight in weights.items() if weight)}:
            raise self._turns()

    def _turns(self) -> PhysicsError:
        return PhysicsError("what acts here turns with what is driven: it has no constant coefficients",
                            "ask for a response to a coordinate, as in frf[…, "
                            f"{self.configuration.scene.coordinates[0]}]")

    def carried(self, weights: Any) -> dict[int, float]:
        """{i: number} of b₀ of loads that turn with what is driven, `weights` {number of an input: node of the time}:
        the product of the two is what must not depend on it."""
        self.require_steady({})
        found, values = [], {**self.values}
        for instant in (0.0, *INSTANTS):
            values[self.scene.time.name] = instant
            shares = dict(zip(weights, evaluate(list(weights.values()), Floats, values), strict=True))
            K = matrices_at(self.timed, values)["K"]
            found.append({(i, 0): -sum(w * K.get((i, j), 0.0) for j, w in shares.items()) for i in range(self.n)})
        if any(self._others(found[0], later, {}) for later in found[1:]):
            raise self._turns()
        return {i: x for (i, _), x in found[0].items() if x}

    @cached_property
    def columns(self) -> dict[int, list[dict[int, float]]]:
        """{number of an input: [{i: number}] of b₀, b₁, b₂}, the residual moved to the right side."""
        M, C, G, K = self.elements.matrices()
        found = {j: [{}, {}, {}] for j in range(self.n, len(self.scene.q))}
        for power, matrices in enumerate(((K,), (C, G), (M,))):
            for matrix in matrices:
                for (i, j), x in matrix.items():
                    if i < self.n <= j and x:
                        column = found[j][power]
                        column[i] = column.get(i, 0.0) - x
        if self.configuration.spec.get("damping") is not None and not self.scene.pieces:
            for (i, j), x in self.damping.items():
                found[j][1][i] = found[j][1].get(i, 0.0) - x
        return found

    @cached_property
    def damping(self) -> dict[tuple[int, int], float]:
        """C_u of what `damping:` does with displacements that drive the scene, {(i, j): number}."""
        from vibcli.mechanics.given_damping import columns_of

        M, _, _, K = self.numbers.elements.matrices()
        driven = [j for j, opening in enumerate(self.scene.inputs.values(), self.n) if opening.node is not None]
        return columns_of(self.configuration, M, K, self.n, driven)

    def rows(self, nodes: Any) -> list[LinearFunction]:
        """The LinearFunction of each node."""
        scene, kinds = self.scene, (self.scene.q, self.scene.v, self.scene.a)
        slopes = [[{i: slopes[x] for i, x in enumerate(kind) if x in slopes} for kind in kinds]
                  for slopes in map(gradient, nodes)]
        flat = [node for parts in slopes for part in parts for node in part.values()]
        known = dict(zip(flat, self._autonomous(flat), strict=True))
        found = []
        for node, parts in zip(nodes, slopes, strict=True):
            numbers = [{i: known[slope] for i, slope in part.items() if known[slope]} for part in parts]
            found.append(LinearFunction(*self._fixed(node), *numbers))
        if scene.timed:
            self._steady_constraints(nodes)
        return found

    def _autonomous(self, nodes: "list[Node]") -> "list[float | mpmath.mpf]":
        """The numbers of slopes, which must not depend on the time."""
        values, time = self.values, self.scene.time
        found = evaluate(nodes, self.arithmetic, values)
        if any(node.mask & time.mask for node in nodes):
            for instant in INSTANTS:
                later = evaluate(nodes, self.arithmetic, {**values, time.name: instant})
                if any(abs(x - y) > SAME * max(abs(x), abs(y), 1e-6) for x, y in zip(found, later, strict=True)):
                    raise PhysicsError("this signal turns with what is driven: it is no linear function of the "
                                       "coordinates", "ask for one that is counted in the carrier")
        return found

    def _fixed(self, node: "Node") -> "tuple[float | mpmath.mpf, list[tuple[float, Node]]]":
        """(value in equilibrium, [(1.0, what depends on the time there)])."""
        scene = self.scene
        if not node.mask & scene.time.mask:
            return evaluate([node], self.arithmetic, self.values)[0], []
        at = substitute([node], self.place)[0]
        steadily = without_time(scene, at)
        return evaluate([steadily], self.arithmetic, self.values)[0], [] if at is steadily else [(1.0, at - steadily)]

    def _steady_constraints(self, nodes: "list[Node]") -> None:
        closed = set(self.scene.dependent.values())
        for part in reachable(nodes):
            if part.op == "symbol" and part in closed and self.scene.time in gradient(part):
                raise PhysicsError(f"'{part.name}' is driven through a loop that closes at every instant",
                                   "drive a point or a body instead of the constraint")
