"""Springs, dampers, preloads, matrices and cases against formulas derived by hand."""

from math import cos, pi, sin, sqrt

import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError, SpecError

P = {"m": 2.0, "L": 0.6, "g": 9.81, "k": 300.0, "K": 700.0, "N": 25.0, "c": 4.0, "h": 0.2,
     "J": 0.3, "kt": 45.0, "W": 3.0}
HEAD = "".join(["parameters:\n", *(f"  {name}: {{value: {number}, unused: allowed}}\n" for name, number in P.items())])
m, L, g, k, K, N, c, h, J, kt, W = P.values()


def scene(text):
    return problem(HEAD + text)


BEAD = "bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}\n"
FREE = "bodies: {b: {mass: m, at: [0, 0], move: [x, y, 0]}}\n"
PENDULUM = "gravity: g\nbodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: f}}}\n"
STRUT = sqrt(L**2 + h**2)


def table(*rows):
    return pytest.mark.parametrize("text, answers", [pytest.param(*row[1:], id=row[0]) for row in rows])


@table(
    ("along the slide", BEAD + "springs: {s: {k: k, between: [[0, -L], b]}}", {"K[y,y]": k, "omega[1]": sqrt(k / m)}),
    ("across, undeformed", BEAD + "springs: {s: {k: k, between: [[L, 0], b]}}", {"K[y,y]": 0.0}),
    ("across, preloaded", BEAD + "springs: {s: {k: k, between: [[L, 0], b], preload: N}}", {"K[y,y]": N / L}),
    ("across, pressed", BEAD + "springs: {s: {k: k, between: [[L, 0], b], preload: -N}, t: {k: K, between: [[0, h], "
                               "b]}}",
     {"K[y,y]": K - N / L, "stable": True}),
    ("free length, across", BEAD + "springs: {s: {k: k, between: [[L, 0], b], free_length: h}}",
     {"K[y,y]": k * (L - h) / L}),
    ("zero free length", FREE + "springs: {s: {k: k, between: [[L, h], b], free_length: 0}, "
     "t: {k: k, between: [b, [-L, -h]], free_length: 0}}", {"K[x,x]": 2 * k, "K[y,y]": 2 * k, "K[x,y]": 0.0}),
    ("ends coincide, zero free length", FREE + "springs: {s: {k: k, between: [[0, 0], b], free_length: 0}}",
     {"K[x,x]": k, "K[y,y]": k, "omega[2]": sqrt(k / m)}),
    ("inclined", FREE + "springs: {s: {k: k, between: [[L, h], b]}, t: {k: K, between: [[0, -h], b]}}",
     {"K[x,x]": k * L**2 / STRUT**2, "K[x,y]": k * L * h / STRUT**2, "K[y,y]": k * h**2 / STRUT**2 + K}),
    ("static, one", "gravity: g\n" + BEAD + "springs: {s: {k: k, between: [[0, L], b], preload: static}}",
     {"equilibrium[y]": 0.0, "K[y,y]": k}),
    ("static, inclined on an upright slide", "gravity: g\n" + BEAD + "springs: {s: {k: k, between: [[L, h], b], "
                                                            "preload: static}}",
     {"equilibrium[y]": 0.0, "K[y,y]": k * h**2 / STRUT**2 + m * g * STRUT / h * (L**2 / STRUT**3)}),
    ("static, many", "gravity: g\n" + FREE + "springs: {s: {k: k, between: [[-L, h], b], preload: static}, "
     "t: {k: K, between: [[L, h], b], preload: static}}",
     {"equilibrium[x]": 0.0, "K[x,y]": (K - k) * L * h / STRUT**2,
      "K[x,x]": (k + K) * L**2 / STRUT**2 + 2 * m * g * STRUT / (2 * h) * h**2 / STRUT**3}),
    ("static, undetermined but without effect", "gravity: g\n" + BEAD + "springs: {s: {k: k, between: [[0, L], b], "
                                                            "preload: static}, "
     "t: {k: K, between: [[0, -L], b], preload: static}}", {"K[y,y]": k + K, "equilibrium[y]": 0.0}),
    ("static torsion", "gravity: g\nbodies: {b: {mass: m, at: [L, 0], pin: {at: [0, 0], by: f}}}\n"
     "springs: {s: {torsion: kt, between: [ground, b], preload: static}}", {"equilibrium[f]": 0.0, "K[f,f]": kt}),
    ("torsion preload bends nothing", PENDULUM + "springs: {s: {torsion: kt, between: [ground, b]}}",
     {"K[f,f]": kt + m * g * L, "omega[1]": sqrt((kt + m * g * L) / (m * L**2))}),
    ("stretch outright", "coordinates: [x, y]\nbodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
     "springs: {s: {k: k, stretch: 2*x - y}, t: {k: K, between: [ground, a]}}",
     {"K[x,x]": 4 * k + K, "K[x,y]": -2 * k, "K[y,y]": k}),
    ("stretch of a torsion spring", "bodies: {a: {inertia: J, turn: u}, b: {inertia: J, turn: w}}\n"
     "springs: {s: {torsion: kt, stretch: w - 3*u}}", {"K[u,u]": 9 * kt, "K[u,w]": -3 * kt, "omega[1]": 0.0}),
    ("damper along and torsion damper", "bodies: {a: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, "
                                        "0], by: f}}}\n"
     "points: {A: {body: a, at: [L, 0]}}\nsprings: {s: {torsion: kt, between: [a, ground]}}\n"
     "dampers: {d: {c: c, between: [[L, -h], A]}, e: {torsion: c*L^2, between: [a, ground]}}",
     {"C[f,f]": 2 * c * L**2, "zeta[1]": 2 * c * L**2 / (2 * sqrt(kt * m * L**2 / 3))}),
    ("damper across does nothing", BEAD + "springs: {s: {k: k, between: [[0, -L], b]}}\ndampers: {d: {c: c, between: "
                                          "[[L, 0], b]}}",
     {"C[y,y]": 0.0, "K[y,y]": k}),
    ("damper by its deflection", BEAD + "springs: {s: {k: k, between: [[0, -L], b]}}\ndampers: {d: {c: c, stretch: "
                                        "3*y}}",
     {"C[y,y]": 9 * c}),
    ("energies written out", "coordinates: [x]\nenergies: {T: m*x'^2, V: k/6*x^2 - N*x, Phi: 3*c/4*x'^2}",
     {"equilibrium[x]": 3 * N / k, "M[x,x]": 2 * m, "C[x,x]": 1.5 * c, "K[x,x]": k / 3}),
    ("a rotating frame, its kinetic energy at rest", "coordinates: [x]\n"
     "energies: {T: 1/2*m*(x'^2 + W^2*(x + h)^2), V: 1/12*k*x^2}",
     {"equilibrium[x]": 18 * h / 32, "K[x,x]": 32.0, "omega[1]": 4.0}),
    ("matrices", "matrices: {M: [[2, 0], [0, 1]], K: [[30, -10], [-10, 10]], C: [[1, 3], [-1, 2]]}",
     {"K[1,2]": -10.0, "C[1,2]": 1.0, "C[1,1]": 1.0, "M[1,1]": 2.0}),
    ("matrices add to elements", "coordinates: [x]\nbodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: "
                                 "[ground, b]}}\n"
     "matrices: {M: [[3]], K: [[100]]}", {"M[x,x]": m + 3, "K[x,x]": k + 100}),
)
def test_stiffness_and_damping(text, answers):
    found = scene(text)
    for quantity, expected in answers.items():
        assert value(found, quantity) == pytest.approx(expected, rel=1e-13, abs=1e-12), quantity


