"""Damped modes of ratios beside dampers C = U Λ Uᵀ, as far as a RatedExpansion H tells: the zeros of

    det(Λ⁻¹ + s Uᵀ H(s)) Π q(s)

Near an eigenvalue of a mode without dampers this mode is taken out of H, as |ψ|² may be small or 0:

    E = [[Λ⁻¹/s + Uᵀ H′, ψ], [ψᵀ, −q]].

With σ the singular values of Q^½ D⁻¹ Q^½, D = Λ⁻¹ + s Uᵀ H, arg det D changes by at most −Σ ln(1 − σ) where every step
of xᴴ D y is at most √(xᴴQx · yᴴQy): Q = Σ ψ ψᵀ |Δ(s/q)| of the modes that are taken one by one, and of all others,
whose |q| > 0.36 ω² and |ω² − s²| < 1.16 ω², 9 |Δs| Uᵀ H(0).
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.argument_count import newton_steps, turned
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.rated_expansion import RatedExpansion

STEPS, SETTLED = 30, 1e-10
NEAR = 0.3          # of ω² + |s|²: q of a mode that is taken out
ALIKE, SAME = 1e-7, 1e-9    # relative distance of roots that are looked at together, and of those found twice
UNIT, SLACK = 2.0**-52, 8.0
STEEP = 9.5         # of |Δs| along an arc, of the modes that are not taken one by one
ARCS, MOST = 16, 20_000
WIDER = 1.2         # times the radius: eigenvalues that are polished


class RatedRoot(NamedTuple):
    """λ, the bound of its relative error, its shape over coordinates."""

    value: complex
    error: float
    shape: np.ndarray


class RatedRoots:
    """given: the RatedExpansion; rates: Λ."""

    def __init__(self, given: "RatedExpansion", rates: np.ndarray) -> None:
        self.given, self.rates, self.count = given, rates, len(rates)
        self._static = np.einsum("ir,is->rs", given.U, given.smooth(np.zeros(1))[:, :, 0].real)

    def estimates(self) -> np.ndarray:
        """Eigenvalues, Im ≥ 0, of the modes one by one and what all others answer at rest."""
        from scipy.linalg import eig

        given, r, N = self.given, self.count, len(self.given.omega)
        A, B = np.zeros((2, 2 * N + r, 2 * N + r))
        eta, v, f = np.arange(N), np.arange(N, 2 * N), np.arange(2 * N, 2 * N + r)
        pace = self.given.radius
        A[eta, v] = pace
        A[v, eta], A[v, v] = -given.omega**2 / pace, -given.c
        unit = 1 / np.sqrt(abs(np.diag(self._static)) + abs(1 / self.rates) / pace)
        A[np.ix_(v, f)] = given.psi.T * unit / pace
        A[np.ix_(f, f)] = -np.diag(unit**2 / self.rates)
        A[np.ix_(f, v)] = -unit[:, None] * given.psi * pace
        B[eta, eta] = B[v, v] = 1.0
        B[np.ix_(f, f)] = unit[:, None] * self._static * unit
        found = eig(A, B, right=False)
        found = found[np.isfinite(found) & (abs(found) < WIDER * pace)]
        found = np.where(abs(found.imag) < SAME * abs(found), found.real, found)
        return cast("np.ndarray", found[found.imag >= 0])

    def found(self, least: float) -> list[RatedRoot]:
        """All that estimates lead to, |λ| > least, each as often as it is one."""
        points: list[complex] = []
        for s in sorted(self.estimates(), key=abs):
            root = self._approached(complex(s)) if abs(s) > least else None
            if root is not None and least < abs(root) < WIDER * self.given.radius and not any(
                    abs(root - one) < ALIKE * abs(one) for one in points):
                points.append(root)
        return [one for s in points for one in self._at(s) if one.value.imag >= 0]

    def _approached(self, s: complex) -> complex | None:
        for _ in range(STEPS):
            E, slope, *_ = self._bordered(s)
            if not (np.isfinite(E).all() and np.isfinite(slope).all()):
                return None
            step = newton_steps(E, slope)
            if not len(step):
                return None
            step = step[np.argmin(abs(step))]
            s = s + step
            if not 0 < abs(s) < 2 * self.given.radius:
                return None
            if abs(step) <= SETTLED * abs(s):
                s = complex(s.real, 0.0) if abs(s.imag) < SAME * abs(s) else s
                return s if s.imag >= 0 else s.conjugate()
        return None

    def _bordered(self, s: complex) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """E, E′, bounds of the errors of E, and the numbers of the modes that are taken out."""
        given, r, at = self.given, self.count, np.array([s])
        q, q_slope = given.denominators(at)[:, 0], 2 * s + given.c
        out = np.flatnonzero(abs(q) < NEAR * (given.omega**2 + abs(s)**2) * (given.omega > 0))
        kept = np.setdiff1d(np.arange(len(q)), out)
        psi, n = given.psi, r + len(out)
        E, slope, lost = np.zeros((n, n), complex), np.zeros((n, n), complex), np.zeros((n, n))
        inner, border = np.ix_(range(r), range(r)), np.arange(r, n)
        own = psi[:, kept] / q[kept] @ psi[:, kept].T
        flow = -(psi[:, kept] * (q_slope[kept] / q[kept]**2)) @ psi[:, kept].T
        rest, change = (np.einsum("ir,is->rs", given.U, given.smooth(at, steep)[:, :, 0]) for steep in (False, True))
        E[inner] = np.diag(1 / self.rates / s) + own + rest
        slope[inner] = np.diag(-1 / self.rates / s**2) + flow + change
        doubt = given.unsure * 4 * given.omega**2 + SLACK * UNIT * (given.omega**2 + abs(s)**2 + given.c * abs(s))
        lost[inner] = np.diag(SLACK * UNIT / abs(self.rates * s)) + given.lost + (given.blurred[kept] / abs(
            q[kept])).sum() + abs(psi[:, kept]) * (doubt[kept] / abs(q[kept])**2) @ abs(psi[:, kept]).T
        E[:r, r:] = psi[:, out]
        E[r:, :r] = psi[:, out].T
        E[border, border], slope[border, border], lost[border, border] = -q[out], -q_slope[out], doubt[out]
        apart = given.blurred[out] / np.maximum(abs(psi[:, out]).max(axis=0), np.sqrt(given.blurred[out]) + 1e-300)
        lost[:r, r:] = apart
        lost[r:, :r] = apart[:, None]
        return E, slope, lost, out

    def _at(self, s: complex) -> list[RatedRoot]:
        """The RatedRoots that coincide at s, or nearly do."""
        E, slope, lost, out = self._bordered(s)
        unit = self._units(s, out)
        E, slope, lost = (part * unit[:, None] * unit for part in (E, slope, lost))
        left, _, right = np.linalg.svd(E)
        several = max(1, int((abs(newton_steps(E + ALIKE * s * slope, slope) + ALIKE * s) < 3 * ALIKE * abs(s)).sum()))
        w, x = left[:, -several:], right[-several:].conj().T
        small = w.conj().T @ slope @ x
        away, turn = np.linalg.eig(np.linalg.solve(small, -(w.conj().T @ E @ x)))
        gain = np.linalg.norm(np.linalg.inv(small), 2)
        error = gain * np.linalg.norm(abs(w).T @ lost @ abs(x), 2) / abs(s) + 4 * UNIT
        shapes = self._shapes(s, unit[:, None] * (x @ turn), out)
        return [RatedRoot(complex(s + step), float(error), shape) for step, shape in zip(away, shapes.T, strict=True)]

    def _units(self, s: complex, out: np.ndarray) -> np.ndarray:
        """In which entries of E are alike: (r + modes taken out,)."""
        given = self.given
        size = abs(1 / self.rates / s) + abs(np.diag(self._static))
        return cast("np.ndarray", 1 / np.sqrt(np.append(size, (given.omega**2 + abs(s)**2)[out])))

    def _shapes(self, s: complex, vectors: np.ndarray, out: np.ndarray) -> np.ndarray:
        """Displacements (n, vectors), of unit Σ|η|² over all modes."""
        given, r = self.given, self.count
        q = given.denominators(np.array([s]))[:, 0]
        kept = np.setdiff1d(np.arange(len(q)), out)
        eta = np.zeros((len(q), vectors.shape[1]), complex)
        eta[kept] = given.psi[:, kept].T @ vectors[:r] / q[kept][:, None]
        eta[out] = vectors[r:]
        found = given.shapes @ eta + given.smooth(np.array([s]))[:, :, 0] @ vectors[:r]
        others = [given.energy_of_others(s, one) for one in vectors[:r].T]
        return cast("np.ndarray", found / np.sqrt(np.linalg.norm(eta, axis=0)**2 + others))

    def zeros_within(self, radius: float) -> int | None:
        """How many there are in |s| < radius, conjugates and multiplicities counted; None where one is beside it."""
        turns = turned(self._phases, lambda t: radius * np.exp(1j * np.pi * t), ARCS, MOST)
        return None if turns is None else turns + int((abs(self.given.eigenvalues) < radius).sum())

    def _phases(self, s: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """det D/|det D|, and how far its argument can be from that within so long a step."""
        given, r = self.given, self.count
        with np.errstate(all="ignore"):
            D = np.moveaxis(s * given.at(s), -1, 0) + np.diag(1 / self.rates)
            away = np.prod([1 - step / abs(s - one[:, None]) for one in given.eigenvalues], axis=0)
            close = np.min([abs(s - one[:, None]) for one in given.eigenvalues], axis=0) <= step
            size = abs(s / given.denominators(s))
            moved = size * np.where(close, np.inf, (1 + step / abs(s)) / away - 1)
            room = np.einsum("am,bm,mk->kab", given.psi, given.psi, np.where(moved < 1e300, moved, 1e300))
            room = room + STEEP * step[:, None, None] * self._static
            rounding = abs(s) * (r * given.lost + r * (given.blurred[:, None] / abs(given.denominators(s))).sum(axis=0))
            room[:, range(r), range(r)] += rounding[:, None] + SLACK * UNIT * r * (
                abs(1 / self.rates) + (size.T @ (given.psi**2).T))
            usable = np.isfinite(D).all(axis=(1, 2)) & (abs(room) < 1e200).all(axis=(1, 2)) & ~close.any(axis=0)
            phase, change = np.ones(len(s), complex), np.full(len(s), np.inf)
            phase[usable] = np.linalg.slogdet(D[usable])[0]
            usable &= abs(phase) > 0.5
            values, basis = np.linalg.eigh(room[usable])
            root = basis * np.sqrt(np.maximum(values, 0))[:, None, :]
            sigma = np.linalg.svd(np.swapaxes(root, 1, 2) @ np.linalg.solve(D[usable], root + 0j), compute_uv=False)
            change[usable] = np.where(sigma.max(axis=1) < 1, -np.log1p(-sigma).sum(axis=1), np.inf)
        return phase, np.where(np.isfinite(change), change, np.inf)
