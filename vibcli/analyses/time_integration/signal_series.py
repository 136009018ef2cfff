"""A function of a motion that is followed by series: its own series in each step, its turns and its passages."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from operator import mul
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.analyses.time_integration.taylor_march import summed
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import shifted, to_float
from vibcli.numerics.fixed_point_functions import functions
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.power_series import SeriesSource

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.analyses.time_integration.taylor_march import Step, TaylorMarch
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LOOKS = 24              # places in a step at which a sign is looked at
HALVINGS, POLISHED = 60, 40
TOUCH = 10**13          # how many of it are less than the largest value in a step: what touches zero
APART, FAR = 20, 5      # binary orders of a step: how far places lie apart at least, and what is not near
SETTLED, ROUNDINGS = 1 << 10, 1 << 16
FEW = 9


class SignalSeries:
    """An expression of coordinates, their rates and the time as series; KeyError where it has none."""

    def __init__(self, scene: "Scene", node: "Node") -> None:
        kinds = "qva"
        rows = [f"{kind}{i}" for kind in kinds for i in range(len(scene.q))]
        source = SeriesSource(dict(zip((*scene.q, *scene.v, *scene.a, scene.time), (*rows, "t"), strict=True)))
        found, = source.add([node])
        self._constants = list(source.constants)
        head = f"({''.join(name.upper() + ',' for name in rows)})=rows"
        slots = "".join(name + "," for name in source.constants.values())
        names = f"({slots})=constants" if slots else "pass"
        lines = [head, names, "t=[t0]", *(f"{name}=[{name.upper()}[0]]" for name in rows), *source.first]
        round_ = ["h=(k+1)>>1", "t.append(T if k==1 else 0)", *(f"{name}.append({name.upper()}[k])" for name in rows)]
        lines += ["for k in range(1,K+1):", *(" " + line for line in (*round_, *source.lines)), f"return {found}"]
        self._text = "def f(t0,T,rows,K,constants,B):\n" + "".join(f" {line}\n" for line in lines)

    def along(self, march: "TaylorMarch", values: "Mapping[str, mpmath.mpf]") -> "SignalAlong":
        """The signal along a march, given the values of the parameters."""
        import mpmath

        with mpmath.workprec(2 * march.bits):
            known = [fixed_point(x, march.bits) for x in evaluate(self._constants, multiprecision(), values)]
        space: dict[str, Any] = {"mul": mul, **functions(march.bits)}
        exec(compile(self._text, "<signal>", "exec"), space)        # of slots alone
        made = space["f"]

        def row(step: "Step") -> "list[int]":
            rows = [row for kind in step.series for row in kind]
            found: list[int] = made(step.start, step.scale, rows, len(rows[0]) - 1, known, march.bits)
            return found

        return SignalAlong(march, row)


class SeriesPlace(NamedTuple):
    """s in a step, in fixed point, and the series of the signal there."""

    step: "Step"
    s: int
    row: list[int]


class SignalAlong:
    """A signal along a march; row(step): its coefficients in a step."""

    def __init__(self, march: "TaylorMarch", row: "Callable[[Step], list[int]]") -> None:
        self.march, self._row = march, row
        self._known: dict[tuple[int, int], list[SeriesPlace]] = {}

    def time(self, place: SeriesPlace) -> int:
        return place.step.start + (place.s * place.step.scale >> self.march.bits)

    def value(self, place: SeriesPlace) -> int:
        return summed(place.row, place.s, self.march.bits)

    def at(self, step: "Step", instant: int) -> SeriesPlace:
        """The place of an instant in a step."""
        return SeriesPlace(step, ((instant - step.start) << self.march.bits) // step.scale, self._row(step))

    def pieces(self, start: int, end: int) -> "Iterator[tuple[SeriesPlace, SeriesPlace]]":
        """(first, last) of each step that [start, end] meets."""
        self.march.reach(end)
        for step in self.march.steps:
            if step.end > start and step.start < end:
                first = self.at(step, max(start, step.start))
                yield first, self.at(step, min(end, step.end))._replace(row=first.row)

    def extreme(self, start: int, end: int, sense: int, digits: int) -> SeriesPlace:
        """The first place at which the signal is largest (sense 1) or smallest (−1), to so many digits."""
        places = self._turns(start, end)
        values = [sense * self.value(place) for place in places]
        best = max(values)
        alike = max(abs(best) // 10**digits, ROUNDINGS)
        return places[next(k for k, value in enumerate(values) if value >= best - alike)]

    def largest(self, start: int, end: int) -> int:
        """The largest size of the signal."""
        return max(abs(self.value(place)) for place in self._turns(start, end))

    def _turns(self, start: int, end: int) -> list[SeriesPlace]:
        """The ends, and where the signal turns: within steps, or where one goes over into the next."""
        if (start, end) not in self._known:
            self._known[start, end] = self._searched_turns(start, end)
        return self._known[start, end]

    def _searched_turns(self, start: int, end: int) -> list[SeriesPlace]:
        found, before, place = [], 0, None
        for first, last in self.pieces(start, end):
            slope = derivative(first.row)
            if before * summed(slope, first.s, self.march.bits) <= 0:
                found.append(first)
            found += self._roots(first, last, slope)
            before, place = summed(slope, last.s, self.march.bits), last
        return [*found, place]

    def passages(self, start: int, end: int, level: int = 0) -> list[SeriesPlace]:
        """The places at which the signal passes or touches a level, ascending; one from which it starts counts."""
        found: list[SeriesPlace] = []
        for first, last in self.pieces(start, end):
            row = [first.row[0] - level, *first.row[1:]]
            places = [first, *self._roots(first, last, derivative(row)), last]
            sizes = [abs(self.value(place) - level) for place in places]
            still = [place for place, size in zip(places[:-1], sizes, strict=False)
                     if size * TOUCH <= max(sizes) and max(sizes)]
            for place in sorted([*still, *self._roots(first, last, row)], key=lambda place: place.s):
                if not found or self.time(place) - self.time(found[-1]) > place.step.scale >> APART:
                    found.append(place)
        return found

    def zero_near(self, time: "Fraction") -> SeriesPlace:
        """The zero or touch of zero near an instant."""
        step, s = self.march.step_at(time)
        place, near = SeriesPlace(step, s, self._row(step)), to_float(s, self.march.bits)
        size = max(abs(self.value(self.at(step, instant))) for instant in (step.start, step.end))
        for row in (place.row, derivative(place.row)):
            found = self._polished(place, near, row)
            if found is not None and abs(self.value(found)) * TOUCH <= size:
                return found
        raise PhysicsError(f"no zero of the signal is found near t = {float(time):.12g} s", "ask for its min or max")

    def _roots(self, first: SeriesPlace, last: SeriesPlace, row: list[int]) -> list[SeriesPlace]:
        """The places at which a polynomial changes its sign, from the first one on, where it may vanish; none of what
        is zero throughout."""
        bits, largest = self.march.bits, max(map(abs, row), default=0)
        if not largest:
            return []
        numbers = np.array([to_float(x, largest.bit_length()) for x in row])    # of any size
        places = _looked_at(numbers, to_float(first.s, bits), to_float(last.s, bits))
        signs = np.sign(_values(numbers, places))
        signs[0] = np.sign(summed(row, first.s, bits))
        found = []
        for k in range(len(places) - 1):
            if not signs[k]:
                found.append(places[k])
            elif signs[k] * signs[k + 1] < 0:
                found.append(_halved(numbers, places[k], places[k + 1], signs[k]))
        return [place for s in found if (place := self._polished(first, s, row)) is not None
                and first.s <= place.s <= last.s]

    def _polished(self, place: SeriesPlace, s: float, row: Sequence[int]) -> SeriesPlace | None:
        """The zero near s of a polynomial, by Newton's method; None where there is none."""
        bits, slope = self.march.bits, derivative(row)
        here = begin = shifted(int(s * 2**53), bits - 53)
        for _ in range(POLISHED):
            value, rise = summed(row, here, bits), summed(slope, here, bits)
            if not value or not rise:
                break
            step = (value << bits) // rise
            here -= step
            if abs(step) < SETTLED or abs(here - begin) >> bits - FAR:
                break
        return None if abs(here - begin) >> bits - FAR else place._replace(s=here)


def derivative(row: Sequence[int]) -> list[int]:
    """The coefficients of the derivative of a polynomial by s."""
    return [k * x for k, x in enumerate(row)][1:]


def _looked_at(numbers: np.ndarray, low: float, high: float) -> np.ndarray:
    """Places between which a polynomial changes its sign once: those of one of few terms, which may reach far, lie
    between its roots."""
    few = np.trim_zeros(numbers, "b")
    if not 1 < len(few) <= FEW:
        return np.linspace(low, high, LOOKS + 1)
    roots = np.sort(np.roots(few[::-1]).real)
    between = 0.5 * (roots[1:] + roots[:-1])
    return np.array([low, *between[(between > low) & (between < high)], high])


def _values(numbers: np.ndarray, places: float | np.ndarray) -> float | np.ndarray:
    total = np.zeros(np.shape(places))
    for number in numbers[::-1]:
        total = total * places + number
    return total


def _halved(numbers: np.ndarray, low: float, high: float, sign: float) -> float:
    """Where a polynomial changes its sign."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if np.sign(_values(numbers, middle)) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
