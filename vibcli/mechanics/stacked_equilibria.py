"""The equilibria of a scene at many values of its parameters, by arrays, from places near each.

Newton's method on r(q) = 0. Its end is off by δq ≤ |K⁻¹| (|r| + δr) + ε |q|, δr being the rounding of the terms of r;
so much M, C and K there are off by |∂M/∂q| δq, …, which is added to the sizes that tell of their rounding.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.stacked_matrices import StackedMatrices, stacked_matrices

if TYPE_CHECKING:
    from vibcli.mechanics.linearisation import Linearisation

EPSILON = 2.0**-52
STEPS = 30
THERE = 4 * EPSILON     # of the figure: a step that moves nothing
ASIDE = 2.0**-20        # of the figure: how far slopes of M, C and K are looked for
KNOWN = 1e-11           # of the figure: an error beyond which the place is not settled
SAME_WAY = 0.2          # of a step to the next place: how far off it may be


class StackedEquilibria:
    """places: N × n, the coordinates `names` at rest; settled: N truths, has K a minimum of V there, whose place is
    known? scale: the size of the figure along each coordinate; near: N × n, where the search begins."""

    def __init__(self, form: "Linearisation", values: "Mapping[str, float | np.ndarray]", names: Sequence[str],
                 near: np.ndarray, scale: np.ndarray) -> None:
        self._form, self._values, self._names, self._scale = form, dict(values), list(names), scale
        self._count = len(near)
        with np.errstate(all="ignore"):
            self.places, self._at = self._followed(near)
            self.error, self.settled = self._known()

    def _followed(self, q: np.ndarray) -> tuple[np.ndarray, StackedMatrices]:
        for _ in range(STEPS):
            at = self._matrices(q)
            step = self._step(at)
            q = q + step
            if not (np.abs(step) > THERE * self._scale).any():
                break
        return q, self._matrices(q)

    def _matrices(self, q: np.ndarray) -> StackedMatrices:
        here = {name: q[:, i] for i, name in enumerate(self._names)}
        return stacked_matrices(self._form, {**self._values, **here}, self._count)

    def _step(self, at: StackedMatrices) -> np.ndarray:
        """−K⁻¹ r."""
        found: np.ndarray = -(self._flexibility(at.K) @ at.residual[:, :, None])[:, :, 0]
        return found

    def _flexibility(self, K: np.ndarray) -> np.ndarray:
        """K⁻¹ of each, of what the figure's size along the coordinates makes alike; zero where it has none."""
        felt = K * self._scale[:, None] * self._scale
        usable = np.isfinite(felt).all((1, 2))[:, None, None]
        found: np.ndarray = np.linalg.pinv(np.where(usable, felt, 0.0)) * self._scale[:, None] * self._scale
        return found

    def _known(self) -> tuple[np.ndarray, np.ndarray]:
        """(the error of each place, may it be relied on?)"""
        at = self._at
        left = np.abs(at.residual) + EPSILON * (at.terms + 4) * at.residual_size
        error = (np.abs(self._flexibility(at.K)) @ left[:, :, None])[:, :, 0] + EPSILON * np.abs(self.places)
        felt = at.K * self._scale[:, None] * self._scale
        stable = np.isfinite(felt).all((1, 2)) & (felt == felt.transpose(0, 2, 1)).all((1, 2))
        stable &= np.linalg.eigvalsh(np.where(stable[:, None, None], felt, 0.0))[:, 0] > 0
        return error, stable & (error <= KNOWN * self._scale).all(1)

    def matrices(self) -> StackedMatrices:
        """M, C, K there, what the error of the place makes them uncertain by among the sizes of their terms."""
        found = self._at
        sizes = [found.M_size.copy(), found.K_size.copy(), found.C_size.copy()]
        with np.errstate(all="ignore"):
            for i, unit in enumerate(np.eye(len(self._names)) * (ASIDE * self._scale)):
                beside = self._matrices(self.places + unit)
                share = (self.error[:, i] / (unit[i] * EPSILON))[:, None, None]
                for size, one, other in zip(sizes, (beside.M, beside.K, beside.C), (found.M, found.K, found.C),
                                            strict=True):
                    size += np.abs(one - other) * share
        M_size, K_size, C_size = sizes
        return found._replace(M_size=M_size, K_size=K_size, C_size=C_size)

    def follow(self, before: np.ndarray) -> bool:
        """Does each place lead on to from that with the number `before`, −1 of none: is one step of Newton's method
        from there, with the values here, the way here but for a part?"""
        numbers = np.flatnonzero(before >= 0)
        start = self.places.copy()
        start[numbers] = self.places[before[numbers]]
        with np.errstate(all="ignore"):
            step = self._step(self._matrices(start))
            off = np.abs(start + step - self.places) / self._scale
            way = np.abs(step / self._scale).max(1, keepdims=True)
        return bool((off <= SAME_WAY * way + KNOWN).all())
