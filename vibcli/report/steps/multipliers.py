"""Forces in constraints that close loops, along a motion: each is the multiplier of its condition,

    M q̈ + f + Gᵀλ = 0,   G q̈ + h = 0,   G = ∂g/∂q,

h what the second rate of the conditions g = 0 has beside accelerations (Lagrange's equations of the first kind)."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.mechanics.inputs_outputs.reactions import LENGTHENING
from vibcli.mechanics.static_preload import solve_linear
from vibcli.report.blocks import Words
from vibcli.report.steps.agreement import agree_in_motion, samples_of
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

MOST = 4            # accelerations and multipliers that are solved for in letters
READABLE = 40       # letters of a second rate or a multiplier, up to which it is told


def tell_multipliers(problem: "Problem", sheet: WorkedSolution, text: str) -> None:
    """The second rates of conditions, and what follows from these and the equations for the forces that `text` asks;
    nothing where the equations have no multipliers."""
    lines = {line.settles: line.number for line in sheet.steps}
    if "multipliers" not in lines:
        return
    equations, scene = problem.symbolic.equations, problem.system.scene_with_multipliers
    ties = list(zip(equations.multipliers, scene.constraints, strict=False))
    if not equations.full or not any(tie.signal in text for _, tie in ties):
        return
    rates = [textbook(scene.rate(scene.rate(tie.node))) for _, tie in ties]
    uses = [number for name, number in lines.items() if name.startswith("motion[")]
    for (_, tie), rate in zip(ties, rates, strict=True):
        if letters(rate) <= READABLE:
            uses.append(sheet.write(Words(f"second rate of '{tie.name}':  "), rate, " = 0",
                                    settles=f"rate[{tie.name}]", node=rate, uses=[lines["multipliers"]]))
    known = _solved(problem, scene, [*equations.full, *rates], [symbol for symbol, _ in ties])
    for symbol, tie in ties:
        if tie.signal in text:
            force = symbol if tie.form in LENGTHENING else -symbol
            node = textbook(substitute([force], known)[0])
            node = min((node, single(node)), key=letters)
            shown = [" = ", node] if node is not force and letters(node) <= READABLE else []
            sheet.write(Words(f"by these and the equations  {tie.signal}"), " = ", force, *shown,
                        settles=tie.signal, node=node if shown else None, uses=uses)


def _solved(problem: "Problem", scene: "Scene", rows: "list[Node]",
            multipliers: "Sequence[Node]") -> "dict[Node, Node]":
    """{multiplier: what it is} by equations and second rates; none of many, or where these do not fix them."""
    unknown = [*scene.a, *multipliers]
    if len(unknown) > MOST or len(scene.q) - len(problem.scene.q) != len(multipliers):
        return {}
    zero, still = scene.table.zero, dict.fromkeys(unknown, scene.table.zero)
    columns = [gradient(row) for row in rows]
    if any(row.get(a, zero).is_zero for row, a in zip(columns, scene.a, strict=False)):
        return {}
    rest = substitute(rows, still)
    found = solve_linear([[*(of.get(x, zero) for x in unknown), -node]
                          for of, node in zip(columns, rest, strict=True)], zero)
    holds = all(agree_in_motion(scene, samples_of(problem, {}), [
        node, *(of.get(x, zero) * value for x, value in zip(unknown, found, strict=True))], [])
        for of, node in zip(columns, rest, strict=True))
    return dict(zip(multipliers, found[len(scene.a):], strict=True)) if holds else {}
