"""What is asked that lines tell by another name: entries of matrices, forces and places in equilibrium, moments of
inertia, real roots, periods and frequencies beside an angular frequency."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.quantities.expression import value_of
from vibcli.quantities.matrices import coordinate_number
from vibcli.report.blocks import Name
from vibcli.report.steps.instances import found_at, is_found
from vibcli.report.steps.step import WorkedLine, WorkedSolution, unit_told
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MATRICES = "M", "C", "G", "K"
CHECKED = "J", "eigenvalue"         # quantities that several lines may tell
BESIDE = {"period": "T", "frequency": "f"}      # letters of what the line of an angular frequency may tell as well


def settle_told(problem: "Problem", sheet: WorkedSolution) -> None:
    """Let such lines settle what answers ask, where it is the engine's."""
    if problem.scene.pieces:
        return
    settled = {line.settles for line in sheet.steps}
    for asked in [answer.asked for answer in problem.spec.answers]:
        if asked.text in settled or not isinstance(asked.tree, QuantityRef) or asked.tree.args:
            continue
        with suppress(PhysicsError, SpecError):
            _settle(problem, sheet, asked)


def _settle(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> None:
    """By its definition; of what has no number of its own, and in numbers, where the engine has it."""
    known, numeric = None, not problem.numeric.has_free_symbols
    for line, node in _told(problem, sheet, asked.tree):
        if known is None and (numeric or asked.tree.head in CHECKED):
            known = found_at(problem, sheet, asked)
        if known is None or is_found(node, known):
            sheet.settles_too(line, asked.text, node, float(value_of(problem, asked)[0]) if numeric else None,
                              unit_told(problem.spec, asked) if numeric else "")
            return


def _told(problem: "Problem", sheet: WorkedSolution, tree: Any) -> "Iterator[tuple[WorkedLine, Node]]":
    """(a line that may tell it, the expression that is then asked)."""
    table, indices = problem.scene.table, tree.indices
    if tree.head in MATRICES and len(indices) == 2 and problem.symbolic.linearisable:
        entry = _entry(problem, tree)
        yield from ((line, entry) for line in sheet.steps if line.settles == tree.head)
    alone = tree.head == "equilibrium" and (indices[0], "N_" + indices[0].removesuffix(".force"))
    roots = [sheet.letter(letter) for letter in ("s1", "s2")] if tree.head == "eigenvalue" else []
    for line in sheet.steps:
        if line.node is None:
            continue
        if (alone and line.settles in alone) or (tree.head == "J" and line.settles.startswith("J_")):
            yield line, line.node
        elif tree.head == "eigenvalue" and line.letter in roots:
            yield line, table.parameter(line.letter, positive=False)
        elif tree.head in BESIDE and line.settles == f"omega[{indices[0]}]" and _stands_in(
                sheet, line.number, Name(sheet.letter(BESIDE[tree.head]))):
            omega = table.parameter(line.letter) if line.letter else line.node
            yield line, 2 * table.pi / omega if tree.head == "period" else omega / (2 * table.pi)


def _stands_in(sheet: WorkedSolution, number: int, letter: Name) -> bool:
    """Has a numbered line that letter?"""
    return any(isinstance(part, Name) and part == letter for line in sheet.steps if line.number == number
               for part in line.parts)


def _entry(problem: "Problem", tree: QuantityRef) -> Any:
    return problem.symbolic.matrices[MATRICES.index(tree.head)].get(_place(problem, tree), problem.scene.table.zero)


def _place(problem: "Problem", tree: QuantityRef) -> tuple[int, int]:
    i, j = (coordinate_number(problem, index) for index in tree.indices)
    return i, j


def asked_entries(problem: "Problem", letter: str) -> dict[tuple[int, int], str]:
    """{(i, j): text} of the entries of a matrix that answers ask."""
    found = {}
    for asked in [answer.asked for answer in problem.spec.answers]:
        tree = asked.tree
        if isinstance(tree, QuantityRef) and tree.head == letter and len(tree.indices) == 2 and not tree.args:
            with suppress(PhysicsError):
                found[_place(problem, tree)] = asked.text
    return found
