"""All equilibria (gate A13): known sets are found whole, each balanced to rounding and labelled stable or not.

Roots come from mpmath, polynomials with chosen roots, or published lists; on a torus the labels obey Morse's count.
"""

import json
import random
from fractions import Fraction
from itertools import pairwise, product
from math import cos, pi, sin, sqrt

import mpmath
import pytest
from support.scenes import problem, value

from vibcli.analyses.modal.stability import FALLING, HELD, NEUTRAL, STABLE, UNSTABLE, judged, stability
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run

SCALE = 1e-14


def listed(scene, proved=True):
    """[({coordinate: value}, kind)] of all equilibria, each of them balanced; `proved`: is it that these are all?"""
    found = scene.equilibria
    assert not found.cut
    assert proved is None or found.complete is proved
    assert all(item.equilibrium.residual <= SCALE for item in found.items)
    kinds = [stability(about.modal).kind for about in scene.about_each]
    return [(item.equilibrium.values, kind) for item, kind in zip(found.items, kinds, strict=True)]


def found_as(scene, expected, accuracy=1e-12, proved=True):
    """Are exactly the expected ({coordinate: value}, kind) found, in this order?"""
    found = listed(scene, proved)
    assert [kind for _, kind in found] == [kind for _, kind in expected]
    for (values, _), (exact, _) in zip(found, expected, strict=True):
        assert values == pytest.approx(exact, rel=accuracy, abs=accuracy)


def potential(V, names="x", within=2, T=None):
    """A scene of angles, or pure numbers, with V(x, y) in joules and unit inertias, searched from −within to within."""
    speeds = T or " + ".join(f"{name}'^2" for name in names)
    limits = ", ".join(f"{name}: [-{within}, {within}]" for name in names)
    bounds = f"find: {{equilibria: all, within: {{{limits}}}}}\n" if within else ""
    return problem(f"parameters: {{J: 1 kg*m^2, E: 1 J}}\ncoordinates: [{', '.join(names)}]\n{bounds}"
                   f"energies:\n  T: J/2*({speeds})\n  V: E*({V})\n")


PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, kt: KT N*m}
gravity: g
bodies: {b: {mass: m, at: [0, L], pin: {at: [0, 0], by: f}}}
springs: {s: {torsion: kt, between: [ground, b]}}
"""


def upright(kt, more=""):
    return problem(PENDULUM.replace("KT", str(kt)) + more)


# one coordinate


@pytest.mark.parametrize("within", ["", "[-180 deg, 180 deg]", "[-360 deg, 540 deg]", "[-1, 7]"])
def test_a_pendulum_counts_once_a_turn(within):
    scene = upright(0, f"find: {{equilibria: all, within: {{f: {within}}}}}" if within else "")
    found = listed(scene)
    assert sorted(round(cos(values["f"]), 12) for values, _ in found) == [-1, 1]
    assert {cos(values["f"]) < 0: kind for values, kind in found} == {True: STABLE, False: UNSTABLE}


@pytest.mark.parametrize("kt", [9, 6, 3, 9.8, 9.809, 9.80999, 9.8099999, 9.80999999])
def test_a_post_beyond_buckling(kt):
    """kt f = m g L sin f, down to a distance of 1e-9 from the bifurcation, where all three positions meet."""
    with mpmath.workdps(40):
        load = mpmath.mpf("9.81") / mpmath.mpf(str(kt))
        start = mpmath.sqrt(6 * (1 - 1 / load)) if load < 1.2 else mpmath.mpf(2)
        exact = float(mpmath.findroot(lambda f: f - load * mpmath.sin(f), start))
    accuracy = 1e-15 / (1 - kt / 9.81)
    scene = upright(kt)
    found_as(scene, [({"f": -exact}, STABLE), ({"f": 0.0}, UNSTABLE), ({"f": exact}, STABLE)], max(accuracy, 1e-13))
    assert stability(scene.about_each[1].modal).growth_rate == pytest.approx(sqrt((9.81 - kt) / 0.5), rel=1e-6)


@pytest.mark.sweep
@pytest.mark.parametrize("kt", [9.81, 9.82, 20])
def test_a_post_below_buckling_has_one_position(kt):
    found_as(upright(kt), [({"f": 0.0}, HELD if kt == 9.81 else STABLE)], proved=kt != 9.81)


@pytest.mark.sweep
def test_turns_of_a_torsion_spring_are_not_the_same_place():
    """kt f = m g L sin f with a soft spring: several windings, all different; counted by a fine table."""
    load = 9.81 / 0.5
    table = [-9 * pi + 18 * pi * (i + 0.5) / 200000 for i in range(200001)]
    signs = [f - load * sin(f) > 0 for f in table]
    exact = [float(mpmath.findroot(lambda f: f - load * mpmath.sin(f), (a, b), solver="anderson"))
             for a, b, x, y in zip(table, table[1:], signs, signs[1:], strict=False) if x != y]
    scene = upright(0.5, "find: {equilibria: all, within: {f: [-1620 deg, 1620 deg]}}")
    assert len(exact) > 10
    found_as(scene, [({"f": f}, STABLE if load * cos(f) < 1 else UNSTABLE) for f in exact], 1e-11)


@pytest.mark.parametrize("speed, count", [(6.0, 4), (4.0, 2)])
def test_a_bead_on_a_spinning_hoop(speed, count):
    scene = problem(f"coordinates: [q]\nenergies:\n  T: 1/2*2*0.5^2*(q'^2 + {speed}^2*sin(q)^2)\n  V: -9.81*cos(q)\n"
                    "find: {equilibria: all, within: {q: [-180 deg, 180 deg]}}\n".replace(" deg", "*pi/180"))
    cosine = 9.81 / (0.5 * speed**2)
    tilt = [float(mpmath.acos(cosine))] if cosine < 1 else []
    fast = [({"q": -tilt[0]}, STABLE)] if tilt else []
    middle = [({"q": 0.0}, UNSTABLE if tilt else STABLE)]
    found_as(scene, fast + middle + [({"q": q}, STABLE) for q in tilt] + [({"q": pi}, UNSTABLE)], 1e-11)
    assert len(scene.equilibria.items) == count


@pytest.mark.parametrize("unit, factor", [("km", 1e3), ("m", 1.0), ("mm", 1e-3), ("µm", 1e-6)])
def test_a_truss_that_snaps_through_at_every_scale(unit, factor):
    scene = problem(f"""
