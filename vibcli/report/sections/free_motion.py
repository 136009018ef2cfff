"""A free motion that small oscillations do not tell, of one degree: the period of a wide swing; under dry friction how
often it turns, and where it comes to rest."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure, supported
from vibcli.report.blocks import Name, Section, maths, paragraph, section
from vibcli.report.sections.equilibrium import measured
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.report.blocks import Maths
    from vibcli.report.document import Report
    from vibcli.results.full_response import FullResponse
    from vibcli.results.problem import Problem

LOOKS = 0.01, 0.1, 1.0, 8.0, 64.0       # seconds, one after the other, until it rests
MOST = 100      # half cycles, beyond which it is not followed
ENDS = ("switches", "sticks")


def free_motion(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Without being asked, where the scene says how the motion starts."""
    if problem.spec.get("initial") is None or problem.numeric.has_free_symbols or problem.scene.pieces:
        return
    if problem.system.sticking is not None or (problem.spec.motion == "full" and problem.spec.in_full):
        from vibcli.results.full_response import FullResponse

        yield from swinging(problem, FullResponse(problem))


def swinging(problem: "Problem", motion: "FullResponse") -> Iterator[Section]:
    """Of one degree of freedom on which no load acts in time; nothing where it has no period and no friction."""
    if len(problem.scene.coordinates) != 1 or problem.scene.timed or problem.spec.expanded:
        return
    try:
        yield from (_period if problem.system.sticking is None else _rest)(problem, motion)
    except PhysicsError:
        return


def _period(problem: "Problem", motion: "FullResponse") -> Iterator[Section]:
    name, = problem.scene.coordinates
    found = motion.by_quadrature(NameRef(0, 0, name, 0))
    if found is None:
        return
    T, error = found
    parts = [maths("T = "), f"{figure(T, error)} s, ", maths("f = "), f"{figure(1 / T, error)} Hz"]
    small = _small_period(problem)
    if small is not None:
        parts.append(f": {figure(T / small, error, digits=5)} times that of small oscillations, {figure(small)} s")
    yield from section("Period of the swing", paragraph(*parts))


def _small_period(problem: "Problem") -> float | None:
    """2π/ω of small oscillations; None where there are none."""
    from math import tau

    try:
        omega = problem.modal.modes[0].omega
    except PhysicsError:
        return None
    return tau / float(omega) if omega else None


def _rest(problem: "Problem", motion: "FullResponse") -> Iterator[Section]:
    """Half cycles end where all stands still for an instant, or for good."""
    for look in LOOKS:
        trajectory = motion.trajectory(look)
        if trajectory.end < look:
            return
        turns = sorted({event.time for event in trajectory.events if event.kind in ENDS})
        rests = trajectory.events[-1].kind == "sticks" if trajectory.events else not trajectory.at([look])[1].any()
        if rests or len(turns) > MOST:
            break
    cycles = f"{len(turns)} half cycle{'s' * (len(turns) != 1)}"
    if rests and turns:
        told = [f"it comes to rest after {cycles}, ", maths("t = "), f"{figure(turns[-1])} s, at ",
                _place(problem, motion, turns[-1])]
    else:
        told = ["it stays where it starts: friction holds it" if rests else
                f"it still moves after {figure(look)} s and {cycles}"]
    yield from section("Motion under dry friction", paragraph(*told))


def _place(problem: "Problem", motion: "FullResponse", t: float) -> "Maths":
    """x = 5 mm, where it is at an instant."""
    name, = problem.scene.coordinates
    signal = motion.signal_of(problem.scene.symbol(name, 0), {})
    value = float(signal.values([t])[0])
    _, unit = measured(value, problem.system.dimension(name))
    return maths(Name(name), " = ", supported(value, signal.error(t)), unit)
