"""Rest where forces jump: r(q, σ) = 0, u(q) = 0, |σₖ| ≤ 1, σₖ standing for sign uₖ where uₖ vanishes.

A force F₀ sign d bears there whatever balance asks for between −F₀ and F₀. Newton's method finds q and σ at once, the
arguments that vanish being those next to zero where the descent of the potential energy ends.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.linearisation import residual_terms
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.running_errors import UNIT, Rounded, error_in

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np

    from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent
    from vibcli.symbolic.node import Node

NEAR, NOTHING = 1e-3, 1e-25             # of the figure
STEPS, SETTLED, ROUND = 30, 1e-13, 1e-12     # of Newton; relative


class JumpsAtRest(NamedTuple):
    """`nodes`: {sign u or step u: what stands for it at rest}; `unknowns`: symbols of q and σ; `conditions`: nodes that
    vanish; `values`: {name of an unknown: float}."""

    nodes: "dict[Node, Node]"
    unknowns: "list[Node]"
    conditions: "list[Node]"
    values: dict[str, float]

    @property
    def senses(self) -> "dict[Node, float]":
        """{sign u or step u: its value in the balance of forces}."""
        return dict(zip(self.nodes, evaluate(list(self.nodes.values()), Floats, self.values), strict=True))

    def opened(self, node: "Node") -> "Node":
        """An expression with σ for what jumps at rest."""
        return substitute([node], self.nodes)[0]

    def bounded(self, arithmetic: Any, values: "Mapping[str, Any]") -> dict[str, Rounded]:
        """{name of an unknown: number with its bound}: to first order by what is left of the conditions."""
        import numpy as np

        left = evaluate(self.conditions, arithmetic, {**values, **self.values})
        J = _jacobian(self, {**{name: float(getattr(x, "value", x)) for name, x in values.items()}, **self.values})
        off = np.abs(np.linalg.inv(J)) @ np.array([abs(x.value) + error_in(x) if isinstance(x, Rounded) else abs(x)
                                                   for x in left], dtype=float)
        return {name: Rounded(x, 2 * float(error) + UNIT * abs(x))
                for (name, x), error in zip(self.values.items(), off, strict=True)}

    def precisely(self, arithmetic: Any, values: "Mapping[str, Any]") -> dict[str, Any]:
        """{name of an unknown: mpmath number}, at the working precision."""
        import mpmath

        found = {name: mpmath.mpf(x) for name, x in self.values.items()}
        slopes = [gradient(node).get(x, node.table.zero) for node in self.conditions for x in self.unknowns]
        n = len(self.unknowns)
        for _ in range(STEPS):
            known = {**values, **found}
            left = mpmath.matrix(evaluate(self.conditions, arithmetic, known))
            J = mpmath.matrix(n, n)
            for i, slope in enumerate(evaluate(slopes, arithmetic, known)):
                J[i // n, i % n] = slope
            step = mpmath.lu_solve(J, left)
            found = {name: x - dx for (name, x), dx in zip(found.items(), step, strict=True)}
            if all(abs(dx) <= 4 * mpmath.eps * abs(x) or abs(x) < mpmath.eps for x, dx in zip(
                    found.values(), step, strict=True)):
                break
        return found


def rest_at_jumps(search: "EnergyDescent", q: "np.ndarray") -> JumpsAtRest | None:
    """The JumpsAtRest next to a place where a search ends; None where there is none."""
    scene = search.scene
    if scene.resting.loops is not None or scene.timed:
        return None
    table = scene.table
    forces = [table.total(row) for row in residual_terms(search.numeric.system.linearisation)]
    jumping = [part for part in reachable(forces) if part.name in ("sign", "step") and part.mask]
    near = {**search.numeric.floats, **search.named_plainly(q)}
    sizes = _sizes(search, jumping, near)
    active = [part for part, size in zip(jumping, sizes, strict=True) if size <= NEAR]
    while active:
        found = _solved(search, forces, active, q)
        outside = [] if found is None else [part for part, symbol in zip(active, found.unknowns[len(q):], strict=True)
                                            if abs(found.values[symbol.name]) > 1 + ROUND]
        if found is None or not outside:
            return found
        active = [part for part in active if part not in outside]
    return None


def _sizes(search: "EnergyDescent", jumping: "Sequence[Node]", near: dict[str, float]) -> list[float]:
    """How far the arguments are from zero, as shares of what they change by over the figure."""
    import numpy as np

    found = []
    for part in jumping:
        u = part.args[0]
        slopes = gradient(u)
        value, *rows = evaluate([u, *(slopes.get(x, u.table.zero) for x in search.scene.q)], Floats, near)
        size = float(np.abs(rows) @ search.scale)
        found.append(abs(value) / size if size else np.inf)
    return found


def _solved(search: "EnergyDescent", forces: "list[Node]", active: "Sequence[Node]",
            q: "np.ndarray") -> JumpsAtRest | None:
    import numpy as np

    scene, table = search.scene, search.scene.table
    symbols = [table.variable(f"the sense {i + 1} at rest") for i in range(len(active))]
    nodes = {part: symbol if part.name == "sign" else (symbol + 1) * HALF
             for part, symbol in zip(active, symbols, strict=True)}
    unknowns = [*scene.q, *symbols]
    found = JumpsAtRest(nodes, unknowns, [*substitute(forces, nodes), *(part.args[0] for part in active)],
                        {**search.named_plainly(q), **{symbol.name: 0.0 for symbol in symbols}})
    scale = np.concatenate([search.scale, np.ones(len(symbols))])
    for _ in range(STEPS):
        known = {**search.numeric.floats, **found.values}
        left = np.array(evaluate(found.conditions, Floats, known))
        J = _jacobian(found, known) * scale
        if not (np.isfinite(left).all() and np.isfinite(J).all()) or np.linalg.matrix_rank(
                J / np.maximum(np.abs(J).max(axis=1, keepdims=True), 1e-300), tol=ROUND) < len(J):
            return None
        step = np.linalg.solve(J, left)
        found = found._replace(values={name: x - float(dx) + 0.0 for (name, x), dx in zip(
            found.values.items(), scale * step, strict=True)})
        if np.abs(step).max() <= SETTLED:
            settled = np.array([found.values[name] for name in search.names])
            plain = {name: 0.0 if abs(x) <= NOTHING * size else x
                     for (name, x), size in zip(found.values.items(), scale, strict=True)}
            return found._replace(values=plain) if np.all(np.abs(settled - q) <= 10 * NEAR * search.scale) else None
    return None


def _jacobian(found: JumpsAtRest, known: dict[str, float]) -> "np.ndarray":
    import numpy as np

    slopes = [gradient(node).get(x, node.table.zero) for node in found.conditions for x in found.unknowns]
    n = len(found.unknowns)
    return np.array(evaluate(slopes, Floats, known), dtype=float).reshape(n, n)
