"""Motions of small oscillations as textbooks write them: the formula piece by piece, the regime, the steady state."""

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.notation.numbers import figure
from vibcli.report import blocks
from vibcli.report.blocks import Heading, Name, Section, line, paragraph, section
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.results.problem import Problem

MOST_PARTS, MOST_PIECES = 8, 4
NO_ANGLE = 1e-12


def formulas(asked: "Sequence[RequestedSignal]") -> Iterator[Section]:
    """x = A e^{−δt} cos(ω_d t − φ) + … of each signal, on each piece of the forcing."""
    found = []
    for one in asked:
        signal = one.signal
        if not hasattr(signal, "output") or not signal.motion.forcing.listed:
            continue
        starts = [piece.start for piece in signal.motion.forcing.segments(math.inf)]
        if len(starts) <= MOST_PIECES:
            found += _pieces(one, signal, starts)
    yield from section("As a formula, in SI units", *found)


def _pieces(one, signal, starts):
    from vibcli.analyses.transient.textbook_form import formula

    found: list = []
    name = Name(one.text) if isinstance(one.tree, NameRef) and "." not in one.text else one.text
    for number, start in enumerate(starts):
        parts = formula(signal.motion, signal.output, number)
        if len(parts) > MOST_PARTS:
            return []
        if len(starts) > 1:
            end = f" ≤ t < {figure(starts[number + 1])} s" if number + 1 < len(starts) else " s ≤ t"
            clock = f", τ = t − {figure(start)} s" if start else ""
            found.append(Heading(f"{figure(start)}{end}{clock}:"))
        found.append(blocks.equations([line(name, f" = {_sum(parts, 'τ' if start else 't')}")]))
    return found


def _sum(parts, t):
    """Σ of the Parts as text."""
    text = ""
    for part in parts:
        negative = part.amplitude < 0
        text += (" − " if text else "−") if negative else (" + " if text else "")
        text += _product(part, t)
    return text or "0"


def _product(part, t):
    size = figure(abs(part.amplitude))
    factors = [size] if size != "1" or not (part.power or part.rate or part.omega) else []
    if part.power:
        factors.append(t if part.power == 1 else f"{t}^{part.power}")
    if part.rate:
        factors.append(f"e^({_signed(part.rate)}·{t})")
    if part.omega:
        phase = f" {'−' if part.phase > 0 else '+'} {figure(abs(part.phase))}" if abs(part.phase) > NO_ANGLE else ""
        factors.append(f"cos({figure(part.omega)}·{t}{phase})")
    return "·".join(factors)


def _signed(value):
    return figure(value).replace("-", "−")


def free_vibration(problem: "Problem", asked: "Sequence[RequestedSignal]") -> Iterator[Section]:
    """The regime of one degree of freedom; decrement and decay, beats, the share of each mode in the energy."""
    motion, rows = problem.response, []
    if motion.drive or not any(x for part in motion.deviations for x in part):
        return
    if len(problem.scene.q) == 1:
        rows += _regime(problem)
    else:
        rows += _participation(problem)
    for one in asked:
        rows += _beats(one)
    yield from section("Free vibration", *(paragraph(row) for row in rows))


def _regime(problem):
    from vibcli.analyses.transient.free_vibration import decrement
    from vibcli.analyses.transient.textbook_form import regime
    from vibcli.report.sections.mode_tables import bounds

    mode = problem.modal.damped[0] if problem.modal.damped else None
    words = regime(*problem.response.matrices)
    if words == "under-damped" and mode is not None and mode.omega_d:
        decay, omega_d = float(mode.decay), float(mode.omega_d)
        delta = decrement(-decay, omega_d)
        bound = sum(bounds(mode))
        zeta, shown, per_cycle, time, cycles = (figure(value, bound) for value in (
            float(mode.zeta), decay, delta, math.log(10) / decay, math.log(10) / delta))
        return [f"under-damped, ζ = {zeta}",
                f"decay constant {shown} 1/s, logarithmic decrement {per_cycle}; the amplitude falls to 1/10 in {time} "
                f"s, or {cycles} cycles"]
    return [words]


def _participation(problem):
    from vibcli.analyses.transient.free_vibration import energy_shares

    if problem.modal.damped is not None or any(mode.omega is None for mode in problem.modal.modes):
        return []
    shares = energy_shares(problem.response.matrices[0], problem.modal.modes, *problem.response.deviations)
    told = ", ".join(f"mode {mode.index}: {figure(100 * share, digits=4)} %"
                     for mode, share in zip(problem.modal.modes, shares, strict=True))
    return [f"share in the energy: {told}"] if told else []


def _beats(one):
    from vibcli.analyses.transient.free_vibration import beat_period

    if not hasattr(one.signal, "output"):
        return []
    period = beat_period(one.signal.motion, one.signal.output)
    return [f"{one.label} beats with the period 2π/|ω₁ − ω₂| = {figure(period)} s"] if period else []
