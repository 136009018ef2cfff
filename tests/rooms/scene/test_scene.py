"""Every motion, and what bodies are made of: kinetic and potential energy against formulas derived by hand.

One coordinate each unless said: T = ½ M(q) q̇², so M[q,q] as drawn, and V(q) − V(drawn) at finite displacements.
"""

from math import atan2, cos, hypot, pi, sin, sqrt

import pytest
from support.scenes import problem, value

from vibcli.base.errors import SpecError
from vibcli.mechanics.energies import kinetic, potential
from vibcli.symbolic.evaluation import Floats, evaluate

P = {"m": 2.0, "r": 0.1, "R": 0.5, "L": 0.6, "g": 9.81, "k": 300.0, "M": 5.0, "h": 0.2}
HEAD = "".join(["parameters:\n", *(f"  {name}: {{value: {number}, unused: allowed}}\n" for name, number in P.items())])
m, r, R, L, g, k, M, h = P.values()


def scene(text, gravity="gravity: g\n"):
    """A scene of plain SI numbers with the parameters P and gravity."""
    return problem(HEAD + gravity + text)


def energies(found, q, v):
    """(T, V) at {coordinate: value} and velocities in the same order."""
    names = found.scene.coordinates
    state = dict(zip(names, q, strict=True)) | {n + "'": x for n, x in zip(names, v, strict=True)}
    return evaluate([kinetic(found.scene), potential(found.scene)], Floats, found.numeric.floats | state)


def matches(found, T, V, places=((0.3,), (-0.7,), (1.9,)), speeds=((1.0,), (-2.5,), (0.4,))):
    """T and V of a scene at finite displacements against functions of (q, v) and (q)."""
    zero = tuple(found.numeric.drawn_floats.values())
    V0, ours0 = V(*zero), energies(found, zero, zero)[1]
    for q, v in zip(places, speeds, strict=True):
        t, u = energies(found, q, v)
        assert t == pytest.approx(T(*q, *v), rel=1e-13)
        assert u - ours0 == pytest.approx(V(*q) - V0, rel=1e-12, abs=1e-12)


