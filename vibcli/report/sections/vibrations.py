"""Vibrations of small motions in words: the regime, decay, the share of each mode, beats with their envelope."""

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Section, paragraph, section
from vibcli.report.sections.formulas import sum_of

if TYPE_CHECKING:
    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.results.problem import Problem

NOTHING = 1e-12


def free_vibration(problem: "Problem", asked: "Sequence[RequestedSignal]") -> Iterator[Section]:
    """The regime of one degree of freedom; decrement and decay, beats, the share of each mode in the energy."""
    motion, rows = problem.response, []
    if motion.drive or not any(x for part in motion.deviations for x in part):
        return
    if len(problem.scene.q) == 1:
        rows += _regime(problem)
    else:
        rows += _participation(problem)
    rows += beats(asked, motion.until)
    yield from section("Free vibration", *(paragraph(row) for row in rows))


def _regime(problem: "Problem") -> list[str]:
    from vibcli.analyses.transient.free_vibration import decrement
    from vibcli.analyses.transient.textbook_form import regime

    mode = problem.modal.damped[0] if problem.modal.damped else None
    words = regime(*problem.response.matrices)
    if words == "under-damped" and mode is not None and mode.omega_d:
        decay, omega_d = float(mode.decay), float(mode.omega_d)
        delta = decrement(-decay, omega_d)
        bound = sum(mode.bounds)
        zeta, shown, per_cycle, time, cycles = (figure(value, bound) for value in (
            float(mode.zeta), decay, delta, math.log(10) / decay, math.log(10) / delta))
        return [f"under-damped, ζ = {zeta}",
                f"decay constant {shown} 1/s, logarithmic decrement {per_cycle}; the amplitude falls to 1/10 in {time} "
                f"s, or {cycles} cycles"]
    return [words]


def _participation(problem: "Problem") -> list[str]:
    from vibcli.analyses.transient.free_vibration import energy_shares

    if problem.modal.damped is not None or not problem.modal.modes.finite or any(
            mode.omega is None for mode in problem.modal.modes):
        return []
    shares = energy_shares(problem.response.matrices[0], problem.modal.modes, *problem.response.deviations)
    if not shares:      # what begins at rest anywhere along rigid motions stays there
        return []
    told = ", ".join(f"mode {mode.index}: {figure(100 * share, digits=4)} %"
                     for mode, share in zip(problem.modal.modes, shares, strict=True))
    return [f"share in the energy: {told}"]


def beats(asked: "Sequence[RequestedSignal]", until: float) -> Iterator[str]:
    """Of each signal that beats, in words."""
    from vibcli.results.signal_features import beat_period

    for one in asked:
        try:
            period = beat_period(one.signal) if hasattr(one.signal, "output") else None
        except PhysicsError:
            continue
        if period is not None:
            yield f"{one.label} beats with the period 2π/|ω₁ − ω₂| = {figure(period)} s{_envelope(one.signal, until)}"


def _envelope(signal: Any, until: float) -> str:
    """√(A₁² + A₂² + 2A₁A₂ cos(Δω t − Δφ)), and what it lies between; nothing where there are more vibrations."""
    from vibcli.analyses.transient.textbook_form import Part

    envelope = signal.envelope
    try:
        waves = envelope.found.waves
    except PhysicsError:
        return ""
    (a, first), (b, second), (c, both) = waves
    steady = [Part(abs(a + b), 0, first.real, 0.0, 0.0, False)] if first == second else [
        Part(abs(size), 0, node.real, 0.0, 0.0, False) for size, node in ((a, first), (b, second))]
    c = c if both.imag > 0 else c.conjugate()
    turning = Part(abs(c), 0, both.real, abs(both.imag), -cmath.phase(c), False)
    low, high = (envelope.extreme(0.0, until, sense)[1] for sense in (-1, 1))
    low = low if low > NOTHING * high else 0.0
    return (f"; envelope, in SI units, √({sum_of([*steady, turning], 't')}), between {figure(low)} and {figure(high)} "
            f"up to t = {figure(until)} s")
