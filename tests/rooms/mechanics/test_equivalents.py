"""Springs and dampers at one place as a perpendicular pair, against Hessians of the energy by SymPy."""

import random
from math import atan2, cos, hypot, pi, radians, sin
from textwrap import dedent

import mpmath
import pytest
import sympy
from support.scenes import problem, value

import vibcli
from vibcli.api.reports import report, solution
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.cli.program import run
from vibcli.results.equivalent_pair import with_pair

PARTS = ("xx", "xy", "yy", "max", "min", "angle")
FREE = "bodies: {p: {mass: 1 kg, at: [0 m, 0 m], move: [x, y, 0]}}\n"


def pair(xx, xy, yy):
    """The entries, the eigenvalues and the direction of the larger."""
    mean, half = (xx + yy) / 2, hypot((xx - yy) / 2, xy)
    return dict(zip(PARTS, (xx, xy, yy, mean + half, mean - half, atan2(2 * xy, xx - yy) / 2), strict=True))


def found(scene, head="stiffness", place="p"):
    return {part: value(scene, f"{head}[{place}].{part}") for part in PARTS}


def random_scene(seed):
    """(text, V of SymPy in x and y) of a particle on springs of all kinds under a load."""
    rng = random.Random(seed)
    x, y = sympy.symbols("x y", real=True)
    V, springs = sympy.Integer(0), []
    for i in range(rng.randint(2, 5)):
        angle, far, k = rng.uniform(-pi, pi), rng.uniform(0.5, 2), rng.uniform(50, 500)
        ax, ay = (round(part, 3) for part in (far * cos(angle), far * sin(angle)))
        length, drawn = sympy.sqrt((x - ax)**2 + (y - ay)**2), hypot(ax, ay)
        kind = rng.choice(("plain", "preload", "free_length", "law", "none"))
        between = f"between: [[{ax} m, {ay} m], p]"
        N, free, cubic = rng.uniform(-10, 30), rng.uniform(0.5, 1.1) * drawn, rng.uniform(10, 900)
        text, energy = {
            "plain": (f"k: {k} N/m", k * (length - drawn)**2 / 2),
            "preload": (f"k: {k} N/m, preload: {N} N", N * length + k * (length - drawn)**2 / 2),
            "free_length": (f"k: {k} N/m, free_length: {free} m", k * (length - free)**2 / 2),
            "law": (f"law: '{k} N/m*d + {cubic} N/m^3*d^3'",
                    k * (length - drawn)**2 / 2 + cubic * (length - drawn)**4 / 4),
            "none": (f"k: {k} N/m, free_length: 0 m", k * length**2 / 2)}[kind]
        springs.append(f"  s{i}: {{{text}, {between}}}\n")
        V += energy
    F = [rng.uniform(-20, 20) for _ in "xy"]
    text = (FREE + "springs:\n" + "".join(springs)
            + f"forces: {{F: {{at: p, force: ['{F[0]} N', '{F[1]} N']}}}}\n")
    return text, V, F, (x, y)


def at(V, F, symbols, place):
    """(what is left of the forces, what is wanted of the pair) at a place."""
    slopes = sympy.lambdify(symbols, [sympy.diff(V, s) - f for s, f in zip(symbols, F, strict=True)])
    K = sympy.lambdify(symbols, [sympy.diff(V, *two) for two in ((symbols[0],) * 2, symbols, (symbols[1],) * 2)])
    return max(map(abs, slopes(*place))), pair(*K(*place))


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(5))
def test_it_is_the_hessian_of_the_energy_in_equilibrium(seed):
    text, *independent = random_scene(seed)
    scene = problem(text)
    left, numbers = at(*independent, [value(scene, f"equilibrium[{q}]") for q in "xy"])
    assert left < 1e-9
    assert found(scene) == pytest.approx(numbers, rel=1e-9, abs=1e-7)


