"""Motions of small oscillations as textbooks write them: the formula piece by piece."""

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import SHOWN, figure
from vibcli.report import blocks
from vibcli.report.blocks import Heading, Name, Section, line, section
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.report.blocks import Equations
    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.results.signals import LinearSignal

MOST_PARTS, MOST_PIECES, MOST_DIGITS = 8, 4, 15
NO_ANGLE = 1e-12


def formulas(asked: "Sequence[RequestedSignal]", until: float) -> Iterator[Section]:
    """x = A e^{−δt} cos(ω_d t − φ) + … of each signal, on each piece of the forcing, looked at `until` an instant."""
    found = []
    for one in asked:
        signal = one.signal
        if not hasattr(signal, "output") or not signal.motion.forcing.listed or signal.motion.forcing.recorded:
            continue
        starts = [piece.start for piece in signal.motion.forcing.segments(math.inf)]
        if len(starts) <= MOST_PIECES:
            found += _pieces(one, signal, starts, until)
    yield from section("As a formula, in SI units", *found)


def _pieces(one: "RequestedSignal", signal: "LinearSignal", starts: Sequence[float], until: float) -> "list[Equations]":
    from vibcli.analyses.transient.textbook_form import formula

    found: list[Any] = []
    name = Name(one.text) if isinstance(one.tree, NameRef) and "." not in one.text else one.text
    for number, start in enumerate(starts):
        parts = formula(signal.motion, signal.output, number, until=until)
        if len(parts) > MOST_PARTS:
            return []
        if len(starts) > 1:
            end = f" ≤ t < {figure(starts[number + 1])} s" if number + 1 < len(starts) else " s ≤ t"
            clock = f", τ = t − {figure(start)} s" if start else ""
            found.append(Heading(f"{figure(start)}{end}{clock}:"))
        found.append(blocks.equations([line(name, f" = {sum_of(parts, 'τ' if start else 't')}")]))
    return found


def sum_of(parts: "Sequence[Part]", t: str) -> str:
    """Σ of the Parts as text, `t` being the letter of the time; (a + b t) e^{λt} of those that fall or grow alike."""
    text, digits = "", _digits(parts)
    for group in _alike(parts):
        negative, product = _polynomial(group, t, digits) if len(group) > 1 else _product(group[0], t, digits)
        text += (" − " if text else "−") if negative else (" + " if text else "")
        text += product
    return text or "0"


def _alike(parts: Sequence[Any]) -> list[Any]:
    """[parts that are one power of the time, or several times the same e^{λt}]"""
    groups: list[Any] = []
    for part in parts:
        last = groups[-1][-1] if groups else None
        if last and part.rate and not part.omega and (last.rate, last.omega) == (part.rate, 0.0):
            groups[-1].append(part)
        else:
            groups.append([part])
    return groups


def _polynomial(group: Sequence[Any], t: str, digits: int) -> tuple[bool, str]:
    """(False, (a + b t + …) e^{λt})"""
    inside = sum_of([part._replace(rate=0.0) for part in group], t)
    return False, f"({inside})·{_falling(group[0], t, digits)}"


def _digits(parts: Sequence[Any]) -> int:
    """How many digits of frequencies and rates tell those apart that differ."""
    def apart(digits: int) -> bool:
        return all(len({figure(value, digits=digits) for value in values}) == len(values) for values in both)

    both = {part.omega for part in parts}, {part.rate for part in parts}
    return next((digits for digits in range(SHOWN, MOST_DIGITS) if apart(digits)), MOST_DIGITS)


def _product(part: "Part", t: str, digits: int) -> tuple[bool, str]:
    """(negative, text of the magnitude) of a part."""
    from vibcli.notation.plain import plain

    size, wave = figure(abs(part.amplitude)), ""
    negative = part.amplitude < 0
    if part.omega:
        turned, wave = _wave(part, t, digits)
        negative = negative != turned
    factors = [size] if size != "1" or not (part.power or part.rate or part.omega) else []
    if part.power:
        factors.append(t if part.power == 1 else plain.power(t, str(part.power)))
    if part.rate:
        factors.append(_falling(part, t, digits))
    return negative, "·".join(factors + [wave] * bool(wave))


def _falling(part: "Part", t: str, digits: int) -> str:
    return f"e^({'−' if part.rate < 0 else ''}{_times(abs(part.rate), t, digits)})"


def _times(rate: float, t: str, digits: int) -> str:
    """rate·t, t alone where the rate is one."""
    size = figure(rate, digits=digits)
    return t if size == "1" else f"{size}·{t}"


def _wave(part: "Part", t: str, digits: int) -> tuple[bool, str]:
    """(whether −, sin or cos) of cos(ωt − φ), which is a sine where φ is a right angle and a minus where it is two."""
    angle = _times(part.omega, t, digits)
    for lag, turned, function in ((0.0, False, "cos"), (math.pi, True, "cos"), (math.pi / 2, False, "sin"),
                                  (-math.pi / 2, True, "sin"), (-math.pi, True, "cos")):
        if abs(part.phase - lag) <= NO_ANGLE:
            return turned, f"{function}({angle})"
    return False, f"cos({angle} {'−' if part.phase > 0 else '+'} {figure(abs(part.phase))})"
