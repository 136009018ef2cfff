"""Numbers that are read off one signal of a small motion, at the working precision of mpmath: of its steady state, and
of a free vibration A e^{−δt} cos(ω_d t − φ) near that which the floats find."""

import math
from typing import TYPE_CHECKING, Any

from mpmath import mp

from vibcli.analyses.transient.high_precision_steady import SteadyWaves, harmonic
from vibcli.base.errors import PhysicsError
from vibcli.results.precise_signals import PreciseLinear

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.high_precision import PreciseMotion
    from vibcli.analyses.transient.textbook_form import Part

STEPS, LOST, ALONE = 12, 8, 1e-10
NUDGE = 1e-2        # of what the last step may lack, away from an eigenvalue that is met exactly
NEAR = 1e-8         # relative: frequencies of one vibration in floats and in more digits


def limit(signal: Any) -> "mpmath.mpf":
    """For t → ∞, of a signal that has a limit and whose free motion dies out."""
    parts = signal.signals.values() if hasattr(signal, "signals") else [signal]
    for motion in (part.motion for part in parts):
        if not hasattr(motion, "forcing") or motion.forcing.period is not None or any(
                wave.power or wave.exponent for wave in motion.forcing.segments(math.inf)[-1].waves
                if not wave.exponent.real < 0):
            raise _unknown()
    return signal.steady.at(mp.mpf(0)).read(0)[0]


def phasors(signal: PreciseLinear) -> "list[tuple[mpmath.mpf, mpmath.mpc]]":
    """[(Ω, X)] of the steady state Re Σ X e^{iΩt}, by ascending Ω, the constant with Ω = 0; PhysicsError of one that
    has harmonics without end."""
    steady = signal.steady
    if not isinstance(steady.motion, SteadyWaves):
        raise _unknown()
    found = {mp.mpf(0): mp.mpc(steady.output.constant)}
    for speed, X in steady.motion.phasors(steady.output):
        found[speed] = found.get(speed, 0) + X
    return sorted(found.items())


def harmonics(signal: PreciseLinear) -> "list[tuple[mpmath.mpf, mpmath.mpc]]":
    """Those of them that oscillate, but for such as are nothing beside the largest."""
    found = [(speed, X) for speed, X in phasors(signal) if speed]
    largest = max((abs(X) for _, X in found), default=0)
    return [(speed, X) for speed, X in found if abs(X) > ALONE * largest]


def repeated(signal: PreciseLinear, number: int) -> "mpmath.mpc":
    """X of a harmonic of the steady state under periodic forcing, of number 0 the mean."""
    return harmonic(signal.steady.motion, signal.output, number)


def mean_square(signal: PreciseLinear) -> "mpmath.mpf":
    """Of the steady state over all time."""
    return mp.fsum(abs(X) ** 2 / (2 if speed else 1) for speed, X in phasors(signal))


def eigenvalue(signal: PreciseLinear, part: "Part") -> "mpmath.mpc":
    """λ of the vibration e^{λt} of a Part in floats."""
    return _eigenpair(_matrix(signal), mp.mpc(part.rate, part.omega))[0]


def residue(signal: PreciseLinear, part: "Part") -> "mpmath.mpc":
    """a of the free vibration Re(a e^{λt}) of a Part in floats, under loads that do not change their form from the
    start on: of the start less the steady state then."""
    motion, A = signal.motion, _matrix(signal)
    steady = signal.steady.motion
    if not isinstance(steady, SteadyWaves) or len(motion.forcing.pieces) > 1 or any(
            wave.exponent.real for wave in motion.forcing.pieces[0].waves):
        raise _unknown()
    λ, right = _eigenpair(A, mp.mpc(part.rate, part.omega))
    _, left = _eigenpair(A.T, λ)
    rest = [mp.fsum(mp.re(s**order * Q[i]) for s, Q, _ in steady.waves)
            for order, places in enumerate((motion.system.places, motion.system.heavy)) for i in places]
    start = [y - x for y, x in zip(motion.start, rest, strict=True)]
    share = mp.fdot(left, start) / mp.fdot(left, right)
    return 2 * share * _read(motion, A, signal.output, right)


def _read(motion: "PreciseMotion", A: "mpmath.matrix", output: "LinearOutput", right: "mpmath.matrix") -> "mpmath.mpc":
    """The output of the state e^{λt} v: of the rows Q of its coordinates."""
    rate, Q = A * right, motion.system.Q
    turn = A * rate
    return mp.fsum(x * mp.fdot([mp.mpmathify(entry) for entry in Q[i]], state)
                   for part, state in ((output.q, right), (output.v, rate), (output.a, turn)) for i, x in part.items())


def _matrix(signal: PreciseLinear) -> "mpmath.matrix":
    if not isinstance(signal, PreciseLinear) or not hasattr(signal.motion, "system"):
        raise _unknown()
    return mp.matrix(signal.motion.system.A.tolist())


def _eigenpair(A: "mpmath.matrix", near: "mpmath.mpc") -> "tuple[mpmath.mpc, mpmath.matrix]":
    """(λ, v) of A v = λ v by Rayleigh's quotients from a value in floats."""
    size, λ = A.rows, near
    vector = mp.matrix([mp.mpc(1, k % 3) / (k + 1) for k in range(size)])
    small = mp.mpf(10) ** (LOST - mp.dps) * abs(near)
    for step in range(STEPS):
        try:
            fresh = mp.lu_solve(A - λ * mp.eye(size), vector)
        except ZeroDivisionError:           # it is λ itself
            λ += small * NUDGE
            continue
        change = mp.fdot(map(mp.conj, fresh), vector) / mp.fdot(map(mp.conj, fresh), fresh)
        vector = fresh / mp.norm(fresh)
        λ += change
        if step and abs(change) <= small:
            return λ, vector
    raise _unknown()


def _unknown() -> PhysicsError:
    return PhysicsError("more digits of this number are not found", "ask for values at instants, or leave --digits out")
