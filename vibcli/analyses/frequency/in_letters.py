"""Amplitudes in letters, for one and two degrees of freedom: H(iΩ) = (N_r + iΩ N_i)/(D_r + iΩ D_i).

By Cramer's rule from D = K − Ω²M + iΩC: N = cᵀ adj(D) b + d det D. Products of entries are not multiplied out, which is
how a textbook prints them. |H|² = (N_r² + Ω²N_i²)/(D_r² + Ω²D_i²), tan θ = Ω (N_r D_i − N_i D_r)/(N_r D_r + Ω²N_i D_i).
"""

from vibcli.algebra.calculus import gradient, substitute
from vibcli.algebra.copied import copied
from vibcli.algebra.normal import textbook
from vibcli.algebra.quotient import shorter
from vibcli.algebra.rationals import ONE
from vibcli.errors import NotInLetters
from vibcli.mechanics.linear_letters import coefficients

SQUARE = "Omega squared"        # the symbol of Ω² while a formula is being made


class Formula:
    """numerator and denominator: (real part, imaginary part over Ω) as nodes in Ω; `order`: of the derivative;
    `short`: of one degree of freedom."""

    __slots__ = ("Omega", "denominator", "numerator", "order", "poles", "short", "table", "zeros")

    def __init__(self, table, Omega, numerator, denominator, order, short):
        w, square = table.variable(SQUARE), {table.variable(SQUARE): Omega * Omega}
        self.table, self.Omega, self.order, self.short = table, Omega, order, short
        self.poles, self.zeros = (_root(parts, w) for parts in (denominator, numerator))
        self.numerator = tuple(substitute(list(map(_simple, numerator)), square))
        self.denominator = tuple(substitute([denominator[0], _simple(denominator[1])], square))

    @property
    def undamped(self):
        return self.numerator[1].is_zero and self.denominator[1].is_zero

    @property
    def amplitude(self):
        """|H|; without damping H itself, whose sign tells the phase."""
        if self.undamped and self.order % 2 == 0:
            sign = -ONE if self.order % 4 else ONE
            return self.table.scaled(self._times(self.numerator[0] / self.denominator[0]), sign)
        return self._times(self._size(self.numerator) / self._size(self.denominator))

    def _times(self, node):
        return node * self.Omega**self.order if self.order else node

    def _size(self, parts):
        real, imaginary = parts
        if imaginary.is_zero:
            return real if not real.mask and self.table.is_positive(real) else self.table.sqrt(real * real)
        if real.is_zero:
            return self.table.sqrt(imaginary * imaginary) * self.Omega
        return self.table.sqrt(real * real + (self.Omega * imaginary) ** 2)

    @property
    def tangent(self):
        """tan θ of the lag θ = −arg H of the undifferentiated output; None where θ is a right angle everywhere."""
        (a, b), (c, d) = self.numerator, self.denominator
        above, below = a * d - b * c, a * c + self.Omega * self.Omega * b * d
        if not self.numerator[1].is_zero:
            above, below = _simple(above), _simple(below) if self.short else below
        if below.is_zero:
            return None
        return self.Omega * above / below


def formula(problem, signal, driven_by, frequency="Omega", order=0):
    """The Formula of a signal for a unit of a named input; `frequency`: the letter of Ω."""
    if len(problem.scene.q) > 2:
        raise NotInLetters("amplitudes in letters are found for one and two degrees of freedom",
                           "give numbers with --set")
    table = problem.scene.table
    b, c, d = (_copied(part, table) for part in coefficients(problem, signal, driven_by))
    M, C, G, K = problem.matrices_in_letters
    n, w, zero = len(problem.scene.q), table.variable(SQUARE), table.zero
    D = [[(textbook(K.get((i, j), zero) - w * M.get((i, j), zero)), C.get((i, j), zero) + G.get((i, j), zero))
          for j in range(n)] for i in range(n)]
    b, c = ([_pair(part, i, w, zero) for i in range(n)] for part in (b, c))
    det = D[0][0] if n == 1 else _minus(_times(D[0][0], D[1][1], w), _times(D[0][1], D[1][0], w))
    parts = [_times(_times(c[i], _adjugate(D, i, j, zero), w), b[j], w) for i in range(n) for j in range(n)]
    direct = _pair(d, 0, w, zero)
    if not all(part.is_zero for part in direct):
        parts.append(_times(direct, det, w))
    numerator = tuple(table.sum(*((part[k], ONE) for part in parts)) for k in (0, 1))
    return Formula(table, table.parameter(frequency), numerator, det, order, n == 1)


def _simple(node):
    return shorter(textbook(node))


def _copied(parts, table):
    return [dict(zip(part, copied(list(part.values()), table), strict=True)) for part in parts]


def _pair(parts, i, w, zero):
    """(even, odd over iΩ) of entry i of a polynomial in s, s² = −Ω²."""
    zeroth, first, second = (part.get(i, zero) for part in parts)
    return zeroth - w * second, first


def _times(one, two, w):
    (a, b), (c, d) = one, two
    return a * c - w * (b * d), a * d + b * c


def _minus(one, two):
    return one[0] - two[0], one[1] - two[1]


def _adjugate(D, i, j, zero):
    """Entry (i, j) of adj D."""
    if len(D) == 1:
        return zero + 1, zero
    if i == j:
        return D[1 - i][1 - i]
    return -D[i][j][0], -D[i][j][1]


def _root(parts, w):
    """Ω at which an undamped part vanishes, where it is linear in Ω²; None elsewhere."""
    real, imaginary = parts
    real = textbook(real)
    slope = gradient(real).get(w)
    if not imaginary.is_zero or slope is None or slope.mask & w.mask:
        return None
    square = _simple(-(substitute([real], {w: w.table.zero})[0] / slope))
    return None if square.is_zero else w.table.sqrt(square)
