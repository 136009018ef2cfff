"""Signals of forces of dry friction that several elements share while they stick."""

from collections.abc import Callable, Mapping, Set
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.semantics import lower

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef

TINY = 1e-7         # of what the forces alone would change


class SharedFriction:
    """A signal with a change of each friction force in it: does it change if these still balance?"""

    def __init__(self, node: "Node", changes: "Mapping[str, Node]") -> None:
        self.node, self.changes = node, changes

    @classmethod
    def of(cls, scene: "Scene", tree: Any, names: Set[str],
           symbol: "Callable[[str, int, NameRef], Node]") -> "SharedFriction | None":
        """That of a tree with the forces `names`; None where none of them is one of dry friction."""
        from vibcli.mechanics.equilibrium.dry_friction import signs_of_speeds

        owners = {law.owner for law in scene.laws if law.damper and signs_of_speeds(scene, [law.force(scene)])}
        changes = {name.removesuffix(".force"): scene.table.variable(f"change of {name}") for name in sorted(names)
                   if name.removesuffix(".force") in owners}
        if not changes:
            return None

        def changed(name: str, primes: int, part: "NameRef") -> "Node":
            node, owner = symbol(name, primes, part), name.removesuffix(".force")
            return node + changes[owner] if owner in changes and owner != name and not primes else node

        return cls(lower(tree, scene.table, changed), changes)

    def require_fixed(self, trajectory: "Trajectory", times: Any, values: "Mapping[str, float | np.ndarray]",
                      value: "Callable[[Node, dict[str, float | np.ndarray]], float | np.ndarray]") -> None:
        """PhysicsError at instants at which statics does not fix the signal; value(node, values): of a node there."""
        import numpy as np

        from vibcli.mechanics.equilibrium.redundant_friction import shared

        moves = _moves(trajectory, times, values)
        if not any(moves[owner].any() for owner in self.changes if owner in moves):
            return
        none = {symbol.name: np.zeros(times.shape) for symbol in self.changes.values()}
        some = {symbol.name: moves[owner] for owner, symbol in self.changes.items() if owner in moves}
        at_first = value(self.node, {**values, **none})
        alone = sum(np.abs(value(self.node, {**values, **none, name: move}) - at_first) for name, move in some.items())
        if (np.abs(value(self.node, {**values, **none, **some}) - at_first) > TINY * alone).any():
            raise shared(next(owner for owner in self.changes if owner in moves and moves[owner].any()))


def require_unshared(trajectory: "Trajectory", times: "np.ndarray", values: "Mapping[str, Any]") -> None:
    """PhysicsError at instants at which forces of dry friction are shared in any proportion."""
    from vibcli.mechanics.equilibrium.redundant_friction import shared

    for owner, change in _moves(trajectory, times, values).items():
        if change.any():
            raise shared(owner)


def _moves(trajectory: "Trajectory", times: "np.ndarray",
           values: "Mapping[str, Any]") -> "dict[str, np.ndarray]":
    """The changes of friction forces that still balance, {owner: array}; empty where none is held."""
    import numpy as np

    if not trajectory.system.switches or not trajectory.friction.possible:
        return {}
    none, held = np.full(times.shape, np.nan), trajectory.held(times)
    if not held:
        return {}
    held = {trajectory.system.switches[k]: sigma for k, sigma in held.items()}
    stuck = np.array([~np.isnan(held.get(part.argument, none)) for part in trajectory.friction.parts])
    return trajectory.friction.moves(values, len(times), stuck)
