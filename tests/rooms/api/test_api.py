"""The front door for Python: the same answers as the commands give, by `import vibcli`."""

import ast
import inspect
import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy

import vibcli
from vibcli.api.expressions import MotionEquation, SymbolicExpression
from vibcli.api.pictures import SceneDrawing
from vibcli.api.response import SampledResponse
from vibcli.api.values import QuantityValue
from vibcli.check.verdicts import check
from vibcli.cli.program import run
from vibcli.manual.index import page
from vibcli.manual.python import EXAMPLE

ROOT = Path(__file__).parents[3]
PROBLEMS = sorted((ROOT / "problems").glob("*/*.yaml"))[4::14]
EXAMPLES = Path(vibcli.__file__).parent / "examples"
DRIVEN = {
    "parameters": {"m": "2 kg", "k": "800 N/m", "c": "8 N*s/m"},
    "bodies": {"block": {"mass": "m", "slide": "x"}},
    "springs": {"s": {"k": "k", "between": ["ground", "block"]}},
    "dampers": {"d": {"c": "c", "between": ["ground", "block"]}},
    "forces": {"drive": {"at": "block", "force": "(10 N)*sin((15 rad/s)*t)"}},
    "initial": {"x": "1 cm"},
}
LETTERS = {
    "parameters": {"m": None, "k": None},
    "bodies": {"a": {"mass": "m", "slide": "x"}, "b": {"mass": "m", "slide": "y"}},
    "springs": {"s": {"k": "k", "between": ["ground", "a"]}, "r": {"k": "k", "between": ["a", "b"]}},
}


@pytest.fixture(scope="module")
def driven():
    return vibcli.load(DRIVEN)


# the import


def test_an_import_alone_imports_nothing():
    program = ("import sys; before = set(sys.modules); import vibcli; new = set(sys.modules) - before\n"
               "assert new == {'vibcli'}, new; vibcli.load; assert 'vibcli.api.load' in sys.modules")
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr


def test_reading_a_scene_needs_no_numpy():
    program = ("import sys, vibcli; vibcli.load({'bodies': {'b': {'mass': '1 kg', 'slide': 'x'}}})\n"
               "assert not {'numpy', 'sympy', 'matplotlib'} & set(sys.modules)")
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr


def test_what_is_not_there_is_told():
    with pytest.raises(AttributeError, match="no attribute 'lood'"):
        vibcli.lood  # noqa: B018
    assert set(vibcli.DOOR) <= set(dir(vibcli))


def test_public_names_stand_on_the_page():
    text = page("python")
    assert [name for name in vibcli.DOOR if name not in text] == []
    for kind in (vibcli.Model, MotionEquation, SymbolicExpression, SceneDrawing, SampledResponse, QuantityValue):
        names = set(vars(kind)) - set(dir(tuple)) - {"of", "of_equivalent", "of_forces", "primitives"}
        missing = [name for name in names if not name.startswith("_") and name not in text]
        assert missing == [], (kind, missing)


def test_the_example_of_the_page_prints_what_it_says(capsys):
    assert all(line.strip() in page("python") for line in EXAMPLE.split("\n"))
    exec(EXAMPLE, {})
    told = [line.partition("# ")[2] for line in EXAMPLE.split("\n") if "# " in line]
    assert capsys.readouterr().out.split("\n") == [*told, ""] and len(told) == 7


def test_types_are_written_on_all_public_functions():
    swept = 0
    for path in sorted((Path(vibcli.__file__).parent / "api").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef) and (not node.name.startswith("_") or node.name == "__getitem__"):
                args = [arg for arg in (*node.args.args, *node.args.kwonlyargs) if arg.arg not in ("self", "cls")]
                assert node.returns is not None, (path.name, node.name)
                assert all(arg.annotation is not None for arg in args), (path.name, node.name)
                swept += 1
    assert swept >= 40


