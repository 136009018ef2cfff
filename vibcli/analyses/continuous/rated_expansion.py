"""What coordinates answer to forces of dampers in a system whose modes are damped each by itself, about s = 0:

    H(s) = Σ φ ψᵀ/q(s),     q(s) = s² + c s + ω²,     ψ = Uᵀ φ

of the modes with an eigenvalue in |s| < 2.5 R one by one, and of all others as a power series, which converges beyond
R: from the exact sum over all modes on a circle about R (Cauchy).
"""

from functools import cached_property
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.damped_sum import DampedSum
from vibcli.analyses.continuous.member_damping import MemberDamping
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.analyses.modal.mode_sequence import Modes

REACH = 2.5         # times R: eigenvalues of all other modes are beyond
POINTS, TERMS = 96, 48      # on the circle, in all, and of the series: (1.7/2.5)^96 and (1/2.5)^48 are below rounding
CIRCLES = np.linspace(1.4, 1.7, 31)     # of R: radii that are tried
ASIDE = 0.2         # of the distance of the next eigenvalue: where what the modes one by one leave out is looked at
UNIT, SURER = 2.0**-52, 4.0
ANGLE = np.pi * (3 - 5**0.5) / 2    # arccos of a ratio at which no Uₖ is near 0
MOST = 400          # modes one by one


