"""Equations of motion and their linearisation against SymPy working on energies that are written out by hand."""

import random
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy
from support import mechanisms
from support.scenes import problem

from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.mechanics.lagrange import equation_of, full_equations
from vibcli.mechanics.numeric_equations import NumericEquations
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

DIGITS, STATES = 40, 6


class Theirs:
    """T, V, Φ, the left sides of Lagrange's equations and the matrices of a mechanism, by SymPy."""

    def __init__(self, make):
        text, self.names, energies = make()
        self.problem = problem(text)
        exact = {name: rational(value) for name, value in exact_parameters(self.problem).items()}
        n = len(self.names)
        self.q, self.v, self.a = (sympy.symbols(f"{letter}:{n}", real=True) for letter in "qva")
        self.T, self.V, self.Phi = map(sympy.sympify, energies(exact, list(self.q), list(self.v)))
        self.left = [self.lagrange(i) for i in range(n)]
        self.M, self.C = sympy.hessian(self.T, self.v), sympy.hessian(self.Phi, self.v)
        self.K, self.force = sympy.hessian(self.V, self.q), [sympy.diff(self.V, x) for x in self.q]
        self.arguments = (*self.q, *self.v, *self.a)

    def lagrange(self, i):
        """d/dt ∂T/∂q̇ − ∂T/∂q + ∂V/∂q + ∂Φ/∂q̇."""
        momentum = sympy.diff(self.T, self.v[i])
        rate = sum(sympy.diff(momentum, x) * u for x, u in zip(self.q + self.v, self.v + self.a, strict=True))
        return rate - sympy.diff(self.T, self.q[i]) + sympy.diff(self.V, self.q[i]) + sympy.diff(self.Phi, self.v[i])

    def at(self, expressions, state):
        """Values in many digits at a state (q, v, a) of floats."""
        flat = [mpmath.mpf(x) for part in state for x in part]
        return compiled(self.arguments, tuple(expressions))(flat)

    def symbols(self, state):
        """The state as vibcli names it."""
        return {name + "'" * primes: value for primes, part in enumerate(state)
                for name, value in zip(self.names, part, strict=True)}

    def equilibrium(self):
        """The equilibrium in many digits, by Newton's method from that of vibcli."""
        start = [mpmath.mpf(self.problem.configuration.equilibrium.values[name]) for name in self.names]
        n = len(start)

        def force(*q):
            return self.at(self.force, (q, [0] * n, [0] * n))

        return list(mpmath.findroot(force, start)) if n > 1 else [mpmath.findroot(lambda x: force(x)[0], start[0])]


def exact_parameters(scene):
    rational = scene.numeric.rational
    return rational | {name: value for name, value in scene.numeric.floats.items() if name not in rational}


def rational(value):
    if isinstance(value, float):        # 20 deg is a multiple of pi
        return sympy.pi * sympy.nsimplify(sympy.Rational(value) / sympy.pi.evalf(40), rational=True, tolerance=1e-15)
    return sympy.Rational(value.numerator, value.denominator)


@cache
def compiled(arguments, expressions):
    """[values] of expressions as a function of all arguments, in many digits: a matrix is read at many states."""
    return sympy.lambdify([arguments], list(expressions), "mpmath")


@cache
def both(make):
    with mpmath.workdps(DIGITS):
        return Theirs(make)


@pytest.fixture(params=mechanisms.ALL, ids=lambda make: make.__name__)
def mechanism(request):
    with mpmath.workdps(DIGITS):
        yield both(request.param)


def states(theirs):
    generator = random.Random("lagrange")
    n = len(theirs.names)
    return [[[generator.uniform(-s, s) for _ in range(n)] for s in (0.25, 2.0, 9.0)] for _ in range(STATES)]


def ours(theirs, nodes, state):
    return evaluate(nodes, Floats, theirs.problem.numeric.floats | theirs.symbols(state))


def agree(found, exact, rtol=1e-12):
    """Lists of numbers, relative to the largest of them."""
    size = max(abs(x) for x in exact)
    return all(abs(x - y) <= rtol * size for x, y in zip(found, exact, strict=True))


@pytest.mark.sweep
def test_names(mechanism):
    assert mechanism.problem.scene.coordinates == list(mechanism.names)
    assert len(mechanisms.ALL) >= 8


