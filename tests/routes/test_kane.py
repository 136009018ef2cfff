"""Equations of motion and small oscillations of problem files against Kane's method (tests/support/kane.py).

Kane's equations come from accelerations and partial velocities and know neither T nor V nor Lagrange's equations; where
loops are closed, SymPy keeps the dependent speeds and their rates, which are solved for here in numbers.
"""

import random
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import mpmath
import pytest
import sympy
from support import kane
from support.scenes import problem_of
from sympy.physics.mechanics import KanesMethod, dynamicsymbols

from vibcli.check.instances import Instances
from vibcli.mechanics.lagrange import equation_of
from vibcli.results.random_states import reach
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

PROBLEMS = {path.stem: path for path in (Path(__file__).parents[2] / "problems").glob("*/*.yaml")}
DIGITS, STATES, RTOL, STEP = 40, 4, 1e-12, mpmath.mpf(10) ** -12
EXCITATION = {"rods_on_shaken_pivot": "X", "lever_on_shaking_floor": "Y", "spool_on_driven_plank": "Y",
              "centrifugal_pendulum_absorber": "M0"}      # what the small oscillations leave out
NO_MATTER = {"disc_on_sprung_platform": ["r"], "hoist_with_moving_pulley": ["r1", "r2"],
             "trammel_with_particle": ["theta0"]}         # parameters that drop out of the equations of motion


class Kane:
    """The residual −(Fr + Fr*) of a model in numbers, in mpmath at the working precision."""

    def __init__(self, build, names):
        symbols = {name: sympy.Symbol(name, positive=True) for name in names}
        model = kane.Model(symbols.get("g"))
        build(model, SimpleNamespace(**symbols))
        t = model.t
        q_ind, q_dep = model.independent + model.rolled, model.dependent
        u = [dynamicsymbols(f"u{i}") for i in range(len(q_ind + q_dep))]
        self.free, self.untied, self.names = len(model.independent), len(q_ind), [q.name for q in q_ind + q_dep]
        between_speeds = [*model.rolling, *(condition.diff(t) for condition in model.tied)]
        method = KanesMethod(
            model.N, q_ind, u[:self.free], [speed - q.diff(t) for q, speed in zip(q_ind + q_dep, u, strict=True)],
            q_dependent=q_dep, configuration_constraints=model.tied, u_dependent=u[self.free:],
            velocity_constraints=between_speeds)
        method.kanes_equations(model.bodies, model.loads)
        parts = {"motion": [method.mass_matrix, method.forcing]}
        if q_dep:
            parts["closing"] = [sympy.Matrix(model.tied), sympy.Matrix(model.tied).jacobian(q_dep)]
        if len(u) > self.free:
            speeds = sympy.Matrix(between_speeds).xreplace(method.kindiffdict())
            parts["speeds"] = [speeds.jacobian(u), speeds.xreplace(dict.fromkeys(u, 0))]
        self.used = {symbol.name for matrices in parts.values() for matrix in matrices for symbol in matrix.free_symbols
                     if symbol is not t}
        given = [*q_ind, *q_dep, *u, t, *symbols.values()]
        self.numbers = {name: sympy.lambdify(given, matrices, "mpmath", cse=True)
                        for name, matrices in parts.items()}

    def closed(self, p, q, t):
        """All coordinates of the free ones in `q`, by Newton's method on those that are tied."""
        q, tied = list(q), len(q) - self.untied
        for _ in range(60 if tied else 0):
            left, slopes = self.numbers["closing"](*q, *[0] * len(q), t, *p)
            step = mpmath.lu_solve(slopes, -left)
            q[self.untied:] = [x + dx for x, dx in zip(q[self.untied:], step, strict=True)]
            if mpmath.norm(step) < 1e3 * mpmath.eps:
                return q
        assert not tied, "the loops do not close"
        return q

    def residual(self, p, q, v, a, t):
        """The left sides of the equations of motion; q: all coordinates, v and a: rates of the free ones."""
        count, free = len(q), self.free
        v, a = mpmath.matrix(v), mpmath.matrix(a)
        if count > free:
            ties, rest = self.numbers["speeds"](*q, *[0] * count, t, *p)
            v = mpmath.matrix([*v, *mpmath.lu_solve(ties[:, free:], -rest - ties[:, :free] * v)])
        mass, force = self.numbers["motion"](*q, *v, t, *p)
        if count > free:
            a = mpmath.matrix([*a, *mpmath.lu_solve(mass[free:, free:], force[free:, :] - mass[free:, :free] * a)])
        return list(mass[:free, :] * a - force[:free, :])


