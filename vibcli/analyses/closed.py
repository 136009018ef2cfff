"""Natural frequencies in letters: the characteristic polynomial det(K − λM), factored, its roots where readable.

One degree: ω = √(K/M). Factors of degree one and two in λ = ω² are solved; a factor of higher degree is left as a
polynomial. Every root is checked in numbers at sample values before it is shown.
"""

from math import gcd

from vibcli.algebra.evaluate import Floats, evaluate, from_sympy, sympy_arithmetic
from vibcli.algebra.expression import reachable
from vibcli.algebra.normal import TooLong, expanded, factors_of, reduced, textbook
from vibcli.algebra.rationals import HALF, ONE

LARGEST, LONGEST, READABLE, COFACTORS = 6, 400, 24, 4


class ClosedMode:
    """ω² and ω as expressions; shape: amplitudes by coordinate with the first one 1, or None."""

    __slots__ = ("omega", "shape", "square")

    @property
    def readable(self):
        return self.shape is not None and all(len(reachable([part])) <= READABLE for part in self.shape)

    def __init__(self, square, omega, shape):
        self.square, self.omega, self.shape = square, omega, shape


class ClosedForms:
    """modes: ascending at the sample values; polynomial: unsolved factors in λ = ω², or None; zeta, omega_d of one
    degree; ratio: the amplitude ratio of two degrees as a function of ω."""

    __slots__ = ("modes", "omega_d", "polynomial", "ratio", "zeta")

    def __init__(self, modes, polynomial=None, zeta=None, omega_d=None, ratio=None):
        self.modes, self.polynomial, self.zeta, self.omega_d, self.ratio = modes, polynomial, zeta, omega_d, ratio


def closed_forms(problem):
    """The ClosedForms of a scene whose small oscillations are known in letters; None where they are too long."""
    if not problem.linear_in_letters:
        return None
    scene = problem.scene
    M, C, G, K = problem.matrices_in_letters
    n, zero = len(scene.q), scene.table.zero
    if n == 1:
        return _one_degree(scene, M.get((0, 0), zero), C.get((0, 0), zero), K.get((0, 0), zero))
    if n > LARGEST or G:
        return None
    return _several(scene, M, K, n)


def _one_degree(scene, m, c, k):
    table = scene.table
    if m.is_zero:
        return None
    square = ratio(k, m)
    if k.is_zero:
        return ClosedForms([ClosedMode(table.zero, table.zero, [table.one])])
    modes = [ClosedMode(square, root_of(square, scene.sample), [table.one])]
    if c.is_zero:
        return ClosedForms(modes)
    zeta = ratio(c, table.number(2) * root_of(m * k, scene.sample))
    if evaluate([square], Floats, scene.sample)[0] <= 0:
        return ClosedForms(modes)
    decay = ratio(c, 2 * m)
    return ClosedForms(modes, zeta=zeta, omega_d=table.sqrt(square - decay * decay))


def ratio(above, below):
    """above/below with common factors cancelled."""
    table = above.table
    return table.product((textbook(above), ONE), (textbook(below), -ONE))


def root_of(node, sample=None):
    """√node, factor by factor; a perfect square gives its root, positive at the sample values."""
    table = node.table
    if node.is_zero:
        return node
    pieces = node.args if node.op == "product" else ((node, ONE),)
    factors = [(table.sqrt(table.number(node.coefficient if node.op == "product" else 1)), ONE)]
    for base, exponent in pieces:
        try:
            inner = factors_of(table, reduced(expanded(base)))
        except TooLong:
            inner = ((base, ONE),)
        for part, power in inner:
            negative = power == 2 and evaluate([part], Floats, sample or {})[0] < 0
            factors.append((-part if negative else part, power * exponent * HALF))
    return table.product(*factors)


def _several(scene, M, K, n):
    import sympy

    arithmetic = sympy_arithmetic()
    symbols = {}
    for name, node in scene.parameters.nodes.items():
        symbols[name] = sympy.Symbol(name, positive=node in scene.table.positive, real=True)
    back = {symbol: scene.parameters.nodes[name] for name, symbol in symbols.items()}
    nodes = [matrix.get((i, j), scene.table.zero) for matrix in (M, K) for i in range(n) for j in range(n)]
    values = evaluate(nodes, arithmetic, symbols)
    mass, stiffness = (sympy.Matrix(n, n, values[k * n * n:(k + 1) * n * n]) for k in (0, 1))
    if sum(entry.count_ops() for entry in values) > LONGEST:
        return None
    unknown = sympy.Symbol("lambda_", real=True)
    polynomial = sympy.expand((stiffness - unknown * mass).det(method="berkowitz"))
    roots, left = [], []
    for factor, power in sympy.factor_list(polynomial, unknown)[1]:
        degree = sympy.degree(factor, unknown)
        if degree > 2:
            left.append(factor)
        elif degree:
            whole = sympy.Poly(factor, unknown).all_coeffs()
            coefficients = [textbook(from_sympy(scene.table, c, back)) for c in whole]
            roots += quadratic_roots(coefficients, scene.sample) * power
    if left:
        return ClosedForms([], polynomial=_polynomial(scene, left, unknown, back))
    found = sorted(((evaluate([node], Floats, scene.sample)[0], node) for node in roots), key=lambda pair: pair[0])
    if not _agrees(scene, M, K, n, [value for value, _ in found]):
        return None
    modes, ratio_of_omega = [], None
    if n == 2:
        shapes = [_shape(scene, M, K, i, [node for _, node in found]) for i in range(2)]
        if roots[0] is not roots[1] and any((0, 1) in matrix for matrix in (M, K)):
            ratio_of_omega = _ratio(scene, M, K, scene.table.variable("ω") ** 2)
    else:
        single = [n <= COFACTORS and roots.count(node) == 1 for _, node in found]
        shapes = [_by_cofactors(scene, M, K, n, node) if alone else None
                  for alone, (_, node) in zip(single, found, strict=True)]
    for (_, node), shape in zip(found, shapes, strict=True):
        modes.append(ClosedMode(node, root_of(node, scene.sample), shape))
    return ClosedForms(modes, ratio=ratio_of_omega)


