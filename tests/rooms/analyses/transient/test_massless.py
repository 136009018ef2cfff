"""Coordinates without inertia in time: relaxation, Zener's model, joints of springs. Against mpmath's e^{At}."""

import json
import re

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.modal.stability import WORDS, stability
from vibcli.analyses.transient.high_precision import precise_value
from vibcli.analyses.transient.linear_response import linear_motion
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

# of each coordinate: m with inertia, z held back by a damper of its own, s by springs alone
KINDS = ["z", "zz", "mz", "ms", "mzs", "mzzs", "msms", "zszm", "mmzz", "zss"]


def system(kinds, dice, symmetric=True):
    """(M, C, K) with whole numbers, coordinates coupled as the kinds allow."""
    n = len(kinds)
    m = np.array([kind == "m" for kind in kinds])
    B, D = dice.integers(-3, 4, (n, n)), dice.integers(-2, 3, (n, n))
    damped = np.array([kind != "s" for kind in kinds])
    M = np.where(np.outer(m, m), B @ B.T + 4 * np.eye(n), 0.0)
    C = np.where(np.outer(damped, damped), 0.2 * D @ D.T + np.eye(n), 0.0)
    E = dice.integers(-3, 4, (n, n))
    K = E @ E.T + 9.0 * np.eye(n)
    if not symmetric:
        skew = dice.integers(-2, 3, (n, n))
        K = K + skew - skew.T
    return M, C, K


def exact(M, C, K, forces, q0, v0, t):
    """(q, q̇, q̈) at t under Σ force·e^{st}, complex vectors: the descriptor system E ẏ = A y by mpmath, its statics
    eliminated."""
    n = len(M)
    heavy = [i for i in range(n) if M[i, i]]
    dragged = [i for i in range(n) if not M[i, i] and C[i, i]]
    still = [i for i in range(n) if not M[i, i] and not C[i, i]]
    kept = heavy + dragged
    with mpmath.workdps(40):
        M, C, K = (mpmath.matrix(matrix.tolist()) for matrix in (M, C, K))

        def part(matrix, rows, columns):
            return mpmath.matrix([[matrix[i, j] for j in columns] for i in rows])

        follow = -part(K, still, still)**-1 * part(K, still, kept) if still else mpmath.matrix(0, len(kept))
        K_kept = part(K, kept, kept) + (part(K, kept, still) * follow if still else 0 * part(K, kept, kept))
        h, r = len(heavy), len(kept)
        lead = mpmath.zeros(r + h)
        A = mpmath.zeros(r + h)
        for i in range(h):
            lead[i, i] = 1
            A[i, r + i] = 1
        for row, i in enumerate(kept):
            for column, j in enumerate(kept):
                A[h + row, column] = -K_kept[row, column]
                if column < h:
                    lead[h + row, r + column] = M[i, j]
                    A[h + row, r + column] -= C[i, j]
                else:
                    lead[h + row, column] = C[i, j]
        # y = (a, z, a'), augmented by e^{st} for each force
        size = r + h + len(forces)
        G = mpmath.zeros(size)
        inverse = lead**-1
        top = inverse * A
        for i in range(r + h):
            for j in range(r + h):
                G[i, j] = top[i, j]
        for number, (s, force) in enumerate(forces):
            f = [mpmath.mpc(x) for x in force]
            reduced = mpmath.matrix([f[i] for i in kept])
            if still:
                reduced -= part(K, kept, still) * (part(K, still, still)**-1 * mpmath.matrix([f[i] for i in still]))
            column = inverse * mpmath.matrix([0] * h + list(reduced))
            for i in range(r + h):
                G[i, r + h + number] = column[i]
            G[r + h + number, r + h + number] = mpmath.mpc(s)
        y = mpmath.matrix([q0[i] for i in kept] + [v0[i] for i in heavy] + [1] * len(forces))
        y = mpmath.expm(G * mpmath.mpf(t)) * y
        found = []
        for order in range(3):
            state = G**order * y
            q = [mpmath.mpc(0)] * n
            for place, i in enumerate(kept):
                q[i] = state[place]
            if still:
                pushed = [sum(mpmath.mpc(s)**order * mpmath.mpc(force[i]) * y[r + h + number]
                              for number, (s, force) in enumerate(forces)) for i in still]
                rest = follow * state[:r] + part(K, still, still)**-1 * mpmath.matrix(pushed)
                for place, i in enumerate(still):
                    q[i] = rest[place]
            found.append(np.array([float(x.real) for x in q]))
        return found


