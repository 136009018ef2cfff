"""The motion in time: where it starts, what drives it, its free part as a formula, its steady state, its extremes."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from math import inf
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import NoBound, NoDigit, NotInLetters, PhysicsError, Unknown
from vibcli.base.units import TIME, times
from vibcli.language.sections.initial import FIELDS
from vibcli.notation.numbers import SHOWN, figure, is_lost, supported, with_unit
from vibcli.reader.sections.find import RESPONSE
from vibcli.report import blocks
from vibcli.report.blocks import Name, Section, TableBlock, line, maths, paragraph, section
from vibcli.report.sections.parameters import as_given
from vibcli.report.sections.requested_signals import RequestedSignal, extremes, if_known, signals_asked, trees_asked
from vibcli.report.sections.steady_state import steady_state

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.report.document import Report
    from vibcli.report.wanted import Wanted
    from vibcli.results.escalation import BoundedExtreme
    from vibcli.results.full_response import FullResponse
    from vibcli.results.problem import Problem
    from vibcli.results.response import Response
    from vibcli.results.responses import SmallResponse
    from vibcli.results.signal import Signal
    from vibcli.results.wave_response import WaveResponse

MOST_LINES = 16         # of what drives a motion


def response(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The sections of a motion in time."""
    if problem.numeric.has_free_symbols:
        yield from _in_letters(problem, report.wanted)
        return
    motion, asked = problem.response, signals_asked(problem, report.wanted.signals)
    require_quick(problem, asked, report.wanted)
    if motion.KIND == "prescribed":
        yield from section(f"Motion in time ({motion.words})", paragraph("nothing moves freely"))
    else:
        drive = _drive(problem, motion) if motion.KIND in ("small", "steady") else ()
        yield from _start(problem, motion, _kind(motion, asked), drive)
    if motion.KIND == "full":
        from vibcli.report.sections.integration import integration

        yield from integration(problem, motion)
    elif motion.KIND in ("small", "steady"):
        from vibcli.report.sections.formulas import formulas
        from vibcli.report.sections.vibrations import beats, free_vibration

        yield from free_vibration(problem, asked)
        yield from formulas(asked, motion.until)
        if motion.drive:
            yield from section("Beats", *map(paragraph, beats(asked, motion.until)))
            yield from steady_state(asked, report.wanted.phase)
    if report.pictures:
        from vibcli.report.sections.illustrations import plot
        from vibcli.report.sections.sampled_series import response_figure, sampled

        yield from section("As a plot", plot("response", "The motion in time", response_figure(
            problem, sampled(problem, report.wanted))))
    known = known_until(motion, report.wanted)
    yield from _at_instants(problem, asked, report.wanted, known)
    if not at_instants_alone(motion, report.wanted):
        yield from _extremes(asked, min(known, motion.until), report.wanted.digits)
    if motion.KIND in ("waves", "parts"):
        yield from _by_waves(motion, asked)
    missing = unknown(problem, report.wanted)
    if missing is not None:
        raise missing


def _in_letters(problem: "Problem", wanted: "Wanted") -> Iterator[Section]:
    from vibcli.report.sections.symbolic_response import response_in_letters

    if wanted.at:
        names = ", ".join(name for name in problem.scene.parameters.free if name not in problem.numeric.given)
        raise NotInLetters("values at instants are found in numbers", f"give values with --set to {names}")
    yield from response_in_letters(problem, trees_asked(problem, RESPONSE, wanted.signals))


def _by_waves(motion: "WaveResponse", asked: list[RequestedSignal]) -> Iterator[Section]:
    from vibcli.report.sections.fronts import fronts

    yield from fronts(asked, motion.until)
    if motion.KIND == "waves":
        end = motion.alone.still_from(motion.until)
        if 0 < end < inf:
            yield from section("End of the motion", paragraph(f"all is at rest from t = {figure(end)} s on"))


def require_quick(problem: "Problem", asked: list[RequestedSignal], wanted: "Wanted") -> None:
    """PhysicsError, before anything is computed, where the digits asked for would take long."""
    if wanted.digits is not None:
        from vibcli.results import precise_work

        steps = sum(max(precise_work.estimated_steps(one.signal, float(t), wanted.digits) for one in asked)
                    for _, t in wanted.at)
        precise_work.require_quick(steps, wanted.digits, problem.work)


