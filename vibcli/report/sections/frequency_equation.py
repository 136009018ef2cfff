"""Frequency equations of members as textbooks write them: the equation, its roots, shapes, what is orthogonal."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.report.blocks import Factor, Section, Words, equations, line, section
from vibcli.report.place_letter import lines_by_letter, place_letter
from vibcli.report.sections.members import integrals
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SIMPLE, PRINTED = {"sin": "n·π", "cos": "(2n − 1)·π/2"}, 5
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
    """∫ μ X_i X_j dx + M X_i(L) X_j(L) = 0 of two modes."""
    scene, M = problem.scene, problem.symbolic.discrete_matrices[0]
    along = integrals(found.pieces, lambda placed: [(placed.piece.inertia, "X_i·X_j·dx")])
    several, told = len({owner for owner, *_ in along}) > 1, []
    for number, (owner, inner, where) in enumerate(along):
        told += [" + ∫" if number else "∫", *inner, *([Words(f" ({owner})")] if several else []), *where]
    stations = {scene.q.index(node): (part, station.place) for member in map(scene.members.get, found.members)
                for station in member.stations for part, node in enumerate(member.motions(station)) if node in scene.q}
    for i in dict.fromkeys([*stations, *found.hung]):
        if (i, i) in M:
            told += [" + ", Factor(M[i, i]), *_product(*stations[i])] if i in stations else [
                " + ", Factor(M[i, i]), "·Y_i·Y_j"]
    hung = [scene.q[i].name for i in found.hung if (i, i) in M and i not in stations]
    yield line(*told, " = 0, i ≠ j", *([Words("   Y that of " + ", ".join(hung))] if hung else []), inset=2)


def _product(part, place):
    """X_i(L)·X_j(L) of displacements, of slopes ∂X_i/∂x(L)·∂X_j/∂x(L)."""
    for index in "ij":
        yield from (f"·∂X_{index}/∂x(" if part else f"·X_{index}(", place, ")")


def _frequency(found):
    """ω = (βL)²·√(EI/(μL⁴)), or its square where a foundation adds to it."""
    x, order = found.wave_number, found.order
    alone = textbook(found.square / x ** order)
    if x in reachable([alone]):
        return line("ω² = ", found.square, inset=2)
    return line("ω = ", x ** (order // 2) * found.wave_number.table.sqrt(alone), inset=2)
