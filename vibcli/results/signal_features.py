"""Numbers that are read off one signal of a small motion in free vibration: after the last change of the loads
x = A e^{−δt} cos(ω_d t − φ), beside what the loads that do not oscillate add."""

from cmath import rect
from math import pi, tau
from typing import TYPE_CHECKING

from vibcli.analyses.excitation.forcing import oscillates
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.transient.envelope import Beats, Decay
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.results.signals import LinearSignal

ALONE = 1e-10       # amplitude of another vibration, relative to the largest, that counts as none
UNDYING = 1e-13     # decay, relative to the angular frequency, that counts as none


def wrapped(angle: float) -> float:
    """The angle in (−π, π]."""
    angle = -((-angle + pi) % tau - pi) + 0.0
    return pi if angle == -pi else angle


def kept_up(signal: "LinearSignal") -> bool:
    """Do loads that oscillate without end drive the motion?"""
    forcing = signal.motion.forcing
    return forcing.period is not None or oscillates(forcing)


def free_parts(signal: "LinearSignal") -> "list[Part]":
    """The Parts of a signal after the last change of the loads, of which none oscillates without end."""
    from vibcli.analyses.transient.textbook_form import formula, told_apart

    if kept_up(signal):
        if signal.part == "steady":
            raise PhysicsError("a steady state is no free vibration: it does not die out", "ask for max(x)")
        signal.motion.steady  # noqa: B018 - at resonance there is none, and so no part that is free
        raise PhysicsError("loads that oscillate without end keep this signal in motion: it is no free vibration",
                           "the part of it that is free is transient(x)")
    return formula(signal.motion, signal.output, -1, told_apart(signal.motion))


def vibration(signal: "LinearSignal") -> "Part":
    """The one Part A e^{rate τ} cos(ω τ − φ) of a free vibration, τ from the last change of the loads; PhysicsError
    where there are several or none."""
    parts = [part for part in free_parts(signal) if not part.forced and part.omega]
    largest = max((abs(part.amplitude) for part in parts), default=0.0)
    waves = [part for part in parts if abs(part.amplitude) > ALONE * largest]
    if not waves:
        raise PhysicsError("this signal does not vibrate freely", "ask for max(x), or its value at a time")
    if len(waves) > 1:
        raise PhysicsError(f"this signal holds {len(waves)} vibrations: no one amplitude or decrement is that of all",
                           "ask for max(x), or start in one mode")
    return waves[0]


def from_the_start(signal: "LinearSignal") -> "Part":
    """The same of a vibration that is free from t = 0 on."""
    part = vibration(signal)
    require_from_the_start(signal)
    return part


def require_from_the_start(signal: "LinearSignal") -> None:
    """Refuses a signal whose loads change after t = 0."""
    last = signal.motion.forcing.last.start
    if last:
        kept = "kept up" if kept_up(signal) else "free"
        raise PhysicsError(f"this vibration is {kept} only from t = {last:.6g} s on: A e^(−δt) cos(ω_d t − φ) is not "
                           "its motion from t = 0", "ask for max(x), or its value at a time")


def envelope(signal: "LinearSignal") -> "Decay | Beats":
    """Of the one or two vibrations, free or kept up by loads, that are there from t = 0 on."""
    from vibcli.analyses.transient.envelope import Beats, Decay
    from vibcli.analyses.transient.free_vibration import vibrations

    forcing = signal.motion.forcing
    if forcing.period is not None:
        raise PhysicsError("the loads of this signal have harmonics without end: it has no envelope that is found",
                           "ask for max(x), or its value at a time")
    waves = vibrations(signal.motion, signal.output)
    if any(wave.power for wave in waves):
        raise PhysicsError("at a resonance the amplitude of this signal grows with the time: an envelope is found of "
                           "one vibration and of two", "ask for max(x), or its value at a time")
    if len(waves) > 2:
        raise PhysicsError(f"this signal holds {len(waves)} vibrations: an envelope is found of one and of two",
                           "ask for max(x), or start in one mode or two")
    if len(waves) < 2 and not kept_up(signal):
        waves = [vibration(signal)]
    if not waves:
        raise PhysicsError("this signal does not vibrate", "ask for max(x), or its value at a time")
    require_from_the_start(signal)
    return Beats(*waves) if len(waves) == 2 else Decay(waves[0].amplitude, waves[0].rate)


