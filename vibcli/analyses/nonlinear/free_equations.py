"""The equations of free motions of several degrees in modal coordinates, and their exact derivatives.

With q = q₀ + Φ η about an equilibrium, ΦᵀM₀Φ = 1, and time counted as θ = ω t, ω = w ωᵢ:

    r = Φᵀ (M(q) q̈ + h(q, q̇))/ωᵢ² = 0        q̈ = ω² Φ η″        q̇ = ω Φ η′

Dampers are left out of h.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import effective_potential
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.numeric_code import SWITCHED
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene

EPS = 2.0**-52
STIFF, SAME = 1e-9, 1e-6        # relative: a smaller ω² is none; nearer frequencies are the same
EVEN = 1e-13                    # of forces: less is none
TRIALS, ODD = 3, 1e-9           # states at which forces are compared with those of the reversed motion


class Slopes(NamedTuple):
    """r of shape (n, places), and its derivatives by η″/w², η and η′/w of shape (n, n, places); `by_w`: of shape
    (n, places)."""

    residual: np.ndarray
    mass: np.ndarray
    stiffness: np.ndarray
    damping: np.ndarray
    by_w: np.ndarray


class FreeEquations:
    """Those of a scene about the equilibrium `rest`; `omegas` ascending and `shapes` Φ of its small vibrations.
    `bent`: is |u|, min … in them?"""

    def __init__(self, scene: "Scene", floats: Mapping[str, float], rest: np.ndarray) -> None:
        self.scene, self.floats, self.n, self.rest = scene, floats, len(scene.q), rest
        parts = dynamics(scene, undamped=True)
        zero = scene.table.zero
        self.pairs, self.h = list(parts.M), parts.h
        self.entries = list(parts.M.values())
        moved = [(pair, k, slope) for pair, node in parts.M.items() for k, q in enumerate(scene.q)
                 if not (slope := gradient(node).get(q, zero)).is_zero]
        self.moved = [(pair, k) for pair, k, _ in moved]
        by_q, by_v = ([gradient(node).get(x, zero) for node in parts.h for x in symbols]
                      for symbols in (scene.q, scene.v))
        self._plain = Compiled(scene, floats, None, [*self.entries, *self.h])
        self._sloped = Compiled(scene, floats, None,
                                [*self.entries, *self.h, *(slope for *_, slope in moved), *by_q, *by_v])
        self._potential = Compiled(scene, floats, None, [effective_potential(scene)])
        self._errors = RunningErrors(Floats)
        self._rounded = {name: Rounded(value, EPS / 2 * abs(value)) for name, value in floats.items()}
        self.bent = any(part.op == "call" and part.name in SWITCHED for part in reachable(parts.nodes()))
        self.omegas, self.shapes = self._small_vibrations()

    def _small_vibrations(self) -> tuple[np.ndarray, np.ndarray]:
        q, v = self.rest[:, None], np.zeros((self.n, 1))
        M, _, _, K, _ = self._parted(self._sloped, q, v, np.zeros((self.n, 1)))
        M, K = M[:, :, 0], 0.5 * (K[:, :, 0] + K[:, :, 0].T)
        try:
            L = np.linalg.inv(np.linalg.cholesky(M))
        except np.linalg.LinAlgError:
            raise PhysicsError("no inertia moves with a coordinate of this scene: its free motions are not followed",
                               "give what moves a mass, or take the coordinate out") from None
        squares, vectors = np.linalg.eigh(L @ K @ L.T)
        if squares[0] < STIFF * abs(squares[-1]) or not np.isfinite(squares).all():
            below = squares[0] < -STIFF * abs(squares[-1])
            raise PhysicsError("this equilibrium is not stable: there are no free vibrations about it" if below else
                               "something moves without stiffness in small motions: the families of free motions "
                               "start at modes with a frequency",
                               "ask about another one, by its number as last index" if below else
                               "hold what moves freely as a whole, or take its coordinate out")
        return np.sqrt(squares), L.T @ vectors

    def require_reversible(self) -> None:
        """PhysicsError where forces turn with the sense of the motion, as those of turning frames do."""
        rng = np.random.default_rng(1)
        q = self.rest[:, None] + 0.1 * self.shapes @ rng.standard_normal((self.n, TRIALS)) * self._reach()
        v = self.shapes @ (self.omegas[:, None] * rng.standard_normal((self.n, TRIALS))) * 0.1 * self._reach()
        with np.errstate(all="ignore"):
            there, back, still = (self._parted(self._plain, q, s * v, 0 * q)[1] for s in (1, -1, 0))
        size = np.abs(there - still) + np.abs(back - still)
        if np.any(np.abs(there - back) > ODD * size.max()):
            raise PhysicsError("forces of this scene turn with the sense of the motion (a frame that turns): families "
                               "of free motions of several degrees are found where a motion runs backwards as well",
                               "ask for omega[1], or for the motion from `initial`")

    @cached_property
    def odd(self) -> bool:
        """Do the forces of opposite motions only differ in their sign?"""
        eta, slope, bend = np.random.default_rng(2).standard_normal((3, self.n, TRIALS)) * 0.3 * self._reach()
        scale = float(self.omegas[0])
        there, back = (self.residual(scale, 1.0, s * eta, s * slope, s * bend) for s in (1, -1))
        return bool(np.all(np.abs(there + back) <= EVEN * np.abs(there).max()))

    def _reach(self) -> float:
        """A length in modal coordinates of the size of the scene."""
        units = np.array([self.scene.unit_of(name) for name in self.scene.coordinates])
        return float((units[:, None] / np.maximum(np.abs(self.shapes), 1e-300)).min())

    @property
    def reach(self) -> float:
        return self._reach()

    def places(self, eta: np.ndarray) -> np.ndarray:
        """q of shape (n, places)."""
        found: np.ndarray = self.rest[:, None] + self.shapes @ eta
        return found

    def residual(self, scale: float, w: float | np.longdouble, eta: np.ndarray, slope: np.ndarray,
                 bend: np.ndarray) -> np.ndarray:
        """r; the arrays η, η′, η″ of shape (n, places) may be of longer numbers than floats. scale: ωᵢ."""
        omega = scale * w
        q, v, a = self.places(eta), omega * (self.shapes @ slope), omega**2 * (self.shapes @ bend)
        M, h, *_ = self._parted(self._plain, q, v, a)
        found: np.ndarray = self.shapes.T @ (np.einsum("ilj,lj->ij", M, a) + h) / scale**2
        return found

    def slopes(self, scale: float, w: float, eta: np.ndarray, slope: np.ndarray, bend: np.ndarray) -> Slopes:
        """r and its derivatives."""
        omega, Phi = scale * w, self.shapes
        v, a = omega * (Phi @ slope), omega**2 * (Phi @ bend)
        M, h, turned, K, C = self._parted(self._sloped, self.places(eta), v, a)
        force = np.einsum("ilj,lj->ij", M, a)
        mass, stiffness, damping = (np.einsum("ai,abj,bl->ilj", Phi, part, Phi, optimize=False)
                                    for part in (M, K + turned, C))
        stiffness, damping = stiffness / scale**2, damping / scale
        by_w = 2 / w * (Phi.T @ force) / scale**2 + np.einsum("ilj,lj->ij", damping, slope)
        return Slopes(Phi.T @ (force + h) / scale**2, mass, stiffness, damping, by_w)

    def _parted(self, compiled: Compiled, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> tuple[np.ndarray, ...]:
        """(M, h, ∂(M q̈)/∂q at fixed q̈, ∂h/∂q, ∂h/∂q̇) at the places."""
        n, places = self.n, q.shape[1]
        with np.errstate(all="ignore"):
            values = compiled(np.zeros(places), q, v)
        kind, count = q.dtype, len(self.pairs)
        M, h = np.zeros((n, n, places), kind), np.empty((n, places), kind)
        for (i, j), value in zip(self.pairs, values, strict=False):
            M[i, j] = M[j, i] = value
        for i in range(n):
            h[i] = values[count + i]
        if compiled is self._plain:
            return M, h
        turned, K, C = np.zeros((n, n, places)), np.empty((n * n, places)), np.empty((n * n, places))
        start = count + n
        for ((i, j), k), value in zip(self.moved, values[start:], strict=False):
            turned[i, k] += value * a[j]
            if i != j:
                turned[j, k] += value * a[i]
        start += len(self.moved)
        for m in range(n * n):
            K[m], C[m] = values[start + m], values[start + n * n + m]
        return M, h, turned, K.reshape(n, n, places), C.reshape(n, n, places)

    def rounding(self, scale: float, w: float, eta: np.ndarray, slope: np.ndarray, bend: np.ndarray) -> np.ndarray:
        """What the rounding of parameters and of the arithmetic leaves of r at most, of shape (n,), at one place."""
        omega, Phi = scale * w, self.shapes
        q, v, a = self.rest + Phi @ eta, omega * (Phi @ slope), omega**2 * (Phi @ bend)
        values = self._rounded | {x.name: float(y) for x, y in (*zip(self.scene.q, q, strict=True),
                                                 *zip(self.scene.v, v, strict=True))}
        try:
            found = [float(error_in(x)) for x in evaluate([*self.entries, *self.h], self._errors, values)]
        except (ZeroDivisionError, OverflowError, ValueError):
            return np.full(self.n, np.inf)
        error = np.array(found[len(self.pairs):])
        for (i, j), part in zip(self.pairs, found, strict=False):
            error[i] += part * abs(a[j])
            error[j] += part * abs(a[i]) * (i != j)
        result: np.ndarray = np.abs(Phi.T) @ error / scale**2
        return result

    def energy(self, eta: np.ndarray) -> float:
        """V there − V at the equilibrium, of shape (n,) at rest."""
        q = np.stack([self.rest, self.rest + self.shapes @ eta], axis=1).astype(np.longdouble)
        V, = self._potential(np.zeros(2), q, 0 * q)
        return float(np.diff(np.broadcast_to(V, (2,)))[0])
