"""Deflections of uniform pieces of members at rest, without loads of their own, between displacements of their ends.

    N u″ = k u:             u = u₀ sinh β(l − x)/sinh βl + u_l sinh βx/sinh βl, β² = k/N; linear without a foundation
    ((N + n x) u′)′ = 0:    u = u₀ + (u_l − u₀) log(1 + n x/N)/log(1 + n l/N)
    B u⁗ − N u″ + k u = 0:  even and odd solutions about the middle; without N and k cubic (Hermite)
"""

from fractions import Fraction
from math import factorial
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.member_springs import SMALL, even_solutions, odd_solutions, share_along

TERMS = 20      # of power series

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class RestPiece(NamedTuple):
    """Its length, whether it `bends`, B, N at its left end, N′, k: nodes of a scene."""

    length: "Node"
    bends: bool
    bending: "Node | None"
    tension: "Node"
    gradient: "Node"
    foundation: "Node"

    @property
    def plain(self) -> bool:
        """Does it deflect in a polynomial?"""
        return self.foundation.is_zero and self.gradient.is_zero and (not self.bends or self.tension.is_zero)

    @property
    def graded(self) -> bool:
        """Is it a beam whose tension varies along it?"""
        return self.bends and not self.gradient.is_zero

    @property
    def numbers(self) -> "list[Node]":
        """Its length, B, N, N′ and k."""
        return [self.length, self.bending, self.tension, self.gradient, self.foundation]

    def longest(self, scene: "Builder | Scene") -> float:
        """The length over which its deflections grow by e⁸ at the most."""
        tension, foundation = (abs(scene.number(node)) for node in (self.tension, self.foundation))
        if self.graded:
            tension = max(tension, abs(scene.number(self.tension + self.gradient * self.length)))
        if self.bends:
            bending = abs(scene.number(self.bending))
            rate: float = ((tension + 2 * (foundation * bending) ** 0.5) / bending) ** 0.5
        else:
            rate = (foundation / tension) ** 0.5 if tension else 0.0
        return min(scene.number(self.length), 8 / rate) if rate else scene.number(self.length)


def deflection(scene: "Builder | Scene", piece: RestPiece, at: "Node", order: int, ends: "Sequence[Node]") -> "Node":
    """u at a place, or a derivative, that the ends leave: {u₀, u_l}, of beams {u₀, θ₀, u_l, θ_l}."""
    if piece.plain:
        shapes = (_cubic if piece.bends else _linear)(scene, piece.length)
        return scene.table.total([_derivative(scene, shape, order, at) * end
                                  for shape, end in zip(shapes, ends, strict=True)])
    known = basis_at(scene, piece, at, order)
    return scene.table.total([value * scene.table.total([end * c for end, c in zip(ends, column, strict=True)])
                              for value, column in zip(known, shares(scene, piece), strict=True)])


def basis_at(scene: "Builder | Scene", piece: RestPiece, at: "Node", order: int = 0) -> "list[Node]":
    """Deflections of which all others are sums, or their derivatives, at a place."""
    call, one = scene.table.call, scene.table.one
    if piece.plain:
        return [_derivative(scene, [0] * k + [one], order, at) for k in range(4 if piece.bends else 2)]
    if piece.bends:
        return [found[order] for parity in (0, 1) for found in _solutions(scene, piece, at - piece.length / 2, parity)]
    if piece.gradient.is_zero:
        beta, rest = scene.table.sqrt(piece.foundation / piece.tension), piece.length - at
        if order:
            return [-beta * call("cosh", beta * rest), beta * call("cosh", beta * at)]
        return [call("sinh", beta * rest), call("sinh", beta * at)]
    if share_along(scene, piece.length, piece.tension, piece.gradient) is None:
        return [scene.table.zero if order else one]
    if order:
        return [scene.table.zero, piece.gradient / (2 * (piece.tension + piece.gradient * at))]
    return [one, share_along(scene, at, piece.tension, piece.gradient)]


