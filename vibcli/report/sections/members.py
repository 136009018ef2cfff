"""Members: differential equation and conditions at their stations, in letters."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Factor, Heading, Line, Name, Section, Words, equations, line, paragraph, section
from vibcli.report.place_letter import by_letter, lines_by_letter, place_letter, words_by_letter
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

# Signs of what a piece of each order does to its left end, along u and ∂u/∂x; those at its right end are the opposite
SIGNS = {2: (1,), 4: (-1, 1)}
MOTIONS = ("{u}", "∂{u}/∂x")
RATES = (("∂²{u}/∂t²", "∂³{u}/∂x∂t²"), ("∂{u}/∂t", "∂²{u}/∂x∂t"), MOTIONS)     # of M, C, K
SIMPLE, PRINTED = {"sin": "n·π", "cos": "(2n − 1)·π/2"}, 5
CLOSE = 1e-8        # of ω²: frequencies that are one
REMARK, JUMPS = "x counts from the left end of each member", "; [ ] is the jump at a place, right less left"
DAMPED = "without what `damping` adds: it damps every mode by itself"
RIGHT, SIDES = "(+)", "; (+) is what holds right of a place, (−) left of it"


def member_equations(problem: "Problem") -> Iterator[Section]:
    """The equations of free vibration of members, and of what they are tied to."""
    if not problem.symbolic.linearisable:
        yield from section("Equations of free vibration", paragraph("not found in letters, as the equilibrium is not"))
        return
    form, scene = problem.symbolic.linearisation, problem.scene
    M, C, _, K = problem.symbolic.discrete_matrices
    blocks: list = []
    own: dict = {}
    remark, letter = REMARK, place_letter(scene)
    for name, member in scene.members.items():
        pieces = [piece for piece in form.pieces if piece.owner == name]
        own |= {scene.q.index(node): (member, part) for station in member.stations
                for part, node in enumerate(member.motions(station)) if _is_own(node, member, scene)}
        if pieces:
            conditions = list(station_conditions(member, form.pieces, (M, C, K), scene))
            told = [part for one in conditions for part in one.parts if type(part) is str]
            for mark, words in (("[", JUMPS), (RIGHT, SIDES)):
                if words not in remark and any(mark in part for part in told):
                    remark += words
            blocks += [Heading(f"{name}:"), equations(lines_by_letter([
                *differential(pieces, _letter(member)), *conditions], letter))]
    others = [i for i in range(len(scene.q)) if i not in own]
    if others:
        blocks += [Heading("what they carry:"), equations(lines_by_letter([
            carried(i, form.pieces, (M, C, K), scene) for i in others], letter))]
    yield from section("Equations of free vibration", *blocks, paragraph(words_by_letter(remark, letter), hang=4),
                       paragraph(DAMPED) if problem.spec.get("damping") is not None else None)


def _letter(member):
    """u, or φ of a shaft."""
    from vibcli.notation.plain import GREEK

    return GREEK.get(member.kind.letter, member.kind.letter)


def differential(pieces: "Sequence[Any]", u: str) -> Iterator[Line]:
    """EI ∂⁴u/∂x⁴ − N ∂²u/∂x² + k u + c ∂u/∂t + μ ∂²u/∂t² = 0 of each uniform stretch."""
    stretches: list = []
    for placed in pieces:
        piece, end = placed.piece, textbook(placed.start + placed.piece.length)
        pull = [(along, f"{x}∂²{u}/∂x²") for along, x in _tension(placed)] + [(piece.gradient, f"∂{u}/∂x")]
        rest = [(piece.foundation, u), (piece.drag, f"∂{u}/∂t"), (piece.inertia, f"∂²{u}/∂t²")]
        if piece.bending.is_zero:
            parts = (*_terms(pull), " = ", *_terms(rest))
        else:
            parts = (*_terms([(piece.bending, f"∂⁴{u}/∂x⁴"), *((-along, text) for along, text in pull), *rest]), " = 0")
        if stretches and stretches[-1][0] == parts:
            stretches[-1][2] = end
        else:
            stretches.append([parts, placed.start, end])
    for parts, start, end in stretches:
        where = ["     (", start, " < x < ", end, ")"] if len(stretches) > 1 else []
        yield line(*parts, *where)


def _tension(placed):
    """N(x) along a piece, x from the left end of the member: coefficients of 1 and of x."""
    piece = placed.piece
    return (textbook(piece.tension - piece.gradient * placed.start), ""), (piece.gradient, "x·")


def station_conditions(member: Any, pieces: "Sequence[Any]", matrices: Any, scene: Any) -> Iterator[Line]:
    """What holds at each station: motions that are held, forces where they are free."""
    u, starts = _letter(member), {piece.start: piece for piece in pieces if piece.owner == member.name}
    left = None
    for station in member.stations:
        right, parts = starts.get(station.place), []
        for part, node in enumerate(member.motions(station)):
            parts.append(", " if part else "")
            if _is_own(node, member, scene):
                parts += _balance(scene.q.index(node), part, (left, right), matrices, scene, member, pieces)
            else:
                parts += [MOTIONS[part].format(u=u), " = ", node]
        yield Line(tuple(part for part in parts if part != ""), ("at x = ", station.place), inset=2)
        left = right


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
    along = _integrals(found.pieces, lambda placed: [(placed.piece.inertia, "X_i·X_j·dx")])
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


def member_energies(problem: "Problem", kind: str) -> list:
    """What members add to T and V, as integrals along each: parts of a formula."""
    form = problem.symbolic.linearisation if problem.symbolic.linearisable else problem.system.linearisation

    def integrand(placed):
        piece, u = placed.piece, _letter(problem.scene.members[placed.owner])
        return {"T": [(piece.inertia, f"(∂{u}/∂t)²")], "Phi": [(piece.drag, f"(∂{u}/∂t)²")],
                "V": [(piece.bending, f"(∂²{u}/∂x²)²"), *((along, f"{x}(∂{u}/∂x)²") for along, x in _tension(placed)),
                      (piece.foundation, f"{u}²")]}[kind]

    found, parts = _integrals(form.pieces, integrand), []
    several = len({owner for owner, *_ in found}) > 1
    for owner, inner, where in found:
        long = len(inner) > 3
        parts += [" + ½·∫(" if long else " + ½·∫", *inner, ")·d" if long else "·d", "x",
                  *([Words(f" ({owner})")] if several else []), *where]
    return list(by_letter(parts, place_letter(problem.scene)))


def _integrals(pieces, integrand):
    """[(member, parts of the integrand, parts that tell from where to where)]: one for all stretches on which it is the
    same; `integrand(piece)`: terms (coefficient, text)."""
    told: dict = {}
    for placed in pieces:
        inner, end = tuple(_terms(integrand(placed))), textbook(placed.start + placed.piece.length)
        if inner:
            spans = told.setdefault((placed.owner, inner), [])
            start = spans.pop()[0] if spans and spans[-1][1] == textbook(placed.start) else placed.start
            spans.append((start, end))
    found = []
    for (owner, inner), spans in told.items():
        stepped = sum(one == owner for one, _ in told) > 1
        where = [part for start, end in spans for part in (Words(", "), start, " < x < ", end)][1:]
        found.append((owner, inner, [Words(" ("), *where, Words(")")] if stepped else []))
    return found


def _is_own(node, member, scene):
    return node in scene.q and member.has_coordinate(node.name)


def _balance(i, part, sides, matrices, scene, member, pieces):
    """Internal force = what acts on the station, other members held there too; the jump of it at an inner one."""
    u, (left, right) = _letter(member), sides
    acting = [(node, RATES[kind][part].format(u=u) if j == i else Name(scene.q[j].name + "'" * (2 - kind)))
              for kind, matrix in enumerate(matrices) for (row, j), node in matrix.items() if row == i]
    acting += [(-node, told) for node, told in _pulls(i, pieces, scene) if told[1].text != f" of {member.name}"]
    if left is None and right is None:      # parts without inertia on both sides, springs among the others
        return [*_terms(acting), " = 0"]
    ends = [_forces(placed, end, u)[part] for placed, end in ((left, 1), (right, 0)) if placed]
    own, sign = _terms(ends[-1]), SIGNS[2 if (right or left).piece.bending.is_zero else 4][part]
    if left and right and ends[0] == ends[1]:
        own = ["[", *own, "]"]
    elif left and right:
        own = _terms([*((node, text + RIGHT) for node, text in ends[1]),
                      *((-node, text + "(−)") for node, text in ends[0])])
    if not right:
        sign = -sign
    return [*own, " = ", *(_terms([(sign * node, name) for node, name in acting]) or ["0"])]


def _forces(placed, end, u):
    """Internal forces along u and ∂u/∂x at the left (0) or right (1) end: terms (coefficient, derivative)."""
    piece = placed.piece
    tension = textbook(piece.tension + piece.gradient * piece.length) if end else textbook(piece.tension)
    if piece.bending.is_zero:
        return [[(tension, f"∂{u}/∂x")]]
    bending = textbook(piece.bending)
    return [[(bending, f"∂³{u}/∂x³"), (-tension, f"∂{u}/∂x")], [(bending, f"∂²{u}/∂x²")]]


def carried(i: int, pieces: "Sequence[Any]", matrices: Any, scene: Any) -> Line:
    """Equation of what members are tied to: M q̈ + C q̇ + K q = forces of the members."""
    acting = [(node, Name(scene.q[j].name + "'" * (2 - kind))) for kind, matrix in enumerate(matrices)
              for (row, j), node in matrix.items() if row == i]
    return line(*(_terms(acting) or ["0"]), " = ", *(_terms(_pulls(i, pieces, scene)) or ["0"]),
                label=Name(scene.q[i].name))


def _pulls(i, pieces, scene):
    """What pieces of members do along the coordinate i: terms (coefficient, (derivative, of whom, where))."""
    for placed in pieces:
        signs = SIGNS[2 if placed.piece.bending.is_zero else 4]
        for end, place in enumerate((placed.start, textbook(placed.start + placed.piece.length))):
            forces = _forces(placed, end, _letter(scene.members[placed.owner]))
            for terms, sign, row in zip(forces, signs, placed.rows[end * len(signs):], strict=False):
                if i in row:
                    for node, text in terms:
                        yield (row[i] * node * (-sign if end else sign),
                               (text, Words(f" of {placed.owner}"), Words(" at x = "), place))


def _terms(terms: "Sequence[tuple[Node, Any]]") -> list:
    """Σ coefficient·text as parts of a formula, without what is zero."""
    parts: list = []
    for node, text in terms:
        node = textbook(node)
        if node.is_zero:
            continue
        negative = node.op != "sum" and node.coefficient < 0
        size = -node if negative else node
        sign = " − " if negative and parts else "−" if negative else " + " if parts else ""
        told = text if isinstance(text, tuple) and not isinstance(text, Name) else (text,)
        parts += [sign, *told] if size is size.table.one else [sign, Factor(size), "·", *told]
    return [part for part in parts if part != ""]