def quadratic_roots(coefficients, sample):
    """The roots of a λ² + b λ + c or a λ + b, over one denominator, the common rational factor cancelled."""
    if len(coefficients) == 2:
        a, b = coefficients
        return [ratio(-b, a)]
    a, b, c = coefficients
    table = a.table
    root = root_of(b * b - 4 * a * c, sample)
    common = gcd(*(_divisor(node) for node in (b, 2 * a)), root.coefficient.numerator if root.op == "product" else 1)
    below = textbook(2 * a / common)
    return [table.product((textbook(-b / common) + sign * root / common, ONE), (below, -ONE)) for sign in (-1, 1)]


def _divisor(node):
    """The integer that divides all coefficients of a polynomial; 1 where there are fractions."""
    values = expanded(node).values()
    return gcd(*(v.numerator for v in values)) if all(v.denominator == 1 for v in values) else 1


def _agrees(scene, M, K, n, squares):
    """Do the closed forms equal the eigenvalues at the sample values?"""
    import numpy as np

    zero = scene.table.zero
    values = evaluate([matrix.get((i, j), zero) for matrix in (M, K) for i in range(n) for j in range(n)], Floats,
                      scene.sample)
    mass, stiffness = np.array(values).reshape(2, n, n)
    try:
        reference = np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)
    except np.linalg.LinAlgError:
        return False
    return len(squares) == n and bool(np.allclose(squares, reference, rtol=1e-6, atol=1e-7 * abs(reference).max()))


def _shape(scene, M, K, i, squares):
    """Amplitudes of mode i of two degrees: the first is 1, or it rests. A double root has both coordinates alone."""
    one, zero = scene.table.one, scene.table.zero
    alone = [[one, zero], [zero, one]]
    coupled = any(pair in matrix for matrix in (M, K) for pair in ((0, 1), (1, 0)))
    if squares[0] is squares[1]:
        return alone[i] if all(matrix.get((0, 1)) is matrix.get((1, 0)) for matrix in (M, K)) else None
    entry = {pair: K.get(pair, zero) - squares[i] * M.get(pair, zero) for pair in ((0, 0), (0, 1))}
    if not coupled:
        x, = evaluate([entry[0, 0]], Floats, scene.sample)
        y, = evaluate([K.get((0, 0), zero)], Floats, scene.sample)
        return alone[0] if abs(x) <= 1e-9 * abs(y) or entry[0, 0].is_zero else alone[1]
    amplitude = _ratio(scene, M, K, squares[i])
    return None if amplitude is None else [one, amplitude]


def _by_cofactors(scene, M, K, n, square):
    """Amplitudes as cofactors of a row of K − λM, the first that moves being 1; None where they are too long."""
    zero, table = scene.table.zero, scene.table
    if any(e.denominator == 2 for part in reachable([square]) if part.op == "product" for _, e in part.args):
        return None
    entry = [[K.get((i, j), zero) - square * M.get((i, j), zero) for j in range(n)] for i in range(n)]
    for row in range(n):
        rest = [line for i, line in enumerate(entry) if i != row]
        found = [textbook(table.scaled(determinant([line[:j] + line[j + 1:] for line in rest]), (-1) ** (row + j)))
                 for j in range(n)]
        sizes = evaluate(found, Floats, scene.sample)
        largest = max(map(abs, sizes))
        terms = max(abs(x) for x in evaluate([part for line in entry for part in line], Floats, scene.sample))
        if largest <= 1e-9 * terms ** (n - 1):
            continue
        pivot = next(j for j, size in enumerate(sizes) if abs(size) > 1e-9 * largest)
        return [zero if abs(size) <= 1e-9 * largest else ratio(part, found[pivot])
                for part, size in zip(found, sizes, strict=True)]
    return None


def determinant(rows):
    """By expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total = rows[0][0].table.zero
    for j, entry in enumerate(rows[0]):
        if not entry.is_zero:
            minor = determinant([line[:j] + line[j + 1:] for line in rows[1:]])
            total = total + entry * minor * (-1) ** j
    return total


def _ratio(scene, M, K, square):
    """q₂/q₁ = −(K₁₁ − ω² M₁₁)/(K₁₂ − ω² M₁₂), or from the second equation where that is 0/0 at the sample."""
    zero = scene.table.zero
    for i in (0, 1):
        above, below = (K.get((i, j), zero) - square * M.get((i, j), zero) for j in (0, 1))
        values = {**scene.sample, "ω": 1.0}
        x, y = evaluate([above, below], Floats, values)
        if abs(y) > 1e-9 * max(abs(x), 1e-300):
            return ratio(-above, below)
    return None


def _polynomial(scene, factors, unknown, back):
    """The unsolved factors as expressions of the symbol lambda."""
    symbol = scene.table.variable("λ")
    return [textbook(from_sympy(scene.table, factor, {**back, unknown: symbol})) for factor in factors]
