"""First-order bounds of the errors of what is read off signals of small motions, absolute each."""

from math import inf, log, pi
from typing import TYPE_CHECKING

from vibcli.analyses.transient import steady_errors
from vibcli.base.named_tuple import NamedTuple
from vibcli.results import signal_features, steady_features

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.transient.envelope import Beats, Decay
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.results.signals import LinearSignal

ROUNDING = 2.0**-49
FADED, LEFT = 4.0, 1.25     # decay times after which little is left of a transient, and a factor for what is
SAMPLES = 8         # instants of a period at which the errors of a root mean square are looked at


class PartErrors(NamedTuple):
    """Of amplitude, phase, rate and angular frequency."""

    amplitude: float
    phase: float
    rate: float
    omega: float


def of_part(signal: "LinearSignal", part: "Part") -> PartErrors:
    """Of a vibration A e^{rate τ} cos(ω τ − φ) in a signal, τ from the last change of the loads."""
    import numpy as np

    motion = signal.motion
    errors = motion.pieces(0.0 if motion.forcing.period else inf).errors
    node = complex(part.rate, part.omega)
    if part.forced:
        off = [error for rate, error in steady_errors.of_waves_in(motion.steady, signal.output).items()
               if abs(rate - part.omega) <= signal_features.ALONE * part.omega]
        return _with_phase(part, sum(off), 0.0, ROUNDING * part.omega)
    decay, speed = errors.system.of_eigenvalue(node)
    start = errors.timeline.starts[-1:]
    places = [place for place, block in zip(errors.system.places, motion.blocks, strict=True)
              if len(block.B) == 1 and abs(block.B[0, 0] - node) <= ROUNDING * abs(node)]
    if places:
        amplitude = errors.of_free(signal.output, places[0].start)
    else:
        value, slope = (float(motion.errors(signal.output, start, order)[0]) for order in range(2))
        amplitude = value + (slope + abs(part.rate) * value) / part.omega
        amplitude += abs(part.amplitude) * (decay + speed) / part.omega
    return _with_phase(part, float(np.real(amplitude)), decay, speed)


def _with_phase(part: "Part", amplitude: float, rate: float, omega: float) -> PartErrors:
    amplitude += ROUNDING * abs(part.amplitude)
    return PartErrors(amplitude, min(pi, amplitude / (abs(part.amplitude) or 1e-300)) + ROUNDING, rate, omega)


def amplitude(signal: "LinearSignal") -> float:
    """Of the one free vibration, or of the steady state that loads keep up."""
    if not signal_features.kept_up(signal):
        if not signal_features.amplitude(signal):
            return 0.0
        return of_part(signal, signal_features.vibration(signal)).amplitude
    steady = signal.motion.steady
    if steady.period is None and len(steady_features.harmonics(signal)) < 2:
        return sum(phasors(signal).values())
    from math import tau

    period = tau / steady_features.fundamental(signal)
    return 0.5 * sum(signal.steady.error(signal.steady.extreme(0.0, period, sense)[0]) for sense in (1, -1))


def phasors(signal: "LinearSignal") -> dict[float, float]:
    """{Ω: |δX|} of the waves of the steady state."""
    return {rate: error for rate, error in steady_errors.of_waves_in(signal.motion.steady, signal.output).items()
            if rate}


def phase(signal: "LinearSignal") -> float:
    if not signal_features.kept_up(signal):
        return of_part(signal, signal_features.vibration(signal)).phase
    (Omega, X), = steady_features.harmonics(signal)
    return min(pi, phasors(signal)[Omega] / abs(X)) + ROUNDING


def harmonic(signal: "LinearSignal", number: int) -> float:
    steady = signal.motion.steady
    if steady.period is None and signal.motion.forcing.period is not None:     # of one harmonic alone
        return sum(phasors(signal).values())
    Omega = steady_features.fundamental(signal)
    if steady.period is not None:
        return steady_errors.of_harmonic(steady, signal.output, number)
    return sum(error for rate, error in phasors(signal).items()
               if abs(rate - number * Omega) <= steady_features.COMMENSURATE * rate)


def mean(signal: "LinearSignal", value: float = 0.0) -> float:
    """Of the mean, `value`."""
    if not signal_features.kept_up(signal):
        return _at_last(signal) + sum(error for _, error in _lasting(signal))
    steady = signal.motion.steady
    if steady.period is not None and not steady.powers:
        return steady_errors.of_harmonic(steady, signal.output, 0) + ROUNDING * abs(signal.output.constant)
    constant = ROUNDING * abs(signal.output.constant) + signal.motion.data_errors.of_rest(signal.output)
    return steady_errors.of_waves_in(steady, signal.output).get(0.0, 0.0) + constant


