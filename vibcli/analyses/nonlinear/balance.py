"""Harmonics that obey the equations of motion at as many places, by Newton's method, and how well they know ω.

r(θⱼ) = 0 at θⱼ = π j/N, j = 0 … N, with one condition more, closes the N + 1 coefficients of each coordinate and ω; of
equations that are odd in the deviations odd harmonics and a quarter of the period suffice. At
twice as many places r does not vanish; with J y = e_ω of the equations there the error of ω is at most Σ |y| |r|, to
first order, r being found in long doubles and bounds of what rounding leaves of it being added.
"""

from collections.abc import Callable

import numpy as np

from vibcli.analyses.nonlinear.free_equations import FreeEquations
from vibcli.analyses.nonlinear.harmonics import CosineMotion, cosines
from vibcli.base.named_tuple import NamedTuple

STEPS = 8
CLOSE, LAST = 1e-5, 1e-10           # relative changes: the next step is the last one, none is needed
SAFE = 2.0
PLACES = (0.0, 0.4, 1.0)       # of the way, where rounding is looked at


class ClosingCondition(NamedTuple):
    """A condition: its value, which is to vanish, and its slopes by the coefficients and by w."""

    value: float
    by_a: np.ndarray
    by_w: float


class ConvergedMotion(NamedTuple):
    """A motion, its change by the right side of the closing condition as (a, w), and how far Newton's steps went."""

    motion: CosineMotion
    tangent: CosineMotion
    moved: float


class HarmonicBalance:
    """The equations of one family; `scale`: ωᵢ of its linear mode."""

    def __init__(self, equations: FreeEquations, number: int) -> None:
        self.equations, self.number, self.scale = equations, number, float(equations.omegas[number])
        self.harmonics = slice(1, None, 2) if equations.odd else slice(None)    # those that a motion has

    def solved(self, start: CosineMotion,
               closing: "Callable[[CosineMotion], ClosingCondition]") -> ConvergedMotion | None:
        """The motion that meets a condition, from one near it; None where Newton's steps do not close in."""
        motion, last = start, np.inf
        for _ in range(STEPS):
            J, right = self._system(motion, closing(motion))
            try:
                found = np.linalg.solve(J, right)
            except np.linalg.LinAlgError:
                return None
            step, tangent = (self._motion(column, motion) for column in found.T)
            motion = CosineMotion(motion.a + step.a, motion.w + step.w)
            change = step.size / motion.size + abs(step.w / motion.w) if motion.size else np.inf
            if not change < max(2.0, 4 * last) or not motion.w > 0:
                return None
            if change <= (CLOSE if last < 1e-2 else LAST):
                return ConvergedMotion(motion, tangent, _apart(motion, start))
            last = change
        return None

    def _system(self, motion: CosineMotion, closing: ClosingCondition, finer: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """[J; closing] and its right sides: −(r, closing), and 1 in the last row. finer: so many times the places."""
        harmonics = len(motion.a) - 1
        cells = finer * harmonics
        n, table = self.equations.n, cosines(cells, cells, odd=self.equations.odd)
        a = motion.with_harmonics(cells).a[self.harmonics]
        eta, slope, bend = (a.T @ part for part in table)
        found = self.equations.slopes(self.scale, motion.w, eta, slope, bend)
        count = len(a) * n
        J = np.empty((count + 1, count + 1))
        block = J[:-1, :-1].reshape(len(a), n, len(a), n)
        for part, basis, factor in ((found.mass, table.bend, motion.w**2), (found.stiffness, table.value, 1.0),
                                    (found.damping, table.slope, motion.w)):
            if basis is table.slope and not part.any():
                continue
            grown = (factor * part).transpose(2, 0, 1)[:, :, None, :] * basis.T[:, None, :, None]
            if basis is table.bend:
                block[...] = grown
            else:
                block += grown
        J[:-1, -1] = found.by_w.T.ravel()
        J[-1, :-1] = CosineMotion(closing.by_a, 0.0).with_harmonics(cells).a[self.harmonics].ravel()
        J[-1, -1] = closing.by_w
        right = np.zeros((count + 1, 2))
        right[:-1, 0], right[-1] = -found.residual.T.ravel(), (-closing.value, 1.0)
        return J, right

    def _motion(self, column: np.ndarray, like: CosineMotion) -> CosineMotion:
        a = np.zeros(like.a.shape)
        a[self.harmonics] = column[:-1].reshape(-1, like.a.shape[1])
        return CosineMotion(a, float(column[-1]))

    def refined(self, motion: CosineMotion, closing: "Callable[[CosineMotion], ClosingCondition]") -> CosineMotion:
        """By a last step from r in long doubles."""
        condition = closing(motion)
        J, right = self._system(motion, condition)
        right[:-1, 0] = -self._residual(motion, 1).ravel()
        step = self._motion(np.linalg.solve(J, right[:, 0]), motion)
        return CosineMotion(motion.a + step.a, motion.w + step.w)

    def _residual(self, motion: CosineMotion, finer: int) -> np.ndarray:
        """r in long doubles, of shape (places, n)."""
        harmonics = len(motion.a) - 1
        table = cosines(harmonics, finer * harmonics, True, self.equations.odd)
        eta, slope, bend = (motion.a[self.harmonics].T @ part for part in table)
        found = self.equations.residual(self.scale, np.longdouble(motion.w), eta, slope, bend)
        return np.asarray(found.T, float)

    def error(self, motion: CosineMotion, closing: "Callable[[CosineMotion], ClosingCondition]") -> float:
        """A bound of the relative error of ω."""
        J, _ = self._system(motion, closing(motion), 2)
        unit = np.zeros(len(J))
        unit[-1] = 1.0
        try:
            y = np.abs(np.linalg.solve(J.T, unit))
        except np.linalg.LinAlgError:
            return np.inf
        left = np.abs(self._residual(motion, 2)) + self._rounding(motion)
        own = 4 * 2.0**-52
        condition = float((closing(motion).by_a * motion.a).sum())
        total = float(y[:-1] @ left.ravel()) + float(y[-1]) * own * abs(condition)
        return SAFE * total / motion.w + own if np.isfinite(total) else np.inf

    def _rounding(self, motion: CosineMotion) -> np.ndarray:
        """Of r, the largest of some places, of shape (n,)."""
        k = np.arange(len(motion.a))
        found = []
        for share in PLACES[:2] if self.equations.odd else PLACES:
            angle = np.pi * share * k
            rows = np.cos(angle), -k * np.sin(angle), -k * k * np.cos(angle)
            found.append([motion.a.T @ row for row in rows])
        result: np.ndarray = np.max([self.equations.rounding(self.scale, motion.w, *one) for one in found], axis=0)
        return result

    def energy(self, motion: CosineMotion) -> float:
        """Above that of the equilibrium [J]: V at the end of the way."""
        return self.equations.energy(motion.a.sum(axis=0))


def _apart(one: CosineMotion, other: CosineMotion) -> float:
    return float(np.linalg.norm(one.a - other.a) / one.size + abs(one.w - other.w) / one.w)
