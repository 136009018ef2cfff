"""A motion in Taylor series whose forces bend or jump with it: each step ends where one does, and the next one follows
the equations of the side beyond."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.features import passage
from vibcli.evidence.reference.switches import STICKS, Switches
from vibcli.evidence.reference.taylor_steps import LONGER, TaylorSteps
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.evidence.reference.switches import Sides
    from vibcli.evidence.reference.taylor_steps import TaylorStep
    from vibcli.evidence.subject import Deadline
    from vibcli.symbolic.node import Node

LOOKS = 16              # at what may vanish, in a step
TOGETHER = 8            # bends at one instant
CLOSER = 40             # halvings of the time after a bend before which another one may be


class SwitchedSteps(TaylorSteps):
    """The motion of Switches; values(bits): {parameter: number}; as TaylorSteps."""

    def __init__(self, switches: Switches, values: Callable[[int], Mapping[str, Any]],
                 start: Callable[[int], Sequence[int]], until: Fraction, digits: int, work: float) -> None:
        self._switches, self._values, self._modes, self._sizes = switches, values, [], {}
        self._forms: dict[tuple[Any, ...], list[Node]] = {}
        super().__init__(switches, start, until, digits, work)

    def forms(self, nodes: "Sequence[Node]", t: int) -> "list[Node]":
        """Expressions as they are at an instant in fixed point."""
        mode = self._modes[self.place(t)]
        key = id(mode), tuple(nodes)
        if key not in self._forms:
            self._forms[key] = self._switches.resolved(nodes, mode)
        return self._forms[key]

    def _march(self, switches: Switches, state: list[int], end: int, _: "Deadline") -> None:
        t, scale, sizes, together = 0, max(end >> 6, 1), [abs(x) for x in state], 0
        mode = self._mode_at_start(state)
        while t < end:
            compute, limit, longest = mode.pieces.series(t, self.bits)
            stop = end if limit is None else min(end, limit)
            step, after, spare = self._stepped(compute, t, min(scale, longest or scale), state, sizes, stop, end)
            self.steps.append(step)
            self._modes.append(mode)
            self.breaks += [step.end] * (step.end == limit)
            event = self._event(mode, step)
            if event is not None:
                at, switch = event
                self.steps[-1] = step = step._replace(end=at)
                self.breaks.append(at)
                after = [self.summed(row, step, at) for row in (*step.rows[0], *step.rows[1])]
                mode = self._beyond(mode, switch, at, after)
                together = together + 1 if at == t else 0
                if together > TOGETHER:
                    raise PhysicsError("no reference is found of forces that bend again and again at one instant")
            sizes = [max(size, abs(x)) for size, x in zip(sizes, after, strict=True)]
            t, state, scale = step.end, after, max(int(step.scale * min(LONGER, 2.0 ** (spare / self.order))), 1)
        self.sizes = [x / 2**self.bits for x in sizes]

    def _seen(self, nodes: "Iterable[Node]", t: int, rows: Sequence[list[int]]) -> list[mpmath.mpf]:
        """Expressions at an instant, of [q], [q̇], [q̈] in fixed point."""
        scene = self._switches.scene
        with mpmath.workprec(2 * self.bits):
            known = {**self._values(self.bits), scene.time.name: mpmath.ldexp(t, -self.bits)}
            for primes, row in zip(("", "'", "''"), rows, strict=True):
                known |= {name + primes: mpmath.ldexp(x, -self.bits)
                          for name, x in zip(scene.coordinates, row, strict=True)}
            return evaluate(list(nodes), multiprecision(), known)

    def _along(self, nodes: "Sequence[Node]", step: "TaylorStep", t: int) -> list[mpmath.mpf]:
        return self._seen(nodes, t, [[self.summed(row, step, t) for row in rows] for rows in step.rows])

    def _event(self, mode: "Sides", step: "TaylorStep") -> "tuple[int, tuple[Node, int]] | None":
        """(the first instant of a step at which something watched vanishes, (argument, sense beyond)), or None."""
        nodes = [node for *_, node in mode.watched]
        before, span = step.start, step.end - step.start
        for k in range(1, LOOKS + 1):
            t = step.start + span * k // LOOKS
            passed = [i for i, x in enumerate(self._along(nodes, step, t)) if self._is_beyond(nodes[i], x)]
            if any(mode.watched[i][0] is None for i in passed):
                raise PhysicsError("the reference finds that a rope goes slack")
            if passed:
                at, i = min((self._passage(nodes[i], step, before, t), i) for i in passed)
                return at, mode.watched[i][:2]
            before = t
        return None

    def _is_beyond(self, node: "Node", x: mpmath.mpf) -> bool:
        size = self._sizes[node] = max(self._sizes.get(node, 0), abs(x))
        return cast("bool", x < -mpmath.ldexp(size, -self.accuracy // 2))

    def _passage(self, node: "Node", step: "TaylorStep", low: int, high: int) -> int:
        def at(t: int) -> mpmath.mpf:
            return self._along([node], step, t)[0]

        near = high
        for _ in range(CLOSER):
            if at(low) > 0 or at(near) > 0:
                break
            near = low + (near - low) // 2
        else:
            raise PhysicsError("no reference is found of a force that bends and goes on as it was")
        return passage(at, (low if at(low) > 0 else near, high), self)

    def _mode_at_start(self, state: list[int]) -> "Sides":
        switches, senses, tiny = self._switches, dict.fromkeys(self._switches.arguments, 1), []
        rows = self._rows(switches.mode(senses), 0, state)
        for u, x in zip(senses, self._seen(senses, 0, rows), strict=True):
            if abs(x) > mpmath.ldexp(1, -self.accuracy // 2):
                senses[u] = 1 if x > 0 else -1
            else:
                tiny.append(u)
        for u in sorted(tiny, key=switches.at_speed, reverse=True):
            senses[u] = self._sense_of(u, senses, 0, state)
        return switches.mode(senses)

    def _sense_of(self, u: "Node", senses: "Mapping[Node, int]", t: int, state: list[int]) -> int:
        """That which an argument has just after an instant at which it is zero: by its rate, or the second one."""
        switches, scene = self._switches, self._switches.scene
        rates = {}
        for sense in (1, -1):
            mode = switches.mode({**senses, u: sense})
            rows = self._rows(mode, t, state)
            rate = switches.resolved([scene.rate(u)], mode)
            rates[sense] = self._seen(rate, t, rows)[0]
            if not switches.at_speed(u) and abs(rates[sense]) <= mpmath.ldexp(1, -self.accuracy // 2):
                rates[sense] = self._seen(switches.resolved([scene.rate(scene.rate(u))], mode), t, rows)[0]
        if rates[1] <= 0 <= rates[-1] and switches.at_speed(u) and rates[1] != rates[-1]:
            return STICKS
        return 1 if rates[1] > 0 else -1

    def _rows(self, mode: "Sides", t: int, state: list[int]) -> list[list[int]]:
        """[q], [q̇], [q̈] of a state in a mode."""
        found = mode.pieces.series(t, self.bits)[0](t, max(1, 1 << self.bits), state, 1)
        return [[row[0] for row in rows] for rows in (found.q, found.v, found.a)]

    def _beyond(self, mode: "Sides", switch: "tuple[Node, int]", t: int, state: list[int]) -> "Sides":
        """The Sides after one that ends."""
        u, sense = switch
        senses = dict(mode.senses)
        if senses[u] != STICKS and self._switches.at_speed(u):
            sense = self._sense_of(u, senses, t, state)
        return self._switches.mode({**senses, u: sense})

