"""Functions of exact sums: sin of a·t + b is a wave, step(a·t + b) counts from an instant, |sin u| is periodic.

An argument that is another line from some instant on (a ramp that is held) is treated line by line.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation import piecewise_linear
from vibcli.analyses.excitation.exponential_polynomials import (
    HALF,
    STILL,
    Exact,
    Sum,
    Waves,
    added,
    constant,
    gate,
    multiplied,
    since,
    smooth_pieces,
    wave,
)

if TYPE_CHECKING:
    from vibcli.symbolic.sampled_functions import Samples

ONE = Fraction(1)


class NotSaid(Exception):
    """A function that is no sum of polynomials, exponentials, sines, steps and impulses; with the reason."""


def called(name: str, args: Sequence[Sum], order: int, numbers: type[Any], record: "Samples | None" = None) -> Sum:
    """A function of Sums as a Sum; `order`: of the rate; `record`: the samples where it is one of them."""
    if name in ("min", "max"):
        a, b = args
        larger = ONE if name == "max" else -ONE
        between = added((a, ONE), (b, -ONE))
        return added((a, HALF), (b, HALF), (_magnitude(between, numbers), larger * HALF))
    if name == "abs":
        return _magnitude(args[0], numbers)
    if name == "ramp":
        return multiplied(args[0], by_line(args[0], partial(_step, numbers=numbers)))
    if record is not None:
        return by_line(args[0], partial(_record, samples=record, order=order, numbers=numbers))
    if name in ORDERED:
        return by_line(args[0], partial(ORDERED[name], order=order, numbers=numbers))
    if name in _PLAIN:
        return by_line(args[0], partial(_PLAIN[name], numbers=numbers))
    raise NotSaid(f"{name} of what changes in time has no closed form here")


def by_line(total: Sum, function: Callable[[Waves], Sum]) -> Sum:
    """Σ of function(piece) from each instant to the next; `function` takes {wave: polynomial}."""
    if any(key[1] for key in total):
        raise NotSaid("its argument jumps or turns again and again")
    pieces = smooth_pieces(total)
    found = []
    for (T, here), following in zip(pieces, [*pieces[1:], None], strict=True):
        if following is not None and following[0] <= 0:
            continue
        value = function(here)
        start = value if T is None else multiplied(value, since(T))
        found.append((start, ONE))
        if following is not None:
            found.append((multiplied(value, since(following[0])), -ONE))
    return added(*found)


def _line(here: Waves) -> tuple[Fraction, Fraction] | None:
    """(a, b) of a·t + b, None of anything else."""
    if any(key != STILL for key in here):
        return None
    p = here.get(STILL, ())
    return None if len(p) > 2 else (Fraction(p[1] if len(p) > 1 else 0), Fraction(p[0] if p else 0))


def _needed(here: Waves, what: str) -> tuple[Fraction, Fraction]:
    line = _line(here)
    if line is None:
        raise NotSaid(f"the argument of {what} must be linear in the time")
    return line


def _sine(here: Waves, numbers: type[Any], quarter: int) -> Sum:
    a, b = _needed(here, "sin or cos")
    return wave(0, a, 0, b, quarter, ONE)


def _exponential(here: Waves, numbers: type[Any], parts: tuple[tuple[int, Fraction], ...]) -> Sum:
    a, b = _needed(here, "exp, sinh or cosh")
    return added(*((wave(sign * a, 0, sign * b, 0, 0, ONE), weight) for sign, weight in parts))


def _magnitude(total: Sum, numbers: type[Any]) -> Sum:
    return multiplied(total, by_line(total, partial(_sign, numbers=numbers)))


def _sign(here: Waves, numbers: type[Any], at_zero: int = 0) -> Sum:
    line = _line(here)
    if line is None:
        a, b, height, _ = _swing(here, numbers)
        if not -1 < height < 1:
            return constant(ONE if height > 0 else -ONE)
        angle = numbers.arc_sine(numbers.number(height))
        return gate(piecewise_linear.sign_of_sine(a, b, angle, numbers.pi, None))
    a, b = line
    if not a:
        return constant(Fraction((b > 0) - (b < 0) if b else at_zero))
    side = ONE if a > 0 else -ONE
    return added((since(-b / a), 2 * side), (constant(ONE), -side))


def _step(here: Waves, numbers: type[Any]) -> Sum:
    return added((_sign(here, numbers, 1), HALF), (constant(ONE), HALF))


def _swing(here: Waves, numbers: type[Any]) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    """(a, b, height, R) of R·(sin(a·t + b) + height): one sine beside a constant."""
    level, swings = Fraction(0), []
    for (r, w, r0, w0, q), p in here.items():
        if len(p) > 1 or r or r0:
            raise NotSaid("where its argument changes sign is not known in closed form")
        if w:
            swings.append((w, w0, q, p[0]))
        else:
            level += p[0] * _real(numbers, w0, q)
    if len({w for w, _, _, _ in swings}) != 1:
        raise NotSaid("where its argument changes sign is not known in closed form")
    a = Fraction(swings[0][0])
    if len(swings) == 1:
        _, w0, q, size = swings[0]
        sign = -1 if size < 0 else 1
        return a, w0 + (q + 2 - sign) * numbers.pi / 2, level / size * sign, Fraction(size * sign)
    total = sum(numbers.number(size) * numbers.turned(0, w0, q) for _, w0, q, size in swings)
    size, phase = numbers.polar(total)
    size = numbers.exact(size)
    return a, phase + numbers.pi / 2, level / size, size


def _real(numbers: type[Any], phase: Exact, quarters: int) -> Fraction:
    return numbers.exact(numbers.turned(0, phase, quarters).real) if phase else ONE


def _impulse(here: Waves, order: int, numbers: type[Any]) -> Sum:
    if order:
        raise NotSaid("this is the rate of an impulse: what moves jumps, and has no acceleration there")
    line = _line(here)
    if line is None:
        a, b, height, size = _swing(here, numbers)
        if not -1 < height < 1:
            return {}
        steep = numbers.arithmetic.power(numbers.number(1 - height * height), HALF)
        arc = numbers.arc_sine(numbers.number(height))
        return gate(piecewise_linear.sign_of_sine(a, b, arc, numbers.pi, 1 / (size * a * numbers.exact(steep))))
    a, b = line
    if not (a or b):
        raise NotSaid("an impulse acts at an instant, here at all times")
    return gate(piecewise_linear.Blow(-b / a, 1 / abs(a))) if a and -b / a >= 0 else {}


def _wave_form(here: Waves, order: int, numbers: type[Any], name: str) -> Sum:
    a, b = _needed(here, name)
    if order > 1:
        raise NotSaid("this is the rate of an impulse: what moves jumps, and has no acceleration there")
    if not a:
        return constant(numbers.exact(numbers.arithmetic.functions[name](numbers.number(b), *[order] * bool(order))))
    return gate(getattr(piecewise_linear, name)(a, b, numbers.pi, order))


def _record(here: Waves, samples: "Samples", order: int, numbers: type[Any]) -> Sum:
    a, b = _needed(here, "a record")
    if order > 2 or (order == 2 and samples.jumps):
        raise NotSaid("this is the rate of an impulse: what moves jumps, and has no acceleration there")
    if a:
        from vibcli.analyses.excitation.tabulated import TabulatedFunction

        return gate(TabulatedFunction(samples, a, b, order, numbers))
    return constant(numbers.exact(samples.at(numbers.number(b), order)))


_PLAIN: dict[str, Callable[..., Sum]] = {
    "sin": partial(_sine, quarter=-1), "cos": partial(_sine, quarter=0),
    "exp": partial(_exponential, parts=((1, ONE),)),
    "sinh": partial(_exponential, parts=((1, HALF), (-1, -HALF))),
    "cosh": partial(_exponential, parts=((1, HALF), (-1, HALF))),
    "step": _step, "sign": _sign,
}
ORDERED: dict[str, Callable[..., Sum]] = {"impulse": _impulse, "square": partial(_wave_form, name="square"),
            "sawtooth": partial(_wave_form, name="sawtooth")}
