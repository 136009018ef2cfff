"""Inerters against Lagrange's equations written by hand: T has ½ b ṡ² more, and b s̈ acts between the two ends."""

from math import sqrt

import pytest
from support.scenes import problem, value
from sympy import Matrix, cos, diff, hessian, lambdify, sin, symbols

P = {"m1": 3.0, "m2": 2.0, "k1": 500.0, "k2": 300.0, "b": 1.5, "J": 0.4, "B": 0.7, "kt": 90.0}
HEAD = "".join(["parameters:\n", *(f"  {name}: {{value: {number}, unused: allowed}}\n" for name, number in P.items())])
m1, m2, k1, k2, b, J, B, kt = P.values()
CHAIN = """
bodies: {one: {mass: m1, slide: x1}, two: {mass: m2, slide: x2}}
springs: {s: {k: k1, between: [ground, one]}, t: {k: k2, between: [one, two]}}
inerters: {i: {b: b, between: [one, two]}}
initial: {x1: 0.02, x2': 0.3}
"""


def linear(T, V, q, v):
    """M, K, and q̈ of small oscillations as a function of the coordinates, by SymPy from T and V."""
    M, K = hessian(T, v), hessian(V, q)
    return M, K, lambdify(q, list(-M.inv() * K * Matrix(q)))


def two_masses():
    q, v = symbols("x1 x2"), symbols("v1 v2")
    T = (m1 * v[0] ** 2 + m2 * v[1] ** 2 + b * (v[1] - v[0]) ** 2) / 2
    V = (k1 * q[0] ** 2 + k2 * (q[1] - q[0]) ** 2) / 2
    return linear(T, V, q, v)


def test_matrices_and_frequencies_of_two_masses():
    M, K, _ = two_masses()
    found = problem(HEAD + CHAIN)
    squares = sorted(complex(w).real for w in (M.inv() * K).eigenvals())
    for i in range(2):
        assert value(found, f"omega[{i + 1}]") == pytest.approx(sqrt(squares[i]), rel=1e-12)
        for j in range(2):
            assert value(found, f"M[x{i + 1},x{j + 1}]") == pytest.approx(float(M[i, j]), rel=1e-13)


@pytest.mark.parametrize("motion", ["small", "full"])
@pytest.mark.parametrize("t", [0.0, 0.1, 0.37])
def test_the_force_is_b_times_the_acceleration_of_the_stretch(motion, t):
    _, _, accelerations = two_masses()
    found = problem(HEAD + CHAIN + f"motion: {motion}\n")
    x1, x2, force, stretch = (value(found, f"{name}({t} s)") for name in ("x1", "x2", "i.force", "i.stretch"))
    a1, a2 = accelerations(x1, x2)
    assert stretch == pytest.approx(x2 - x1, abs=1e-12)
    assert force == pytest.approx(b * (a2 - a1), rel=1e-8)


def test_torsion_acts_between_rotations():
    found = problem(HEAD + """
bodies: {one: {inertia: J, turn: u}, two: {inertia: J, turn: w}}
springs: {s: {torsion: kt, between: [ground, one]}}
inerters: {i: {torsion: B, between: [one, two]}, g: {torsion: B, between: [ground, two]}}
initial: {u: 0.1}
""")
    assert [value(found, f"M[{pair}]") for pair in ("u,u", "u,w", "w,w")] == pytest.approx([J + B, -B, J + 2 * B])
    W = kt * (J + 2 * B) / ((J + B) * (J + 2 * B) - B**2)
    assert value(found, "omega[2]") == pytest.approx(sqrt(W), rel=1e-12)
    u = value(found, "u(0.2 s)")
    assert value(found, "g.force(0.2 s)") == pytest.approx(B * B / (J + 2 * B) * -W * u, rel=1e-9)
    assert value(found, "ground.moment(0.2 s)") == pytest.approx(
        kt * u + value(found, "g.force(0.2 s)"), rel=1e-9)


def test_between_places_it_acts_along_their_line():
    found = problem(HEAD + """
bodies: {p: {mass: m1, at: [0, 0], move: [x, y, 0]}}
springs: {s: {k: k1, between: [[0, -1], p], free_length: 0}}
inerters: {i: {b: b, between: [[3, 4], p]}}
""")
    c, s = 3 / sqrt(34), 5 / sqrt(34)     # the spring draws it to [0, -1]
    assert value(found, "M[x,x]") == pytest.approx(m1 + b * c * c)
    assert value(found, "M[x,y]") == pytest.approx(b * c * s)
    assert value(found, "M[y,y]") == pytest.approx(m1 + b * s * s)


def test_on_a_shaken_end_it_passes_on_the_acceleration():
    """m ẍ + k x = b (ü − ẍ), u = h sin Ωt: X = b Ω² h/((m + b) Ω² − k) in size."""
    h, Omega = 0.01, 9.0
    found = problem(HEAD + f"""
points: {{wall: {{at: [0, 0], moves: [{h}*sin({Omega}*t), 0]}}}}
bodies: {{p: {{mass: m1, at: [1, 0], slide: x}}}}
springs: {{s: {{k: k1, between: [p, [2, 0]]}}}}
inerters: {{i: {{b: b, between: [wall, p]}}}}
""")
    X = -b * Omega**2 * h / (k1 - (m1 + b) * Omega**2)
    assert value(found, "amplitude(x)") == pytest.approx(abs(X), rel=1e-10)
    assert value(found, "amplitude(i.force)") == pytest.approx(b * Omega**2 * abs(X - h), rel=1e-10)


@pytest.mark.sweep
def test_a_swinging_end_is_that_of_lagrange():
    """A pendulum with an inerter from its bob to a wall: the full equation of motion against SymPy's."""
    found = problem(HEAD + """
bodies: {p: {mass: m1, at: [0, -1], pin: {at: [0, 0], by: f}}}
springs: {s: {torsion: kt, between: [ground, p]}}
inerters: {i: {b: b, between: [[2, -1], p]}}
initial: {f: 0.4}
motion: full
""")
    f, w, a = symbols("f w a")
    s = ((2 - sin(f)) ** 2 + (1 - cos(f)) ** 2) ** 0.5
    T, V = m1 * w**2 / 2 + b * (diff(s, f) * w) ** 2 / 2, kt * f**2 / 2
    residual = diff(T, w, w) * a + diff(T, w, f) * w - diff(T - V, f)
    solved = lambdify((f, w), (residual.subs(a, 0) / -diff(T, w, w)))
    at = {name: value(found, f"{name}(0.2 s)") for name in ("f", "f'", "f''")}
    assert at["f''"] == pytest.approx(solved(at["f"], at["f'"]), rel=1e-7)
    slope = lambdify(f, diff(s, f))
    bend = lambdify(f, diff(s, f, 2))
    acceleration = slope(at["f"]) * at["f''"] + bend(at["f"]) * at["f'"] ** 2
    assert value(found, "i.force(0.2 s)") == pytest.approx(b * acceleration, rel=1e-7)


def test_it_has_its_share_of_the_kinetic_energy():
    found = problem(HEAD + "bodies: {one: {mass: m1, slide: x1}}\n"
                    "springs: {s: {k: k1, between: [ground, one]}}\ninerters: {i: {b: b, between: [ground, one]}}\n")
    shares = found.modal.result("shares").kinetic[1] if hasattr(found, "modal") else found.shares.kinetic[1]
    assert shares == pytest.approx({"one": m1 / (m1 + b), "i": b / (m1 + b)})