def test_the_full_law_of_a_preloaded_spring():
    """A spring that hangs a mass: preload shifts the tension, not the stiffness; V by its definition."""
    text = "gravity: g\n" + BEAD + "springs: {s: {k: k, between: [[L, h], b], preload: N}}\nequilibrium: {y: -0.3}"
    found = scene(text)
    y = found.configuration.equilibrium.values["y"]
    now = sqrt(L**2 + (h - y) ** 2)
    tension = N + k * (now - STRUT)
    assert tension * (h - y) / now == pytest.approx(m * g, rel=1e-12)
    stiffness = k * ((h - y) / now) ** 2 + tension / now * (1 - ((h - y) / now) ** 2)
    assert value(found, "K[y,y]") == pytest.approx(stiffness, rel=1e-12)


def test_a_static_preload_in_letters():
    found = problem("parameters: {m: , g: , L: , k: , a: }\ngravity: g\n"
                    "bodies: {b: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: f}}}\n"
                    "points: {A: {body: b, at: [L, 0]}}\n"
                    "springs: {s: {k: k, between: [[L, a], A], preload: static}}\n"
                    "answers:\n  K[f,f]: k*L^2\n  equilibrium[f]: 0\n")
    from vibcli.check.verdicts import check

    assert all(verdict.agrees for verdict in check(found))
    assert str(next(iter(found.system.preloads))) == "s"