class RatedExpansion:
    """still: the DynamicMatrix without damping; U (n, r) the rows of dampers; H (n, r) within |s| < radius."""

    def __init__(self, still: "DynamicMatrix", U: np.ndarray, modes: "Modes", damping: "MemberDamping",
                 radius: float) -> None:
        self.still, self.U, self.radius = still, U, radius
        self._sum = DampedSum(damping, modes, self._plain)
        self._damping, self._modes = damping, modes
        known = modes.first(max(len(modes.up_to(highest(damping, radius))), len(damping.ratios)))
        if len(known) > MOST:
            raise PhysicsError("so many damped modes of members are not found where modes have ratios beside dampers",
                               "ask for fewer, or lower ones, or for frequency responses")
        self.omega = np.array([float(mode.omega or 0.0) for mode in known])
        self.c = np.array([float(damping.rate(mode)) for mode in known])
        self.unsure = np.array([float(mode.error) for mode in known])
        self.shapes = np.array([[float(x) for x in mode.shape] for mode in known]).reshape(-1, still.n).T
        self.psi = U.T @ self.shapes
        half = self.c / 2
        root = np.sqrt(half**2 - self.omega**2 + 0j)
        fast = -half - root
        slow = np.where(self.c > 2 * self.omega, self.omega**2 / np.where(fast == 0, 1, fast), -half + root)
        self.eigenvalues = np.array([fast, slow])
        self._expand()
        self._look_beside()

    def _plain(self, sigma: np.ndarray) -> np.ndarray:
        """(n, r, N) without damping."""
        D = np.moveaxis(self.still.at(sigma).D, -1, 0)
        return np.moveaxis(np.linalg.solve(D, np.broadcast_to(self.U, (len(sigma), *self.U.shape))), 0, -1)

    def denominators(self, s: np.ndarray) -> np.ndarray:
        """q, (modes, N)."""
        return cast("np.ndarray", self.omega[:, None]**2 + self.c[:, None] * s + s * s)

    def _one_by_one(self, s: np.ndarray) -> np.ndarray:
        return cast("np.ndarray", np.einsum("im,rm,mk->irk", self.shapes, self.psi, 1 / self.denominators(s)))

    def _expand(self) -> None:
        s = self._circle(self.eigenvalues)
        whole = self._sum.at(s)
        self.series = _coefficients(s / self.radius, whole - self._one_by_one(s))
        rounding = SURER * self._sum.rounding * UNIT
        self.lost = rounding * abs(self.U.T @ abs(np.moveaxis(whole, -1, 0))).max()

    def _circle(self, eigenvalues: np.ndarray) -> np.ndarray:
        """The upper half of one away from eigenvalues."""
        sizes = np.append(abs(eigenvalues).ravel(), 0.0)
        clear = [abs(sizes - at * self.radius).min() for at in CIRCLES]
        turn = np.exp(2j * np.pi * (np.arange(POINTS // 2) + 0.5) / POINTS)
        return cast("np.ndarray", self.radius * CIRCLES[int(np.argmax(clear))] * turn)

    @cached_property
    def _power_sums(self) -> np.ndarray:
        """Σ ψ ψᵀ Rᵏ/ω²⁺ᵏ over all others, (TERMS, r, r): from H with a ratio ζ of all modes, Σ Uₖ(−ζ) sᵏ/ω²⁺ᵏ."""
        zeta = float(np.cos(ANGLE))
        s = self._circle(self.omega * np.exp(1j * (np.pi - ANGLE)))
        whole = DampedSum(MemberDamping((zeta,)), self._modes, lambda sigma: np.einsum(
            "ir,isk->rsk", self.U, self._plain(sigma))).at(s)
        q = self.omega[:, None]**2 + 2 * zeta * self.omega[:, None] * s + s * s
        found = _coefficients(s / self.radius, whole - np.einsum("am,bm,mk->abk", self.psi, self.psi, 1 / q))
        k = np.arange(TERMS)
        return cast("np.ndarray", found / ((-1.0)**k * np.sin((k + 1) * ANGLE) / np.sin(ANGLE))[:, None, None])

    def energy_of_others(self, s: complex, force: np.ndarray) -> float:
        """Σ |ψᵀ f|²/|q(s)|² over all others: 1/q = Σ gₖ(s)/ω²⁺ᵏ."""
        g = self._terms(s)
        sums = np.einsum("r,krs,s->k", force.conj(), self._power_sums, force).real
        k = np.arange(TERMS)
        pairs = np.outer(g, g.conj()).real
        inside = k[:, None] + k < TERMS - 2
        return float((pairs[inside] * sums[(k[:, None] + k + 2)[inside]]).sum()) / self.radius**2

    def _terms(self, s: complex) -> np.ndarray:
        """gₖ(s)/Rᵏ."""
        R = self.radius
        g = np.zeros(TERMS, complex)
        if self._damping.ratios:
            g[0], g[1] = 1.0, -2 * float(self._damping.ratios[-1]) * s / R
            for k in range(2, TERMS):
                g[k] = g[1] * g[k - 1] - (s / R)**2 * g[k - 2]
            return g
        a, b = (*map(float, self._damping.series), 0.0)[:2]
        g[::2] = (-s * (s + a) / (1 + b * s) / R**2)**np.arange(TERMS // 2) / (1 + b * s)
        return g

    def _look_beside(self) -> None:
        """What is seen of H itself near eigenvalues beyond what it is here: (modes,) of ψ ψᵀ of each."""
        self.blurred = np.zeros(len(self.omega))
        places = self.eigenvalues[1]
        near = np.flatnonzero((abs(places) < self.radius) & (self.omega > 0))
        others = np.concatenate([self.eigenvalues.ravel(), [0.0]])
        apart = abs(places[near][:, None] - others)
        apart = np.where(apart > 1e-9 * abs(places[near])[:, None], apart, np.inf).min(axis=1)
        s = places[near] + ASIDE * np.minimum(apart, abs(places[near])) * 1j
        if len(s):
            seen = np.einsum("ir,isk->rsk", self.U, self._sum.at(s)) - self.at(s)
            q = abs(self.denominators(s)[near, range(len(near))])
            self.blurred[near] = SURER * abs(seen).max(axis=(0, 1)) * q

    def smooth(self, s: np.ndarray, slope: bool = False) -> np.ndarray:
        """What all others answer, or its derivative, (n, r, N)."""
        series, s = self.series, np.asarray(s, complex) / self.radius
        if slope:
            series = self.series[1:] * np.arange(1, len(self.series))[:, None, None] / self.radius
        return cast("np.ndarray", np.einsum("kir,kn->irn", series, s ** np.arange(len(series))[:, None]))

    def at(self, s: np.ndarray) -> np.ndarray:
        """Uᵀ H, (r, r, N)."""
        own = np.einsum("im,rm,mk->irk", self.psi, self.psi, 1 / self.denominators(s))
        return cast("np.ndarray", own + np.einsum("ir,isk->rsk", self.U, self.smooth(s)))


def _coefficients(s: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Those of a real power series, (TERMS, …), from its values (…, N) on the upper half of a circle."""
    k = np.arange(TERMS)
    return np.stack([(values * s**-float(power)).sum(axis=-1).real for power in k]) * 2 / POINTS


def highest(damping: "MemberDamping", radius: float) -> float:
    """ω beyond which both eigenvalues of all modes have |λ| > 2.5 R, ω²/c being less than the slow one."""
    most = REACH * radius
    if damping.ratios:
        return most * max(1.0, 2 * max(map(float, damping.ratios)))
    a, b = (*map(float, damping.series), 0.0)[:2]
    if b * most >= 1:
        return np.inf
    return cast("float", max(most, (a * most / (1 - b * most))**0.5))
