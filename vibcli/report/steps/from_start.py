"""The motion of several degrees of freedom from a given start: free modes, real ones where damping leaves them apart,
else complex ones; under harmonics beside what they keep up,

    q = Σ Im X e^{i(Ωt + ε)} + free modes of what the start has beside that at t = 0."""

from cmath import exp
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.free_waves import FreeWave
from vibcli.report.steps.from_complex_modes import complex_modes_of, tell_complex_modes
from vibcli.report.steps.from_modes import modes_of, tell_modes
from vibcli.report.steps.from_the_start import IN_TIME
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.report.steps.waves_in_numbers import KeptUpPart
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.report.steps.steady_states import SteadyState
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MOST = 3                # coordinates whose motion is a line to read


def tell_from_start(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, uses: "Sequence[int]") -> None:
    """Write down the free motion from the start that the file gives; nothing where it has none or is not such a sum."""
    if about.problem.spec.get("initial") is not None and not found.drive and _is_told(about, found):
        start = start_from_rest(about.problem)
        if start is not None:
            _tell_free(about, sheet, start, uses, {})


def tell_driven_from_start(kept: "Sequence[tuple[SteadyState, Sequence[complex]]]", uses: "Sequence[int]") -> None:
    """Write down the motion under harmonics whose complex amplitudes are known, where one in time is asked."""
    (steady, _), *_ = kept
    about, sheet = steady.about, steady.sheet
    problem, names = about.problem, about.scene.coordinates
    heads = {tree.head for answer in problem.spec.answers for tree in answer.asked.parts.quantities}
    if not (heads & IN_TIME or "response" in (problem.spec.get("find") or ())) or not _is_told(about, steady.found):
        return
    left = start_from_rest(problem)
    if left is None or any(about.value(one.given) is None for one, _ in kept):
        return
    for one, values in kept:
        left = [[x - part for x, part in zip(*both, strict=True)]
                for both in zip(left, _at_start(one, values), strict=True)]
    told: list[Any] = [Words("beside what is kept up the start has  ")]
    for i, name in enumerate(names):
        unit = "m" if problem.system.dimension(name) else "rad"
        told += [Words(",  " * bool(i)), Name(name), *number(left[0][i], unit), Words(",  "), Name(name + "'"), *number(
            left[1][i], f"{unit}/s")]
    line = sheet.write(*told, Words(", of which free modes are made"), settles="rest of the start", uses=uses)
    parts = {name: KeptUpPart([part for one, values in kept if values[k] for part in _kept(one, k)],
                              _waves(kept, k)) for k, name in enumerate(names)}
    _tell_free(about, sheet, left, [*uses, line], {name: part for name, part in parts.items() if part.told})


def _at_start(steady: "SteadyState", values: "Sequence[complex]") -> list[list[float]]:
    """[places, speeds] at t = 0 of what one harmonic keeps up."""
    Omega, time = steady.about.value(steady.given), steady.about.scene.time.name
    ahead, = evaluate([steady.argument], Floats, {**steady.about.problem.numeric.floats, time: 0.0})
    turned = [X * exp(1j * ahead) * (1 if steady.wave == "sin" else 1j) for X in values]
    return [[X.imag for X in turned], [Omega * X.real for X in turned]]


def _is_told(about: AboutRest, found: SmallEquations) -> bool:
    problem = about.problem
    return not (problem.numeric.has_free_symbols or found.G or problem.spec.in_full or not proportional(problem.spec)
                or len(about.scene.q) > MOST)


def start_from_rest(problem: "Problem") -> "list[list[float]] | None":
    """[places, speeds] at t = 0 from rest."""
    try:
        place, speed = problem.initial.start
        rest = problem.configuration.equilibrium.values
    except PhysicsError:
        return None
    names = problem.scene.coordinates
    return [[float(place[name] - rest[name]) for name in names], [float(speed[name]) for name in names]]


def _tell_free(about: AboutRest, sheet: WorkedSolution, start: "Sequence[Sequence[float]]", uses: "Sequence[int]",
               kept: "Mapping[str, KeptUpPart]") -> None:
    modes = modes_of(about.problem, start)
    if modes:
        tell_modes(about, sheet, modes, uses, kept)
        return
    complex_ones = complex_modes_of(about.problem, start)
    if complex_ones:
        tell_complex_modes(about, sheet, complex_ones, uses, kept)


def _kept(steady: "SteadyState", k: int) -> "list[Name | Node | str]":
    """[" + ", part, …] of what is kept up of a coordinate."""
    X = steady.own("X", k)
    if steady.undamped:
        return [" + ", X, f"·{steady.wave}(", steady.argument, ")"]
    return [" + ", "|", X, f"|·{steady.wave}(", steady.argument, " − ", steady.own("theta", k), ")"]


def _waves(kept: "Sequence[tuple[SteadyState, Sequence[complex]]]", k: int) -> list[FreeWave] | None:
    """The same as waves of Ωt by the parts of X = a + ib; None where these have no letters, or t is not counted so."""
    found = []
    for steady, values in kept:
        still, = substitute([steady.argument], {steady.about.scene.time: steady.table.zero})
        if not values[k]:
            continue
        if not (steady.phasors.known and still.is_zero):
            return None
        a, b = steady.phasors.parts_of(k)
        found.append(FreeWave(*((b, a) if steady.wave == "sin" else (a, -b)), steady.Omega, steady.table.zero))
    return found