disc_T = 0.75 * m      # times (r·turn)²
ONE = {
    "slide along x": ("bodies: {b: {mass: m, at: [1, 2], slide: x}}", lambda q, v: m * v**2 / 2, lambda q: 0),
    "slide on an incline": ("bodies: {b: {mass: m, at: [1, 2], slide: {along: [3, 4], by: x}}}",
                            lambda q, v: m * v**2 / 2, lambda q: m * g * q * 0.8),
    "slide by an expression": ("coordinates: [x]\nbodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 2], by: "
                               "x^2/L}}}",
                               lambda q, v: m * (2 * q * v / L) ** 2 / 2, lambda q: m * g * q**2 / L),
    "pinned rod": ("bodies: {b: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: f}}}",
                   lambda q, v: m * L**2 * v**2 / 6, lambda q: -m * g * L / 2 * cos(q)),
    "pinned at its centre": ("bodies: {b: {shape: disc, mass: m, radius: R, at: [1, 1], pin: f}}",
                             lambda q, v: m * R**2 * v**2 / 4, lambda q: 0),
    "pinned at a point": ("points: {O: [R, 0]}\nbodies: {b: {mass: m, at: [0, 0], pin: {at: O, by: "
                          "-2*f}}}\ncoordinates: [f]",
                          lambda q, v: 2 * m * R**2 * v**2, lambda q: m * g * R * sin(2 * q)),
    "disc on a line, travel": ("surfaces: {l: {line: [[0, 0], [3, 4]]}}\n"
                               "bodies: {b: {shape: disc, mass: m, radius: r, at: [-0.8*r, 0.6*r], roll: {surface: l, "
                               "travel: x}}}", lambda q, v: 0.75 * m * v**2, lambda q: m * g * 0.8 * q),
    "disc below a line": ("surfaces: {l: {line: [[0, 0], [3, 4]]}}\n"
                          "bodies: {b: {shape: disc, mass: m, radius: r, at: [0.8*r, -0.6*r], roll: {surface: l, "
                          "turn: f}}}",
                          lambda q, v: disc_T * r**2 * v**2, lambda q: m * g * 0.8 * r * q),
    "disc above a line": ("surfaces: {l: {line: [[0, 0], [3, 4]]}}\n"
                          "bodies: {b: {shape: disc, mass: m, radius: r, at: [-0.8*r, 0.6*r], roll: {surface: l, "
                          "turn: f}}}",
                          lambda q, v: disc_T * r**2 * v**2, lambda q: -m * g * 0.8 * r * q),
    "rolling on a hub": ("surfaces: {l: {line: [[0, 0], [0, 1]]}}\n"
                         "bodies: {b: {shape: disc, mass: m, radius: R, at: [h, 3], roll: {surface: l, travel: x, "
                         "radius: h}}}",
                         lambda q, v: (m + m * R**2 / 2 / h**2) * v**2 / 2, lambda q: m * g * q),
    "inside, turn": ("surfaces: {c: {circle: [0, 0], radius: R, side: inside}}\n"
                     "bodies: {b: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: c, turn: f}}}",
                     lambda q, v: disc_T * r**2 * v**2, lambda q: -m * g * (R - r) * cos(r * q / (R - r))),
    "inside, swing": ("surfaces: {c: {circle: [0, 0], radius: R, side: inside}}\n"
                      "bodies: {b: {shape: ring, mass: m, radius: r, at: [0, r - R], roll: {surface: c, swing: f}}}",
                      lambda q, v: m * (R - r) ** 2 * v**2, lambda q: -m * g * (R - r) * cos(q)),
    "inside, travel": ("surfaces: {c: {circle: [1, 0], radius: R, side: inside}}\n"
                       "bodies: {b: {shape: disc, mass: m, radius: r, at: [1, r - R], roll: {surface: c, travel: x}}}",
                       lambda q, v: 0.75 * m * v**2, lambda q: -m * g * (R - r) * cos(q / (R - r))),
    "outside": ("surfaces: {c: {circle: [0, 0], radius: R}}\n"
                "bodies: {b: {shape: disc, mass: m, radius: r, at: [0, r + R], roll: {surface: c, turn: f}}}",
                lambda q, v: disc_T * r**2 * v**2, lambda q: m * g * (R + r) * cos(r * q / (R + r))),
    "a ring on a peg": ("surfaces: {c: {circle: [0, 0], radius: r}}\n"
                        "bodies: {b: {shape: ring, mass: m, radius: R, at: [0, r - R], roll: {surface: c, turn: f}}}",
                        lambda q, v: m * R**2 * v**2, lambda q: -m * g * (R - r) * cos(R * q / (R - r))),
    "move along a circle": ("coordinates: [f]\nbodies: {b: {shape: rod, mass: m, from: [0, 0], to: [0, L], move: "
                            "[L/2*sin(f), L/2*cos(f), -f]}}",
                            lambda q, v: m * (L / 2) ** 2 * v**2 / 2 + m * L**2 / 24 * v**2,
                            lambda q: m * g * L / 2 * cos(q)),
    "welded to a pinned rod": ("bodies:\n  a: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: "
                               "f}}\n"
                               "  b: {shape: disc, mass: M, radius: r, at: [L, h], weld: a}",
                               lambda q, v: (m * L**2 / 3 + M * (r**2 / 2 + L**2 + h**2)) * v**2 / 2,
                               lambda q: m * g * L / 2 * sin(q) + M * g * (L * sin(q) + h * cos(q))),
    "without motion": ("bodies:\n  a: {mass: M, at: [0, 0]}\n  b: {mass: m, at: [0, 0], slide: {along: [0, -1], by: "
                       "x}}",
                       lambda q, v: m * v**2 / 2, lambda q: -m * g * q),
    "lumped mass and inertia": ("coordinates: [x]\nbodies:\n  a: {mass: m, slide: x}\n  b: {inertia: m*R^2, turn: "
                                "-x/r}\n"
                                "  c: {shape: disc, mass: M, radius: R, turn: 2*x/R}",
                                lambda q, v: (m + m * R**2 / r**2 + M * R**2 / 2 * 4 / R**2) * v**2 / 2, lambda q: 0),
    "drawn at an angle": ("coordinates: {f: {drawn: pi/3}}\nbodies: {b: {mass: m, at: [L*sin(pi/3), -L*cos(pi/3)], "
                          "move: [L*sin(f), -L*cos(f), f]}}", lambda q, v: m * L**2 * v**2 / 2,
                          lambda q: -m * g * L * cos(q)),
    "pin of a drawn angle": ("coordinates: {f: {drawn: pi/6}}\nbodies: {b: {mass: m, at: [L*sin(pi/6), -L*cos(pi/6)], "
                             "pin: {at: [0, 0], by: f}}}", lambda q, v: m * L**2 * v**2 / 2,
                             lambda q: -m * g * L * cos(q)),
    "gyration": ("bodies: {b: {mass: m, gyration: h, at: [0, -L], pin: {at: [0, 0], by: f}}}",
                 lambda q, v: m * (h**2 + L**2) * v**2 / 2, lambda q: -m * g * L * cos(q)),
    "inertia instead of the shape's": ("bodies: {b: {shape: disc, radius: R, mass: m, inertia: 3*m*R^2, at: [0, 0], "
                                       "pin: f}}",
                                       lambda q, v: 1.5 * m * R**2 * v**2, lambda q: 0),
    "energies written out": ("energies: {T: 1/2*M*(1 + (x/L)^2)*x'^2, V: k*x^4/L^2}",
                             lambda q, v: M * (1 + (q / L) ** 2) * v**2 / 2, lambda q: k * q**4 / L**2),
}


