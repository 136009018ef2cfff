"""Deflections that members are assumed to have: what a scene stores and carries where it moves in them alone.

    K̂ᵢⱼ = ∫ (B fᵢ″fⱼ″ + N fᵢ′fⱼ′ + k fᵢfⱼ) dx + φᵢᵀK φⱼ      M̂ᵢⱼ = ∫ μ fᵢfⱼ dx + φᵢᵀM φⱼ      (Rayleigh 1877, Ritz 1909)

φ: the coordinates; those that hold to a member follow it, with f or f′ at their stations. Members without a function
deflect between their stations in lines, beams in cubics. All in mpmath's numbers, the integrals by Gauss' rules, of
which two have to agree.
"""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.modal.estimates import matrix_of
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.sections.initial import PLACE
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.base.errors import Where
    from vibcli.language.reader import Expression
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
    from vibcli.symbolic.node import Node

SAME, AGREED = mpmath.mpf("1e-30"), mpmath.mpf("1e-25")     # of the size; numbers have 60 digits
RULES = (4, 5, 6)           # Gauss' rules of 24, 48, 96 points


class AssumedShape(NamedTuple):
    """functions: {member: [f, f′, f″] of the place, for which the time of the scene stands}; amplitudes: {index of a
    coordinate: how far it moves} of those that are given; `where` it is written."""

    functions: dict[Any, Any]
    amplitudes: dict[Any, Any]
    where: "Where | None" = None


class Reduced(NamedTuple):
    """M̂, K̂ of assumed shapes, matrices of mpmath's; motions: for each shape {index of a coordinate: how far it moves},
    of those that do."""

    M: Any
    K: Any
    motions: list[Any]


def derivatives_of(modal: "ModalAnalysis", expression: "Expression") -> "list[Node]":
    """[f, f′, f″] of a function of the place x."""
    scene, found = modal.scene, [modal.scene.lower(expression, (PLACE, modal.scene.time))]
    for _ in range(2):
        found.append(gradient(found[-1]).get(scene.time, scene.table.zero))
    return found


def reduced(modal: "ModalAnalysis", elements: "FactoredSystem", shapes: "list[AssumedShape]") -> Reduced:
    """What is stored and carried in the shapes; PhysicsError where one does not fit what holds the members."""
    for shape in shapes:
        for name in shape.functions:
            _require_inertia(modal, elements, name, shape.where)
    bare = elements.with_parts(pieces=())
    M, _, _, K = (matrix_of(entries, elements.n) for entries in bare.matrices())
    fields = [_Fields(modal, shape) for shape in shapes]
    motions = [_motions(modal, elements, field) for field in fields]
    M, K = ([[_form(matrix, a, b) for b in motions] for a in motions] for matrix in (M, K))
    for placed in elements.pieces:
        rule, values = _integrable(placed, fields, motions)
        piece = placed.piece
        for i, f in enumerate(values):
            for j, g in enumerate(values):
                M[i][j] += piece.inertia * _sum(rule, f[0], g[0])
                K[i][j] += piece.foundation * _sum(rule, f[0], g[0]) + piece.bending * _sum(rule, f[2], g[2])
                tensions = [(x, w * (piece.tension + piece.gradient * x)) for x, w in rule]
                K[i][j] += _sum(tensions, f[1], g[1])
    return Reduced(mpmath.matrix(M), mpmath.matrix(K), motions)