def letters(seed):
    """(scene in letters, {part: SymPy expression}) of preloaded springs about a place of equilibrium."""
    rng = random.Random(seed)
    n, x, y = rng.randint(2, 4), *sympy.symbols("x y", real=True)
    V, springs, names = sympy.Integer(0), [], []
    for i in range(n):
        k, a, far = sympy.symbols(f"k{i} a{i} l{i}", positive=True)
        names += [f"k{i}: {{unit: N/m}}", f"a{i}: {{unit: rad}}", f"l{i}: {{unit: m}}"]
        length, between = sympy.sqrt((x - far * sympy.cos(a))**2 + (y - far * sympy.sin(a))**2), [
            f"[l{i}*cos(a{i}), l{i}*sin(a{i})]", "p"]
        if rng.random() < 0.5:
            opposite, N = sympy.sqrt((x + far * sympy.cos(a))**2 + (y + far * sympy.sin(a))**2), sympy.Symbol(f"N{i}")
            names.append(f"N{i}: {{unit: N}}")
            V += k * (length - far)**2 / 2 + N * length + k * (opposite - far)**2 / 2 + N * opposite
            springs += [f"  s{i}: {{k: k{i}, preload: N{i}, between: [{between[0]}, p]}}\n",
                        f"  t{i}: {{k: k{i}, preload: N{i}, between: [[-l{i}*cos(a{i}), -l{i}*sin(a{i})], p]}}\n"]
        else:
            V += k * (length - far)**2 / 2
            springs.append(f"  s{i}: {{k: k{i}, between: [{between[0]}, p]}}\n")
    text = "parameters: {" + ", ".join(names) + "}\n" + FREE + "springs:\n" + "".join(springs)
    rest = {x: 0, y: 0}
    K = [sympy.diff(V, *two).subs(rest) for two in ((x, x), (x, y), (y, y))]
    return text, V.free_symbols - {x, y}, K


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(5))
def test_letters_agree_with_sympy(seed):
    from vibcli.quantities.quantity import declared
    from vibcli.symbolic.evaluation import Floats, evaluate
    from vibcli.symbolic.parser import parse

    text, symbols, K = letters(seed)
    scene, rng = problem(text), random.Random(seed)
    nodes = [declared(tree).symbolic(scene, tree) for tree in (parse(f"stiffness[p].{part}") for part in PARTS)]
    for _ in range(3):
        at = {s: rng.uniform(0.3, 3) for s in sorted(symbols, key=str)}
        numbers = pair(*(float(entry.subs(at)) for entry in K))
        got = evaluate(nodes, Floats, {str(s): x for s, x in at.items()})
        assert dict(zip(PARTS, got, strict=True)) == pytest.approx(numbers, rel=1e-9, abs=1e-9)


TWO = """
parameters: {k1: {unit: N/m}, k2: {unit: N/m}, a: {unit: rad}, b: {unit: rad}, L: {unit: m}}
points: {A: ['L*cos(a)', 'L*sin(a)'], B: ['L*cos(b)', 'L*sin(b)']}
bodies: {p: {mass: 1 kg, at: [0, 0], move: [x, y, 0]}}
springs: {s: {k: k1, between: [A, p]}, t: {k: k2, between: [B, p]}}
answers:
  stiffness[p].max: (k1 + k2 + sqrt(k1^2 + k2^2 + 2*k1*k2*cos(2*(a - b))))/2
  stiffness[p].min: (k1 + k2 - sqrt(k1^2 + k2^2 + 2*k1*k2*cos(2*(a - b))))/2
  stiffness[p].angle: atan2(k1*sin(2*a) + k2*sin(2*b), k1*cos(2*a) + k2*cos(2*b))/2
"""


def test_two_springs_in_letters_print_the_book_s_formula():
    from vibcli.notation.scene_language import language
    from vibcli.quantities.quantity import declared
    from vibcli.symbolic.parser import parse

    tree = parse("stiffness[p].max")
    assert language(declared(tree).symbolic(problem(TWO), tree)) == (
        "(k1 + k2 + sqrt(k1^2 + 2*k1*k2*cos(2*a - 2*b) + k2^2))/2")


STAR = "springs:\n" + "".join(
    f"  s{i}: {{k: 30 N/m, between: [['cos({angle} deg)*(1 m)', 'sin({angle} deg)*(1 m)'], p]}}\n"
    for i, angle in enumerate((90, 210, 330)))


def test_three_springs_at_equal_angles_have_no_stiffest_direction():
    scene = problem(FREE + STAR)
    assert [value(scene, f"stiffness[p].{part}") for part in ("max", "min")] == pytest.approx([45, 45])
    with pytest.raises(PhysicsError, match="alike in every direction"):
        value(scene, "stiffness[p].angle")


@pytest.mark.parametrize("angle", [90, -90, 89.999999, -89.999999, 0, 180, 45])
def test_the_angle_is_in_its_range(angle):
    far = f"['cos({angle} deg)*(1 m)', 'sin({angle} deg)*(1 m)']"
    scene = problem(FREE + f"springs: {{s: {{k: 30 N/m, between: [{far}, p]}}}}\n")
    folded = radians(angle) - pi * round(radians(angle) / pi - 1e-12)
    assert value(scene, "stiffness[p].angle") == pytest.approx(folded, abs=1e-12)


