"""How constraints tie coordinates, the virtual work of what acts, and the reactions."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.abbreviations import abbreviated
from vibcli.notation.numbers import figure
from vibcli.report import blocks
from vibcli.report.blocks import Section, TableBlock, Words, line, section
from vibcli.report.keys import Key
from vibcli.report.sections.equations_of_motion import with_lengths
from vibcli.report.sections.too_long import brief

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

WRITTEN_OUT = 16        # coordinates whose generalised forces are printed


def virtual_work(problem: "Problem", report: "Report") -> Iterator[Section]:
    """δA = Σ Q δq, where there are loads or it is asked for."""
    scene = problem.system.scene_with_multipliers
    if not (scene.forces or "virtual_work" in problem.spec.get("find", ())) or not 0 < len(scene.q) <= WRITTEN_OUT:
        return
    from vibcli.mechanics.virtual_work import generalised_forces
    from vibcli.notation.plain import plain

    names = [plain.symbol(name) for name in scene.coordinates]
    shown, lengths = abbreviated(generalised_forces(scene), report.roots)
    lines = [line("δA = " + " + ".join(f"Q_{name}·δ{name}" for name in names), hang=2)]
    balanced = _balanced(problem)
    for name, node in zip(names, shown, strict=True):
        vanishes = balanced and not (scene.constraints or node.is_zero or problem.system.sticking is not None)
        lines.append(line(f"Q_{name} = ", brief(node), " = 0" if vanishes else ""))
    driven = ", and of the inertia of driven motion" if scene.timed and scene.inertias else ""
    where = "at rest in equilibrium" if balanced else "at rest"
    yield from section(f"Virtual work of weights, springs and steady loads{driven}, {where}",
                       blocks.equations(lines), *with_lengths(lengths))


def _balanced(problem):
    """Is there an equilibrium, as far as is known?"""
    try:
        if problem.numeric.has_free_symbols:
            problem.symbolic.equilibrium_position  # noqa: B018
        else:
            problem.configuration.equilibrium  # noqa: B018
    except NotInLetters:
        return True
    except PhysicsError:
        return False
    return True


def _unit(problem, signal):
    """N, or N·m of a moment."""
    from vibcli.base.units import FORCE
    from vibcli.language.signals import signal_dimension

    return "N" if signal_dimension(problem.spec, signal) in (None, FORCE) else "N·m"


def reactions(problem: "Problem", _: "Report") -> Iterator[Section]:
    """The reactions in equilibrium, of a scene in numbers, and those along a motion."""
    from vibcli.mechanics.inputs_outputs.reactions import along_the_motion

    if not problem.numeric.has_free_symbols:
        rows = [(reaction.signal, "not fixed by statics" if reaction.value is None else
                 f"{figure(reaction.value)} {_unit(problem, reaction.signal)}")
                for reaction in problem.configuration.reactions if reaction.value != 0.0]
        yield from section("Reactions in equilibrium (tension positive; what supports and drives exert on the body, "
                           "fixed axes)" if any(".drive" in signal for signal, _ in rows) else
                           "Reactions in equilibrium (tension positive; what supports exert on the body, fixed axes)",
                           TableBlock(("force", "value"), tuple(rows)))
    yield from section("Reactions along a motion", blocks.equations(
        line(Words(signal), " = ", brief(node)) for signal, node in along_the_motion(problem.numeric).items()))


REACTIONS = Key("reactions", "{signal: force or moment in equilibrium}, with `find: [reactions]`; null where statics "
                "leaves it open", lambda problem: {
                    reaction.signal: reaction.value for reaction in problem.configuration.reactions})
