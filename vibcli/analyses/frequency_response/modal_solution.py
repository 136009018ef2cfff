"""D⁻¹ of many degrees of freedom by modes, and what they miss of H(s) put right by one residual.

    ẏ = A y,  A W = W B,  W real:   D⁻¹ = R (s − B)⁻¹ L,   B = [σ, ω; −ω, σ] for a pair λ = σ ± iω,

or D⁻¹ = Φ (s² + 2ζω s + ω²)⁻¹ Φᵀ where damping does not couple the modes. For a given b all is a sum of the same
functions of s, x = X f(s), and so is r = b − D x: what the modes miss of A W = W B, of rounding's size from the start.
With y = Y f(s) for D⁻ᵀc,

    H = cᵀx + yᵀr + d,     off by (D⁻ᵀc − y)ᵀ r <= β² |D⁻¹| |x| |y|,     β = |r|/|x| of scaled coordinates,

besides the rounding of the sum. A frequency at which that is more than rounding of Σ |yᵢ| |Dᵢᵢ| |xᵢ| is left to LU, as
is one at which a far end of a chain hardly feels the other, so that this sum is lost in |x| |y|. What is put right and
told is some 10⁻⁷ of itself off in single precision.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.direct import SINGULAR, repaired
from vibcli.analyses.frequency_response.modes_of_matrices import TURNED, coupled, decoupled, reduced_to_unit_mass
from vibcli.analyses.frequency_response.quadratics import polynomial, slope

if TYPE_CHECKING:
    pass

ROUNDING = 2.0**-51
SINGLE = 2.0**-20       # what single precision makes of a product, relative
BLOCK = 2.0**15         # frequencies times modes that are summed at once


def modal_solution(system: Any, otherwise: Any, most: float = np.inf) -> "ModalSolution | None":
    """The solution that leaves to another method what it loses; None where M is not positive definite, where the modes
    are nearly dependent, and where there are more than so many degrees of freedom and damping couples them."""
    reduced = reduced_to_unit_mass(system)
    if reduced is None:
        return None
    found = decoupled(system, reduced)
    if found is not None:
        return ModalSolution(system, otherwise, DecoupledModalSum(system, *found))
    asked = [part for coefficients in (system.b, system.c) for *_, part in _terms(coefficients)]
    modes = coupled(system, reduced, asked) if system.n <= most else None
    return modes and ModalSolution(system, otherwise, CoupledModalSum(system, *modes))


class DecoupledModalSum:
    """Modes that damping does not couple: f = 1/(s² + 2ζω s + ω²), and s times as much."""

    def __init__(self, system: Any, squares: np.ndarray, rates: np.ndarray, shapes: np.ndarray) -> None:
        self.squares, self.rates, self.shapes, self.inertia = squares, rates, shapes, system.M @ shapes
        self.missed = system.K @ shapes - self.inertia * squares, system.C @ shapes - self.inertia * rates
        self.pace = np.sqrt(max(np.abs(squares).max(), np.finfo(float).tiny))

    def functions(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(how near s is to a pole, f), (N,) and (m, N)."""
        squares, rates = self.squares[:, None], self.rates[:, None]
        stiffness = squares + s * (rates + s)
        near = np.sqrt(_squared(stiffness) / (np.abs(squares) + _squared(s))**2).min(axis=0)
        along = 1 / stiffness
        return near, np.concatenate([along, s * along])

    def slopes(self, s: np.ndarray, f: np.ndarray) -> np.ndarray:
        """df/ds."""
        along = f[:len(self.squares)]
        steep = -(2 * s + self.rates[:, None]) * along * along
        return np.concatenate([steep, along + s * steep])

    def driven(self, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """X, (n, m), and [what r is more of f, 1, s], (n, m + 2)."""
        share, none = self.shapes.T @ b, np.zeros((len(b), 1))
        missed = np.hstack([-self.missed[0] * share, -self.missed[1] * share])
        return self.seen(b), np.hstack([missed, (b - self.inertia @ share)[:, None], none])

    def seen(self, c: np.ndarray) -> np.ndarray:
        """Y, (n, m)."""
        return np.hstack([self.shapes * (self.shapes.T @ c), np.zeros(self.shapes.shape)])


class CoupledModalSum:
    """Pairs and real eigenvalues: f = Re and Im of 1/(s − λ), as functions of s, and 1/(s − λ) of real ones. left:
    (m, n), None where D is the same as Dᵀ; shares: L of b and c."""

    def __init__(self, system: Any, pairs: np.ndarray, real: np.ndarray, right: np.ndarray, left: np.ndarray | None,
                 shares: Any, pace: float) -> None:
        self.pairs, self.real, self.right, self.left, self.shares, self.pace = pairs, real, right, left, shares, pace
        velocity, self.inertia = self._turned(right), system.M @ right
        self.momentum = system.C @ right + system.M @ velocity
        self.missed = system.K @ right + self._turned(self.momentum)

    def _turned(self, of_modes: np.ndarray) -> np.ndarray:
        """The product with B."""
        first, second, alone = self._parts(of_modes)
        straight, across = self.pairs.real, self.pairs.imag
        return np.hstack([first * straight - second * across, first * across + second * straight, alone * self.real])

    def _parts(self, of_modes: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        count = len(self.pairs)
        return of_modes[..., :count], of_modes[..., count:2 * count], of_modes[..., 2 * count:]

    def _spread(self, of_modes: np.ndarray, share: np.ndarray, sign: int = 1) -> np.ndarray:
        """The coefficients of f in (s − B)⁻¹ of shares, or with −1 of Bᵀ."""
        (first, second, alone), (one, two, three) = self._parts(of_modes), self._parts(share)
        return np.hstack([first * one + second * two, sign * (first * two - second * one), alone * three])

    def functions(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(how near s is to a pole, f), (N,) and (m, N)."""
        pairs, real, count = self.pairs[:, None], self.real[:, None], len(self.pairs)
        ahead, alone, size = s - pairs, s - real, np.sqrt(_squared(s))
        above = ahead if (s.imag >= 0).all() else np.where(s.imag < 0, s.conj(), s) - pairs
        near = np.sqrt(np.concatenate([_squared(above) / (size + np.abs(pairs))**2,
                                       _squared(alone) / (size + np.abs(real))**2]).min(axis=0))
        f = np.empty((2 * count + len(real), len(s)), complex)
        f[count:2 * count] = 1 / (ahead * (s - pairs.conj()))
        f[:count] = (s - pairs.real) * f[count:2 * count]
        f[count:2 * count] *= pairs.imag
        f[2 * count:] = 1 / alone
        return near, f

    def slopes(self, s: np.ndarray, f: np.ndarray) -> np.ndarray:
        """df/ds."""
        (straight, across, alone) = (part.T for part in self._parts(f.T))
        return np.concatenate([across**2 - straight**2, -2 * straight * across, -alone**2])

    def driven(self, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """X, (n, m), and [what r is more of f, 1, s], (n, m + 2)."""
        share = self.shares(b)
        rest = b - self.momentum @ share, -self.inertia @ share
        return self._spread(self.right, share), np.hstack([-self._spread(self.missed, share), np.stack(rest, axis=1)])

    def seen(self, c: np.ndarray) -> np.ndarray:
        """Y, (n, m)."""
        if self.left is None:
            found: np.ndarray = self._spread(self.right, self.shares(c))
            return found
        return self._spread(self.left.T, self.right.T @ c, -1)


class ModalSolution:
    """H of what DecoupledModalSum or CoupledModalSum tell."""

    __slots__ = ("modes", "otherwise", "rows", "scales", "single", "sizes", "x", "y")

    def __init__(self, system: Any, otherwise: Any, modes: Any) -> None:
        self.otherwise, self.modes, pace = otherwise, modes, modes.pace
        driven = [(power, factor, *modes.driven(part)) for power, factor, part in _terms(system.b)]
        self.x = [(power, factor, X) for power, factor, X, _ in driven]
        self.y = [(power, factor, modes.seen(part)) for power, factor, part in _terms(system.c)]
        self.rows = [(k + j, f * g, c @ X) for j, g, c in _terms(system.c) for k, f, X in self.x]
        none = np.zeros((system.n, 2))
        parts = [[pace**k * np.hstack([X / pace, none]) for k, _, X in self.x],
                 [pace**k * np.hstack([Y / pace, none]) for k, _, Y in self.y],
                 [pace**k * missed * np.append(np.full(X.shape[1], 1 / pace), [1.0, pace])
                  for k, _, X, missed in driven]]
        self.scales = [max(np.abs(part).max() for part in group) or 1.0 for group in parts]
        self.single = np.vstack([part / scale for group, scale in zip(parts, self.scales, strict=True)
                                 for part in group]).astype(np.float32)
        self.sizes = np.abs(np.stack([np.diag(matrix) for matrix in (system.K, system.C, system.M)], axis=1))

    def __call__(self, system: Any, s: np.ndarray,
                 steep: bool = False) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        """(H, dH/ds or None, whether there is a pole)."""
        with np.errstate(all="ignore"):
            found = [self._values(part, steep) for part in self._parts(s)]
        values, slopes, lost = zip(*found, strict=True)
        values = np.concatenate(values) + polynomial(system.d, s)
        slopes = np.concatenate(slopes) + slope(system.d, s) if steep else None
        return repaired(system, s, values, slopes, np.flatnonzero(np.concatenate(lost)), self.otherwise)

    def fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc), (N, n) each."""
        with np.errstate(all="ignore"):
            found = [self._fields(part) for part in self._parts(s)]
        x, y, lost = (np.concatenate([part[k] for part in found]) for k in range(3))
        if lost.any():
            x[lost], y[lost] = self.otherwise.fields(system, s[lost])
        return x, y

    def _parts(self, s: np.ndarray) -> list[np.ndarray]:
        many = max(1, int(BLOCK / self.single.shape[1]))
        return [s[k:k + many] for k in range(0, max(len(s), 1), many)]

    def _fields(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        near, f = self.modes.functions(s)
        x, y = (_sum(terms, s, [_times(part, f) for *_, part in terms]).T for terms in (self.x, self.y))
        return x, y, self._told(s, near, f)[1]

    def _values(self, s: np.ndarray, steep: bool) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        near, f = self.modes.functions(s)
        missed, lost = self._told(s, near, f)
        values, slopes = _sum(self.rows, s, [row @ f for *_, row in self.rows]) + missed, None
        if steep:
            turned = self.modes.slopes(s, f)
            slopes = _sum(self.rows, s, [row @ turned for *_, row in self.rows])
            slopes += _sum([(k - 1, k * factor) for k, factor, _ in self.rows if k], s,
                           [row @ f for k, _, row in self.rows if k])
        return values, slopes, lost

    def _told(self, s: np.ndarray, near: np.ndarray, f: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(yᵀr, whether something else than rounding may be left of each H): x and y may be off by β/near of their
        size."""
        at, (_, y0, r0) = s / self.modes.pace, self.scales
        single = np.concatenate([f * self.modes.pace, np.ones((1, len(s))), at[None]]).astype(np.complex64)
        parts = list(_times(self.single, single).reshape(-1, len(self.sizes), len(s)))
        driven, seen = len(self.x), len(self.x) + len(self.y)
        x, y, missed = (_sum(terms, at.astype(np.complex64), of) for terms, of in (
            (self.x, parts[:driven]), (self.y, parts[driven:seen]), (self.x, parts[seen:])))
        lost = self._lost(s, x, y, missed, near, np.abs(single[:-2]))
        return y0 * r0 * (y * missed).sum(axis=0).astype(complex), lost

    def _lost(self, s: np.ndarray, x: np.ndarray, y: np.ndarray, missed: np.ndarray, near: np.ndarray,
              f: np.ndarray) -> np.ndarray:
        x0, y0, r0 = self.scales
        Omega = np.sqrt(_squared(s))
        size = self.sizes @ np.stack([np.ones(len(s)), Omega, Omega**2])
        largest = size.max(axis=0)
        size = (size / largest).astype(np.float32)
        x, y, missed = _squared(x) * size, _squared(y) * size, _squared(missed) / size
        told = np.sqrt(x * y).sum(axis=0).astype(float) * x0 * y0 * largest
        x, y, missed = (part.sum(axis=0).astype(float) for part in (x, y, missed))
        together, beta = np.sqrt(x * y) * x0 * y0 * largest, np.sqrt(missed / x) * r0 / x0 / largest
        summed = sum(Omega**k * (np.abs(row).astype(np.float32) @ f) for k, _, row in self.rows) / self.modes.pace
        told -= 2 * beta / near * together
        small = ((beta + TURNED) / near + SINGLE) * beta * together <= ROUNDING * told
        found: np.ndarray = (near <= 64 * SINGULAR) | ((missed != 0) & ~(small & (summed <= len(self.sizes) * told)))
        return found


def _terms(coefficients: np.ndarray) -> list[tuple[int, complex, np.ndarray]]:
    """[(power of s, 1 or i, real coefficients)], as many as are not zero, at least one."""
    found = [(power, factor, part) for power, whole in enumerate(coefficients)
             for factor, part in ((1.0, whole.real), (1j, whole.imag)) if part.any()]
    return found or [(0, 1.0, np.zeros(len(coefficients[0])))]


def _sum(terms: Sequence[tuple[Any, ...]], s: np.ndarray, parts: Sequence[np.ndarray]) -> Any:
    """Σ factor sᵏ part."""
    return sum(part if not power and factor == 1.0 else s.dtype.type(factor) * s**power * part
               for (power, factor, *_), part in zip(terms, parts, strict=True))


def _squared(x: np.ndarray) -> np.ndarray:
    found: np.ndarray = x.real**2 + x.imag**2
    return found


def _times(matrix: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A real matrix times complex columns."""
    found: np.ndarray = (matrix @ x.view(x.real.dtype)).view(x.dtype)
    return found
