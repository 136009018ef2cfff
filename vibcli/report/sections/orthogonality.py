"""What two modes of members are orthogonal by: integrals of their inertia along them, and all that is lumped."""

from collections.abc import Iterator
from functools import partial
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Line, Name, Words, line
from vibcli.report.sections.members import integrals, terms_of
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

HUNG = "YWVUS"      # amplitudes of what hangs on members


def orthogonality(problem: "Problem", found: Any) -> Iterator[Line]:
    """∫ μ X_i X_j dx + M X_i(L) X_j(L) = 0 of two modes, with all that has inertia among what members move."""
    scene, M = problem.scene, problem.symbolic.discrete_matrices[0]
    along = integrals(found.pieces, lambda placed: [(placed.piece.inertia, "X_i·X_j·dx")])
    several, told = len({owner for owner, *_ in along}) > 1, []
    for number, (owner, inner, where) in enumerate(along):
        told += [" + ∫" if number else "∫", *inner, *([Words(f" ({owner})")] if several else []), *where]
    amplitudes = _amplitudes(found, several)
    hung = [i for i in found.hung if any(i in pair for pair in M)]
    taken = {*scene.coordinates, *scene.parameters.nodes}
    letters = [letter for letter in HUNG if letter not in taken]
    if len(hung) > len(letters):
        return
    named = list(zip(hung, letters, strict=False))
    amplitudes |= {i: (scene.table.one, lambda mode, letter=letter: (f"{letter}_{mode}",), []) for i, letter in named}
    lumped = terms_of([_lumped(M[i, j], amplitudes[i], amplitudes[j])
                       for i, j in combinations_with_replacement(amplitudes, 2) if (i, j) in M])
    joined = _joined(lumped) if told and lumped else lumped
    meaning = [part for i, letter in named
               for part in (Words(",  "), letter, Words(" that of "), Name(scene.q[i].name))]
    yield line(*told, *joined, " = 0, ω_i ≠ ω_j", *([Words("   "), *meaning[1:]] if meaning else []), inset=2)


def _joined(terms):
    """Terms of a sum behind others: the first with its sign."""
    return [" − ", *terms[1:]] if terms[0] == "−" else [" + ", *terms]


def _amplitudes(found, several):
    """{coordinate: (what it is of the motion X or ∂X/∂x of a member at a place, that as text of mode i or j, whose it
    is)}."""
    amplitudes: dict = {}
    for placed in found.pieces:
        half = len(placed.rows) // 2
        for place, rows in ((placed.start, placed.rows[:half]), (
                textbook(placed.start + placed.piece.length), placed.rows[half:])):
            for part, row in enumerate(rows):
                for i, slope in row.items():
                    amplitudes.setdefault(i, (1 / slope, partial(_motion, part, place),
                                              [Words(f" ({placed.owner})")] if several else []))
    return amplitudes


def _motion(part, place, mode):
    """X_i(L), or ∂X_i/∂x(L) of a turn."""
    return (f"∂X_{mode}/∂x(" if part else f"X_{mode}(", place, ")")


def _lumped(inertia, one, other):
    """What an entry of the mass matrix adds, by the motions of which its coordinates are parts."""
    (scale, first, owner), (factor, second, another) = one, other
    size = textbook(inertia * scale * factor)
    if one is other:
        return (size, (*first("i"), "·", *first("j"), *owner))
    if owner != another:
        first, second = partial(_of, first, owner), partial(_of, second, another)
    both = owner if owner == another else []
    return (size, ("(", *first("i"), "·", *second("j"), " + ", *second("i"), "·", *first("j"), ")", *both))


def _of(motion, owner, mode):
    return (*motion(mode), *owner)