def test_energies(mechanism):
    scene = mechanism.problem.scene
    pairs = [(ours(mechanism, [kinetic(scene), potential(scene), dissipation(scene)], state),
              mechanism.at([mechanism.T, mechanism.V, mechanism.Phi], state)) for state in states(mechanism)]
    for i in (0, 2):
        assert agree([x[i] for x, _ in pairs], [y[i] for _, y in pairs])
    first, theirs = pairs[0][0][1], pairs[0][1][1]
    assert agree([x[1] - first for x, _ in pairs], [y[1] - theirs for _, y in pairs])


@pytest.mark.sweep
@pytest.mark.parametrize("form", ["as it comes", "textbook"])
def test_full_equations(mechanism, form):
    scene = mechanism.problem.scene
    left = full_equations(scene) if form == "textbook" else [equation_of(scene, i) for i in range(len(scene.q))]
    for i, node in enumerate(left):
        found = [ours(mechanism, [node], state)[0] for state in states(mechanism)]
        exact = [mechanism.at([mechanism.left[i]], state)[0] for state in states(mechanism)]
        assert agree(found, exact)


@pytest.mark.sweep
def test_a_wrong_equation_is_noticed(mechanism):
    node = equation_of(mechanism.problem.scene, 0)
    found = [ours(mechanism, [node], state)[0] * (1 + 1e-11) for state in states(mechanism)]
    assert not agree(found, [mechanism.at([mechanism.left[0]], state)[0] for state in states(mechanism)])


def test_mass_matrix_anywhere(mechanism):
    n = len(mechanism.names)
    for state in states(mechanism):
        values = mechanism.problem.numeric.floats | dict(zip(mechanism.names, state[0], strict=True))
        M = in_numbers(mechanism.problem.system.linearisation, Floats, values).elements.matrices()[0]
        exact = mechanism.at(mechanism.M, state)
        assert agree([M.get((i, j), 0.0) for i in range(n) for j in range(n)], exact, 1e-14)


# small oscillations: gate A12

def at_equilibrium(mechanism):
    q = mechanism.equilibrium()
    rest = [0] * len(q)
    return [mechanism.at(matrix, (q, rest, rest)) for matrix in (mechanism.M, mechanism.C, mechanism.K)]


def flat(matrices, n):
    M, C, G, K = matrices
    assert not G
    return [[matrix.get((i, j), 0) for i in range(n) for j in range(n)] for matrix in (M, C, K)]


def magnitudes(elements, n):
    """Σ |terms| of each entry of M, C, K."""
    found = []
    for rows, extra, size in ((elements.inertias, elements.M, {}), (elements.dampers, elements.C, {}),
                              (elements.springs, elements.K, elements.K_size)):
        total = {pair: max(abs(value), size.get(pair, 0)) for pair, value in extra.items()}
        for weight, row in rows:
            for i, x in row.items():
                for j, y in row.items():
                    total[i, j] = total.get((i, j), 0) + abs(weight * x * y)
        found.append([total.get((i, j), 0) for i in range(n) for j in range(n)])
    return found


@pytest.mark.sweep
def test_matrices_in_floats(mechanism):
    elements, n = mechanism.problem.configuration.linear_system, len(mechanism.names)
    sizes = magnitudes(elements, n)
    ours = flat(elements.matrices(), n)
    for found, exact, size in zip(ours, at_equilibrium(mechanism), sizes, strict=True):
        assert all(abs(x - y) <= 1e-14 * s + 1e-300 for x, y, s in zip(found, exact, size, strict=True))


@pytest.mark.sweep
def test_matrices_in_many_digits(mechanism):
    elements, n = mechanism.problem.configuration.precise_system(DIGITS), len(mechanism.names)
    for found, exact in zip(flat(elements.matrices(), n), at_equilibrium(mechanism), strict=True):
        assert agree(found, exact, mpmath.mpf(10) ** -34) if any(exact) else not any(found)


def test_floats_are_the_rounded_many_digits(mechanism):
    n = len(mechanism.names)
    configuration = mechanism.problem.configuration
    sizes = magnitudes(configuration.linear_system, n)
    rounded, exact = (flat(e.matrices(), n) for e in
                      (configuration.linear_system, configuration.precise_system(DIGITS)))
    for found, theirs, size in zip(rounded, exact, sizes, strict=True):
        assert all(abs(x - y) <= 1e-14 * s for x, y, s in zip(found, theirs, size, strict=True))


