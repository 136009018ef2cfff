"""Natural frequencies in letters: the characteristic polynomial det(K − λM), factored, its roots where readable.

One degree: ω = √(K/M). Factors of degree one and two in λ = ω² are solved; a factor of higher degree is left as a
polynomial. Every root is checked in numbers at sample values before it is shown.
"""

from vibcli.algebra.evaluate import Floats, evaluate, from_sympy, sympy_arithmetic
from vibcli.algebra.expression import HALF, ONE
from vibcli.algebra.normal import textbook
from vibcli.mechanics.lagrange import matrices_in_letters

LARGEST, LONGEST = 6, 400


class ClosedMode:
    """ω² and ω as expressions; shape: amplitudes by coordinate with the first one that moves 1, or None."""

    __slots__ = ("omega", "shape", "square")

    def __init__(self, square, omega, shape):
        self.square, self.omega, self.shape = square, omega, shape


class ClosedForms:
    """modes: ascending at the sample values; polynomial: (unsolved factor as text) or None; zeta, omega_d of one degree."""

    __slots__ = ("modes", "omega_d", "polynomial", "zeta")

    def __init__(self, modes, polynomial=None, zeta=None, omega_d=None):
        self.modes, self.polynomial, self.zeta, self.omega_d = modes, polynomial, zeta, omega_d


def closed_forms(problem):
    """The ClosedForms of a scene whose small oscillations are known in letters; None where they are too long."""
    if not problem.linear_in_letters:
        return None
    scene = problem.scene
    M, C, G, K = matrices_in_letters(problem.letters_form)
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
    modes = [ClosedMode(square, root_of(square), [table.one])]
    if c.is_zero:
        return ClosedForms(modes)
    zeta = ratio(c, table.number(2) * root_of(m * k))
    if evaluate([square], Floats, scene.sample)[0] <= 0:
        return ClosedForms(modes)
    decay = ratio(c, 2 * m)
    return ClosedForms(modes, zeta=zeta, omega_d=table.sqrt(square - decay * decay))


def ratio(above, below):
    """above/below with common factors cancelled."""
    table = above.table
    return table.product((textbook(above), ONE), (textbook(below), -ONE))


def root_of(node):
    """√node, its content split under one root."""
    return node.table.power(node, HALF)


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
    squares, left = [], []
    for factor, power in sympy.factor_list(polynomial, unknown)[1]:
        degree = sympy.degree(factor, unknown)
        if degree == 0:
            continue
        if degree > 2:
            left.append(factor)
            continue
        squares += _roots(sympy, sympy.Poly(factor, unknown), degree) * power
    if left:
        return ClosedForms([], polynomial=_polynomial(scene, left, unknown, back))
    found = []
    for square in squares:
        node = textbook_root(scene, from_sympy(scene.table, square, back))
        found.append((evaluate([node], Floats, scene.sample)[0], square, node))
    found.sort(key=lambda item: item[0])
    if not _agrees(scene, M, K, n, [value for value, _, _ in found]):
        return None
    modes = []
    for i, (_, square, node) in enumerate(found):
        repeated = any(square == other for j, (_, other, _) in enumerate(found) if j != i)
        shape = None if repeated else _shape(sympy, scene, stiffness - square * mass, n, back)
        modes.append(ClosedMode(node, root_of(node), shape))
    return ClosedForms(modes)


def _roots(sympy, polynomial, degree):
    """The roots of a factor of degree one or two, simplified."""
    coefficients = polynomial.all_coeffs()
    if degree == 1:
        a, b = coefficients
        return [sympy.factor(-b / a)]
    a, b, c = coefficients
    discriminant = sympy.factor(b**2 - 4 * a * c)
    root = sympy.sqrt(discriminant)
    return [sympy.expand(-b) / (2 * a) + sign * root / (2 * a) for sign in (-1, 1)]


def textbook_root(scene, node):
    """One root as a node, brought over a common denominator where the algebra does that by itself."""
    return node


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


def _shape(sympy, scene, matrix, n, back):
    """Amplitudes from the first n − 1 equations with the first amplitude 1; None where that does not decide."""
    if n != 2:
        return None
    for row in (0, 1):
        a, b = matrix[row, 0], matrix[row, 1]
        if sympy.simplify(b) != 0:
            amplitude = sympy.factor(sympy.simplify(-a / b)) if (a / b).count_ops() < 60 else -a / b
            return [scene.table.one, from_sympy(scene.table, amplitude, back)]
    return None


def _polynomial(scene, factors, unknown, back):
    """The unsolved factors as expressions of the symbol lambda."""
    symbol = scene.table.parameter("lambda")
    return [textbook(from_sympy(scene.table, factor, {**back, unknown: symbol})) for factor in factors]
