"""Signals of small motions at the working precision of mpmath, and the digits that two precisions agree in."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, reduce
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NoReturn

import mpmath
from mpmath import mp

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.symbolic.node import Node

GUARD, MORE, TRIES, NOISE = 30, 25, 12, 1e12
ENVELOPE = "envelope"
RATE = " rate"       # of a signal within another


def agreed(compute: "Callable[[], list[mpmath.mpf]]", digits: int, size: float = 0.0,
           died_out: float = 0.0) -> "list[mpmath.mpf]":
    """Numbers correct to `digits`, or to as many of `size`: computed at ever higher precision until two results agree.

    What stays at the last places of three precisions is 0, unless it may have died out by so many digits more.
    """
    precision, tries = digits + GUARD, []
    for _ in range(TRIES):
        with mpmath.workdps(precision):
            try:
                found = compute()
            except ArithmeticError:
                raise PhysicsError("more digits of this are not found: a system of equations is singular",
                                   "leave --digits out") from None
            tries.append((precision, found))
            rests = [_vanishes([(places, numbers[i]) for places, numbers in tries if places > died_out + digits])
                     for i in range(len(found))]
            small = mp.mpf(10) ** (-digits - 1)
            if len(tries) > 1 and all(nothing or (abs(x - y) <= max(abs(x), size) * small and (x or size)) for
                                      x, y, nothing in zip(found, tries[-2][1], rests, strict=True)):
                return [mp.mpf(0) if nothing else x for x, nothing in zip(found, rests, strict=True)]
        precision += max(MORE, precision // 3)
    raise PhysicsError(f"{digits} digits of this are not found: it is zero, or so nearly that {tries[-1][0]} digits do "
                       "not tell", "ask for it at an earlier instant, or leave --digits out")


def _vanishes(tries: Sequence[tuple[int, mpmath.mpf]]) -> bool:
    """Is a number zero at two precisions, or but rounding, x·10^precision not growing over three or more?"""
    sizes = [abs(x) * mp.mpf(10) ** places for places, x in tries if x]
    return (len(tries) > 1 and not sizes) or (len(tries) > 2 and all(
        later <= NOISE * sooner for sooner, later in pairwise(sizes)))


class PreciseLinear:
    """A linear output of a PreciseMotion, or of what is left of one."""

    def __init__(self, motion: Any, output: "LinearOutput") -> None:
        self.motion, self.output = motion, output

    def at(self, time: "mpmath.mpf", before: bool = False) -> "LinearInstant":
        """What is known of it at a time, just after what jumps there, or just before it."""
        return LinearInstant(self.motion.at(time, mp.prec, before), self.output)

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """The instants up to a time at which its loads bend or jump."""
        found: list[mpmath.mpf] = self.motion.breaks(until)
        return found

    @cached_property
    def steady(self) -> "PreciseLinear":
        from vibcli.analyses.transient.high_precision_steady import steady_motion

        return PreciseLinear(steady_motion(self.motion), self.output)

    @cached_property
    def transient(self) -> "PreciseLinear":
        from vibcli.analyses.transient.high_precision_steady import TransientMotion

        return PreciseLinear(TransientMotion(self.motion), self.output)

    @property
    def envelope(self) -> NoReturn:
        raise PhysicsError("more digits of what holds an envelope are not found", "leave --digits out")


class LinearInstant:
    """A PreciseLinear at an instant."""

    def __init__(self, state: Any, output: "LinearOutput") -> None:
        self.state, self.output = state, output

    def read(self, highest: int, by: Any = 0) -> "list[mpmath.mpf]":
        """It and its derivatives, a little later."""
        state = self.state.later(by) if by else self.state
        return [state.read(self.output, order) for order in range(highest + 1)]


class PreciseComposed:
    """A function of signals, instant by instant; closing: Closing of coordinates that close loops, or None."""

    def __init__(self, node: "Node", signals: "Mapping[str, PreciseLinear]", values: "Mapping[str, mpmath.mpf]",
                 time: "Node", arithmetic: Any, closing: Any = None) -> None:
        self.node, self.signals, self.values, self.time = node, signals, values, time
        self.arithmetic, self.closing = arithmetic, closing

    def derivative(self, order: int) -> "Node":
        """Its derivative as a function of the signals x, "x rate" and "x rate rate"."""
        node = self.node
        for _ in range(order):
            slopes = gradient(node)
            node = node.table.total([slopes.get(self.time, node.table.zero), *(
                slope * node.table.variable(symbol.name + RATE) for symbol, slope in slopes.items()
                if symbol is not self.time)])
        return node

    def at(self, time: "mpmath.mpf", before: bool = False) -> "ComposedInstant":
        """What is known of it at a time, as of PreciseLinear."""
        free = {} if self.closing is None else self.closing.free
        return ComposedInstant(self, time, {name: signal.at(time, before)
                                            for name, signal in {**self.signals, **free}.items()})

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """The instants up to a time at which the loads of any part bend or jump."""
        return [at for signal in self.signals.values() for at in signal.breaks(until)]

    @cached_property
    def steady(self) -> "PreciseComposed":
        signals = {name: signal.steady for name, signal in self.signals.items()}
        return PreciseComposed(self.node, signals, self.values, self.time, self.arithmetic, self.closing)

    @cached_property
    def transient(self) -> "PreciseDifference":
        return PreciseDifference(self, self.steady)


class ComposedInstant:
    """A PreciseComposed at an instant."""

    def __init__(self, signal: PreciseComposed, time: "mpmath.mpf", parts: Mapping[str, LinearInstant]) -> None:
        self.signal, self.time, self.parts = signal, time, parts

    def read(self, highest: int, by: Any = 0) -> "list[mpmath.mpf]":
        """It and its derivatives, a little later."""
        values = {**self.signal.values, self.signal.time.name: self.time + by}
        for name, part in self.parts.items():
            values |= {name + RATE * order: value for order, value in enumerate(part.read(highest, by))}
        if self.signal.closing is not None:
            values |= self._closed(values, highest)
        nodes = [self.signal.derivative(order) for order in range(highest + 1)]
        found = evaluate(nodes, self.signal.arithmetic, values)
        if not mpmath.isfinite(found[0]) or mpmath.im(found[0]):
            raise PhysicsError(f"this signal has no finite real value at t = {float(self.time):.6g} s",
                               "mind its divisors and what stands under roots and in logarithms")
        return found


    def _closed(self, values: Mapping[str, mpmath.mpf], highest: int) -> dict[str, mpmath.mpf]:
        """{name: number} of the coordinates that close loops."""
        if highest:
            raise PhysicsError("more digits of extremes and zeros are not found of what hangs on coordinates that "
                               "close loops", "ask for values at instants")
        loops, rest = self.signal.closing.loops, self.signal.closing.rest
        found = loops.refined({**values, **{name: rest[name] for name in loops.names}}, self.signal.arithmetic)
        return {name: found[name] for name in loops.names}


class PreciseDifference:
    """One signal less another."""

    def __init__(self, one: Any, two: Any) -> None:
        self.parts = one, two

    def at(self, time: "mpmath.mpf", before: bool = False) -> "DifferenceInstant":
        """What is known of it at a time, as of PreciseLinear."""
        return DifferenceInstant(*(part.at(time, before) for part in self.parts))

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """The instants up to a time at which the loads of either bend or jump."""
        return [at for part in self.parts for at in part.breaks(until)]


class DifferenceInstant:
    """A PreciseDifference at an instant."""

    def __init__(self, one: Any, two: Any) -> None:
        self.one, self.two = one, two

    def read(self, highest: int, by: Any = 0) -> "list[mpmath.mpf]":
        """It and its derivatives, a little later."""
        return [x - y for x, y in zip(self.one.read(highest, by), self.two.read(highest, by), strict=True)]


def precise_signal(source: Sequence[Any]) -> Any:
    """The precise signal, at the working precision, of the `source` of a signal in floats."""
    response, tree, *parts = source
    found = response.precise.signal(tree)
    for number, part in enumerate(parts):
        if part == ENVELOPE:
            floats = reduce(getattr, parts[:number + 1], response.signal(tree))
            found = response.precise.envelope(found, floats.parts)
        else:
            found = getattr(found, part)
    return found
