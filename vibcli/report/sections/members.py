"""Members: differential equation and conditions at their stations, in letters."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Factor, Heading, Line, Name, Section, Words, equations, line, paragraph, section
from vibcli.report.own_letters import own_letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

# Signs of what a piece of each order does to its left end, along u and ∂u/∂x; those at its right end are the opposite
SIGNS = {2: (1,), 4: (-1, 1)}
MOTIONS = ("{u}", "∂{u}/∂x")
RATES = (("∂²{u}/∂t²", "∂³{u}/∂x∂t²"), ("∂{u}/∂t", "∂²{u}/∂x∂t"), MOTIONS)     # of M, C, K
REMARK, JUMPS = "x counts from the left end of each member", "; [ ] is the jump at a place, right less left"
DAMPED = "without what `damping` adds: it damps every mode by itself"
RIGHT, SIDES = "(+)", "; (+) is what holds right of a place, (−) left of it"


def member_equations(problem: "Problem") -> Iterator[Section]:
    """The equations of free vibration of members, and of what they are tied to."""
    if not problem.symbolic.linearisable:
        yield from section("Equations of free vibration", paragraph("not found in letters, as the equilibrium is not"))
        return
    form, scene = problem.symbolic.linearisation, problem.scene
    matrices = of_what_is_no_member(problem)
    blocks: list[Any] = []
    own: dict[Any, Any] = {}
    remark, letters = REMARK, own_letters(scene)
    for name, member in scene.members.items():
        pieces = [piece for piece in form.pieces if piece.owner == name]
        own |= {scene.q.index(node): (member, part) for station in member.stations
                for part, node in enumerate(member.motions(station)) if _is_own(node, member, scene)}
        if pieces:
            conditions = list(station_conditions(member, form.pieces, matrices, scene))
            told = [part for one in conditions for part in one.parts if type(part) is str]
            for mark, words in (("[", JUMPS), (RIGHT, SIDES)):
                if words not in remark and any(mark in part for part in told):
                    remark += words
            blocks += [Heading(f"{name}:"), equations(letters.lines([
                *differential(pieces, _letter(member)), *conditions]))]
    others = [i for i in range(len(scene.q)) if i not in own]
    if others:
        blocks += [Heading("what they carry:"), equations(letters.lines(
            carried(i, form.pieces, matrices, scene) for i in others))]
    yield from section("Equations of free vibration", *blocks, paragraph(letters.words(remark), hang=4),
                       paragraph(DAMPED) if problem.spec.get("damping") is not None else None)


def _letter(member: "Member") -> str:
    """u, or φ of a shaft."""
    from vibcli.notation.names import GREEK

    return GREEK.get(member.kind.letter, member.kind.letter)


def differential(pieces: "Sequence[Any]", u: str) -> Iterator[Line]:
    """EI ∂⁴u/∂x⁴ − N ∂²u/∂x² + k u + c ∂u/∂t + μ ∂²u/∂t² = 0 of each uniform stretch."""
    stretches: list[Any] = []
    for placed in pieces:
        piece, end = placed.piece, textbook(placed.start + placed.piece.length)
        pull = [(along, f"{x}∂²{u}/∂x²") for along, x in _tension(placed)] + [(piece.gradient, f"∂{u}/∂x")]
        rest = [(piece.foundation, u), (piece.drag, f"∂{u}/∂t"), (piece.inertia, f"∂²{u}/∂t²")]
        if piece.bending.is_zero:
            parts = (*terms_of(pull), " = ", *terms_of(rest))
        else:
            pull = [(-along, text) for along, text in pull]
            parts = (*terms_of([(piece.bending, f"∂⁴{u}/∂x⁴"), *pull, *rest]), " = 0")
        if stretches and stretches[-1][0] == parts:
            stretches[-1][2] = end
        else:
            stretches.append([parts, placed.start, end])
    for parts, start, end in stretches:
        where = ["     (", start, " < x < ", end, ")"] if len(stretches) > 1 else []
        yield line(*parts, *where)


def _tension(placed: "PlacedPiece") -> "tuple[tuple[Node, str], tuple[Node, str]]":
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


def member_energies(problem: "Problem", kind: str) -> list[Any]:
    """What members add to T and V, as integrals along each: parts of a formula."""
    form = problem.symbolic.linearisation if problem.symbolic.linearisable else problem.system.linearisation

    def integrand(placed: "PlacedPiece") -> "list[tuple[Node, str]]":
        piece, u = placed.piece, _letter(problem.scene.members[placed.owner])
        return {"T": [(piece.inertia, f"(∂{u}/∂t)²")], "Phi": [(piece.drag, f"(∂{u}/∂t)²")],
                "V": [(piece.bending, f"(∂²{u}/∂x²)²"), *((along, f"{x}(∂{u}/∂x)²") for along, x in _tension(placed)),
                      (piece.foundation, f"{u}²")]}[kind]

    found, parts = integrals(form.pieces, integrand), []
    several = len({owner for owner, *_ in found}) > 1
    for owner, inner, where in found:
        long = len(inner) > 3
        parts += [" + ½·∫(" if long else " + ½·∫", *inner, ")·d" if long else "·d", "x",
                  *([Words(f" ({owner})")] if several else []), *where]
    return list(own_letters(problem.scene).parts(parts))


def integrals(pieces: "Sequence[Any]", integrand: "Callable[..., list[tuple[Node, str]]]"
              ) -> list[tuple[str, tuple[Factor | str, ...], list[Any]]]:
    """[(member, parts of the integrand, parts that tell from where to where)]: one for all stretches on which it is the
    same; `integrand(piece)`: terms (coefficient, text)."""
    told: dict[Any, Any] = {}
    for placed in pieces:
        inner, end = tuple(terms_of(integrand(placed))), textbook(placed.start + placed.piece.length)
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


def _is_own(node: "Node", member: "Member", scene: "Scene") -> bool:
    return node in scene.q and member.has_coordinate(node.name)


def _balance(i: int, part: int, sides: "tuple[PlacedPiece | None, PlacedPiece | None]", matrices: Any, scene: "Scene",
             member: "Member", pieces: Sequence[Any]) -> list[Any]:
    """Internal force = what acts on the station, other members held there too; the jump of it at an inner one."""
    u, (left, right) = _letter(member), sides
    acting = [(node, RATES[kind][part].format(u=u) if j == i else Name(scene.q[j].name + "'" * (2 - kind)))
              for kind, matrix in enumerate(matrices) for (row, j), node in matrix.items() if row == i]
    acting += [(-node, told) for node, told in _pulls(i, pieces, scene) if told[1].text != f" of {member.name}"]
    if left is None and right is None:      # parts without inertia on both sides, springs among the others
        return [*terms_of(acting), " = 0"]
    ends = [_forces(placed, end, u)[part] for placed, end in ((left, 1), (right, 0)) if placed]
    own, sign = terms_of(ends[-1]), SIGNS[2 if (right or left).piece.bending.is_zero else 4][part]
    if left and right and ends[0] == ends[1]:
        own = ["[", *own, "]"]
    elif left and right:
        own = terms_of([*((node, text + RIGHT) for node, text in ends[1]),
                      *((-node, text + "(−)") for node, text in ends[0])])
    if not right:
        sign = -sign
    return [*own, " = ", *(terms_of([(sign * node, name) for node, name in acting]) or ["0"])]


def _forces(placed: "PlacedPiece", end: int, u: str) -> "list[list[tuple[Node, str]]]":
    """Internal forces along u and ∂u/∂x at the left (0) or right (1) end: terms (coefficient, derivative)."""
    piece = placed.piece
    tension = textbook(piece.tension + piece.gradient * piece.length) if end else textbook(piece.tension)
    if piece.bending.is_zero:
        return [[(tension, f"∂{u}/∂x")]]
    bending = textbook(piece.bending)
    return [[(bending, f"∂³{u}/∂x³"), (-tension, f"∂{u}/∂x")], [(bending, f"∂²{u}/∂x²")]]


def of_what_is_no_member(problem: "Problem") -> "tuple[dict[tuple[int, int], Node], ...]":
    """M, C + G, K of what is no member."""
    M, C, G, K = problem.symbolic.discrete_matrices
    return M, {pair: (C[pair] + G[pair] if pair in C else G[pair]) if pair in G else C[pair] for pair in C | G}, K


def carried(i: int, pieces: "Sequence[Any]", matrices: Any, scene: Any) -> Line:
    """Equation of what members are tied to: M q̈ + C q̇ + K q = forces of the members."""
    acting = [(node, Name(scene.q[j].name + "'" * (2 - kind))) for kind, matrix in enumerate(matrices)
              for (row, j), node in matrix.items() if row == i]
    return line(*(terms_of(acting) or ["0"]), " = ", *(terms_of(_pulls(i, pieces, scene)) or ["0"]),
                label=Name(scene.q[i].name))


def _pulls(i: int, pieces: "Sequence[PlacedPiece]", scene: "Scene") -> Any:
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


def terms_of(terms: "Iterable[tuple[Node, Any]]") -> "list[Factor | Name | Node | str | Words]":
    """Σ coefficient·text as parts of a formula, without what is zero."""
    parts: list[Any] = []
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