class Both:
    """A problem with numbers, and Kane's residual of it."""

    def __init__(self, build):
        self.name = build.__name__
        self.problem = next(iter(Instances(problem_of(PROBLEMS[self.name]))))
        self.scene = self.problem.scene
        with mpmath.workdps(DIGITS):
            self.parameters = self.problem.numeric.values(multiprecision())
        self.kane = Kane(build, list(self.parameters))

    def drawn(self):
        """The values of Kane's coordinates in the drawn position."""
        return [mpmath.mpf(self.problem.numeric.drawn_floats.get(name, 0)) for name in self.kane.names]

    def states(self):
        """(q, v, a, t) at random near the drawn position, the loops closed."""
        generator, names = random.Random(self.name), self.scene.coordinates
        for _ in range(STATES):
            q, t = self.drawn(), mpmath.mpf(generator.uniform(0, 3))
            for i, name in enumerate(names):
                q[i] += reach(self.problem, name) * generator.uniform(-1, 1)
            rates = [[mpmath.mpf(reach(self.problem, name) * generator.uniform(-size, size)) for name in names]
                     for size in (9, 30)]
            yield self.kane.closed(list(self.parameters.values()), q, t), *rates, t

    def residual(self, state, spoiled=None, share=0):
        """Kane's, with a parameter spoiled."""
        p = {name: value * (1 + share * (name == spoiled)) for name, value in self.parameters.items()}
        q, v, a, t = state
        return self.kane.residual(list(p.values()), self.kane.closed(list(p.values()), q, t), v, a, t)

    def symbols(self, state):
        """The state as vibcli names it."""
        q, v, a, t = state
        found = dict(zip(self.kane.names, q, strict=True)) | {self.scene.time.name: t}
        for primes, rates in (("'", v), ("''", a)):
            found |= {name + primes: x for name, x in zip(self.kane.names, rates, strict=False)}
        return {name: float(x) for name, x in found.items()} | self.problem.numeric.floats


@cache
def both(build):
    with mpmath.workdps(DIGITS):
        return Both(build)


@pytest.fixture(params=kane.ALL, ids=lambda build: build.__name__)
def pair(request):
    with mpmath.workdps(DIGITS):
        yield both(request.param)


def agree(found, exact):
    """Lists of numbers, relative to the largest of them."""
    largest = max(map(abs, exact))
    return largest > 0 and all(abs(x - y) <= RTOL * largest for x, y in zip(found, exact, strict=True))


def compared(pair, spoiled=None, share=0):
    """Does each equation of motion agree at all states?"""
    nodes = [equation_of(pair.scene, i) for i in range(len(pair.scene.q))]
    states = list(pair.states())
    exact = [pair.residual(state, spoiled, share) for state in states]
    found = [evaluate(nodes, Floats, pair.symbols(state)) for state in states]
    return [agree(x, y) for x, y in zip(zip(*found, strict=True), zip(*exact, strict=True), strict=True)]


@pytest.mark.sweep
def test_the_spread():
    assert len(kane.ALL) >= 21
    assert {build.__name__ for build in kane.ALL} <= set(PROBLEMS)
    assert sum(len(both(build).kane.names) > both(build).kane.free for build in kane.ALL) >= 8
    assert sum(bool(both(build).scene.loops) for build in kane.ALL) >= 3
    assert sum(both(build).scene.timed for build in kane.ALL) >= 6


def test_coordinates_are_those_of_the_scene(pair):
    assert pair.scene.coordinates == pair.kane.names[:pair.kane.free]


