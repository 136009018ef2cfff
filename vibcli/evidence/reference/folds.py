"""Folds of equilibria to many digits, at which these resist a motion v no longer, in the unknowns (x, p, v),

    r(x, p) = 0,      ∂r/∂x v = 0,      v₀ᵀ v = 1,

with the forces at rest r of x = (q, λ) and v₀ about v (Moore and Spence 1980), by Newton's method in mpmath from what
floats know.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.sensitivities import rational
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.static_positions import StaticEquations, newton
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.node import Node

CLOSE = 1e-6        # relative: of p in floats and in more digits
STEPS = 12          # of Newton's method in floats


class FoldEquations:
    """Of a parameter's name; near: {coordinate or parameter: number} about where they meet."""

    def __init__(self, numeric: "NumericSystem", static: StaticEquations, name: str, near: Mapping[str, Any]) -> None:
        self.numeric, self.static, self.name = numeric, static, name
        self.n = len(static.names)
        slopes = [{symbol.name: slope for symbol, slope in gradient(r).items()} for r in static.residuals]
        ties, parts = static.names[self.n - len(static.parts.gaps):], static.parts.slopes
        for (k, i), slope in zip(parts, substitute(list(parts.values()), static.still), strict=True):
            slopes[i][ties[k]] = slope
        self._nodes = [*static.residuals, *(row.get(each, static.scene.table.zero) for row in slopes
                                            for each in static.names)]
        self._last: tuple[Any, ...] = (None, None)
        x, p = self._beside(near), float(near[name])
        pushed = np.array(self._forces(x, p, Floats)[1], dtype=float).reshape(self.n, self.n)
        self.v0 = np.linalg.svd(pushed)[2][-1].tolist()
        self.near = [*x, p, *self.v0]

    def _beside(self, near: Mapping[str, mpmath.mpf]) -> list[float]:
        """x in floats, of which coordinates that follow from others and forces of constraints are found by Newton's
        method, by least squares."""
        x, p = list(map(float, self.static.near)), float(near[self.name])
        left = [k for k, name in enumerate(self.static.names) if name not in near]
        for k, name in enumerate(self.static.names):
            x[k] = float(near.get(name, x[k]))
        for _ in range(STEPS if left else 0):
            r, J = (np.array(part, dtype=float) for part in self._forces(x, p, Floats))
            for k, step in zip(left, np.linalg.lstsq(J.reshape(self.n, self.n)[:, left], -r, rcond=None)[0],
                               strict=True):
                x[k] += float(step)
        return x

    def known(self, p: Any, arithmetic: Any) -> Mapping[str, Any]:
        """{parameter: number} with one value of its own."""
        key = p, mpmath.mp.prec
        if self._last[0] != key:
            given = {self.name: rational(p) if isinstance(p, mpmath.mpf) else Fraction(float(p))}
            self._last = key, self.numeric.sharing(given).values(arithmetic)
        return cast("Mapping[str, Any]", self._last[1])

    def residual(self, y: Sequence[Any], arithmetic: Any) -> list[Any]:
        """Of all unknowns."""
        n = self.n
        v = y[n + 1:]
        r, J = self._forces(y[:n], y[n], arithmetic)
        rows = [sum(J[i * n + k] * v[k] for k in range(n)) for i in range(n)]
        return [*r, *rows, sum(a * b for a, b in zip(self.v0, v, strict=True)) - 1]

    def read(self, node: "Node | None", y: Sequence[Any], arithmetic: Any) -> Any:
        """An expression of the coordinates there; of none the parameter."""
        if node is None:
            return y[self.n]
        still = {v.name: arithmetic.number(0) for v in self.static.scene.v}
        return evaluate([node], arithmetic, {**still, **self.known(y[self.n], arithmetic), **dict(zip(
            self.static.names, y[:self.n], strict=True))})[0]

    def _forces(self, x: Sequence[float | mpmath.mpf], p: float | mpmath.mpf,
                arithmetic: Any) -> tuple[list[float | mpmath.mpf], list[float | mpmath.mpf]]:
        found = evaluate(self._nodes, arithmetic, {**self.known(p, arithmetic), **dict(zip(
            self.static.names, x, strict=True))})
        return found[:self.n], found[self.n:]


def true_fold(fold: FoldEquations, node: "Node | None", size: float) -> TrueValues:
    """The parameter, or an expression of the coordinates there, whose digits count from a size on where it is less."""
    def found() -> "tuple[list[mpmath.mpf], float | mpmath.mpf]":
        arithmetic = multiprecision()
        y = list(newton(lambda *y: fold.residual(y, arithmetic), fold.near))
        if abs(y[fold.n] - fold.near[fold.n]) > CLOSE * abs(y[fold.n]):
            raise PhysicsError("the reference finds this fold elsewhere")
        value = fold.read(node, y, arithmetic)
        nothing = abs(value) <= size * mpmath.mpf(10) ** (-mpmath.mp.dps // 2)
        return [mpmath.mpf(0) if nothing else value], max(size, abs(value))

    return settled(found, limit=240, sized=True)
