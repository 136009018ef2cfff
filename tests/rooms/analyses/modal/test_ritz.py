"""Ritz estimates against the reduced matrices of M and K written by hand, and as bounds over all problem files."""

import json
import random
from functools import cache
from pathlib import Path
from textwrap import dedent

import mpmath
import pytest
from support.scenes import kept_problem_of, problem, problem_of

import vibcli
from vibcli.analyses.modal.ritz import ritz
from vibcli.base.errors import PhysicsError
from vibcli.check.instances import Instances
from vibcli.cli.program import run
from vibcli.language.document.document import read
from vibcli.language.reader import Reader
from vibcli.reader.sections.find import QUESTIONS

PROBLEMS = sorted((Path(__file__).parents[4] / "problems").glob("*/*.yaml"))
SHAFT = dedent("""
    bodies: {one: {inertia: 2, turn: a}, two: {inertia: 1.5, turn: b}, three: {inertia: 0.8, turn: c}}
    springs: {s: {torsion: 30e3, between: [ground, one]}, t: {torsion: 24e3, between: [one, two]},
              u: {torsion: 12e3, between: [two, three]}}
""")
CAR = dedent("""
    parameters: {m: 1200 kg, J: 1600 kg*m^2, k1: 30 kN/m, k2: 36 kN/m, a: 1.2 m, b: 1.5 m}
    bodies: {car: {mass: m, inertia: J, at: [0, 0], move: [0, y, phi]}}
    points: {rear: {body: car, at: [-a, 0]}, front: {body: car, at: [b, 0]}}
    springs: {s: {k: k1, between: [[-a, -1 m], rear]}, t: {k: k2, between: [[b, -1 m], front]}}
""")
CART = dedent("""
    parameters: {M: 3 kg, m: 2 kg, L: 0.8 m, k: 50 N/m, g: 9.81 m/s^2}
    gravity: g
    bodies: {cart: {mass: M, at: [0, 0], slide: x}, bob: {mass: m, at: [0, -L], pin: {at: cart, by: phi}}}
    springs: {s: {k: k, between: [[-1 m, 0], cart]}}
""")
BY_HAND = {
    "shaft": (SHAFT, "abc", [[2, 0, 0], [0, "1.5", 0], [0, 0, "0.8"]],
              [[54000, -24000, 0], [-24000, 36000, -12000], [0, -12000, 12000]],
              ({"a": 1, "b": 2, "c": 3}, {"a": 1, "c": -1})),
    "car": (CAR, ("y", "phi"), [[1200, 0], [0, 1600]], [[66000, 18000], [18000, 124200]],
            ({"y": "1 m", "phi": "-0.25"},)),
    "cart": (CART, ("x", "phi"), [[5, "1.6"], ["1.6", "1.28"]], [[50, 0], [0, "15.696"]],
             ({"x": "0.1 m", "phi": "30 deg"}, {"x": "m/k*g", "phi": "-sqrt(2)"})),
}
AMPLITUDES = {"30 deg": lambda: mpmath.pi / 6, "m/k*g": lambda: mpmath.mpf("0.3924"),
              "-sqrt(2)": lambda: -mpmath.sqrt(2)}


def asking(text, shapes):
    return problem(f"{text}\nfind: [{{ritz: {{shapes: {json.dumps(shapes)}}}}}]\n")


def estimates(scene, shapes):
    """The Ritz estimates of a Problem by other shapes than its file assumes, beside modes that are found once."""
    text = json.dumps([{"ritz": {"shapes": [dict(zip(scene.scene.coordinates, shape, strict=True))
                                            for shape in shapes]}}])
    questions = QUESTIONS.read(read(f"find: {text}".encode(), "scene.yaml")[0].entries["find"][1], Reader())
    return ritz(scene.modal, questions.about("ritz"))


def number(written):
    return AMPLITUDES[written]() if written in AMPLITUDES else mpmath.mpf(str(written).removesuffix(" m"))


