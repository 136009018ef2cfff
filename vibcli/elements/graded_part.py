"""A beam under a tension that varies along it, or a part of one, at rest, by power series about its middle.

B u⁗ − ((N + n x) u′)′ + k u = q₀ + q₁ x, x from the middle. With η = x/a, ν = N a²/B, γ = n a³/B, χ = k a⁴/B

    u = Σ c_k ηᵏ,   (k+4)(k+3)(k+2)(k+1) c_{k+4} = ν (k+2)(k+1) c_{k+2} + γ (k+1)² c_{k+1} − χ c_k + [load]

of which c₀ … c₃ are free. Ends are told by r = ((u_l + u₀)/2, (u_l − u₀)/2, a (θ_l − θ₀)/2, a (θ_l + θ₀)/2). a is 1/π
of half the length, so that −π ≤ η ≤ π: no factor is then rational, and products of sums stay as they are.
"""

from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

TINY = 2.0**-180        # of its first: the last terms of the series


class GradedPart(NamedTuple):
    """The series of c₀ … c₃ and of q₀, lists of coefficients; c₀ … c₃ by r, lists by rows; r of q₀; a; B.

    stiffness: by the end values (u₀, θ₀, u_l, θ_l), symmetric, the forces on the ends; even, slanted: what loads 1 and
    x put on the ends, in place of them.
    """

    scene: "Builder | Scene"
    series: "list[list[Node]]"
    by_ends: "list[list[Node]]"
    own: "list[Node]"
    unit: "Node"
    bending: "Node"
    stiffness: "list[list[Node]]"
    even: "list[Node]"
    slanted: "list[Node]"

    def derivative(self, order: int, eta: "Node", ends: "list[Node]", load: "Node") -> "Node":
        """∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at η between ends that move, under an even load."""
        scaled = load * self.unit**4 / self.bending
        free = self.free(ends, scaled)
        parts = [self._at(self.series[j], order, eta) * c for j, c in enumerate([*free, scaled])]
        return self.scene.table.total(parts) / self.unit**order

    def free(self, ends: "list[Node]", scaled: "Node | None" = None) -> "list[Node]":
        """c₀ … c₃ between ends that move, under an even load, q a⁴/B."""
        u0, t0, ul, tl = ends
        r = [(ul + u0) / 2, (ul - u0) / 2, (tl - t0) * self.unit / 2, (tl + t0) * self.unit / 2]
        if scaled is not None:
            r = [one - scaled * own for one, own in zip(r, self.own, strict=True)]
        return [self.scene.table.total([row[i] * r[i] for i in range(4)]) for row in self.by_ends]

    def named(self, owner: str) -> "GradedPart":
        """With symbols for the coefficients of its series, so that sums of them stay short."""
        define = self.scene.table.defined
        return self._replace(series=[[define(f"{owner}.c{j}{k}", c) for k, c in enumerate(one)]
                                     for j, one in enumerate(self.series)])

    def basis(self, eta: "Node") -> "list[Node]":
        """The series of c₀ … c₃ at η."""
        return [self._at(series, 0, eta) for series in self.series[:4]]

    def _at(self, series: "list[Node]", order: int, eta: "Node") -> "Node":
        found = self.scene.table.zero
        for k in range(len(series) - 1, order - 1, -1):
            found = found * eta + _falling(k, order) * series[k]
        return found


def _apart(values: "list[Node]") -> "list[Node]":
    """By (u₀, a θ₀, u_l, a θ_l) what acts by r."""
    a, b, c, d = values
    return [(a - b) / 2, (d - c) / 2, (a + b) / 2, (d + c) / 2]


def _falling(k: int, order: int) -> int:
    """k (k − 1) … of `order` factors."""
    found = 1
    for i in range(order):
        found *= k - i
    return found


def _ends_of(table: "Table", series: "list[Node]") -> "list[list[Node]]":
    """The even and odd parts at η = π of u, u′, u″, u‴ by η, [[even, odd], …]."""
    at_end = [c * table.pi**k for k, c in enumerate(series)]
    return [[table.sum(*((at_end[k], _falling(k, order)) for k in range(order, len(series))
                         if (k - order) % 2 == odd)) / table.pi**order for odd in (0, 1)] for order in range(4)]


def _motion(parts: "list[list[Node]]") -> "list[Node]":
    """The r of a series."""
    u, slope, *_ = parts
    return [u[0], u[1], slope[1], slope[0]]