@pytest.mark.parametrize("text, message", [
    ("gravity: g\n" + BEAD + "springs: {s: {k: k, between: [[L, 0], b], preload: static}}", "no preload of 's'"),
    ("gravity: g\n" + FREE + "springs: {s: {k: k, between: [[L, h], b], preload: static}}", "no preload of 's'"),
    (FREE + "springs: {s: {k: k, between: [[L, 0], b], preload: static}, t: {k: k, between: [[-L, 0], b], preload: "
            "static}}",
     "do not fix"),
])
def test_static_preloads_that_cannot_be(text, message):
    with pytest.raises(PhysicsError, match=message):
        scene(text).system.linearisation  # noqa: B018


@pytest.mark.parametrize("text, message", [
    (BEAD + "springs: {s: {k: k, between: [[0, 0], b]}}", "coincide"),
    (BEAD + "springs: {s: {k: k, between: [ground, b]}}", "bare ground"),
    ("bodies: {a: {mass: m, slide: x}, b: {mass: m, at: [0, 0], slide: y}}\nsprings: {s: {k: k, between: [a, "
     "b]}}", "lumped"),
    ("bodies: {a: {inertia: J, turn: x}}\nsprings: {s: {k: k, between: [ground, a]}}", "torsion"),
    ("bodies: {a: {mass: m, slide: x}}\nsprings: {s: {torsion: kt, between: [ground, a]}}", "no rotation"),
    (BEAD + "springs: {s: {k: k, between: [[0, 1], [0, 2]]}}", "never changes"),
])
def test_springs_that_cannot_be(text, message):
    with pytest.raises(SpecError, match=message):
        scene(text).scene  # noqa: B018


CASES = """
bodies: {b: {mass: m, at: [0, -L], pin: {at: [0, 0], by: f}}}
gravity: g
cases:
  heavier: {parameters: {m: 7}}
  longer:
    parameters: {L: 1.2}
  stiff:
    springs: {s: {torsion: kt, between: [ground, b]}}
  elsewhere:
    bodies: {b: {at: [L*sin(pi/6), -L*cos(pi/6)]}}
    springs: {s: {torsion: kt, between: [ground, b], preload: static}}
"""


@pytest.mark.parametrize("case, expected", [
    (None, sqrt(g / L)), ("heavier", sqrt(g / L)), ("longer", sqrt(g / 1.2)), ("stiff", sqrt(g / L + kt / (m * L**2))),
    ("elsewhere", sqrt(g / L * cos(pi / 6) + kt / (m * L**2)))])
def test_cases(case, expected):
    found = scene(CASES)
    part = found.case(case) if case else found
    assert value(part, "omega[1]") == pytest.approx(expected, rel=1e-13)


def test_values_for_symbols():
    found = problem("parameters: {m: , k: }\nbodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, "
                    "b]}}")
    assert found.numeric.has_free_symbols
    assert value(found.with_values({"m": 2, "k": 8}), "omega[1]") == 2.0
    with pytest.raises(PhysicsError, match="needs numbers"):
        value(found.with_values({"m": 2}), "omega[1]")


def test_a_chain_of_carriers():
    """Pendulum on a pendulum on a slide on an incline: V to second order at the hanging position."""
    found = scene("gravity: g\nbodies:\n  cart: {mass: m, at: [0, 0], slide: {along: [cos(pi/6), sin(pi/6)], by: x}}\n"
                  "  a: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: u}}\n"
                  "  b: {mass: m, at: [0, -L - h], pin: {at: [0, -L], carrier: a, by: w}}\n"
                  "springs: {s: {k: k, between: [[-L*cos(pi/6), -L*sin(pi/6)], cart], preload: static}}")
    M = {("x", "x"): 3 * m, ("x", "u"): 2 * m * L * cos(pi / 6), ("u", "u"): 2 * m * L**2, ("u", "w"): m * L * h,
         ("w", "w"): m * h**2, ("x", "w"): m * h * cos(pi / 6)}
    for (i, j), expected in M.items():
        assert value(found, f"M[{i},{j}]") == pytest.approx(expected, rel=1e-13)
    for name, expected in (("x", k), ("u", 2 * m * g * L), ("w", m * g * h)):
        assert value(found, f"K[{name},{name}]") == pytest.approx(expected, rel=1e-13)
    assert sin(value(found, "equilibrium[u]")) == 0
