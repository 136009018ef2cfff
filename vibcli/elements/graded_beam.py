"""Pieces of beams under a tension that varies along them, at rest: springs, mean displacement, deflection, exactly.

Cut into parts so short that their power series serve, joined at the cuts. Stiffness counts by θ_l − θ₀, (θ_l + θ₀)/2 −
(u_l − u₀)/l, (u_l − u₀)/l and (u₀ + u_l)/2: what a piece needs to turn or shift alone is known, for u = x the load
k x − n and the forces −N₀, N_l, for u = 1 the load k, so that small tensions are told beside large stiffnesses.
"""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.graded_part import GradedPart, graded_part

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import TypeVar

    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    Joined = tuple[list[list[Node]], list[Node], list[Node]]
    T = TypeVar("T")

MEASURE = 5.0           # ν + γ + 2√χ of a part at most
PRESSED = 9.0           # the same where it is pressed all along: what waves loses no digits


class GradedBeam(NamedTuple):
    """A piece: its parts, from left to right, and d and the loads 1 and x on the ends of what stands left of each cut;
    x counts from the middle of the piece."""

    scene: "Builder | Scene"
    length: "Node"
    tension: "Node"
    gradient: "Node"
    foundation: "Node"
    parts: list[GradedPart]
    joined: "list[Joined]"

    def springs(self, owner: str, ends: "list[Node]") -> "list[tuple[Node, Node]]":
        """[(stiffness, stretch)]: Σ ½ k s² is what it stores, by elimination from the largest on."""
        u0, t0, ul, tl = ends
        turned = (ul - u0) / self.length
        s = [tl - t0, (tl + t0) / 2 - turned, turned, (u0 + ul) / 2]
        k = self._by_shape()
        chosen, found, define = list(range(len(k))), [], self.scene.table.defined
        while chosen:
            i = max(chosen, key=lambda i: abs(self.scene.number(k[i][i])) * (1.0 if i < 2 else 1e-30))
            chosen.remove(i)
            share = {j: define(f"{owner}.c{i + 1}{j + 1}", k[i][j] / k[i][i]) for j in chosen if not k[i][j].is_zero}
            stretch = self.scene.table.total([s[i], *(part * s[j] for j, part in share.items())])
            found.append((define(f"{owner}.k{i + 1}", k[i][i]), stretch))
            for a in share:
                for b in share:
                    k[a][b] = k[a][b] - share[a] * k[i][b]
        return found

    def mean(self, owner: str, ends: "list[Node]") -> "Node":
        """∫ u dx/l without loads of its own, by which loads spread evenly act."""
        _, loads, _ = self.joined[-1]
        shares = [self.scene.table.defined(f"{owner}.m{i}", a / self.length) for i, a in enumerate(loads, 1)]
        return self.scene.table.total([a * b for a, b in zip(shares, ends, strict=True)])

    def derivative(self, order: int, at: "Node", ends: "list[Node]", load: "Node") -> "Node":
        """∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at a distance from its left end, between ends that move, under an even load."""
        part = self.length / len(self.parts)
        number = min(int(self.scene.number(at) / self.scene.number(part)), len(self.parts) - 1)
        cuts = self._cuts(ends, load)
        eta = (2 * at - (2 * number + 1) * part) / part * self.scene.table.pi
        return self.parts[number].derivative(order, eta, [*cuts[number], *cuts[number + 1]], load)

    def shares(self, order: int, at: "Node", owner: str) -> "list[Node]":
        """That of end values of 1 each, and of a load of 1."""
        table = self.scene.table
        unit = [[table.one if i == j else table.zero for i in range(5)] for j in range(5)]
        return [table.defined(f"{owner}.u{j}", self.derivative(order, at, row[:4], row[4]))
                for j, row in enumerate(unit, 1)]

    def shapes(self, places: "Sequence[Node]", owner: str) -> "list[list[Node]]":
        """[u that end values of 1 each leave] at places."""
        table, number = self.scene.table, self.scene.number
        one, zero = table.one, table.zero
        cuts = [self._cuts([one if i == j else zero for i in range(4)], zero) for j in range(4)]
        part, free, parts, found = self.length / len(self.parts), {}, {}, []
        for i, place in enumerate(places):
            k = min(int(number(place) / number(part)), len(self.parts) - 1)
            if k not in free:
                parts[k] = self.parts[k].named(f"{owner}.{k}")
                free[k] = [[table.defined(f"{owner}.{k}{a}{b}", c) for b, c in enumerate(
                    self.parts[k].free([*cut[k], *cut[k + 1]]))] for a, cut in enumerate(cuts)]
            eta = table.defined(f"{owner}.eta{i}", (2 * place - (2 * k + 1) * part) / part * table.pi)
            basis = [table.defined(f"{owner}.s{i}{j}", one) for j, one in enumerate(parts[k].basis(eta))]
            found.append([table.defined(f"{owner}.u{i}{j}", table.total([a * b for a, b in zip(
                basis, row, strict=True)])) for j, row in enumerate(free[k])])
        return found

    def _cuts(self, ends: "list[Node]", load: "Node") -> "list[list[Node]]":
        """(u, θ) at all cuts, ends included."""
        found = [ends[2:]]
        for number in range(len(self.parts) - 1, 0, -1):
            left, part = self.joined[number - 1], self.parts[number]
            outer = [*ends[:2], *found[0]]
            found.insert(0, _between(left, (part.stiffness, part.even), outer, load))
        return [ends[:2], *found]

    def _by_shape(self) -> "list[list[Node]]":
        """The stiffness by v, w, (u_l − u₀)/l and, on a foundation, (u₀ + u_l)/2."""
        d, even, slanted = self.joined[-1]
        n, k, zero = self.gradient, self.foundation, self.scene.table.zero
        turning = [-self.tension, zero, self.tension + n * self.length, zero]
        turning = [a - n * b + k * c for a, b, c in zip(turning, even, slanted, strict=True)]
        bent = [(d[3][3] - 2 * d[1][3] + d[1][1]) / 4, (d[3][3] - d[1][1]) / 2, d[3][3] + 2 * d[1][3] + d[1][1]]
        turned = [(turning[3] - turning[1]) / 2, turning[3] + turning[1],
                  turning[3] + turning[1] + self.length / 2 * (turning[2] - turning[0])]
        found = [[bent[0], bent[1], turned[0]], [bent[1], bent[2], turned[1]], turned]
        if k.is_zero:
            return found
        shifted = [k * (even[3] - even[1]) / 2, k * (even[3] + even[1]),
                   k * (even[3] + even[1] + self.length / 2 * (even[2] - even[0])), k * (even[0] + even[2])]
        return [[*row, entry] for row, entry in zip(found, shifted, strict=False)] + [shifted]