# values


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_values_are_those_that_check_finds(path):
    model = vibcli.load(path)
    compared = 0
    for verdict in check(model._as_read):
        model_of_case = model.case(verdict.case) if verdict.case else model
        if not isinstance(verdict.found, (float, int)) or model_of_case._problem.numeric.has_free_symbols:
            continue
        answer = model_of_case[verdict.answer.asked.text]
        if answer.value is None:        # a function of the state, found at a random one
            continue
        compared += 1
        if model._as_read.spec.in_full and not isinstance(verdict.found, bool):     # windows may begin elsewhere
            assert abs(answer.value - verdict.found) <= answer.error
        elif verdict.answer.asked.text.startswith("law["):      # a law made beside more has its sums in another order
            assert abs(answer.value - verdict.found) <= min(answer.error, 1e-15 * abs(answer.value))
        else:
            assert answer.value == verdict.found
        assert 0 <= answer.error <= 1e-5 * abs(answer.value) + 1e-9      # the root of rounding, of an argmax
    assert compared or model._problem.numeric.has_free_symbols or not model._as_read.spec.answers


def test_ten_problems_are_compared():
    assert len(PROBLEMS) >= 10


def test_errors_bound_what_is_off(driven):
    decay, damped = 2.0, np.sqrt(396.0)       # c/2m, √(ω² − δ²)
    exact = {"omega[1]": 20.0, "frequency[1]": 10 / np.pi, "zeta[1]": 0.1, "decay[1]": decay, "omega_d[1]": damped,
             "amplitude(x)": 10 / 370, "omega[1]^2*m/k": 1.0, "omega[1]/zeta[1]": 200.0,
             "abs(frf[x, drive](15 rad/s))": 1 / 370}
    for text, value in exact.items():
        found = driven[text]
        assert abs(found.value - value) <= found.error + 4e-16 * value, text
        assert found.error < 1e-10 * value
    assert driven["omega[1]"].unit == "rad/s" and driven["frequency[1]"].unit == "Hz"
    assert driven["x(0.1 s)"].unit == "m" and driven["s.force(0.1 s)"].unit == "N" and driven["T"].unit == "J"
    assert driven["omega[1]/zeta[1]"].unit == "1/s" or driven["omega[1]/zeta[1]"].unit == "rad/s"
    assert float(driven["omega[1]"]) == driven.omega[0] and driven["stable"].value is True
    assert driven["eigenvalue[1]"].value == pytest.approx(complex(-decay, damped), rel=1e-14)


def test_the_instant_of_a_maximum_is_bounded():
    free = vibcli.load({"parameters": {"m": "2 kg", "k": "800 N/m"}, "bodies": {"block": {"mass": "m", "slide": "x"}},
                        "springs": {"s": {"k": "k", "between": ["ground", "block"]}}, "initial": {"x'": "1 m/s"}})
    found = free["argmax(x)"]
    assert abs(found.value - np.pi / 40) <= found.error < 1e-5
    assert abs(free["max(x)"].value - 0.05) <= free["max(x)"].error


@pytest.mark.sweep
def test_modes_and_equilibrium_are_those_of_the_command(capsys):
    path = EXAMPLES / "damped_absorber.yaml"
    model = vibcli.load(path)
    assert run(["frequencies", "--json", str(path)]) == 0
    data = json.loads(capsys.readouterr().out)
    assert list(model.omega) == [mode["omega"] for mode in data["modes"]]
    assert list(model.zeta) == [mode["zeta"] for mode in data["damped"]]
    assert model.modes.T.tolist() == [list(mode["shape"].values()) for mode in data["modes"]]
    assert model.equilibrium == data["equilibrium"]["coordinates"]
    assert list(model.equations) == model.coordinates == data["coordinates"]