def amplitude(signal: "LinearSignal") -> float:
    """Of the one free vibration; 0 of what stays at rest."""
    if all(not part.amplitude or not (part.omega or part.rate or part.power) for part in free_parts(signal)):
        return 0.0
    part = vibration(signal)
    return part.amplitude if abs(part.rate) <= UNDYING * part.omega else from_the_start(signal).amplitude


def decrement(signal: "LinearSignal") -> float:
    from vibcli.analyses.transient.free_vibration import decrement

    part = vibration(signal)
    return decrement(part.rate, part.omega) + 0.0       # 0 and not −0 where nothing damps


def time_to(signal: "LinearSignal", fraction: float) -> float:
    from vibcli.analyses.transient.free_vibration import time_to

    return time_to(fraction, _decaying(signal).rate)


def cycles_to(signal: "LinearSignal", fraction: float) -> float:
    from vibcli.analyses.transient.free_vibration import cycles_to

    part = _decaying(signal)
    return cycles_to(fraction, -tau * part.rate / part.omega)


def _decaying(signal: "LinearSignal") -> "Part":
    part = vibration(signal)
    if not part.rate < 0:
        raise PhysicsError("this vibration does not die out: its amplitude never falls to a fraction", "add a damper")
    return part


def beating(signal: "LinearSignal") -> "list[Part]":
    """The two largest vibrations."""
    from vibcli.analyses.transient.free_vibration import vibrations

    return sorted(vibrations(signal.motion, signal.output), key=lambda part: -part.amplitude)[:2]


def beat_period(signal: "LinearSignal") -> float:
    """Of two vibrations that last, one of which a load may keep up."""
    from vibcli.analyses.transient.free_vibration import beat_period

    if signal.motion.forcing.period is None:
        found = beat_period(signal.motion, signal.output)
        if found is not None:
            return found
    raise PhysicsError("this signal has no beats", "beats need two largest vibrations of nearly equal frequencies and "
                       "comparable amplitudes, which last beyond a beat; steady(x) is without those that die out")


def free_period(signal: "LinearSignal") -> float:
    return tau / vibration(signal).omega


def mean(signal: "LinearSignal") -> float:
    """Of what lasts of a free motion."""
    return _vibrating(signal)[0][1].real


def rms(signal: "LinearSignal") -> float:
    """√(c² + Σ A²/2) of c + Σ A cos(ω t − φ), what lasts of a free motion."""
    found: float = sum(abs(X) ** 2 / (2 if speed else 1) for speed, X in _vibrating(signal)) ** 0.5
    return found


def _vibrating(signal: "LinearSignal") -> list[tuple[float, complex]]:
    """The waves that last, of which there is one at least."""
    found = lasting(signal)
    if not any(speed for speed, _ in found):
        raise at_rest()
    return found


def at_rest() -> PhysicsError:
    return PhysicsError("this signal comes to rest: it has no period to take a mean over", "ask for final(x)")


def lasting(signal: "LinearSignal") -> list[tuple[float, complex]]:
    """[(ω, X)] of c + Σ Re X e^{iωt} that does not die out of a free motion, ω = 0 of the constant."""
    if drifting(signal):
        raise drifts_or_grows()
    return beside_drift(signal)


def beside_drift(signal: "LinearSignal") -> list[tuple[float, complex]]:
    """The same of a motion that may drift, of what does not."""
    parts = free_parts(signal)
    if any(part.amplitude and (part.rate > 0 or (part.power and part.omega and not part.rate)) for part in parts):
        raise drifts_or_grows()
    start = signal.motion.forcing.last.start
    waves = [(part.omega, rect(part.amplitude, -part.phase - part.omega * start)) for part in parts
             if part.omega and abs(part.rate) <= UNDYING * part.omega]
    return [(0.0, complex(sum(part.amplitude for part in parts if not (part.omega or part.rate or part.power)))),
            *waves]


def drifting(signal: "LinearSignal") -> dict[int, float]:
    """{k: c} of the c τᵏ in a free motion, τ from the last change of the loads, k ≥ 1."""
    return {part.power: part.amplitude for part in free_parts(signal)
            if part.power and part.amplitude and not (part.omega or part.rate)}


def drifts_or_grows() -> PhysicsError:
    return PhysicsError("this motion drifts or grows: it has no mean over a period", "ask for its value at a time")
