"""Frequency equations of members as textbooks write them: the equation, its roots, shapes, what is orthogonal."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.lumped_impedances import coupled
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.notation.numbers import figure
from vibcli.report.blocks import (
    Factor,
    Name,
    Section,
    Words,
    equations,
    factors,
    line,
    maths,
    paragraph,
    section,
    separated,
)
from vibcli.report.measured import without_units
from vibcli.report.own_letters import own_letters
from vibcli.report.sections.orthogonality import orthogonality
from vibcli.report.sections.shapes_in_numbers import shapes_in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.analyses.closed_form.tied_members import Tied
    from vibcli.report.blocks import Line, Paragraph
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SIMPLE, PRINTED, DIGITS = {"sin": "n·π", "cos": "(2n − 1)·π/2"}, 5, 10
SERIES = "a beam whose tension varies along it has no shape in elementary functions: power series in its place"
CLOSE = 1e-8        # of ω²: frequencies that are one


def frequency_equation(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Frequency equations as textbooks write them, and what their roots are."""
    if not problem.scene.pieces:
        return
    if problem.scene.loops is not None or not problem.symbolic.linearisable:
        known = not problem.numeric.has_free_symbols
        system = problem.configuration.linear_system if known else None
        yield from section("Frequency equation", equations(
            _determinant(system.n, system.G, None))) if system else ()
        return
    blocks = [equations(own_letters(problem.scene).lines(lines)) for lines in _equations(
        report.measured, problem, partial(shapes_in_numbers, problem, report.normalise))]
    undamped = " (of the undamped system)" if _damped(problem) else ""
    yield from section("Frequency equation" + "s" * (len(blocks) > 1) + undamped, *blocks, *_apart(problem))


def _apart(problem: "Problem") -> "Iterator[Paragraph]":
    """What no member is tied to, whose frequencies these equations do not have."""
    form, names = problem.symbolic.linearisation, problem.scene.q
    M, _, G, K = matrices_in_letters(form)
    tied = coupled({*M, *G, *K}, {i for placed in form.pieces for row in placed.rows for i in row})
    apart = [maths(Name(q.name)) for i, q in enumerate(names) if i not in tied and any(i in pair for pair in M)]
    if apart:
        yield paragraph(*separated(apart), f" move{'s' * (len(apart) == 1)} apart from these members, by frequencies "
                        "of which these equations tell nothing")


def _equations(problem: "Problem", plain: "Problem", shapes: Callable[..., Any]) -> "Iterator[list[Line]]":
    """The lines on each equation, with its shapes(members): of chains of pieces, of members that meet in one motion, of
    others; `plain`: the same problem, whose modes are told."""
    from vibcli.analyses.closed_form.member_frequencies import chains, frequency_equations
    from vibcli.analyses.closed_form.textbook_equation import is_short, met
    from vibcli.analyses.closed_form.tied_members import tied_equations
    from vibcli.report.sections.hanging_string import hanging_alone, of_hanging

    names, told, left, long = list(problem.scene.members), {}, [], {}
    for chain, found in zip(chains(problem.symbolic.linearisation.pieces), frequency_equations(problem.symbolic),
                            strict=True):
        if found is None or met(found) or not is_short(found):
            left += chain
            long |= {} if found is None else {found.members: found}
        else:
            told[found.members] = partial(_solved, problem, plain, shapes, found)
    for pieces, tied, size in tied_equations(problem.symbolic, left):
        owners = tuple(dict.fromkeys(piece.owner for piece in pieces))
        hanging = hanging_alone(problem, pieces) if tied is None else None
        told[owners] = partial(of_hanging, problem, hanging) if hanging is not None else partial(
            _long, problem, shapes, long[owners]) if tied is None and owners in long else partial(
            _unwritten, problem, shapes, owners, size) if tied is None else partial(_met, problem, shapes, tied)
    for members, lines in sorted(told.items(), key=lambda pair: min(map(names.index, pair[0]))):
        yield list(lines(Words(", ".join(members)) if len(names) > 1 else None))


def _unwritten(problem: "Problem", shapes: Callable[..., Any], members: tuple[str, ...], size: int,
               label: str | None) -> "Iterator[Line]":
    """What is solved, and the shapes."""
    yield from _determinant(size, problem.symbolic.discrete_matrices[2], label)
    if any(placed.owner in members and not (placed.piece.bending.is_zero or placed.piece.gradient.is_zero)
           for placed in problem.symbolic.linearisation.pieces):
        yield line(Words(SERIES), inset=2)
    yield from shapes(members)


