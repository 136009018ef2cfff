"""What two modes of members are orthogonal by: integrals of their inertia along them, and all that is lumped."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.lumped_impedances import by_motions
from vibcli.report.blocks import Line, Name, Words, line
from vibcli.report.sections.members import integrals, terms_of
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.analyses.closed_form.tied_members import Tied
    from vibcli.results.problem import Problem
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

HUNG = "YWVUS"      # amplitudes of what hangs on members


def orthogonality(problem: "Problem", found: Any) -> Iterator[Line]:
    """∫ μ X_i X_j dx + M X_i(L) X_j(L) = 0 of two modes, with all that has inertia among what members move."""
    scene, M = problem.scene, problem.symbolic.discrete_matrices[0]
    along = integrals(found.pieces, lambda placed: [(placed.piece.inertia, "X_i·X_j·dx")])
    several, told = len({owner for owner, *_ in along}) > 1, []
    for number, (owner, inner, where) in enumerate(along):
        told += [" + ∫" if number else "∫", *inner, *([Words(f" ({owner})")] if several else []), *where]
    motions, parts = _motions(found, several)
    hung = [i for i in found.hung if any(i in pair for pair in M)]
    taken = {*scene.coordinates, *scene.parameters.nodes}
    letters = [letter for letter in HUNG if letter not in taken]
    if len(hung) > len(letters):
        return
    named = list(zip(hung, letters, strict=False))
    for i, letter in named:
        parts[i] = {len(motions): scene.table.one}
        motions.append((partial(_of_hung, letter), []))
    lumped = terms_of([(size, _products(motions[m], motions[n])) for m, n in combinations_with_replacement(
        range(len(motions)), 2) for size in [_lumped(M, parts, m, n, scene.table)]])
    joined = _joined(lumped) if told and lumped else lumped
    meaning = [part for i, letter in named
               for part in (Words(",  "), letter, Words(" that of "), Name(scene.q[i].name))]
    yield line(*told, *joined, " = 0, ω_i ≠ ω_j", *([Words("   "), *meaning[1:]] if meaning else []), inset=2)


def _joined(terms: Sequence[Any]) -> list[Any]:
    """Terms of a sum behind others: the first with its sign."""
    return [" − ", *terms[1:]] if terms[0] == "−" else [" + ", *terms]


def _motions(found: "FrequencyEquation | Tied", several: bool) -> Any:
    """[(text of a motion X or ∂X/∂x of a place in mode i or j, whose it is)] of the stations, and {coordinate: {number
    of a motion: how much of it that is}}."""
    motions, parts = [], {}
    for placed in found.pieces:
        half = len(placed.rows) // 2
        for place, rows in ((placed.start, placed.rows[:half]), (
                textbook(placed.start + placed.piece.length), placed.rows[half:])):
            for i, shares in by_motions([row for row in rows if row]).items():
                if i not in parts:
                    parts[i] = {len(motions) + k: share for k, share in enumerate(shares) if not share.is_zero}
            motions += [(partial(_motion, part, place), [Words(f" ({placed.owner})")] if several else [])
                        for part, row in enumerate(rows) if row]
    return motions, parts


def _motion(part: int, place: "Node", mode: str) -> "tuple[str, Node, str]":
    """X_i(L), or ∂X_i/∂x(L) of a turn."""
    return (f"∂X_{mode}/∂x(" if part else f"X_{mode}(", place, ")")


def _of_hung(letter: str, mode: str) -> tuple[str]:
    return (f"{letter}_{mode}",)


def _lumped(M: "Mapping[tuple[int, int], Node]", parts: "Mapping[int, dict[int, Node]]", m: int, n: int,
            table: "Table") -> "Node":
    """What the mass matrix has of two motions."""
    return textbook(table.total([node * parts[i][m] * parts[j][n] for (i, j), node in M.items()
                                 if m in parts.get(i, ()) and n in parts.get(j, ())]))


def _products(one: tuple[Callable[..., Any], list[Words]],
              other: tuple[Callable[..., Any], list[Words]]) -> "tuple[Node | str | Words, ...]":
    """The products of two motions in the modes i and j."""
    (first, owner), (second, another) = one, other
    if one is other:
        return (*first("i"), "·", *first("j"), *owner)
    if owner != another:
        first, second = partial(_with_owner, first, owner), partial(_with_owner, second, another)
    both = owner if owner == another else []
    return ("(", *first("i"), "·", *second("j"), " + ", *second("i"), "·", *first("j"), ")", *both)


def _with_owner(motion: Callable[..., Any], owner: Sequence[Words], mode: str) -> "tuple[str, Node, str, Words]":
    return (*motion(mode), *owner)
