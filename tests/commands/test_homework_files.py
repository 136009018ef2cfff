"""Records and tables from which a problem takes numbers: they go out with its sheets, and stand in the manifest."""

import json
from pathlib import Path

import pytest

from vibcli.cli.program import run
from vibcli.homework.leaks import comments_of, text_of_page

SCENE = """title: A block on shaken ground
question: A block {m} on a spring {k}. The ground moves as quake.csv tells.
parameters: {m: 2 kg, k: 800 N/m}
records: {ag: {file: data/quake.csv, unit: m/s^2}}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
forces: {f: {coordinate: x, value: -m*ag(t)}}
variants:
  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}}
  ask: {"max(x)": mm}
"""
QUAKE = "t,a\n0.0,0.0\n0.1,0.42\n0.25,-0.61\n0.4,0.35\n0.6,0\n"


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    Path("data").mkdir()
    Path("data/quake.csv").write_text(QUAKE, encoding="utf-8")
    Path("block.yaml").write_text(SCENE, encoding="utf-8")
    Path("salt").write_text("a secret text\n", encoding="utf-8")


def homework(*options, file="block.yaml", out="out"):
    return run(["homework", file, "-o", out, "--paper", "3", "--salt-file", "salt", *options])


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()}


@pytest.mark.sweep
def test_a_record_goes_out_with_the_sheet(course):
    assert homework() == 0
    found = files("out")
    assert found["student/data/quake.csv"] == QUAKE.encode()
    said = text_of_page(found["student/1.html"].decode())
    assert "With this sheet comes data/quake.csv." in said and "5 samples of data/quake.csv" in said
    manifest = json.loads(found["instructor/manifest.json"])
    assert manifest["problems"][0]["files"] == {"data/quake.csv": QUAKE}
    Path("data/quake.csv").unlink()
    Path("block.yaml").unlink()
    assert run(["homework", "out/instructor/manifest.json", "--from-manifest", "-o", "again"]) == 0
    assert files("again") == found


@pytest.mark.sweep
@pytest.mark.parametrize("line, said", [("# tells a secret text", "the salt"), ("# the peak is {}", "the key"),
                                        ("0.7 0.1 # as at home", "")])
def test_its_words_are_held_against_keys_and_salt(course, capsys, line, said):
    assert homework() == 0
    manifest = json.loads(files("out")["instructor/manifest.json"])
    key = manifest["problems"][0]["variants"][0]["keys"][0]["value"]
    Path("data/quake.csv").write_text(QUAKE + line.format(f"{key:.3g}") + "\n", encoding="utf-8")
    assert homework(out="other") == (4 if said else 3)
    assert said in capsys.readouterr().err and not Path("other").exists()


@pytest.mark.sweep
def test_numbers_of_its_rows_are_no_keys(course):
    assert homework() == 0
    manifest = json.loads(files("out")["instructor/manifest.json"])
    key = manifest["problems"][0]["variants"][0]["keys"][0]["value"]
    rows = "".join(f"{line},{key:.4g}\n" for line in QUAKE.splitlines()[1:])
    Path("data/quake.csv").write_text("t,a,measured\n" + rows, encoding="utf-8")
    assert homework(out="other") == 0


@pytest.mark.sweep
def test_two_files_of_one_name(course, capsys):
    for name, quake in (("one", QUAKE), ("two", QUAKE), ("three", QUAKE.replace("0.42", "0.52"))):
        (Path(name) / "data").mkdir(parents=True)
        (Path(name) / "data" / "quake.csv").write_text(quake, encoding="utf-8")
        (Path(name) / f"{name}.yaml").write_text(SCENE, encoding="utf-8")
    Path("set.yaml").write_text("problems: [one/one.yaml, two/two.yaml]\n", encoding="utf-8")
    assert homework(file="set.yaml") == 0
    Path("set.yaml").write_text("problems: [one/one.yaml, three/three.yaml]\n", encoding="utf-8")
    assert homework(file="set.yaml", out="other") == 4
    assert "another file with this name is handed out" in capsys.readouterr().err and not Path("other").exists()


def test_comments_of_a_scene():
    scene = """# first
title: A block   # of the lecturer
question: >-
  Block #2 on spring # 3 is not a comment
parameters: {m: 2 kg, s: "# nor this"}  #ab
"""
    assert comments_of(scene) == ["first", "of the lecturer"]