def graded_mean(scene: "Builder | Scene", owner: str, numbers: "Sequence[Node]", ends: "list[Node]") -> "Node":
    """∫ u dx/l of a piece given by its length, B, N, N′ and k."""
    return plainly(scene, lambda: graded_beam(scene, *numbers).mean(owner, ends))


def graded_shapes(scene: "Builder | Scene", owner: str, numbers: "Sequence[Node]",
                  places: "Sequence[Node]") -> "list[list[Node]]":
    """u at places that end values of 1 each leave, [[u₀, θ₀, u_l, θ_l] of each place]."""
    return plainly(scene, lambda: graded_beam(scene, *numbers).shapes(places, owner))


def graded_stiffness(scene: "Builder | Scene", numbers: "Sequence[Node]") -> "list[list[Node]]":
    """By the end values (u₀, θ₀, u_l, θ_l)."""
    return plainly(scene, lambda: graded_beam(scene, *numbers).joined[-1][0])


def plainly(scene: "Builder | Scene", find: "Callable[[], T]") -> "T":
    """Without asking for signs: nothing in the long numbers of a piece has to cancel."""
    sample = scene.table.sample
    scene.table.resample(None)
    found = find()
    scene.table.resample(sample)
    return found


def graded_beam(scene: "Builder | Scene", length: "Node", bending: "Node", tension: "Node", gradient: "Node",
                foundation: "Node") -> GradedBeam:
    """The piece with the tension N at its left end, N′ = n."""
    count = _count(*map(scene.number, (length, bending, tension, gradient, foundation)))
    half = length / (2 * count)
    parts = [graded_part(scene, half, bending, tension + gradient * half * (2 * i + 1), gradient, foundation)
             for i in range(count)]
    joined = []
    for i, part in enumerate(parts):
        one = _of_part(part, half * (2 * i + 1 - count))
        joined.append(_join(scene, joined[-1], one) if joined else one)
    return GradedBeam(scene, length, tension, gradient, foundation, parts, joined)


