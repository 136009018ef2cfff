"""Frequency responses: amplitude at rest, resonances and antiresonances; amplitudes in letters of few degrees."""

from collections.abc import Iterator
from math import isfinite, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.numbers import figure, supported
from vibcli.report import blocks
from vibcli.report.blocks import Section, TableBlock, line, maths, note, paragraph, section
from vibcli.report.keys import Key, data
from vibcli.report.sections.requested_signals import curves_asked, symbol

if TYPE_CHECKING:
    from vibcli.report.blocks import Paragraph
    from vibcli.report.document import Report
    from vibcli.report.wanted import Wanted
    from vibcli.results.frequency_response import FrequencyResponse
    from vibcli.results.problem import Problem

LETTERS = 2     # most degrees of freedom whose amplitudes are written in letters


def frequency_response(problem: "Problem", report: "Report") -> Iterator[Section]:
    """A section for each frequency response that is asked for."""
    for name, driver, unit in curves_asked(problem, report.wanted):
        title = f"Frequency response of {symbol(name)} to {driver}"
        blocks_of = list(_in_letters(problem, name, driver))
        if not problem.numeric.has_free_symbols:
            blocks_of += _in_numbers(problem, name, driver, unit)
        yield from section(title, *blocks_of, note(f"H in {unit}, lag " if unit != "1" else "H without unit, lag ",
                                                   maths("θ = −arg H")))
    if report.pictures and not problem.numeric.has_free_symbols:
        from vibcli.report.sections.illustrations import plot
        from vibcli.report.sections.sampled_series import frequency_figure, sampled_curves

        curves = sampled_curves(problem, report.wanted)
        yield from section("As a plot", plot("frequency-response", "Amplitude and phase lag over the frequency",
                                             frequency_figure(problem, curves)))


def _in_letters(problem: "Problem", name: str, driver: str) -> Iterator[Any]:
    """The amplitude and tan θ, resonances and antiresonances; nothing where they are too long or not known."""
    if len(problem.scene.q) > LETTERS:
        if problem.numeric.has_free_symbols:
            raise NotInLetters(f"frequency responses of more than {LETTERS} degrees of freedom are found in numbers",
                               "give the parameters values with --set")
        return
    from vibcli.report.sections.symbolic_modes import turned
    from vibcli.report.sections.symbolic_response import conditions, lag_line, ratio_lines

    try:
        found = problem.symbolic_frequency_response(name, driver)
    except (NotInLetters, PhysicsError):
        if problem.numeric.has_free_symbols:
            raise
        return
    if found.vanishes:
        lines = [line("H = 0")]
    elif found.undamped:
        lines = [line("H = ", found.amplitude), *ratio_lines(problem, found, "H")]
    elif found.ahead:
        lines = [line("H = ", *turned(found.amplitude))]
    else:
        lines = [line("|H| = ", found.amplitude), *ratio_lines(problem, found, "|H|"), lag_line(found, "theta")]
    yield blocks.equations(lines)
    yield from conditions(found)


def _in_numbers(problem: "Problem", name: str, driver: str, unit: str) -> "Iterator[Paragraph | TableBlock]":
    curve = problem.frequency_response(name, driver)
    curve.find_errors()
    rows = [_peak_row(curve, number, peak) for number, peak in enumerate(_peaks(curve), 1)]
    rows += [(f"antiresonance {number}", *_place(Omega, off), figure(size, error), "", "", "")
             for number, (Omega, off, size, error) in enumerate(curve.dips, 1)]
    head = ("", "Ω [rad/s]", "f [Hz]", f"|H| [{unit}]", "Ω₁ [rad/s]", "Ω₂ [rad/s]", "Q")
    yield _static(curve, unit)
    yield TableBlock(head, tuple(rows)) if rows else paragraph("no resonance")
    if not curve.transfer.counts("poles"):
        yield paragraph("(poles are looked for from many places and not counted: peaks may be missing)")
    if not curve.transfer.counts("zeros"):
        yield paragraph("(antiresonances are followed from those without damping and not counted: some may be missing)")
    yield from _fixed_points(problem, curve, unit)
    if any(isfinite(value) for _, value in curve.peaks):
        yield paragraph("Ω₁ and Ω₂: half-power points, |H| = peak/√2; Q = Ω/(Ω₂ − Ω₁)")