def _determinant(size: int, G: Mapping[Any, Any], label: str | None) -> "Iterator[Line]":
    """What is solved where nothing shorter is told."""
    if not size:
        yield line(Words("not written out: the frequencies are those of the member between what holds it"), label=label)
        return
    lumped = "K + iωG − ω²M" if G else "K − ω²M"
    yield line("det D(ω) = 0", Words(f",  {size} × {size}: {lumped} and the dynamic stiffness of each part; "
                                     "not written out"), label=label)


def _long(problem: "Problem", shapes: Any, found: "FrequencyEquation", label: str) -> Iterator[Any]:
    """What is solved, and the orthogonality."""
    moving = {i for placed in found.pieces for row in placed.rows for i in row}
    yield from _determinant(len(moving) + len(found.hung), problem.symbolic.discrete_matrices[2], label)
    yield from shapes(found.members)
    yield from orthogonality(problem, found)


def _met(problem: "Problem", shapes: Callable[..., Any], tied: "Tied", label: Words) -> "Iterator[Line]":
    """k₁ + k₂ + Z = 0, and what these are."""
    yield line(*factors(tied.left), " = ", tied.right, *([] if tied.omega.name == "omega" else [
        Words(",  "), tied.omega, Words(" the circular frequency")]), label=label)
    for letter, (above, below) in tied.stiffnesses.items():
        yield line(letter, " = ", above / below, Words("   "), *whose(tied, letter), inset=2)
    for letter, (order, power) in tied.arguments.items():
        yield line(letter ** order, " = ", power, inset=2)
    for letter, Z in tied.letters.items():
        yield line(letter, " = ", Z, inset=2)
    letters = list(dict.fromkeys(tied.clamped)) or list(tied.stiffnesses)
    names = [part for number, letter in enumerate(letters) for part in (
        Words(" and " if number + 1 == len(letters) else ", "), letter)][1:]
    if len(letters) < len(tied.clamped):
        yield line(Words("multiplied by the square of the denominator of "), *names,
                   Words(" it has all roots, those at which the joint rests among them"), *_anyhow(tied), inset=2)
    if len(letters) > 1:
        yield line(Words("multiplied by the denominators of "), *names,
                   Words(" it has all roots, those at which a joint rests among them"), *_anyhow(tied), inset=2)
    for letter in tied.repeated:
        yield line(Words("and where the denominator of "), letter,
                   Words(" is 0: its members move against each other, the joint rests"), inset=2)
    yield from shapes(tied.members)
    yield from orthogonality(problem, tied)


def _anyhow(tied: "Tied") -> list[Any]:
    """Where waves of a member in a bed become one, or straight, at a frequency that need be none of its own: both
    parts of dynamic stiffnesses are 0 there."""
    if all(placed.piece.foundation.is_zero for placed in tied.pieces):
        return []
    letters = tied.arguments
    pairs = [one ** 2 + other ** 2 for other, (_, power) in letters.items() for one in letters
             if one in reachable([power])]
    named = [part for one in (*letters, *pairs) for part in (Words(", "), one)][1:]
    return [Words("; where one of "), *named, Words(" is 0 it may be 0 too, without a frequency there")]


def whose(tied: "Tied", letter: "Node") -> list[Any]:
    """Parts that tell of which members, or on which stretches of one, a dynamic stiffness is."""
    role = [Words(f",  {tied.roles[letter]}")] if letter in tied.roles else []
    if len(tied.members) > 1:
        return [Words("of " + ", ".join(dict.fromkeys(placed.owner for placed in tied.owners[letter]))), *role]
    return [part for placed in tied.owners[letter] for part in (Words(", "), placed.start, " < x < ",
            textbook(placed.start + placed.piece.length))][1:] + role


def _damped(problem: "Problem") -> bool:
    """Does anything damp, which the equation leaves out?"""
    return bool(problem.symbolic.discrete_matrices[1] or problem.spec.get("damping") is not None or
                any(not placed.piece.drag.is_zero for placed in problem.symbolic.linearisation.pieces))


