"""Forces in constraints, supports and drives along any motion, from its places, velocities and accelerations.

As in equilibrium (mechanics/reactions.py) the scene is released, with the inertia of the motion in E:

    E_q + Σ λ_k ∂G_k/∂q = 0        R_ρ = E_ρ + Σ λ_k ∂G_k/∂ρ,        ρ = 0 of supports and drives.

What bends or jumps with the motion does so by its senses σ, which who follows the motion knows.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.language.signal_names import signal_name
from vibcli.language.signals import CONTACT
from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING, OPEN, Released, constraint_slopes, solved_each
from vibcli.mechanics.lagrange import equation_of
from vibcli.mechanics.signals import in_contact, normal_of, reaction_of, require_fixed
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

JUMPS = ("sign", "step")


class ForcesAlong:
    """The forces of a system at states {name: array} of all its coordinates, their rates and the time."""

    def __init__(self, numeric: "NumericSystem") -> None:
        self.numeric, self.released = numeric, Released(numeric)
        self._normals: dict[str, list[Node]] = {}

    @cached_property
    def nodes(self) -> "list[Node]":
        """E of every coordinate and every ∂G_k/∂q, what is released being held."""
        scene = self.released.scene
        T, V, Phi = kinetic(scene), potential(scene), dissipation(scene)
        flat = [*(equation_of(scene, i, T, V, Phi) for i in range(len(scene.q))), *constraint_slopes(scene)]
        n = len(self.released.real)
        return substitute(flat, dict.fromkeys((*scene.q[n:], *scene.v[n:], *scene.a[n:]), scene.table.zero))

    @cached_property
    def jumps(self) -> "dict[Node, Node]":
        """{σ as a symbol: its argument} of what jumps with the motion."""
        table = self.released.scene.table
        return {table.variable(f"sense {i}"): argument for i, argument in enumerate(dict.fromkeys(
            part.args[0] for part in self._jumping))}

    @property
    def _jumping(self) -> "list[Node]":
        """sign u and step u within the nodes, those of the time alone apart."""
        motion = ~self.released.scene.time.mask
        return [part for part in reachable(self.nodes) if part.name in JUMPS and part.mask & motion]

    @cached_property
    def _sensed(self) -> "list[Node]":
        """The nodes with the symbols σ in place of what jumps: sign u = σ, step u = (1 + σ)/2."""
        symbols = {argument: symbol for symbol, argument in self.jumps.items()}
        senses = {part: symbols[part.args[0]] for part in self._jumping}
        return substitute(self.nodes, {part: sense if part.name == "sign" else (1 + sense) / 2
                                       for part, sense in senses.items()})

    def values(self, names: Sequence[str], states: Any,
               senses: "Callable[[Scene, list[Node]], list[np.ndarray]] | None" = None) -> "dict[str, np.ndarray]":
        """{signal: array} of the forces of these names; senses(scene, arguments): the σ of what jumps there, else by
        the signs of the arguments."""
        import numpy as np

        scene, n = self.released.scene, len(self.released.real)
        count, nodes = len(states[scene.time.name]), self.nodes
        if senses is not None and self.jumps:
            nodes, found = self._sensed, senses(scene, list(self.jumps.values()))
            states = {**states, **{symbol.name: sigma for symbol, sigma in zip(self.jumps, found, strict=True)}}
        flat = np.array([np.broadcast_to(value, count) for value in evaluate(nodes, Arrays, states)], dtype=float)
        size, ties = len(scene.q), len(scene.constraints)
        E, G = flat[:size], flat[size:].reshape(ties, size, count)
        known = self._known(E.T, G.transpose(2, 0, 1), n)
        return {name: np.array(np.broadcast_to(self._value(known, name, states), count)) for name in names}

    def _known(self, E: "np.ndarray", G: "np.ndarray", n: int) -> "dict[str, np.ndarray | None]":
        """{signal: array, None where rigid bodies alone leave it open at any instant}, of E and G one instant a row."""
        import numpy as np

        scene, found = self.released.scene, {}
        multipliers, loose = solved_each(G[:, :, :n], E[:, :n], self.released.units)
        held = E[:, n:] + (multipliers[:, None] @ G[:, :, n:])[:, 0]
        left_open = np.abs(loose @ G[:, :, n:]).max(axis=(0, 1), initial=0.0) > OPEN
        for k, tie in enumerate(scene.constraints):
            sign = 1.0 if tie.form in LENGTHENING else -1.0
            found[tie.signal] = None if np.abs(loose[:, :, k]).max(initial=0.0) > OPEN else sign * multipliers[:, k]
        found.update({q.name: None if unknown else value
                      for q, value, unknown in zip(self.released.held, held.T, left_open, strict=True)})
        return found

    def _value(self, known: "Mapping[str, np.ndarray | None]", text: str,
               states: "Mapping[str, float | np.ndarray]") -> "float | np.ndarray":
        signal = signal_name(text)
        if signal.kind in CONTACT and text not in known:
            return self._contact(known, signal.name, signal.kind, states)
        text = reaction_of(self.numeric.system, text, known)
        return require_fixed(text, known[text])

    def _contact(self, known: "Mapping[str, np.ndarray | None]", name: str, part: str,
                 states: "Mapping[str, float | np.ndarray]") -> "float | np.ndarray":
        reach, normal = self.released.scene.bodies[name].reach, self._normal(name)
        if part == "friction" and reach is not None and f"{name}.drive" not in known:
            arm: float | np.ndarray = evaluate([reach], Arrays, states)[0]
            return self._value(known, f"{name}.reaction.moment", states) / arm
        return in_contact(part, evaluate(normal, Arrays, states), [
            self._value(known, f"{name}.reaction.{axis}", states) for axis in "xy"])

    def _normal(self, name: str) -> "list[Node]":
        """The normal of the surface that a body touches, what is released being held."""
        if name not in self._normals:
            scene, n = self.released.scene, len(self.released.real)
            self._normals[name] = substitute(normal_of(scene, name), dict.fromkeys(scene.q[n:], scene.table.zero))
        return self._normals[name]
