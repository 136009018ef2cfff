"""Signals in time: values at any instant, extremes, passages through zero; the exact ones of linear motions, and those
that are composed of them."""

from collections.abc import Mapping
from functools import cached_property
from math import inf, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.work import Work
from vibcli.results.signal import Signal, part_of, require_finite
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.composition import Composition, Leaf
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.sampled_extremes import SampledSearch
    from vibcli.results.envelope import Envelope
    from vibcli.symbolic.node import Node


EQUAL = 1e-12       # relative distance of periods that are one


class LinearSignal(Signal):
    """A linear output of a linear motion. part: "steady" or "transient" where it is that of another; source: the
    response and the tree it was asked as, and the parts of that which it is."""

    LOOKED = 1

    def __init__(self, motion: "LinearMotion", output: "LinearOutput", part: str = "",
                 source: tuple[Any, ...] = ()) -> None:
        self.motion, self.output, self.part, self.source = motion, output, part, source

    def values(self, times: "np.ndarray", order: int = 0) -> "np.ndarray":
        return self.motion.values(self.output, times, order)

    def error(self, t: float) -> float:
        import numpy as np

        return float(self.motion.errors(self.output, np.array([t]))[0])

    def error_of_time(self, t: float) -> float:
        from vibcli.analyses.transient.instant_errors import of_top

        return of_top(self.motion, self.output, t)

    def error_of_zero(self, t: float) -> float:
        from vibcli.analyses.transient.instant_errors import of_passage

        return of_passage(self.motion, self.output, t)

    def error_of_final(self) -> float:
        from vibcli.results.feature_errors import final

        return final(self)

    def told_zero(self, t: float) -> float:
        """A share of what terms would be with coordinates as large as the largest of them."""
        from vibcli.results.known_digits import share_of_terms

        return share_of_terms(self.motion, self.output, t)

    def along(self, end: float) -> "Leaf":
        from vibcli.analyses.transient.composition import Leaf

        return Leaf(self.motion.pieces(end), self.output)

    @cached_property
    def period(self) -> float | None:
        """After which the steady state repeats itself, None where it does not; of others, None."""
        from vibcli.results.steady_features import fundamental

        try:
            return tau / fundamental(self) if self.part == "steady" else None
        except PhysicsError:
            return None

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        end = min(end, start + (self.period or end))      # later ones are the same but for rounding
        return self.motion.extreme(self.output, start, end, "max" if sense > 0 else "min")

    def rivals(self, start: float, end: float, sense: int, margin: float) -> list[float]:
        """The instants at which it comes within a margin of its largest or smallest value."""
        from vibcli.analyses.transient.extremes import rivals

        end = min(end, start + (self.period or end))
        return rivals(self.motion.pieces(end), self.output, start, end, "max" if sense > 0 else "min", margin,
                      self.motion.work)

    def zeros(self, start: float, end: float) -> "np.ndarray":
        return self.motion.zeros(self.output, start, end)

    def final(self) -> float:
        return self.motion.final(self.output)

    @cached_property
    def steady(self) -> "LinearSignal":
        self.motion.steady.require_held(self.output)
        return LinearSignal(self.motion.steady, self.output, "steady", part_of(self.source, "steady"))

    @cached_property
    def transient(self) -> "LinearSignal":
        self.motion.steady.require_held(self.output)
        return LinearSignal(self.motion.transient, self.output, "transient", part_of(self.source, "transient"))

    @cached_property
    def envelope(self) -> "Envelope":
        from vibcli.results.envelope import Envelope

        return Envelope(self)

    @property
    def phasors(self) -> list[tuple[float, complex]]:
        """[(Ω, complex X)] of the steady state Re Σ X e^{iΩt}, by ascending Ω."""
        from vibcli.results.steady_features import harmonics

        return harmonics(self)


