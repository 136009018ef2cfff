"""A motion that is integrated: the balance of its energies, its events, how well it is known, and its period."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure, supported
from vibcli.report.blocks import Section, TableBlock, paragraph, section
from vibcli.report.sections.expanded_motion import periods

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.results.problem import Problem

MOST_EVENTS = 40
LEAST = 2.0**-52


def integration(problem: "Problem", motion: Any) -> Iterator[Section]:
    """What happened on the way, how well the energies balance, and the period of what has one."""
    yield from _followed(motion.trajectory())
    if problem.spec.expanded:
        yield from periods(problem, motion)
    else:
        from vibcli.report.sections.free_motion import swinging

        yield from swinging(problem, motion)


def _followed(trajectory: "Trajectory") -> Iterator[Section]:
    balance = trajectory.balance
    largest = max(abs(float(x)) for x in (*balance.energy, *balance.work, *balance.dissipated, *balance.driving))
    off = float(balance.error) * largest
    start = float(balance.energy[0])
    rows = [("T + V at the start", figure(start if abs(start) > LEAST * largest else 0.0)),
            ("at the end", supported(float(balance.energy[-1]), off, beside=largest))]
    for words, values in (("work of the loads", balance.work), ("dissipated", balance.dissipated),
                          ("work of what drives the motion", balance.driving)):
        if values[-1]:
            rows.append((words, supported(float(values[-1]), off, beside=largest)))
    yield from section("Energy", TableBlock(("", "[J]"), tuple(rows)), paragraph(_accuracy(trajectory)))
    events = [(figure(event.time), event.kind, event.name) for event in trajectory.events[:MOST_EVENTS]]
    more = len(trajectory.events) - len(events)
    yield from section("Events", TableBlock(("t [s]", "what", "where"), tuple(events)) if events else None,
                       paragraph(f"and {more} more") if more else None)


def _accuracy(trajectory: "Trajectory") -> str:
    """How well a motion is known: what it says of itself."""
    if trajectory.rests and trajectory.rests == trajectory.end:
        return "it starts at rest where its forces balance, and nothing acts on it in time: there it stays"
    told = f"it rests up to t = {figure(trajectory.rests)} s; " if trajectory.rests else ""
    error = figure(float(trajectory.balance.error), digits=2)
    told += f"the balance of these energies holds to {error} of the largest of them"
    shared = max(trajectory.shared.of_state(trajectory.end), LEAST)
    told += ("; nothing moves by more than rounding may" if trajectory.shared.still else
             f"; a second solution agrees to {figure(shared, digits=2)} of the motion")
    if trajectory.end < trajectory.until:
        told += f" up to t = {figure(trajectory.end, digits=4)} s, from where on it is not known: {trajectory.reason}"
    if trajectory.fast is not None:
        told += (f"; from t = {figure(trajectory.fast.since, digits=3)} s on an oscillation of "
                 f"{figure(trajectory.fast.speed)} rad/s, {figure(trajectory.fast.part, digits=2)} of the motion, is "
                 "stepped over: velocities and forces that it moves are known the less")
    if trajectory.drift is not None:
        told += f"; the loops stay closed to {figure(float(max(trajectory.drift)), digits=2)} of their motion"
    return told