def shares(scene: "Builder | Scene", piece: RestPiece) -> "list[list[Node]]":
    """How much of each of them end values of 1 leave, a row for each: {u₀, u_l}, of beams {u₀, θ₀, u_l, θ_l}."""
    zero, one, half = scene.table.zero, scene.table.one, piece.length / 2
    if piece.plain:
        return [list(row) for row in zip(*(_cubic if piece.bends else _linear)(scene, piece.length), strict=True)]
    if piece.bends:
        even, odd = (_parted(*_solutions(scene, piece, half, parity)) for parity in (0, 1))
        return [[value, -slope, value, slope] for value, slope in even] + [
            [-value, slope, value, slope] for value, slope in odd]
    if piece.gradient.is_zero:
        whole = scene.table.call("sinh", scene.table.sqrt(piece.foundation / piece.tension) * piece.length)
        return [[1 / whole, zero], [zero, 1 / whole]]
    whole = share_along(scene, piece.length, piece.tension, piece.gradient)
    if whole is None:       # an end without tension goes with the other
        return [[zero, one] if scene.number(piece.gradient) > 0 else [one, zero]]
    return [[one, zero], [-1 / whole, 1 / whole]]


def _parted(first: "tuple[Node, ...]", second: "tuple[Node, ...]") -> "list[tuple[Node, Node]]":
    """[(by half the value, by half the slope)] of two solutions of one parity at the right end."""
    (u, u1, *_), (w, w1, *_) = first, second
    below = 2 * (u * w1 - w * u1)
    return [(w1 / below, -w / below), (-u1 / below, u / below)]


def _linear(scene: "Builder | Scene", length: "Node") -> "list[list[Node]]":
    """Powers of x in the shapes of u₀ and u_l."""
    zero, one = scene.table.zero, scene.table.one
    return [[one, -1 / length], [zero, 1 / length]]


def _cubic(scene: "Builder | Scene", length: "Node") -> "list[list[Node]]":
    """Those of u₀, θ₀, u_l, θ_l."""
    zero, one = scene.table.zero, scene.table.one
    return [[one, zero, -3 / length**2, 2 / length**3], [zero, one, -2 / length, 1 / length**2],
            [zero, zero, 3 / length**2, -2 / length**3], [zero, zero, -1 / length, 1 / length**2]]


def _derivative(scene: "Builder | Scene", coefficients: "Sequence[Node | int]", order: int, x: "Node") -> "Node":
    """Of Σ cₖ xᵏ."""
    total, power = scene.table.zero, scene.table.one
    for k in range(order, len(coefficients)):
        factor = 1
        for i in range(order):
            factor *= k - i
        total, power = total + factor * coefficients[k] * power, power * x
    return total


def _solutions(scene: "Builder | Scene", piece: RestPiece, x: "Node", parity: int) -> "list[tuple[Node, ...]]":
    """Two even or two odd ones, as (u, u′, u″, u‴) at x; under little tension 1 or x and a power series."""
    ratio = piece.tension / piece.bending
    if not piece.foundation.is_zero or abs(scene.number(ratio * piece.length**2)) > 4 * SMALL:
        of = piece.bending, piece.tension, piece.foundation
        return (odd_solutions if parity else even_solutions)(scene, x, *of)
    zero, one = scene.table.zero, scene.table.one
    plain = (x, one, zero, zero) if parity else (one, zero, zero, zero)
    return [plain, tuple(_series(scene, ratio * x * x, 2 + parity - k) * x ** max(2 + parity - k, 0)
                         if k < 3 + parity else ratio * x * _series(scene, ratio * x * x, 1) for k in range(4))]


def _series(scene: "Builder | Scene", y: "Node", n: int) -> "Node":
    """Σ yᵏ/(2k + n)!."""
    terms, size = [], factorial(n)
    for k in range(TERMS):
        terms.append((y**k, Fraction(1, size)))
        size *= (2 * k + n + 1) * (2 * k + n + 2)
    return scene.table.sum(*terms)