def test_residual_vanishes_at_the_equilibrium(mechanism):
    rest = [0] * len(mechanism.names)
    q = [mechanism.problem.configuration.equilibrium.values[name] for name in mechanism.names]
    exact = mechanism.equilibrium()
    assert all(abs(x - y) <= 1e-13 for x, y in zip(q, exact, strict=True))
    weight = max(abs(x) for x in mechanism.at(mechanism.force, ([0.3] * len(q), rest, rest)))
    assert max(abs(x) for x in mechanism.at(mechanism.force, (q, rest, rest))) <= 1e-13 * weight


@pytest.mark.sweep
def test_equations_in_many_digits(mechanism):
    """The same expressions evaluated in 40 digits leave no doubt about the formula."""
    scene, state = mechanism.problem.scene, states(mechanism)[0]
    values = mechanism.problem.numeric.values(multiprecision()) | {
        name: mpmath.mpf(x) for name, x in mechanism.symbols(state).items()}
    found = evaluate([equation_of(scene, i) for i in range(len(scene.q))], multiprecision(), values)
    assert agree(found, mechanism.at(mechanism.left, state), mpmath.mpf(10) ** -34)


@pytest.mark.sweep
def test_kane_gives_the_same():
    """The pendulum on a cart by Kane's method, which knows neither T nor V."""
    from sympy.physics import mechanics as me

    theirs = both(mechanisms.cart_pendulum)
    x, f, u, w = me.dynamicsymbols("x f u w")
    p = {name: sympy.Rational(value.numerator, value.denominator)
         for name, value in theirs.problem.numeric.rational.items()}
    N, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(N, 0)
    A = N.orientnew("A", "Axis", [f, N.z])
    A.set_ang_vel(N, w * N.z)
    cart = origin.locatenew("cart", x * N.x)
    cart.set_vel(N, u * N.x)
    bob = cart.locatenew("bob", -p["L"] * A.y)
    bob.v2pt_theory(cart, N, A)
    loads = [(cart, (-p["k"] * x - p["c"] * u) * N.x), (bob, -p["m"] * p["g"] * N.y), (A, -p["ct"] * w * N.z)]
    kane = me.KanesMethod(N, q_ind=[x, f], u_ind=[u, w], kd_eqs=[x.diff() - u, f.diff() - w])
    fr, frstar = kane.kanes_equations([me.Particle("c", cart, p["M"]), me.Particle("b", bob, p["m"])], loads)
    for state in states(theirs):
        values = dict(zip((x, f, u, w), state[0] + state[1], strict=True))
        accelerations = dict(zip((u.diff(), w.diff()), state[2], strict=True))
        exact = [-float(part.subs(accelerations).subs(values)) for part in fr + frstar]
        found = [ours(theirs, [equation_of(theirs.problem.scene, i)], state)[0] for i in (0, 1)]
        assert agree(found, exact)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 6])
def test_equations_of_given_matrices(n):
    """M q̈ + C q̇ + K q, the skew part of C included, in letters and solved for q̈."""
    generator = random.Random(n)

    def drawn(i, j):
        return generator.randint(-9, 9)

    M = [[2**(i + j) * (10 * (i == j) + 1) for j in range(n)] for i in range(n)]
    C, K = ([[drawn(i, j) for j in range(n)] for i in range(n)] for _ in range(2))
    K = [[K[min(i, j)][max(i, j)] for j in range(n)] for i in range(n)]
    names = ", ".join(f"x{i}" for i in range(n))
    scene = problem(f"coordinates: [{names}]\nmatrices: {{M: {M}, C: {C}, K: {K}}}").scene
    system = NumericEquations(scene, {})
    for _ in range(3):
        q, v, a = ([drawn(0, 0) for _ in range(n)] for _ in range(3))
        state = {f"x{i}" + "'" * k: x[i] for k, x in enumerate((q, v, a)) for i in range(n)}
        for left in (full_equations(scene), [equation_of(scene, i) for i in range(n)]):
            assert evaluate(left, Floats, state) == pytest.approx([
                sum(M[i][j] * a[j] + C[i][j] * v[j] + K[i][j] * q[j] for j in range(n)) for i in range(n)], abs=1e-11)
        found = system.accelerations(0.0, *(np.array(x, float)[:, None] for x in (q, v)))[:, 0]
        assert np.array(M) @ found == pytest.approx(-(np.array(C) @ v + np.array(K) @ q), rel=1e-11, abs=1e-11)
