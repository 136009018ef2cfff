"""Forces that bend or jump with a motion: which side of each bend it is on, and what its equations are there.

A bend is where the argument u of |u|, sign u, min, max … vanishes. Where u is a velocity and both sides drive it back
to zero, as dry friction does at rest, it sticks: u stays zero, which is a constraint of the equations,

    M q̈ + h₀ + λ ∂u/∂q̇ = 0,   u̇ = 0,        |λ| ≤ σ₀ F,   h(sign u = ±1) = h₀ ± F ∂u/∂q̇.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, cast

from vibcli.analyses.time_integration.smooth_pieces import SmoothPieces, bent
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equations_of_motion import drift
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.equations_of_motion import Dynamics
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

STICKS = 0
STATES, BESIDE, SAME = 3, 0.01, 1e-9       # in which arguments are compared, beside the drawn one; relative
Senses = Mapping["Node", int]


def bends(scene: "Scene", nodes: "Sequence[Node]") -> "list[Node]":
    """What of expressions bends or jumps with the motion."""
    return [part for part in bent(nodes) if part.mask & ~scene.time.mask]


class Sides(NamedTuple):
    """The equations on one side of each bend; senses: {argument: ±1, or that it sticks}; watched: [(argument, the
    sense that it has beyond, what is positive as long as they hold)]; held: {argument: σ where it sticks}."""

    pieces: SmoothPieces
    senses: Senses
    watched: "list[tuple[Node | None, int, Node]]"
    held: "dict[Node, Node]"


class Switches:
    """The Sides of a motion; `made(parts)`: its SmoothPieces; floats: {parameter: float}; taut: what has to stay
    positive."""

    def __init__(self, scene: "Scene", parts: "Dynamics", made: "Callable[[Dynamics], SmoothPieces]",
                 floats: Mapping[str, float], taut: "Sequence[Node]" = ()) -> None:
        self.scene, self.parts, self._made, self._taut, self._modes = scene, parts, made, taut, {}
        self._floats, self._alike = floats, {}
        self.arguments: list[Node] = []
        self._bounds = scene.law_switches()[1] if scene.laws else {}
        for part in bends(scene, parts.nodes()):
            if bends(scene, part.args):
                raise PhysicsError("no reference is found of motions whose forces bend where another one bends")
            argument, _ = self._argument(part)
            if argument not in self.arguments:
                self.arguments.append(argument)

    @property
    def products(self) -> int:
        """Of series, in each round."""
        return self.mode(dict.fromkeys(self.arguments, 1)).pieces.products

    def at_speed(self, argument: "Node") -> bool:
        """Is it a velocity?"""
        return any(v in gradient(argument) for v in self.scene.v)

    def mode(self, senses: Senses) -> Sides:
        """On these sides."""
        key = tuple(senses[u] for u in self.arguments)
        if key not in self._modes:
            self._modes[key] = self._mode(dict(senses))
        return cast("Sides", self._modes[key])

    def _mode(self, senses: "dict[Node, int]") -> Sides:
        parts, watched, held = self._on_sides(senses), [], {}
        for u, sense in senses.items():
            if sense != STICKS:
                watched.append((u, -sense, u * sense))
                continue
            if self.parts.gaps:
                raise PhysicsError("no reference is found of friction that sticks where constraints hold the scene")
            parts, force, limit = self._stuck(parts, senses, u)
            held[u] = force / limit * self._bounds.get(u, 1)
            watched += [(u, sense, limit - force * sense) for sense in (1, -1)]
        taut = self._resolved(self._taut, senses, held)
        return Sides(self._made(parts), senses, [*watched, *((None, 0, node) for node in taut)], held)

    def _on_sides(self, senses: "dict[Node, int]") -> "Dynamics":
        return self.parts.made_of(self._resolved(self.parts.nodes(), senses, {}))

    def _stuck(self, parts: "Dynamics", senses: "Mapping[Node, int]", u: "Node") -> "tuple[Dynamics, Node, Node]":
        """(the equations with one more constraint, its force λ, the largest that friction bears)."""
        scene, table, n = self.scene, self.scene.table, len(self.scene.q)
        slopes = {i: gradient(u)[v] for i, v in enumerate(scene.v) if v in gradient(u)}
        jump = [one - none for one, none in zip(self._on_sides({**senses, u: 1}).h, parts.h, strict=True)]
        square = table.total([slope * slope for slope in slopes.values()])
        left = {i: table.total([parts.h[i], *(parts.M[pair] * scene.a[j] for j in range(n) if (
            pair := (min(i, j), max(i, j))) in parts.M)]) for i in slopes}
        force = -table.total([slope * left[i] for i, slope in slopes.items()]) / square
        limit = table.total([slope * jump[i] for i, slope in slopes.items()]) / square * self._bounds.get(u, 1)
        more = parts._replace(names=[*parts.names, "friction"], gaps=[*parts.gaps, u], rates=[*parts.rates, u],
                              slopes={**parts.slopes, **{(len(parts.gaps), i): x for i, x in slopes.items()}},
                              bends=[*parts.bends, drift(scene, u)])
        return more, force, limit

    def resolved(self, nodes: "Sequence[Node]", mode: Sides) -> "list[Node]":
        """Expressions as they are in a mode; what bends elsewhere stays."""
        return self._resolved(nodes, mode.senses, mode.held)

    def _resolved(self, nodes: "Sequence[Node]", senses: "Mapping[Node, int]",
                  held: "Mapping[Node, Node]") -> "list[Node]":
        instead = {}
        for part in bends(self.scene, nodes):
            argument, sign = self._same(*self._argument(part))
            if argument in senses:
                instead[part] = self._on_side(part, senses[argument] * sign, held.get(argument), sign)
        return substitute(list(nodes), instead)

    def _argument(self, part: "Node") -> "tuple[Node, int]":
        """(what vanishes where a part bends, ±1), one of ±u for all."""
        u, table = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0], part.table
        for sign in (1, -1):
            found = table.call("sign", u * sign)
            if found.op == "call":
                return found.args[0], sign
        raise PhysicsError("no reference is found of what bends at a place that is none")

    def _same(self, argument: "Node", sign: int) -> "tuple[Node, int]":
        """(the argument of a bend of the equations that vanishes where this one does, ±1); itself where none is."""
        if argument not in self._alike:
            self._alike[argument] = next(((u, way) for u in self.arguments if (way := self._way(argument, u))),
                                         (argument, 1))
        u, way = self._alike[argument]
        return u, sign * way

    def _way(self, one: "Node", other: "Node") -> int:
        """±1, the sign of the ratio of two arguments, if that is the same number in all states."""
        if one is other:
            return 1
        scene, ratios = self.scene, []
        for k in range(1, STATES + 1):
            state = {**self._floats, scene.time.name: 0.0}
            for i, q in enumerate(scene.q):
                unit = BESIDE * k * (-1) ** i * scene.unit_of(q.name)
                state |= {q.name: scene.number(q) + unit, q.name + "'": unit / (i + k)}
            u, v = evaluate([one, other], Floats, state)
            ratios.append(u / v if v else 0.0)
        alike = max(ratios) - min(ratios) <= SAME * max(map(abs, ratios))
        return (ratios[0] > 0) - (ratios[0] < 0) if alike else 0

    def _on_side(self, part: "Node", sense: int, held: "Node | None", sign: int) -> "Node":
        """What stands for a part; held: σ of what sticks."""
        table, u = part.table, part.args[0]
        if part.name in ("min", "max"):
            return cast("Node", part.args[0] if (sense >= 0) == (part.name == "max") else part.args[1])
        if sense == STICKS:
            return held * sign if held is not None and part.name == "sign" else table.zero
        if part.name == "impulse":          # of a rate of what is constant there
            return table.zero
        result: Node = {"abs": u * sense, "sign": table.number(sense), "step": table.number((1 + sense) // 2),
                          "ramp": u * ((1 + sense) // 2)}[part.name]
        return result
