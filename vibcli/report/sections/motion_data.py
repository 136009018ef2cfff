"""Motions in time as data, with the bounds of what is found, and the keys of these data."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.report.keys import Key, data
from vibcli.report.sections.expanded_motion import PERIODS, compared_periods
from vibcli.report.sections.requested_signals import extremes, if_known, signals_asked
from vibcli.report.sections.response import (
    at_instants_alone,
    known_until,
    require_quick,
    unknown,
    unknown_at,
    value_at,
    without_bound,
)
from vibcli.report.sections.steady_state import harmonics_of, phase_in

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.report.wanted import Wanted
    from vibcli.results.escalation import BoundedExtreme
    from vibcli.results.problem import Problem
    from vibcli.results.response import Response
    from vibcli.results.signal import Signal


def response_data(problem: "Problem", wanted: "Wanted") -> dict[str, Any]:
    """A motion in time as data, as far as it is known."""
    motion, asked = problem.response, signals_asked(problem, wanted.signals)
    require_quick(problem, asked, wanted)
    places, speeds = motion.start
    known = known_until(motion, wanted)
    instants = [_values(problem, one, wanted, known) for one in asked]
    alone = at_instants_alone(motion, wanted)
    end = None if alone else min(known, motion.until)
    ends = [(one, None, None) for one in asked] if alone else extremes(asked, end)
    found = [SIGNALS.row(one.text, one.unit, *(number for which in both for number in _of_extreme(which, end)),
                         None if alone else without_bound(one, end),
                         None if alone else _steady(motion, one.signal, wanted.phase), values,
                         [] if alone else one.signal.leaps(end), motion.estimated and one.signal.is_estimated)
             for (one, *both), values in zip(ends, instants, strict=True)]
    missing = unknown(problem, wanted)
    return data((*KNOWN, PERIODS, UNKNOWN, ESTIMATED), {
        "until": end, "initial": {} if alone else {**places, **{name + "'": v for name, v in speeds.items()}},
        "signals": found, "balance": motion.trajectory().balance.error if motion.KIND == "full" else None,
        "unknown": missing and missing.message, "estimated": any(one["estimated"] for one in found),
        "periods": compared_periods(problem, motion)})


def _of_extreme(found: "BoundedExtreme | str", end: float) -> tuple[float | None, float | None, float | None]:
    """(value, bound of its error, instant) of a BoundedExtreme up to an end; nothing of what is not known."""
    if found is None or isinstance(found, str):
        return (None,) * 3
    return found.value, found.error, found.time if found.tells_instant(end) else None


def _values(problem: "Problem", one: "RequestedSignal", wanted: "Wanted",
            known: float) -> "list[tuple[float | Fraction | None, ...]]":
    """[(t, value, bound of its error, why there is none)] at the instants asked for; with --digits as texts; None
    beyond what is known."""
    def value(t: "Fraction") -> "tuple[Any, ...]":
        from vibcli.results.escalation import value_of_signal

        if float(t) > known:
            return None, None, None
        if wanted.digits is not None:
            return value_at(one, t, wanted.digits), None, None
        found: tuple[Any, ...] = if_known(lambda: (*value_of_signal(one.signal.read_at(float(t)), t), None),
                                            lambda _: (None, None, unknown_at(one, t)))
        return found

    return [(t, *value(t)) for _, t in wanted.at]


def _steady(motion: "Response", signal: "Signal", convention: str) -> list[tuple[float, complex, float]] | None:
    """[(Ω, X, phase)] of the steady state; None where there is none."""
    if not motion.drive or not hasattr(signal, "output"):
        return None
    try:
        return [(Omega, X, phase_in(convention, X)) for Omega, X, _ in harmonics_of(signal)]
    except PhysicsError:
        return None


SIGNALS = Key("signals", "a list, one entry to each signal", each=(
    Key("signal", "the signal as written"),
    Key("unit", "its unit"),
    Key("max", "its largest value for 0 ≤ t ≤ until; null of a force that statics alone does not fix at all of these "
        "instants, and of what has no bound or one as large as the signal"),
    Key("max_error", "how far that may be off at most, of a motion that is integrated, or `estimated`, about"),
    Key("argmax", "the instant of that, in s; null where its bound is as long as all of the time"),
    Key("min", "its smallest value; null as above"),
    Key("min_error", "how far that may be off, as above"),
    Key("argmin", "the instant of that, in s"),
    Key("no_bound", "null, or why its largest and smallest values have no bound, or one as large as the signal, and "
        "what helps"),
    Key("steady", "a list of the harmonics of the steady state, of a periodic load the first; null where there is none",
        each=(
            Key("Omega", "angular frequency of a harmonic", lambda one: one[0]),
            Key("amplitude", "its amplitude X", lambda one: abs(one[1])),
            Key("phase", "its θ in X sin(Omega t − θ), or as --phase says", lambda one: one[2]))),
    Key("at", "a list, one entry to each --at; empty without", each=(
        Key("t", "the instant, in s", lambda one: float(one[0])),
        Key("value", "the value then, null where it is not known; with --digits a decimal", lambda one: one[1]),
        Key("error", "how far that may be off, as above; null with --digits", lambda one: one[2]),
        Key("no_bound", "null, or why that has no bound or one as large as the signal, and what helps",
            lambda one: one[3]))),
    Key("fronts", "a list of the fronts of travelling waves at which the signal leaps; empty of other motions", each=(
        Key("t", "the instant, in s", lambda one: one[0]),
        Key("before", "the value before it", lambda one: one[1]),
        Key("after", "the value after it", lambda one: one[2]))),
    Key("estimated", "true where its errors are estimates of what modes of members left out add, and no bounds")))
KNOWN = (
    Key("until", "its end, in s, as far as it is known; null where a motion that is all prescribed is asked for at "
        "instants alone"),
    Key("initial", "{coordinate, or velocity x': value at t = 0}"), SIGNALS,
    Key("balance", "what the energies of an integrated motion fail to balance by, relative to the largest; null of "
        "small oscillations, and of a motion that --digits follows by series"))
UNKNOWN = Key("unknown", "null, or why the motion is known up to `until` alone, though more was asked for")
ESTIMATED = Key("estimated", "true where the errors of a signal at least are estimates")
MOTION = Key("response", "of `vibcli response`, and where `find` asks: the motion in time; null where symbols have no "
             "value", of=(UNKNOWN, *KNOWN, PERIODS, ESTIMATED))