def _place(Omega: float, off: float) -> tuple[str, str]:
    """A frequency that is off by so much, in rad/s and Hz."""
    return supported(Omega, off), supported(Omega / tau, off / tau)


def _peak_row(curve: "FrequencyResponse", number: int, peak: "ResonancePeak") -> tuple[str, ...]:
    off, relative = curve.error_of_peak(number)
    value = "∞" if peak.value is None else figure(peak.value, relative)
    beside = ["–"] * 3
    if peak.quality is not None:
        errors = curve.errors_of_half_power(number)
        beside = [supported(peak.low, errors[0]), supported(peak.high, errors[1]),
                  figure(peak.quality, curve.error_of_quality(number))]
    return f"peak {number}", *_place(peak.Omega, off), value, *beside


def _fixed_points(problem: "Problem", curve: "FrequencyResponse", unit: str) -> Iterator[Any]:
    """Through which all curves pass, whatever the one damper of two degrees of freedom is."""
    dampers = list(problem.spec.get("dampers") or {})
    if len(problem.scene.q) != LETTERS or len(dampers) != 1 or curve.signal.startswith(f"{dampers[0]}."):
        return
    rows = []
    for number, (Omega, value) in enumerate(curve.fixed_points(dampers[0]), 1):
        off, relative = curve.error_of_fixed_point(dampers[0], Omega)
        rows.append((f"fixed point {number}", *_place(Omega, off), figure(value, relative)))
    if rows:
        yield paragraph(f"Fixed points, the same for every value of '{dampers[0]}':")
        yield TableBlock(("", "Ω [rad/s]", "f [Hz]", f"|H| [{unit}]"), tuple(rows))


class ResonancePeak(NamedTuple):
    """Ω, amplitude (None where it has no bound), half-power points and quality (None where one of these is missing)."""

    Omega: float
    value: float | None
    low: float | None
    high: float | None
    quality: float | None


def _peaks(curve: "FrequencyResponse") -> Iterator[ResonancePeak]:
    """The resonances of a frequency response, by ascending Ω."""
    curve.find_half_powers()
    for number, (Omega, value) in enumerate(curve.peaks, 1):
        try:
            low, high = curve.half_power_of(number)
        except PhysicsError:
            low = high = None
        yield ResonancePeak(Omega, value if isfinite(value) else None, low, high,
                            None if low is None else Omega / (high - low))


def _static(curve: "FrequencyResponse", unit: str) -> "Paragraph":
    try:
        found, error = curve.at(0.0)
        return paragraph(f"at rest (Ω → 0): {supported(found.real, error * abs(found))}{f' {unit}' * (unit != '1')}")
    except PhysicsError:
        return paragraph("at rest (Ω → 0) it has no bound: the scene moves off freely")


FREQUENCY_RESPONSE = Key(
    "frequency_response", "of `vibcli frf`, and where `find` asks: a list, one entry to each signal; null where "
    "symbols have no value", each=(
        Key("signal", "the signal as written"),
        Key("input", "the name of the input"),
        Key("unit", "unit of the signal over that of the input"),
        Key("peaks", "a list of its resonances, by ascending Omega", each=(
            Key("Omega", "where it is"),
            Key("value", "amplitude there; null where it has no bound"),
            Key("quality", "Omega over the distance of the half-power points; null where one is missing"))),
        Key("antiresonances", "the Omega of zeros, or of minima where it is damped"),
        Key("peaks_counted", "false where poles are not counted, so that peaks may be missing"),
        Key("antiresonances_counted", "false where zeros are not counted, so that antiresonances may be missing")))


def frequency_response_data(problem: "Problem",
                            wanted: "Wanted") -> list[dict[str, list[dict[Any, Any] | float] | str]]:
    """The frequency responses asked for, as data."""
    found = [(asked, problem.frequency_response(*asked[:2])) for asked in curves_asked(problem, wanted)]
    return [data(FREQUENCY_RESPONSE.each, FREQUENCY_RESPONSE.row(
        *asked, list(_peaks(curve)), curve.antiresonances, *map(curve.transfer.counts, ("poles", "zeros"))))
        for asked, curve in found]