GROUNDED = """
    parameters: {k: 100 N/m, c: 5 N*s/m, L: 1 m}
    bodies: {p: {mass: 1 kg, at: [0 m, 0 m], move: [x, y, 0]}, q: {mass: 1 kg, slide: z}}
    springs: {s: {k: k, between: [[L, 0 m], p]}, u: {k: k, between: [[0 m, L], p], acts: tension},
              w: {k: k, between: [ground, q]}}
    dampers: {d: {c: c, between: [[L, 0 m], p]}, f: {friction: 3 N, between: [[0 m, L], p]}}
"""


@pytest.mark.parametrize("quantity, said", [
    ("stiffness[p].max", "'u' has a kink in the equilibrium"), ("stiffness[q].max", "'q' has no place"),
    ("damping[p].xx", "'f' has no slope at rest")])
def test_what_has_no_equivalent_is_refused(quantity, said):
    with pytest.raises(PhysicsError, match=said):
        value(problem(GROUNDED), quantity)


def test_what_turns_with_the_time_is_refused():
    scene = problem("""
        parameters: {k: 100 N/m, W: 2 rad/s}
        bodies:
          disc: {inertia: 1 kg*m^2, mass: 1 kg, at: [0 m, 0 m], pin: {at: [0 m, 0 m], by: W*t}}
          p: {mass: 1 kg, at: [0 m, 0 m], move: {by: [x, y, 0], carrier: disc}}
        points: {A: {body: disc, at: [1 m, 0 m]}, B: {body: disc, at: [0 m, 1 m]}}
        springs: {s: {k: k, between: [A, p]}, u: {k: 2*k, between: [B, p]}}
    """)
    with pytest.raises(PhysicsError, match="carried by what is prescribed in time"):
        value(scene, "stiffness[p].max")


def test_places_that_a_body_carries_together_are_one():
    scene = problem("""
        parameters: {k: 100 N/m}
        bodies: {p: {mass: 1 kg, inertia: 1 kg*m^2, at: [0 m, 0 m], move: [x, y, f]}}
        points: {A: {body: p, at: [1 m, 0 m]}, B: {body: p, at: [0 m, 0 m]}}
        springs:
          s: {k: k, between: [A, [2 m, 1 m]]}
          u: {k: 2*k, between: [[0 m, 1 m], p]}
          v: {k: 3*k, between: [[1 m, 0 m], B]}
          t: {torsion: 3 N*m, between: [ground, p]}
    """)
    for place in ("p", "B"):
        assert [value(scene, f"stiffness[{place}].{part}") for part in PARTS[:3]] == pytest.approx([300, 0, 200])
    assert value(scene, "stiffness[A].angle") == pytest.approx(pi / 4)


def test_laws_of_dampers_count_by_their_slope_at_rest():
    scene = problem(FREE + """
springs: {s: {k: 1 N/m, between: [[1 m, 0 m], p]}, t: {k: 1 N/m, between: [[0 m, 1 m], p]}}
dampers:
  d: {law: '5 N*s/m*v + 3 N*s^2/m^2*v*abs(v)', between: [[1 m, 0 m], p]}
  e: {law: '2 N*s^3/m^3*v^3', between: [[0 m, 1 m], p]}
""")
    assert found(scene, "damping") == pytest.approx(dict(zip(PARTS, (5, 0, 0, 5, 0, 0), strict=True)))


def test_more_digits():
    scene = problem(FREE + "springs: {s: {k: 3 N/m, between: [[1 m, 0 m], p]}, t: {k: 1 N/m, between: [[1 m, 1 m], "
                           "p]}}\n").with_digits(30)
    with mpmath.workdps(40):
        assert abs(value(scene, "stiffness[p].max") - (2 + mpmath.sqrt(10) / 2)) < 1e-29
        assert abs(value(scene, "stiffness[p].angle") - mpmath.atan2(1, 3) / 2) < 1e-29


@pytest.mark.parametrize(("angle", "said"), [("0 deg", "share their axes: the modes"),
                                             ("90 deg", "share their axes: the modes"),
                                             ("30 deg", "do not share their axes")])
def test_the_report_says_whether_both_pairs_share_their_axes(angle, said):
    text = FREE + ("springs: {s: {k: 300 N/m, between: [[1 m, 0 m], p]}, t: {k: 100 N/m, between: [[0 m, 1 m], p]}}\n"
                   f"dampers: {{d: {{c: 2 N*s/m, between: [['cos({angle})*(1 m)', 'sin({angle})*(1 m)'], p]}}}}\n"
                   "find: [equivalents]\n")
    scene = problem(text)
    printed = str(report(scene, ["equivalents"]).sections)
    assert said in printed
    K, C = (_matrix(scene, head) for head in ("stiffness", "damping"))
    assert ("do not" in said) == (abs((K * C - C * K)[0, 1]) > 1e-9)


