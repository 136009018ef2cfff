"""Responses sampled for pictures and files."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.report.sections.requested_signals import curves_asked, signals_asked, symbol

if TYPE_CHECKING:
    import numpy as np

    from vibcli.plots.figure import Figure
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem


BEND, PASSES = 0.07, 4      # radians from one piece of a curve to the next; how often it is divided


class SampledSignal(NamedTuple):
    """A signal at all instants: `parts` {steady, transient: values} where they were asked for; `bounds`: (upper, lower)
    of a free vibration that dies out, or None."""

    name: str
    unit: str
    times: Any
    values: Any
    parts: dict[Any, Any]
    bounds: tuple[Any, ...] | None = None


class SampledCurve(NamedTuple):
    """A frequency response over Ω: complex values, and the Ω of its peaks and antiresonances."""

    name: str
    driver: str
    unit: str
    Omega: Any
    values: Any
    peaks: list[Any]
    antiresonances: list[Any]


def sampled(problem: "Problem", wanted: "Wanted") -> list[SampledSignal]:
    """The Series of the signals asked for, NaN where no digit of them is known."""
    from vibcli.results.known_digits import known_alone

    asked = signals_asked(problem, wanted.signals)
    times = problem.response.instants([one.signal for one in asked], wanted.points)
    found = []
    for one in asked:
        parts = {part: getattr(one.signal, part).values(times) for part in wanted.parts}
        values = known_alone(one.signal, times, one.signal.sampled(times))
        found.append(SampledSignal(one.text, one.unit, times, values, parts, _bounds(problem, one.signal, times)))
    return found


def _bounds(problem: "Problem", signal: Any, times: "np.ndarray") -> Any:
    """(upper, lower) envelope of beats, and of a free vibration that dies out; None of others."""
    if not hasattr(signal, "output"):
        return None
    from vibcli.results.signal_features import beat_period, vibration

    try:
        if problem.response.drive or not vibration(signal).rate < 0:
            beat_period(signal)
        size, middle = signal.envelope.values(times), signal.output.constant
    except PhysicsError:
        return None
    return middle + size, middle - size


def response_figure(problem: "Problem", series: Sequence[SampledSignal]) -> "Figure":
    """The motion in time as a Figure."""
    from vibcli.plots.response import of_response

    lines, steady, bounds = [], [], []
    for one in series:
        lines.append((symbol(one.name), one.unit, one.values))
        steady.append(one.parts.get("steady"))
        bounds.append(one.bounds)
        if "transient" in one.parts:
            lines.append((f"{symbol(one.name)}, transient", one.unit, one.parts["transient"]))
            steady.append(None)
            bounds.append(None)
    return of_response(series[0].times, lines, steady, bounds, problem.response.title,
                       problem.response.until)


def columns(problem: "Problem", series: Sequence[SampledSignal]) -> "list[tuple[str, str, np.ndarray]]":
    """[(name, unit, array)] of a motion in time; of one that is not known to its end a last row, without values, has
    that end."""
    import numpy as np

    found = [("t", "s", series[0].times)]
    for one in series:
        found.append((one.name, one.unit, one.values))
        found += [(f"{part} {one.name}", one.unit, values) for part, values in one.parts.items()]
    motion = problem.response
    if motion.known >= motion.until:
        return found
    ends = [motion.until] + [np.nan] * (len(found) - 1)
    return [(name, unit, np.append(values, end)) for (name, unit, values), end in zip(found, ends, strict=True)]


def sampled_curves(problem: "Problem", wanted: "Wanted") -> list[SampledCurve]:
    """The SampledCurves asked for, over one range."""
    asked = [(name, driver, unit, problem.frequency_response(name, driver))
             for name, driver, unit in curves_asked(problem, wanted)]
    low = wanted.low or _asked_end(problem, "from") or min(curve.span[0] for *_, curve in asked)
    high = wanted.high or _asked_end(problem, "up_to") or max(curve.span[1] for *_, curve in asked)
    if not low < high:
        raise PhysicsError(f"the range from {low:.6g} to {high:.6g} rad/s is empty", "give other ends")
    import numpy as np

    known = [curve.curve(low, high) for *_, curve in asked]
    Omega = np.array(sorted({at for own, _ in known for at in own.tolist()}))
    return [SampledCurve(name, driver, unit, Omega, curve.completed(own, Omega),
                         [Omega for Omega, _ in curve.peaks if low < Omega < high],
                         [Omega for Omega in curve.antiresonances if low < Omega < high])
            for (name, driver, unit, curve), own in zip(asked, known, strict=True)]


def _asked_end(problem: "Problem", key: str) -> Any:
    from vibcli.quantities.expression import number_of
    from vibcli.reader.sections.find import FREQUENCY_RESPONSE

    find = problem.spec.get("find")
    record = find.about(FREQUENCY_RESPONSE) if find is not None else None
    return number_of(problem, record[key].tree) if record is not None and key in record else None


def frequency_figure(problem: "Problem", curves: Sequence[SampledCurve], nyquist: bool = False) -> "Figure":
    """The frequency responses as a Figure: magnitude and phase, or in the complex plane."""
    from vibcli.plots import frequency

    Omega, found = curves[0].Omega, [curve.values for curve in curves]
    if nyquist:
        Omega, found = _smooth(Omega, [problem.frequency_response(curve.name, curve.driver) for curve in curves], found)
    Omega = Omega.tolist()      # floats of Python: an array's own are slow
    values = dict(zip(_labels(curves), (points.tolist() for points in found), strict=True))
    if len(curves) == 1:
        peaks, dips = curves[0].peaks, curves[0].antiresonances
    else:
        natural = problem.frequency_response(curves[0].name, curves[0].driver).natural
        peaks, dips = [place for place in natural if Omega[0] < place < Omega[-1]], []
    title = problem.spec.get("title") or ""
    if nyquist:
        return frequency.nyquist(Omega, values, _unit(curves), at=peaks, title=title)
    driver = symbol(curves[0].driver)
    if curves[0].driver in problem.spec.coordinates:        # the force along it
        driver = f"Q_{driver}"
    kind = f"|H| to {driver}" if len(curves) > 1 else f"|{_factor(next(iter(values)))}/{_factor(driver)}|"
    return frequency.of_frequency_response(Omega, values, kind, _unit(curves), peaks, dips, title=title)


def _smooth(Omega: Any, responses: Any, found: Any) -> tuple[Any, Any]:
    """Frequencies and values at which curves in the complex plane turn by little from one to the next."""
    import numpy as np

    for _ in range(PASSES):
        bends = np.zeros(len(Omega))
        for H in found:
            steps = np.diff(H)
            with np.errstate(invalid="ignore", divide="ignore"):
                bends[1:-1] = np.fmax(bends[1:-1], np.abs(np.angle(steps[1:] / steps[:-1])))
        wide = np.flatnonzero((bends[1:] > BEND) | (bends[:-1] > BEND))
        if not wide.size:
            break
        between = (Omega[wide] + Omega[wide + 1]) / 2
        Omega = np.insert(Omega, wide + 1, between)
        found = [np.insert(H, wide + 1, response.values(between)) for H, response in zip(found, responses, strict=True)]
    return Omega, found


def _factor(name: str) -> str:
    """A name as it stands in a quotient: in brackets where it is more than one name."""
    return f"({name})" if any(sign in name for sign in " ·/") else name


def _labels(curves: Sequence[SampledCurve]) -> list[str]:
    """What each curve is called: with its unit where not all have the same."""
    alike = len({curve.unit for curve in curves}) == 1
    return [symbol(curve.name) + ("" if alike or curve.unit == "1" else f" [{curve.unit}]") for curve in curves]


def _unit(curves: Sequence[SampledCurve]) -> str:
    """The unit that all curves have; none of a ratio of like quantities."""
    units = {curve.unit for curve in curves}
    return units.pop() if len(units) == 1 and units != {"1"} else ""


def frequency_columns(curves: Sequence[SampledCurve]) -> "list[tuple[str, str, np.ndarray]]":
    """[(name, unit, array)] of frequency responses."""
    return [("Omega", "rad/s", curves[0].Omega), *((curve.name, curve.unit, curve.values) for curve in curves)]


def eigenvalue_figure(problem: "Problem", wanted: "Wanted | None" = None) -> "Figure":
    """The eigenvalues in the complex plane, those of the undamped system where nothing damps."""
    from vibcli.plots.eigenvalues import argand
    from vibcli.report.sections.shown_modes import shown, shown_damped

    if problem.numeric.has_free_symbols:
        from vibcli.language.parameters import require_values

        require_values(problem.scene.parameters, "a plot of the eigenvalues")
    found = []
    values = [(mode.index, complex(mode.eigenvalue)) for mode in shown_damped(problem, wanted) or ()] or [
        (mode.index, complex(float(mode.growth_rate or 0.0), float(mode.omega or 0.0)))
        for mode in shown(problem, wanted)]
    for index, value in values:
        found.append((value, str(index)))
        if value.imag:
            found.append((value.conjugate(), ""))
    return argand([value for value, _ in found], [label for _, label in found], title=problem.spec.get("title") or "")