def test_dependent_coordinates(pair):
    """Where both name them."""
    dependent = {name: node for name, node in pair.scene.dependent.items() if name in pair.kane.names}
    for state in pair.states():
        symbols = pair.symbols(state)
        for name, x in zip(dependent, evaluate(list(dependent.values()), Floats, symbols), strict=True):
            assert x == pytest.approx(symbols[name], rel=1e-12, abs=1e-14)


def test_equations_of_motion(pair):
    assert all(compared(pair))


@pytest.mark.sweep
def test_a_perturbed_parameter_is_detected(pair):
    """Each that matters, by a part in a billion."""
    unseen = [name for name in sorted(pair.kane.used) if all(compared(pair, name, 1e-9))]
    assert unseen == NO_MATTER.get(pair.name, [])


# small oscillations

def slopes(pair, p, q, kind):
    """∂r/∂q, ∂r/∂v or ∂r/∂a (kind 0, 1, 2) of Kane's residual r at rest in q at t = 0, by central differences."""
    n, now = pair.kane.free, mpmath.mpf(0)
    columns = []
    for j in range(n):
        ends = []
        for sign in (1, -1):
            state = [list(q), [now] * n, [now] * n]
            state[kind][j] += sign * STEP
            ends.append(pair.kane.residual(p, pair.kane.closed(p, state[0], now), *state[1:], now))
        columns.append([(x - y) / (2 * STEP) for x, y in zip(*ends, strict=True)])
    return mpmath.matrix(columns).T


def equilibrium(pair, p):
    """Kane's coordinates at rest, by Newton's method from vibcli's."""
    n, now = pair.kane.free, mpmath.mpf(0)
    known = pair.problem.configuration.at_rest | pair.problem.configuration.dependent_values
    q = pair.kane.closed(p, [mpmath.mpf(known.get(name, 0)) for name in pair.kane.names], now)
    for _ in range(4):
        left = pair.kane.residual(p, q, [now] * n, [now] * n, now)
        if any(left):
            step = mpmath.lu_solve(slopes(pair, p, q, 0), -mpmath.matrix(left))
            q = pair.kane.closed(p, [*(x + dx for x, dx in zip(q, step, strict=False)), *q[n:]], now)
    return q


def oscillations(pair, spoiled=None, share=0):
    """[(vibcli's, Kane's)] of M, C + G and K, without the excitation."""
    n, still = pair.kane.free, EXCITATION.get(pair.name)
    p = [value * (name != still) * (1 + share * (name == spoiled)) for name, value in pair.parameters.items()]
    q = equilibrium(pair, p)
    M, C, G, K = (mpmath.matrix([[matrix.get((i, j), 0.0) for j in range(n)] for i in range(n)])
                  for matrix in pair.problem.configuration.linear_system.matrices())
    return q, [(found, slopes(pair, p, q, kind)) for found, kind in ((M, 2), (C + G, 1), (K, 0))]


def alike(found, exact):
    """Matrices, entry for entry; what is zero but for the differences counts as zero."""
    rounding = max(map(abs, exact)) * mpmath.mpf(10) ** -18
    return all(abs(x - y) <= RTOL * abs(y) + rounding for x, y in zip(found, exact, strict=True))


def test_small_oscillations(pair):
    q, matrices = oscillations(pair)
    assert all(alike(found, exact) for found, exact in matrices)
    place = pair.problem.configuration.equilibrium.values
    assert q[:pair.kane.free] == [pytest.approx(place[name], rel=1e-12, abs=1e-14) for name in pair.scene.coordinates]


@pytest.mark.sweep
@pytest.mark.parametrize("build", [kane.four_bar_with_springs, kane.particle_on_turning_disc,
                                   kane.column_under_follower_force], ids=lambda build: build.__name__)
def test_a_perturbed_parameter_changes_the_small_oscillations(build):
    with mpmath.workdps(DIGITS):
        pair = both(build)
        for name in pair.kane.used:
            assert not all(alike(found, exact) for found, exact in oscillations(pair, name, 1e-9)[1]), name
