"""The steady state: harmonics, amplitude and phase."""

import cmath
import math
from collections.abc import Iterator, Sequence
from math import degrees
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure, supported
from vibcli.report.blocks import Section, TableBlock, paragraph, section
from vibcli.report.sections.formulas import sum_of

if TYPE_CHECKING:
    from vibcli.report.blocks import Paragraph
    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.results.signals import LinearSignal

FIRST, SMALL = 9, 1e-9     # harmonics of a periodic steady state that are listed
PHASES = {"sine": ("X·sin(Ω·t − θ)", 1, -0.25), "cosine": ("X·cos(Ω·t − θ)", 1, 0.0),
          "lead": ("X·sin(Ω·t + α)", -1, -0.25)}
NOTHING = 1e-12


def steady_state(asked: "Sequence[RequestedSignal]", convention: Any) -> Iterator[Section]:
    """Amplitude and phase of each harmonic of the steady state and what follows growing loads, or why there is none."""
    try:
        lost = [f"{one.label}: {text}" for one in asked for text in _driven_off(one.signal)]
        asked = [one for one in asked if not any(_driven_off(one.signal))]
        growing = [f"{one.label} = {text}" for one in asked for text in _following(one.signal)]
        asked = [one for one in asked if not any(_following(one.signal))]
        rows = tuple(steady_rows(asked, convention))
    except PhysicsError as error:
        yield from section("Steady state", paragraph(f"{error.message}: {error.hint}" if error.hint else error.message))
        return
    if lost:
        yield from section("Without a steady state", *map(paragraph, lost))
    if growing:
        yield from section("Steady state behind loads that grow, in SI units", *map(paragraph, growing))
    angle = "α" if convention == "lead" else "θ"
    yield from section(f"Steady state {PHASES[convention][0]}", TableBlock(
        ("signal", "Ω [rad/s]", "f [Hz]", "T [s]", "X", f"{angle} [rad]", f"{angle} [°]"), rows) if rows else None,
        *(paragraph(f"{one.label}: {words}") for one in asked for words in _left_out(one.signal)), _still(asked, rows))


def _driven_off(signal: "LinearSignal") -> Iterator[str]:
    """Why a signal has no steady state though others have."""
    if hasattr(signal, "output"):
        steady = signal.motion.steady
        try:
            steady.require_held(signal.output)
        except PhysicsError as error:
            yield error.message


def _following(signal: "LinearSignal") -> Iterator[str]:
    """Σ cₖ tᵏ of a signal that grows with its loads, and the waves beside it, as text."""
    from vibcli.analyses.transient.textbook_form import Part

    if not hasattr(signal, "output") or signal.motion.steady.period is not None:
        return
    powers = signal.motion.steady.polynomial(signal.output)
    if any(powers[1:]):
        parts = [Part(c, k, 0.0, 0.0, 0.0, True) for k, c in enumerate(powers) if c][::-1]
        waves = [(Omega, X) for Omega, X in signal.motion.steady.oscillating(signal.output) if X]
        yield sum_of(parts + [Part(abs(X), 0, 0.0, Omega, -cmath.phase(X), True) for Omega, X in waves], "t")


def _still(asked: "Sequence[RequestedSignal]", rows: tuple[tuple[str, ...], ...]) -> "Paragraph | None":
    """Which signals do not vibrate where others do."""
    still = [one.label for one in asked if hasattr(one.signal, "output") and not harmonics_of(one.signal)]
    return paragraph(f"without vibration: {', '.join(still)}") if rows and still else None


def _left_out(signal: "LinearSignal") -> Iterator[str]:
    """What the harmonics beyond those listed add to a periodic steady state."""
    if not hasattr(signal, "output") or signal.motion.steady.period is None:
        return
    steady = signal.motion.steady
    told = sum(abs(X) ** 2 / 2 for _, X, _ in harmonics_of(signal)) + steady.mean(signal.output) ** 2
    mean, rms = steady.mean(signal.output), steady.rms(signal.output)
    rest = math.sqrt(max(0.0, rms**2 - told))
    yield (f"mean {figure(mean if abs(mean) > NOTHING * rms else 0.0)}, root mean square {figure(rms)}; the "
           f"harmonics after the {FIRST}th have a root mean square of {figure(rest, digits=2)}")


def phase_in(convention: str, X: complex) -> float:
    """The phase of Re X e^{iΩt} as the convention counts it, in (−π, π]."""
    from vibcli.results.signal_features import wrapped

    _, sign, turn = PHASES[convention]
    return wrapped(sign * (-cmath.phase(X) + turn * math.tau))


def harmonics_of(signal: Any) -> list[tuple[float, complex, float]]:
    """[(Ω, X, |δX|)] of the steady state: all of finitely many, the first of a periodic one; none of products of
    signals."""
    from vibcli.results import feature_errors
    from vibcli.results.escalation import phasors_of_signal
    from vibcli.results.steady_features import fundamental, harmonic

    if not hasattr(signal, "output"):
        return []
    if signal.motion.steady.period is None:
        return phasors_of_signal(signal)
    Omega = fundamental(signal)
    found = [(n * Omega, harmonic(signal, n), feature_errors.harmonic(signal, n)) for n in range(1, FIRST + 1)]
    largest = max(abs(X) for _, X, _ in found)
    return [one for one in found if abs(one[1]) > SMALL * largest]


def steady_rows(asked: "Sequence[RequestedSignal]", convention: str) -> Iterator[tuple[str, ...]]:
    """Rows of signal, Ω, f, T, amplitude and phase of each harmonic of the steady state."""
    for one in asked:
        harmonics = harmonics_of(one.signal)
        largest = max((abs(X) for _, X, _ in harmonics), default=0.0)
        for Omega, X, error in harmonics:
            if Omega:
                theta, turned = phase_in(convention, X), error / abs(X) if X else 0.0
                yield (f"{one.label} [{one.unit}]", figure(Omega), figure(Omega / math.tau), figure(math.tau / Omega),
                       supported(abs(X), error, beside=largest), supported(theta, turned, beside=math.tau),
                       supported(degrees(theta), degrees(turned), 4, beside=360.0))
