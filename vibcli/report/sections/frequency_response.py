"""Frequency responses: amplitude at rest, resonances and antiresonances; amplitudes in letters of few degrees."""

from math import isfinite, tau

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report import blocks
from vibcli.report.blocks import TableBlock, line, paragraph, section
from vibcli.report.sections.requested_signals import curves_asked, symbol

LETTERS = 2     # most degrees of freedom whose amplitudes are written in letters


def frequency_response(problem, report):
    """A section for each frequency response that is asked for."""
    for name, driver, unit in curves_asked(problem, report.wanted):
        title = f"Frequency response H of {symbol(name)} to {driver} [{unit}], lag θ = −arg H"
        blocks_of = list(_in_letters(problem, name, driver))
        if not problem.numeric.has_free_symbols:
            blocks_of += _in_numbers(problem, name, driver, unit)
        yield from section(title, *blocks_of)
    if report.pictures and not problem.numeric.has_free_symbols:
        from vibcli.report.sections.illustrations import plot
        from vibcli.report.sections.sampled_series import frequency_figure, sampled_curves

        curves = sampled_curves(problem, report.wanted)
        yield from section("As a plot", plot("frequency-response", "Amplitude and phase lag over the frequency",
                                             frequency_figure(problem, curves)))


def _in_letters(problem, name, driver):
    """The amplitude and tan θ, resonances and antiresonances; nothing where they are too long or not known."""
    if len(problem.scene.q) > LETTERS:
        if problem.numeric.has_free_symbols:
            raise NotInLetters(f"frequency responses of more than {LETTERS} degrees of freedom are found in numbers",
                               "give the parameters values with --set")
        return
    from vibcli.analyses.closed_form.frequency_response import formula
    from vibcli.report.sections.symbolic_modes import turned
    from vibcli.report.sections.symbolic_response import conditions

    try:
        found = formula(problem.symbolic, name, driver)
    except (NotInLetters, PhysicsError):
        if problem.numeric.has_free_symbols:
            raise
        return
    if found.vanishes:
        lines = [line("H = 0")]
    elif found.undamped:
        lines = [line("H = ", found.amplitude)]
    elif found.ahead:
        lines = [line("H = ", *turned(found.amplitude))]
    else:
        lag = line("θ = ±π/2") if found.tangent is None else line("tan θ = ", found.tangent)
        lines = [line("|H| = ", found.amplitude), lag]
    yield blocks.equations(lines)
    yield from conditions(found)


def _in_numbers(problem, name, driver, unit):
    curve, rows = problem.frequency_response(name, driver), []
    for number, (Omega, value) in enumerate(curve.peaks, 1):
        rows.append((f"peak {number}", figure(Omega), figure(Omega / tau), figure(value) if isfinite(value) else "∞",
                     *_bandwidth(curve, number)))
    for number, Omega in enumerate(curve.antiresonances, 1):
        rows.append((f"antiresonance {number}", figure(Omega), figure(Omega / tau),
                     "0" if curve.transfer.undamped else figure(abs(curve.at(Omega)[0])), "", "", ""))
    head = ("", "Ω [rad/s]", "f [Hz]", f"|H| [{unit}]", "Ω₁ [rad/s]", "Ω₂ [rad/s]", "Q")
    yield _static(curve, unit)
    yield TableBlock(head, tuple(rows)) if rows else paragraph("no resonance")
    yield from _fixed_points(problem, curve, unit)
    if any(isfinite(value) for _, value in curve.peaks):
        yield paragraph("Ω₁ and Ω₂: half-power points, |H| = peak/√2; Q = Ω/(Ω₂ − Ω₁)")


def _fixed_points(problem, curve, unit):
    """Through which all curves pass, whatever the one damper of two degrees of freedom is."""
    dampers = list(problem.spec.get("dampers") or {})
    if len(problem.scene.q) != LETTERS or len(dampers) != 1 or curve.signal.startswith(f"{dampers[0]}."):
        return
    rows = [(f"fixed point {number}", figure(Omega), figure(Omega / tau), figure(value))
            for number, (Omega, value) in enumerate(curve.fixed_points(dampers[0]), 1)]
    if rows:
        yield paragraph(f"Fixed points, the same for every value of '{dampers[0]}':")
        yield TableBlock(("", "Ω [rad/s]", "f [Hz]", f"|H| [{unit}]"), tuple(rows))


def _bandwidth(curve, number):
    """The half-power points of a peak and its quality, dashes where it has none."""
    try:
        return (*(figure(Omega) for Omega in curve.half_power_of(number)), figure(curve.quality(number)))
    except PhysicsError:
        return ("–", "–", "–")


def _static(curve, unit):
    try:
        return paragraph(f"at rest (Ω → 0): {figure(curve.at(0.0)[0].real)}{f' {unit}' * (unit != '1')}")
    except PhysicsError:
        return paragraph("at rest (Ω → 0) it has no bound: the scene moves off freely")