def test_cases_and_other_values(driven):
    assert driven.with_values(k=3200).omega == pytest.approx([40.0])
    assert driven.with_values(k="0.8 N/mm", m=Fraction(1, 2) + 1.5).omega == pytest.approx([20.0])
    assert driven.with_values(k=3200).with_values(m="8 kg").omega == pytest.approx([20.0])
    cased = vibcli.load({**DRIVEN, "cases": {"heavy": {"parameters": {"m": "8 kg"}}}})
    assert cased.cases == ["heavy"] and cased.case("heavy").omega == pytest.approx([10.0])
    assert cased.case("heavy").with_values(k=3200).omega == pytest.approx([20.0])
    for wrong, words in (({"q": 1}, "no parameter 'q'"), ({"k": "3 +"}, "ends too early"), ({"k": "3 m"}, "stiffness"),
                         ({"k": None}, "ends too early")):
        with pytest.raises(vibcli.SpecError, match=words):
            driven.with_values(**wrong)
    with pytest.raises(vibcli.SpecError, match="no case 'light'"):
        cased.case("light")


# letters


def test_scenes_in_letters_answer_in_expressions():
    p = vibcli.load(LETTERS)
    m, k = sympy.symbols("m k", positive=True)
    golden = [sympy.sqrt(k * (3 - sympy.sqrt(5)) / (2 * m)), sympy.sqrt(k * (3 + sympy.sqrt(5)) / (2 * m))]
    for found, expected in zip(p.omega, golden, strict=True):
        assert sympy.simplify(found.to_sympy() - expected) == 0
    ratio = p["omega[2]/omega[1]"]
    assert ratio.value is None and ratio.unit == "1"
    assert float(ratio.expression.to_sympy()) == pytest.approx((3 + 5**0.5) / 2)
    assert str(p["K[x, x]"].expression) == "2*k" and p["K[x, x]"].unit == "N/m"
    assert str(p.equilibrium["x"]) == "0" and p.zeta == []
    assert float(p.modes[0][1].to_sympy()) == pytest.approx((1 + 5**0.5) / 2)
    assert p.omega[0]._repr_latex_().startswith("$") and r"\sqrt" in p.omega[0].latex
    with pytest.raises(TypeError, match="expression"):
        float(ratio)
    with pytest.raises(vibcli.PhysicsError):
        p["omega[3]"]
    assert p.with_values(m="1 kg", k="1 N/m").omega == pytest.approx([(5**0.5 - 1) / 2, (5**0.5 + 1) / 2])


def test_equations_go_to_sympy(driven):
    t = sympy.Symbol("t")
    m, c, k = sympy.symbols("m c k", positive=True)
    x = sympy.Function("x")(t)
    expected = m * x.diff(t, 2) + c * x.diff(t) + k * x - 10 * sympy.sin(15 * t)
    for linear in (False, True):
        equation = driven.equations["x"].to_sympy(linear=linear)
        assert sympy.simplify(equation.lhs - equation.rhs - expected) == 0
    assert str(driven.equations["x"]) == "m*x'' + c*x' + k*x = 10*sin(15*t)"
    motion = driven["motion[x]"].expression.to_sympy()
    assert sympy.simplify(motion - expected) == 0
    assert str(driven["T"].expression) == "m*x'^2/2" and driven["T"].value is None


# responses


def test_a_response_is_that_of_the_command(driven, tmp_path, capsys):
    path = EXAMPLES / "forced_vibration.yaml"
    model = vibcli.load(path)
    assert run(["response", "--json", "--until", "500 ms", "--at", "250 ms", str(path)]) == 0
    data = json.loads(capsys.readouterr().out)["response"]
    motion = model.response(until="500 ms", points=3)
    assert motion.t.tolist() == [0.0, 0.25, 0.5] and data["until"] == 0.5
    assert list(motion) == [one["signal"] for one in data["signals"]]
    for one in data["signals"]:
        assert motion[one["signal"]][1] == pytest.approx(one["at"][0]["value"], rel=1e-12)
        assert motion.unit(one["signal"]) == one["unit"]
        assert motion[one["signal"]].shape == (3,)
    assert motion.unknown is None and len(motion) == len(data["signals"])
    assert model.response(until=1).t[-1] == 1.0     # another end, and the first stays as it is
    assert motion.t[-1] == 0.5


