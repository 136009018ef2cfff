"""The first lines: what the coordinates are, where they rest, what constraints leave of the others."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.in_motion import short_form
from vibcli.report.steps.lengths import with_lengths
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene

    Ways = dict[tuple[int, float | None], str]

TIED = "by the constraints"      # why coordinates follow from others; of scenes with constraints of one form:
WHY = {"rope": "as ropes keep their length", "gear": "as wheels roll on each other", "belt": "as belts do not slip"}
STRAIGHT: "Ways" = {(0, 1): "to the right", (0, -1): "to the left", (1, 1): "upwards", (1, -1): "downwards"}
TURNS: "Ways" = {(2, 1): "counter-clockwise", (2, -1): "clockwise"}     # by (x, y or angle; its slope)
WAYS = {"displacement": STRAIGHT, "rotation": TURNS, "rolling": {**STRAIGHT, **TURNS}}
SHORT = 8           # letters of what a constraint leaves of a coordinate, up to which several stand in a line


def tell_coordinates(problem: "Problem", scene: "Scene", sheet: WorkedSolution) -> None:
    """What each coordinate of a scene of the problem is, and its value as drawn."""
    from vibcli.report.sections.parameters import words_of

    for name in scene.coordinates:
        at = scene.drawn[scene.symbol(name)]
        what = words_of(problem, name)
        told = [word for word in (what, _sense(scene, name, what), "zero as drawn" * at.is_zero) if word]
        drawn = [] if at.is_zero else [Words(",  as drawn " if told else "as drawn "), Name(name), " = ", at]
        sheet.write(Name(name), Words(":  " + ",  ".join(told)), *drawn, settles=name)
    looped = problem.scene.loops.names if problem.scene.loops is not None else ()
    follows = {name: what for name in looped if name not in scene.coordinates and (what := words_of(problem, name))}
    for i, (name, what) in enumerate(follows.items()):
        sheet.write(Words("and by the closed loop  " * (not i)), Name(name), Words(f":  {what}"), joined=True)


def _sense(scene: "Scene", name: str, what: str) -> str:
    """Which way a body moves or turns where its coordinate grows; '' where that is no such direction."""
    kind, _, owner = what.partition(" of ")
    body, q, zero = scene.bodies.get(owner), scene.symbol(name), scene.table.zero
    if kind not in WAYS or body is None or body.frame is None:
        return ""
    slopes = [textbook(gradient(node).get(q, zero)) for node in (*body.frame.place, body.frame.angle)]
    steady = [float(slope.coefficient) if slope.op == "number" else None for slope in slopes]
    ways = () if kind == "displacement" and None in steady else enumerate(steady)
    return next(filter(None, (WAYS[kind].get(way) for way in ways)), "")


def tell_constraints(problem: "Problem", sheet: WorkedSolution) -> None:
    """What constraints that close no loop leave of the other coordinates; short ones in a line."""
    from vibcli.report.sections.parameters import words_of

    scene = problem.scene
    loops = scene.loops.names if scene.loops is not None else ()
    forms = {constraint.form for constraint in scene.constraints}
    why = WHY.get(forms.pop(), TIED) if len(forms) == 1 else TIED
    known = {name: short_form(node) for name, node in scene.dependent.items() if name not in loops}
    short = {name: node for name, node in known.items() if letters(node) <= SHORT}
    long = {name: node for name, node in known.items() if name not in short}
    shown = dict(zip(long, with_lengths(sheet, list(long.values())), strict=True))
    for group in ([short] if short else []) + [{name: node} for name, node in long.items()]:
        about = {name: f"{what}  " if (what := words_of(problem, name)) else "" for name in group}
        told = [part for name, node in group.items() for part in (
            Words(",  "), Words(about[name]), Name(name), " = ", shown.get(name, node))][1:]
        sheet.write(*told, Words(f"   ({why})"), settles=", ".join(group),
                    node=next(iter(group.values())) if len(group) == 1 else None)


def tell_conditions(problem: "Problem", sheet: WorkedSolution) -> list[int]:
    """The conditions of closed loops, those of a constraint in a line, without those that were told as what they
    leave of a coordinate; the numbers of their lines."""
    if problem.scene.loops is None:
        return []
    found: dict[Any, Any] = {}
    scene, loose = problem.scene, problem.system.scene_with_multipliers
    names = [name for name in scene.dependent if name not in scene.loops.names]
    known = dict(zip(map(loose.symbol, names), copied([scene.dependent[name] for name in names], loose.table),
                     strict=True))
    for constraint in loose.constraints:
        if not is_zero(substitute([constraint.node], known)[0]):
            found.setdefault(constraint.whole, []).append(textbook(constraint.node))
    shown = {whole: with_lengths(sheet, copied(nodes, scene.table)) for whole, nodes in found.items()}
    return [sheet.write(Words(f"'{whole}' holds:  "), *[part for node in nodes for part in (
        Words(",  "), node, " = 0")][1:], settles=f"condition {whole}") for whole, nodes in shown.items()]


def tell_loops(about: AboutRest, sheet: WorkedSolution, conditions: Iterable[int]) -> None:
    """What closed loops leave of their coordinates, to the second order from rest, and their rates."""
    scene, before = about.scene, 0
    looped = scene.loops.names if scene.loops is not None else ()
    found = {name: about.small(scene.dependent[name]) for name in looped}
    sums = {name: about.first(small, scene.q) + about.bent(small) for name, small in found.items()}
    for name, node in sums.items():
        rate, moves = about.first(found[name], scene.v), about.first(found[name], scene.q)
        joined = letters(node) <= SHORT and before == sheet.last
        line = sheet.write(*([] if joined else [Words("so from rest, to the second order  ")]), Name(name), " = ", node,
                           " + …", Words(",  "), Name(name + "'"), " = ", rate, settles=name, uses=list(conditions),
                           node=moves, joined=joined)
        before = line if letters(node) <= SHORT else 0
