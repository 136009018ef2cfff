"""`--jobs` of `vibcli variants` and `vibcli homework`: the same bytes, whatever does the work."""

import pytest
from support.homework_scenes import EIGHTEEN as SCENE

from vibcli.cli import run

LETTERS = """title: A block in letters
question: A block {m} on a spring {k}.
parameters: {m: {}, k: {}, n: 1}
bodies: {block: {mass: n*m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
variants:
  parameters: {n: [2, 3, 5]}
  ask: {"omega[1]": , "equation[x]": }
  without: [told]
"""


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    for name, text in (("one", SCENE), ("two", SCENE.replace("820", "850")), ("three", LETTERS)):
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    (tmp_path / "set.yaml").write_text("title: Week 3\nproblems: [one.yaml, two.yaml, three.yaml]\n", encoding="utf-8")
    (tmp_path / "salt").write_text("a secret text", encoding="utf-8")
    return tmp_path


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.sweep
def test_homework_and_variants_are_the_same(course, capsys):
    options = ["homework", "set.yaml", "--paper", "3", "--salt-file", "salt"]
    assert run([*options, "-o", "one"]) == 0 and run([*options, "-o", "two", "--jobs", "2"]) == 0
    assert files(course / "one") == files(course / "two") and len(files(course / "one")) > 10
    capsys.readouterr()
    shown = [(run(["variants", "one.yaml", "--table", "--rejected", *more]), capsys.readouterr().out)
             for more in ([], ["--jobs", "2"])]
    assert shown[0] == shown[1] and shown[0][0] == 0


@pytest.mark.parametrize("options, said", [
    (["--jobs", "0"], "jobs"), (["--jobs", "2", "--cluster", "tcp://localhost:1"], "choose one")])
def test_refusals_write_nothing(course, capsys, options, said):
    assert run(["homework", "set.yaml", "--paper", "3", "--salt-file", "salt", "-o", "out", *options]) == 2
    assert said in capsys.readouterr().err and not (course / "out").exists()