@pytest.mark.sweep
@pytest.mark.parametrize("kinds", KINDS)
@pytest.mark.parametrize("symmetric", [True, False])
def test_free_and_forced_motion_against_matrix_exponentials(kinds, symmetric):
    dice = np.random.default_rng(len(kinds) + 10 * symmetric)
    n = len(kinds)
    M, C, K = system(kinds, dice, symmetric)
    loads = dice.normal(size=(3, n))
    rates = [0j, 1.7j, -0.4 + 0.9j]
    waves = [Wave(i, complex(loads[k, i]), 0, s) for k, s in enumerate(rates) for i in range(n)]
    q0, v0 = dice.normal(size=n), np.where(M.diagonal() > 0, dice.normal(size=n), 0.0)
    forces = [(s, loads[k]) for k, s in enumerate(rates)]
    motion = linear_motion(M, C, K, Forcing(n, [Segment(0.0, tuple(waves))]), q0, v0)
    for t in (0.0, 0.3, 6.0):
        for order, wanted in enumerate(exact(M, C, K, forces, q0, v0, t)):
            found = [motion.values(LinearOutput(q={i: 1.0}), np.array([t]), order)[0] for i in range(n)]
            assert np.abs(found - wanted).max() <= 2e-12 * max(1.0, np.abs(wanted).max()), (t, order)
            if order:
                found = [motion.values(LinearOutput(v={i: 1.0}), np.array([t]), order - 1)[0] for i in range(n)]
                assert np.abs(found - wanted).max() <= 2e-12 * max(1.0, np.abs(wanted).max()), (t, order)
    steady = motion.steady
    for i in range(n):
        H = dict(steady.phasors(LinearOutput(q={i: 1.0})))
        D = K + 1.7j * C - 1.7**2 * M
        assert abs(H[1.7] - np.linalg.solve(D, loads[1])[i]) < 1e-12
    output = LinearOutput(q={0: 1.0})
    rest = motion.transient.values(output, np.array([0.5])) + steady.values(output, [0.5])
    assert rest[0] == pytest.approx(motion.values(output, [0.5])[0], abs=1e-12)


def test_what_springs_alone_hold_follows_its_load():
    K = np.array([[3.0, -1.0], [-1.0, 2.0]])
    load = (Wave(0, 1 - 2j, 0, 3j), Wave(1, 0.5, 1, 0j))
    motion = linear_motion(np.zeros((2, 2)), np.zeros((2, 2)), K, Forcing(2, [Segment(0.0, load)]), [0, 0], [0, 0])
    t = np.linspace(0, 2, 9)
    force = np.array([np.real((1 - 2j) * np.exp(3j * t)), 0.5 * t])
    for i, wanted in enumerate(np.linalg.solve(K, force)):
        assert np.abs(motion.values(LinearOutput(q={i: 1.0}), t) - wanted).max() < 1e-15
    assert motion.extreme(LinearOutput(q={1: 1.0}), 0.0, 2.0)[1] >= motion.values(LinearOutput(q={1: 1.0}), t).max()


def test_dampers_that_hold_only_a_stretch():
    """z₁ −c− z₂, each on a spring to the ground: the stretch relaxes at (k₁k₂/(k₁ + k₂))/c, the rest follows it."""
    c, k = 2.0, np.array([3.0, 5.0])
    C = c * np.array([[1.0, -1.0], [-1.0, 1.0]])
    motion = linear_motion(np.zeros((2, 2)), C, np.diag(k), Forcing(2, [Segment(0.0)]), [0.05, -0.03], [0, 0])
    t = np.linspace(0, 3, 7)
    stretch = 0.08 * np.exp(-k.prod() / k.sum() / c * t)
    assert np.abs(motion.values(LinearOutput(q={0: 1.0}), t) - stretch * k[1] / k.sum()).max() < 1e-15
    assert np.abs(motion.values(LinearOutput(q={1: 1.0}), t) + stretch * k[0] / k.sum()).max() < 1e-15


