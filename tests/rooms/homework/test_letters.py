"""Keys that stay in letters, and equations with numbers: against formulas written out here, by gates, sheets, marks."""

import json
import random
from functools import cache
from math import pi, sqrt

import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.cli.program import run
from vibcli.homework.asked_keys import key_of
from vibcli.homework.candidates import candidates
from vibcli.homework.document import SceneDocument
from vibcli.homework.formula_keys import FormulaKey
from vibcli.homework.gates import Wrong
from vibcli.homework.leaks import leak
from vibcli.homework.manifest import read_manifest
from vibcli.homework.marked_expressions import typed
from vibcli.homework.marks import Marker
from vibcli.homework.terms import alike
from vibcli.homework.variants import read_anew, solve_variants
from vibcli.homework.worked_variants import WorkedVariants
from vibcli.report.blocks import Document
from vibcli.report.formats.typst import render
from vibcli.report.sections.steps import section_of
from vibcli.report.steps.worked import worked

ROD = """title: A rod on a spring
question: A rod of mass {m} hangs from a pin; a spring {k} acts at {a} from it, and the rod is {n} times as long.
gravity: g
parameters: {m: , k: , a: , g: 9.81 m/s^2, n: 2}
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -n*a], pin: {at: [0, 0], by: phi}}}
springs: {s: {k: k, stretch: a*phi}}
answers:
  omega[1]: sqrt(3*g/(2*n*a) + 3*k/(n^2*m))
  equation[phi]: n^2*a^2*m/3*phi'' + (k*a^2 + m*g*n*a/2)*phi = 0
variants: {parameters: {n: [2, 3, 4, 5]}, ask: {"omega[1]": , "equation[phi]": , T: }}
"""
BLOCK = """title: A block
question: A block {m} on a spring {k} and a damper {c}, driven by {F}.
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m, F: 10 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, stretch: x}}
dampers: {d: {c: c, stretch: x}}
forces: {f: {at: block, force: F*sin(15 rad/s*t)}}
answers: {"omega_d[1]": 19.90 rad/s}
variants:
  parameters: {m: {from: 1 kg, to: 3 kg, step: 0.5 kg}, k: [600 N/m, 800 N/m]}
  ask: {"equation[x]": {points: 2}, "omega_d[1]": rad/s}
"""


def solved(text):
    source = text_source(text)
    return solve_variants(problem_of(source), SceneDocument.of(source.node, source.file, None))


def number(text, **letters):
    """The value of a key's text."""
    return eval(text.replace("^", "**"), {"sqrt": sqrt, "pi": pi}, letters)


@pytest.mark.sweep
def test_expressions_are_those_of_the_closed_form():
    found = solved(ROD)
    assert len(found.accepted) == found.reread == 4
    for variant in found.accepted:
        n, (omega, equation, energy) = float(variant.values["n"].exact), variant.keys
        for m, k, a in ((1.3, 70.0, 0.4), (8.0, 11.0, 2.5)):
            wanted = sqrt(3 * 9.81 / (2 * n * a) + 3 * k / (n**2 * m))
            assert number(omega.text, m=m, k=k, a=a) == pytest.approx(wanted, rel=1e-13)
            assert number(energy.text.replace("phi'", "w"), m=m, a=a, w=1.7) == pytest.approx(
                m * (n * a * 1.7)**2 / 6, rel=1e-13)
            given = {one.mistake: one.value for one in omega.wrong}
            for name, value in (("weight forgotten", sqrt(3 * k / (n**2 * m))), ("root forgotten", wanted**2),
                                ("cycles for radians", wanted / (2 * pi)), ("sign", -wanted),
                                ("period for frequency", 2 * pi / wanted), ("half the frequency", wanted / 2),
                                ("particle for body (rod)", wanted * sqrt(4 / 3)),
                                ("lever ratio once (s)", sqrt(3 * 9.81 / (2 * n * a) + 3 * k / (a * n**2 * m)))):
                assert number(given[name], m=m, k=k, a=a) == pytest.approx(value, rel=1e-12), name
        assert equation.text.endswith(" = 0") and "n" not in equation.text
        assert omega.figures == "exact"


BLOCKS = """title: Two blocks apart
question: Blocks of mass {m}, one on a spring {k}, the other, {r} times as heavy, on one {s} times as stiff.
parameters: {m: , k: , r: 2, s: 3}
bodies: {one: {mass: m, slide: x1}, two: {mass: r*m, slide: x2}}
springs: {a: {k: k, stretch: x1}, b: {k: s*k, stretch: x2}}
variants: {parameters: {r: [2, 3, 7], s: [3, 4, 5]}, ask: {"omega[1]": , "equation[x2]": }}
"""


