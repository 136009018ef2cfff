"""Complex frequencies of members, polished: λ with D(λ) x = 0 from an estimate, with a bound.

Newton's method for the whole matrix: (D(s) + δ D′(s)) x = 0 has a δ that leads from s to the nearest λ (A. Ruhe 1973).
At the last, vectors x and w of D x = 0, wᴴ D = 0 give λ to rounding; what rounds in D is |ΔD_ij| ≤ E √(size_i size_j).
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.argument_count import newton_steps, sizes
from vibcli.analyses.continuous.counting import GUARD, SLACK
from vibcli.analyses.continuous.dynamic_matrix import BLOWN, SHARES
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.retardation import reaction_rate, retarded_reaction

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix, EvaluatedMatrix

STEPS, SETTLED = 30, 1e-9
NEARLY = 1e-6       # a relative step towards a root next to another one, where no step is as short as a settled one
UNIT = 2.0**-53
GIVEN = 2.0         # roundings of a damper beside √(Nμ), as they are given
ALIKE = 1e-7        # relative distance below which roots are looked at together
CLOSE = 1e-8        # relative bound of a root beyond which another may be next to it,
AROUND, WIDER, PLACES = 1e-5, (1, 10, 100), 16     # on a circle about which, at so many places, both are seen,
SPLIT = 0.05        # of its radius: how far they are from their middle at most
NONE = 1e-8         # of D: what a shape at the middle of such roots leaves of it
FLAT = 1e-6         # of κ: so near the real axis the energy of a piece is that of its slope


class DampedRoot(NamedTuple):
    """λ, the bound of its relative error, and the shape over the coordinates of the scene, of unit kinetic energy."""

    value: complex
    error: float
    shape: np.ndarray


class Whole:
    """A matrix, and the same with nodes within its pieces where it is too large near a frequency of one held."""

    def __init__(self, matrix: "DynamicMatrix") -> None:
        self.matrix, self._divided = matrix, {}

    def at(self, s: complex) -> "EvaluatedMatrix":
        """D and D′ at s, of the matrix, or that with nodes where its pieces are smallest."""
        with np.errstate(all="ignore"):
            found = self.matrix.at(np.array([complex(s)]), steep=True)
            if found.excess[0] <= BLOWN and self.matrix.n:
                return found
            others = [self._by(share).at(np.array([complex(s)]), steep=True) for share in SHARES]
        candidates = [found, *others] if self.matrix.n else others
        return min(candidates, key=lambda one: np.nan_to_num(one.excess[0], nan=np.inf))

    def _by(self, share: float) -> "DynamicMatrix":
        if share not in self._divided:
            self._divided[share] = self.matrix.divided(share)
        return cast("DynamicMatrix", self._divided[share])


def approached(whole: Whole, s: complex) -> complex | None:
    """The root to which Newton's steps lead from s; None where they do not settle. On the real axis they never do next
    to two that are conjugate: then from aside."""
    found, last = _followed(whole, s)
    if found is None and last is not None and not last.imag:
        found = _followed(whole, last * (1 + 1j * NEARLY))[0]
    return found


def _followed(whole: Whole, s: complex) -> tuple[complex, complex]:
    """(the root, the place of the last step), None where there is none."""
    shortest, best = NEARLY, None
    for _ in range(STEPS):
        D, slope, _ = _scaled(whole.at(s), s)
        if not np.isfinite(D).all():
            return None, None
        step = newton_steps(D, slope)
        if not len(step):
            return None, None
        step = step[np.argmin(abs(step))]
        s = complex(s + step)
        if abs(step) <= shortest * abs(s):
            shortest, best = abs(step) / abs(s), s if s.imag >= 0 else s.conjugate()
            if shortest <= SETTLED:
                break
    return best, s


def roots_at(whole: Whole, s: complex) -> list[DampedRoot]:
    """All roots that coincide at s, or nearly do, each with its bound; none where that does not tell. Of those with few
    shapes, as where damping is critical, these are those of their middle."""
    found = whole.at(s)
    D, slope, scale = _scaled(found, s)
    left, _, right = np.linalg.svd(D)
    aside = _scaled(whole.at(s * (1 + ALIKE)), s)
    several = max(1, int((abs(newton_steps(*aside[:2])) < 3 * ALIKE * abs(s)).sum()))
    w, x = left[:, -several:], right[-several:].conj().T
    try:
        away = np.linalg.eigvals(np.linalg.solve(w.conj().T @ slope @ x, -(w.conj().T @ D @ x)))
        gain = np.linalg.norm(np.linalg.inv(w.conj().T @ slope @ x), 2)
    except np.linalg.LinAlgError:       # det D has a zero of higher order there
        return _close(whole, s)
    spread = (abs(w).sum(axis=0) ** 2).sum() ** 0.5 * (abs(x).sum(axis=0) ** 2).sum() ** 0.5
    given = np.sqrt(found.given[:, 0]) * scale
    felt = ((given @ abs(w)) ** 2).sum() ** 0.5 * ((given @ abs(x)) ** 2).sum() ** 0.5
    error = UNIT * (SLACK * GUARD * spread + GIVEN * felt) * gain / abs(s) + 4 * UNIT
    out = [] if error < CLOSE else _close(whole, s)
    for i, step in enumerate(away if not out else ()):
        value = complex(s + step)
        shape = (scale * x[:, i])[:whole.matrix.n]
        out.append(DampedRoot(value, float(error), shape / _kinetic(found, scale * x[:, i], value)))
    return out


def _close(whole: Whole, s: complex) -> list[DampedRoot]:
    """Roots with fewer shapes than they are that lie close together next to s; those of several shapes may lie further
    apart than those of one, whose Newton's steps part them. None where there are not several."""
    for wider in WIDER:
        middle, many = _together(whole, s, wider * AROUND)
        if many >= (2 if wider == 1 else 3):
            error = 2 * SPLIT * wider * AROUND
            return [DampedRoot(middle, error, shape) for shape in _shapes(whole, middle, many)]
    return []


