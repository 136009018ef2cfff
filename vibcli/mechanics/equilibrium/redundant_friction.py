"""Which forces of dry friction statics alone does not fix while they hold a scene.

Friction at zero speed enters the equations as Σ σₖ aₖ, the signs σₖ of the speeds ṡₖ being unknown. With constraints
G q̇ = 0 these are known but for the N of Σ aₖ Nₖ + Gᵀ λ = 0: two in parallel have aₑ = c a_d, and share a load anyhow.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotFixed
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium.dry_friction import signs_of_speeds
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    import numpy as np

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

STEP = 0.1
TINY = 1e-9     # of the length of a column: it depends on others


class Held(NamedTuple):
    """One sign of a speed: the `owner` of its law, "" of what is no element, the speed in it with
    its slopes ∂ṡ/∂q̇ and its `drift`, the speed at q̇ = 0, the `size` of the force of
    the element, and its column a."""

    owner: str
    argument: Any
    slopes: "tuple[Node, ...]"
    drift: Any
    size: Any
    column: "tuple[Node, ...]"


class Redundancy:
    """The signs of speeds in the equations of a scene, `slopes` being {(i, j): ∂Gᵢ/∂qⱼ} of its constraints."""

    def __init__(self, scene: "Scene", equations: "Sequence[Node]", slopes: Mapping[Any, Any] | None = None) -> None:
        self.scene = scene
        self.ties = [[(slopes or {}).get((i, j), scene.table.zero) for j in range(len(scene.q))]
                     for i in sorted({i for i, _ in slopes or {}})]
        self.parts = _of_laws(scene)
        self.parts += _of_others(scene, equations, self.parts)

    @property
    def possible(self) -> bool:
        """Could any be redundant?"""
        return len(self.parts) > 1 and any(part.owner for part in self.parts)

    def carried(self, values: "Mapping[str, float | np.ndarray]", count: int, held: "np.ndarray") -> "np.ndarray":
        """At which of `count` instants, of which the `values` are known, the sign of each part is held, as its speed
        follows from those that are known to be: `held`, a row for each part."""
        W, drift, G = (self._array(nodes, values, count) for nodes in (
            [part.slopes for part in self.parts], [[part.drift] for part in self.parts], self.ties))
        return _each(_carried, W, drift[:, :, 0], G, held.T).T

    def moves(self, values: "Mapping[str, float | np.ndarray]", count: int,
              held: "np.ndarray") -> "dict[str, np.ndarray]":
        """{owner: changes of its force} of shape (count,): one N, small beside the friction, where `held`, a row for
        each part, says that a sign is held."""
        A, sizes, G = (self._array(nodes, values, count) for nodes in (
            [part.column for part in self.parts], [[part.size] for part in self.parts], self.ties))
        found = _each(_free, A, G, held.T) * sizes[:, :, 0]
        return {owner: sum(found[:, k] for k, part in enumerate(self.parts) if part.owner == owner)
                for owner in dict.fromkeys(part.owner for part in self.parts) if owner}

    def _array(self, rows: "Sequence[Sequence[Node]]", values: "Mapping[str, float | np.ndarray]",
               count: int) -> "np.ndarray":
        import numpy as np

        nodes = [node for row in rows for node in row]
        found = [np.broadcast_to(value, (count,)) for value in evaluate(nodes, Arrays, values)]
        width = len(rows[0]) if rows else len(self.scene.q)
        return np.array(found, dtype=float).reshape(len(rows), width, count).transpose(2, 0, 1)


def shared(owner: str) -> NotFixed:
    """The refusal of the force of an element."""
    return NotFixed(f"{owner}.force", "more friction holds the scene than it needs",
                    "take one of the elements that share the load out")


def require_fixed_at_rest(configuration: Any, owner: Any) -> None:
    """PhysicsError where the force of an element with dry friction is not fixed in equilibrium."""
    scene = configuration.scene
    if not any(signs_of_speeds(scene, [law.force(scene)]) for law in scene.terms_of(owner, "laws")):
        return
    import numpy as np

    from vibcli.mechanics.equations_of_motion import dynamics

    parts = dynamics(scene)
    found = Redundancy(scene, parts.h, parts.slopes)
    everything = np.ones((len(found.parts), 1), dtype=bool)
    if found.possible and found.moves({**configuration.at_rest, scene.time.name: 0.0}, 1, everything).get(owner):
        raise shared(owner)


def _of_laws(scene: "Scene") -> list[Held]:
    found = []
    for law in scene.laws:
        force, speed = law.force(scene), scene.rate(law.s)
        for sign in signs_of_speeds(scene, [force]) if law.damper else ():
            size = _slope(scene, force, sign)
            found.append(_held(scene, law.owner, sign, size, tuple(size * slope for slope in _slopes(scene, speed))))
    return found


def _of_others(scene: "Scene", equations: "Sequence[Node]", laws: Sequence[Held]) -> list[Held]:
    """What else holds with a sign of the equations, loads and energies: the column that no law accounts for."""
    found, table = [], scene.table
    for sign in dict.fromkeys(sign for node in equations for sign in signs_of_speeds(scene, [node])):
        argument = sign.args[0]
        own = [part.column for part in laws if part.argument is argument]
        column = tuple(_slope(scene, node, sign) - table.sum(*((part[i], 1) for part in own))
                       for i, node in enumerate(equations))
        if not all(is_zero(node) for node in column):
            found.append(_held(scene, "", sign, table.zero, column))
    return found


def _held(scene: "Scene", owner: str, sign: "Node", size: "Node", column: "tuple[Node, ...]") -> Held:
    argument = sign.args[0]
    drift, = substitute([argument], scene.rates_at_rest)
    return Held(owner, argument, _slopes(scene, argument), drift, size, column)


def _slope(scene: "Scene", node: "Node", sign: "Node") -> "Node":
    sigma = scene.table.variable("sigma of friction")
    return gradient(substitute([node], {sign: sigma})[0]).get(sigma, scene.table.zero)


def _slopes(scene: "Scene", node: "Node") -> "tuple[Node, ...]":
    found = gradient(node)
    return tuple(found.get(v, scene.table.zero) for v in scene.v)


def _each(function: "Callable[..., np.ndarray]", *arrays: "np.ndarray") -> "np.ndarray":
    """A function of each instant, of equal ones once."""
    import numpy as np

    known, found = {}, []
    for row in zip(*arrays, strict=True):
        key = b"".join(np.ascontiguousarray(part).tobytes() for part in row)
        if key not in known:
            known[key] = function(*row)
        found.append(known[key])
    return np.array(found)


def _free(a: "np.ndarray", g: "np.ndarray", held: "np.ndarray") -> "np.ndarray":
    """An N of one instant, the largest of its Nₖ being STEP."""
    import numpy as np

    lengths = np.linalg.norm(a, axis=1)
    held = held & (lengths > 0)
    B = np.concatenate([_unit(a[held]), _unit(g)])
    some = np.cos(1.0 + np.arange(len(B)))                  # in no special direction
    y = (some - B @ (np.linalg.pinv(B, rcond=TINY) @ some))[:int(held.sum())]
    found = np.zeros(len(a))
    found[held] = np.where(np.abs(y) > TINY, y, 0.0) / lengths[held]
    largest = np.abs(found).max(initial=0.0)
    return STEP * found / largest if largest else found


def _unit(rows: "np.ndarray") -> "np.ndarray":
    import numpy as np

    size = np.linalg.norm(rows, axis=-1, keepdims=True)
    return rows / np.where(size > 0, size, 1.0)


def _carried(w: "np.ndarray", drift: "np.ndarray", g: "np.ndarray", held: "np.ndarray") -> "np.ndarray":
    """Which speeds vanish as those that are held do, being linear in them: w = C w_held + D g."""
    import numpy as np

    if not held.any():
        return held
    known, offsets = np.concatenate([w[held], g]), np.concatenate([drift[held], np.zeros(len(g))])
    C = w @ np.linalg.pinv(known, rcond=TINY)
    inside = np.linalg.norm(w - C @ known, axis=1) <= TINY * np.linalg.norm(w, axis=1)
    still = np.abs(drift - C @ offsets) <= TINY * (np.abs(drift) + np.abs(C) @ np.abs(offsets))
    found: np.ndarray = held | inside & still
    return found