def _count(length: float, bending: float, tension: float, gradient: float, foundation: float) -> int:
    """Into how many parts it is cut."""
    first, last, leaning = tension, tension + gradient * length, abs(gradient) * length
    need = max(abs(first), abs(last)) + leaning / 2 + 2 * abs(foundation * bending) ** 0.5
    most = PRESSED if max(first, last) <= 0 and not foundation else MEASURE
    return max(1, int(length / 2 * (need / bending / most) ** 0.5) + 1)


def _of_part(part: GradedPart, middle: "Node") -> "Joined":
    """(d, loads 1 and x) of a part whose middle is there."""
    return part.stiffness, part.even, [a + middle * b for a, b in zip(part.slanted, part.even, strict=True)]


def _join(scene: "Builder | Scene", left: "Joined", right: "Joined") -> "Joined":
    """Two of them as one, what is between them moving freely."""
    flexible = _flexibility(left, right)
    zero = scene.table.zero
    d = [[*row[:2], zero, zero] for row in left[0][:2]] + [[zero, zero, *row[2:]] for row in right[0][2:]]
    across = [*([left[0][i][2], left[0][i][3]] for i in (0, 1)), *([right[0][i][0], right[0][i][1]] for i in (2, 3))]
    shares = [[row[0] * flexible[0][j] + row[1] * flexible[1][j] for j in (0, 1)] for row in across]
    d = [[d[min(i, j)][max(i, j)] - shares[min(i, j)][0] * across[max(i, j)][0]
          - shares[min(i, j)][1] * across[max(i, j)][1] for j in range(4)] for i in range(4)]
    loads = []
    for one, other in zip(left[1:], right[1:], strict=True):
        middle = [one[2] + other[0], one[3] + other[1]]
        loads.append([end - share[0] * middle[0] - share[1] * middle[1]
                      for end, share in zip([*one[:2], *other[2:]], shares, strict=True)])
    return d, loads[0], loads[1]


def _flexibility(left: "Joined", right: "Joined | tuple[list[list[Node]], list[Node]]") -> "list[list[Node]]":
    """What moves between two of them, by forces there."""
    a, b, c = (left[0][i][j] + right[0][i - 2][j - 2] for i, j in ((2, 2), (2, 3), (3, 3)))
    determinant = a * c - b * b
    return [[c / determinant, -b / determinant], [-b / determinant, a / determinant]]


def _between(left: "Joined", right: "tuple[list[list[Node]], list[Node]]", ends: "list[Node]",
             load: "Node") -> "list[Node]":
    """(u, θ) between two of them as their outer ends move."""
    forces = []
    for i in (0, 1):
        force = load * (left[1][2 + i] + right[1][i])
        force = force - left[0][2 + i][0] * ends[0] - left[0][2 + i][1] * ends[1]
        forces.append(force - right[0][i][2] * ends[2] - right[0][i][3] * ends[3])
    return [row[0] * forces[0] + row[1] * forces[1] for row in _flexibility(left, right)]