REFUSED = {
    "a blow on a joint of springs": (np.diag([1.0, 0]), np.zeros((2, 2)), np.array([[2.0, -1], [-1, 2]]),
                                     ((1, 1.0),), "a blow falls on"),
    "nothing holds it": (np.diag([1.0, 0]), np.zeros((2, 2)), np.diag([2.0, 0]), (), "neither inertia, damper nor"),
    "velocities drive it": (np.diag([1.0, 0]), np.array([[0.0, 1], [-1, 0]]), np.diag([2.0, 3]), (), "driven by veloc"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_determined_is_refused(name):
    M, C, K, blows, words = REFUSED[name]
    with pytest.raises(PhysicsError, match=words) as refusal:
        motion = linear_motion(M, C, K, Forcing(2, [Segment(0.0, (), blows)]), [0.0, 0.0], [0.0, 0.0])
        motion.values(LinearOutput(q={0: 1.0}), np.array([1.0]))
    assert refusal.value.hint


def test_small_inertias_tend_to_none():
    """The motion with m → 0 differs by O(m) once its own fast vibration is gone."""
    dice = np.random.default_rng(3)
    M, C, K = system("mzs", dice)
    bare = linear_motion(M, C, K, Forcing(3, [Segment(0.0)]), [0.1, 0.2, 0.0], [0.3, 0.0, 0.0])
    start = bare.start
    for small in (1e-5, 1e-7):
        heavy = M + np.diag([0, small, small])
        dragged = C + np.diag([0, 0, 1e-2 * np.sqrt(small)])
        full = linear_motion(heavy, dragged, K, Forcing(3, [Segment(0.0)]), start, [0.3, 0.0, 0.0])
        for i in range(2):
            apart = full.values(LinearOutput(q={i: 1.0}), [1.0]) - bare.values(LinearOutput(q={i: 1.0}), [1.0])
            assert abs(apart[0]) < 20 * np.sqrt(small)


def test_zener_against_its_cubic():
    """m c λ³ + m k₁ λ² + c (k + k₁) λ + k k₁ = 0 in 40 digits, from x = x₀ at rest with u = 0."""
    scene = problem("""
        bodies: {block: {mass: 2 kg, slide: x}, joint: {slide: u}}
        springs: {s: {k: 50 N/m, between: [ground, block]}, s1: {k: 80 N/m, between: [block, joint]}}
        dampers: {d: {c: 6 N*s/m, between: [ground, joint]}}
        initial: {x: 2 cm}
    """)
    with mpmath.workdps(40):
        roots = mpmath.polyroots([12, 160, 780, 4000], maxsteps=200, extraprec=200)
        x0 = mpmath.mpf(2) / 100
        start = mpmath.matrix([x0, 0, -65 * x0])        # x, x', x'' = −(k + k₁) x₀/m
        parts = mpmath.lu_solve(mpmath.matrix([[root**order for root in roots] for order in range(3)]), start)
        for text, order, t in (("x(0.4 s)", 0, 0.4), ("x'(1.1 s)", 1, 1.1), ("x''(0.05 s)", 2, 0.05)):
            exact = mpmath.re(sum(part * root**order * mpmath.exp(root * mpmath.mpf(str(t)))
                                  for part, root in zip(parts, roots, strict=True)))
            assert measure(scene, parse(text))[0] == pytest.approx(float(exact), rel=1e-13, abs=1e-16)


LETTERS = """
parameters: {k: , c: , u0: , F0: , W: }
bodies: {node: {slide: u}}
springs: {s: {k: k, between: [ground, node]}}
dampers: {d: {c: c, between: [ground, node]}}
"""


@pytest.mark.parametrize(("more", "lines"), [
    ("initial: {u: u0}\n", ["u = u₀·exp(−k·t/c)"]),
    ("forces: {F: {at: node, force: F0*sin(W*t)}}\n", ["X = F₀/√(k² + c²·W²)", "tan θ = c·W/k", "A = X·sin θ"])])
def test_relaxation_in_letters(more, lines, tmp_path, capsys):
    unused = {"u0", "F0", "W"} - set(re.findall(r"\w+", more))
    text = LETTERS
    for name in unused:
        text = text.replace(f", {name}: ", "")
    file = tmp_path / "scene.yaml"
    file.write_text(text + more)
    assert run(["response", str(file)]) == 0
    out = capsys.readouterr().out
    assert all(line in out for line in lines), out
    assert run(["solve", str(file)]) == 0
    assert "λ = −k/c" in capsys.readouterr().out


@pytest.mark.parametrize(("stiffness", "words"), [("3 N/m", "stable"), ("-3 N/m", "unstable")])
def test_stability_without_inertia(stiffness, words):
    scene = problem(f"""
        bodies: {{a: {{slide: x}}, b: {{slide: y}}}}
        energies: {{V: "{stiffness}/2*x^2 + (x - y)^2*40 N/m"}}
        dampers: {{d: {{c: 4 N*s/m, between: [ground, a]}}, e: {{c: 4 N*s/m, between: [ground, b]}}}}
    """)
    assert scene.modal.stability.stable is (words == "stable")
    assert WORDS[stability(scene.modal).kind] == words


@pytest.mark.sweep
@pytest.mark.parametrize("kinds", ["mz", "mzs", "zs"])
def test_digits_without_inertia(kinds):
    """To 30 digits, and as the floats: values, rates and accelerations after a step, a wave and a blow."""
    M, C, K = system(kinds, np.random.default_rng(8))
    n = len(kinds)
    blow = ((0, 0.25),)
    waves = Wave(0, 1 - 0.5j, 0, 1.5j), Wave(1, 0.5, 1, 0j)
    pieces = [Segment(0.0, (Wave(n - 1, 2.0, 0, 0j),)), Segment(0.5, waves, blow)]
    start = [0.125] * n, [0.5 if M[i, i] else 0.0 for i in range(n)]
    motion = linear_motion(M, C, K, Forcing(n, pieces), *start)
    matrices = [matrix.tolist() for matrix in (M, C, K)]
    for output in (LinearOutput(q={n - 1: 1.0}), LinearOutput(0.5, {0: 1.0}, {n - 1: 2.0}, {1: 0.5})):
        for order in range(2):
            some = [precise_value(*matrices, motion.forcing, *start, output, 1.25, digits, order)
                    for digits in (16, 30)]
            found = motion.values(output, np.array([1.25]), order)[0]
            assert abs(some[0] - some[1]) <= 1e-16 * abs(some[1])
            assert found == pytest.approx(float(some[1]), rel=1e-12)


def test_relaxation_to_forty_digits(tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text("""
bodies: {a: {slide: u}}
springs: {s: {k: 50 N/m, between: [ground, a]}}
dampers: {d: {c: 6 N*s/m, between: [ground, a]}}
initial: {u: 2 cm}
""")
    assert run(["response", str(file), "--at", "0.1", "--digits", "40"]) == 0
    with mpmath.workdps(50):
        exact = mpmath.nstr(mpmath.exp(-mpmath.mpf(5) / 6) / 50, 40)
    assert exact in capsys.readouterr().out


def test_digits_are_refused_where_dampers_hold_only_a_stretch():
    C = [[2, -2], [-2, 2]]
    with pytest.raises(PhysicsError, match="only some motions") as refusal:
        precise_value([[0, 0], [0, 0]], C, [[3, 0], [0, 5]], Forcing(2, [Segment(0.0)]), [1, 0], [0, 0],
                      LinearOutput(q={0: 1.0}), 1, 20)
    assert refusal.value.hint == "leave --digits out"


@pytest.mark.sweep
def test_the_start_that_is_told_is_where_what_follows_stands(tmp_path, capsys):
    """(k + k₁) u = k₁ x + F cos Wt at t = 0, which the report and --json say."""
    file = tmp_path / "scene.yaml"
    file.write_text("""
bodies: {block: {mass: 2 kg, slide: x}, joint: {slide: u}}
springs: {s: {k: 50 N/m, between: [ground, joint]}, s1: {k: 80 N/m, between: [block, joint]}}
dampers: {d: {c: 6 N*s/m, between: [ground, block]}}
forces: {F: {at: joint, force: 3 N*cos(4 rad/s*t)}}
initial: {x: 2 cm}
""")
    assert run(["response", str(file), "--json"]) == 0
    initial = json.loads(capsys.readouterr().out)["response"]["initial"]
    assert initial["u"] == pytest.approx((80 * 0.02 + 3) / 130, rel=1e-14) and initial["x"] == 0.02
    assert run(["response", str(file)]) == 0
    assert "u(0) = 0.0353846 m" in capsys.readouterr().out