parameters: {{m: 1 kg, k: {2000 / factor} N/m, b: 0.4 {unit}, h: 0.15 {unit}, g: 9.81 m/s^2}}
gravity: g
bodies: {{apex: {{mass: m, at: [0, h], slide: {{along: [0, 1], by: y}}}}}}
springs: {{l: {{k: k, between: [[-b, 0], apex]}}, r: {{k: k, between: [[b, 0], apex]}}}}
""")
    rest = mpmath.hypot(0.4, 0.15)

    def force(u):
        return 4000 * u * (1 - rest / mpmath.hypot(0.4, u)) + 9.81

    exact = [(float(mpmath.findroot(force, ends, solver="anderson")) - 0.15) * factor
             for ends in ((-0.3, -0.1), (0.0, 0.06), (0.1, 0.14))]
    found = listed(scene)
    assert [kind for _, kind in found] == [STABLE, UNSTABLE, STABLE]
    assert [values["y"] for values, _ in found] == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("V, roots", [
    ("x^2/2 + 1/10/(1 - x)", 2), ("1/(x + 1) + 1/(1 - x)", 1), ("x^2/2 + 1/10/(1 - x)^3 + 1/10/(1 + x)^3", 1),
    ("x^2/2 - 1/100/(1 - x)^2", 3), ("-log(x + 3) - x^3/9", 2), ("1/x - x", 0), ("exp(20*x)", 0)])
def test_poles_are_no_equilibria(V, roots):
    """Magnets and charges: forces change sign at their poles too. Compared with the roots that mpmath finds."""
    functions = {"x^2/2 + 1/10/(1 - x)": lambda x: x + 0.1 / (1 - x) ** 2,
                 "1/(x + 1) + 1/(1 - x)": lambda x: 1 / (1 - x) ** 2 - 1 / (1 + x) ** 2,
                 "x^2/2 + 1/10/(1 - x)^3 + 1/10/(1 + x)^3": lambda x: x + 0.3 / (1 - x) ** 4 - 0.3 / (1 + x) ** 4,
                 "x^2/2 - 1/100/(1 - x)^2": lambda x: x - 0.02 / (1 - x) ** 3,
                 "-log(x + 3) - x^3/9": lambda x: -1 / (x + 3) - x**2 / 3,
                 "1/x - x": lambda x: -1 / x**2 - 1, "exp(20*x)": lambda x: 20 * mpmath.exp(20 * x)}
    force, exact = functions[V], []
    table = [-2 + 4 * (i + 0.37) / 3000 for i in range(3000)]
    for a, b in pairwise(table):
        x, y, fine = force(a), force(b), force((a + b) / 2)
        if x * y < 0 and abs(fine) <= max(abs(x), abs(y)):
            exact.append(float(mpmath.findroot(force, (a, b), solver="anderson")))
    found = [values["x"] for values, _ in listed(potential(V), V != "x^2/2 - 1/100/(1 - x)^2")]     # an odd pole
    assert found == pytest.approx(exact, rel=1e-12, abs=1e-12)
    assert len(found) <= roots


def with_roots(roots):
    """The coefficients of ∫ Π (x − r) dx, rounded to doubles, and the real roots of what its derivative then is."""
    terms = [Fraction(1)]
    for root in roots:
        terms = [(terms[i - 1] if i else 0) - root * (terms[i] if i < len(terms) else 0) for i in range(len(terms) + 1)]
    rounded = [float(c / (i + 1)) for i, c in enumerate(terms)]
    with mpmath.workdps(60):
        slopes = [mpmath.mpf(c) * (i + 1) for i, c in enumerate(rounded)]
        exact = mpmath.polyroots(slopes[::-1], maxsteps=500, extraprec=400)
        return rounded, sorted(float(root.real) for root in exact if abs(root.imag) < 1e-20)


@pytest.mark.sweep
def test_random_polynomials_with_close_pairs():
    """Nothing missed, nothing invented: up to nine roots of the force, two of them as near as 1e-4."""
    draw, compared, proofs = random.Random("polynomials"), 0, 0
    for _ in range(16):
        roots = [Fraction(draw.randint(-1900000, 1900000), 10**6) for _ in range(draw.randint(1, 8))]
        rounded, exact = with_roots(sorted({*roots, roots[0] + Fraction(1, 10 ** draw.randint(1, 4))}))
        scene = potential(" + ".join(f"({c!r})*x^{i}" for i, c in enumerate(rounded, 1)))
        found, proofs = listed(scene, None), proofs + scene.equilibria.complete
        gap = min((b - a for a, b in pairwise(exact)), default=1.0)
        assert [values["x"] for values, _ in found] == pytest.approx(exact, abs=0.1 * gap), exact
        kinds = [kind for _, kind in found]
        assert kinds[-1] == STABLE and all(a != b for a, b in pairwise(kinds))
        compared += len(exact)
    assert compared >= 64 and proofs >= 14


@pytest.mark.parametrize("V, expected", [
    ("x^4/4", [(0.0, HELD)]), ("-x^4/4", [(0.0, FALLING)]), ("x^3/3", [(0.0, FALLING)]),
    ("(x - 1/3)^3/3", [(1 / 3, FALLING)]), ("(x - 1/3)^4", [(1 / 3, HELD)]),
    ("(x - 1/3)^3*(x - 1)/3", [(1 / 3, FALLING), (5 / 6, STABLE)]),
    ("x^2*(x - 1)^3", [(0.0, UNSTABLE), (0.4, STABLE), (1.0, FALLING)])])
def test_multiple_zeros_are_found_and_judged_beyond_the_linear_terms(V, expected):
    found = listed(potential(V), proved=False)
    assert [kind for _, kind in found] == [kind for _, kind in expected]
    assert [values["x"] for values, _ in found] == pytest.approx([x for x, _ in expected], abs=2e-6)


def test_a_gap_is_one_line_of_neutral_positions():
    """A spring with play: no force acts from −1 to 1."""
    scene = potential("max(abs(x) - 1, 0)^2")
    (values, kind), = listed(scene, proved=False)
    assert kind == NEUTRAL and abs(values["x"]) < 1 and scene.equilibria.items[0].free == [{"x": 1.0}]


def test_a_kink_is_listed_with_its_stability_left_open(tmp_path, capsys):
    """V = F |x| − k x²/2: at rest at the kink, and where it tips over, x = ±F/k."""
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 1 kg, F: 2 N, k: 3 N/m}\ncoordinates: [x]\n"
                    "energies: {T: m*x'^2/2, V: F*abs(x) - k*x^2/2}\n"
                    "find: {equilibria: all, within: {x: [-2 m, 2 m]}}\n")
    assert run(["solve", str(path)]) == 0
    out = capsys.readouterr().out
    assert out.count("grows as exp(1.73205·t)") == 2 and "no small oscillations: a kink" in out
    scene = problem(path.read_text())
    assert [item.equilibrium.values["x"] for item in scene.equilibria.items] == pytest.approx([-2 / 3, 0, 2 / 3])
    assert [judged(about.modal).stable for about in scene.about_each] == [False, None, False]


CRANK = """
parameters: {r: 0.3 m, l: 0.5 m, d: sqrt(l^2 - r^2), m1: 2 kg, m2: 3 kg, w: 0.9 m, l0: 0.4 m, k: 400 N/m, g: 9.81 m/s^2}
coordinates: [phi, psi, x]
gravity: g
points: {A: [0, r], B: {body: rod, at: [d, 0]}}
bodies:
  crank: {shape: rod, mass: m1, from: [0, 0], to: [0, r], pin: {at: [0, 0], by: phi}}
  rod: {shape: rod, mass: m2, from: [0, r], to: [d, 0], pin: {at: A, carrier: crank, by: psi}}
  slider: {mass: 1 kg, at: [d, 0], slide: x}
