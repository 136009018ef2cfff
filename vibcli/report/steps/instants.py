"""Where a coordinate is at an instant, and how fast, by the motion that the lines before tell, as in
x = A e^{s₁t} + B e^{s₂t}; at t = 0 as the file says."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.initial_state import starts_in_letters
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Words
from vibcli.report.steps.instances import found_at, is_found
from vibcli.report.steps.parts_of_a_turn import shortest
from vibcli.report.steps.place_of_rest import as_counted
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.node import is_number
from vibcli.symbolic.parser import VALUE
from vibcli.symbolic.semantics import lower_measured
from vibcli.symbolic.syntax import NameRef, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


MOTIONS = "motion", "motion from the start"        # lines that tell how the only coordinate moves under a load


def tell_instant(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked a coordinate, or its speed, at an instant, and is it written down by the motion?"""
    found = _found(problem, sheet, asked)
    if found is None:
        return False
    (node, line), value, unit = found, None, ""
    node = shortest(problem, sheet, node)
    if not problem.numeric.has_free_symbols:
        value, unit = float(value_of(problem, asked)[0]), unit_told(problem.spec, asked)
    if any((one.number, one.settles, one.value) == (line, asked.text.rpartition("(")[0], value) and one.node is node
           for one in sheet.steps):         # a force from rest is told with its expression there
        sheet.write(settles=asked.text, node=node, value=value, unit=unit, uses=[line], joined=True)
        return True
    shown = [" = ", node] if (line is None and not is_number(node)) or value is None else []
    names = {*problem.spec.parameters, *problem.spec.coordinates}
    sheet.write(Words(as_printed(asked.text, names)), *shown, *(() if value is None else number(value, unit)),
                *as_counted(problem, asked.tree), settles=asked.text, node=node, value=value, unit=unit, uses=[line])
    return True


def at_instant(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> "Node | None":
    """Its expression by the letters of the lines; None of what is no such place or speed."""
    found = _found(problem, sheet, asked)
    return None if found is None else found[0]


def _found(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> "tuple[Node, int | None] | None":
    """(its expression, the line that tells the motion)."""
    tree = asked.tree
    if getattr(tree, "head", "") != VALUE or not isinstance(tree.args[0], NameRef) or (
            tree.args[0].primes > 1 or parts_of(tree.args[1]).quantities):
        return None
    forms = _forms(problem, sheet, tree)
    values = found_at(problem, sheet, asked) if forms else []
    return next((form for form in forms if is_found(form[0], values)), None)


def _forms(problem: "Problem", sheet: WorkedSolution, tree: "QuantityRef") -> "list[tuple[Node, int | None]]":
    """(its expression, the line that tells the motion) that may be: of the start, and of the motion, which lines may
    count from rest."""
    (name, primes), scene = (tree.args[0].name, tree.args[0].primes), problem.scene
    t = lower_measured(tree.args[1], scene.table, lambda name, *_: scene.parameters.nodes[name])
    if t.op == "number" and not t.is_zero and problem.numeric.has_free_symbols:
        return []       # its unit would not stand beside letters
    found: list[Any] = [(node, None) for node in _start(problem, name, primes)] if t.is_zero else []
    for line in sheet.steps:
        told = line.settles == name or (line.settles in MOTIONS and scene.coordinates == [name])
        if told and line.node is not None:
            motion = gradient(line.node).get(scene.time, scene.table.zero) if primes else line.node
            found.append((substitute([motion], {scene.time: t})[0], line.number))
    if name in scene.coordinates and not primes and not problem.symbolic.balanced_as_drawn:
        with suppress(PhysicsError):
            rest = problem.symbolic.equilibrium_position[name]
            found += [(node + rest, line) for node, line in found]
    return found


def _start(problem: "Problem", name: str, primes: int) -> "list[Node]":
    """Of a coordinate, or its speed, at t = 0 by the letters of the file; none where it gives no start."""
    record, key = problem.spec.get("initial"), name + "'" * primes
    if record is not None and key in record:
        return [problem.scene.lower(record[key])]
    try:
        starts = starts_in_letters(problem.symbolic) if name in problem.scene.coordinates else None
    except PhysicsError:
        starts = None
    return [] if starts is None else [starts[problem.scene.coordinates.index(name)][primes]]