@pytest.mark.parametrize(("text", "least"), [(ROD, 3), (BLOCKS, 7)])
def test_expressions_are_found_once_and_put_in(text, least):
    """Where modes change places, s/r < 1 or > 1, they are found anew, and are those of the scene read anew."""
    source = text_source(text)
    problem, document = problem_of(source), SceneDocument.of(source.node, source.file, None)
    rules = problem.spec.get("variants")
    variants = candidates(problem, rules, lambda one: one)
    keys = [key_of(problem.spec, one) for one in rules.ask]
    count = 0
    for place, scene in variants:
        fresh = document.anew(variants.values_at(place))
        found, wanted = ([key.found(one) for key in keys] for one in (scene, fresh))
        assert found == wanted, place
        count += 1
    assert least <= variants.sharing < count


@pytest.mark.sweep
def test_worked_solutions_in_letters_go_along_one_path():
    source = text_source(ROD)
    document = SceneDocument.of(source.node, source.file, None)
    lines = WorkedVariants(document)
    for one in solved(ROD).accepted:
        problem = document.anew(one.values)
        fresh = worked(problem)
        along, anew = (render([Document("", None, (), tuple(section_of(each)))], None)
                       for each in (lines.lines(one.values), fresh))
        assert along == anew
    assert lines.alone == 1


@pytest.mark.sweep
def test_a_mistake_that_is_the_key_rejects_and_one_that_always_is_is_left_out():
    always = ROD.rstrip()[:-1] + ', mistakes: {sum: {answers: {"omega[1]": "sqrt(omega[1]^2)"}}}}\n'
    assert ("sum", "omega[1]") in solved(always).same
    once = always.replace("sqrt(omega[1]^2)", "omega[1]*n/3")
    found = solved(once)
    assert [float(one.values["n"].exact) for one in found.accepted] == [2, 4, 5]
    assert found.rejected[0].gate == "apart" and found.rejected[0].reason == "'sum' gives omega[1] itself"


def test_what_is_told_nowhere_in_letters():
    found = solved(ROD.replace(", and the rod is {n} times as long", ""))
    assert found.counts["told"] == 4 and "tells n" in found.advice


@pytest.mark.sweep
def test_what_is_not_found_in_letters_is_said():
    found = solved(ROD.replace('"omega[1]": , ', '"K[phi,phi]": , "equilibrium[phi]": , ').replace(
        "stretch: a*phi", "stretch: a*phi + a*phi^3 + a*sin(phi)^5 - 0.1*a"))
    assert not found.accepted and "letters" in found.advice


@pytest.mark.sweep
def test_two_ways_that_differ_are_a_fault(monkeypatch):
    right = FormulaKey.found
    monkeypatch.setattr(FormulaKey, "found", lambda self, problem: right(self, problem).replace("981", "982"))
    with pytest.raises(RuntimeError, match="two ways to omega"):
        solved(ROD)


@pytest.mark.sweep
@pytest.mark.parametrize("text, key, right", [(ROD, 1, "text"), (BLOCK, 0, "terms")])
def test_a_mistake_that_is_said_to_give_the_right_equation_is_a_fault(text, key, right):
    source = text_source(text)
    document = SceneDocument.of(source.node, source.file, None)
    found = solve_variants(problem_of(source), document)
    variant = found.accepted[0]
    one = variant.keys[key]
    wrong = (Wrong(one.wrong[0].mistake, getattr(one, right)), *one.wrong[1:])
    keys = [*variant.keys]
    keys[key] = one._replace(wrong=wrong)
    with pytest.raises(RuntimeError, match=r"two ways to what '.*' makes of equation\[.*\] differ"):
        read_anew(document, found.keys, variant._replace(keys=tuple(keys)))


@pytest.mark.sweep
def test_a_scene_whose_letters_all_get_values_has_numbers():
    text = ROD.replace("m: , k: , a: ,", "m: 2 kg, k: , a: ,").replace(
        "n: [2, 3, 4, 5]", "k: [100 N/m, 200 N/m], a: [0.3 m, 0.4 m]").replace(", T: }", "}")
    found = solved(text)
    assert len(found.accepted) == 4
    for one in found.accepted:
        k, a = (float(one.values[name].exact) for name in "ka")
        assert one.keys[0].value == pytest.approx(sqrt(3 * 9.81 / (4 * a) + 3 * k / 8), rel=1e-13)
        terms = one.keys[1].terms
        assert terms["phi"] / terms["phi''"] == pytest.approx(one.keys[0].value**2, rel=1e-13)