springs: {buffer: {k: k, between: [slider, [w, 0]], free_length: l0}}
constraints: {pin: {join: [B, slider]}}
"""


@pytest.mark.sweep
def test_a_slider_crank_all_the_way_round():
    """A closed loop: V of the crank's turn alone, x = −r sin φ + √(l² − r² cos² φ) the place of the slider."""
    def slope(f):
        return mpmath.diff(energy, f)

    def energy(f):
        x = -0.3 * mpmath.sin(f) + mpmath.sqrt(0.25 - 0.09 * mpmath.cos(f) ** 2)
        return 200 * (0.9 - x - 0.4) ** 2 + (2 + 3) * 9.81 * 0.15 * mpmath.cos(f)

    table = [-pi + 2 * pi * (i + 0.3) / 400 for i in range(401)]
    exact = [float(mpmath.findroot(slope, ends, solver="anderson")) for ends in pairwise(table)
             if slope(ends[0]) * slope(ends[1]) < 0]
    scene = problem(CRANK)
    found = listed(scene, proved=False)
    assert len(exact) == 4
    assert [values["phi"] for values, _ in found] == pytest.approx(exact, abs=1e-9)
    assert [kind for _, kind in found] == [STABLE if mpmath.diff(energy, f, 2) > 0 else UNSTABLE for f in exact]
    for about, f in zip(scene.about_each, exact, strict=True):
        x = -0.3 * sin(f) + sqrt(0.25 - 0.09 * cos(f) ** 2)
        assert 0.4 + about.configuration.dependent_values["x"] == pytest.approx(x, abs=1e-9)


# several coordinates