@pytest.mark.parametrize("name", BY_HAND)
def test_they_are_those_of_the_reduced_matrices_written_by_hand(name):
    text, names, M, K, shapes = BY_HAND[name]
    found = asking(text, shapes).modal.result("ritz")
    with mpmath.workdps(40):
        M, K = (mpmath.matrix([[mpmath.mpf(x) for x in row] for row in matrix]) for matrix in (M, K))
        Phi = mpmath.matrix([[number(shape.get(q, 0)) for shape in shapes] for q in names])
        reduced, held = Phi.T * M * Phi, Phi.T * K * Phi
        squares, mixed = mpmath.eig(reduced**-1 * held)
        exact = sorted(map(mpmath.re, mpmath.eig(M**-1 * K)[0]))
        order = sorted(range(len(shapes)), key=lambda i: mpmath.re(squares[i]))
        for mode, i, square in zip(found.modes, order, exact, strict=False):
            assert mode.omega == pytest.approx(float(mpmath.sqrt(mpmath.re(squares[i]))), rel=1e-15)
            assert mode.exact == pytest.approx(float(mpmath.sqrt(square)), rel=1e-15) and mode.omega >= mode.exact
            shape = Phi * mixed[:, i]
            scale = mode.shape[0] / mpmath.re(shape[0])
            assert mode.shape == pytest.approx([float(mpmath.re(x) * scale) for x in shape], rel=1e-14)
            assert (mpmath.matrix([mode.shape]) * M * mpmath.matrix(mode.shape))[0] == pytest.approx(1, rel=1e-14)
        for rows, matrix in ((found.M, reduced), (found.K, held)):
            assert rows == [pytest.approx([float(x) for x in matrix[i, :]], rel=1e-15) for i in range(len(rows))]
    assert len(found.modes) == len(shapes)


@cache
def in_numbers():
    """The Problems of all files in numbers of which frequencies are found."""
    return [scene for scene in map(kept_problem_of, PROBLEMS) if not scene.numeric.has_free_symbols
            and scene.scene.q and not scene.spec.choices and _swings(scene)]


def _swings(scene):
    try:
        return bool(scene.modal.sharp_modes) and not any(scene.configuration.linear_system.G.values())
    except PhysicsError:
        return False


@pytest.mark.sweep
def test_they_are_upper_bounds_and_all_shapes_together_give_the_frequencies():
    dice, seen, together = random.Random("ritz"), 0, 0
    for scene in in_numbers():
        n = len(scene.scene.q)
        shapes = [[dice.uniform(-1, 1) * scene.numeric.size_along(q) for q in scene.scene.coordinates]
                  for _ in range(min(n, 20))]
        count = len(scene.modal.sharp_modes)
        try:
            found = estimates(scene, shapes[:dice.randint(1, min(n, count, 20))]).modes
            whole = estimates(scene, shapes).modes if n == count <= 20 else []
        except PhysicsError as error:
            assert "symmetric" in error.message or scene.configuration.linear_system.massless, error.message
            continue
        for mode, exact in zip(found, scene.modal.sharp_modes, strict=False):
            bound = -exact.growth_rate**2 if exact.omega is None else exact.omega**2
            assert mode.square >= float(bound) * (1 if bound < 0 else 1 - 1e-15), scene.spec.file
            seen += 1
        for mode in whole:
            assert (mode.omega is None) == (mode.exact is None), scene.spec.file
            assert mode.omega is None or mode.omega == pytest.approx(mode.exact, rel=4e-16), scene.spec.file
            together += 1
    assert seen > 60 and together > 100


@pytest.mark.sweep
def test_a_massless_coordinate_follows_or_is_refused():
    """Of x with 1 kg, held over y, K = 4·(x − y)² + 2·y² is 4/3 at rest of y: shapes bound that."""
    matrices = "coordinates: [x, y]\nmatrices: {{M: [[1, 0], [0, 0]], K: [[4, -4], [-4, {}]]}}"
    found, = asking(matrices.format(6), [{"x": 1}]).modal.result("ritz").modes
    assert (found.square, found.exact) == (4, pytest.approx((4 / 3) ** 0.5, rel=1e-15))
    with pytest.raises(PhysicsError, match="along what has no inertia"):
        asking(matrices.format(-1), [{"x": 1}]).modal.result("ritz")
    with pytest.raises(PhysicsError, match=r"nothing that has inertia moves in shape 1$"):
        asking(matrices.format(6), [{"y": 1}]).modal.result("ritz")
    with pytest.raises(PhysicsError, match="moves in shape 2 but for a combination"):
        asking(matrices.format(6), [{"x": 1}, {"x": 1, "y": 1}]).modal.result("ritz")


def test_where_the_minimax_principle_does_not_hold_they_are_refused():
    gyroscopic = ("parameters: {m: 2 kg, k: 50 N/m, Omega: 1 rad/s}\n"
                  "bodies: {a: {mass: m, at: [0, 0], move: [x, y, 0]}}\n"
                  "energies: {T: m*Omega*(x*y' - y*x'), V: k/2*(x^2 + 2*y^2)}")
    with pytest.raises(PhysicsError, match="without gyroscopic terms"):
        asking(gyroscopic, [{"x": 1}]).modal.result("ritz")
    column = next(path for path in PROBLEMS if path.stem == "column_under_follower_force")
    follower = next(iter(Instances(problem_of(column))))
    with pytest.raises(PhysicsError, match="symmetric stiffness"):
        estimates(follower, [[1.0] * len(follower.scene.q)])