@pytest.mark.parametrize("name", ONE)
def test_one_coordinate(name):
    text, T, V = ONE[name]
    matches(scene(text), T, V)


def two(q, v):
    return q, v


def carried_pin(relative):
    """A rod on a turning arm; the bob's angle is measured from the fixed frame or from the arm."""
    def T(a, b, u, w):
        B, W = (a + b, u + w) if relative else (b, w)
        x, y = -R * sin(a) * u - L * sin(B) * W, R * cos(a) * u + L * cos(B) * W
        return m * (x * x + y * y) / 2

    def V(a, b):
        return m * g * (R * sin(a) + L * sin(a + b if relative else b))
    return T, V


PLACES, SPEEDS = ((0.3, -0.4), (-1.1, 0.2), (0.05, 2.0)), ((1.0, -2.0), (0.4, 3.0), (-1.0, -1.0))


@pytest.mark.parametrize("relative", [False, True])
@pytest.mark.parametrize("pin", ["{at: [R, 0], carrier: arm, by: b RELATIVE}", "{at: P, by: b RELATIVE}"])
def test_a_carried_pin(relative, pin):
    text = ("points: {P: {body: arm, at: [R, 0]}}\nbodies:\n  arm: {inertia: 0, at: [0, 0], pin: {at: [0, 0], by: a}}\n"
            f"  bob: {{mass: m, at: [R + L, 0], pin: {pin}}}").replace("RELATIVE", ", relative: "
                                                            "true" if relative else "")
    if "at: P" not in pin:
        text = text.split("\n", 1)[1]
    if relative and "at: P" in pin:
        text = text.replace("by: b", "carrier: arm, by: b")
    found = scene(text)
    matches(found, *carried_pin(relative), PLACES, SPEEDS)


def test_a_carried_slide_turns_with_its_carrier():
    text = ("bodies:\n  tube: {inertia: 0, at: [0, 0], pin: {at: [0, 0], by: a}}\n"
            "  bead: {shape: disc, radius: r, mass: m, at: [h, 0], slide: {along: [1, 0], by: s, carrier: tube}}")

    def T(a, s, u, w):
        return m * (w**2 + (h + s) ** 2 * u**2) / 2 + m * r**2 / 4 * u**2
    matches(scene(text), T, lambda a, s: m * g * (h + s) * sin(a), PLACES, SPEEDS)


