"""Amplitudes in letters, for one and two degrees of freedom: H(iΩ) = s (N_r + iΩ N_i)/(D_r + iΩ D_i).

By Cramer's rule from D = K − Ω²M + iΩC: s N = cᵀ adj(D) b + d det D, s the letters that all of it has in common.
Products of entries are not multiplied out, and sums have the sign that they have at rest, Ω → 0, which is how a
textbook prints them. |H| = s √((N_r² + Ω²N_i²)/(D_r² + Ω²D_i²)), tan θ = Ω (N_r D_i − N_i D_r)/(N_r D_r + Ω²N_i D_i).
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_linear import coefficients
from vibcli.symbolic.common_denominator import shorter, single
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import TooLong, expanded, textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE, ZERO
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from typing import TypeVar

    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.symbolic.node import Node

    Place = TypeVar("Place", int, tuple[int, int])

SQUARE = "Omega squared"        # the symbol of Ω² while a formula is being made
MOST = 2                        # degrees of freedom
SLOW = 1e-4                     # Ω where signs are looked at, relative to its sample value


class Peak(NamedTuple):
    """Ω of a maximum, which there is where `less` < `more`."""

    Omega: Any
    less: Any
    more: Any


class Formula:
    """scale s; numerator N and denominator D: (real part, imaginary part over Ω) as nodes in Ω; poles, zeros: Ω of an
    undamped resonance and antiresonance where there is one; peak: the Peak of one damped degree of freedom, or None;
    `order`: of the derivative; `short`: of one degree."""

    __slots__ = ("Omega", "denominator", "numerator", "order", "peak", "poles", "scale", "short", "table", "zeros")

    def __init__(self, table: Table, Omega: "Node", numerator: "tuple[Node, Node]", denominator: "tuple[Node, Node]",
                 order: int, short: bool) -> None:
        w, square = table.variable(SQUARE), {table.variable(SQUARE): Omega * Omega}
        self.table, self.Omega, self.order, self.short = table, Omega, order, short
        nothing = _nothing(numerator)
        self.poles, self.zeros = (None if nothing else _root(pair, w) for pair in (denominator, numerator))
        self.scale = _common(table, numerator)
        real, imaginary = substitute([denominator[0], _simple(denominator[1])], square)
        self.denominator = real, imaginary
        parts = [_simple(part / self.scale) for part in numerator]
        real, imaginary = substitute(parts, square)
        self.numerator = real, imaginary
        peaked = short and not order and not nothing
        self.peak = _peak(self.scale, Omega, parts, denominator, w) if peaked else None

    @property
    def vanishes(self) -> bool:
        """Does the input not reach the output at all?"""
        return _nothing(self.numerator)

    @property
    def undamped(self) -> bool:
        return self.numerator[1].is_zero and self.denominator[1].is_zero

    @property
    def ahead(self) -> bool:
        """Is H imaginary: that of a rate without damping?"""
        return self.numerator[0].is_zero and self.denominator[1].is_zero and not self.numerator[1].is_zero

    @property
    def amplitude(self) -> "Node":
        """|H|; without damping H itself, or H/i of a rate, whose sign tells the phase."""
        scale = self.scale * self.Omega**self.order if self.order else self.scale
        if self.undamped and self.order % 2 == 0:
            sign = -ONE if self.order % 4 else ONE
            return self.table.scaled(scale * self.numerator[0] / self.denominator[0], sign)
        if self.ahead and not self.order:
            return scale * self.Omega * self.numerator[1] / self.denominator[0]
        scale = scale if self.table.is_positive(scale) else self.table.call("abs", scale)
        return scale * self._size_above() / self._size(self.denominator)

    def _size_above(self) -> "Node":
        """√(N_r² + Ω²N_i²), without the powers of Ω, or all but a number, that both have in common."""
        real, turned = self.numerator[0], textbook(self.Omega * self.numerator[1])
        if real.is_zero or turned.is_zero:
            return self._size(self.numerator)
        if (ratio := _simple(turned / real)).op == "number":
            return self.table.sqrt(1 + ratio**2) * self._size((real, self.table.zero))
        shared = _common(self.table, (textbook(real), turned))
        if shared is self.table.one or not self.table.is_positive(shared):
            return self._size(self.numerator)
        return shared * self.table.sqrt(_simple(real / shared) ** 2 + _simple(turned / shared) ** 2)

    @property
    def square(self) -> "tuple[Node, Node]":
        """(above, below) of |H|², polynomials in Ω."""
        squares = [real * real + (self.Omega * imaginary) ** 2 for real, imaginary in (self.numerator,
                                                                                      self.denominator)]
        return squares[0] * (self.scale * self.Omega**self.order) ** 2, squares[1]

    def _size(self, parts: "tuple[Node, Node]") -> "Node":
        real, imaginary = parts
        if imaginary.is_zero:
            return real if not real.mask and self.table.is_positive(real) else self.table.sqrt(real * real)
        if real.is_zero:
            return self.table.sqrt(imaginary * imaginary) * self.Omega
        return self.table.sqrt(real * real + (self.Omega * imaginary) ** 2)

    @property
    def side(self) -> int | None:
        """The sign of sin θ, where no letter decides about it."""
        (a, b), (c, d) = self.numerator, self.denominator
        above = self.scale * self.Omega * (a * d - b * c)
        return next((sign for sign in (1, -1) if self.table.is_positive(above if sign > 0 else -above)), None)

    @property
    def tangent(self) -> "Node | None":
        """tan θ of the lag θ = −arg H of the undifferentiated output; None where θ is a right angle everywhere."""
        (a, b), (c, d) = self.numerator, self.denominator
        above, below = a * d - b * c, a * c + self.Omega * self.Omega * b * d
        if not self.numerator[1].is_zero:
            above, below = _simple(above), _simple(below) if self.short else below
        if below.is_zero:
            return None
        found = self.Omega * above / below
        return min(found, single(found), key=letters) if self.numerator[1].is_zero else found


def formula(symbolic: "SymbolicSystem", signal: Any, driven_by: str, frequency: "str | Node" = "Omega",
            order: int = 0) -> Formula:
    """The Formula of a signal for a unit of a named input; `frequency`: Ω as a node, or its letter."""
    require_few(symbolic.system)
    return from_parts(symbolic, *coefficients(symbolic, signal, driven_by),
                      symbolic.scene.table.parameter(frequency) if isinstance(frequency, str) else frequency, order)


def require_few(system: "MechanicalSystem") -> None:
    """NotInLetters of more than two degrees of freedom."""
    if len(system.scene.q) > MOST:
        raise NotInLetters("amplitudes in letters are found for one and two degrees of freedom",
                           "give numbers with --set")


def from_parts(symbolic: "SymbolicSystem", b: "Sequence[dict[int, Any]]", c: "Sequence[dict[int, Node]]",
               d: "Sequence[dict[int, Any]]", Omega: "Node", order: int = 0) -> Formula:
    """The Formula of H = cᵀ D⁻¹ b + d, each [{i: node}] of the powers of s = iΩ; d has the one entry 0."""
    table = Table(squares_at_sample=True)
    *_, Omega = copied([*symbolic.scene.parameters.nodes.values(), Omega], table)    # letters in the order of the scene
    matrices = [_copied([entries], table)[0] for entries in symbolic.matrices]
    M, C, G, K = matrices
    table.resample(_slowly(symbolic.scene.sample, Omega, matrices))
    b, c, d = (_copied(part, table) for part in (b, c, d))
    n, w, zero = len(symbolic.scene.q), table.variable(SQUARE), table.zero
    D = [[(textbook(K.get((i, j), zero) - w * M.get((i, j), zero)), C.get((i, j), zero) + G.get((i, j), zero))
          for j in range(n)] for i in range(n)]
    b, c = ([_pair(part, i, w, zero) for i in range(n)] for part in (b, c))
    part = _taking_part(D, b, c)
    D, b, c, n = [[D[i][j] for j in part] for i in part], [b[i] for i in part], [c[i] for i in part], len(part)
    det = _determinant(D, w)
    if _nothing(det):
        raise PhysicsError("something moves here that has neither inertia nor stiffness nor damping: its response to a "
                           "force is not finite", "give it a mass, tie it with a spring, or take it out")
    parts = [_times(_times(c[i], _adjugate(D, i, j, zero), w), b[j], w) for i in range(n) for j in range(n)]
    direct = _pair(d, 0, w, zero)
    if not all(part.is_zero for part in direct):
        parts.append(_times(direct, det, w))
    real, imaginary = (table.sum(*((part[k], ONE) for part in parts)) for k in (0, 1))
    return Formula(table, Omega, (real, imaginary), det, order, n == 1)


def _determinant(D: "Sequence[list[tuple[Node, Node]]]", w: "Node") -> "tuple[Node, Node]":
    return D[0][0] if len(D) == 1 else _minus(_times(D[0][0], D[1][1], w), _times(D[0][1], D[1][0], w))


def _slowly(sample: Mapping[str, float], Omega: "Node",
            matrices: "Sequence[dict[tuple[int, int], Node]]") -> dict[str, float]:
    """Sample values with Ω near zero, where letters of its own make it."""
    held = set(reachable([node for entries in matrices for node in entries.values()]))
    own = {part.name for part in reachable([Omega]) if part.op == "symbol" and part not in held}
    return {name: value * SLOW if name in own else value for name, value in sample.items()} | {
        name: SLOW for name in own if name not in sample}


def _common(table: Table, nodes: "tuple[Node, Node]") -> "Node":
    """The letters that all terms of the nodes have in common."""
    try:
        monomials = [dict(monomial) for node in nodes for monomial in expanded(node)]
    except (TooLong, ZeroDivisionError):
        return table.one
    shared = [atom for atom in (monomials[0] if monomials else ()) if not atom.mask and atom.op == "symbol"]
    least = ((atom, min(monomial.get(atom, ZERO) for monomial in monomials)) for atom in shared)
    return table.product(*((atom, e) for atom, e in least if e > 0))


def _simple(node: "Node") -> "Node":
    return shorter(textbook(node))


def _copied(parts: "Sequence[Mapping[Place, Node]]", table: Table) -> "list[dict[Place, Node]]":
    return [dict(zip(part, copied(list(part.values()), table), strict=True)) for part in parts]


def _pair(parts: "Sequence[dict[int, Node]]", i: int, w: "Node", zero: "Node") -> "tuple[Node, Node]":
    """(even, odd over iΩ) of entry i of a polynomial in s, s² = −Ω²."""
    zeroth, first, second = (part.get(i, zero) for part in parts)
    return zeroth - w * second, first


def _taking_part(D: "Sequence[list[tuple[Node, Node]]]", b: "Sequence[tuple[Node, Node]]",
                 c: "Sequence[tuple[Node, Node]]") -> "Sequence[int]":
    """The coordinates that H depends on: of two that are not coupled those that are driven and seen; one at least."""
    if len(D) == 1 or not _nothing(D[0][1], D[1][0]):
        return range(len(D))
    return [i for i in range(len(D)) if not _nothing(b[i]) and not _nothing(c[i])] or [0]


def _nothing(*pairs: "tuple[Node, Node]") -> bool:
    return all(part.is_zero for pair in pairs for part in pair)


def _times(one: "tuple[Node, Node]", two: "tuple[Node, Node]", w: "Node") -> "tuple[Node, Node]":
    (a, b), (c, d) = one, two
    return a * c - w * (b * d), a * d + b * c


def _minus(one: "tuple[Node, Node]", two: "tuple[Node, Node]") -> "tuple[Node, Node]":
    return one[0] - two[0], one[1] - two[1]


def _adjugate(D: "Sequence[list[tuple[Node, Node]]]", i: int, j: int, zero: "Node") -> "tuple[Node, Node]":
    """Entry (i, j) of adj D."""
    if len(D) == 1:
        return zero + 1, zero
    if i == j:
        return D[1 - i][1 - i]
    return -D[i][j][0], -D[i][j][1]


def _root(parts: "tuple[Node, Node]", w: "Node") -> "Node | None":
    """Ω at which an undamped part vanishes, where it is linear in Ω² and not always of one sign; None elsewhere."""
    real, imaginary = parts
    real = textbook(real)
    slope = gradient(real).get(w)
    if not imaginary.is_zero or slope is None or slope.mask & w.mask:
        return None
    square = _simple(-(substitute([real], {w: w.table.zero})[0] / slope))
    return None if square.is_zero or w.table.is_positive(-square) else w.table.sqrt(square)


def _peak(scale: "Node", Omega: "Node", numerator: "Sequence[Node]", denominator: "tuple[Node, Node]",
          w: "Node") -> Peak | None:
    """The Peak of s/|k − mΩ² + iΩc|, for c² < 2km: Ω² = k/m − c²/(2m²), and 2k²/(2km − c²) where s, or what stands
    above, has the factor Ω²; None of other responses."""
    real, c = denominator
    slope, free = gradient(real).get(w), [scale, scale / (Omega * Omega)]
    above = numerator[0] if not numerator[0].mask else textbook(numerator[0] / w)
    held = [Omega in reachable([node, above, real, c]) for node in free]
    rises = above is not numerator[0]
    if c.is_zero or slope is None or slope.mask or not numerator[1].is_zero or above.mask or all(held) or (
            rises and held[0]):
        return None
    m, k = -slope, textbook(substitute([real], {w: w.table.zero})[0])
    if k.table.is_positive(textbook(c * c - 2 * k * m)):
        return None
    rises = rises or held[0]
    square = shorter(2 * k * k / (2 * k * m - c * c)) if rises else _simple(k / m) - textbook(c * c / (2 * m * m))
    Omega = root(square) if rises else w.table.sqrt(square)
    return Peak(Omega, textbook(c * c), textbook(2 * k * m))