def _solved(problem: "Problem", plain: "Problem", shapes: Callable[..., Any], found: "FrequencyEquation",
            label: Words | None) -> "Iterator[Line]":
    """The equation, its roots, the frequencies, the shape and the orthogonality."""
    from vibcli.analyses.closed_form.member_shapes import on_both_sides, shape, unstrained
    from vibcli.analyses.closed_form.textbook_equation import by_letters, sides

    named, letters = by_letters(found, problem.scene.parameters.nodes)
    left, right = sides(named)
    yield line(left, " = ", right, label=label)
    for letter, argument in letters:
        yield line(letter, " = ", argument, inset=2)
    simple = SIMPLE.get(left.name) if right.is_zero and left.op == "call" else None
    values = simple is None and _roots(problem, plain, found)
    if simple:
        orders = ", n = 0, 1, 2, …" if unstrained(found) else ", n = 1, 2, …"
        yield line(found.wave_number, " = ", simple + orders, inset=2)
    elif values:
        yield line(found.wave_number, " = ", ", ".join(f"{value:.{DIGITS}g}" for value in values), ", …", inset=2)
    yield _frequency(found, bool(simple or values))
    drawn = shape(found)
    if drawn is None and problem.numeric.has_free_symbols:
        place = problem.scene.table.parameter(own_letters(problem.scene).place)
        for start, end, X in on_both_sides(named, place):
            yield line("X(x) = ", X, Words("   "), start, " < x < ", end, Words(",  where it moves at  "), "x = ",
                       textbook(found.pieces[1].start), inset=2)
    elif drawn is None:
        yield from shapes(found.members)
    else:
        second = [] if drawn.sigma is None else [" − σ·", Factor(drawn.second)]
        yield line("X(x) = ", drawn.first, *second, inset=2)
        if drawn.sigma is not None:
            above, below = drawn.sigma
            yield line("σ = ", above / below, inset=2)
    yield from orthogonality(problem, found)


def _roots(problem: "Problem", plain: "Problem", found: "FrequencyEquation") -> list[float] | None:
    """The first βL that fulfil an equation, as numbers, only if modes have them all; where no modes are known only of
    what has no impedance beside whose pole two may hide."""
    from vibcli.analyses.closed_form.member_shapes import roots

    values = roots(found, PRINTED)
    if not values or problem.numeric.has_free_symbols:
        return None if found.letters else values
    squares = [evaluate([found.square], Floats, {**problem.numeric.floats, found.wave_number.name: value})[0]
               for value in values]
    known = [float(mode.omega) ** 2 for mode in plain.modal.modes.up_to(squares[-1] ** 0.5 * (1 + CLOSE))
             if mode.omega]
    kept = [value for value, square in zip(values, squares, strict=True)
            if any(abs(square - one) <= CLOSE * one for one in known)]
    return kept if len(kept) == len(known) else None


def _frequency(found: "FrequencyEquation", listed: bool) -> "Line":
    """ω = (βL)²·√(EI/(μL⁴)), or its square where a foundation adds to it."""
    x, order = found.wave_number, found.order
    alone = textbook(found.square / x ** order)
    if x in reachable([alone]):
        return line(found.omega ** 2, " = ", found.square, *_beyond(found, listed), inset=2)
    bare = without_units(alone)
    if not any(node.op == "symbol" for node in reachable([bare])):
        value = figure(evaluate([bare], Floats, {})[0] ** 0.5, digits=DIGITS)
        return line(found.omega, " = ", x.table.parameter(f"{value} rad/s") * x ** (order // 2), inset=2)
    return line(found.omega, " = ", x ** (order // 2) * x.table.sqrt(alone), inset=2)


def _beyond(found: "FrequencyEquation", listed: bool) -> "list[Node | Words]":
    """βL other than positive at which there are frequencies of a member on a foundation; `listed`: are its roots?"""
    from vibcli.analyses.closed_form.member_shapes import unstrained

    x, rests = found.wave_number, bool(unstrained(found)) and not listed
    if found.pieces[0].piece.foundation.is_zero:
        return []
    if found.second is None and not found.letters:
        return [Words(",  also where "), x, Words(" is 0")] if rests else []
    where, what = (x ** found.order, "negative") if found.second is None else (x, "not real")
    return [Words(",  also where "), where, Words(" is 0 or " * rests + " is " * (not rests) + what)]
