"""`vibcli homework --export` as a lecturer uses it: packages, what the manifest says of them, what is refused."""

import json
import re
from xml.etree import ElementTree

import pytest
from support import course_systems
from support.homework_scenes import EIGHTEEN as SCENE

from vibcli.cli.program import run
from vibcli.homework.exports import FORMATS
from vibcli.manual.exports import EXPORTS

LETTERS = """title: A block in letters
question: A block {m} on a spring {k}.
parameters: {m: {}, k: {}, n: 1}
bodies: {block: {mass: n*m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
answers: {"omega[1]": sqrt(k/m), "equation[x]": "m*x'' + k*x = 0"}
variants:
  parameters: {n: [2, 3, 5]}
  without: [told]
"""
ALL = [option for name in FORMATS for option in ("--export", name)]


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    (tmp_path / "block.yaml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "salt").write_text("a secret text\n", encoding="utf-8")
    return tmp_path


def exported(*options, file="block.yaml", out="out"):
    return run(["homework", file, "-o", out, "--salt-file", "salt", *options])


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.sweep
def test_packages_keys_and_marks(course, capsys):
    """Each system gives the right answers of the manifest its points, and so does `grade`."""
    assert exported(*ALL, "--pool", "4") == 0
    assert "4 variants of 1 problem" in capsys.readouterr().out
    out = course / "out" / "instructor"
    manifest = json.loads((out / "manifest.json").read_text(encoding="utf-8"))
    assert [one["format"] for one in manifest["exports"]] == list(FORMATS)
    assert all((out / path).exists() for one in manifest["exports"] for path in one["files"])
    assert not (course / "out" / "student").exists() and len(list((out / "keys").iterdir())) == 4
    items = {one["id"]: one["sheets"][0]["variant"] for one in manifest["students"]}
    assert len(items) == 4 and all(name == f"block-{variant}" for name, variant in items.items())
    keys = {one["variant"]: one["keys"] for one in manifest["problems"][0]["variants"]}
    units, = (one["units"] for one in manifest["exports"] if one["format"] == "canvas")
    for name in FORMATS:
        more = (out / name,) if name == "prairielearn" else ()
        read = getattr(course_systems, name)(files(out / name), *more)
        assert set(read) == set(items)
        for item, variant in items.items():
            for letter, key in zip("ab", keys[variant], strict=True):
                scaled = name == "canvas" and units.get(item, {}).get(key["quantity"]) == "%"
                text = repr(key["value"] * (100 if scaled else 1))
                assert read[item][letter](text)[0] == "right"
                assert read[item][letter](f"-{text}")[0] == "wrong"
    item, variant = next(iter(items.items()))
    answers = [f"--answer={key['quantity']}={key['value']}" for key in keys[variant]]
    assert run(["grade", str(out / "manifest.json"), "--student", item, *answers]) == 0
    assert "3 of 3 points" in capsys.readouterr().out


@pytest.mark.sweep
def test_the_same_bytes_again_more_variants_beside_and_from_the_manifest(course):
    assert exported(*ALL, "--pool", "3") == 0 and exported(*ALL, "--pool", "3", out="again") == 0
    assert files(course / "out") == files(course / "again")
    assert exported("--export", "moodle", "--pool", "5", out="more") == 0

    def names(folder):
        quiz = ElementTree.parse(course / folder / "instructor" / "moodle" / "questions.xml")
        return {one.find("idnumber").text for one in quiz.iter("question") if one.get("type") == "cloze"}

    assert len(names("out")) == 3 and len(names("more")) == 5 and names("out") < names("more")
    (course / "block.yaml").write_text(SCENE.replace("800", "900").replace("A block {m}", "A thing {m}"),
                                       encoding="utf-8")
    assert run(["homework", "out/instructor/manifest.json", "--from-manifest", "-o", "third"]) == 0
    assert files(course / "out") == files(course / "third")


@pytest.mark.sweep
def test_what_no_system_compares_is_marked_by_hand(course, capsys):
    (course / "letters.yaml").write_text(LETTERS, encoding="utf-8")
    assert exported(*ALL, "--pool", "2", file="letters.yaml") == 0
    assert "letters: omega[1], equation[x]: marked by hand" in capsys.readouterr().out
    out = course / "out" / "instructor"
    quiz = ElementTree.parse(out / "moodle" / "questions.xml")
    essays = [one for one in quiz.iter("question") if one.get("type") == "essay"]
    assert len(essays) == 2
    for one in essays:
        assert "\\sqrt" in one.find("graderinfo/text").text
        assert "\\sqrt" not in one.find("questiontext/text").text
    page = (out / "prairielearn/questions/letters-by-hand/question.html").read_text(encoding="utf-8")
    assert "<pl-manual-grading-only>{{{params.key}}}" in page and "pl-number-input" not in page
    assert all(getattr(course_systems, name)(files(out / name), *((out / name,) * (name == "prairielearn"))) == {}
               for name in FORMATS)


@pytest.mark.sweep
def test_a_problem_called_as_what_is_marked_by_hand_of_another(course):
    """Each has a folder of its own."""
    (course / "letters.yaml").write_text(LETTERS, encoding="utf-8")
    (course / "letters-by-hand.yaml").write_text(SCENE, encoding="utf-8")
    (course / "set.yaml").write_text("problems: [letters.yaml, letters-by-hand.yaml]\n", encoding="utf-8")
    assert exported("--export", "prairielearn", "--pool", "2", file="set.yaml") == 0
    folders = {path.name: path for path in (course / "out/instructor/prairielearn/questions").iterdir()}
    other, = set(folders) - {"letters-by-hand"}
    assert "pl-number-input" in (folders[other] / "question.html").read_text(encoding="utf-8")
    assert "pl-manual-grading-only" in (folders["letters-by-hand"] / "question.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("options, code, said", [
    (["--export", "scorm", "--pool", "3"], 2, "'scorm' is not one of"),
    (["--export", "moodle"], 2, "--pool 40"), (["--pool", "3"], 2, "--export canvas"),
    (["--export", "moodle", "--pool", "0"], 2, "pool"), (["--export", "moodle", "--pool", "3", "--paper", "2"], 2,
                                                         "hand out by themselves"),
    (["--export", "moodle", "--pool", "1000"], 4, "block has 18 variants, and a pool of 1000 is asked for")])