def rms(signal: "LinearSignal", value: float) -> float:
    """Of the root mean square, `value`."""
    import numpy as np

    if not signal_features.kept_up(signal):
        return mean(signal) + sum(A * error for A, error in _lasting(signal)) / (2 * value or 1.0)
    steady = signal.motion.steady
    if steady.period is not None:
        times = steady.period * np.arange(SAMPLES) / SAMPLES
        return 2 * float(steady.errors(signal.output, times).max()) + ROUNDING * value
    sizes = dict(steady.phasors(signal.output))
    return sum(abs(sizes.get(rate, 0.0)) * error for rate, error in steady_errors.of_waves_in(
        steady, signal.output).items()) / (value or 1.0) + ROUNDING * value + mean(signal)


def of_waves(signal: "LinearSignal", waves: "Sequence[tuple[float, complex]]") -> list[float]:
    """Of the X of the waves [(Ω, X)] of a steady state, Ω = 0 of the mean."""
    found = steady_errors.of_waves_in(signal.motion.steady, signal.output)
    return [sum(error for rate, error in found.items() if abs(rate - speed) <= steady_features.COMMENSURATE * speed)
            if speed else mean(signal) for speed, _ in waves]


def of_lasting(signal: "LinearSignal") -> list[float]:
    """Of the X of signal_features.lasting."""
    return [_at_last(signal), *(error for _, error in _lasting(signal))]


def _lasting(signal: "LinearSignal") -> list[tuple[float, float]]:
    """[(amplitude, its error)] of the vibrations that do not die out."""
    return [(abs(part.amplitude), of_part(signal, part).amplitude) for part in signal_features.free_parts(signal)
            if part.omega and abs(part.rate) <= signal_features.UNDYING * part.omega]


def _at_last(signal: "LinearSignal") -> float:
    """Of the value at the last change of the loads."""
    import numpy as np

    motion = signal.motion
    last = motion.pieces(0.0 if motion.forcing.period else inf).timeline.starts[-1]
    return float(motion.errors(signal.output, np.array([last]))[0])


def relative_of_decrement(signal: "LinearSignal") -> float:
    """Relative, of the decrement and of what follows from it; of no decay 0."""
    part = signal_features.vibration(signal)
    found = of_part(signal, part)
    return (found.rate / abs(part.rate) + found.omega / part.omega if part.rate else 0.0) + ROUNDING


def relative_of_decay(signal: "LinearSignal", fraction: float) -> float:
    """Relative, of the time in which a vibration falls to a fraction."""
    part = signal_features.vibration(signal)
    return of_part(signal, part).rate / abs(part.rate) + ROUNDING * (1 + 1 / (abs(log(fraction)) or 1.0))


def relative_of_beats(signal: "LinearSignal") -> float:
    """Relative, of the period of beats."""
    one, two = signal_features.beating(signal)
    return sum(of_part(signal, part).omega + ROUNDING * part.omega for part in (one, two)) / abs(
        one.omega - two.omega)


def relative_of_period(signal: "LinearSignal") -> float:
    if signal_features.kept_up(signal):
        return ROUNDING
    part = signal_features.vibration(signal)
    return of_part(signal, part).omega / part.omega + ROUNDING


def final(signal: "LinearSignal") -> float:
    """Of the limit: that of the value when what fades has all but faded, before what cancels in it has grown."""
    import numpy as np

    motion = signal.motion
    last = motion.forcing.last
    rates = [node.real for block in motion.blocks for node in block.nodes] + [wave.exponent.real for wave in last.waves]
    slowest = min((abs(rate) for rate in rates if rate), default=inf)
    return LEFT * float(motion.errors(signal.output, np.array([last.start + FADED / slowest]))[0])


def envelope(signal: "LinearSignal", found: "Decay | Beats", t: float) -> tuple[float, float]:
    """(of the value, of an instant at which it is largest or smallest) at an instant, of the envelope of a signal."""
    import numpy as np

    from vibcli.analyses.transient.envelope import Beats
    from vibcli.analyses.transient.free_vibration import vibrations

    if isinstance(found, Beats):
        parts = [found.one, found.two]
    else:
        parts = vibrations(signal.motion, signal.output) or [signal_features.vibration(signal)]
    errors = [of_part(signal, part) for part in parts]
    sizes = [abs(part.amplitude) * float(np.exp(part.rate * t)) for part in parts]
    grown = [float(np.exp(part.rate * t)) for part in parts]
    value = sum(grow * error.amplitude + size * (error.rate * t + ROUNDING)
                for grow, size, error in zip(grown, sizes, errors, strict=True))
    if not isinstance(found, Beats):
        return value, ROUNDING * t
    angle = sum((error.omega + ROUNDING * part.omega) * t + error.phase
                for part, error in zip(parts, errors, strict=True))
    return value + min(sizes) * angle, angle / abs(found.apart) + ROUNDING * t
