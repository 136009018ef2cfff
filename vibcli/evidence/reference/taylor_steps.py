"""A motion in Taylor series of fixed-point numbers, step by step: true where two numbers of digits agree.

A step is as long as its last coefficients are below the digits asked for; those of more digits are of another order and
length. The coefficients come from the equations (analyses/time_integration/smooth_pieces.py), which are smooth between
the instants at which what drives the motion bends.
"""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from fractions import Fraction
from math import ceil, log2
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.time_integration.motion_series import Coefficients
    from vibcli.evidence.reference.blows import Blows
    from vibcli.evidence.reference.records import PiecesOfRecords
    from vibcli.symbolic.node import Node

SPARE = 64              # bits below the digits asked for
LAST = 3                # coefficients that have to be small
ROUNDED = 16            # bits, of fixed points: what is no larger may be rounding alone
ASTRAY = 16             # bits, of what accelerations at the end of a step may lack
SHORTER, LONGER = 0.5, 1.25
SHORTEST = 1e-30        # of the motion


class TaylorStep(NamedTuple):
    """Rows of coefficients of s = (t − start)/scale for q, q̇ and q̈, all numbers fixed points."""

    start: int
    end: int
    scale: int
    rows: tuple[list[Any], list[Any], list[Any]]


class TaylorSteps:
    """The motion of SmoothPieces from start(bits), [q, q̇] in fixed point, up to `until` s, to about so many digits.
    work: how many products of numbers it may take; PhysicsError of one that takes more; sizes: the largest magnitude of
    each of q and q̇, as floats; breaks: instants at which forces may jump. blows(bits): instants at which
    q̇ jumps, and by how much, ascending."""

    def __init__(self, pieces: Any, start: Callable[[int], Sequence[int]], until: Fraction, digits: int, work: float,
                 blows: "Callable[[int], Blows] | None" = None) -> None:
        self.accuracy, self.bits, self.order = ceil(digits * log2(10)), bits_of(digits), ceil(1.3 * digits)
        self.steps: list[TaylorStep] = []
        self.breaks: list[int] = []
        self.sizes: list[float] = []
        self._price, self._left = pieces.products * self.order**2 * max(1.0, self.bits / 512), work
        self._march(pieces, list(start(self.bits)), max(1, self.fixed(until)), blows(self.bits) if blows else [])

    def fixed(self, time: Fraction) -> int:
        """An instant in fixed point."""
        return (time.numerator << self.bits) // time.denominator

    def _march(self, pieces: "PiecesOfRecords", state: list[int], end: int, blows: Sequence[Any]) -> None:
        t, scale, left = 0, max(end >> 6, 1), list(blows)
        sizes = [abs(x) for x in state]
        while t < end or (left and left[0][0] == t):
            while left and left[0][0] <= t:
                jumps = left.pop(0)[1]
                state = [*state[:len(jumps)], *map(sum, zip(state[len(jumps):], jumps, strict=True))]
                sizes = [max(size, abs(x)) for size, x in zip(sizes, state, strict=True)]
            compute, limit, longest = pieces.series(t, self.bits)
            ends = [max(end, t + 1), *([] if limit is None else [limit]), *(at for at, _ in left[:1])]
            step, state, spare = self._stepped(compute, t, min(scale, longest or scale), state, sizes, min(ends), end)
            self.steps.append(step)
            sizes = [max(size, abs(x)) for size, x in zip(sizes, state, strict=True)]
            if step.end in ends[1:]:
                self.breaks.append(step.end)
            t, scale = step.end, int(step.scale * min(LONGER, 2.0 ** (spare / self.order)))
        self.sizes = [x / 2**self.bits for x in sizes]

    def _stepped(self, compute: "Callable[[int, int, Sequence[int], int], Coefficients]", t: int, scale: int,
                 state: list[int], sizes: list[int], stop: int, end: int) -> tuple[TaylorStep, list[int], int]:
        """(the TaylorStep, the state at its end, bits to spare)."""
        while True:
            found = self._computed(compute, t, scale, state)
            spare = self._spare(found, sizes)
            if spare >= 0:
                step = TaylorStep(t, min(t + scale, stop), scale, (found.q, found.v, found.a))
                after = [self.summed(row, step, step.end) for row in (*found.q, *found.v)]
                if self._arrives(compute, step, after):
                    return step, after, spare
                spare = -self.order
            scale = max(int(scale * max(SHORTER, 2.0 ** (spare / self.order))), 1)
            if scale < SHORTEST * end:
                raise PhysicsError(f"the reference does not get beyond t = {t / 2**self.bits:.6g} s: the motion is "
                                   "singular there")

    def _arrives(self, compute: "Callable[[int, int, Sequence[int], int], Coefficients]", step: TaylorStep,
                 after: list[int]) -> bool:
        """Are the accelerations at its end those that its series come to? What is too small for them to be seen, as
        what a hyperbolic tangent lacks of 1, may grow within a step."""
        _, v, a = step.rows
        try:
            found = compute(step.end, step.scale, after, 1).a
        except ArithmeticError:         # no force has a value there: the next step tells
            return True
        lacking = max((abs(there[0] - self.summed(row, step, step.end)) * step.scale >> self.bits
                       for there, row in zip(found, a, strict=True)), default=0)
        allowed = max((abs(x) for row in v for x in row), default=0) * self.order >> max(self.accuracy - ASTRAY, 0)
        return lacking <= max(allowed, 1 << ROUNDED)

    def _computed(self, compute: "Callable[[int, int, Sequence[int], int], Coefficients]", t: int, scale: int,
                  state: list[int]) -> "Coefficients":
        self._left -= self._price
        if self._left < 0:
            raise TakesMinutes(t / 2**self.bits)
        try:
            return compute(t, scale, state, self.order)
        except ArithmeticError:
            raise PhysicsError(f"the reference does not get beyond t = {t / 2**self.bits:.6g} s: the equations are "
                               "singular there") from None

    def _spare(self, found: "Coefficients", sizes: Sequence[int]) -> int:
        """Bits by which the last coefficients are smaller than they have to be."""
        rows = [*found.q, *found.v]
        largest = [max(size, *map(abs, row)) for size, row in zip(sizes, rows, strict=True)]
        least = max(largest) >> self.accuracy
        left = [max(size, least).bit_length() - max(map(abs, row[-LAST:])).bit_length()
                for size, row in zip(largest, rows, strict=True) if max(map(abs, row[-LAST:])) >> ROUNDED]
        return min(left, default=self.accuracy + self.order) - self.accuracy

    def summed(self, row: Sequence[int], step: TaylorStep, t: int) -> int:
        """Σ row[k] sᵏ at an instant of a step."""
        s, total = ((t - step.start) << self.bits) // step.scale, 0
        for coefficient in reversed(row):
            total = (total * s >> self.bits) + coefficient
        return total

    def forms(self, nodes: "Sequence[Node]", _: int) -> "Sequence[Node]":
        """Expressions as they are at an instant in fixed point."""
        return nodes

    def at(self, t: int) -> "list[list[mpmath.mpf]]":
        """[q], [q̇], [q̈] at an instant in fixed point."""
        import mpmath

        step = self.steps[self.place(t)]
        with mpmath.workprec(2 * self.bits):
            return [[mpmath.ldexp(self.summed(row, step, t), -self.bits) for row in rows] for rows in step.rows]

    def jerks(self, t: int) -> "list[mpmath.mpf]":
        """The rates of q̈ at an instant in fixed point."""
        import mpmath

        step = self.steps[self.place(t)]
        with mpmath.workprec(2 * self.bits):
            rates = ([k * x for k, x in enumerate(row)][1:] for row in step.rows[2])
            return [mpmath.mpf(self.summed(row, step, t)) / step.scale for row in rates]

    def place(self, t: int) -> int:
        """The number of the step that an instant lies in."""
        return max(bisect_right(self.steps, t, key=lambda step: step.start) - 1, 0)

    def time(self, t: int) -> "mpmath.mpf":
        """An instant in seconds."""
        import mpmath

        with mpmath.workprec(2 * self.bits):
            return mpmath.ldexp(t, -self.bits)


def bits_of(digits: int) -> int:
    """Of the fixed points of a motion to so many digits."""
    return ceil(digits * log2(10)) + SPARE


class TakesMinutes(PhysicsError):
    """The reference takes more work than is given to it; reached: how far it came [s]."""

    def __init__(self, reached: Any) -> None:
        self.reached = float(reached)
        super().__init__(f"the reference takes minutes: it came to t = {self.reached:.3g} s")
