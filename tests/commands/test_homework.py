"""`vibcli homework` and `vibcli grade` as a lecturer uses them: sheets, keys, manifest, marks; what is refused."""

import csv
import json
import os
from pathlib import Path

import jsonschema
import pytest
import yaml

from vibcli.cli.program import run
from vibcli.homework.leaks import leak, text_of_page
from vibcli.homework.manifest import seal

SCENE = """# the answer is easy
title: A block
question: A block {m} on a spring {k} and a damper {c}.
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {d: {c: c, between: [ground, block]}}
answers: {"omega_d[1]": 19.90 rad/s}
variants:
  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}, k: [620 N/m, 820 N/m, 1.1 kN/m]}
  ask: {"omega_d[1]": {unit: rad/s, points: 2}, "zeta[1]": }
"""


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "block.yaml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "roster.csv").write_text("id,name\ns1,Ada\ns2,Bo\ns3,\n", encoding="utf-8")
    (tmp_path / "salt").write_text("a secret text\n", encoding="utf-8")
    return tmp_path


@pytest.fixture(autouse=True)
def pages(request, monkeypatch):
    """Sheets are pages, but for the tests of paper."""
    if not request.node.name.startswith("test_paper"):
        monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)


def homework(*options, file="block.yaml", out="out"):
    return run(["homework", file, "-o", out, "--students", "roster.csv", "--salt-file", "salt", *options])


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.sweep
def test_sheets_keys_and_marks(course, capsys):
    assert homework() == 0
    out = course / "out"
    manifest = json.loads((out / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    assert [one["id"] for one in manifest["students"]] == ["s1", "s2", "s3"]
    variants = {one["variant"]: one for one in manifest["problems"][0]["variants"]}
    assert len(variants) == 3
    keys = list(csv.DictReader((out / "instructor" / "keys.csv").open(encoding="utf-8")))
    assert len(keys) == 6
    for student in manifest["students"]:
        found = variants[student["sheets"][0]["variant"]]
        page = text_of_page((out / "student" / f"{student['id']}.html").read_text(encoding="utf-8"))
        assert leak(page, [key["value"] for key in found["keys"]], ["a secret text", "the answer is easy"]) is None
        for text in found["values"].values():
            assert text.split()[0] in page
        assert "Steps" in (out / "instructor" / "keys" / f"block-{found['variant']}.html").read_text(encoding="utf-8")
    capsys.readouterr()
    own = [row for row in keys if row["id"] == "s2"]
    answers = [f"--answer={row['quantity']}={row['key']} {row['unit']}" for row in own]
    assert run(["grade", "out/instructor/manifest.json", "--student", "s2", *answers]) == 0
    assert "3 of 3 points" in capsys.readouterr().out
    (course / "answers.csv").write_text("id,omega_d[1],zeta[1]\n" + f"s2,{own[0]['key']},{own[1]['key']}\ns1,4,=2\n",
                                        encoding="utf-8")
    assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv", "-o", "marks.csv"]) == 0
    found = list(csv.DictReader((course / "marks.csv").open(encoding="utf-8")))
    assert [row["verdict"] for row in found] == ["right", "right", "wrong", "unreadable"]
    assert found[3]["answer"] == "'=2"


@pytest.mark.sweep
def test_the_same_bytes_again_and_from_the_manifest_after_an_edit(course):
    assert homework("--force") == 0 and homework(out="again") == 0
    assert files(course / "out") == files(course / "again")
    (course / "block.yaml").write_text(SCENE.replace("800", "900").replace("A block {m}", "A thing {m}"),
                                       encoding="utf-8")
    assert run(["homework", "out/instructor/manifest.json", "--from-manifest", "-o", "third"]) == 0
    assert files(course / "out") == files(course / "third")


@pytest.mark.sweep
def test_a_student_who_comes_later_changes_nobody(course):
    assert homework() == 0
    with (course / "roster.csv").open("a", encoding="utf-8") as stream:
        stream.write("s4,Eve\n")
    assert homework(out="more") == 0
    before, after = files(course / "out"), files(course / "more")
    assert all(after[name] == data for name, data in before.items() if name.startswith("student"))


@pytest.mark.sweep
def test_a_set_with_parts(course, capsys):
    (course / "more").mkdir()
    for name in ("one", "two", "three"):
        (course / "more" / f"{name}.yaml").write_text(SCENE.replace("A block", f"The {name}"), encoding="utf-8")
    (course / "set.yaml").write_text("title: Week 3\ncourse: Dynamics\nproblems: [{file: block.yaml, points: 6}, "
                                     "{file: more, pick: 2}]\n", encoding="utf-8")
    assert homework(file="set.yaml") == 0
    manifest = json.loads((course / "out" / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    assert all(len(one["sheets"]) == 3 and one["sheets"][0]["problem"] == "block" for one in manifest["students"])
    assert [key["points"] for key in manifest["problems"][0]["variants"][0]["keys"]] == [4, 2]
    page = (course / "out" / "student" / "s1.html").read_text(encoding="utf-8")
    assert "Week 3" in page and "Dynamics" in page and "3. The" in page
    capsys.readouterr()
    assert run(["grade", "out/instructor/manifest.json", "--student", "s1", "--answer", "zeta[1]=0.1"]) == 2
    assert "say which of block" in capsys.readouterr().err
    for paths in (["."], ["set.yaml", "block.yaml"]):
        assert run(["check", *paths]) == 0
        assert "set.yaml" not in capsys.readouterr().out


@pytest.mark.sweep
def test_a_number_of_one_problem_that_is_a_key_of_another(course):
    """Who would read 20.1 kg beside a key of 20.1 rad/s gets another variant."""
    (course / "one.yaml").write_text(SCENE.replace("{from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}", "[2 kg]"),
                                     encoding="utf-8")
    assert homework(file="one.yaml") == 0
    manifest = json.loads((course / "out" / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    keys = [f"{one['keys'][0]['value']:.3g} kg" for one in manifest["problems"][0]["variants"]]
    two = SCENE.replace("{from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}", f"[{', '.join(keys)}, 2.5 kg, 2.6 kg, 2.7 kg]")
    two = two.replace("[620 N/m, 820 N/m, 1.1 kN/m]", "[800 N/m]")
    (course / "two.yaml").write_text(two, encoding="utf-8")
    (course / "set.yaml").write_text("problems: [one.yaml, two.yaml]\n", encoding="utf-8")
    for number in range(1, 5):
        assert homework("--attempt", str(number), file="set.yaml", out=f"out{number}") == 0


@pytest.mark.sweep
def test_a_case_with_variants_of_its_own(course, capsys):
    """What another case alone uses is no fault of it."""
    scene, _, variants = SCENE.partition("variants:")
    (course / "block.yaml").write_text(scene.replace("c: 8 N*s/m}", "c: 8 N*s/m, k2: 500 N/m}") + f"""cases:
  two springs: {{springs: {{s2: {{k: k2, between: [ground, block]}}}}}}
  one spring:
    variants:{variants.replace(chr(10), chr(10) + "    ")}""", encoding="utf-8")
    (course / "set.yaml").write_text("problems: [{file: block.yaml, case: one spring}]\n", encoding="utf-8")
    assert run(["variants", "block.yaml", "--case", "one spring"]) == 0
    assert homework(file="set.yaml") == 0
    assert run(["homework", "out/instructor/manifest.json", "--from-manifest", "-o", "again"]) == 0
    assert files(course / "out") == files(course / "again")


@pytest.mark.sweep
def test_numbered_sheets(course):
    assert run(["homework", "block.yaml", "-o", "out", "--paper", "12", "--salt-file", "salt"]) == 0
    assert sorted(path.name for path in (course / "out" / "student").iterdir())[0] == "01.html"


@pytest.mark.parametrize("options, code, said", [
    (["--paper", "3"], 2, "say for whom"), (["--distinct"], 0, ""), (["--attempt", "0"], 2, "attempt"),
    (["--from-manifest"], 2, "knows its students")])
def test_options(course, capsys, options, code, said):
    assert homework(*options) == code
    assert said in capsys.readouterr().err


def test_refusals_leave_nothing_behind(course, capsys):
    def refused(code, said, *args):
        assert run(["homework", *args]) == code
        assert said in capsys.readouterr().err
        assert not (course / "out").exists() and not list(course.glob(".out*"))

    known = ("-o", "out", "--students", "roster.csv", "--salt-file", "salt")
    refused(2, "name a file with a secret text", "block.yaml", "-o", "out", "--paper", "3")
    (course / "short").write_text("abc")
    refused(2, "it could be guessed", "block.yaml", "-o", "out", "--paper", "3", "--salt-file", "short")
    refused(2, "there is no file 'none'", "none", *known)
    (course / "leak.yaml").write_text(SCENE.replace("A block {m}", "Find 25.05 = 626/25 of {m}").replace(
        "  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}, k: [620 N/m, 820 N/m, 1.1 kN/m]}",
        "  parameters: {m: [1 kg]}\n  without: [readable]").replace("800 N/m", "643.6 N/m"), encoding="utf-8")
    refused(4, "would tell the key 25.05", "leak.yaml", *known)
    (course / "bare.yaml").write_text(SCENE.partition("variants")[0], encoding="utf-8")
    refused(3, "says nothing of variants", "bare.yaml", *known)
    (course / "few.yaml").write_text(SCENE.replace("k: [620 N/m, 820 N/m, 1.1 kN/m]}", "k: [800 N/m]}").replace(
        "from: 1.2 kg, to: 3.2 kg, step: 0.4 kg", "from: 1 kg, to: 2 kg, step: 1 kg"), encoding="utf-8")
    refused(4, "3 students, 2 variants: up to 2 share one", "few.yaml", *known, "--distinct")
    refused(2, "there is no folder nowhere", "block.yaml", "-o", "nowhere/out", *known[2:])
    refused(2, "File name too long", "block.yaml", "-o", 300 * "a", *known[2:])
    (course / "empty").mkdir()
    os.chdir("empty")
    try:
        refused(2, "is not replaced", "../block.yaml", "-o", ".", "--paper", "2", "--salt-file", "../salt")
    finally:
        os.chdir("..")
    (course / "full").mkdir()
    (course / "full" / "thesis.txt").write_text("mine")
    assert homework(out="full") == 2 and homework("--force", out="full") == 2
    assert (course / "full" / "thesis.txt").read_text() == "mine"


@pytest.mark.sweep
@pytest.mark.parametrize("fault", [KeyboardInterrupt, RuntimeError, MemoryError])
def test_what_breaks_off_in_the_middle_leaves_the_folder_as_it_was(course, monkeypatch, fault):
    """Nothing where nothing was, and the old sheets where they are being replaced."""
    from vibcli.homework import folder

    whole = folder.manifest

    def broken(*args):
        raise fault

    monkeypatch.setattr(folder, "manifest", broken)
    assert homework() in (101, 130)
    assert not (course / "out").exists() and not list(course.glob(".out*"))
    monkeypatch.setattr(folder, "manifest", whole)
    assert homework() == 0
    before = files(course / "out")
    monkeypatch.setattr(folder, "manifest", broken)
    assert homework("--force", "--attempt", "2") in (101, 130)
    assert files(course / "out") == before and not list(course.glob(".out*"))


@pytest.mark.sweep
def test_sharing_of_problems_that_are_picked(course, capsys):
    (course / "more").mkdir()
    single = SCENE.replace("{from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}", "[2 kg]").replace(", 820 N/m, 1.1 kN/m", "")
    for name in ("one", "two"):
        (course / "more" / f"{name}.yaml").write_text(single, encoding="utf-8")
    (course / "set.yaml").write_text("problems: [{file: more, pick: 1}]\n", encoding="utf-8")
    assert homework(file="set.yaml", out="shared") == 0
    assert "1 variant: up to" in capsys.readouterr().err
    assert homework("--distinct", file="set.yaml") == 4 and not (course / "out").exists()


def test_manifests_that_are_none(course, capsys):
    for text, said in (("{", "this is no manifest"), ("[" * 100_000, "this is no manifest"),
                       ("[]", "no manifest of this version"), ('{"form": 1}', "no manifest")):
        (course / "m.json").write_text(text)
        assert run(["grade", "m.json", "--student", "s1", "--answer", "x=1"]) == 3
        assert said in capsys.readouterr().err
    assert run(["grade", "nowhere.json", "--student", "s1"]) == 3


@pytest.mark.sweep
def test_manifests_that_are_damaged(course, capsys):
    """With any part of it taken out or of another kind: said, by its path, never a fault of ours."""
    assert homework() == 0
    path = course / "out" / "instructor" / "manifest.json"
    whole = path.read_text(encoding="utf-8")
    places = [("problems",), ("students",), ("problems", 0, "variants"), ("problems", 0, "scene"),
              ("problems", 0, "variants", 0, "keys", 0, "value"), ("students", 0, "sheets", 0, "variant"),
              ("problems", 0, "variants", 0, "keys", 0, "mistakes", 0, "name")]
    for place in places:
        for other in (None, "text", {}):
            data = json.loads(whole)
            *way, last = place
            inner = data
            for key in way:
                inner = inner[key]
            if isinstance(inner[last], type(other)):
                continue
            inner[last] = other
            path.write_text(json.dumps(data), encoding="utf-8")
            capsys.readouterr()
            assert run(["grade", str(path), "--student", "s1", "--answer", "zeta[1]=1"]) == 3
            assert run(["homework", str(path), "--from-manifest", "-o", "third"]) == 3
            assert f"damaged: {place[0]}" in capsys.readouterr().err


@pytest.mark.sweep
def test_manifests_that_were_edited(course, capsys):
    """Any other value is known by the seal, and one with a seal of its own leads nowhere outside."""
    assert homework() == 0
    path = course / "out" / "instructor" / "manifest.json"
    whole = json.loads(path.read_text(encoding="utf-8"))
    key = whole["problems"][0]["variants"][0]["keys"][0]
    for edited in (key | {"value": 5.0}, key | {"figures": -1}, key | {"mistakes": []}):
        whole["problems"][0]["variants"][0]["keys"][0] = edited
        path.write_text(json.dumps(whole), encoding="utf-8")
        for command in (["grade", str(path), "--student", "s1", "--answer", "zeta[1]=1"],
                        ["homework", str(path), "--from-manifest", "-o", "third"]):
            capsys.readouterr()
            assert run(command) == 3 and "was changed after it was written" in capsys.readouterr().err
    whole["problems"][0]["variants"][0]["keys"][0] = key
    whole["students"][0]["id"] = "../../../evil"
    path.write_text(json.dumps(whole | {"seal": seal(whole)}), encoding="utf-8")
    assert run(["homework", str(path), "--from-manifest", "-o", "third"]) == 4
    assert "leads out of the folder" in capsys.readouterr().err and not (course / "third").exists()


def test_a_case_that_is_none_is_told_in_the_set(course, capsys):
    (course / "set.yaml").write_text("problems: [{file: block.yaml, case: stif}]\n", encoding="utf-8")
    assert homework(file="set.yaml") == 3 and not (course / "out").exists()
    assert "set.yaml:1:31: error: block.yaml: the file has no case 'stif'" in capsys.readouterr().err


@pytest.mark.sweep
def test_a_mistake_that_cannot_be_solved_hands_out_nothing(course, capsys):
    (course / "block.yaml").write_text(SCENE + "  mistakes: {pole: {bodies: {block: {mass: -m}}}}\n", encoding="utf-8")
    assert homework() == 3 and not (course / "out").exists()
    said = capsys.readouterr().err
    assert "block.yaml:12:20: error: the mistake 'pole' gives nothing in any variant: the mass is -1" in said


@pytest.mark.sweep
@pytest.mark.parametrize("text, said", [
    ("omega_d[1],id\n5\n", "no id"), ("id,zeta[1],zeta[1]\ns1,1,2\n", "the column 'zeta[1]' stands twice"),
    ("id,zeta[1]\ns1,1,2\n", "has 3 cells"), ("id,zeta[1]\ns1,1\ns1,2\n", "stand in line 2 already"),
    ("id,zetta[1]\ns1,1\n", "does not ask for 'zetta[1]'"), ("zeta[1]\n1\n", "one of them is 'id'"),
    ('id,zeta[1]\ns1,"' + "1" * 200_000 + '"\n', "cannot be read"), ("id,zeta[1]\ns9,1\n", "no student 's9'")])
def test_answers_that_are_none(course, capsys, text, said):
    assert homework() == 0
    (course / "answers.csv").write_text(text, encoding="utf-8")
    capsys.readouterr()
    assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv"]) == 3
    assert said in capsys.readouterr().err


@pytest.mark.sweep
def test_hostile_answers(course, capsys):
    """Neither orders to a screen nor formulas of a spreadsheet nor a cell without end come through."""
    assert homework() == 0
    hostile = "\x1b[31m23.37", "=1+1", "+1e5", "9" * 100_000, "23\u202e.37", "-12.5 rad/s"
    for answer in hostile:
        (course / "answers.csv").write_text(f"id,omega_d[1]\ns1,{answer}\n", encoding="utf-8")
        capsys.readouterr()
        assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv"]) == 0
        shown = capsys.readouterr().out
        assert all(letter.isprintable() or letter == "\n" for letter in shown) and len(shown) < 1500
        assert "'=1+1" in shown if answer == "=1+1" else f",{answer}," in shown if answer[0] in "+-" else True
    (course / "answers.csv").write_text("id,zeta[1],zeta [1]\ns1,0.1,0.2\n", encoding="utf-8")
    assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv"]) == 3
    assert "zeta[1] is answered twice" in capsys.readouterr().err
    twice = "--answer=zeta[1]=0.1", "--answer=zeta[ 1 ]=0.2"
    assert run(["grade", "out/instructor/manifest.json", "--student", "s1", *twice]) == 2
    assert "zeta[1] is answered twice" in capsys.readouterr().err


@pytest.mark.sweep
def test_a_table_is_read_whole_or_not_at_all(course, capsys, monkeypatch):
    assert homework() == 0
    monkeypatch.setattr("vibcli.homework.tables.MAX_BYTES", 20)
    (course / "answers.csv").write_text("id,zeta[1]\ns1,1\ns2,1\ns3,1\n", encoding="utf-8")
    assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv"]) == 3
    assert "longer than 20 bytes" in capsys.readouterr().err


@pytest.mark.sweep
def test_paper(course):
    """PDF: read back, its pages, no key in it, the same bytes again."""
    pytest.importorskip("typst")
    pypdf = pytest.importorskip("pypdf")
    assert homework() == 0 and homework(out="again") == 0
    assert files(course / "out") == files(course / "again")
    manifest = json.loads((course / "out" / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    variants = {one["variant"]: one for one in manifest["problems"][0]["variants"]}
    for student in manifest["students"]:
        read = pypdf.PdfReader(course / "out" / "student" / f"{student['id']}.pdf")
        found = variants[student["sheets"][0]["variant"]]
        text = "\n".join([*map(str, (read.metadata or {}).values()), *(page.extract_text() for page in read.pages)])
        assert len(read.pages) == 1 and leak(text, [key["value"] for key in found["keys"]], ["a secret text"]) is None
        assert all(value.split()[0] in text for value in found["values"].values()) and "omega_d[1]" in text
        key = pypdf.PdfReader(course / "out" / "instructor" / "keys" / f"block-{found['variant']}.pdf")
        assert leak("\n".join(page.extract_text() for page in key.pages), [found["keys"][0]["value"]], []) is not None


@pytest.mark.sweep
def test_marks_as_json(course, capsys):
    assert homework() == 0
    capsys.readouterr()
    manifest = json.loads((course / "out" / "instructor" / "manifest.json").read_text(encoding="utf-8"))
    number = manifest["students"][0]["sheets"][0]["variant"]
    key = next(one for one in manifest["problems"][0]["variants"] if one["variant"] == number)["keys"][0]
    key, band = key["value"], key["band"]
    mine = ("grade", "out/instructor/manifest.json", "--student", "s1")
    assert run([*mine, "--answer", f"omega_d[1]={key:.4g}", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    right, missing = found["marks"]
    assert (found["points"], found["of"]) == (2, 3) and right["verdict"] == "right" and missing["answer"] is None
    assert right == {"id": "s1", "problem": "block", "quantity": "omega_d[1]", "answer": f"{key:.4g}", "points": 2,
                     "of": 2, "verdict": "right", "mistake": None, "said": None,
                     "off": float(f"{key:.4g}") - key, "band": band, "unit": "rad/s"}
    far = f"omega_d[1]={key + 1.5 * band!r}"
    assert run([*mine, "--answer", far]) == 0
    shown, said = capsys.readouterr().out, "no known mistake leads to this: it lies further from the key than its band"
    assert f"({said} reaches, but not twice as far; off by +" in shown and " rad/s, allowed ± " in shown
    (course / "answers.csv").write_text(f'id,"omega_d[1]"\ns1,{far.partition("=")[2]}\n', encoding="utf-8")
    assert run(["grade", "out/instructor/manifest.json", "--csv", "answers.csv", "-o", "marks.csv"]) == 0
    wrong, _ = csv.DictReader((course / "marks.csv").open(encoding="utf-8"))
    assert wrong["said"].startswith(said) and not {"off", "band", "key"} & set(wrong)
    assert run([*mine, "--json", "-o", "marks.csv"]) == 2 and "choose one" in capsys.readouterr().err


def test_the_schema_of_sets(capsys):
    assert run(["schema", "--set"]) == 0
    found = json.loads(capsys.readouterr().out)
    jsonschema.Draft7Validator.check_schema(found)
    valid = jsonschema.Draft7Validator(found).is_valid
    path = Path(__file__).parents[2] / "problems" / "sets" / "free_vibration_with_a_lever" / "set.yaml"
    assert valid(yaml.safe_load(path.read_text(encoding="utf-8")))
    assert valid({"problems": ["a.yaml", {"file": "more", "pick": 2}]}) and not valid({"title": "Week 3"})
    assert not valid({"problems": [{"fil": "a.yaml"}]}) and not valid({"problems": []})


def test_a_set_is_told_from_a_scene_with_a_slip(tmp_path, capsys):
    (tmp_path / "set.yaml").write_text("course: Dynamics\nproblems: [a.yaml]\n", encoding="utf-8")
    assert run(["solve", str(tmp_path / "set.yaml")]) == 3
    assert capsys.readouterr().err.count("hint: this is a set of problems: vibcli homework hands it out") == 2
