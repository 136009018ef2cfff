"""The numbers of small motions that are found to any number of digits, each by the word that asks for it."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from mpmath import mp

from vibcli.base.errors import PhysicsError
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.results import precise_features, signal_features, steady_features
from vibcli.results.escalation import largest
from vibcli.results.precise_frequency_response import LEVEL, POLE, TURN, ZERO, precise_place, precise_response
from vibcli.results.precise_instants import extreme_to, required, value_when
from vibcli.results.precise_signals import agreed, precise_signal
from vibcli.results.signals import LinearSignal
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import QuantityRef, parts_of

if TYPE_CHECKING:
    import mpmath

    from vibcli.results.precise_frequency_response import PreciseCurve
    from vibcli.results.precise_signals import PreciseLinear
    from vibcli.results.problem import Problem
    from vibcli.results.signals import ComposedSignal
    from vibcli.symbolic.syntax import Number

    Precise = Callable[[Problem, QuantityRef, int, float], mpmath.mpf]


def _signal(problem: "Problem", tree: QuantityRef) -> "ComposedSignal | LinearSignal":
    found: ComposedSignal | LinearSignal = problem.response.signal(tree.args[0])
    return found


def _value(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
    signal, when = _signal(problem, tree), _exactly(problem, tree.args[1])
    return value_when(signal, when, digits, most, largest(signal, float(when())))


def _exactly(problem: "Problem", tree: "Number") -> "Callable[[], mpmath.mpf]":
    """A function that gives an instant or a frequency at the working precision; cycles count as 2π."""
    if parts_of(tree).quantities:
        raise PhysicsError("an instant or a frequency that is found itself has no more digits", "write it as a number")

    def number() -> "mpmath.mpf":
        arithmetic, nodes = multiprecision(), problem.scene.parameters.nodes
        node = lower(tree, problem.scene.table, lambda name, primes, part: nodes[name])
        found, = evaluate([node], arithmetic, problem.numeric.values(arithmetic))
        return found * 2 * mp.pi if counts_cycles(problem.spec, tree) else found

    return number


def response(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpc":
    """A frequency response at a frequency."""
    signal, driver = tree.indices
    return precise_response(problem, signal, driver, _exactly(problem, tree.args[0]), digits, most)


def _extreme(sense: int, which: int) -> "Precise":
    def value(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
        signal, until = _signal(problem, tree), problem.response.until
        return extreme_to(signal, 0.0, until, sense, digits, 0.0, most)[which]
    return value


def _zero(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
    signal, number = _signal(problem, tree), int(tree.indices[0])
    return signal.precise_zero(signal.first_zeros(problem.response.until, number)[number - 1], digits)


def _overshoot(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
    signal, until = _signal(problem, tree), problem.response.until
    start, final = signal.precise(0, digits), agreed(lambda: [_final(signal, _fine(signal), tree)], digits)[0]
    with mp.workdps(digits + 5):
        top = extreme_to(signal, 0.0, until, 1 if final > start else -1, digits, 0.0, most)[1]
        return max(mp.mpf(0), (top - final) / (final - start))


def _fine(signal: "ComposedSignal | LinearSignal") -> Any:
    return precise_signal(required(signal))


def _read(find: "Callable[[Any, Any, QuantityRef], mpmath.mpf]") -> "Precise":
    """A number that `find(signal in floats, signal, tree)` reads off a linear signal."""
    def value(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
        signal = _signal(problem, tree)
        if not isinstance(signal, LinearSignal) and tree.head != "final":
            raise PhysicsError("more digits of this are not found", "ask for values at instants")
        return agreed(lambda: [find(signal, _fine(signal), tree)], digits)[0]
    return value


def _final(signal: "ComposedSignal | LinearSignal", fine: Any, tree: QuantityRef) -> "mpmath.mpf":
    parts = [signal] if isinstance(signal, LinearSignal) else signal.signals.values()
    if any(not node.real < 0 for part in parts for block in part.motion.blocks for node in block.nodes):
        raise PhysicsError("more digits of a limit are not found where a free motion does not die out",
                           "ask for values at instants")
    return precise_features.limit(fine)


def _one(signal: LinearSignal, fine: "PreciseLinear") -> "tuple[mpmath.mpf, mpmath.mpc]":
    """The one harmonic (Ω, X) of a steady state that loads keep up."""
    found = precise_features.harmonics(fine)
    if len(found) != 1 or signal.part == "transient":
        raise PhysicsError("more digits of several harmonics together are not found", "ask for harmonic[1](x)")
    return found[0]


def _amplitude(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    if signal_features.kept_up(signal):
        return abs(_one(signal, fine)[1])
    return abs(precise_features.residue(fine, signal_features.from_the_start(signal)))


def _phase(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    if signal_features.kept_up(signal):
        return _wrapped(-mp.arg(_one(signal, fine)[1]) - mp.pi / 2)
    return _wrapped(-mp.arg(precise_features.residue(fine, signal_features.from_the_start(signal))))


def _wrapped(angle: "mpmath.mpf") -> "mpmath.mpf":
    """−π < angle ≤ π."""
    return angle - 2 * mp.pi * mp.ceil((angle - mp.pi) / (2 * mp.pi))


def _harmonic(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    if signal.motion.steady.period is not None:
        return abs(precise_features.repeated(fine, int(tree.indices[0])))
    wanted = int(tree.indices[0]) * steady_features.fundamental(signal)
    near = [abs(X) for speed, X in precise_features.harmonics(fine)
            if abs(speed - wanted) <= steady_features.COMMENSURATE * speed]
    return near[0] if near else mp.mpf(0)


def _mean(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    _require_kept_up(signal)
    if signal.motion.steady.period is not None:
        return mp.re(precise_features.repeated(fine, 0))
    return mp.re(dict(precise_features.phasors(fine))[0])


def _rms(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    _require_kept_up(signal)
    return mp.sqrt(precise_features.mean_square(fine))


def _require_kept_up(signal: LinearSignal) -> None:
    if not signal_features.kept_up(signal):
        raise PhysicsError("more digits of this are found of steady states alone", "ask for values at instants")


def _decrement(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    λ = precise_features.eigenvalue(fine, signal_features.vibration(signal))
    return -2 * mp.pi * λ.real / λ.imag


def _time_to(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    return mp.log(_fraction(tree)) / precise_features.eigenvalue(fine, signal_features.vibration(signal)).real


def _cycles_to(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    return -mp.log(_fraction(tree)) / _decrement(signal, fine, tree)


def _fraction(tree: QuantityRef) -> "mpmath.mpf":
    return mp.mpf(tree.indices[0])


def _period(signal: LinearSignal, fine: "PreciseLinear", tree: QuantityRef) -> "mpmath.mpf":
    if signal_features.kept_up(signal):
        return 2 * mp.pi / _one(signal, fine)[0]
    return 2 * mp.pi / precise_features.eigenvalue(fine, signal_features.vibration(signal)).imag


def place(problem: "Problem", tree: QuantityRef, digits: int, most: float) -> "mpmath.mpf":
    """A place of a frequency response, or what is read off it there."""
    signal, driver = tree.args[0].indices
    curve, number = problem.frequency_response(signal, driver), int(tree.indices[0]) - 1

    def top(fine: "PreciseCurve", number: int) -> "mpmath.mpf":
        peak = curve.peak(number + 1)
        return fine.place(peak.Omega, POLE if peak.value is None else TURN)

    def half(fine: "PreciseCurve", number: int) -> "mpmath.mpf":
        peak = number // 2
        level = abs(fine.at(top(fine, peak))[0]) ** 2 / 2
        return fine.place(curve.half_power_of(peak + 1)[number % 2], LEVEL, level)

    def read(fine: "PreciseCurve") -> "mpmath.mpf":
        if tree.head == "antiresonance":
            return fine.place(curve.antiresonance(number + 1), ZERO if curve.undamped else TURN)
        if tree.head == "half_power":
            return half(fine, number)
        if tree.head == "quality":
            return top(fine, number) / (half(fine, 2 * number + 1) - half(fine, 2 * number))
        return top(fine, number) if tree.component == "Omega" else abs(fine.at(top(fine, number))[0])

    return precise_place(problem, signal, driver, read, digits, most)


NUMBERS: "dict[str, Precise]" = {
    "value": _value, "max": _extreme(1, 1), "min": _extreme(-1, 1), "argmax": _extreme(1, 0), "argmin": _extreme(-1, 0),
    "zero": _zero, "overshoot": _overshoot, "final": _read(_final),
    "amplitude": _read(_amplitude), "phase": _read(_phase), "harmonic": _read(_harmonic), "mean": _read(_mean),
    "rms": _read(_rms), "decrement": _read(_decrement), "time_to": _read(_time_to), "cycles_to": _read(_cycles_to),
    "period": _read(_period)}
