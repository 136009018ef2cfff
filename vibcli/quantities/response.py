"""Numbers of responses: values in time, extremes, steady amplitudes, decrements, and frequency responses."""

from collections.abc import Callable, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import PhysicsError
from vibcli.quantities.quantity import (
    ERROR,
    EXACT,
    NUMBER,
    OF_SIGNAL,
    PERIOD,
    ROUNDING,
    SIGNAL,
    Declaration,
    ErrorOfZero,
    declared,
    one,
)
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.results.signal import Signal
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

ALONG = ("value", "max", "min", "argmax", "argmin", "zero")     # along motions that are integrated
LOOKS = 4       # at a signal that may be constant


def _measured(number: Callable[..., Any]) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[float, float]]":
    """(value, relative error bound) of a number of a signal, which comes with a function that gives its absolute error;
    hints speak of that signal."""
    def value(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, float]":
        from vibcli.quantities.precise_numbers import settled

        try:
            found, off = number(problem, tree, args)
            if problem.rough:
                return found, 0.0
            kind = problem.response_of(tree).KIND
            if kind in EXACT or (kind == "series" and tree.head in ALONG):
                value, error = settled(problem, tree, args, found, relative(found, lost := off()))
                if value is found and 0.0 < lost >= abs(found):
                    _require_digit(problem, tree, args, found, lost)
                return value, error
            return settled(problem, tree, args, found, max(ERROR, _doubt(problem, tree, found, off)))
        except PhysicsError as error:
            if error.hint and "(x)" in error.hint:
                raise error.told(hint=error.hint.replace("(x)", f"({_found(problem, tree)})")) from None
            raise
    return value


def _require_digit(problem: "Problem", tree: QuantityRef, args: Sequence[Any], found: float, off: float) -> None:
    """NoDigit of a number that may be off by as much as numbers of its kind become."""
    from vibcli.results.known_digits import require_digit, size_of

    try:
        signal, quantity = _signal(problem, tree), declared(tree)
    except PhysicsError:        # the number is found without it
        return
    of_signal = quantity.unit == SIGNAL
    size = size_of(signal, args[1] if tree.head == "value" else _end(problem, tree)) if of_signal else quantity.size(
        problem, tree)
    require_digit(found, off, size, signal.MORE, "value" if of_signal else "number")


def relative(value: float, off: float) -> float:
    """The relative error bound of a value that may be off by so much; of 0, if it may be off at all, 1."""
    if value and isfinite(off):
        return max(ROUNDING, off / abs(value))
    return 1.0 if value else ErrorOfZero(off)


def _doubt(problem: "Problem", tree: QuantityRef, value: float, off: Callable[..., float]) -> float:
    """The relative error of a number of a motion that was integrated: of a value in time, of an extreme, of an instant
    and of a period its own, of others that of the motion up to its end."""
    if problem.response.KIND != "full":
        return 0.0
    if tree.head == "period":
        return cast("float", problem.response.period(tree.args[0])[1])
    if not problem.response.integrated:
        return 0.0
    if tree.head in ALONG:
        return off() / (abs(value) or 1e-300)
    return cast("float", problem.response.reaching(problem.response.known).shared.of_state(problem.response.known))


def _found(problem: "Problem", tree: QuantityRef) -> str:
    """The text of the signal that a quantity is asked of, steady or not, or of that within it which is found: hints
    speak of x."""
    arg = tree.args[0]
    while isinstance(arg, QuantityRef) and declared(arg).kind == OF_SIGNAL and (
            arg.head == "steady" or not _is_found(problem, arg)):
        arg = arg.args[0]
    return tree.text[arg.start - tree.start:arg.end - tree.start]


def _is_found(problem: "Problem", arg: "SyntaxTree") -> bool:
    import numpy as np

    try:
        problem.response.signal(arg).values(np.zeros(1))
    except PhysicsError:
        return False
    return True


def _signal(problem: "Problem", tree: QuantityRef) -> "Signal":
    return cast("Signal", problem.response_of(tree).signal(tree.args[0]))


def at_instant(signal: Any, time: float) -> float:
    """The value of a signal at an instant from t = 0 on."""
    import numpy as np

    if not time >= 0 or not isfinite(time):
        raise PhysicsError(f"there is no motion at t = {time:.6g} s", "motions start at t = 0")
    return float(signal.values(np.array([time]))[0])


def _value(problem: "Problem", tree: QuantityRef, args: Sequence[Any]) -> tuple[float, Callable[..., float]]:
    signal = _signal(problem, tree).read_at(args[1])
    return at_instant(signal, args[1]), lambda: signal.error(args[1])


