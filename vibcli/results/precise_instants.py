"""Values, extremes and zeros of signals of small motions to any number of digits.

The floats tell where an extreme or a zero lies; from there Newton's method goes on in mpmath. Where loads bend or jump,
and at the ends of what is looked at, the instant itself is known, and both sides of it are looked at.
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from mpmath import mp

from vibcli.analyses.transient.descriptor_system import real
from vibcli.base.errors import PhysicsError
from vibcli.results.precise_signals import GUARD, agreed, precise_signal
from vibcli.results.precise_work import MOST, estimated_steps, require_quick

if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction

    import mpmath

    from vibcli.results.precise_envelope import PreciseEnvelope
    from vibcli.results.precise_signals import PreciseComposed, PreciseLinear
    from vibcli.results.signal import Signal

ROUNDING = 1e-14        # relative: values that floats do not tell apart
NEAR = 2.0**-48         # relative: instants that floats do not tell apart
SIMPLE = 1e-3           # y ÿ/ẏ² beside a single zero; 1/2 beside a double one
STEPS, LOST = 40, 8     # of Newton's method; digits that its last step may lack
EXTREMES: "WeakKeyDictionary[Signal, dict[tuple[float, ...], tuple[mpmath.mpf, mpmath.mpf]]]" = WeakKeyDictionary()


def value_to(signal: "Signal", t: "Fraction | int", digits: int) -> "mpmath.mpf":
    """The value of a signal at an instant, correct to `digits`."""
    return value_when(signal, lambda: real(t), digits)


def value_when(signal: "Signal", when: "Callable[[], mpmath.mpf]", digits: int, most: float = MOST,
               size: float = 0.0) -> "mpmath.mpf":
    """The same, or to as many digits of `size`; when: gives the instant at the working precision."""
    source, t = required(signal), float(when())
    require_quick(estimated_steps(signal, t, digits), digits, source[0].problem.work, most)
    return agreed(lambda: precise_signal(source).at(when()).read(0), digits, size, _died_out(source, t))[0]


def extreme_to(signal: "Signal", start: float, end: float, sense: int, digits: int, size: float = 0.0,
               most: float = MOST) -> "tuple[mpmath.mpf, mpmath.mpf]":
    """(instant, value) of the largest (sense 1) or smallest (−1) value between two instants, the earliest of equals, of
    whatever the floats do not tell apart, found once. most: steps of a million products that it may take."""
    known, asked = EXTREMES.setdefault(signal, {}), (start, end, sense, digits, size)
    if asked not in known:
        known[asked] = _extreme_to(signal, start, end, sense, digits, size, most)
    return known[asked]


def _extreme_to(signal: "Signal", start: float, end: float, sense: int, digits: int, size: float,
                most: float) -> "tuple[mpmath.mpf, mpmath.mpf]":
    source = required(signal)

    def one_near(t: float) -> "list[mpmath.mpf]":
        return agreed(lambda: _extreme(precise_signal(source), t, start, end, sense), digits, size,
                      _died_out(source, t))

    near, value = signal.extreme(start, end, sense)
    found = [one_near(t) for t in _rivals(signal, near, value, start, end, sense, digits, most)]
    best = max(sense * value for _, value in found)
    small = max(abs(best), size) * mp.mpf(10) ** -digits
    return min(((t, value) for t, value in found if abs(sense * value - best) <= small), key=lambda pair: pair[0])


def _rivals(signal: "Signal", near: float, value: float, start: float, end: float, sense: int, digits: int,
            most: float) -> list[float]:
    """The instants at which floats leave open whether the extreme is there."""
    require_quick(estimated_steps(signal, near, digits), digits, signal.source[0].problem.work, most)
    if _rests(signal, end, digits):
        return [near]
    margin = 2 * signal.error(end) + ROUNDING * abs(value)
    try:
        found = signal.rivals(start, end, sense, margin)
    except KeyError:
        found = [near]
    require_quick(len(found) * estimated_steps(signal, max(found), digits), digits, signal.source[0].problem.work, most)
    return found


def _rests(signal: "Signal", end: float, digits: int) -> bool:
    """Is it of a motion that starts at rest and that nothing drives, constant and no approximation to it?"""
    response = signal.source[0]
    with mp.workdps(digits + GUARD):
        motion = response.precise.alone
        return getattr(signal, "motion", None) is response.alone and not any(motion.start) and not any(
            piece.waves or piece.impulses for piece in motion.forcing.segments(end))


def _died_out(source: "Sequence[Any]", t: float) -> float:
    """By how many digits parts of a motion may have died out until an instant."""
    motion: Any = source[0].alone
    rates = [node.real for block in motion.blocks for node in block.nodes]
    rates += [wave.exponent.real for piece in motion.forcing.segments(t) for wave in piece.waves]
    return max(map(abs, rates), default=0.0) * t / math.log(10)


def zero_to(signal: "Signal", near: float, digits: int) -> "mpmath.mpf":
    """The instant of a zero, found near an instant in floats."""
    source = required(signal)
    require_quick(estimated_steps(signal, near, digits), digits, source[0].problem.work)
    instant, left = agreed(lambda: _zero(precise_signal(source), near), digits, died_out=_died_out(source, near))
    if left:
        raise PhysicsError(f"the signal turns {float(left):.3g} away from zero at t = {near:.12g} s: it has no zero "
                           "there", "ask for its min or max")
    return instant


def required(signal: "Signal") -> tuple[Any, ...]:
    """The source of a signal; PhysicsError where it has none."""
    if not signal.source:
        raise PhysicsError(f"more digits of {signal.KIND} are not found", "leave --digits out")
    return signal.source


def _breaks(signal: "PreciseComposed | PreciseEnvelope | PreciseLinear", near: float) -> list[Any]:
    """The exact instants near that in floats at which loads bend or jump, before which there is a motion."""
    return [at for at in signal.breaks(near) if at and abs(at - near) <= NEAR * near]


def _extreme(signal: "PreciseEnvelope | PreciseLinear", near: float, start: float, end: float,
             sense: int) -> "list[mpmath.mpf]":
    """[instant, value]."""
    for at in (*_breaks(signal, near), *(real(x) for x in (start, end) if x == near)):
        sides = [signal.at(at, before).read(1) for before in (True, False) if at != (start if before else end)]
        best = max(sense * side[0] for side in sides)
        rising, falling = at == start or sense * sides[0][1] >= 0, at == end or sense * sides[-1][1] <= 0
        jumps = len(sides) == 2 and abs(sides[0][0] - sides[1][0]) > mp.eps**0.5 * abs(best)
        if jumps or (rising and falling):
            return [at, sense * best]
    here = signal.at(real(near))
    by = _root(lambda by: here.read(2, by)[1:], near)
    value, _, bend = here.read(2, by)
    if sense * bend > 0 or not start <= near + by <= end:
        raise _lost(near)
    return [real(near) + by, value]


def _zero(signal: "PreciseComposed | PreciseLinear", near: float) -> "list[mpmath.mpf]":
    """[instant, what the signal is there where it only touches zero]."""
    nothing = mp.mpf(0)
    for at in _breaks(signal, near):
        left, right = (signal.at(at, before).read(0)[0] for before in (True, False))
        if left * right < 0:
            return [at, nothing]
    here = signal.at(real(near))
    if not here.read(0)[0]:
        return [real(near), nothing]
    value, slope, bend = here.read(2)
    if abs(value * bend) < SIMPLE * slope**2:
        return [real(near) + _root(lambda by: here.read(1, by), near), nothing]
    by = _root(lambda by: here.read(2, by)[1:], near)
    return [real(near) + by, here.read(0, by)[0]]


def _root(function: "Callable[[mpmath.mpf], list[mpmath.mpf]]", near: float) -> "mpmath.mpf":
    """How much later than `near` a function ([value, slope] of that) vanishes, by Newton's method."""
    by, small = mp.mpf(0), mp.mpf(10) ** (LOST - mp.dps)
    for _ in range(STEPS):
        value, slope = function(by)
        if not value:
            return by
        if not slope or abs(by) > NEAR**0.25 * max(near, 1):
            break
        step = -value / slope
        by += step
        if abs(step) <= small * abs(near + by):
            return by
    raise _lost(near)


def _lost(near: float) -> PhysicsError:
    return PhysicsError(f"more digits of what lies at t = {near:.12g} s are not found: the signal is too flat there",
                        "leave --digits out")
