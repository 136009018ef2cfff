"""Derivatives of frequencies and damping by the parameters."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Section, Words, maths, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.insight import grid, numbered, require_numbers, without_end

if TYPE_CHECKING:
    from vibcli.report.blocks import Maths
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def sensitivities(problem: "Problem", _: "Report") -> Iterator[Section]:
    require_numbers(problem, "sensitivities")
    if not problem.modal.modes.finite:
        yield from without_end("Sensitivities", "sensitivities")
        return
    found = problem.modal.result("sensitivities")
    heads = [(f"mode {mode.index}", mode) for mode in problem.modal.modes.shown() if mode.omega]
    damped = {one.mode.index: one for one in found.damped or ()}
    tables = [
        *grid("Sensitivity of the natural frequencies: (p/ω)·∂ω/∂p", [
            (head, {maths(Name(name)): logarithmic(found.values[name], rates[mode.index], float(mode.omega))
                    for name, rates in found.omega.items()}) for head, mode in heads], _rate),
        *grid("∂ω/∂p [rad/s per unit of p]", [
            (head, {_with_unit(problem, name): rates[mode.index] for name, rates in found.omega.items()})
            for head, mode in heads], _rate),
        *grid("Sensitivity of the damping ratios: ∂ζ/∂p [per unit of p]", [
            (f"mode {index}", {_with_unit(problem, name): rate for name, rate in one.zeta.items()})
            for index, one in damped.items() if one.zeta is not None], _rate)]
    remarks = [paragraph(remark) for remark in _remarks(found)]
    if not tables:
        tables = section("Sensitivities", *remarks)
    elif remarks:
        tables[-1] = tables[-1]._replace(blocks=(*tables[-1].blocks, *remarks))
    yield from tables


def logarithmic(value: float, rate: float, omega: float) -> float:
    """(p/ω) ∂ω/∂p; None where there is no derivative."""
    return None if rate is None else value * rate / omega


def _with_unit(problem: "Problem", name: str) -> "Maths":
    unit = units.text(problem.spec.dimensions.of(name))
    return maths(Name(name), *[Words(f" [{unit}]")] * bool(unit))


def _rate(value: float | None) -> str:
    return "–" if value is None else figure(value, digits=5)


def _remarks(found: Any) -> Iterator[str]:
    """What has to be said of a table of sensitivities."""
    if not found.values:
        yield "There are no sensitivities: no number of this scene has a name under `parameters`."
    for group in found.coinciding:
        yield (f"Modes {numbered(group)} have one frequency, which splits as a parameter changes: their derivatives "
               "are in ascending order, as it grows.")
    for why in found.refused.values():
        yield why[0].upper() + why[1:] + "."
    several = dict.fromkeys(one.mode.index for one in found.damped or () if one.eigenvalue is None)
    if several:
        yield f"The eigenvalues of damped mode {numbered(several)} are not simple: they have no derivative."
    if found.remark:
        yield found.remark[0].upper() + found.remark[1:] + "."


def _sensitivities(problem: "Problem") -> Any:
    if not problem.modal.modes.finite:
        return None
    found = problem.modal.result("sensitivities")
    omega = {mode.index: float(mode.omega) for mode in problem.modal.modes.shown() if mode.omega}
    entries = []
    for name, value in found.values.items():
        modes = [(i, rate, logarithmic(value, rate, omega[i])) for i, rate in found.omega.get(name, {}).items()]
        damped = None if found.damped is None or name in found.refused else [
            (one.mode.index, one.eigenvalue[name], one.zeta and one.zeta[name])
            for one in found.damped if one.eigenvalue]
        entries.append(PARAMETERS.row(name, value, modes, damped, found.refused.get(name)))
    return KEY.row(entries, found.coinciding, found.remark)


PARAMETERS = Key("parameters", "a list, one entry to each parameter", each=(
    Key("parameter", "its name"),
    Key("value", "its value p"),
    Key("modes", "a list, one entry to each mode that oscillates", each=(
        Key("index", "number of the mode", lambda one: one[0]),
        Key("omega", "derivative of omega by p; null of gyroscopic modes that coincide", lambda one: one[1]),
        Key("logarithmic", "that derivative times p/omega", lambda one: one[2]))),
    Key("damped", "a list, one entry to each simple eigenvalue; null where nothing damps", each=(
        Key("index", "number of the damped mode", lambda one: one[0]),
        Key("eigenvalue", "[re, im] of the derivative of the eigenvalue by p",
            lambda one: [one[1].real, one[1].imag]),
        Key("zeta", "derivative of zeta by p; null where there is no zeta", lambda one: one[2]))),
    Key("refusal", "why there is no derivative by p, or null")))
KEY = Key("sensitivities", "exact derivatives by the parameters that no others define, the shift of the equilibrium "
          "included", _sensitivities, of=(
    PARAMETERS,
    Key("coinciding", "lists of the modes whose frequencies coincide: their derivatives are those of the frequencies "
        "in ascending order as p grows"),
    Key("refusal", "why there are none of the damped modes, or null")))