DOUBLE = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2}
gravity: g
points: {A: {body: a, at: [0, -L]}, B: {body: b, at: [0, -2*L]}}
bodies:
  a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: f}}
  b: {mass: m, at: [0, -2*L], pin: {at: A, carrier: a, by: h}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("third", [False, True])
def test_pendulums_of_two_and_three_links(third):
    text = DOUBLE + ("  c: {mass: m, at: [0, -3*L], pin: {at: B, carrier: b, by: i}}\n" if third else "")
    text = text if third else text.replace(", B: {body: b, at: [0, -2*L]}", "")
    names = "fhi" if third else "fh"
    hanging = [dict(zip(names, place, strict=True)) for place in product((0.0, pi), repeat=len(names))]
    found_as(problem(text), [(place, UNSTABLE if any(place.values()) else STABLE) for place in hanging])


@pytest.mark.sweep
def test_himmelblau():
    """Himmelblau (1972), Applied Nonlinear Programming: four minima, one maximum, four saddles, as published."""
    minima = [(3, 2), (-2.805118, 3.131312), (-3.779310, -3.283186), (3.584428, -1.848126)]
    others = [(-0.270845, -0.923039), (-3.073026, -0.081353), (-0.127961, -1.953715), (0.086678, 2.884255),
              (3.385152, 0.073852)]

    def force(x, y):
        a, b = x**2 + y - 11, x + y**2 - 7
        return [4 * x * a + 2 * b, 2 * a + 4 * y * b]

    expected = []
    for kind, places in ((STABLE, minima), (UNSTABLE, others)):
        for place in places:
            x, y = mpmath.findroot(force, place)
            assert (float(x), float(y)) == pytest.approx(place, abs=3e-6)
            expected.append(({"x": float(x), "y": float(y)}, kind))
    expected.sort(key=lambda pair: list(pair[0].values()))
    scene = potential("(x^2 + y - 11)^2 + (x + y^2 - 7)^2", "xy", 6)
    found_as(scene, expected)
    assert [sum(mode.growth_rate is not None for mode in about.modal.modes) for about in scene.about_each].count(2) == 1


@pytest.mark.sweep
def test_two_wells_in_each_of_two_turned_directions():
    """V = W(u) + W(v), W = (u² − 1)²/4, along axes turned by 0.3 rad, unequal masses: nine positions, four stable."""
    c, s = cos(0.3), sin(0.3)
    u, v = f"({c!r}*x + {s!r}*y)", f"({-s!r}*x + {c!r}*y)"
    scene = potential(f"({u}^2 - 1)^2/4 + ({v}^2 - 1)^2/4", "xy", 2, "x'^2 + 3*y'^2")
    expected = [({"x": c * a - s * b, "y": s * a + c * b}, STABLE if a and b else UNSTABLE)
                for a, b in product((-1, 0, 1), repeat=2)]
    found_as(scene, sorted(expected, key=lambda pair: [round(x, 9) for x in pair[0].values()]), 1e-11)


def on_a_torus(seed):
    """A scene of two angles with random forces."""
    draw, terms = random.Random(seed), []
    for a, b in ((1, 0), (0, 1), (1, 1), (1, -1)):
        terms += [f"({draw.gauss(0, 1):.5f})*{f}({a}*x + ({b})*y)" for f in ("cos", "sin")]
    return potential(" + ".join(terms), "xy", None)


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(6))
def test_morse_count_on_a_torus(seed):
    """Σ (−1)^(unstable modes) = 0, the Euler characteristic of the torus."""
    scene = on_a_torus(seed)
    signs = [(-1) ** sum(mode.growth_rate is not None for mode in about.modal.modes) for about in scene.about_each]
    assert len(listed(scene)) == len(signs) >= 4
    assert sum(signs) == 0 and signs.count(1) >= 2


@pytest.mark.sweep
def test_small_basins_are_found():
    """A bar on two springs has six positions; one draws in a thousandth of random starts (8·10⁵ found no seventh)."""
    scene = problem("""
parameters: {m: 6 kg, L: 0.8 m, k1: 400 N/m, k2: 250 N/m, h1: 0.3 m, h2: 0.35 m, d: 0.2 m, g: 9.81 m/s^2}
gravity: g
points: {A: {body: bar, at: [0, 0]}, B: {body: bar, at: [L, 0]}}
bodies: {bar: {shape: rod, mass: m, from: [0, 0], to: [L, 0], move: [x, y, phi]}}
springs: {l: {k: k1, between: [[0, h1], A]}, r: {k: k2, between: [[L + d, h2], B]}}
find: {equilibria: all, within: {x: [-0.8 m, 0.8 m], y: [-0.8 m, 0.8 m]}}
""")
    found = listed(scene, proved=False)
    assert [values["phi"] for values, _ in found] == pytest.approx([-0.56003, 3.12965, -0.11106, 0.13100, 0.05154,
                                                                    0.41063], abs=6e-6)
    assert [kind for _, kind in found].count(STABLE) == 1


# lines of equilibria


def test_a_free_cart_is_neutral_along_its_way():
    scene = problem("parameters: {M: 2 kg, m: 1 kg, L: 1 m, g: 9.81 m/s^2}\ngravity: g\nbodies:\n"
                    "  cart: {mass: M, at: [0, 0], slide: x}\n"
                    "  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}\n")
    found_as(scene, [({"x": 0.0, "phi": 0.0}, NEUTRAL), ({"x": 0.0, "phi": pi}, UNSTABLE)])
    assert [item.free for item in scene.equilibria.items] == [[{"x": 1.0}]] * 2