def test_a_response_has_any_signal(driven):
    motion = driven.response(until=2, points=201)
    assert motion["s.force"] == pytest.approx(800 * motion["x"])
    assert np.gradient(motion["x"], motion.t)[1:-1] == pytest.approx(motion["x'"][1:-1], abs=4e-3)
    with pytest.raises(vibcli.SpecError, match="no coordinate or signal 'z'"):
        motion["z"]
    for wrong in ("2 m", "-1 s", "soon", "0 s"):
        with pytest.raises(vibcli.SpecError):
            driven.response(until=wrong)


def test_a_frequency_response_is_in_rad_per_second_or_hertz(driven):
    Omega = np.array([[0.0, 5.0], [15.0, 20.0]])
    exact = 1 / (800 - 2 * Omega**2 + 8j * Omega)
    assert driven.frf("x", "drive", omega=Omega) == pytest.approx(exact, rel=1e-12)
    assert driven.frf("x", "drive", f=Omega / (2 * np.pi)) == pytest.approx(exact, rel=1e-12)
    assert driven.frf("x'", "drive", omega=3.0) == pytest.approx(3j / (800 - 18 + 24j), rel=1e-12)
    assert driven.frf("x", "drive", f=2.0) == driven["frf[x, drive](2 Hz)"].value
    for wrong in ({}, {"omega": 1, "f": 1}, {"frequency": 1}):
        with pytest.raises(TypeError):
            driven.frf("x", "drive", **wrong)
    with pytest.raises(TypeError):
        driven.frf("x", "drive", 3.0)
    with pytest.raises(vibcli.SpecError, match="no input 'motor'"):
        driven.frf("x", "motor", omega=1)
    with pytest.raises(ValueError, match="not negative"):
        driven.frf("x", "drive", omega=[np.nan])


# what is wrong


def test_errors_of_a_mapping_name_the_path_of_keys():
    with pytest.raises(vibcli.SpecError) as caught:
        vibcli.load({"bodies": {"b": {"mass": "2 kg", "slide": "x", "colour": "red"}},
                     "springs": {"s": {"k": object(), "between": ["ground", "c"]}}, 3.5: "x", "title": "a\x07b"})
    places = [found.where.file for found in caught.value.diagnostics]
    assert {"bodies.b.colour", "springs.s.k", "springs.s.between[1]", "title"} <= set(places)
    assert "springs.s.between[1]: there is no point or body 'c'" in str(caught.value)
    assert all(found.message for found in caught.value.diagnostics) and len(places) >= 5


def test_a_mapping_that_holds_itself_is_refused():
    scene = {"bodies": {}}
    scene["bodies"]["b"] = scene
    with pytest.raises(vibcli.SpecError, match="deep"):
        vibcli.load(scene)


def test_a_mapping_is_the_text_that_says_the_same(driven):
    import yaml

    same = vibcli.loads(yaml.safe_dump(DRIVEN))
    assert same["max(x)"].value == driven["max(x)"].value
    numbers = {"parameters": {"m": 2, "k": np.float64(8.5), "n": {"value": -1.5, "unused": "allowed", "sign": "any"}},
               "bodies": {"a": {"mass": "m", "slide": "x"}}, "springs": {"s": {"k": "k", "between": ("ground", "a")}}}
    assert vibcli.load(numbers).omega == pytest.approx([np.sqrt(4.25)])


def test_what_is_invalid_carries_all_diagnostics(tmp_path):
    with pytest.raises(vibcli.SpecError) as caught:
        vibcli.loads("bodies: {b: {mass: 2 m, slide: x}}\nsprings: {s: {k: 3 N, between: [ground, b]}}\n")
    assert len(caught.value.diagnostics) == 2
    assert [found.where.line for found in caught.value.diagnostics] == [1, 2]
    with pytest.raises(vibcli.SpecError):
        vibcli.loads("")
    with pytest.raises(FileNotFoundError):
        vibcli.load(tmp_path / "missing.yaml")