def test_a_move_in_a_turning_carrier():
    text = ("bodies:\n  plate: {inertia: 0, at: [0, 0], pin: {at: [0, 0], by: a}}\n"
            "  b: {shape: rod, mass: m, from: [0, h - L/2], to: [0, h + L/2], move: {by: [0, y, 2*y/L], carrier: "
            "plate}}")

    def T(a, y, u, w):
        return m * (w**2 + (h + y) ** 2 * u**2) / 2 + m * L**2 / 24 * (u + 2 * w / L) ** 2
    matches(scene(text + "\ncoordinates: [a, y]"), T, lambda a, y: m * g * (h + y) * cos(a), PLACES, SPEEDS)


@pytest.mark.parametrize("by", ["travel: s", "turn: -s/r"])
def test_rolling_on_a_carried_line(by):
    text = ("surfaces: {l: {line: [[0, 0], [1, 0]], body: plank}}\ncoordinates: [a, s]\nbodies:\n"
            "  plank: {inertia: 0, at: [0, 0], pin: {at: [0, 0], by: a}}\n"
            f"  disc: {{shape: disc, mass: m, radius: r, at: [0, r], roll: {{surface: l, {by}}}}}")

    def T(a, s, u, w):
        d, dd, turn = (s, w, u - w / r) if by == "travel: s" else (s + r * a, w + r * u, -w / r)
        x = dd * cos(a) - d * sin(a) * u - r * cos(a) * u
        y = dd * sin(a) + d * cos(a) * u - r * sin(a) * u
        return m * (x * x + y * y) / 2 + m * r**2 / 4 * turn**2

    def V(a, s):
        return m * g * ((s if by == "travel: s" else s + r * a) * sin(a) + r * cos(a))
    matches(scene(text), T, V, PLACES, SPEEDS)


def test_rolling_in_a_turning_track():
    text = ("surfaces: {c: {circle: [0, 0], radius: R, side: inside, body: drum}}\nbodies:\n"
            "  drum: {shape: ring, mass: M, radius: R, at: [0, 0], pin: a}\n"
            "  disc: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: c, turn: b}}")

    def T(a, b, u, w):      # contact: R u = v + r w with v = (R − r)·swing' of the centre
        swing = (R * u - r * w) / (R - r)
        return M * R**2 * u**2 / 2 + m * (R - r) ** 2 * swing**2 / 2 + m * r**2 / 4 * w**2
    matches(scene(text), T, lambda a, b: -m * g * (R - r) * cos((R * a - r * b) / (R - r)), PLACES, SPEEDS)


