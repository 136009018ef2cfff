"""`--jobs` of `vibcli variants` and `vibcli homework`: the same bytes, whatever does the work."""

import pickle
from concurrent.futures import Executor, Future

import pytest
from support.homework_scenes import EIGHTEEN as SCENE
from support.homework_scenes import LETTERS

from vibcli.api.source import file_source, problem_of
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.homework.course import course_of
from vibcli.homework.document import SceneDocument
from vibcli.homework.folder import Leak
from vibcli.homework.folder import files as written
from vibcli.homework.handout import Handout
from vibcli.homework.paper import Pages
from vibcli.homework.parts import solve_in_parts
from vibcli.homework.roster import Student


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
    packages = ["homework", "set.yaml", "--pool", "3", "--export", "moodle", "--export", "qti21", "--salt-file", "salt"]
    assert run([*packages, "-o", "three"]) == 0 and run([*packages, "-o", "four", "--jobs", "2"]) == 0
    assert files(course / "three") == files(course / "four") and len(files(course / "three")) > 10
    capsys.readouterr()
    shown = [(run(["variants", "one.yaml", "--table", "--rejected", *more]), capsys.readouterr().out)
             for more in ([], ["--jobs", "2"])]
    assert shown[0] == shown[1] and shown[0][0] == 0


class Elsewhere(Executor):
    """Gives work away as bytes, and takes it back so."""

    def __init__(self):
        self.count = 0

    def submit(self, work, /, *args):
        self.count += 1
        found = Future()
        work, args = pickle.loads(pickle.dumps((work, args)))
        try:
            found.set_result(pickle.loads(pickle.dumps(work(*args))))
        except PhysicsError as error:
            found.set_exception(pickle.loads(pickle.dumps(error)))
        return found


@pytest.mark.sweep
def test_sheets_are_made_elsewhere_and_leaks_seen_there(course, monkeypatch, capsys):
    """A task has no more students than it may, an even number of them, and no key twice."""
    monkeypatch.setattr("vibcli.homework.making.SIZE", 3)
    one = course_of("one.yaml").problems[0]
    source = file_source("one.yaml")
    document = SceneDocument.of(source.node, source.file, None)
    found = solve_in_parts(problem_of(source), document)
    handout = Handout.of(one, found, document, SCENE)
    who = [(Student(str(number)), [(handout, number % 4)]) for number in range(7)]
    told, elsewhere = [], Elsewhere()
    options = course_of("one.yaml"), [handout], who, 1, "a secret text", Pages(), told.append
    here = dict(written(*options))
    assert dict(written(*options, elsewhere)) == here and elsewhere.count == 4 and told[-1] == 1.0
    assert sum("keys/" in name for name in here) == 4 and sum(name.startswith("student") for name in here) == 7
    with pytest.raises(Leak, match="the sheet of 0 would tell") as refused:
        list(written(*options[:4], "and a damper", *options[5:], elsewhere))
    assert "nothing was written" in refused.value.hint


@pytest.mark.parametrize("options, said", [
    (["--jobs", "0"], "jobs"), (["--jobs", "2", "--cluster", "tcp://localhost:1"], "choose one")])
def test_refusals_write_nothing(course, capsys, options, said):
    assert run(["homework", "set.yaml", "--paper", "3", "--salt-file", "salt", "-o", "out", *options]) == 2
    assert said in capsys.readouterr().err and not (course / "out").exists()