def _extreme(sense: int) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[float, Callable[..., float]]]":
    """The value of an extreme."""
    def value(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, Callable[..., float]]":
        signal = _signal(problem, tree)
        until = problem.response_of(tree).until
        instant, found = signal.extreme(0.0, until, sense)
        return found, lambda: signal.error_of_extreme(0.0, until, (instant, found), sense)
    return value


def _instant(sense: int) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[float, Callable[..., float]]]":
    """The instant of an extreme."""
    def value(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, Callable[..., float]]":
        signal, until = _signal(problem, tree), problem.response_of(tree).until
        instant = signal.extreme(0.0, until, sense)[0]
        return instant, lambda: _of_what_changes(tree, signal, until, instant)
    return value


def _of_what_changes(tree: QuantityRef, signal: Any, until: float, instant: float) -> float:
    """The bound of an instant, if the signal has one that stands out."""
    from vibcli.results.escalation import is_constant

    error: float = signal.error_of_time(instant)
    at_an_end = instant in (0.0, until)     # exact; of what does not change rounding may tell one
    still = _looks_still(signal, until) if at_an_end else error >= until
    if still and is_constant(*(signal.bounded_extreme(0.0, until, sense) for sense in (1, -1))):
        raise PhysicsError(f"'{tree.text.partition('(')[2].removesuffix(')')}' does not change: no instant of it "
                           "stands out", "ask for max(x)")
    return error


def _looks_still(signal: Any, until: float) -> bool:
    """Is it the same at several instants but for rounding, which sets one apart?"""
    from vibcli.results.escalation import FLAT

    seen = [at_instant(signal, until * k / LOOKS) for k in range(LOOKS + 1)]
    return 0.0 < max(seen) - min(seen) <= FLAT * max(map(abs, seen))


def _final(problem: "Problem", tree: QuantityRef, args: Sequence[Any]) -> tuple[float, Callable[[], float]]:
    return _limit(problem, tree, _signal(problem, tree))


def _limit(problem: "Problem", tree: QuantityRef, signal: Any) -> tuple[float, Callable[[], float]]:
    """(the limit of a signal, what gives its absolute error); of motions of members it is seen to."""
    response = problem.response_of(tree)
    if hasattr(response, "long_after"):
        found, error = response.long_after(tree.args[0]).final
        return found, lambda: error
    return signal.final(), signal.error_of_final


def _small(name: str) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[float, Callable[..., float]]]":
    """Of a small motion."""
    def number(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, Callable[..., float]]":
        from vibcli.quantities import small_motion

        return cast("tuple[float, Callable[..., float]]", getattr(small_motion, name)(problem, tree, args))
    return number


def _overshoot(problem: "Problem", tree: QuantityRef, args: Sequence[Any]) -> tuple[float, Callable[[], float]]:
    signal = _signal(problem, tree)
    start, (final, error_of_final) = at_instant(signal, 0.0), _limit(problem, tree, signal)
    if final == start:
        raise PhysicsError("the signal ends where it starts: it has no overshoot", "ask for max(x)")
    sense = 1 if final > start else -1
    until = problem.response_of(tree).until
    instant, top = signal.extreme(0.0, until, sense)
    found = max(0.0, float((top - final) / (final - start)))

    def off() -> float:
        last, high = error_of_final(), signal.error_of_extreme(0.0, until, (instant, top), sense)
        return (high + last + found * (signal.error(0.0) + last)) / abs(final - start)

    return found, off


def _zero(problem: "Problem", tree: QuantityRef, args: Sequence[Any]) -> tuple[float, Callable[[], float]]:
    number, signal = int(tree.indices[0]), _signal(problem, tree)
    until = problem.response_of(tree).until
    found = signal.first_zeros(until, number)
    if len(found) < number:
        told = f"the signal passes through zero {len(found)} times until t = {until:.6g} s"
        if signal.has_died_out(until):
            raise PhysicsError(told + ", as far as floating-point numbers tell it from zero", "ask for an earlier one")
        raise PhysicsError(told, f"later ones, if there are any, are seen with a later end: find: [{{response: "
                                 f"{{until: {2 * until:.3g} s}}}}]")
    instant = float(found[number - 1])
    return instant, lambda: signal.error_of_zero(instant)


def _end(problem: "Problem", tree: QuantityRef) -> float:
    return cast("float", problem.response_of(tree).until)