@pytest.mark.sweep
def test_equations_with_numbers_by_their_coefficients():
    found = solved(BLOCK)
    assert len(found.accepted) == found.reread == 10
    for one in found.accepted:
        m, k = (float(one.values[name].exact) for name in "mk")
        equation = one.keys[0]
        assert equation.terms == pytest.approx({"x''": m, "x'": 8.0, "x": k, "sin(15*t)": -10.0}, rel=1e-15)
        assert equation.band.width == pytest.approx(0.01) and equation.figures == "3"
        assert {wrong.mistake for wrong in equation.wrong} == {"damper forgotten (d)"}


@pytest.mark.sweep
def test_a_mistaken_coefficient_asks_for_more_figures_or_rejects():
    near = BLOCK.rstrip() + "\n  mistakes: {heavy: {bodies: {block: {mass: 1.01*m}}}}\n"
    found = solved(near)
    assert {one.keys[0].figures for one in found.accepted} == {"4"}
    assert solved(near.replace("1.01*m", "1.00001*m")).counts["apart"] == 10


@pytest.mark.sweep
def test_the_full_equation_and_one_that_coefficients_do_not_tell():
    text = BLOCK.replace("stretch: x}}\ndampers", "stretch: x + r*x^3}}\ndampers").replace(
        "F: 10 N", "F: 10 N, r: 2 m^-2").replace('"equation[x]": {points: 2}', '"motion[x]":').replace(
            "mass: m", "mass: m, at: [0, 0]").replace("slide: x", "slide: {by: x, along: [1, 0]}").replace(
                "force: F*sin(15 rad/s*t)", "force: [F*sin(15 rad/s*t), 0]")
    found = solved(text + "  without: [told]\n")
    assert len(found.accepted) == 10
    for one in found.accepted:      # k (x + r x³)(1 + 3 r x²) with r = 2
        m, k = (float(one.values[name].exact) for name in "mk")
        assert one.keys[0].terms == pytest.approx({"x''": m, "x'": 8.0, "x": k, "x^3": 8 * k, "x^5": 12 * k,
                                                   "sin(15*t)": -10.0}, rel=1e-12)
    odd = text.replace("x + r*x^3", "sqrt(0.3/r + x^2) - 0.1 m")
    assert "numbers stand within" in solved(odd + "  without: [told, regime]\n").advice


@pytest.mark.sweep
def test_alike_is_what_a_search_for_the_factor_finds():
    draw = random.Random("factors")
    for _ in range(400):
        one = {name: draw.uniform(-3, 3) for name in "abc"}
        factor = draw.uniform(-2, 2)
        other = {name: value / factor * (1 + draw.uniform(-0.02, 0.02)) for name, value in one.items()}
        factors = [factor * (1 + i / 20_000) for i in range(-1000, 1001)]
        worst = min(max(abs(x * other[name] / one[name] - 1) for name in one) for x in factors)
        assert alike(one, other, worst + 1e-4) and not alike(one, other, worst - 1e-4)
    assert not alike({"a": 1.0}, {"a": 1.0, "b": 1e-3}, 0.5) and not alike({"a": 1.0}, {"b": 1.0}, 0.5)