def _shapes(whole: Whole, s: complex, many: int) -> list[np.ndarray]:
    """What D(s) nearly takes to 0, one for each of so many roots."""
    found = whole.at(s)
    D, _, scale = _scaled(found, s)
    _, sizes, right = np.linalg.svd(D)
    m = int(np.clip((sizes < NONE * sizes[0]).sum(), 1, many // 2))
    vectors = [scale * right[-1 - min(k * m // many, m - 1)].conj() for k in range(many)]
    return [x[:whole.matrix.n] / _kinetic(found, x, s) for x in vectors]


def _together(whole: Whole, s: complex, around: float) -> tuple[complex, int]:
    """(their middle, how many there are) of roots next to s: with (ln det D)′ = tr D⁻¹D′ on a circle about it,

        Σ (λ − s)ᵏ = (1/2πi) ∮ (z − s)ᵏ tr D⁻¹D′ dz,

    0 where they are not well within it."""
    steps = around * abs(s) * np.exp(2j * np.pi * (np.arange(PLACES) + 0.5) / PLACES)
    traces = []
    for z in s + steps:
        D, slope, _ = _scaled(whole.at(z), z)
        try:
            traces.append(np.trace(np.linalg.solve(D, slope)))
        except np.linalg.LinAlgError:
            return s, 0
    if not np.isfinite(traces).all():
        return s, 0
    count, first, second = (complex(np.mean(steps**k * traces)) for k in (1, 2, 3))
    many = round(count.real)
    if many < 2 or abs(count - many) > SPLIT or abs(second / many - (first / many)**2) > (SPLIT * around * abs(s))**2:
        return s, 0
    return s + first / many, many


def _scaled(found: "EvaluatedMatrix", s: complex) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """D and D′ with a unit for each coordinate in which what its diagonal was added from is 1; these units."""
    scale = 1 / np.sqrt(np.maximum(sizes(found, s)[:, 0], 1e-300))
    D, slope = (part[:, :, 0] * scale[:, None] * scale for part in (found.D, found.slope))
    return D, slope, scale


def _kinetic(found: "EvaluatedMatrix", x: np.ndarray, s: complex) -> float:
    """√(xᴴ M x + Σ μ ∫|u|² dx)."""
    energy = float((x.conj() @ found.matrix.polynomial[2] @ x).real)
    for stack, (d, slope) in zip(found.matrix.stacks, found.ends, strict=True):
        at, beta = np.array([s]), stack.beta
        kappa, flow = retarded_reaction(stack.piece, at, beta), reaction_rate(stack.piece, at, beta)
        factor = 1 + beta * s
        for p, rows in enumerate(stack.ends):
            u = np.array([sum(float(c) * x[i] for i, c in row.items()) for row in rows], complex)
            plain, own = abs(kappa[p, 0].imag) <= FLAT * abs(kappa[p, 0]), d[:, :, p, 0] / factor[p, 0]
            steep = (slope[:, :, p, 0] - beta[p, 0] * own) / (factor[p, 0] * flow[p, 0])
            form = steep.real if plain else own.imag / kappa[p, 0].imag
            energy += float(stack.piece.inertia[p, 0]) * float((u.conj() @ form @ u).real)
    return np.sqrt(energy) if energy > 0 else float(np.linalg.norm(x)) or 1.0
