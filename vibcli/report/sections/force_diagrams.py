"""Diagrams of the forces and moments within members: which are found, and the scene above them."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import NoBound, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Section, section
from vibcli.report.sections.illustrations import drawing

if TYPE_CHECKING:
    from vibcli.mechanics.internal_forces import InternalForce
    from vibcli.plots.figure import Figure
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


class WhichForces(NamedTuple):
    """Those of a mode, at an instant of the motion in time in seconds, amplitudes of its steady state, or at rest."""

    mode: int | None = None
    at: float | None = None
    amplitudes: bool = False


def force_diagrams(problem: "Problem", _: "Report") -> Iterator[Section]:
    """Forces and moments within members at rest, where they are found and not all zero."""
    if problem.numeric.has_free_symbols or not problem.scene.members:
        return
    from vibcli.drawing.member_diagrams import draw
    from vibcli.mechanics.internal_forces import forces_at_rest

    try:
        drawn = draw(problem.scene, forces_at_rest(problem.configuration), ())
    except PhysicsError:
        return
    yield from section("Forces and moments within members in equilibrium",
                       drawing("forces", "Diagrams along each member", drawn))


def found_forces(problem: "Problem", which: WhichForces) -> "tuple[list[InternalForce], list[str]]":
    """(forces and moments within members, what is said of them: which they are, and why others are not found)."""
    from vibcli.results import internal_forces

    internal_forces.require_numbers(problem)
    if which.mode is not None:
        from vibcli.analyses.modal.normalisation import words
        from vibcli.drawing.vibration import caption, mode

        told = caption(mode(problem, which.mode))
        return internal_forces.forces_of_mode(problem, which.mode), [told, words("first", problem.spec.members)]
    if which.at is None and not which.amplitudes:
        from vibcli.mechanics.internal_forces import forces_at_rest

        return forces_at_rest(problem.configuration), ["in equilibrium"]
    if which.at is not None:
        (forces, refused), told = internal_forces.forces_in_time(problem, which.at), f"at t = {which.at:.6g} s"
    else:
        (forces, refused), told = internal_forces.amplitudes(problem), "amplitudes of the steady state"
    return forces, [told, *refused]


def force_drawing(problem: "Problem", which: WhichForces) -> list[object]:
    """The primitives of the diagrams, below the scene as it then is."""
    from vibcli.drawing.member_diagrams import draw

    forces, told = found_forces(problem, which)
    if which.mode is not None:
        from vibcli.drawing.symbols.mode_shape import draw as draw_mode

        return draw(problem.scene, forces, draw_mode(problem, which.mode)[:-1], told)
    if which.at is not None:
        from vibcli.drawing.animation import at_instant

        try:
            return draw(problem.scene, forces, at_instant(problem, which.at), told)
        except NoBound as refusal:
            told = [*told, f"the scene is drawn at rest: {refusal.message}"]
    from vibcli.drawing.drawing import draw as draw_scene

    return draw(problem.scene, forces, draw_scene(problem), told, which.amplitudes)


def force_figure(problem: "Problem", which: WhichForces) -> "Figure":
    """The same as curves over the places along each member, for the terminal."""
    from vibcli.drawing.member_diagrams import NAMES
    from vibcli.plots.figure import Curve, Figure, Panel
    from vibcli.plots.prefixes import labelled, readable

    forces, told = found_forces(problem, which)
    panels = []
    for force in forces:
        if force.largest:
            factor, unit = readable(force.largest, force.unit)
            points = [stretch.points() for stretch in force.stretches]
            x = [float(place) for places, _ in points for place in places]
            y = [float(value) * factor for _, values in points for value in values]
            name = NAMES[problem.scene.members[force.member].kind.name, force.part]
            panels.append(Panel(f"x along {force.member} [m]", labelled(name, unit), tall=0.6,
                                curves=(Curve(f"of {force.member}", tuple(x), tuple(y)),)))
    return Figure("; ".join(told), tuple(panels))