@pytest.fixture
def handed(tmp_path, capsys):
    """text ↦ the manifest, once handed out to one student in HTML or PDF."""
    def called(text, *options):
        (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
        (tmp_path / "roster.csv").write_text("id\ns1\n")
        (tmp_path / "salt").write_text("a very secret text")
        code = run(["homework", str(tmp_path / "scene.yaml"), "-o", str(tmp_path / "out"), "--students",
                    str(tmp_path / "roster.csv"), "--salt-file", str(tmp_path / "salt"), *options])
        _, err = capsys.readouterr()
        return code, err, tmp_path / "out"

    return called


ONE = ROD.replace("n: [2, 3, 4, 5]", "n: [3]")
HOSTILE = ["__import__('os').system('ls')", "9^9^9^9^9^9", "(" * 200, "k" * 400, "1/0", "k/(m - m)", "sqrt(-k)/sqrt(m)",
           "10^(10^(10^10))*k", "(1 + k/m)^999999999", "omega[1]", "max(phi)", "phi", "t", "impulse(t)", "k'", "nan",
           "=1+1", "k,m", "lambda: 0", "√", "", "k" + "+k" * 200, "exp(exp(exp(exp(k/m))))", "phi'''", "\x00", "k = m"]


@cache
def marker_of(out):
    return Marker(read_manifest(str(out / "instructor" / "manifest.json")))


def verdicts(out, **answers):
    """{quantity: (verdict, mistake)} of the student's answers."""
    marker = marker_of(out)
    named = {"omega": "omega[1]", "equation": next(
        key for key in ("equation[phi]", "equation[x]") if key in marker_quantities(out)), "T": "T"}
    found = marker.marks("s1", "scene", {named[name]: text for name, text in answers.items()})
    return {one.quantity: one for one in found}


def marker_quantities(out):
    manifest = json.loads((out / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    return [key["quantity"] for key in manifest["problems"][0]["variants"][0]["keys"]]


@pytest.mark.sweep
def test_marks_of_expressions(handed):
    code, err, out = handed(ONE)
    assert code == 0, err
    for text in ("sqrt(g/(2*a) + k/(3*m))", "√(g/(2·a) + k/(3·m))", "sqrt((3*m*g + 2*a*k)/(6*a*m))",
                 "sqrt(3)*sqrt(g/6/a + k/(9 * m))", "(g/(2*a) + k/(3*m))^(1/2)", "sqrt(3*g/(2*n*a) + 3*k/(n²*m))",
                 "sqrt(4.905 m/s^2/a + k/(3*m))", "sqrt(4.905/a + k/(3*m))"):
        assert verdicts(out, omega=text)["omega[1]"].verdict == "right", text
    for text, mistake in (("sqrt(k/(3*m))", "weight forgotten"), ("g/(2*a) + k/(3*m)", "root forgotten"),
                          ("sqrt(g/(2*a) + k/(3*m))/(2*pi)", "cycles for radians"),
                          ("-sqrt(g/(2*a) + k/(3*m))", "sign"), ("sqrt(g/(2*a) + k/(3*m)*1.001)", "")):
        one = verdicts(out, omega=text)["omega[1]"]
        assert (one.verdict, one.mistake, one.points) == ("wrong", mistake, 0), text
    for text, said in (("4*sqrt(g/(2*a) + k/(3*m))", "the expression is right but for a factor of 4"),
                       ("sqrt(g/(2*a) + k/(4*m))", "at random values of its letters it is another than the key")):
        assert said in verdicts(out, omega=text)["omega[1]"].said, text
    assert "expected an angular frequency" in verdicts(out, omega="k/m")["omega[1]"].said
    assert "no letter 'q'" in verdicts(out, omega="sqrt(q/m)")["omega[1]"].said
    for text in HOSTILE:
        found = verdicts(out, omega=text, equation=text, T=text)
        assert not any(one.points for one in found.values()), text
        assert all(one.said for one in found.values() if one.verdict == "unreadable"), text


@pytest.mark.sweep
def test_marks_of_equations_and_energies_in_letters(handed):
    _, _, out = handed(ONE)
    for text in ("3*m*a^2*phi'' + (k*a^2 + 3*m*g*a/2)*phi = 0", "φ̈ = -(g/(2·a) + k/(3·m))·φ",
                 "φ'' + (g/(2*a) + k/(3*m))*φ = 0"):
        assert verdicts(out, equation=text)["equation[phi]"].verdict == "right", text
    for text, mistake in (("φ̈ = -k/(3·m)·φ", "weight forgotten"), ("φ̈ = (g/(2·a) + k/(3·m))·φ", "")):
        one = verdicts(out, equation=text)["equation[phi]"]
        assert (one.verdict, one.mistake) == ("wrong", mistake), text
        assert mistake or "at random values and motions it is no multiple of the key" in one.said
    assert verdicts(out, equation="phi''")["equation[phi]"].verdict == "unreadable"
    assert verdicts(out, T="3/2*m*a^2*phi'^2")["T"].verdict == "right"
    assert verdicts(out, T="3*m*a^2*phi'^2")["T"].said == "the expression is right but for a factor of 2"
    one = verdicts(out, T="9/8*m*a^2*phi'^2")["T"]
    assert (one.verdict, one.mistake) == ("wrong", "particle for body (rod)")


@pytest.mark.sweep
def test_marks_of_equations_with_numbers(handed):
    code, err, out = handed(BLOCK.replace("{from: 1 kg, to: 3 kg, step: 0.5 kg}", "[3 kg]").replace("600 N/m, ", ""))
    assert code == 0, err
    draw = random.Random("students")
    for _ in range(60):
        factor = draw.choice((1.0, 1 / 3, 1 / 800, draw.uniform(0.01, 90)))
        m, c, k, F = (f"{factor * x:.3g}" for x in (3, 8, 800, 10))
        assert verdicts(out, equation=f"{m}*x'' + {c}*x' + {k}*x = {F}*sin(15*t)")["equation[x]"].points == 2
    other = "no known mistake leads to this: it is not made of the terms of the key"
    for text, mistake, said in (
            ("3*x'' + 800*x = 10*sin(15*t)", "damper forgotten (d)", None),
            ("3*x'' + 8*x' + 820*x = 10*sin(15*t)", "", "the equation is right but for the term with x"),
            ("3*x'' + 8*x' + 800*x = 0", "", "the equation is right but for the term with sin(15*t)"),
            ("3*x'' + 8*x' - 800*x = 10*sin(15*t)", "", "the equation is right but for the sign of the term with x"),
            ("4*x'' + 9*x' + 800*x = 10*sin(15*t)", "", "its coefficients are not to each other as those of the key"),
            ("3*x'' + 8*x' + 800*x = 10*sin(14*t)", "", other),
            ("3*x'' + 8*x' + 800*x + 2*x^3 = 10*sin(15*t)", "", other)):
        one = verdicts(out, equation=text)["equation[x]"]
        assert (one.verdict, one.mistake, one.points) == ("wrong", mistake, 0), text
        assert one.said.endswith(said or ""), (text, one.said)
    for text in ("3 kg*x'' + 8 N*s/m*x' + 0.8 kN/m*x = 10 N*sin(15 rad/s*t)", "ẍ + 2.67*ẋ + 267*x = 3.33*sin(15*t)"):
        assert verdicts(out, equation=text)["equation[x]"].verdict == "right", text
    for text in HOSTILE:
        assert verdicts(out, equation=text)["equation[x]"].points == 0, text


@pytest.mark.sweep
def test_sheets_tables_and_the_manifest_again(handed, tmp_path):
    _, _, out = handed(ONE)
    rows = (out / "instructor" / "keys.csv").read_text(encoding="utf-8").splitlines()
    assert rows[1].startswith("s1,scene,1,omega[1],sqrt(") and ",,exact,," in rows[1]
    code = run(["homework", str(out / "instructor" / "manifest.json"), "-o", str(tmp_path / "again"), "--salt-file",
                str(tmp_path / "salt"), "--from-manifest"])
    assert code == 0
    for path in sorted(out.rglob("*")):
        if path.is_file():
            assert (tmp_path / "again" / path.relative_to(out)).read_bytes() == path.read_bytes(), path


@pytest.mark.sweep
def test_a_sheet_that_tells_an_expression_is_not_written(handed):
    code, err, out = handed(ONE.replace("times as long.", "times as long. (ω = √((2943·m/100 + 2·k·a)/(6·m·a))?)"))
    assert code == 4 and "would tell the key" in err and not out.exists()


@pytest.mark.parametrize("text, formula, told", [
    ("the rate is sqrt( k / m ) here", "sqrt(k/m)", True), ("√(k/m)", "sqrt(k/m)", True), ("2·k²/m", "2*k^2/m", True),
    ("a spring k and m", "k", False), ("sqrt(k/m2)", "sqrt(k/m)", False), ("x'' + 4*x = 0", "x'' + 4*x = 0", True),
    ("12*k/m", "2*k/m", False)])
def test_leaks_of_formulas(text, formula, told):
    assert (leak(text, [], [], [formula]) is not None) is told


def test_answers_as_they_are_typed():
    assert typed("φ̈ + 2·δ·φ̇ − m₁²") == "phi'' + 2*delta*phi' - m1^(2)" and typed("ẍ×√(k)") == "x''*sqrt(k)"


@pytest.mark.parametrize("mass", ["2 kg", ""])
def test_no_equation_with_a_record_is_asked(tmp_path, monkeypatch, mass):
    """What an answer cannot hold, with numbers or in letters."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "push.csv").write_text("0,0\n1,0.5\n2,0\n", encoding="utf-8")
    scene = BLOCK.replace("m: 2 kg", f"m: {mass}").replace("m: {from: 1 kg, to: 3 kg, step: 0.5 kg}, ", "")
    scene = scene.replace("bodies:", "records: {f: {file: push.csv}}\nbodies:").replace("F*sin(15 rad/s*t)", "F*f(t)")
    found = solved(scene.replace(', "omega_d[1]": rad/s', "").replace('answers: {"omega_d[1]": 19.90 rad/s}\n', ""))
    assert not found.accepted and "no answer can be written in which the record f stands" in found.advice