SHAPES = {
    "shape: disc, radius: R": (pi * R**2, m * R**2 / 2), "shape: ring, radius: R": (2 * pi * R, m * R**2),
    "shape: rectangle, width: L, height: h": (L * h, m * (L**2 + h**2) / 12),
    "shape: ellipse, a: R, b: r": (pi * R * r, m * (R**2 + r**2) / 4), "shape: particle": (None, 0.0),
    "shape: sector, radius: R, half_angle: pi/4": (pi / 4 * R**2, m * (R**2 / 2 - (8 * sqrt(0.5) * R / (3 * pi)) ** 2)),
    "shape: arch, radius: R, half_angle: pi/2": (pi * R, m * (R**2 - (2 * R / pi) ** 2)),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_shapes(shape):
    measure, J = SHAPES[shape]
    found = scene(f"bodies: {{b: {{{shape}, mass: m, at: [0, 0], move: [x, y, f]}}}}", "")
    assert value(found, "J[b]") == pytest.approx(J, rel=1e-14)
    assert value(found, "M[f,f]") >= J * (1 - 1e-14)
    if measure:
        slender = shape.split(",")[0] in ("shape: ring", "shape: arch")
        found = scene(f"bodies: {{b: {{{shape}, density: {'3*m/L' if slender else '3*m/L^2'}, at: [0, 0], "
                      "move: [x, y, f]}}", "")
        assert value(found, "M[x,x]") == pytest.approx(3 * m / (L if slender else L**2) * measure, rel=1e-14)


def test_sector_and_arch_lie_along_their_angle():
    found = scene("bodies: {b: {shape: sector, radius: R, half_angle: pi/6, angle: 2*pi/3, mass: m, at: [1, 2], move: "
                  "[x, y, f]}}")
    off = 2 * R * 0.5 / (3 * pi / 6)
    assert value(found, "centre[b].x") == pytest.approx(1 - off / 2, rel=1e-14)
    assert value(found, "centre[b].y") == pytest.approx(2 + off * sqrt(3) / 2, rel=1e-14)


def test_parts_and_holes():
    found = scene("points: {O: [0, 0]}\nbodies: {b: {parts: [{shape: rectangle, mass: M, width: L, height: h, at: [0, "
                  "0]}, "
                  "{shape: disc, mass: m, radius: r, at: [h, 0], cut: true}], pin: {at: O, by: f}}}")
    x = -m * h / (M - m)
    J0 = M * (L**2 + h**2) / 12 - m * (r**2 / 2 + h**2)
    assert value(found, "centre[b].x") == pytest.approx(x, rel=1e-14)
    assert value(found, "J[b, O]") == pytest.approx(J0, rel=1e-14)
    assert value(found, "J[b]") == pytest.approx(J0 - (M - m) * x**2, rel=1e-13)
    assert value(found, "M[f,f]") == pytest.approx(J0, rel=1e-13)


@pytest.mark.parametrize("angle", [0.0, 0.4, 2.1])
def test_gravity_as_a_vector(angle):
    found = scene("bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: f}}}\n"
                  f"equilibrium: {{f: 0.1 + {angle}/2}}", f"gravity: [g*sin({angle}), -g*cos({angle})]\n")
    assert value(found, "equilibrium[f]") == pytest.approx(atan2(sin(angle), cos(angle)), abs=1e-12)
    assert value(found, "omega[1]") == pytest.approx(sqrt(g / L), rel=1e-12)


@pytest.mark.parametrize("text, message", [
    ("surfaces: {l: {line: [[0, 0], [1, 0]]}}\nbodies: {b: {shape: disc, mass: m, radius: r, at: [0, R], roll: "
     "{surface: l, "
     "travel: x}}}", "does not touch"),
    ("surfaces: {c: {circle: [0, 0], radius: R, side: inside}}\nbodies: {b: {shape: disc, mass: m, radius: r, at: [0, "
     "0], "
     "roll: {surface: c, swing: x}}}", "does not touch"),
    ("bodies:\n  a: {mass: m, at: [0, 0], slide: {by: x, carrier: b}}\n  b: {mass: m, at: [0, 0], slide: {by: y, "
     "carrier: a}}",
     "carry one another"),
    ("bodies: {b: {mass: m, at: [0, 0], slide: {by: x, along: [0, 0]}}}", "no length"),
])
def test_scenes_that_contradict_themselves(text, message):
    with pytest.raises(SpecError, match=message):
        scene(text).scene  # noqa: B018


def test_hypotenuse():
    """The span of a spring across both directions is the exact distance."""
    found = scene("bodies: {b: {mass: m, at: [0, 0], move: [x, y, 0]}}\nsprings: {s: {k: k, between: [[3*L, 4*L], b]}}")
    matches(found, lambda x, y, u, w: m * (u * u + w * w) / 2,
            lambda x, y: m * g * y + k * (hypot(3 * L - x, 4 * L - y) - 5 * L) ** 2 / 2, PLACES, SPEEDS)


@pytest.mark.parametrize("a", ["-2 m", "1 m - 3 m", "-b"])
def test_a_parameter_that_is_given_as_negative_is_not_taken_as_positive(a):
    found = problem(f"""
        parameters: {{m: 2 kg, k: 800 N/m, b: 2 m, a: {a}}}
        bodies: {{block: {{mass: m, slide: x}}}}
        springs: {{s: {{k: k*abs(a)/b, between: [ground, block]}}}}
    """)
    assert value(found, "omega[1]") == pytest.approx(sqrt(800 / 2), rel=1e-15)
