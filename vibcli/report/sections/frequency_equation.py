"""Frequency equations of members as textbooks write them: the equation, its roots, shapes, what is orthogonal."""

from collections.abc import Iterator
from functools import partial
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING

from vibcli.report.blocks import Factor, Name, Section, Words, equations, line, section
from vibcli.report.place_letter import lines_by_letter, place_letter
from vibcli.report.sections.members import integrals, terms_of
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SIMPLE, PRINTED = {"sin": "n·π", "cos": "(2n − 1)·π/2"}, 5
HUNG = "YZWVU"      # amplitudes of what hangs on members
CLOSE = 1e-8        # of ω²: frequencies that are one


def frequency_equation(problem: "Problem", _: "Report") -> Iterator[Section]:
    """Frequency equations as textbooks write them, and what their roots are."""
    if not problem.scene.pieces or problem.scene.loops is not None or not problem.symbolic.linearisable:
        return
    from vibcli.analyses.closed_form.member_frequencies import frequency_equations

    found = [one for one in frequency_equations(problem.symbolic) if one is not None]
    several, letter = len(problem.scene.members) > 1, place_letter(problem.scene)
    blocks = [equations(lines_by_letter([*_solved(problem, one, Words(", ".join(one.members)) if several else None),
                                        *_orthogonality(problem, one)], letter)) for one in found]
    undamped = " (of the undamped system)" if _damped(problem) else ""
    yield from section("Frequency equation" + "s" * (len(found) > 1) + undamped, *blocks)


def _damped(problem):
    """Does anything damp, which the equation leaves out?"""
    return bool(problem.symbolic.discrete_matrices[1] or problem.spec.get("damping") is not None or
                any(not placed.piece.drag.is_zero for placed in problem.symbolic.linearisation.pieces))


def _solved(problem, found, label):
    """The equation, its roots, the frequencies, the shape and the orthogonality."""
    from vibcli.analyses.closed_form.member_shapes import shape, unstrained
    from vibcli.analyses.closed_form.textbook_equation import by_letters, sides

    named, letters = by_letters(found, problem.scene.parameters.nodes)
    left, right = sides(named)
    yield line(left, " = ", right, label=label)
    for letter, argument in letters:
        yield line(letter, " = ", argument, inset=2)
    simple = SIMPLE.get(left.name) if right.is_zero and left.op == "call" else None
    values = simple is None and _roots(problem, found)
    if simple:
        yield line("βL = ", simple, ", n = 0, 1, 2, …" if unstrained(found) else ", n = 1, 2, …", inset=2)
    elif values:
        yield line("βL = ", ", ".join(f"{value:.10g}" for value in values), ", …", inset=2)
    yield _frequency(found)
    drawn = shape(found)
    if drawn is not None:
        second = [] if drawn.sigma is None else [" − σ·", Factor(drawn.second)]
        yield line("X(x) = ", drawn.first, *second, inset=2)
        if drawn.sigma is not None:
            above, below = drawn.sigma
            yield line("σ = ", Factor(above), "/", Factor(below), inset=2)


def _roots(problem, found):
    """The first βL that fulfil an equation, as numbers; where modes are known, only if these have them all."""
    from vibcli.analyses.closed_form.member_shapes import roots
    from vibcli.symbolic.evaluation import Floats, evaluate

    values = roots(found, PRINTED)
    if not values or None in values or problem.numeric.has_free_symbols:
        return None if values and None in values else values
    squares = [evaluate([found.square], Floats, {**problem.numeric.floats, found.wave_number.name: value})[0]
               for value in values]
    known = [float(mode.omega) ** 2 for mode in problem.modal.modes.up_to(squares[-1] ** 0.5 * (1 + CLOSE))
             if mode.omega]
    kept = [value for value, square in zip(values, squares, strict=True)
            if any(abs(square - one) <= CLOSE * one for one in known)]
    return kept if len(kept) == len(known) else None


def _orthogonality(problem, found):
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
    amplitudes |= {i: (scene.table.one, lambda mode, letter=letter: (f"{letter}_{mode}",)) for i, letter in named}
    lumped = terms_of([term for i, j in combinations_with_replacement(amplitudes, 2) if (i, j) in M
                       for term in _lumped(M[i, j], amplitudes[i], amplitudes[j], i == j)])
    joined = _joined(lumped) if told and lumped else lumped
    meaning = [part for i, letter in named
               for part in (Words(",  "), letter, Words(" that of "), Name(scene.q[i].name))]
    yield line(*told, *joined, " = 0, ω_i ≠ ω_j", *([Words("   "), *meaning[1:]] if meaning else []), inset=2)


def _joined(terms):
    """Terms of a sum behind others: the first with its sign."""
    return [" − ", *terms[1:]] if terms[0] == "−" else [" + ", *terms]


def _amplitudes(found, several):
    """{coordinate: (what it is of the motion X or ∂X/∂x of a member at a place, that as text, of mode i or j)}."""
    amplitudes: dict = {}
    for placed in found.pieces:
        half = len(placed.rows) // 2
        for place, rows in ((placed.start, placed.rows[:half]), (
                textbook(placed.start + placed.piece.length), placed.rows[half:])):
            for part, row in enumerate(rows):
                for i, slope in row.items():
                    amplitudes.setdefault(i, (1 / slope, partial(_motion, part, place, placed.owner if several else "")))
    return amplitudes


def _motion(part, place, owner, mode):
    """X_i(L), or ∂X_i/∂x(L) of a turn; with the member, where there are several."""
    head = f"∂X_{mode}/∂x(" if part else f"X_{mode}("
    return (head, place, ")", *([Words(f" ({owner})")] if owner else []))


def _lumped(inertia, one, other, alike):
    """What an entry of the mass matrix adds, by the motions of which its coordinates are parts."""
    (scale, first), (factor, second) = one, other
    size = textbook(inertia * scale * factor)
    if alike:
        return [(size, (*first("i"), "·", *first("j")))]
    return [(size, (*first("i"), "·", *second("j"))), (size, (*second("i"), "·", *first("j")))]


def _frequency(found):
    """ω = (βL)²·√(EI/(μL⁴)), or its square where a foundation adds to it."""
    x, order = found.wave_number, found.order
    alone = textbook(found.square / x ** order)
    if x in reachable([alone]):
        return line("ω² = ", found.square, inset=2)
    return line("ω = ", x ** (order // 2) * found.wave_number.table.sqrt(alone), inset=2)
