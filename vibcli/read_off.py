"""Numbers that are read off one signal of a small motion: of its free vibration, and of its steady state."""

from math import pi

from vibcli.errors import PhysicsError

TURN = 2 * pi
COMMENSURATE, MOST = 1e-9, 1000
ALONE = 1e-10       # amplitude of another vibration, relative to the largest, that counts as none


def vibration(signal):
    """The one Part A e^{rate t} cos(ω t − φ) of a free vibration; PhysicsError where there are several or none."""
    from vibcli.analyses.response.formula import formula

    parts = formula(signal.motion, signal.output)
    largest = max((abs(part.amplitude) for part in parts if part.omega), default=0.0)
    waves = [part for part in parts if part.omega and abs(part.amplitude) > ALONE * largest]
    if not waves:
        raise PhysicsError("this signal does not vibrate freely", "ask for max(x), or its value at a time")
    if len(waves) > 1:
        raise PhysicsError(f"this signal holds {len(waves)} vibrations: no one amplitude or decrement is that of all",
                           "ask for max(x), or start in one mode")
    return waves[0]


def amplitude(signal):
    """Of the one free vibration; 0 of what stays at rest."""
    from vibcli.analyses.response.formula import formula

    if all(not part.amplitude or not (part.omega or part.rate) for part in formula(signal.motion, signal.output)):
        return 0.0
    return vibration(signal).amplitude


def decrement(signal):
    from vibcli.analyses.response.free import decrement

    part = vibration(signal)
    return decrement(part.rate, part.omega)


def time_to(signal, fraction):
    from vibcli.analyses.response.free import time_to

    return time_to(fraction, _decaying(signal).rate)


def cycles_to(signal, fraction):
    from vibcli.analyses.response.free import cycles_to

    part = _decaying(signal)
    return cycles_to(fraction, -TURN * part.rate / part.omega)


def _decaying(signal):
    part = vibration(signal)
    if not part.rate < 0:
        raise PhysicsError("this vibration does not die out: its amplitude never falls to a fraction", "add a damper")
    return part


def beat_period(signal):
    from vibcli.analyses.response.free import beat_period

    found = beat_period(signal.motion, signal.output)
    if found is None:
        raise PhysicsError("this signal has no beats", "beats need two vibrations of nearly equal frequency and "
                           "comparable amplitude that last")
    return found


def free_period(signal):
    return TURN / vibration(signal).omega


def envelope(signal, times):
    """A e^{rate t} of a free vibration."""
    import numpy as np

    part = vibration(signal)
    return part.amplitude * np.exp(part.rate * np.asarray(times))


def harmonics(signal):
    """[(Ω, X)] of the waves of the steady state that is no constant, where it has finitely many."""
    steady = signal.motion.steady
    if steady.period is not None:
        raise PhysicsError("this steady state has harmonics without end", "ask for harmonic[1](x), or max(steady(x))")
    found = [(Omega, X) for Omega, X in steady.phasors(signal.output) if Omega]
    largest = max((abs(X) for _, X in found), default=0.0)
    return [(Omega, X) for Omega, X in found if abs(X) > ALONE * largest]


def fundamental(signal):
    """The angular frequency of a periodic steady state; PhysicsError where it is not periodic."""
    steady = signal.motion.steady
    if steady.period is not None:
        return TURN / steady.period
    speeds = [Omega for Omega, _ in harmonics(signal)]
    if not speeds:
        raise PhysicsError("this steady state is at rest: it has no period", "ask for final(x)")
    for parts in range(1, MOST):
        ratios = [parts * speed / speeds[0] for speed in speeds]
        if all(abs(ratio - round(ratio)) <= COMMENSURATE * ratio for ratio in ratios):
            return speeds[0] / parts
    raise PhysicsError("the frequencies of this steady state have no common period", "ask for max(x) and min(x)")


def harmonic(signal, number):
    """The complex amplitude X of harmonic n of a periodic steady state."""
    steady, Omega = signal.motion.steady, fundamental(signal)
    if steady.period is not None:
        return steady.harmonic(signal.output, number)
    near = [X for speed, X in harmonics(signal) if abs(speed - number * Omega) <= COMMENSURATE * speed]
    return near[0] if near else 0j


def steady_amplitude(signal):
    """Of one harmonic |X|, of several half the range over a period."""
    if signal.motion.steady.period is None:
        found = harmonics(signal)
        if len(found) < 2:
            return abs(found[0][1]) if found else 0.0
    period, steady = TURN / fundamental(signal), signal.steady
    return 0.5 * (steady.extreme(0.0, period, 1)[1] - steady.extreme(0.0, period, -1)[1])