def test_refusals_leave_nothing_behind(course, capsys, options, code, said):
    assert exported(*options) == code
    assert said in capsys.readouterr().err
    assert not (course / "out").exists() and not list(course.glob(".out*"))


@pytest.mark.sweep
def test_a_key_that_canvas_loses_is_refused_by_it_alone(course, capsys):
    small = SCENE.replace('"zeta[1]": ', '"zeta[1]^3": ').replace("  ask:", "  without: [readable]\n  ask:")
    (course / "small.yaml").write_text(small, encoding="utf-8")
    assert exported("--export", "moodle", "--export", "canvas", "--pool", "3", file="small.yaml") == 4
    assert "no unit brings it between" in capsys.readouterr().err and not (course / "out").exists()
    assert exported("--export", "moodle", "--pool", "3", file="small.yaml") == 0


@pytest.mark.sweep
def test_a_variant_whose_item_names_its_key_is_in_no_pool(course, capsys):
    assert exported("--export", "qti21", "--pool", "18") == 0
    problem, = json.loads((course / "out/instructor/manifest.json").read_text(encoding="utf-8"))["problems"]
    named = f"lift-{problem['variants'][4]['keys'][0]['value']:.1f}"
    those = [one["variant"] for one in problem["variants"]
             if f"{one['keys'][0]['value']:.1f}" != named.removeprefix("lift-")]
    (course / f"{named}.yaml").write_text(SCENE, encoding="utf-8")
    capsys.readouterr()
    assert exported("--export", "qti21", "--pool", "18", file=f"{named}.yaml", out="more") == 4
    assert f"has {len(those)} variants that by chance tell no key of their own" in (said := capsys.readouterr().err)
    assert f"ask for --pool {len(those)}" in said and not (course / "more").exists()
    assert exported("--export", "qti21", "--pool", str(len(those)), file=f"{named}.yaml", out="more") == 0
    problem, = json.loads((course / "more/instructor/manifest.json").read_text(encoding="utf-8"))["problems"]
    assert [one["variant"] for one in problem["variants"]] == those and len(those) < 18


@pytest.mark.sweep
def test_a_variant_whose_question_tells_its_key_by_chance_is_in_no_pool(course, capsys):
    """At as many figures as the question has, which its band does not reach."""
    exact = SCENE.replace("points: 2}", "points: 2, rtol: 0.01 %}")
    (course / "exact.yaml").write_text(exact, encoding="utf-8")
    assert exported("--export", "qti21", "--pool", "18", file="exact.yaml") == 0
    problem, = json.loads((course / "out/instructor/manifest.json").read_text(encoding="utf-8"))["problems"]
    keys = [one["keys"][0] for one in problem["variants"]]
    number = next(number for key in keys if abs((number := round(key["value"], 1)) - key["value"]) > 5 * key["band"])
    (course / "warm.yaml").write_text(exact.replace("A block {m}", f"In a room at {number} °C a block {{m}}"),
                                      encoding="utf-8")
    assert exported("--export", "qti21", "--pool", "18", file="warm.yaml", out="more") == 4
    assert "variants that by chance tell no key of their own" in capsys.readouterr().err
    assert exported("--export", "qti21", "--pool", "12", file="warm.yaml", out="more") == 0
    problem, = json.loads((course / "more/instructor/manifest.json").read_text(encoding="utf-8"))["problems"]
    assert all(abs(one["keys"][0]["value"] - number) > 0.05 for one in problem["variants"])


def test_a_question_that_tells_a_key_is_not_exported(course, capsys):
    leak = SCENE.replace("A block {m}", "Find 25.05 = 626/25 of {m}").replace(
        "  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}, k: [620 N/m, 820 N/m, 1.1 kN/m]}",
        "  parameters: {m: [1 kg]}\n  without: [readable]").replace("800 N/m", "643.6 N/m")
    (course / "leak.yaml").write_text(leak, encoding="utf-8")
    assert exported("--export", "qti21", "--pool", "1", file="leak.yaml") == 4
    assert "the question leak-1 would tell the key 25.05" in capsys.readouterr().err
    assert not (course / "out").exists()


def test_the_manual_tells_of_every_format():
    assert [name for name, _ in EXPORTS[1]] == sorted(FORMATS, key=[name for name, _ in EXPORTS[1]].index)
    assert {name for name, _ in EXPORTS[1]} == set(FORMATS)
    assert re.search(r"10\^1", str(EXPORTS))
