"""What follows ramps and parabolas in letters, its limits, and means of harmonic steady states, against SymPy."""

import pytest
import sympy
from support.scenes import problem

import vibcli
from vibcli.symbolic.in_sympy import in_sympy

TOWED = """
parameters: {{m: , k: , c: , e: , v: }}
points: {{end: {{at: [0, 0], moves: [{path}, 0]}}}}
bodies:
  a: {{mass: m, at: [1, 0], slide: {{along: [1, 0], by: x}}}}
  b: {{mass: 2*m, at: [2, 0], slide: {{along: [1, 0], by: z}}}}
springs: {{s: {{k: k, between: [end, a]}}, q: {{k: 3*k, between: [a, b]}}}}
dampers: {{d: {{c: c, between: [[0, 0], a]}}, f: {{c: e, between: [[0, 0], b]}}}}
"""
m, k, c, e, v = sympy.symbols("m k c e v", positive=True)
t = sympy.Symbol("t")


def same(found, expected):
    return sympy.simplify(found - expected) == 0


@pytest.mark.parametrize("path", ["v*t", "v*t^2/2", "v*t^3 - 2*v*t"])
def test_what_follows_the_time_obeys_the_equations_of_motion(path):
    scene = problem(TOWED.format(path=path))
    end = sympy.sympify(path.replace("^", "**"), {"v": v, "t": t})
    x, z, seen, force = (part.subs(sympy.Symbol("t", positive=True), t) for part in in_sympy(
        [scene.symbolic_following(name) for name in ("x", "z", "end.x", "q.force")], ()))
    assert same(seen, end) and same(force, 3 * k * (z - x))
    assert same(m * x.diff(t, 2) + c * x.diff(t), k * (end - x) + 3 * k * (z - x))
    assert same(2 * m * z.diff(t, 2) + e * z.diff(t), -3 * k * (z - x))


def test_limits_behind_a_ramp_in_letters():
    scene = vibcli.loads(TOWED.format(path="v*t"))
    for text, expected in (("final(end.x - x)", (c + e) * v / k), ("final(x - z)", e * v / (3 * k)),
                           ("final(s.force)", -(c + e) * v), ("final(x')", v),
                           ("final(x'*(x - z))", e * v**2 / (3 * k))):
        assert same(scene[text].expression.to_sympy(), expected), text
    with pytest.raises(vibcli.PhysicsError, match="grows without end"):
        scene["final(x)"]


def test_limits_need_dampers():
    scene = vibcli.loads(TOWED.format(path="v*t").split("dampers")[0].replace("c: , e: , ", ""))
    with pytest.raises(vibcli.PhysicsError, match="die out"):
        scene["final(end.x - x)"]


def test_means_of_a_harmonic_in_letters():
    scene = vibcli.loads("""
parameters: {m: , k: , c: , v: , w: }
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
dampers: {d: {c: c, between: [ground, a]}}
forces: {P: {at: a, force: v*sin(w*t)}}
""")
    w = sympy.Symbol("w", positive=True)
    square = v**2 / ((k - m * w**2) ** 2 + (c * w) ** 2) / 2
    for text, expected in (("mean(x^2)", square), ("rms(x)^2", square), ("mean(x'^2)", square * w**2),
                           ("rms(d.force)^2", (c * w) ** 2 * square), ("mean(x)", sympy.Integer(0))):
        assert same(scene[text].expression.to_sympy(), expected), text
    with pytest.raises(vibcli.PhysicsError, match="in numbers"):
        scene["mean(x*x')"]
