"""The full equations of motion in numbers: accelerations of many instants at once.

Up to DIRECT coordinates without constraints M q̈ = −h is solved in the expressions; else by LU factors of

    [M  Gᵀ] [q̈]   [−h]
    [G  0 ] [λ] = [−γ]        at each instant, of constant M once.
"""

import numpy as np

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.rationals import ONE
from vibcli.errors import PhysicsError
from vibcli.mechanics.compiled import Compiled
from vibcli.mechanics.dynamics import drift, dynamics

DIRECT = 3
SINGULAR = 1e-13


class System:
    """A scene's equations compiled; `n` coordinates, `m` independent constraints.

    switches: the arguments whose signs stay as they are while the motion is smooth, in the order of their senses g.
    """

    def __init__(self, scene, floats, redundant=()):
        self.scene, self.floats = scene, floats
        self.parts = parts = dynamics(scene, redundant)
        self.n, self.m = len(scene.q), len(parts.gaps)
        self._slots, self._sizes = {}, None
        self.still = self.m == 0 and all(not node.mask for node in parts.M.values())
        self.direct = self.m == 0 and self.n <= DIRECT
        self._require_inertia()
        self.inertia = self.compiled([parts.M[i, i] for i in range(self.n)])
        if self.direct:
            self._compiled = self.compiled(_solved(scene.table, parts, self.n))
        else:
            self._pairs, self._ties = list(parts.M), list(parts.slopes)
            entries = [*parts.M.values(), *parts.slopes.values(), *parts.h, *parts.bends]
            self._compiled = self.compiled(entries)
            self._inverse = self._factors() if self.still else None
        self.closing = self.compiled([*parts.gaps, *parts.rates, *parts.slopes.values()]) if self.m else None

    def _require_inertia(self):
        for i, name in enumerate(self.scene.coordinates):
            if (i, i) not in self.parts.M:
                raise massless(name)

    def compiled(self, nodes):
        """The nodes as a function of arrays; its switches are added to those of the system."""
        return Compiled(self.scene, self.floats, self._slots, nodes)

    @property
    def switches(self):
        return list(self._slots)

    def prepared(self, t):
        return self._compiled.prepared(t)

    def accelerations(self, t, q, v, g=(), c=None):
        """q̈ of shape (n, instants)."""
        return self.solved(t, q, v, g, c)[0]

    def solved(self, t, q, v, g=(), c=None):
        """(q̈, λ) of shapes (n, instants) and (m, instants)."""
        values = self._compiled(t, q, v, g, c)
        shape = q.shape[1]
        if self.direct:
            a = np.empty((self.n, shape))
            for i, value in enumerate(values):
                a[i] = value
            return a, None
        n, m = self.n, self.m
        right = np.empty((n + m, shape))
        for i, value in enumerate(values[len(self._pairs) + len(self._ties):]):
            right[i] = value
        if self._inverse is not None:
            return (-right / self._inverse if self._inverse.ndim == 2 else -(self._inverse @ right)), None
        A = self.matrices(values, shape)
        try:
            x = np.linalg.solve(A, -right.T[:, :, None])[:, :, 0].T
        except np.linalg.LinAlgError:
            return np.full((n, shape), np.nan), np.full((m, shape), np.nan)
        return x[:n], x[n:]

    def matrices(self, values, instants):
        """[M Gᵀ; G 0] at each instant, of shape (instants, n + m, n + m)."""
        n = self.n
        A = np.zeros((n + self.m, n + self.m, instants))
        for (i, j), value in zip(self._pairs, values, strict=False):
            A[i, j] = A[j, i] = value
        for (k, i), value in zip(self._ties, values[len(self._pairs):], strict=False):
            A[n + k, i] = A[i, n + k] = value
        return A.transpose(2, 0, 1)

    def _factors(self):
        """The inverse of a constant M, as a column where it is diagonal."""
        values = evaluate(list(self.parts.M.values()), Floats, self.floats)
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

    def sizes(self, t, q, v, g=()):
        """Σ |terms of hᵢ| at one instant: what the rounding of hᵢ is relative to."""
        terms = [(i, part) for i, node in enumerate(self.parts.h)
                 for part in ([arg for arg, _ in node.args] if node.op == "sum" else [node])]
        factors = [abs(float(c)) for node in self.parts.h for c in
                   ([c for _, c in node.args] if node.op == "sum" else [1])]
        if self._sizes is None:
            self._sizes = self.compiled([part for _, part in terms])
        found = np.zeros(self.n)
        values = self._sizes(np.array([t]), q[:, None], v[:, None], g)
        for (i, _), factor, value in zip(terms, factors, values, strict=True):
            found[i] += factor * abs(float(np.max(value)))
        return found

    def jumps(self):
        """Not smooth in anything but the time: the switches that hang on the motion."""
        return [bool(node.mask & ~self.scene.time.mask) for node in self.switches]

    def rate_of(self, node):
        """(dnode/dt without accelerations, {i: its slope by q̈ᵢ}) of an expression of q, q̇ and t."""
        from vibcli.algebra.calculus import gradient

        speeds = {v: i for i, v in enumerate(self.scene.v)}
        return drift(self.scene, node), {speeds[v]: x for v, x in gradient(node).items() if v in speeds}


def massless(name):
    return PhysicsError(f"no inertia moves with '{name}': its motion in time does not follow from a mass",
                        "give what moves with it a mass, or take the coordinate out")


def _solved(table, parts, n):
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
    found = [None] * n
    for i in reversed(range(n)):
        rest = table.sum((h[i], ONE), *((M[i, j] * found[j], ONE) for j in range(i + 1, n)))
        found[i] = -(rest / M[i, i])
    return found