@pytest.mark.sweep
@pytest.mark.parametrize("V, count, free", [
    ("(x - y)^2 + (x - y)^4", 1, {"x": 1.0, "y": 1.0}), ("(x^2 + y^2 - 1)^2", 2, None),
    ("(x^2 + y^2 - 1)^2*((x - 3)^2 + y^2 - 1/4)^2", 5, None)])
def test_lines_and_circles_count_once(V, count, free):
    """The circles of V = 0 are one entry each, and what lies between and within them is isolated."""
    scene = potential(V, "xy", 4)
    found = listed(scene, proved=False)
    assert len(found) == count
    neutral = [item.free for item, (_, kind) in zip(scene.equilibria.items, found, strict=True) if kind == NEUTRAL]
    assert [len(directions) for directions in neutral] == [1] * (1 if count < 5 else 2)
    if free:
        assert neutral[0][0] == pytest.approx(free)


@pytest.mark.sweep
def test_a_particle_tied_to_a_point_may_go_round_it():
    scene = problem("parameters: {m: 1 kg, k: 10 N/m, a: 1 m}\nbodies: {p: {mass: m, at: [1.3 m, 0.2 m], "
                    "move: [x, y, 0]}}\nsprings: {s: {k: k, between: [[0, 0], p], free_length: a}}\n")
    (values, kind), = listed(scene, proved=False)
    assert kind == NEUTRAL
    assert (1.3 + values["x"]) ** 2 + (0.2 + values["y"]) ** 2 == pytest.approx(1, rel=1e-13)
    assert scene.about_each[0].modal.modes[1].omega == pytest.approx(sqrt(10), rel=1e-9)


def test_linear_scenes_have_one_and_need_no_bounds():
    scene = problem("parameters: {m: 2 kg, k: 80 N/m, N: 3 N}\nbodies: {a: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a], preload: N}}")
    found_as(scene, [({"x": -3 / 80}, STABLE)])
    assert scene.equilibria.bounds == {}


# labels


def test_gyroscopic_stability_is_lost_to_a_damper():
    """A spinning top's two tilts: K < 0 held by gyroscopic terms alone, until damping lets it fall slowly."""
    text = ("parameters: {m: 1 kg, k: 1 N/m, h: 3 N*s/m, c: 0.1 N*s/m}\ncoordinates: [x, y]\n"
            "matrices: {M: [[m, 0], [0, m]], C: [[DAMP, h], [-h, DAMP]], K: [[-k, 0], [0, -k]]}")
    free, damped = problem(text.replace("DAMP", "0*c")), problem(text.replace("DAMP", "c"))
    assert stability(free.modal).kind == STABLE
    found = stability(damped.modal)
    roots = mpmath.polyroots([1, 0.1 - 3j, -1], maxsteps=100)         # z̈ + (c − i h) ż − k z = 0 of z = x + i y
    assert found.kind == UNSTABLE
    assert found.growth_rate == pytest.approx(float(max(root.real for root in roots)), rel=1e-9)


def test_dampers_slow_the_fall():
    scene = upright(6, "dampers: {d: {torsion: 2 N*m*s, between: [ground, b]}}")
    rate = stability(scene.about_each[1].modal).growth_rate
    assert rate == pytest.approx((-2 + sqrt(4 + 4 * 0.5 * 3.81)) / (2 * 0.5), rel=1e-12)
    assert value(scene, "growth_rate[1][2]") == pytest.approx(sqrt(3.81 / 0.5), rel=1e-12)


# nearness of a bifurcation


