"""The full equations of motion in numbers: accelerations of many instants at once.

Up to DIRECT coordinates without constraints M q̈ = −h is solved in the expressions; else by LU factors of

    [M  Gᵀ] [q̈]   [−h]
    [G  0 ] [λ] = [−γ]        at each instant, of constant M once.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equations_of_motion import drift, dynamics
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.equations_of_motion import Dynamics
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

DIRECT = 3
PROJECTIONS = 4


class NumericEquations:
    """A scene's equations compiled; `n` coordinates, `m` independent constraints.

    switches: the arguments whose signs stay as they are while the motion is smooth, in the order of their senses g.
    changed: what each constant of the equations is written as instead, None: itself; like: those of the same scene with
    other constants, whose expressions these are too, compiled once for all of them.
    """

    parts: "Dynamics"
    solution: "list[Node]"
    _named: dict[Any, Compiled]

    def __init__(self, scene: "Scene", floats: Mapping[str, float], redundant: Sequence[Any] = (),
                 changed: Callable[[float], float] | None = None, like: "NumericEquations | None" = None) -> None:
        self.scene, self.floats, self.redundant, self.changed = scene, floats, redundant, changed
        parts = self.parts = dynamics(scene, redundant) if like is None else like.parts
        self.n, self.m = len(scene.q), len(parts.gaps)
        self._slots, self._named = {}, {} if like is None else like._named
        self.still = self.m == 0 and all(not node.mask for node in parts.M.values())
        self.direct = self.m == 0 and self.n <= DIRECT
        for i, name in enumerate(scene.coordinates):
            if (i, i) not in parts.M:
                raise massless(name)
        if self.direct:
            self.solution = _solved(scene.table, parts, self.n) if like is None else like.solution
            self._compiled = self.compiled(self.solution)
        else:
            self._pairs, self._ties = list(parts.M), list(parts.slopes)
            entries = [*parts.M.values(), *parts.slopes.values(), *parts.h, *parts.bends]
            self._compiled = self.compiled(entries)
            self._inverse = self._factors() if self.still else None
        self._closing = self.compiled([*parts.gaps, *parts.rates]) if self.m else None

    @cached_property
    def inertia(self) -> "Compiled":
        """[Mᵢᵢ] of instants."""
        return self.compiled([self.parts.M[i, i] for i in range(self.n)])

    def compiled(self, nodes: "Sequence[Node]") -> Compiled:
        """The nodes as a function of arrays; its switches are added to those of the system."""
        if self.changed is None:
            return Compiled(self.scene, self.floats, self._slots, nodes)
        key = tuple(nodes), tuple(self._slots)
        if key not in self._named:      # the first of those with other constants
            self._named[key] = Compiled(self.scene, self.floats, dict(self._slots), nodes, named=True)
        named = self._named[key]
        self._slots.update(named.switches or {})
        return named.of_data(self.floats, self.changed)

    @property
    def switches(self) -> "list[Node]":
        return list(self._slots)

    def prepared(self, t: np.ndarray) -> tuple[Any, ...]:
        found: tuple[Any, ...] = self._compiled.prepared(t)
        return found

    def accelerations(self, t: np.ndarray, q: np.ndarray, v: np.ndarray,
                      g: Sequence[float | np.ndarray] | np.ndarray = (),
                      c: Sequence[np.ndarray] | None = None) -> np.ndarray:
        """q̈ of shape (n, instants)."""
        return self._compiled.rows(t, q, v, g, c) if self.direct else self.solved(t, q, v, g, c)[0]

    def solved(self, t: np.ndarray, q: np.ndarray, v: np.ndarray, g: Any = (),
               c: Sequence[np.ndarray] | None = None) -> tuple[np.ndarray, np.ndarray]:
        """(q̈, λ) of shapes (n, instants) and (m, instants)."""
        if self.direct:
            return self.accelerations(t, q, v, g, c), None
        values, shape = self._compiled(t, q, v, g, c), q.shape[1]
        n, m = self.n, self.m
        right = np.empty((n + m, shape))
        for i, value in enumerate(values[len(self._pairs) + len(self._ties):]):
            right[i] = value
        if self._inverse is not None:
            column = self._inverse.shape[1] == 1
            return (-right / self._inverse if column else -(self._inverse @ right)), None
        A = _bordered(values, self._pairs, self._ties, self.n, self.m, shape)
        try:
            x = np.linalg.solve(A, -right.T[:, :, None])[:, :, 0].T
        except np.linalg.LinAlgError:
            return np.full((n, shape), np.nan), np.full((m, shape), np.nan)
        return x[:n], x[n:]

    def by_state(self, t: np.ndarray, q: np.ndarray, v: np.ndarray, steps: np.ndarray) -> np.ndarray:
        """∂q̈/∂(q, q̇) of shape (2n, n, instants) without constraints and switches, by `steps` of each: M δq̈ = −(h + M q̈)
        with M and h of the neighbour, q̈ being that of the state itself."""
        n, count, a = self.n, 2 * self.n, self.accelerations(t, q, v)
        moved = np.repeat(np.concatenate([q, v])[:, None], count, axis=1)
        moved[range(count), range(count)] += steps[:, None]
        times, (Q, V) = np.tile(t, count), np.split(moved.reshape(count, -1), 2)
        if self.direct or self.still:
            found = self.accelerations(times, Q, V).reshape(n, count, -1) - a[:, None]
            result: np.ndarray = (found / steps[:, None]).swapaxes(0, 1)
            return result
        near, found, A = self._compiled(times, Q, V), np.empty(Q.shape), np.tile(a, count)
        for i, value in enumerate(near[len(self._pairs):]):
            found[i] = value
        for (i, j), value in zip(self._pairs, near, strict=False):
            found[i] += value * A[j]
            if i != j:
                found[j] += value * A[i]
        M = _bordered(self._compiled(t, q, v), self._pairs, self._ties, n, 0, q.shape[1])
        right = found.reshape(n, count, -1) / -steps[:, None]
        try:
            return np.linalg.solve(M, right.transpose(2, 0, 1)).transpose(2, 1, 0)
        except np.linalg.LinAlgError:
            return np.full((count, *q.shape), np.nan)

    def _factors(self) -> np.ndarray:
        """The inverse of a constant M, as a column where it is diagonal."""
        values = evaluate(list(self.parts.M.values()), Floats, self.floats)
        values = values if self.changed is None else list(map(self.changed, values))
        M = np.zeros((self.n, self.n))
        for (i, j), value in zip(self.parts.M, values, strict=True):
            M[i, j] = M[j, i] = value
        size = np.diag(M)
        if not (size > 0).all():
            raise massless(self.scene.coordinates[int(np.argmin(size))])
        if not (M - np.diag(size)).any():
            return size[:, None]
        scale = size ** -0.5
        return scale[:, None] * np.linalg.inv(M * np.outer(scale, scale)) * scale

    def sizes(self, t: Any, q: Any, v: Any, g: Any = ()) -> np.ndarray:
        """Σ |terms of hᵢ| at one instant: what the rounding of hᵢ is relative to."""
        factors, compiled = self._terms_of_h
        found: np.ndarray = factors @ np.abs(compiled.rows(np.array([t]), q[:, None], v[:, None], g)[:, 0])
        return found

    @cached_property
    def _terms_of_h(self) -> tuple[np.ndarray, Compiled]:
        """The |factors| of the terms of all hᵢ, a row for each, and what computes these terms without them."""
        terms = [(i, part, factor) for i, node in enumerate(self.parts.h)
                 for part, factor in (node.args if node.op == "sum" else [(node, 1)])]
        factors = np.zeros((self.n, len(terms)))
        for k, (i, _, factor) in enumerate(terms):
            factors[i, k] = abs(float(factor))
        return factors, self.compiled([part for _, part, _ in terms])

    def gaps(self, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(G, Ġ) of shapes (m, instants), which no switch changes."""
        found = self._closing.rows(t, q, v, (1.0,) * len(self._slots))
        return found[:self.m], found[self.m:]

    def slopes(self, t: np.ndarray, q: np.ndarray, v: np.ndarray, g: Sequence[Any] = ()) -> np.ndarray:
        """∂G/∂q of shape (m, n, instants)."""
        values = self._compiled(t, q, v, g or (1.0,) * len(self._slots))
        A = _bordered(values, self._pairs, self._ties, self.n, self.m, q.shape[1])
        return A[:, self.n:, :self.n].transpose(1, 2, 0)

    def projected(self, t: float, q: np.ndarray, v: np.ndarray, g: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
        """The nearest (q, q̇) at an instant that close the loops, distances being measured by M."""
        for _ in range(PROJECTIONS):
            step = self._projection(t, q, v, g, 0)
            q = q + step
            if (np.abs(step) <= 4e-16 * np.abs(q)).all():
                break
        return q, v + self._projection(t, q, v, g, 1)

    def _projection(self, t: float, q: np.ndarray, v: np.ndarray, g: Sequence[float], which: int) -> np.ndarray:
        t, q, v = np.array([t]), q[:, None], v[:, None]
        A = _bordered(self._compiled(t, q, v, g), self._pairs, self._ties, self.n, self.m, 1)[0]
        right = np.concatenate([np.zeros(self.n), -self.gaps(t, q, v)[which][:, 0]])
        return np.linalg.solve(A, right)[:self.n]

    def struck(self, t: float, q: np.ndarray, v: np.ndarray, g: Sequence[Any],
               blows: "Mapping[Node, float]") -> np.ndarray:
        """q̇ after impulses of the sizes {impulse node: N·s} just before an instant: M Δq̇ + Gᵀ Λ = Σ size ∂(−h)/∂δ, and
        Ġ = 0 again where a constraint is driven at another speed from then on."""
        slopes = self.slopes_by(blows)
        point = np.array([t]), q[:, None], v[:, None], g
        sizes = np.array([float(np.max(value)) for value in self.compiled(slopes)(*point)]).reshape(len(blows), self.n)
        entries = [*self.parts.M.values(), *self.parts.slopes.values()]
        values = [float(np.max(value)) for value in self.compiled(entries)(*point)]
        A = _bordered(values, list(self.parts.M), list(self.parts.slopes), self.n, self.m, 1)[0]
        parted = self.gaps(*point[:3])[1][:, 0] if self.m else np.zeros(0)
        right = np.concatenate([-np.array(list(blows.values())) @ sizes, -parted])
        return v + np.linalg.solve(A, right)[:self.n]

    def slopes_by(self, blows: "Mapping[Node, float]") -> "list[Node]":
        """[∂h/∂δ] of each impulse node, one coordinate after the other."""
        table = self.scene.table
        stand_in = {node: table.variable(f"impulse {i}") for i, node in enumerate(blows)}
        h = substitute(self.parts.h, stand_in)
        slopes = [gradient(node).get(symbol, table.zero) for symbol in stand_in.values() for node in h]
        if any(symbol in gradient(slope) for slope in slopes for symbol in stand_in.values()):
            raise PhysicsError("a force of this scene is no linear function of an impulse",
                               "let the impulse stand alone, as in P*impulse(t - t1)")
        return slopes

    def rate_of(self, node: "Node") -> "tuple[Node, dict[int, Node]]":
        """(dnode/dt without accelerations, {i: its slope by q̈ᵢ}) of an expression of q, q̇ and t."""
        speeds = {v: i for i, v in enumerate(self.scene.v)}
        return drift(self.scene, node), {speeds[v]: x for v, x in gradient(node).items() if v in speeds}


def _bordered(values: Sequence[float | np.ndarray], pairs: Sequence[tuple[int, int]], ties: Sequence[tuple[int, int]],
              n: int, m: int, instants: int) -> np.ndarray:
    """[M Gᵀ; G 0] at each instant, of shape (instants, n + m, n + m)."""
    A = np.zeros((n + m, n + m, instants))
    for (i, j), value in zip(pairs, values, strict=False):
        A[i, j] = A[j, i] = value
    for (k, i), value in zip(ties, values[len(pairs):], strict=False):
        A[n + k, i] = A[i, n + k] = value
    return A.transpose(2, 0, 1)


def massless(name: str) -> PhysicsError:
    return PhysicsError(f"no inertia moves with '{name}': its motion in time does not follow from a mass",
                        "give what moves with it a mass, take the coordinate out, or look at small oscillations "
                        "with motion: small")


def _solved(table: "Table", parts: "Dynamics", n: int) -> "list[Node]":
    """[q̈ᵢ] as expressions, by elimination without pivoting: M is positive definite."""
    M = {(i, j): parts.M.get((min(i, j), max(i, j)), table.zero) for i in range(n) for j in range(n)}
    h = list(parts.h)
    for k in range(n):
        if M[k, k].is_zero:
            raise PhysicsError("the mass matrix is singular", "give each coordinate an inertia")
        for i in range(k + 1, n):
            if M[i, k].is_zero:
                continue
            factor = M[i, k] / M[k, k]
            for j in range(k + 1, n):
                M[i, j] = M[i, j] - factor * M[k, j]
            h[i] = h[i] - factor * h[k]
    found = [table.zero] * n
    for i in reversed(range(n)):
        rest = table.total([h[i], *(M[i, j] * found[j] for j in range(i + 1, n))])
        found[i] = -(rest / M[i, i])
    return found
