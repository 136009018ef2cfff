"""The equations of a motion between the instants at which what drives it bends or jumps, as series to any digits.

Between two of them step, ramp, abs, sign, min, max, square and sawtooth of the time are what they are on one side. The
instants are refined by Newton's method from the floats. What bends or jumps with the motion itself is refused by name.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from vibcli.analyses.time_integration.forcing_breaks import BENT, breaks
from vibcli.analyses.time_integration.motion_series import MotionSeries, fixed_point, resting
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.time_integration.motion_series import Computed
    from vibcli.base.work import Work
    from vibcli.mechanics.equations_of_motion import Dynamics
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import RunningErrors

PARTS = 512             # of a motion: the longest step where a pulse of the time may hide
NEAR = 1e-8             # of an instant: how far Newton's method may move it
WITHOUT = "leave --digits out: in floats it is followed"
PERIODIC = ("square", "sawtooth")


def bent(nodes: "Sequence[Node]") -> "list[Node]":
    """What bends or jumps in expressions."""
    return [part for part in reachable(nodes) if part.mask and (part.name in BENT or part.name in part.table.records)]


def require_smooth_motion(scene: "Scene", nodes: "Sequence[Node]") -> None:
    """PhysicsError where more digits of a motion are not found, for what its equations are made of."""
    owners = scene.law_switches()[0] if scene.laws else {}
    solved = next((part for part in reachable(nodes) if part.mask and part.name in part.table.functions), None)
    if solved is not None:
        about = solved.table.functions[solved.name].about
        raise PhysicsError(f"{about}: more digits of such a motion are not found", WITHOUT)
    for part in bent(nodes):
        if part.mask & ~scene.time.mask:
            argument = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0]
            owner = next((owners[u] for u in (argument, -argument) if u in owners), None)
            what = f"'{owner}' bends or jumps" if owner else f"what is written with {part.name}(…) bends or jumps"
            raise PhysicsError(f"{what} with the motion: more digits of such a motion are not found", WITHOUT)
        if part.name == "impulse" or part.name in part.table.records:
            what = "an impulse" if part.name == "impulse" else f"the record '{part.name}'"
            raise PhysicsError(f"{what} drives this motion: more digits of it are not found", WITHOUT)


def may_hide(scene: "Scene", nodes: "Sequence[Node]") -> bool:
    """Is there a function of the time in expressions that may be nothing but for a pulse?"""
    time = scene.time
    return any(part.mask == time.mask and (
        (part.op == "call" and part.name not in BENT and
         (part.name not in ("sin", "cos") or gradient(part.args[0])[time].mask)) or
        (part.op == "product" and any(base.mask and (e < 0 or e.denominator != 1) for base, e in part.args)))
        for part in reachable(nodes))


class SmoothPieces:
    """The equations `parts` of a scene up to an instant; values(bits): of its parameters; rests: does it stay
    where it is?"""

    def __init__(self, scene: "Scene", parts: "Dynamics", values: "Callable[[int], Mapping[str, mpmath.mpf]]",
                 floats: Mapping[str, float], until: float, work: "Work", rests: bool = False) -> None:
        require_smooth_motion(scene, parts.nodes())
        self.rests = rests
        self.scene, self.parts, self.values, self.floats, self.until = scene, parts, values, floats, until
        self._bent, self._hidden = bent(parts.nodes()), may_hide(scene, parts.nodes())
        self.times = list(breaks(scene, parts.nodes(), floats, until, work).times) if self._bent else []
        self._pieces, self._compiled, self._instants = {}, {}, {}

    @property
    def endless(self) -> bool:
        """Do they hold at all times?"""
        return not self._bent and not self._hidden

    @cached_property
    def products(self) -> int:
        """Of series, in each round."""
        return self._piece(0).products

    def series(self, t: int, bits: int) -> "tuple[Computed, int | None, int | None]":
        """(the series of the motion about an instant, the instant up to which they hold, the longest step)."""
        if self.rests:
            return resting, None, None
        if bits not in self._instants:
            self._instants[bits] = [self._refined(time, bits) for time in self.times]
        instants = self._instants[bits]
        number = sum(instant <= t for instant in instants)
        longest = fixed_point(self.until / PARTS, bits) if self._hidden else None
        computed = self._computed(self._piece(number), t, bits)
        return computed, instants[number] if number < len(instants) else None, longest

    def _computed(self, piece: MotionSeries, t: int, bits: int) -> "Computed":
        """The series of a piece that t lies in."""
        if (piece, bits) not in self._compiled:
            self._compiled[piece, bits] = piece.with_bits(self.values(bits), bits)
        found: Computed = self._compiled[piece, bits]
        return found

    def _piece(self, number: int) -> MotionSeries:
        """The MotionSeries between two breaks."""
        ends = [0.0, *self.times, self.until]
        middle = 0.5 * (ends[number] + ends[number + 1])
        nodes, senses = self.parts.nodes(), []
        while remaining := bent(nodes):
            instead = {part: self._on_one_side(part, middle) for part in remaining if not bent(part.args)}
            senses += instead.values()
            nodes = substitute(nodes, instead)
        key = tuple(senses)
        if key not in self._pieces:
            self._pieces[key] = MotionSeries(self.scene, self.parts.made_of(nodes))
        found: MotionSeries = self._pieces[key]
        return found

    def _on_one_side(self, part: "Node", middle: float) -> "Node":
        """What stands for a part in a piece with this middle."""
        table, u = part.table, part.args[0]
        turns, order = self._at(u, middle), part.args[1].coefficient if len(part.args) > 1 else 0
        if part.name in ("min", "max"):
            larger = self._at(u - part.args[1], middle) > 0
            found: Node = part.args[0] if larger == (part.name == "max") else part.args[1]
            return found
        if part.name == "square":
            return table.number((1 - 2 * int(turns / 3.141592653589793 // 1 % 2)) * (not order))
        if part.name == "sawtooth":
            below = int(turns / 6.283185307179586 // 1)
            result: Node = [u / table.pi - table.number(2 * below + 1), 1 / table.pi, table.zero][min(order, 2)]
            return result
        sense = 1 if turns >= 0 else -1
        value: Node = {"abs": u * sense, "sign": table.number(sense), "step": table.number((1 + sense) // 2),
                         "ramp": u * ((1 + sense) // 2)}[part.name]
        return value

    def _at(self, node: "Node", t: float) -> float:
        found: float = evaluate([node], Floats, {**self.floats, self.scene.time.name: t})[0]
        return found

    def _refined(self, time: float, bits: int) -> int:
        """The instant of a break to so many bits."""
        import mpmath

        with mpmath.workprec(bits + 30):
            values, arithmetic, best = self.values(bits), multiprecision(), None
            for part in self._bent:
                g = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0]
                rate = gradient(g).get(self.scene.time)
                if rate is None:
                    continue
                step = _newton(arithmetic, values, self.scene.time.name, (g, rate), part.name in PERIODIC)
                change = step(mpmath.mpf(time))
                if change is not None and abs(change) <= NEAR * time and (best is None or abs(change) < best[0]):
                    best = abs(change), step
            if best is None:
                raise PhysicsError(f"the instant near t = {time:.6g} s at which what drives this motion bends or jumps "
                                   "is not found to more digits", WITHOUT)
            found = mpmath.mpf(time)
            for _ in range(bits.bit_length() + 3):
                found += best[1](found)
            return fixed_point(found, bits)


def _newton(arithmetic: "RunningErrors", values: "Mapping[str, mpmath.mpf]", time: str, nodes: "tuple[Node, Node]",
            periodic: bool) -> "Callable[[mpmath.mpf], mpmath.mpf]":
    """−g/ġ at an instant; of what is periodic in g, from the nearest multiple of π."""
    import mpmath

    def step(t: "mpmath.mpf") -> "mpmath.mpf | None":
        g, rate = evaluate(nodes, arithmetic, {**values, time: t})
        g -= mpmath.pi * mpmath.nint(g / mpmath.pi) if periodic else 0
        return -g / rate if rate else None
    return step
