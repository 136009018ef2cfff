"""Conditions of equilibrium r(q, p) = 0 with one parameter p free, and their exact derivatives.

One evaluation in dual numbers along (dq, dp) gives r, K = ∂r/∂q and the rates of both; dependent coordinates z follow
by closing their loops, G = 0:

    dr = K dq + ∂r/∂p dp        dK = Σ ∂K/∂qᵢ dqᵢ + ∂K/∂p dp        G_z dz = −G_q dq − G_p dp
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.limit_points.compiled_equations import CompiledEquilibrium
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.nonsmooth import KINKED
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.dual_numbers import Duals, dual, slope, value
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.dual_numbers import Dual

SAME = 1e-9         # relative: compiled and in dual numbers
UNDEFINED = (ArithmeticError, ValueError, PhysicsError, SpecError)


class Rates(NamedTuple):
    """r and K at a place in scaled coordinates, the sizes of the terms of r, and the rates of r and K."""

    r: np.ndarray
    K: np.ndarray
    size: np.ndarray
    dr: np.ndarray
    dK: np.ndarray


class ParametricEquilibrium:
    """r(q, p) of a scene. `names`: of the coordinates that forces hang on; `scale`: the size of the figure along each.
    Of coordinates q/scale the rows are r·scale, works. `bends`: may forces bend or jump?"""

    def __init__(self, numeric: "NumericSystem", name: str, rest: Mapping[str, float], loose: list[str]) -> None:
        self.numeric, self.name, self.rest = numeric, name, dict(rest)
        self.scene, self.loops = numeric.scene, numeric.scene.resting.loops
        every = self.scene.coordinates
        self.rows = [i for i, one in enumerate(every) if one not in loose]
        self.names = [every[i] for i in self.rows]
        self.scale = np.array([numeric.size_along(one) for one in self.names])
        self.angle = np.array([not numeric.system.dimension(one) for one in self.names])
        self.form = numeric.system.statics
        self.given = {one: x for one, x in numeric.given.items() if one != name}
        self.start, self.duals = numeric.floats[name], Duals(Floats)
        self.bends = bool(self.scene.table.called.intersection(KINKED) or self.scene.table.functions)

    @cached_property
    def _compiled(self) -> CompiledEquilibrium | None:
        """A CompiledEquilibrium; None where loops are to be closed, or it does not agree with dual numbers."""
        if self.loops is not None:
            return None
        q = np.array([self.rest[one] for one in self.names])
        try:
            found = CompiledEquilibrium(self.scene, self.form, self.name, self.rows, self.at_rest(self.start),
                                        self.rest)
            r, _, K, dr = found(q, self.start)
        except (*UNDEFINED, KeyError):
            return None
        known = self.rates(q / self.scale, self.start, None, 1.0, self.rest)
        outer = np.outer(self.scale, self.scale)
        agrees = known is not None and all(
            np.abs(one - other).max() <= SAME * max(np.abs(other).max(), largest) for one, other, largest in (
                (r * self.scale, known[0].r, known[0].size.max()), (K * outer, known[0].K, 0.0),
                (dr * self.scale, known[0].dr, 0.0)))
        return found if agrees else None

    def slopes(self, q: np.ndarray, p: float, near: Mapping[str, float]) -> tuple[Rates, dict[str, float]] | None:
        """(Rates by p without those of K, {coordinate: float}), as `rates` finds them; None where undefined."""
        if self._compiled is None:
            return self.rates(q, p, None, 1.0, near)
        try:
            r, size, K, dr = self._compiled(q * self.scale, p)
        except UNDEFINED:
            return None
        found = Rates(r * self.scale, K * np.outer(self.scale, self.scale), size * self.scale, dr * self.scale,
                      np.zeros_like(K))
        position = {**near, **{one: float(x) for one, x in zip(self.names, q * self.scale, strict=True)}}
        return (found, position) if all(np.isfinite(part).all() for part in found) else None

    def rates(self, q: np.ndarray, p: float, dq: "np.ndarray | None", dp: float,
              near: Mapping[str, float]) -> tuple[Rates, dict[str, float]] | None:
        """(Rates, {coordinate: float}) at a place, None where the forces are not defined. `near`: a position with
        closed loops near by."""
        try:
            return self._rates(q, p, dq, dp, near)
        except UNDEFINED:
            return None

    def _rates(self, q: np.ndarray, p: float, dq: np.ndarray | None, dp: float,
               near: Mapping[str, float]) -> tuple[Rates, dict[str, float]] | None:
        position = self._closed(q, p, near)
        if position is None:
            return None
        arithmetic = self.duals
        values = self.scene.parameters.values(arithmetic, {**self._numbers(Floats), self.name: dual(p, dp)})
        moved: dict[str, float | Dual] = dict(position)
        if dq is not None:
            moved |= {one: dual(position[one], float(x)) for one, x in zip(self.names, dq * self.scale, strict=True)}
        values = {**values, self.scene.time.name: 0.0, **moved}
        if self.loops is not None:
            values |= self._following(arithmetic, values)
        numbers, n = in_numbers(self.form, arithmetic, values), self.rows
        K, outer = numbers.elements.stiffness(), np.outer(self.scale, self.scale)

        def rows(found: "Sequence[Any]", part: "Callable[[Any], Any]") -> np.ndarray:
            result: np.ndarray = np.array([float(part(found[i])) for i in n]) * self.scale
            return result

        def square(part: "Callable[[Any], Any]") -> np.ndarray:
            return np.array([[float(part(K.get((i, j), 0.0))) for j in n] for i in n]) * outer

        found = Rates(rows(numbers.residual, value), square(value), rows(numbers.residual_size, value),
                      rows(numbers.residual, slope), square(slope))
        return (found, position) if all(np.isfinite(part).all() for part in found) else None

    def _numbers(self, arithmetic: Any) -> dict[str, Any]:
        return {one: arithmetic.number(x) for one, x in self.given.items()}

    def at_rest(self, p: float) -> dict[str, float]:
        """{parameter: float}, and the time."""
        return {**self.scene.parameters.values(Floats, {**self._numbers(Floats), self.name: p}),
                self.scene.time.name: 0.0}

    def _closed(self, q: np.ndarray, p: float, near: Mapping[str, float]) -> dict[str, float] | None:
        target = {**near, **{one: float(x) for one, x in zip(self.names, q * self.scale, strict=True)}}
        if self.loops is None:
            return target
        values = self.at_rest(p)
        found = self.loops.followed({**values, **near}, {**values, **target})
        return None if found is None else {one: found[one] for one in near}

    def _following(self, arithmetic: Duals, values: Mapping[str, Any]) -> dict[str, Any]:
        """The dependent coordinates with their rates."""
        n = len(self.loops.names)
        found = evaluate([*self.loops.conditions, *self.loops.slopes], arithmetic, values)
        G = np.array([[float(value(x)) for x in found[n + i * n:n + (i + 1) * n]] for i in range(n)])
        steps = np.linalg.solve(G, [-float(slope(x)) for x in found[:n]])
        return {z: dual(value(values[z]), float(step)) for z, step in zip(self.loops.names, steps, strict=True)}

    def precisely(self, q: "list[mpmath.mpf]", p: Any,
                  near: Mapping[str, Any]
                  ) -> "tuple[list[mpmath.mpf], list[list[mpmath.mpf]], dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
        """(r, K, {coordinate: number}, {symbol: number}) in mpmath at the working precision, as lists with scaled rows;
        q is not scaled."""
        arithmetic = multiprecision()
        values = self.scene.parameters.values(arithmetic, {**self._numbers(arithmetic), self.name: p})
        values = {**values, self.scene.time.name: arithmetic.number(0),
                  **{one: arithmetic.number(0) + x for one, x in near.items()}, **dict(zip(self.names, q, strict=True))}
        if self.loops is not None:
            values = self.loops.refined(values, arithmetic)
        numbers = in_numbers(self.form, arithmetic, values)
        K = numbers.elements.stiffness()
        r = [numbers.residual[i] * s for i, s in zip(self.rows, self.scale, strict=True)]
        K = [[K.get((i, j), 0) * s * t for j, t in zip(self.rows, self.scale, strict=True)]
             for i, s in zip(self.rows, self.scale, strict=True)]
        return r, K, {one: values[one] for one in near}, values