class ComposedSignal(Signal):
    """A function of signals, instant by instant; `node` in symbols that `signals` names, and in the time."""

    KIND, LOOKED, MORE = "a signal composed of others", 1, "ask for its parts"

    def __init__(self, node: "Node", signals: Mapping[str, LinearSignal], floats: Mapping[str, Any], time: "Node",
                 closing: Any = None, work: Work | None = None,
                 source: tuple[Any, ...] = ()) -> None:
        self.node, self.signals, self.floats, self.time, self.closing = node, signals, floats, time, closing
        self.work, self.source = work or Work(), source

    def values(self, times: Any, order: int = 0) -> "np.ndarray":
        if order:
            raise PhysicsError("rates of products of signals are not found", "ask for the signal itself")
        found = self.composed(times, {name: signal.values(times) for name, signal in self.signals.items()})
        return require_finite(found, times)

    def composed(self, times: Any, known: Mapping[str, Any]) -> "np.ndarray":
        """Its values, given those of its signals, and others for its numbers perhaps."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays

        with np.errstate(all="ignore"):
            values = {**self.floats, self.time.name: np.asarray(times), **known}
            values |= {} if self.closing is None else self.closing.values(times, values)
            found = evaluate([self.node], Arrays, values)[0]
        return np.broadcast_to(found, np.shape(times))

    @property
    def is_estimated(self) -> bool:
        return any(signal.is_estimated for signal in self.signals.values())

    @property
    def names(self) -> set[str]:
        """The names of the symbols that it holds."""
        from vibcli.symbolic.expression_graph import reachable

        return {symbol.name for symbol in reachable([self.node]) if symbol.op == "symbol"}

    def error(self, t: float) -> float:
        from vibcli.results.composed_errors import of_value

        return of_value(self, t, {name: one.error(t) for name, one in self.parts.items()})

    def told_zero(self, t: float) -> float:
        """What its parts make of it that are as large as what is told to be zero of them."""
        from vibcli.results.composed_errors import of_value

        zeros = {name: one.told_zero(t) for name, one in self.parts.items()}
        return inf if inf in zeros.values() else of_value(self, t, zeros)

    @property
    def parts(self) -> "dict[str, Signal]":
        """The signals that it is a function of, those that close loops too."""
        return {**self.signals, **(self.closing.free if self.closing is not None else {})}

    def error_of_time(self, t: float) -> float:
        from vibcli.results.composed_errors import of_instant

        return of_instant(self, t, 1)

    def error_of_zero(self, t: float) -> float:
        from vibcli.results.composed_errors import of_instant

        return of_instant(self, t, 0)

    def error_of_final(self) -> float:
        from vibcli.results.composed_errors import propagated
        from vibcli.symbolic.evaluation import Floats

        return propagated(lambda known: evaluate([self.node], Floats, {**self.floats, **known})[0],
                          {name: signal.final() for name, signal in self.signals.items()},
                          {name: signal.error_of_final() for name, signal in self.signals.items()})

    def along(self, end: float) -> "Composition":
        """The Composition of the outputs up to an instant; KeyError where it holds what has no known bounds."""
        from vibcli.analyses.transient.composition import Composition

        if self.closing is not None:
            raise KeyError("loops")
        leaves = {name: signal.along(end) for name, signal in self.signals.items()}
        return Composition(self.node, leaves, self.floats, self.time.name, require_finite, end)

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        from vibcli.analyses.transient.extremes import extreme

        end = min(end, start + (self.period or end))
        try:
            return extreme(self.along(end), None, start, end, "max" if sense > 0 else "min", self.work)
        except KeyError:
            return self._sampled(start, end).extreme(sense)

    def _sampled(self, start: float, end: float) -> "SampledSearch":
        """The SampledSearch between two instants, kept until others are asked for."""
        from vibcli.analyses.transient.sampled_extremes import SampledSearch

        asked, known = (start, end), getattr(self, "_search", None)
        if known is None or known[0] != asked:
            known = self._search = asked, SampledSearch(self.values, start, end, self.work)
        return known[1]

    def rivals(self, start: float, end: float, sense: int, margin: float) -> list[float]:
        """The instants at which it comes within a margin of its largest or smallest value; KeyError where it holds what
        has no known bounds."""
        from vibcli.analyses.transient.extremes import rivals

        end = min(end, start + (self.period or end))
        return rivals(self.along(end), None, start, end, "max" if sense > 0 else "min", margin, self.work)

    def zeros(self, start: float, end: float) -> list[float]:
        """Instants at which the signal passes or touches zero."""
        from vibcli.analyses.transient.zeros import zeros

        try:
            found: list[float] = zeros(self.along(end), None, start, end, self.work).tolist()
            return found
        except KeyError:
            return self._sampled(start, end).zeros()

    @property
    def period(self) -> float | None:
        """After which it repeats itself from t = 0 on, None where that is not known."""
        periods = [signal.period for signal in self.signals.values()]
        if self.node.mask & self.time.mask or None in periods or not periods:
            return None
        return max(periods) if max(periods) - min(periods) <= EQUAL * max(periods) else None

    def final(self) -> float:
        self.require_no_time("limit")
        from vibcli.symbolic.evaluation import Floats

        try:
            values = {name: signal.final() for name, signal in self.signals.items()}
        except PhysicsError as error:
            raise PhysicsError("no limit of a signal composed of others is found where one of them has none: "
                               + error.message, "ask for a value at a late instant") from None
        found: float = evaluate([self.node], Floats, {**self.floats, **values})[0]
        return found

    @cached_property
    def steady(self) -> "ComposedSignal":
        self.require_no_time("steady state")
        return ComposedSignal(self.node, {name: signal.steady for name, signal in self.signals.items()}, self.floats,
                              self.time, work=self.work, source=part_of(self.source, "steady"))

    def require_no_time(self, what: str) -> None:
        """Refuses what holds the time beside its signals."""
        if self.node.mask & self.time.mask or self.closing is not None:
            raise PhysicsError(f"the {what} of what holds a driven motion in a product is not found",
                               "ask for its values at instants, or for max and min")

    @cached_property
    def transient(self) -> "TransientOfComposed":
        """It less its steady part."""
        from vibcli.symbolic.derivatives import substitute
        from vibcli.symbolic.expression_graph import reachable

        table, signals, instead = self.node.table, dict(self.signals), {}
        for symbol in reachable([self.node]):
            if symbol.op == "symbol" and symbol.name in self.signals:
                instead[symbol] = table.variable(f"steady {symbol.name}")
                signals[f"steady {symbol.name}"] = self.steady.signals[symbol.name]
        node = self.node - substitute([self.node], instead)[0]
        return TransientOfComposed(node, signals, self.floats, self.time, work=self.work,
                                   source=part_of(self.source, "transient"))


class TransientOfComposed(ComposedSignal):
    """What dies out of a composed signal."""

    KIND = "the transient part of a composed signal"
