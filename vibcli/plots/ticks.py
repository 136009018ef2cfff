"""Where ticks stand on an axis and what they say: multiples of 1, 2 or 5, decades, parts of a turn."""

import math
from collections.abc import Callable, Iterator

from vibcli.plots.prefixes import power

OF_A_TURN = (45, 90, 180, 360, 720, 1440, 2880, 5760)
_PLAIN = range(-3, 5)      # decades that are written out: 0.001 … 10000


def ticks(low: float, high: float, fits: Callable[[list[tuple[float, str]]], bool], log: bool = False,
          degrees: bool = False) -> list[tuple[float, str]]:
    """[(place, label)] on an axis from low to high (decades where it is log): the densest ones that `fits` takes,
    else two of them, else one."""
    ends = []
    for found in _candidates(low, high, log, degrees):
        if len(found) > 1:
            if fits(found):
                return found
            ends = [found[0], found[-1]]
    return ends if fits(ends) else ends[:1]


def _candidates(low: float, high: float, log: bool, degrees: bool) -> Iterator[list[tuple[float, str]]]:
    if log:
        if high - low < 1:
            for found in _linear(10.0 ** low, 10.0 ** high):
                yield [(math.log10(value), label) for value, label in found if value > 0]
        for within in (range(1, 10), (1, 2, 5), (1, 3)):
            yield _in_decades(low, high, within)
        for step in (1, 2, 3, 4, 5, 10, 20, 50, 100, 200, 400):
            yield _in_decades(low, high, (1,), step)
    elif degrees and high - low >= 90:
        for step in OF_A_TURN:
            yield _multiples(low, high, step, 0)
    else:
        yield from _linear(low, high)


def _linear(low: float, high: float) -> Iterator[list[tuple[float, str]]]:
    """Ticks at multiples of 1, 2, 5 · 10ᵉ, from a hundred of them on to one."""
    first = math.floor(math.log10(high - low)) - 2
    for exponent in range(first, first + 5):
        for step in (1, 2, 5):
            if (high - low) / (step * 10.0 ** exponent) <= 100:
                yield _multiples(low, high, step, exponent)


def _multiples(low: float, high: float, step: int, exponent: int) -> list[tuple[float, str]]:
    size, slack = step * 10.0 ** exponent, 1e-9
    first, last = math.ceil(low / size - slack), math.floor(high / size + slack)
    return [(k * size, decimal(k * step, exponent)) for k in range(first, last + 1)]


def decimal(n: int, exponent: int) -> str:
    """n·10ᵉ written out, or with a power of ten where that is long."""
    sign, digits = "−" if n < 0 else "", str(abs(n))
    if n == 0:
        return "0"
    if -7 < exponent < 0:
        digits = digits.rjust(1 - exponent, "0")
        return f"{sign}{digits[:exponent]}.{digits[exponent:]}"
    if exponent >= 0 and len(digits) + exponent < 7:
        return sign + digits + "0" * exponent
    stripped = digits.rstrip("0")
    rest = stripped[:1] + ("." + stripped[1:] if stripped[1:] else "")
    ten = power(exponent + len(digits) - 1)
    return sign + (ten if rest == "1" else f"{rest}·{ten}")


def _in_decades(low: float, high: float, within: range | tuple[int, ...], step: int = 1) -> list[tuple[float, str]]:
    slack = 1e-9
    decades = [k for k in range(math.floor(low), math.ceil(high) + 1) if k % step == 0]
    places = [(k, m, k + math.log10(m)) for k in decades for m in within]
    inside = [(k, m, place) for k, m, place in places if low - slack <= place <= high + slack]
    plain = all(k in _PLAIN for k, _, _ in inside)
    return [(place, decimal(m, k) if plain else _scientific(m, k)) for k, m, place in inside]


def decade(value: float, plain: bool) -> str:
    """A multiple of a decade as its tick says it: 2·10⁻², 10⁷, or 0.02 where plain."""
    k = math.floor(math.log10(value) + 1e-9)
    m = round(value / 10.0 ** k)
    return decimal(m, k) if plain else _scientific(m, k)


def _scientific(m: int, k: int) -> str:
    return power(k) if m == 1 else f"{m}·{power(k)}"