def test_what_has_no_answer_is_a_physics_error(driven):
    with pytest.raises(vibcli.PhysicsError) as caught:
        driven["omega[2]"]
    found, = caught.value.diagnostics
    assert "no mode 2" in found.message and found.hint
    for wrong in ("omga[1]", "max(y)", "omega", "3 m", "x", "max(x", "", "omega[1] + max(x)"):
        with pytest.raises(vibcli.SpecError):
            driven[wrong]


def test_records_lie_in_the_folder():
    text = (EXAMPLES / "measured_blow.yaml").read_text()
    assert vibcli.loads(text, folder=EXAMPLES).omega == vibcli.load(EXAMPLES / "measured_blow.yaml").omega
    with pytest.raises(vibcli.SpecError, match="there is no file"):
        vibcli.loads(text)


# reports


@pytest.mark.sweep
def test_a_notebook_shows_report_and_figure(driven, tmp_path):
    html, tex = driven._repr_html_(), driven._repr_latex_()
    assert "<svg" in html and "<math" in html and "<html" not in html
    assert r"\subsection*" in tex and r"\documentclass" not in tex
    assert driven.draw()._repr_svg_().lstrip().startswith("<?xml")
    driven.draw(mode=1, both=True).save(tmp_path / "mode.png")
    assert (tmp_path / "mode.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(vibcli.PhysicsError):
        driven.draw().save(tmp_path / "mode.doc")
    letters = vibcli.load(LETTERS)
    assert "<svg" in letters._repr_html_() and "Model" in repr(letters)


def test_the_scene_chooses():
    path = EXAMPLES / "two_springs_for_two_frequencies.yaml"
    model = vibcli.load(path)
    assert all(verdict.agrees for verdict in check(model._as_read))
    for answer in model._as_read.spec.answers:
        assert model[answer.asked.text].value is not None
    assert inspect.ismethod(model.draw) and model.draw().primitives


WITH_A_BEAM = {
    "parameters": {"m": "2 kg", "k": "800 N/m", "L": "1 m", "mu": "2 kg/m", "EI": "30 N*m^2"},
    "beams": {"arm": {"length": "L", "EI": "EI", "mass_per_length": "mu", "left": "clamped"},
              "mast": {"length": "L", "EI": "EI", "mass_per_length": "mu", "left": {"clamped": "cart"}}},
    "points": {"tip": {"body": "arm", "at": "L"}},
    "bodies": {"b": {"mass": "m", "slide": "x"}, "cart": {"mass": "m", "slide": "y"}},
    "springs": {"s": {"k": "k", "between": ["tip", "b"]}},
    "dampers": {"d": {"c": "2 N*s/m", "between": ["b", "ground"]}},
}


def test_no_energy_or_equation_leaves_members_out():
    """T of the beams is an integral and y moves one of them, whose equation is no ordinary one; x moves none."""
    p = vibcli.load(WITH_A_BEAM)
    for asked in ("T", "V", "motion[y]", "equation[y]"):
        with pytest.raises(vibcli.PhysicsError, match=r"of members is an integral|moves a member"):
            p[asked]
    with pytest.raises(vibcli.PhysicsError, match="partial differential equations"):
        print(p.equations)
    assert str(p["motion[x]"].expression).startswith("m*x'' + 2*x' + k*x")
    assert str(p["Phi"].expression) == "x'^2"
    asked = vibcli.load(WITH_A_BEAM | {"answers": {"T": "m*(x'^2 + y'^2)/2", "equation[y]": "m*y'' = 0"}})
    verdicts = check(asked._problem)
    assert [verdict.agrees for verdict in verdicts] == [False, False]
    assert all("vibcli equations" in verdict.refusal.message for verdict in verdicts)


def test_what_is_no_text_and_no_kind_of_picture_is_told():
    with pytest.raises(TypeError, match=r"expected the text of a scene, found int; vibcli.load takes"):
        vibcli.loads(5)
    with pytest.raises(ValueError, match="a picture is a png or svg or pdf, not a xyz"):
        vibcli.load(DRIVEN).draw().data("xyz")