def _matrix(scene, head):
    xx, xy, yy = (value(scene, f"{head}[p].{part}") for part in PARTS[:3])
    return mpmath.matrix([[xx, xy], [xy, yy]])


def test_letters_tell_where_they_share_them():
    scene = problem(TWO + "dampers: {d: {c: 2 N*s/m, between: [A, p]}}\nfind: [equivalents]\n")
    assert "only where" in str(report(scene, ["equivalents"]).sections)


def test_what_does_not_count_is_named():
    scene = problem("""
        bodies: {p: {mass: 1 kg, inertia: 1 kg*m^2, at: [0 m, 0 m], move: [x, y, f]}}
        springs:
          s: {k: 3 N/m, between: [[1 m, 0 m], p]}
          u: {k: 2 N/m, between: [[0 m, 1 m], p]}
          t: {torsion: 3 N*m, between: [ground, p]}
        find: [equivalents]
    """)
    assert "Not counted: the torsion spring 't'." in str(report(scene, ["equivalents"]).sections)


def test_nothing_to_tell_is_said():
    scene = problem(FREE + "springs: {s: {k: 3 N/m, between: [[1 m, 0 m], p]}}\nfind: [equivalents]\n")
    assert "Nowhere do two springs" in str(report(scene, ["equivalents"]).sections)


def test_answers_bring_the_section_along():
    scene = problem(FREE + "springs: {s: {k: 3 N/m, between: [[1 m, 0 m], p]}}\n"
                           "answers: {'stiffness[p].max': 3 N/m}\n")
    assert "equivalents" in solution(scene)


@pytest.mark.parametrize("seed", range(3))
def test_the_pair_that_is_drawn_resists_like_all(seed):
    rng = random.Random(seed)
    ends = [(rng.uniform(-2, 2), rng.uniform(-2, 2)) for _ in range(6)]
    text = FREE + "springs:\n" + "".join(
        f"  s{i}: {{k: {rng.uniform(9, 99)} N/m, between: [[{x} m, {y} m], p]}}\n" for i, (x, y) in enumerate(ends[:3])
    ) + "dampers:\n" + "".join(
        f"  d{i}: {{c: {rng.uniform(1, 9)} N*s/m, between: [p, [{x} m, {y} m]]}}\n"
        for i, (x, y) in enumerate(ends[3:]))
    all_, pair_ = problem(text), with_pair(problem(text), "p")
    assert [len(pair_.spec.get(section)) for section in ("springs", "dampers")] == [2, 2]
    for entry in ("K[x,x]", "K[x,y]", "K[y,y]", "C[x,x]", "C[x,y]", "C[y,y]"):
        assert value(pair_, entry) == pytest.approx(value(all_, entry), abs=1e-11)


@pytest.mark.parametrize("place, said", [("A", "does not move"), ("w", "no body or point"), ("q", "has no place")])
def test_what_has_no_pair_to_draw_is_refused(place, said):
    scene = problem(FREE[:-2] + ", q: {mass: 1 kg, slide: z}}\npoints: {A: [1 m, 0 m]}\n"
                    "springs: {s: {k: 3 N/m, between: [A, p]}, t: {k: 3 N/m, between: [ground, q]}}\n")
    with pytest.raises(PhysicsError, match=said):
        with_pair(scene, place)


def test_the_pair_is_drawn(tmp_path):
    scene = tmp_path / "star.yaml"
    scene.write_text(FREE + STAR, encoding="utf-8")
    assert run(["draw", str(scene), "--equivalent", "p", "-o", str(tmp_path / "star.svg")]) == 0
    assert b"<svg" in (tmp_path / "star.svg").read_bytes()
    assert run(["draw", str(scene), "--equivalent", "p", "--mode", "1", "-o", str(tmp_path / "no.svg")]) == 2


def test_an_equilibrium_that_is_not_found_in_letters_is_refused():
    model = vibcli.loads(dedent("""
        parameters: {k1: {unit: N/m}, k2: {unit: N/m}, m: {unit: kg}, g: 9.81 m/s^2}
        gravity: g
        bodies: {p: {mass: m, at: [0 m, 0 m], move: [x, y]}}
        springs: {s: {k: k1, between: [[-1 m, 0 m], p]}, t: {k: k2, between: [[0.6 m, 0.8 m], p]}}
    """))
    for quantity in ("stiffness[p].max", "K[x, x]"):
        with pytest.raises(NotInLetters):
            _ = model[quantity]
