"""Numbers of a motion to as many digits as are asked for: by two marches of different order that agree on them.

Neighbouring motions part, in chaos exponentially. How many digits that takes is seen where a first march of few digits
parts from one of more, and later from how many digits two of them share: so many more are carried along.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import ceil, inf
from typing import TYPE_CHECKING

from vibcli.analyses.time_integration.taylor_march import TaylorMarch
from vibcli.base.errors import PhysicsError
from vibcli.base.work import counted
from vibcli.numerics.precision import price

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.time_integration.smooth_pieces import SmoothPieces
    from vibcli.base.work import Task, Work

MOST = 600              # steps of a million products
FEW, FEWEST = 15, 3     # digits of the first march, and those that it shares at least where its loss is read off
LOOKS = 32              # instants at which that is looked at
GUARD, MORE, OTHER_ORDER = 10, 3, 7     # digits carried along; more of the second march, and terms of its series
ROUNDS = 4
FIRST_STEPS, PROBED = 5, 200            # after which the work is estimated, and by which a loss is seen
MOST_PATIENCE = 1_000_000
FASTER = 1.5            # than is seen: how fast digits may be lost where none is shared


class ProvenMotion:
    """A motion whose equations are SmoothPieces, from start(bits) = [q, q̇] in fixed point; sizes: of the figure along
    the coordinates, beside which what is smaller by all digits is nothing."""

    def __init__(self, pieces: "SmoothPieces", start: Callable[[int], list[int]], sizes: "Sequence[float]",
                 work: "Work") -> None:
        self.pieces, self.start, self.sizes, self.work = pieces, start, sizes, work
        self._marches: list[TaylorMarch] = []
        self._loss = -1.0               # digits that are lost in a second; negative: not known yet

    def found(self, question: "Callable[[TaylorMarch], mpmath.mpf]", digits: int, until: "Fraction",
              size: "Callable[[TaylorMarch], mpmath.mpf] | None" = None) -> "mpmath.mpf":
        """What is asked of a march up to an instant, to so many correct digits; 0 of what is nothing by all of these
        beside a size that is asked likewise."""
        more = 0
        for _ in range(ROUNDS):
            first, second = self._pair(digits + more, until)
            found = question(second)
            other = question(first)
            shared = _shared_digits(other, found)
            if shared > digits:
                return found
            if size is not None and 10**digits * max(abs(found), abs(other)) < size(second):
                return 0 * found
            more += ceil(digits - shared) + MORE
        raise PhysicsError(f"{digits} digits of this are not found at t = {float(until):.6g} s: it is 0, or nothing "
                           "but rounding", "leave --digits out, or ask for an instant beside")

    def followed(self, digits: int, until: "Fraction") -> TaylorMarch:
        """A march up to an instant whose states are correct to so many digits of the motion."""
        return self._pair(digits, until)[1]

    def is_affordable(self, digits: int, until: "Fraction", loss: float) -> bool:
        """Are marches of so many digits up to an instant at most half the work that is allowed, as far as their first
        steps show it, where `loss` digits are lost in a second?"""
        march = self._march(digits + GUARD + MORE + ceil(loss * until))
        while len(march.steps) < FIRST_STEPS:
            march.reach(march.end + 1)
        steps = 2 * len(march.steps) * float(until) / float(Fraction(march.end, 1 << march.bits))
        return 2 * steps * self._cost(march.order, march.bits) <= MOST * self.work.patience

    def _pair(self, digits: int, until: Fraction) -> list[TaylorMarch]:
        """Two marches that agree on so many digits of the motion."""
        with self.work.task("the series of this motion", MOST) as task:
            if until and self._loss < 0:
                self._look_ahead(digits, until, task)
            for _ in range(ROUNDS):
                carried = digits + max(GUARD, ceil(max(self._loss, 0.0) * until) + MORE)
                if not self._marches or self._marches[0].digits < carried:
                    self._marches = [self._march(carried)]
                first = self._marches[0]
                if len(self._marches) < 2:
                    self._marches.append(self._march(first.digits + MORE, OTHER_ORDER))
                for march in self._marches:
                    self._follow(march, until, task)
                shared = first.shared_digits(self._marches[1], until)
                if shared > digits or not until:
                    return self._marches
                self._lose(first.digits, shared, until)
        raise PhysicsError(f"{digits} digits of this motion are not found up to t = {float(until):.6g} s",
                           "ask for fewer digits or an earlier instant")

    def _lose(self, carried: int, shared: float, time: Fraction) -> None:
        """Of the digits that were carried so few are shared at an instant."""
        faster = FASTER if shared < FEWEST else 1.0
        self._loss = max(self._loss, faster * (carried - shared) / float(time))

    def _look_ahead(self, digits: int, until: Fraction, task: "Task") -> None:
        """How fast digits are lost: where a march of few of them parts from one of more."""
        few, more = self._march(FEW), self._march(max(digits, FEW) + GUARD)
        for number in range(1, LOOKS + 1):
            time = until * number / LOOKS
            self._follow(few, time, task, more.digits, until)
            self._follow(more, time, task)
            shared = few.shared_digits(more, time)
            if shared < FEWEST or number == LOOKS:
                self._loss, self._marches = max(FEW - shared, 0.0) / float(time), [more]
                break

    def _march(self, digits: int, extra: int = 0) -> TaylorMarch:
        return TaylorMarch(self.pieces.series, self.start, self.sizes, digits, extra,
                           lambda march: counted(self._cost(march.order, march.bits)))

    def _cost(self, order: int, bits: int) -> float:
        """Of a step, in millions of products."""
        return self.pieces.products * order**2 / 2 * price(bits) / 1e6

    def _follow(self, march: TaylorMarch, time: Fraction, task: "Task", digits: int | None = None,
                until: Fraction | None = None) -> None:
        """March up to an instant; up to `until` two marches of so many digits must be no more work than is allowed."""
        until, end = until or time, (time.numerator << march.bits) // time.denominator
        while march.end < end and len(march.steps) < FIRST_STEPS:
            march.reach(march.end + 1)
        if march.end < end:
            last = (until.numerator << march.bits) // until.denominator
            steps, planned = 2 * len(march.steps) * (last / march.end), self._march(digits or march.digits)
            if steps * self._cost(planned.order, planned.bits) > task.limit:
                raise self._too_long(steps, planned.digits, until, task)
        march.reach(end)

    def _too_long(self, steps: float, digits: int, until: Fraction, task: "Task") -> PhysicsError:
        """The refusal, with the digits that will be lost as far as that is seen."""
        planned = self._march(digits + ceil(self._seen_loss() * until) * (self._loss < 0))
        needed = steps * self._cost(planned.order, planned.bits)
        patience = ceil(2 * needed * self.work.patience / task.limit)
        more = f", or allow more with --patience {patience}" if patience <= MOST_PATIENCE else ""
        return PhysicsError(f"to follow this motion with {planned.digits} digits up to t = {float(until):.6g} s would "
                            f"take about {needed:.0f} steps of a million products each; the limit is "
                            f"{task.limit:.0f}", "ask for fewer digits or an earlier instant" + more)

    def _seen_loss(self) -> float:
        """How fast digits are lost, from a few steps."""
        few, more = self._march(FEW), self._march(2 * FEW)
        for _ in range(PROBED):
            few.reach(few.end + 1)
        end = Fraction(few.end, 1 << few.bits)
        half, whole = (max(few.shared_digits(more, time), 0.0) for time in (end / 2, end))
        return max(half - whole, 0.0) / float(end / 2)


def _shared_digits(one: "mpmath.mpf", other: "mpmath.mpf") -> float:
    import mpmath

    if one == other:
        return inf
    return float(-mpmath.log10(abs(one - other) / abs(other))) if other else 0.0
