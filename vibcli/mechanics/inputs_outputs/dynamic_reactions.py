"""Forces in constraints and supports during small oscillations, inertia included.

The scene is released (mechanics/reactions.py): all its coordinates p are free, and the supports give way by ρ. With the
residual E(p, ṗ, p̈, u) of both, linear about the equilibrium, and the constraints G_k(p) = 0,

    δE_p + Σ λ_k δ(∂G_k/∂p) + Σ δλ_k ∂G_k/∂p = 0     gives δλ, and    δR_ρ = δE_ρ + Σ λ_k δ(∂G_k/∂ρ) + Σ δλ_k ∂G_k/∂ρ

with δp = P δq + P_u δu. What q does follows from its own equations, so any left inverse of ∂G/∂p gives the same δλ.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.language.signals import CONTACT
from vibcli.mechanics.autonomous import excitation
from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction, combined, product
from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING, OPEN, constraint_slopes, left_inverse, solved
from vibcli.mechanics.linearise import row_of, slopes_of
from vibcli.mechanics.signals import normal_of, reaction_of, require_fixed
from vibcli.mechanics.static_preload import pivots
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.mechanics.configuration import Configuration


class MovingReactions:
    """The linear functions of all multipliers and supports."""

    def __init__(self, configuration: "Configuration") -> None:
        self.configuration, self.opened = configuration, configuration.with_inputs
        self.released = SystemWithInputs(configuration, releasing=True)

    @cached_property
    def rows(self) -> dict[str, LinearFunction]:
        """{signal: LinearFunction, or None where the scene is supported by more than it needs}."""
        import numpy as np

        scene = self.released.scene
        if any(node.mask & scene.time.mask for node in (part.node for part in scene.constraints)):
            raise PhysicsError("the forces of constraints that depend on the time are not found",
                               "drive a point or a body instead of the constraint")
        real = [i for i, q in enumerate(scene.q) if q.name in self.configuration.spec.coordinates]
        held = [scene.q.index(q) for q in scene.released]
        residual = self._residual()
        slopes = evaluate(constraint_slopes(scene), self.opened.arithmetic, self.released.values)
        G = np.array(slopes, self.opened.kind).reshape(-1, len(scene.q))
        static, loose, inverse = self._solved(G[:, real], [residual[i].constant for i in real], scene.units_of(
            [scene.q[i].name for i in real]))
        self._bend(residual, static)
        multipliers = [combined((-x, residual[i]) for x, i in zip(line, real, strict=True) if x) for line in inverse]
        multipliers = [row._replace(constant=value) for row, value in zip(multipliers, static, strict=True)]
        found = {}
        for k, constraint in enumerate(scene.constraints):
            sign, row = 1.0 if constraint.form in LENGTHENING else -1.0, multipliers[k]
            open_one = np.abs(loose[:, k]).max(initial=0.0) > OPEN
            found[constraint.signal] = None if open_one else combined([(sign, row)])
        for i in held:
            ties = [(G[k, i], row) for k, row in enumerate(multipliers) if G[k, i]]
            open_one = np.abs(loose @ G[:, i].astype(float)).max(initial=0.0) > OPEN
            found[scene.q[i].name] = None if open_one else combined([(1.0, residual[i]), *ties])
        return found

    def _solved(self, G: "np.ndarray", E: Sequence[float],
                units: list[float]) -> "tuple[list[float], np.ndarray, list[list[float]]]":
        """(λ in equilibrium, what Gᵀλ = 0 leaves open, the left inverse of Gᵀ), the first and the last in the numbers
        of G."""
        import numpy as np

        static, loose = solved(G.astype(float), np.array(E, float), units)
        if self.opened.kind is float:
            return static.tolist(), loose, left_inverse(G, units)[0].tolist()
        inverse = _picked_inverse(G)
        return [-sum(x * e for x, e in zip(line, E, strict=True)) for line in inverse], loose, inverse

    def _residual(self) -> dict[int, LinearFunction]:
        """{i: LinearFunction of E_i} over the coordinates and inputs of the opened scene."""
        released, motions = self.released, self._motions()
        numbers = released.numbers
        M, C, G, K = numbers.elements.matrices()
        parts = {i: {"q": {}, "v": {}, "a": {}} for i in range(released.n)}
        for kind, matrices in (("q", (K,)), ("v", (C, G)), ("a", (M,))):
            for matrix in matrices:
                for (i, j), x in matrix.items():
                    if i < released.n:
                        _add(parts[i][kind], x, motions[j])
        driven = excitation(released.scene, released.timed, released.place)
        driven = dict(zip(driven, copied(list(driven.values()), self.opened.scene.table), strict=True))
        return {i: LinearFunction(numbers.residual[i], [(-1.0, driven[i])] if i in driven else [], **part)
                for i, part in parts.items()}

    def _motions(self) -> list[dict[int, float]]:
        """δp_j of every coordinate of the released scene, {number: coefficient} over those of the opened one."""
        opened, released = self.opened, self.released.scene
        names = [q.name for q in released.q if q.name in self.configuration.spec.coordinates]
        rows = dict(zip(names, opened.rows([opened.scene.symbol(name) for name in names]), strict=True))
        inputs = {q.name: {opened.n + k: 1.0} for k, q in enumerate(released.inputs)}
        return [rows[q.name].q if q.name in rows else inputs.get(q.name, {}) for q in released.q]

    def _bend(self, residual: Mapping[int, LinearFunction], multipliers: Sequence[float]) -> None:
        """Adds Σ λ_k δ(∂G_k/∂p) to the residual."""
        scene, motions = self.released.scene, self._motions()
        number = {q: i for i, q in enumerate(scene.q)}
        for constraint, size in zip(scene.constraints, multipliers, strict=True):
            seconds = slopes_of(row_of(constraint.node, number), number)
            values = evaluate(list(seconds.values()), self.opened.arithmetic, self.released.values)
            for (i, j), x in zip(seconds, values, strict=True):
                if i in residual and x and size:
                    _add(residual[i].q, size * x, motions[j])

    def row(self, text: str) -> LinearFunction:
        """The LinearFunction of a reaction, a force in a constraint, or a force of contact."""
        signal = signal_name(text)
        if signal.kind in CONTACT and text not in self.rows:
            return self._contact(signal.name, signal.kind)
        text = reaction_of(self.configuration.system, text, self.rows)
        return require_fixed(text, self.rows[text])

    def _contact(self, name: str, part: str) -> LinearFunction:
        normal, reach = normal_of(self.opened.scene, name), self.opened.scene.bodies[name].reach
        if part == "friction" and reach is not None and f"{name}.drive" not in self.rows:
            arm = self.opened.rows([reach])[0].constant      # what two surfaces press does not turn it
            return combined([(1.0 / arm, self.row(f"{name}.reaction.moment"))])
        nx, ny = self.opened.rows(list(normal))
        x, y = (self.row(f"{name}.reaction.{axis}") for axis in "xy")
        parts = [(1.0, x, nx), (1.0, y, ny)] if part == "normal" else [(1.0, x, ny), (-1.0, y, nx)]
        return combined((sign, product(one, two)) for sign, one, two in parts)


def _picked_inverse(G: "np.ndarray") -> "list[list[mpmath.mpf]]":
    """Another in more digits, on the rows and columns that elimination in floats picks out, as lists."""
    import mpmath

    rows, columns = pivots(G.astype(float).tolist())
    found = [[mpmath.mpf(0)] * G.shape[1] for _ in range(len(G))]
    block: Any = mpmath.matrix([[G[k, i] for k in rows] for i in columns])**-1 if rows else ()
    for at, k in enumerate(rows):
        for place, i in enumerate(columns):
            found[k][i] = block[at, place]
    return found


def _add(total: dict[int, float], factor: float, row: Mapping[int, float]) -> None:
    for i, x in row.items() if factor else ():
        total[i] = total.get(i, 0.0) + factor * x
