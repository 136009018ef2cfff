"""Pieces of members at rest under loads q(x) of any form: what they put on the ends, and the deflection between.

    Fᵢ = ∫ q Nᵢ dx, Nᵢ the deflection with the i-th end value 1: where it is a polynomial integrated by parts, if q is a
    sum of powers, exponentials and sines, else by Gauss's rule.

Within a piece the deflection is found where it is cut: both parts take what is spread on them.
"""

from functools import partial
from typing import TYPE_CHECKING

from vibcli.elements.graded_beam import graded_shapes, graded_stiffness, plainly
from vibcli.elements.member_springs import springs_across, springs_along
from vibcli.elements.rest_shapes import basis_at, shares
from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.quadrature import rule_for, weighed

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.elements.rest_shapes import RestPiece
    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.quadrature import WeightedPlace


def end_forces(scene: "Builder | Scene", piece: "RestPiece", parts: "Sequence[Node]", x: "Node") -> "list[list[Node]]":
    """[Fᵢ of each end value] of each of `parts`, q(x) counted from the left end of a piece. NotSmooth of functions that
    no rule integrates."""
    found: list[list[Node] | None] = [by_parts(scene, piece, q, x) if piece.plain else None for q in parts]
    left = [q for q, known in zip(parts, found, strict=True) if known is None]
    if left:
        rule = rule_for(left, x, (scene.table.zero, piece.length), scene.sample, piece.longest(scene))
        by_rule = _under_graded if piece.graded else _under
        for i, q in enumerate(parts):
            if found[i] is None:
                found[i] = by_rule(scene, piece, rule, partial(weighed, q, x, rule))
    return found


def _under(scene: "Builder | Scene", piece: "RestPiece", rule: "Sequence[WeightedPlace]",
           integrated: "Callable[[Sequence[Node]], Node]") -> "list[Node]":
    basis = zip(*(basis_at(scene, piece, one.place) for one in rule), strict=True)
    sums = [integrated(values) for values in basis]
    return [scene.table.total([c * one for c, one in zip(row, sums, strict=True)])
            for row in zip(*shares(scene, piece), strict=True)]


def _under_graded(scene: "Builder | Scene", piece: "RestPiece", rule: "Sequence[WeightedPlace]",
                  integrated: "Callable[[Sequence[Node]], Node]") -> "list[Node]":
    return plainly(scene, lambda: [
        scene.table.defined(f"held.F{i}", integrated(shape)) for i, shape in enumerate(zip(*graded_shapes(
            scene, "held", piece.numbers, [one.place for one in rule]), strict=True))])


def by_parts(scene: "Builder | Scene", piece: "RestPiece", q: "Node", x: "Node") -> "list[Node] | None":
    """∫₀ˡ q N dx, N being a polynomial: Σ (−1)ᵏ N⁽ᵏ⁾ q₍₋ₖ₋₁₎ between the ends; None where no rule gives it."""
    found, integrals, zero = [], [q], scene.table.zero
    for shape in zip(*shares(scene, piece), strict=True):
        shape = scene.table.total([c * power for c, power in zip(shape, basis_at(scene, piece, x), strict=True)])
        total, sign, k = zero, 1, 1
        while not shape.is_zero:
            if k == len(integrals):
                integrals.append(from_zero(integrals[-1], x))
            if integrals[k] is None:
                return None
            there, here = (substitute([shape * integrals[k]], {x: place})[0] for place in (piece.length, zero))
            total = total + sign * (there - here)
            shape, sign, k = gradient(shape).get(x, zero), -sign, k + 1
        found.append(total)
    return found


def held_deflection(scene: "Builder | Scene", piece: "RestPiece", q: "Node", x: "Node", at: "Node",
                    order: int) -> "Node":
    """u at a place of a piece whose ends are held, or a derivative of it."""
    place, length, half = scene.number(at), scene.number(piece.length), 2 if piece.bends else 1
    zero = scene.table.zero
    if not 1e-12 * length < place < (1 - 1e-12) * length:
        forces, = end_forces(scene, piece, [q], x)
        pulled = forces[:half] if place < length / 2 else [-force for force in forces[half:]]
        return _of_state(piece, at, [zero] * half, pulled, order)
    left = piece._replace(length=at)
    right = piece._replace(length=piece.length - at, tension=piece.tension + piece.gradient * at)
    beyond, = substitute([q], {x: at + x})
    own, = end_forces(scene, left, [q], x)
    other, = end_forces(scene, right, [beyond], x)
    own, other = own[half:], other[:half]
    stiff, stiff_right = _stiffness(scene, left, half), _stiffness(scene, right, 0)
    both = [[a + b for a, b in zip(*rows, strict=True)] for rows in zip(stiff, stiff_right, strict=True)]
    moved = _solved(both, [a + b for a, b in zip(own, other, strict=True)])
    pulled = [scene.table.total([k * u for k, u in zip(row, moved, strict=True)]) - force
              for row, force in zip(stiff, own, strict=True)]
    return _of_state(piece, at, moved, pulled, order)


def _of_state(piece: "RestPiece", at: "Node", moved: "list[Node]", pulled: "list[Node]", order: int) -> "Node":
    """From (u) and (N u′), of beams (u, u′) and (N u′ − B u‴, B u″)."""
    if order < len(moved):
        return moved[order]
    tension = piece.tension + piece.gradient * at
    if not piece.bends:
        return pulled[0] / tension
    return pulled[1] / piece.bending if order == 2 else (tension * moved[1] - pulled[0]) / piece.bending


def _stiffness(scene: "Builder | Scene", piece: "RestPiece", first: int) -> "list[list[Node]]":
    """That of one end, its end values from the `first` on."""
    count = 4 if piece.bends else 2
    if piece.graded:
        return [row[first:first + 2] for row in graded_stiffness(scene, piece.numbers)[first:first + 2]]
    ends = [scene.table.variable(f"end value {i}") for i in range(count)]
    if piece.bends:
        springs = springs_across(scene, piece.length, piece.bending, piece.tension, piece.foundation, ends)
    else:
        springs = springs_along(scene, piece.length, piece.tension, piece.foundation, ends, piece.gradient)
    own, zero = ends[first:first + count // 2], scene.table.zero
    slopes = [(k, [gradient(stretch).get(end, zero) for end in own]) for k, stretch in springs]
    return [[scene.table.total([k * row[i] * row[j] for k, row in slopes]) for j in range(len(own))]
            for i in range(len(own))]


def _solved(matrix: "list[list[Node]]", forces: "list[Node]") -> "list[Node]":
    if len(forces) == 1:
        return [forces[0] / matrix[0][0]]
    (a, b), (c, d) = matrix
    determinant = a * d - b * c
    return [(d * forces[0] - b * forces[1]) / determinant, (a * forces[1] - c * forces[0]) / determinant]
