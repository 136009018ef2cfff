"""The margin to flutter and divergence: its sign is the stability that eigenvalues to many digits give, and the limit
that is chosen is the first of both."""

import math
import random

import mpmath
import pytest
from support.scenes import problem

from vibcli.inverse import search, settled
from vibcli.inverse.conditions import HOLDS, ConditionSystem
from vibcli.inverse.stability_margin import free_roots, margin
from vibcli.mechanics.factored_system import FactoredSystem

COLUMN = """
parameters: {{m: {m} kg, l: {l} m, k: {k} N*m, a: {a}}}
bodies:
  one: {{mass: 2*m, at: [0, l], pin: {{at: [0, 0], by: p}}}}
  two: {{mass: m, at: [0, 2*l], pin: {{at: one, by: q}}}}
springs: {{s: {{torsion: k, between: [ground, one]}}, t: {{torsion: k, between: [one, two]}}}}
forces:
  dead: {{at: two, force: [0, -(1 - a)*P]}}
  following: {{at: two, force: [0, -a*P], carrier: two}}
choose: {{P: stability limit}}
"""


def limits(a):
    """P l/k of divergence and of flutter, ∞ where there is none: 1 − 3(1 − a)s + (1 − a)s² = 0, (7 − (4 − 2a)s)² = 8 of
    that."""
    b = 1 - a
    root = 9 * b * b - 4 * b
    divergence = (3 * b - math.sqrt(root)) / (2 * b) if root >= 0 and b else math.inf
    real = [float(mpmath.re(s)) for s in mpmath.polyroots([(4 - 2 * a) ** 2 - 8 * b, -14 * (4 - 2 * a) + 24 * b, 41])
            if abs(mpmath.im(s)) < 1e-12 and mpmath.re(s) > 0]
    return divergence, min(real, default=math.inf)


@pytest.mark.parametrize("route", ["letters", "search"])
@pytest.mark.parametrize("a", [0.1, 0.3, 0.45, 0.6, 0.75, 0.9])
def test_the_first_of_divergence_and_flutter_is_chosen(a, route, monkeypatch):
    if route == "search":
        monkeypatch.setattr(search, "candidates", lambda *args: None)
    found = settled(problem(COLUMN.format(m=2, l=0.5, k=30, a=a)))
    assert float(found.choice.solutions[0].values["P"]) * 0.5 / 30 == pytest.approx(min(limits(a)), rel=1e-9)


def test_both_kinds_were_swept():
    kinds = {divergence < flutter for divergence, flutter in map(limits, (0.1, 0.3, 0.45, 0.6, 0.75, 0.9))}
    assert kinds == {True, False}


def systems():
    """Random systems of two to four degrees that are no conservative ones, near their limits of stability as well."""
    generator = random.Random("margins")
    for case in range(96):
        n, kind = 2 + case % 3, case % 4

        def full(size, n=n):
            return mpmath.matrix([[generator.gauss(0, size) for _ in range(n)] for _ in range(n)])

        root = full(1)
        M, K = root * root.T + mpmath.eye(n), full(1)
        K = K + K.T + generator.uniform(0, 5) * mpmath.eye(n)
        G, C = mpmath.zeros(n), mpmath.zeros(n)
        if kind == 0:                                   # follower loads
            twist = full(generator.choice((0.1, 0.5, 2.0)))
            K += twist - twist.T
        elif kind == 1:                                 # gyroscopic, perhaps beyond a divergence that it holds
            twist = full(3)
            G = twist - twist.T
        else:                                           # damped follower loads; damping that feeds energy in
            twist, damper = full(0.5), full(1)
            K += (twist - twist.T) * (kind == 2)
            G = (damper - damper.T) * (kind == 2)
            C = damper * damper.T * 0.1 - (0.3 * mpmath.eye(n) if kind == 3 and case % 8 == 3 else mpmath.zeros(n))
        yield M, C, G, K


def grows(M, C, G, K):
    """The largest Re λ, by 20 digits."""
    with mpmath.workdps(20):
        roots = _roots(M, C, G, K)
        return max(mpmath.re(root) for root in roots), max(abs(root) for root in roots)


def _roots(M, C, G, K):
    n = len(M)
    inverse, whole = mpmath.inverse(M), mpmath.zeros(2 * n)
    whole[:n, n:], whole[n:, :n], whole[n:, n:] = mpmath.eye(n), -inverse * K, -inverse * (C + G)
    return mpmath.eig(whole, left=False, right=False)


def entries(A):
    return {(i, j): float(A[i, j]) for i in range(len(A)) for j in range(len(A)) if A[i, j]}


def elements_of(M, C, G, K):
    size = {pair: abs(x) for pair, x in entries(K).items()}
    return FactoredSystem(len(M), M=entries(M), C=entries(C), G=entries(G), K=entries(K), K_size=size)


def of(M, C, G, K):
    elements = elements_of(M, C, G, K)
    return margin(elements, free_roots(elements))


