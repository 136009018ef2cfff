"""Motions in time and frequency responses as data for --json, in SI units."""

from math import inf, isfinite

from vibcli.base.errors import PhysicsError
from vibcli.report.sections.requested_signals import curves_asked, extremes, if_fixed, signals_asked
from vibcli.report.sections.response import known_until, latest_asked, value_at
from vibcli.report.sections.steady_state import harmonics_of, phase_in


def response_data(problem, wanted):
    """{"until", "initial", "signals", "balance", "unknown"} of a motion in time, as far as it is known."""
    motion, asked = problem.response, signals_asked(problem, wanted.signals)
    places, speeds = motion.start
    known = known_until(motion, wanted) if motion.KIND == "full" else inf
    instants = {one.text: _values(problem, one, wanted, known) for one in asked}
    if motion.KIND == "prescribed" and wanted.at and not motion.ends:
        return {"until": None, "initial": {}, "signals": [
            {"signal": one.text, "unit": one.unit, "max": None, "argmax": None, "min": None, "argmin": None,
             "steady": None, "at": instants[one.text]} for one in asked], "balance": None, "unknown": None}
    end = min(known, motion.until)
    found = {"until": end, "initial": {**places, **{name + "'": v for name, v in speeds.items()}},
             "signals": []}
    for one, (late, most), (early, least) in extremes(asked, end):
        found["signals"].append({"signal": one.text, "unit": one.unit, "max": most, "argmax": late, "min": least,
                                 "argmin": early, "steady": _steady(motion, one.signal, wanted.phase),
                                 "at": instants[one.text]})
    missing = unknown(problem, wanted)
    return found | {"balance": float(motion.trajectory().balance.error) if motion.KIND == "full" else None,
                    "unknown": missing and missing.message}


def unknown(problem, wanted):
    """The refusal of the part of a motion that is asked for and not known, else None."""
    motion = problem.response
    latest = latest_asked(motion, wanted) if motion.KIND == "full" else 0.0
    return motion.trajectory().unknown(latest) if motion.KIND == "full" and known_until(motion, wanted) < latest \
        else None


def _values(problem, one, wanted, known):
    """[{"t", "value"}] at the instants asked for; with --digits as texts; None beyond what is known."""
    def value(t):
        import numpy as np

        if float(t) > known:
            return None
        if wanted.digits is not None:
            return value_at(problem, one, t, wanted.digits)
        return if_fixed(lambda: float(one.signal.values(np.array([float(t)]))[0]))

    return [{"t": float(t), "value": value(t)} for _, t in wanted.at]


def _steady(motion, signal, convention):
    """The harmonics of the steady state; None where there is none."""
    if not motion.drive or not hasattr(signal, "output"):
        return None
    try:
        return [{"Omega": Omega, "amplitude": abs(X), "phase": phase_in(convention, X)}
                for Omega, X in harmonics_of(signal)]
    except PhysicsError:
        return None


def frequency_response_data(problem, wanted):
    """[{"signal", "input", "unit", "peaks", "antiresonances"}] of the frequency responses asked for."""
    return [{"signal": name, "input": driver, "unit": unit,
             **_curve(problem.frequency_response(name, driver))}
            for name, driver, unit in curves_asked(problem, wanted)]


def _curve(curve):
    return {"peaks": [{"Omega": Omega, "value": value if isfinite(value) else None, "quality": _quality(curve, i)}
                      for i, (Omega, value) in enumerate(curve.peaks, 1)], "antiresonances": curve.antiresonances}


def _quality(curve, number):
    try:
        return curve.quality(number)
    except PhysicsError:
        return None