class _Fields:
    """The functions of a shape in numbers."""

    def __init__(self, modal: "ModalAnalysis", shape: AssumedShape) -> None:
        self.shape, self.arithmetic = shape, multiprecision()
        self.values, self.time = modal.numeric.values(self.arithmetic), modal.scene.time.name
        self.bends = {name: modal.scene.members[name].kind.bends for name in shape.functions}

    def given(self, placed: "PlacedPiece") -> bool:
        """Is the deflection of a piece given? In the plane beams stretch besides."""
        owner = placed.owner
        return owner in self.bends and (placed.piece.order == 4) == self.bends[owner]

    def at(self, placed: "PlacedPiece", x: mpmath.mpf) -> list[mpmath.mpf]:
        """f, f′, f″ at the distance x from the left end of a piece."""
        values = {**self.values, self.time: placed.start + x}
        try:
            found = evaluate(self.shape.functions[placed.owner], self.arithmetic, values)
        except (ZeroDivisionError, ValueError, OverflowError):
            found = [mpmath.nan]
        if not all(mpmath.isfinite(y) and not mpmath.im(y) for y in found):
            raise PhysicsError(f"the deflection of '{placed.owner}' and its slopes are no real numbers at "
                               f"{float(placed.start + x):.6g} m", "a smooth function of x fits, such as x^2",
                               self.shape.where)
        return found

    def ends(self, placed: "PlacedPiece") -> list[mpmath.mpf]:
        """(u₀, u_l), of beams (u₀, u₀′, u_l, u_l′)."""
        half = len(placed.rows) // 2
        return [*self.at(placed, mpmath.mpf(0))[:half], *self.at(placed, placed.piece.length)[:half]]


def _require_inertia(modal: "ModalAnalysis", elements: "FactoredSystem", name: str, where: "Where | None") -> None:
    """Refuse a deflection of a member of which a part is springs."""
    member = modal.scene.members[name]
    length, = evaluate([member.length], multiprecision(), modal.numeric.values(multiprecision()))
    order = 4 if member.kind.bends else 2
    heavy = sum(placed.piece.length for placed in elements.pieces
                if placed.owner == name and placed.piece.order == order)
    if abs(heavy - length) > 1e-9 * length:
        raise PhysicsError(f"'{name}' or a part of it has no inertia: it deflects as at rest, not as assumed",
                           "give `rho` or its inertia per length", where)


def _motions(modal: "ModalAnalysis", elements: "FactoredSystem", fields: _Fields) -> dict[int, mpmath.mpf]:
    """{index of a coordinate: how far it moves}: those given, and those that follow the members."""
    found, where = dict(fields.shape.amplitudes), fields.shape.where
    rows = [(placed, i, row, end) for placed in elements.pieces if fields.given(placed)
            for i, (row, end) in enumerate(zip(placed.rows, fields.ends(placed), strict=True))]
    sizes = [max(map(abs, (row[3] for row in rows if row[1] % 2 == part)), default=0) for part in (0, 1)]
    while rows:
        left = []
        for placed, i, row, end in rows:
            rest = end - sum(x * found[j] for j, x in row.items() if j in found)
            free = [j for j in row if j not in found]
            if len(free) == 1:
                found[free[0]] = rest / row[free[0]]
            elif free:
                left.append((placed, i, row, end))
            elif abs(rest) > SAME * (1 + max(sizes)):
                raise _contradiction(placed, i, row, end, where)
        if len(left) == len(rows):
            names = ", ".join(modal.scene.coordinates[j] for j in left[0][2] if j not in found)
            raise PhysicsError(f"how {names} follow the deflection of '{left[0][0].owner}' is not settled by it",
                               "give how far they move in a shape of `ritz`", where)
        rows = left
    return found


def _contradiction(placed: "PlacedPiece", i: int, row: Mapping[Any, Any], end: mpmath.mpf,
                   where: "Where | None") -> PhysicsError:
    half = len(placed.rows) // 2
    place = placed.start + (placed.piece.length if i >= half else 0)
    what = "has the slope" if half == 2 and i % 2 else "is"
    held = "held to what moves otherwise" if row else "held"
    return PhysicsError(f"'{placed.owner}' is {held} at {float(place):.6g} m, where this deflection {what} "
                        f"{float(end):.6g}", "a deflection fits the supports: x^2 fits what is clamped at x = 0",
                        where)


