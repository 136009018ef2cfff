"""The motion of one degree of freedom from its start under one harmonic: what is kept up and a free motion,

    x = X sin(Ωt + ε − θ) + e^{−δt} (A cos ω_dt + B sin ω_dt),   A and B from x(0) and ẋ(0).
"""

from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.closed_form.free_response import UNDAMPED, UNDER, regime_at
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.free_waves import FreeWave, ToldMotion
from vibcli.report.steps.step import number
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

IN_TIME = {"value", "max", "min", "argmax", "argmin", "zero", "beat_period"}        # quantities of a motion in time


class KeptUp(NamedTuple):
    """The Steady state, the letters of its amplitude and of its lag, None where it has none, and the lag in numbers."""

    steady: Any
    X: Any
    theta: Any
    lag: float | None


def tell_start(degree: Degree, wave: KeptUp, lines: list[int]) -> None:
    """The constants of the free part, where a motion in time is asked; under-damped or not damped."""
    from vibcli.mechanics.initial_state import start_in_letters

    problem = degree.problem
    heads = {tree.head for answer in problem.spec.answers for tree in answer.asked.parts.quantities}
    values = [degree.about.value(node) for node in (degree.M, degree.C, degree.K)]
    if not (heads & IN_TIME or "response" in (problem.spec.get("find") or ())) or (
            None not in values and regime_at(*values) not in (UNDAMPED, UNDER)) or (
            None in values and not degree.C.is_zero):
        return
    zero = degree.about.table.zero
    try:
        x0, v0 = start_in_letters(problem.symbolic) or (zero, zero)
    except PhysicsError:
        return
    _write(degree, wave, x0, v0, lines)


def _write(degree: Degree, wave: Any, x0: "Node", v0: "Node", lines: list[int]) -> None:
    table, t, sheet = degree.about.table, degree.problem.scene.time, degree.sheet
    A, B = (degree.about.letter(sheet.letter(letter)) for letter in "AB")
    damped = not degree.C.is_zero
    rate = degree.omega_d if damped else degree.omega
    free = A * table.call("cos", rate * t) + B * table.call("sin", rate * t)
    decay: list[Any] = [table.call("exp", -(degree.delta * t)), "·"] if damped else []
    whole = _kept(wave, t) + (decay[0] * free if damped else free)
    line = sheet.write(Words("with a free motion  "), Name(degree.name), " = ", _kept(wave, t), " + ", *decay,
                       Factor(free) if damped else free, settles="motion", uses=lines, node=whole)
    place, speed = _at_start(degree, wave)
    Omega = gradient(wave.steady.argument)[t]
    kept = _as_wave(degree, wave, Omega)
    if kept is not None:
        free = FreeWave(table.zero if (x0 - place).is_zero else A, B, rate, degree.delta if damped else table.zero)
        sheet.waves[degree.name] = ToldMotion([kept, free], line)
    ahead = v0 - speed + (degree.delta * A if damped else table.zero)
    values = _values(degree, wave, x0 - place, v0 - speed)
    told: list[Any] = []
    for letter, form, value, unit in zip((A, B), (x0 - place, ahead / rate), values, (degree.unit,) * 2, strict=True):
        shown = [] if is_number(form) and value is not None else [" = ", form]
        told += [Words(",  " * bool(told)), letter, *shown, *(() if value is None else number(value, unit))]
    sheet.write(Words("at t = 0  "), Name(degree.name), " = ", x0, Words(",  "), Name(degree.name + "'"), " = ", v0,
                Words(":  "), *told, settles="motion from the start", uses=[line])
    for letter, form, value in zip((A, B), (x0 - place, ahead / rate), values, strict=True):
        sheet.write(settles=letter.name, node=form, value=value, joined=True, letter=letter.name,
                    unit="" if value is None else degree.unit)


def _kept(wave: KeptUp, t: "Node") -> "Node":
    argument = wave.steady.argument if wave.theta is None else wave.steady.argument - wave.theta
    node = wave.X * wave.X.table.call(wave.steady.wave, argument)
    return cast("Node", node if wave.steady.mean is None else wave.steady.mean + node)


def _as_wave(degree: Degree, wave: KeptUp, Omega: "Node") -> FreeWave | None:
    """What is kept up as a wave of Ωt; None where it has another phase or a mean, or its lag has no number."""
    table, zero, (steady, X, theta, lag) = degree.about.table, degree.about.table.zero, wave
    if steady.mean is not None or not is_zero(steady.argument - Omega * degree.problem.scene.time) or (
            theta is not None and lag is None):
        return None
    along, across = (X, zero) if theta is None else (X * table.call("cos", theta), X * table.call("sin", theta))
    return FreeWave(*((along, across) if steady.wave == "cos" else (-across, along)), Omega, zero)


def _at_start(degree: Degree, wave: KeptUp) -> "tuple[Node, Node]":
    """The place and the speed of what is kept up at t = 0."""
    table, time, Omega = degree.about.table, degree.problem.scene.time, wave.steady.formula.Omega
    at, = substitute([wave.steady.argument], {time: table.zero})
    at = at if wave.theta is None else at - wave.theta
    sine, cosine = table.call("sin", at), table.call("cos", at)
    place, speed = (sine, cosine) if wave.steady.wave == "sin" else (cosine, -sine)
    mean = table.zero if wave.steady.mean is None else wave.steady.mean
    return mean + wave.X * place, wave.X * Omega * speed


def _values(degree: Degree, wave: KeptUp, A: "Node", speed: "Node") -> tuple[float | None, float | None]:
    """A and B in numbers; None in letters."""
    known = {line.settles: line.value for line in degree.sheet.steps}
    if degree.about.value(degree.K) is None:
        return None, None
    letters = {**degree.about.numbers(), wave.X.name: known[f"amplitude({degree.name})"]}
    if wave.theta is not None:
        letters[wave.theta.name] = wave.lag
    delta, rate = known.get(degree.delta.name) or 0.0, known.get("omega_d[1]") or known["omega[1]"]
    of_A, of_speed = evaluate([A, speed], Floats, letters)
    return of_A, (of_speed + delta * of_A) / rate