def at_instants_alone(motion: Any, wanted: "Wanted") -> bool:
    """Is it a motion without an end, that is prescribed, of which instants are asked for?"""
    return motion.KIND == "prescribed" and bool(wanted.at) and not motion.ends


def known_until(motion: Any, wanted: "Wanted") -> float:
    """Up to when a motion is known, of what is asked for [s]: any other than one that is integrated at all times."""
    if motion.KIND != "full":
        return inf
    latest = _latest(motion, wanted)
    return cast("float", min(latest, motion.trajectory(latest).end))


def unknown(problem: "Problem", wanted: "Wanted") -> Unknown | None:
    """The refusal of the part of a motion that is asked for and not known, else None."""
    motion, known = problem.response, known_until(problem.response, wanted)
    late = known < inf and known < _latest(motion, wanted)
    if not late:
        return None
    forces = any(getattr(one.signal, "forces", None) for one in signals_asked(problem, wanted.signals))
    return cast("Unknown | None", (motion.trajectory() if forces else motion).unknown(_latest(motion, wanted)))


def _latest(motion: "FullResponse", wanted: "Wanted") -> float:
    """The last instant that is asked for [s]."""
    return max([motion.until, *(float(t) for _, t in wanted.at)])


def _at_instants(problem: "Problem", asked: Sequence[RequestedSignal], wanted: "Wanted",
                 known: float) -> Iterator[Section]:
    """The values at the instants asked for, those up to `known`."""
    if wanted.at:
        until = 0.0 if at_instants_alone(problem.response, wanted) else min(known, problem.response.until)
        rows = tuple((f"{one.label} [{one.unit}]", *(
            if_known(lambda one=one, t=t: value_at(one, t, wanted.digits, until), str)
            if float(t) <= known else "–" for _, t in wanted.at))
            for one in asked)
        reasons = (unknown_at(one, t) for one, cells in zip(asked, rows, strict=True)
                   for cell, (_, t) in zip(cells[1:], wanted.at, strict=True) if cell in (NoBound.CELL, NoDigit.CELL))
        yield from section("Values", TableBlock(("signal", *(f"t = {text}" for text, _ in wanted.at)), rows),
                           *map(paragraph, dict.fromkeys(filter(None, reasons))))


def value_at(one: RequestedSignal, t: "Fraction", digits: int | None = None, until: float = 0.0) -> str:
    """A signal at an instant, as text; 0 where it is that beside its largest up to another."""
    if digits is None:
        from vibcli.results.escalation import value_of_signal

        signal, end = one.signal.read_at(float(t)), max(until, float(t))
        value, error = value_of_signal(signal, t)
        text, before = in_figures(one.signal, end, value, error, 12), signal.before(float(t))
        return text if before is None else f"{text} (before {in_figures(one.signal, end, before, error, 12)})"
    return precise_text(one.signal.precise(t, digits), digits)


def in_figures(signal: "Signal", t: float, value: float, error: float, digits: int = SHOWN) -> str:
    """A value of a signal up to an instant, as text: 0 where it is that to so many digits of the largest."""
    from vibcli.results.known_digits import size_beside

    return supported(value, error, digits, beside=size_beside(signal, t) if is_lost(value, error) else 0.0)


def precise_text(value: "mpmath.mpf", digits: int) -> str:
    """A number with so many digits, as text."""
    import mpmath

    return cast("str", mpmath.nstr(value, digits, strip_zeros=False))


def _kind(motion: "Response", asked: Sequence[RequestedSignal]) -> str:
    """What kind of motion it is, and in which signals what modes left out add is only estimated."""
    estimated = [one for one in asked if motion.estimated and one.signal.is_estimated]
    if not estimated:
        return motion.words
    told: dict[str, list[str]] = {}
    for one in estimated:
        told.setdefault(one.signal.why_estimated, []).append(one.text)
    all_alike = len(told) == 1 and len(estimated) == len(asked)
    parts = [("" if all_alike else f" in {', '.join(names)}") + (why and f", {why}") for why, names in told.items()]
    return f"{motion.words}; what those left out add is estimated" + ";".join(parts)