def _integrable(placed: "PlacedPiece", fields: Sequence[_Fields], motions: Sequence[dict[int, mpmath.mpf]]
                ) -> tuple[list[tuple[mpmath.mpf, mpmath.mpf]], list[list[tuple[mpmath.mpf, ...]]]]:
    """(rule [(x, weight)], values [f, f′, f″] at its points of each shape) of a piece, two rules agreeing."""
    before = None
    for degree in RULES:
        rule = [((1 + x) * placed.piece.length / 2, w * placed.piece.length / 2)
                for x, w in _gauss(degree, mpmath.mp.prec)]
        values = [_along(placed, field, moved, rule) for field, moved in zip(fields, motions, strict=True)]
        sums = [[sum(w * y for (_, w), y in zip(rule, f[0], strict=True)), *(_sum(rule, part, part) for part in f)]
                for f in values]
        wrong = next((fields[i] for i in range(len(values)) if not _agree(
            placed, fields[i], rule, values[i], sums[i], before and before[i])), None)
        if wrong is None:
            return rule, values
        before = sums
    raise PhysicsError(f"this deflection of '{placed.owner}' is not smooth between "
                       f"{float(placed.start):.6g} m and {float(placed.start + placed.piece.length):.6g} m: "
                       "what it stores is not found", "a smooth function of x fits, such as x^2", wrong.shape.where)


def _agree(placed: "PlacedPiece", field: _Fields, rule: Sequence[tuple[mpmath.mpf, mpmath.mpf]],
           values: Sequence[tuple[mpmath.mpf, ...]], sums: list[mpmath.mpf], before: list[mpmath.mpf] | None) -> bool:
    """Do two rules agree, and do f and f′ at the ends differ by the integrals of their slopes?"""
    if before is None:
        return False
    size = 1 + max(map(abs, values[0]))
    if abs(sums[0] - before[0]) > AGREED * size * placed.piece.length:
        return False
    stores = sums[1:3] + ([sums[3]] if placed.piece.order == 4 else [])
    if any(abs(x - y) > AGREED * abs(x) for x, y in zip(stores, before[1:], strict=False)):
        return False
    if not field.given(placed):
        return True
    left, right = field.at(placed, mpmath.mpf(0)), field.at(placed, placed.piece.length)
    for k in range(placed.piece.order // 2):
        total = [w * y for (_, w), y in zip(rule, values[k + 1], strict=True)]
        if abs(right[k] - left[k] - sum(total)) > AGREED * (sum(map(abs, total)) + abs(right[k]) + abs(left[k])):
            return False
    return True


def _along(placed: "PlacedPiece", field: _Fields, moved: Mapping[int, mpmath.mpf],
           rule: Sequence[tuple[mpmath.mpf, mpmath.mpf]]) -> list[tuple[mpmath.mpf, ...]]:
    """[f, f′, f″] at the points of a rule."""
    if field.given(placed):
        found = [field.at(placed, x) for x, _ in rule]
    else:
        ends = [sum(x * moved.get(j, 0) for j, x in row.items()) for row in placed.rows]
        found = [_between(ends, x / placed.piece.length, placed.piece.length) for x, _ in rule]
    return list(zip(*found, strict=True))


def _between(ends: Sequence[Any], r: Any, length: Any) -> Any:
    """Of a line or a cubic with these ends."""
    if len(ends) == 2:
        return ends[0] + (ends[1] - ends[0]) * r, (ends[1] - ends[0]) / length, mpmath.mpf(0)
    u, a, b = ends[0], ends[1] * length, ends[3] * length
    c, d = 3 * (ends[2] - u) - 2 * a - b, a + b - 2 * (ends[2] - u)
    return u + r * (a + r * (c + r * d)), (a + r * (2 * c + 3 * r * d)) / length, (2 * c + 6 * r * d) / length**2


@cache
def _gauss(degree: int, precision: int) -> Any:
    """[(x, weight)] on [−1, 1]."""
    return mpmath.calculus.quadrature.GaussLegendre(mpmath.mp).calc_nodes(degree, precision)


def _sum(rule: Sequence[tuple[mpmath.mpf, mpmath.mpf]], f: tuple[mpmath.mpf, ...],
         g: tuple[mpmath.mpf, ...]) -> mpmath.mpf:
    return sum(w * x * y for (_, w), x, y in zip(rule, f, g, strict=True))


def _form(matrix: mpmath.matrix, a: Mapping[int, mpmath.mpf], b: Mapping[int, mpmath.mpf]) -> mpmath.mpf:
    """aᵀ matrix b of motions."""
    return sum((x * matrix[i, j] * y for i, x in a.items() for j, y in b.items()), mpmath.mpf(0))
