"""Entries of M, C, G and K to many digits: of the full equations M q̈ + h(q, q̇) + Gᵀλ = 0 about an equilibrium

    K = ∂r/∂q,  r = h_q + z_qᵀ h_z of q̇ = 0 on G(q, z) = 0,        D = Tᵀ ∂h/∂q̇ T,  T = (1, z_q),  C + G = D

by central differences in mpmath, whose steps fall with the digits; M as it stands, Tᵀ M T.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.static_positions import StaticEquations, resting_place
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

DIGITS, START, LIMIT = 30, 60, 240
CLOSED = 60             # steps of Newton's method


class TrueMatrices:
    """Of a Configuration at the working precision."""

    def __init__(self, configuration: "Configuration", static: StaticEquations) -> None:
        scene, self.static = static.scene, static
        self.arithmetic = multiprecision()
        self.values = configuration.numeric.values(self.arithmetic)
        rest = resting_place(configuration, static, self.values)
        self.place = [rest[name] for name in scene.coordinates]
        free = configuration.scene.coordinates
        self.q = [scene.coordinates.index(name) for name in free]
        self.z = [i for i, name in enumerate(scene.coordinates) if name not in free]
        self.step = mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
        self.units = [mpmath.mpf(scene.unit_of(name)) for name in scene.coordinates]

    def entry(self, head: str, i: int, j: int) -> Any:
        """Of M, C, G or K."""
        if head in "MK":
            return self._mass(i, j) if head == "M" else self._stiffness(i, j)
        one, other = self._drag(i, j), self._drag(j, i)
        return (one + other) / 2 if head == "C" else (one - other) / 2

    def _known(self, place: Sequence[mpmath.mpf], speeds: Sequence[mpmath.mpf] = ()) -> dict[str, mpmath.mpf]:
        scene = self.static.scene
        speeds = speeds or [mpmath.mpf(0)] * len(place)
        return {**self.values, scene.time.name: mpmath.mpf(0), **dict(zip(scene.coordinates, place, strict=True)),
                **{name + "'": v for name, v in zip(scene.coordinates, speeds, strict=True)}}

    def _slopes(self, place: list[mpmath.mpf]) -> mpmath.matrix:
        """∂G/∂q of all coordinates."""
        parts = self.static.parts
        found = dict(zip(parts.slopes, evaluate(list(parts.slopes.values()), self.arithmetic, self._known(place)),
                         strict=True))
        return mpmath.matrix([[found.get((k, i), 0) for i in range(len(place))] for k in range(len(parts.gaps))])

    @cached_property
    def ways(self) -> list[list[mpmath.mpf]]:
        """T: how all coordinates move with each that is free."""
        found = [[mpmath.mpf(int(i == k)) for i in range(len(self.place))] for k in self.q]
        if self.z:
            G = self._slopes(self.place)
            for way, k in zip(found, self.q, strict=True):
                for i, x in zip(self.z, mpmath.lu_solve(_columns(G, self.z), -_columns(G, [k])), strict=True):
                    way[i] = x
        return found

    def _mass(self, i: int, j: int) -> mpmath.mpf:
        M = self.static.parts.M
        entries = zip(M, evaluate(list(M.values()), self.arithmetic, self._known(self.place)), strict=True)
        one, other = self.ways[i], self.ways[j]
        return mpmath.fsum(x * (one[a] * other[b] + (one[b] * other[a] if a != b else 0)) for (a, b), x in entries)

    def _drag(self, i: int, j: int) -> mpmath.mpf:
        """∂h/∂q̇, both sides moved with free coordinates."""
        speeds = [x * self.step * self.units[self.q[j]] for x in self.ways[j]]
        up, down = (evaluate(self.static.parts.h, self.arithmetic, self._known(self.place, [way * v for v in speeds]))
                    for way in (1, -1))
        change = mpmath.fsum(x * (a - b) for x, a, b in zip(self.ways[i], up, down, strict=True))
        return change / (2 * self.step * self.units[self.q[j]])

    def _stiffness(self, i: int, j: int) -> mpmath.mpf:
        step = self.step * self.units[self.q[j]]
        return (self._force(i, j, step) - self._force(i, j, -step)) / (2 * step)

    def _force(self, i: int, j: int, step: mpmath.mpf) -> mpmath.mpf:
        """r of a free coordinate where another one is moved, with all that follows it."""
        place = [x + step * way for x, way in zip(self.place, self.ways[j], strict=True)]
        h = self._at_rest(place)
        if not self.z:
            return h[self.q[i]]
        G, z = self._slopes(place), self.z
        for _ in range(CLOSED):
            gaps = evaluate(self.static.parts.gaps, self.arithmetic, self._known(place))
            change = mpmath.lu_solve(_columns(G, z), -mpmath.matrix(gaps))
            for k, x in zip(z, change, strict=True):
                place[k] += x
            if mpmath.norm(change, mpmath.inf) <= mpmath.eps * 16 * (1 + max(map(abs, place))):
                break
            G = self._slopes(place)
        h = self._at_rest(place)
        ties = mpmath.lu_solve(_columns(G, z).T, -mpmath.matrix([h[k] for k in z]))
        return h[self.q[i]] + mpmath.fsum(tie * G[k, self.q[i]] for k, tie in enumerate(ties))

    def _at_rest(self, place: list[mpmath.mpf]) -> list[mpmath.mpf]:
        return evaluate(self.static.parts.h, self.arithmetic, self._known(place))


def _columns(G: mpmath.matrix, which: Sequence[int]) -> mpmath.matrix:
    return mpmath.matrix([[G[k, i] for i in which] for k in range(G.rows)])


def entry(configuration: "Configuration", static: StaticEquations, head: str, pair: tuple[int, int],
          size: float) -> TrueValues:
    """An entry, whose digits count from a size on where it is smaller."""
    if configuration.spec.get("damping") is not None and head in "CG":
        raise PhysicsError("`damping:` gives C by modes: there is nothing to compare")

    def found() -> "tuple[list[mpmath.mpf], float]":
        value = TrueMatrices(configuration, static).entry(head, *pair)
        nothing = abs(value) <= size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        return [mpmath.mpf(0) if nothing else value], max(size, abs(value))

    return settled(found, DIGITS, START, LIMIT, sized=True)