def _size(problem: "Problem", tree: QuantityRef) -> float:
    """The largest value of the signal; of a value whose motion has no known end, until its instant and for a second.
    Of members under loads with harmonics without end that of the first one."""
    response = problem.response_of(tree)
    if response.KIND == "steady" and getattr(tree.args[0], "head", "") != "steady":
        response = response.of_harmonic(1)
    try:
        end = response.until
    except PhysicsError:
        if tree.head != "value":
            raise
        from vibcli.quantities.expression import number_of

        end = max(number_of(problem, tree.args[1]), 1.0)
    signal = response.signal(tree.args[0])
    signal = signal.steady if response.KIND == "steady" else signal.coarse
    return cast("float", max(abs(signal.extreme(0.0, end, sense)[1]) for sense in (1, -1)))


def _in_letters(name: str) -> "Callable[[Problem, QuantityRef], Node]":
    def symbolic(problem: "Problem", tree: QuantityRef) -> "Node":
        from vibcli.quantities import responses_in_letters

        return cast("Node", getattr(responses_in_letters, name)(problem, tree))
    return symbolic


def _of_signal(about: str, unit: str, number: Callable[..., Any], indices: tuple[str, ...] = (),
               size: Callable[..., float] = _size, kind: str = NUMBER,
               symbolic: Callable[..., Any] | None = None) -> Declaration:
    return Declaration(about, unit, _measured(number), indices, ("signal",), size=size, kind=kind, symbolic=symbolic)


def _part(about: str) -> Declaration:
    return Declaration(about, SIGNAL, args=("signal",), kind=OF_SIGNAL)


QUANTITIES = {
    "amplitude": _of_signal(
        "amplitude of a signal: in the steady state X of its one harmonic, half its range where it has several; of a "
        "free vibration A of A e^(−δt) cos(ω_d t − φ)", SIGNAL, _small("amplitude")),
    "phase": _of_signal(
        "lag θ of the steady state X sin(Ωt − θ), −π < θ ≤ π; of a free vibration φ of A e^(−δt) cos(ω_d t − φ); of "
        "phase(frf[…](…)): −arg", "rad", _small("phase"), size=one),
    "max": _of_signal("largest value from t = 0 on, up to `until` of the response", SIGNAL, _extreme(1)),
    "min": _of_signal("smallest value", SIGNAL, _extreme(-1)),
    "argmax": _of_signal("instant of the largest value", "s", _instant(1), size=_end),
    "argmin": _of_signal("instant of the smallest value", "s", _instant(-1), size=_end),
    "mean": _of_signal("mean over a period of the steady state, or of free vibrations that do not die out; of powers "
                       "and products of signals too, as in mean(x^2), over all times where they have no common period",
                       SIGNAL, _small("mean"), symbolic=_in_letters("mean")),
    "rms": _of_signal("root mean square of the same", SIGNAL, _small("rms"), symbolic=_in_letters("rms")),
    "final": _of_signal("limit for t → ∞", SIGNAL, _final, symbolic=_in_letters("final")),
    "overshoot": _of_signal("(max − final)/(final − start)", "1", _overshoot, size=one),
    "decrement": _of_signal("logarithmic decrement of a free motion, by successive maxima", "1",
                            _small("decrement"), size=one),
    "beat_period": _of_signal("period of the beats of two neighbouring frequencies, 2π/|ω₁ − ω₂|", "s",
                              _small("beat_period"), size=_end, kind=PERIOD),
    "harmonic": _of_signal("amplitude of harmonic n of the periodic steady state", SIGNAL, _small("harmonic"),
                           ("number",)),
    "zero": _of_signal("instant of the i-th zero, a start or a touch counting as a passage", "s", _zero, ("number",),
                       _end),
    "time_to": _of_signal("time in which the envelope of a free motion falls to a fraction", "s",
                          _small("time_to"), ("fraction",), _end),
    "cycles_to": _of_signal("number of cycles in that time", "1", _small("cycles_to"),
                            ("fraction",), one),
    "steady": _part("steady state of a signal, itself a signal: steady(x)(2 s), max(steady(x))"),
    "transient": _part("the rest of a signal, which dies out where the scene is damped"),
    "envelope": _part("envelope of one vibration, A e^(−δt), or of two, √(A₁² + A₂² + 2A₁A₂ cos(Δω t − Δφ)), each A "
                      "with its own decay; itself a signal"),
    "period()": _of_signal("period of the actual motion of a signal", "s", _small("period"), size=_end, kind=PERIOD),
    "value": Declaration("value of a signal at an instant", SIGNAL, _measured(_value), args=("signal", "time"),
                         size=_size),
}