@pytest.mark.parametrize("kt, warned", [(9.82, False), (9.8101, False), (9.810001, True), (9.809999, True)])
def test_a_bifurcation_is_warned_of(kt, warned, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(PENDULUM.replace("KT", str(kt)))
    assert run(["solve", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["equilibrium"]
    assert found["condition"] == pytest.approx((kt + 9.81) / abs(kt - 9.81), rel=1e-6)
    assert bool(found["warning"]) is warned
    assert run(["solve", str(path)]) == 0
    assert ("near a bifurcation" in capsys.readouterr().out) is warned


def test_stiffness_beside_softness_is_no_bifurcation():
    from vibcli.analyses.modal.bifurcation_distance import stiffness_condition

    scene = problem("parameters: {m: 1 kg, k: 1e12 N/m, s: 1 N/m}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, "
                    "slide: y}}\nsprings: {u: {k: k, between: [a, b]}, v: {k: s, between: [ground, a]}}")
    assert stiffness_condition(scene.modal) == 1.0
    assert stiffness_condition(potential("x^4/4 - 1e-9*x^2").modal) > 1e8
    assert stiffness_condition(potential("cos(x)").modal) < 10


# answers, text, JSON


def test_answers_ask_for_one_of_them():
    scene = upright(6)
    assert value(scene, "equilibria") == 3
    exact = float(mpmath.findroot(lambda f: 6 * f - 9.81 * mpmath.sin(f), 1.6))
    assert [value(scene, f"equilibrium[f][{i}]") for i in (1, 2, 3)] == pytest.approx([-exact, 0, exact], rel=1e-14)
    assert [value(scene, f"stable[{i}]") for i in (1, 2, 3)] == [True, False, True]
    assert value(scene, "omega[1][3]") == pytest.approx(sqrt((6 - 9.81 * cos(exact)) / 0.5), rel=1e-12)
    assert value(scene, "stable") is False and value(scene, "equilibrium[f]") == 0
    with pytest.raises(PhysicsError, match="3 are found"):
        value(scene, "stable[4]")


def test_the_case_and_the_file_have_bounds_of_their_own():
    scene = upright(6, "find: {equilibria: all, within: {f: [0, 3]}}\ncases: {wide: {equilibrium: {f: 1}}}\n")
    assert (value(scene, "equilibria"), value(scene.case("wide"), "equilibria")) == (2, 3)


@pytest.mark.sweep
def test_too_many_are_not_counted():
    scene = potential("cos(30*x) + cos(30*y)", "xy", 3)
    assert scene.equilibria.cut and not scene.equilibria.complete and len(scene.equilibria.items) == 200
    with pytest.raises(PhysicsError, match="cut short"):
        value(scene, "equilibria")


@pytest.mark.parametrize("find", ["{equilibria: all}", "[equilibria: all]", "[{equilibria: all}]"])
def test_text_and_json(find, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(PENDULUM.replace("KT", "6") + f"find: {find}\n")
    assert run(["solve", str(path)]) == 0
    lines = capsys.readouterr().out.split("\n")
    table = lines[lines.index("Equilibria"):]
    assert [line.split()[3] for line in table[2:5]] == ["stable", "unstable", "stable"]
    assert "grows as exp(2.76043·t)" in table[3] and table[5].startswith("  searched: f from −3.14159 rad (−180°)")
    assert "Natural frequencies" not in "\n".join(lines)
    assert run(["solve", str(path), "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [entry["stable"] for entry in data["equilibria"]] == [True, False, True]
    middle = data["equilibria"][1]
    assert middle["omega"] == [None] and middle["growth_rate"] == pytest.approx(sqrt(3.81 / 0.5))
    assert middle["coordinates"] == {"f": 0.0} and middle["free"] == [] and middle["warning"] is None
    assert data["search"] == {"bounds": {"f": [-pi, pi]}, "complete": True, "cut": False, "indices": None,
                              "degree": None}
    assert run(["frequencies", str(path), "--json"]) == 0
    assert "equilibria" not in json.loads(capsys.readouterr().out)


@pytest.mark.sweep
def test_where_the_drawn_position_leads_nowhere_the_list_is_still_there():
    """V = −u⁴/4 + u²/2 falls for ever from u = 1.5, yet has three equilibria."""
    far = potential("(x + 3/2)^2/2 - (x + 3/2)^4/4", within=4)
    with pytest.raises(PhysicsError):
        far.configuration.equilibrium  # noqa: B018
    found_as(far, [({"x": -2.5}, UNSTABLE), ({"x": -1.5}, STABLE), ({"x": -0.5}, UNSTABLE)])


@pytest.mark.sweep
def test_the_search_is_the_same_at_every_run():
    first, second = (listed(on_a_torus(3)) for _ in range(2))
    assert first == second