def _start(problem: "Problem", motion: "Response", kind: str, drive: Sequence[None]) -> Iterator[Section]:
    places, speeds = motion.start
    parts = []
    for name, value in places.items():
        dimension = problem.system.dimension(name)
        parts += [", "] * bool(parts) + [maths(Name(name), "(0) = "), with_unit(value, dimension)]
        if speeds[name]:
            parts += [", ", maths(Name(name + "'"), "(0) = "), with_unit(speeds[name], times(dimension, TIME, -1))]
    for signal, field in (problem.spec.get(FIELDS) or {}).items():
        parts += [", "] * bool(parts) + [f"{signal.text}(x) = ", as_given(field, frozenset(problem.spec.parameters))]
    given = problem.initial.given
    if any(name not in given for name in places) and not problem.system.named_start and problem.configuration.falls:
        parts += ["   (as drawn: no equilibrium is reached)"]
    force = problem.spec.let_go
    parts += [f", where {force} lets go"] if force else []
    yield from section(f"Motion in time ({kind})", paragraph("from ", *(parts or ["rest"])), *drive)


def _drive(problem: "Problem", motion: "SmallResponse") -> list[Any]:
    """What stands on the right of M q̈ + C q̇ + K q = Q(t), and what of it the left side lacks."""
    if len(motion.drive) > MOST_LINES:
        return [paragraph(f"driven at {len(motion.drive)} coordinates")]
    told: list[Any] = [blocks.equations(line("Q = ", node, label=Name(problem.scene.coordinates[i]))
                                        for i, node in motion.drive.items())]
    if problem.symbolic.left_out:
        from vibcli.report.sections.equations_of_motion import left_out

        told.append(left_out(problem))
    return told


def _extremes(asked: list[RequestedSignal], until: float, digits: int | None) -> Iterator[Section]:
    from vibcli.results.escalation import is_constant

    rows = []
    for one, *both in extremes(asked, until):
        cells = [cell for found, sense in zip(both, (1, -1), strict=True) for cell in (
            (found, "") if isinstance(found, str) else extreme_cells(one.signal, found, until, sense, digits))]
        if is_constant(*both):
            cells[1::2] = ["always"] * 2
        rows.append((f"{one.label} [{one.unit}]".replace(" []", ""), *cells))
    yield from section(f"Extremes for 0 ≤ t ≤ {figure(until)} s",
                       TableBlock(("signal", "largest", "at t [s]", "smallest", "at t [s]"), tuple(rows)),
                       *map(paragraph, dict.fromkeys(filter(None, (without_bound(one, until) for one in asked)))))


def without_bound(one: RequestedSignal, until: float) -> str | None:
    """Why extremes of a signal up to an instant have no bound, and what helps; None where they have one."""
    extreme = partial(one.signal.bounded_extreme, 0.0, until)
    return next(filter(None, (_reason(partial(extreme, sense)) for sense in (1, -1))), None)


def unknown_at(one: RequestedSignal, t: "Fraction") -> Any:
    """Why the value of a signal at an instant is not known, and what helps; None where it is."""
    from vibcli.results.escalation import value_of_signal

    return _reason(lambda: value_of_signal(one.signal.read_at(float(t)), t))


def _reason(found: Callable[[], Any]) -> str | None:
    """Why nothing bounds what a function finds, or leaves it a digit; None where it finds it."""
    try:
        found()
    except NoBound as refusal:
        return f"{refusal.CELL}: {refusal.message}; {refusal.hint}"
    except PhysicsError:
        pass
    return None


def extreme_cells(signal: "Signal", found: "BoundedExtreme", until: float, sense: int,
                  digits: int | None) -> tuple[str, str]:
    """(value, instant) of an extreme as texts, with so many digits where they are asked for and found."""
    if digits is not None:
        with suppress(PhysicsError):
            t, value = signal.precise_extreme(0.0, until, sense, digits)
            return precise_text(value, digits), precise_text(t, digits)
    return in_figures(signal, until, found.value, found.error), (
        supported(found.time, found.error_of_time, beside=until) if found.tells_instant(until) else NoDigit.CELL)