@pytest.mark.sweep
def test_of_many_coordinates_they_are_refused_before_anything_is_computed():
    names = [f"x{i}" for i in range(1, 301)]
    text = "\n".join(["bodies:", *(f"  b{q}: {{mass: 1, slide: {q}}}" for q in names), "springs:",
                      *(f"  s{q}: {{k: 1, between: [ground, b{q}]}}" for q in names)])
    with pytest.raises(PhysicsError, match="up to 80 coordinates"):
        asking(text, [{"x1": 1}]).modal.result("ritz")


def test_unstable_and_rigid_modes_are_told_apart(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    text = ("coordinates: [x, y]\nmatrices: {{M: [[1, 0], [0, 1]], K: [[{}, 0], [0, 2]]}}\n"
            "find: [{{ritz: {{shapes: {}}}}}]")
    for stiffness, shapes, words in (
            (-4, "[{x: 1}]", "The square of the estimate of mode 1 is negative: the equilibrium is unstable."),
            (-4, "[{y: 1}]", "Mode 1 is unstable, which these shapes do not show."),
            (0, "[{x: 1}]", "mode 1  0                 0       ∞      0"),
            (4, "[{x: 1, y: 1}]", "φᵀKφ/φᵀMφ = 6/2, the square of the estimate.")):
        path.write_text(text.format(stiffness, shapes))
        assert run(["solve", str(path)]) == 0
        told = capsys.readouterr().out
        assert words in told
        assert ("upper bound" in told) == (stiffness >= 0)


def test_shapes_are_of_the_coordinates_that_move_freely():
    crank = (Path(__file__).parents[3] / "bad" / "equilibrium_starts_dependent.yaml").read_text()
    with pytest.raises(PhysicsError, match="'x' follows from the others"):
        asking(crank.partition("equilibrium:")[0], [{"x": "0.1 m"}]).modal.result("ritz")


def test_without_shapes_there_are_none():
    with pytest.raises(PhysicsError, match="no shapes are assumed") as refused:
        problem(SHAFT).modal.result("ritz")
    hint = refused.value.hint.removeprefix("ask with ")
    assert problem(SHAFT + hint).modal.result("ritz").modes[0].omega == pytest.approx((54000 / 2) ** 0.5, rel=1e-15)


def test_in_letters_numbers_are_missing_and_set_gives_them(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 2 kg, k: }\nbodies: {a: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a]}}\nfind: [{ritz: {shapes: [{x: 1}]}}]\n")
    assert run(["solve", str(path)]) == 4
    assert "`ritz` needs numbers, and these parameters have none: k" in capsys.readouterr().err
    assert run(["solve", str(path), "--set", "k=8 N/m", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["insight"]["ritz"]
    assert (found["shapes"], found["M"], found["K"]) == ([[1.0]], [[2.0]], [[8.0]])
    assert found["modes"] == [{"index": 1, "square": 4.0, "omega": 2.0, "exact": 2.0, "error": 0.0,
                               "shape": {"x": pytest.approx(0.5**0.5, rel=1e-15)}, "weights": None}]


@pytest.mark.sweep
def test_answers_and_conditions_ask_for_them(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    shaft = SHAFT + "find: [{ritz: {shapes: [{a: 1, b: 2, c: 3}]}}]\nanswers: "
    for index, expected, code in ((1, 65.8947, 0), (1, 65.91, 1), (2, 65.8947, 4)):     # sqrt(66000/15.2)
        path.write_text(f"{shaft}{{'ritz[{index}]': {expected}}}\n")
        assert run(["check", str(path)]) == code
    assert "there is no Ritz estimate 2: `find` assumes one shape" in "".join(capsys.readouterr())
    scene = vibcli.loads("parameters: {m: 2 kg}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}\n"
                         "springs: {s: {k: k, between: [ground, a]}, t: {k: k, between: [a, b]}}\n"
                         "choose: {k: 'ritz[1] = 3 rad/s'}\nfind: [{ritz: {shapes: [{x: 1, y: 2}]}}]\n")
    assert float(scene["k"]) == pytest.approx(9 * 2 * 5 / 2, rel=1e-9)