@pytest.mark.parametrize("c", [0.1, 0.5, 2.0])
def test_damping_moves_no_divergence(c):
    text = COLUMN.format(m=2, l=0.5, k=30, a=0.1).replace("a: 0.1}", f"a: 0.1, c: {c} N*m*s}}")
    found = settled(problem(text + "dampers: {d: {torsion: c, between: [ground, one]}, "
                            "e: {torsion: c, between: [one, two]}}\n")).choice.solutions
    assert float(found[0].values["P"]) * 0.5 / 30 == pytest.approx(limits(0.1)[0], rel=1e-12)
    assert found[0].residual < 1e-12


@pytest.mark.parametrize("sign", [1, -1])
def test_a_slow_divergence_is_told(sign):
    """λ ≈ −k/c of the soft direction, some 10⁻⁶ of the fastest root."""
    M, C, G = mpmath.eye(2), mpmath.matrix([[1, 0.1], [0.1, 1]]), mpmath.zeros(2)
    value, size = of(M, C, G, mpmath.matrix([[1, 0.2], [-0.2, sign * 1e-6 - 0.04]]))
    assert (value > 0) == (sign > 0) and 1e-8 < abs(value) / size < 1e-4


@pytest.mark.sweep
def test_motion_that_nothing_holds_is_left_out():
    """A chain of three that floats, its dampers positive, or one of them feeding energy in: the double root 0 of the
    free motion, which rounding splits, is no growth."""
    generator = random.Random("floating")
    seen = {True: 0, False: 0}
    for _ in range(40):
        between = mpmath.matrix([[1, -1, 0], [0, 1, -1]])
        k, c = ([generator.uniform(0.5, 2) for _ in range(2)] for _ in range(2))
        c[0] *= generator.choice((1, -1))
        M = mpmath.diag([generator.uniform(0.5, 2) for _ in range(3)])
        M[0, 1] = M[1, 0] = 0.1
        K, C = (between.T * mpmath.diag(x) * between for x in (k, c))
        twist = between.T * mpmath.matrix([[0, 0.05], [-0.05, 0]]) * between
        with mpmath.workdps(40):
            fastest = max(map(mpmath.re, sorted(_roots(M, C, mpmath.zeros(3), K + twist), key=abs)[2:]))
        value, _ = of(M, C, mpmath.zeros(3), K + twist)
        assert (value > 0) == (fastest < 0)
        seen[bool(fastest < 0)] += 1
        still, size = of(M, mpmath.zeros(3), mpmath.zeros(3), K + twist)
        assert still > 1e-6 * size
    assert min(seen.values()) >= 10


@pytest.mark.sweep
def test_its_share_knows_no_unit():
    for M, C, G, K in list(systems())[:24]:
        value, size = of(M, C, G, K)
        other, large = of(M, 1e3 * C, 1e3 * G, 1e6 * K)
        assert other / large == pytest.approx(value / size, rel=1e-6, abs=1e-9)


@pytest.mark.sweep
def test_its_sign_is_the_stability():
    seen = {True: 0, False: 0}
    for M, C, G, K in systems():
        found = of(M, C, G, K)
        assert found is not None
        value, size = found
        fastest, largest = grows(M, C, G, K)
        damped = any(entries(C).values())
        stable = fastest < 0 if damped else fastest < 1e-12 * largest
        if abs(fastest) < 1e-6 * largest and (damped or not stable):
            continue                                    # too near to tell
        assert (value > 0) == stable, (M, C, G, K)
        if damped:
            assert value == pytest.approx(float(-fastest), rel=1e-7, abs=1e-9 * size)
            assert size == pytest.approx(float(largest), rel=1e-7)
        seen[bool(stable)] += 1
    assert min(seen.values()) >= 25


def test_where_nothing_holds_and_dampers_cancel_stability_is_at_its_limit():
    zero = mpmath.zeros(2)
    elements = elements_of(mpmath.eye(2), zero, zero, zero)
    elements.dampers = [(1.0, {0: 1, 1: -1}), (-1.0, {0: 1, 1: -1})]
    assert margin(elements, free_roots(elements)) == (0.0, 0.0)


def test_the_load_that_buckles_members_with_mass_is_told_by_their_slowest_mode_and_far_beyond_without_modes():
    found = problem("""
        parameters: {L: 2 m, EI: 1 kN*m^2, mu: 3 kg/m}
        beams:
          left: {length: L, EI: EI, mass_per_length: mu, preload: -P, left: clamped}
          right: {length: L, EI: EI, mass_per_length: mu, preload: -P, left: clamped}
        choose: {P: stability limit}
        """)
    system, limit = ConditionSystem(found), math.pi**2 * 1000 / 16
    below, above, far = (system.misfits([limit * factor])[0] for factor in (1 - 1e-12, 1 + 1e-12, 1e12))
    assert -HOLDS < above < 0 < below < HOLDS and far == -1