def graded_part(scene: "Builder | Scene", half: "Node", bending: "Node", tension: "Node", gradient: "Node",
                foundation: "Node") -> GradedPart:
    """The GradedPart of half the length, with N at its middle."""
    table, unit = scene.table, half / scene.table.pi
    measures = tension * unit**2 / bending, gradient * unit**3 / bending, foundation * unit**4 / bending
    count = _terms(*(abs(scene.number(node)) * pi**k for node, k in zip(measures, (2, 3, 4), strict=True)))
    series = [_series(table, measures, count, j) for j in range(5 if foundation.is_zero else 6)]
    ends = [_ends_of(table, one) for one in series]
    motions, forces = [_motion(one) for one in ends], [_forces(table, measures, one) for one in ends]
    inverse = _inverse(table, [list(row) for row in zip(*motions[:4], strict=True)])
    d = [[table.total([force[i] * row[j] for force, row in zip(forces, inverse, strict=False)]) for j in range(4)]
         for i in range(4)]
    even, slanted = ([_held(table, d, motions[which], forces[which], i) for i in range(4)] if which < len(series) else
                     [table.zero] * 4 for which in (4, 5))
    sizes = [table.one, unit, table.one, unit]
    even, slanted = ([part * size * unit**power for part, size in zip(_apart(loads), sizes, strict=True)]
                     for loads, power in ((even, 1), (slanted, 2)))
    d = _by_end_values(d, bending / unit**3, sizes)
    return GradedPart(scene, series[:5], inverse, motions[4], unit, bending, d, even, slanted)


def _forces(table: "Table", measures: "tuple[Node, Node, Node]", parts: "list[list[Node]]") -> "list[Node]":
    """Those conjugate to r of a series, times a³/B."""
    (nu, gamma, _), (_, first, second, third) = measures, parts
    return [2 * (nu * first[1] + gamma * table.pi * first[0] - third[1]),
            2 * (nu * first[0] + gamma * table.pi * first[1] - third[0]), 2 * second[0], 2 * second[1]]


def _held(table: "Table", d: "list[list[Node]]", motion: "list[Node]", force: "list[Node]", i: int) -> "Node":
    """What a load puts on ends, in place of it: that on ends which are held, the other way round."""
    return table.total([-force[i], *(entry * r for entry, r in zip(d[i], motion, strict=True))])


def _by_end_values(d: "list[list[Node]]", scale: "Node", sizes: "list[Node]") -> "list[list[Node]]":
    """A matrix by r as one by the end values; of its two halves, equal but for rounding, that above the diagonal."""
    columns = [_apart(list(column)) for column in zip(*map(_apart, d), strict=True)]
    return [[columns[max(i, j)][min(i, j)] * scale * sizes[i] * sizes[j] for j in range(4)] for i in range(4)]


def _terms(nu: float, gamma: float, chi: float) -> int:
    """How many terms of the series count."""
    sizes = [1.0, 1.0, 1.0, 1.0]
    while max(sizes[-4:]) > TINY:
        k = len(sizes) - 4
        found = nu * (k + 2) * (k + 1) * sizes[k + 2] + gamma * (k + 1) ** 2 * sizes[k + 1] + chi * sizes[k]
        sizes.append(found / ((k + 4) * (k + 3) * (k + 2) * (k + 1)))
    return len(sizes)


def _series(table: "Table", measures: "tuple[Node, Node, Node]", count: int, j: int) -> "list[Node]":
    """That of c_j, or under the load η^(j − 4)."""
    nu, gamma, chi = measures
    c = [table.one if i == j else table.zero for i in range(4)]
    for k in range(count - 4):
        below = (k + 4) * (k + 3) * (k + 2) * (k + 1)
        parts = ((nu * c[k + 2], (k + 2) * (k + 1)), (gamma * c[k + 1], (k + 1) ** 2), (chi * c[k], -1),
                 (table.one, int(k == j - 4)))
        c.append(table.sum(*((node, Fraction(factor, below)) for node, factor in parts)))
    return c


def _inverse(table: "Table", rows: "list[list[Node]]") -> "list[list[Node]]":
    """By elimination in the order of c₀ … c₃: no pivot vanishes but where the part buckles between ends held."""
    n = len(rows)
    work = [[*row, *(table.one if i == j else table.zero for j in range(n))] for i, row in enumerate(rows)]
    for i in range(n):
        work[i] = [entry / work[i][i] for entry in work[i]]
        for j in range(n):
            if j != i and not work[j][i].is_zero:
                work[j] = [entry - work[j][i] * other for entry, other in zip(work[j], work[i], strict=True)]
    return [row[n:] for row in work]
