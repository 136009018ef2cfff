"""The first lines: what the coordinates are, where they rest, what constraints leave of the others."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene


def tell_coordinates(problem: "Problem", scene: "Scene", sheet: WorkedSolution) -> None:
    """What each coordinate of a scene of the problem is, and its value as drawn."""
    from vibcli.report.sections.parameters import words_of

    for name in scene.coordinates:
        at = scene.drawn[scene.symbol(name)]
        told = [word for word in (words_of(problem, name), "zero as drawn" * at.is_zero) if word]
        drawn = [] if at.is_zero else [Words(",  as drawn " if told else "as drawn "), Name(name), " = ", at]
        sheet.write(Name(name), Words(":  " + ",  ".join(told)), *drawn, settles=name)


def tell_constraints(scene: "Scene", sheet: WorkedSolution) -> None:
    """What constraints that close no loop leave of the other coordinates."""
    for name, node in scene.dependent.items():
        if scene.loops is None or name not in scene.loops.names:
            sheet.write(Name(name), " = ", textbook(node), Words("   (by the constraints)"), settles=name, node=node)


def tell_conditions(problem: "Problem", sheet: WorkedSolution) -> list[int]:
    """The conditions of closed loops; the numbers of their lines."""
    if problem.scene.loops is None:
        return []
    loose = problem.system.scene_with_multipliers
    return [sheet.write(Words(f"'{constraint.whole}' holds:  "), textbook(constraint.node), " = 0",
                        settles=f"condition {constraint.name}") for constraint in loose.constraints]


def tell_loops(about: AboutRest, sheet: WorkedSolution, conditions: Iterable[int]) -> None:
    """What closed loops leave of their coordinates, to the second order from rest, and their rates."""
    scene = about.scene
    for name in scene.loops.names if scene.loops is not None else ():
        small = about.small(scene.dependent[name])
        rate, moves = about.first(small, scene.v), about.first(small, scene.q)
        sheet.write(Words("so from rest  "), Name(name), " = ", moves + about.bent(small), " + …",
                    Words("   (second order),  "), Name(name + "'"), " = ", rate, settles=name, uses=list(conditions),
                    node=moves)
