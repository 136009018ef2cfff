"""`vibcli check` as CI servers read it: forms, rules, what is left out, what is read from stdin or has changed."""

import io
import json
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml
from support.checked import SCENE

from vibcli.base.errors import LostDigits, NoBound, NotInLetters, PhysicsError, Unknown
from vibcli.base.rules import RULES
from vibcli.check import comparison, verdicts
from vibcli.cli.checking import work
from vibcli.cli.checking.cache import folder_of
from vibcli.cli.checking.found import CheckedAnswer, CheckedFile
from vibcli.cli.checking.text import summary
from vibcli.cli.program import run

junitparser = pytest.importorskip("junitparser")
ROOT = Path(__file__).parents[2]
SCENES = {"agrees.yaml": SCENE.replace("MASS", "1"), "differs.yaml": SCENE.replace("MASS", "2"),
          "uncertain.yaml": SCENE.replace("MASS", "1") + "  2*omega[1]: 4.000 rad/s\n",
          "slip, 100 %: a.yaml": "bodies: {a: {mas: 1 kg}}\n", "loose.yaml": SCENE.replace("MASS", "0"),
          "none.yaml": "title: no answers\n"}
WRONG = {"differs.yaml": ["answer-differs"], "uncertain.yaml": ["answer-uncertain"],
         "slip, 100 %: a.yaml": ["scene-invalid"], "loose.yaml": ["cannot-be-solved"]}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The scenes in sets/, where twice a frequency is known to 0.01 rad/s alone."""
    plain = comparison.bounded
    monkeypatch.setattr(comparison, "bounded", lambda problem, expression: (4.0, 0.01) if (
        expression.text == "2*omega[1]") else plain(problem, expression))
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("GITHUB_ACTIONS", raising=False)
    (tmp_path / "sets").mkdir()
    for name, text in SCENES.items():
        (tmp_path / "sets" / name).write_text(text)
    return tmp_path


def told(form, capsys, *more):
    code = run(["check", "sets", "--format", form, *more])
    return code, capsys.readouterr().out


def annotations(text):
    """[(command, properties, message)] by the grammar of workflow commands: ::name key=value,…::message."""
    found = []
    for line in text.splitlines():
        name, properties, message = re.fullmatch(r"::(\w+) ([^:]*(?:::)?.*?)::(.*)", line).groups()
        values = dict(pair.split("=", 1) for pair in properties.split(","))
        found.append((name, {key: _plain(value) for key, value in values.items()}, _plain(message)))
    return found


def _plain(text):
    for code, char in (("%2C", ","), ("%3A", ":"), ("%0A", "\n"), ("%0D", "\r"), ("%25", "%")):
        text = text.replace(code, char)
    return text


def test_each_form_tells_the_same(folder, capsys):
    expected = sorted((name, rule) for name, rules in WRONG.items() for rule in rules)
    assert run(["check", "sets", "--format", "concise"]) == 3
    text, twice = capsys.readouterr()
    lines = [re.fullmatch(r"sets/(.+?\.yaml)(?::\d+:\d+)?: ([a-z-]+): .+", line) for line in text.splitlines()[:-1]]
    assert sorted(line.groups() for line in lines) == expected and not twice
    _, text = told("github", capsys)
    found = annotations(text)
    assert sorted((one["file"].removeprefix("sets/"), one["title"]) for _, one, _ in found) == expected
    assert {name for name, _, _ in found} == {"error"}
    _, text = told("sarif", capsys)
    results = json.loads(text)["runs"][0]["results"]
    assert len(results) == len(expected)
    _, text = told("junit", capsys)
    suites = junitparser.JUnitXml.fromstring(text.encode())
    rules = [(suite.name.removeprefix("sets/"), one.type) for suite in suites for case in suite for one in case.result]
    assert sorted(rules) == expected
    _, text = told("json", capsys)
    rules = {(one["file"].removeprefix("sets/"), each["rule"]) for one in json.loads(text)
             for each in one["answers"] + one["diagnostics"] if each["rule"]}
    assert sorted(rules) == expected


def test_json_tells_why_a_file_could_not_be_checked(folder, capsys, monkeypatch):
    (folder / "sets" / "gone.yaml").symlink_to("nowhere")
    (folder / "sets" / "driven.yaml").write_text(SCENES["agrees.yaml"] + "records: {a: {file: none.csv, unit: m}}\n")
    whole = work._checked
    monkeypatch.setattr(work, "_checked", lambda file, *rest: 1 / 0 if "none." in file else whole(file, *rest))
    code, text = told("json", capsys)
    found = {one["file"].removeprefix("sets/"): one["diagnostics"] for one in json.loads(text)}
    assert code == 101 and [name for name, those in found.items() if those] == [
        "driven.yaml", "gone.yaml", "loose.yaml", "none.yaml", "slip, 100 %: a.yaml", "uncertain.yaml"]
    slip, = found["slip, 100 %: a.yaml"]
    assert slip == {"rule": "scene-invalid", "message": "unknown key 'mas' in a body", "hint": "did you mean 'mass'?",
                    "file": "sets/slip, 100 %: a.yaml", "line": 1, "column": 14, "width": 3}
    gone, = found["gone.yaml"]
    assert gone["line"] is gone["column"] is gone["width"] is None and "leads nowhere" in gone["hint"]
    loose, = found["loose.yaml"]
    assert loose["rule"] == "cannot-be-solved" and "has inertia" in loose["message"]
    uncertain, = found["uncertain.yaml"]
    assert uncertain["rule"] == "answer-uncertain" and uncertain["line"] == 6
    fault, = found["none.yaml"]
    assert fault["rule"] == "own-fault" and "ZeroDivisionError" in fault["message"]
    driven, = found["driven.yaml"]
    assert "none.csv" in driven["message"] and driven["file"] == "sets/driven.yaml"


def test_what_is_told_at_the_end():
    done, failed = (CheckedFile("a", 3 * wrong, wrong) for wrong in (False, True))
    refused = CheckedFile("a", 4, True, [CheckedAnswer({}, rule, (1, 1, 1), "x", "", False)
                                         for rule in ("answer-differs", "cannot-be-solved")])
    assert summary([refused]) == "0 answers agree, 1 differs, 1 cannot be found in 1 file"
    for files, said in (([failed], "1 file, which could not be checked"), ([done], "1 file"),
                        ([done, failed, failed], "3 files, 2 of which could not be checked"),
                        ([failed, failed], "2 files, none of which could be checked")):
        assert summary(files) == f"0 answers agree in {said}"


@pytest.mark.parametrize("refusal", [NoBound, LostDigits, NotInLetters, Unknown, PhysicsError])
def test_an_answer_that_is_not_known_is_not_told_to_be_none(refusal, folder, capsys, monkeypatch):
    def refused(problem, answer):
        raise refusal("nothing bounds it")

    monkeypatch.setattr(verdicts, "compared", refused)
    assert run(["check", "sets/differs.yaml", "--no-cache"]) == 4
    said = "no such answer" if refusal is PhysicsError else "not known"
    shown = capsys.readouterr().out
    assert f"({said}: nothing bounds it)" in shown
    assert shown.endswith("0 answers agree, 1 cannot be found in 1 file\n")


def test_places_are_those_of_the_answers(folder, capsys):
    _, text = told("github", capsys)
    place = next(one for _, one, _ in annotations(text) if one["file"] == "sets/differs.yaml")
    assert (place["line"], place["col"], place["endColumn"]) == ("5", "13", "20")
    assert SCENES["differs.yaml"].split("\n")[4][12:19] == "2 rad/s"


def test_junit_counts_failures_and_errors(folder, capsys):
    _, text = told("junit", capsys)
    suites = {suite.name.removeprefix("sets/"): suite for suite in junitparser.JUnitXml.fromstring(text.encode())}
    assert set(suites) == set(SCENES)
    counts = {name: (suite.tests, suite.failures, suite.errors) for name, suite in suites.items()}
    assert counts == {"agrees.yaml": (1, 0, 0), "differs.yaml": (1, 1, 0), "uncertain.yaml": (2, 0, 1),
                      "slip, 100 %: a.yaml": (1, 0, 1), "loose.yaml": (1, 0, 1), "none.yaml": (0, 0, 0)}


def test_sarif_has_what_code_scanning_requires(folder, capsys):
    _, text = told("sarif", capsys)
    log = json.loads(text)
    found = log["runs"][0]
    rules = [rule["id"] for rule in found["tool"]["driver"]["rules"]]
    assert log["version"] == "2.1.0" and rules == list(RULES)
    for result in found["results"]:
        place = result["locations"][0]["physicalLocation"]
        assert rules[result["ruleIndex"]] == result["ruleId"] and result["level"] == "error"
        assert result["message"]["text"] and place["region"]["startLine"] >= 1
        uri = place["artifactLocation"]["uri"]
        assert (uri.startswith("sets/") and " " not in uri and "%" in uri) or uri.isascii()


def test_sarif_tools_count_the_same(folder, capsys):
    loader = pytest.importorskip("sarif.loader")
    assert run(["check", "sets", "-o", "report.sarif"]) == 3
    shown = capsys.readouterr().out
    assert "differs.yaml" in shown                                  # in full as well
    assert "1 differs, 1 is uncertain, 1 cannot be found" in shown
    report = loader.load_sarif_file("report.sarif").get_report()
    assert sum(map(report.get_issue_count_for_severity, report.get_severities())) == 4


def test_a_report_is_written_whole_whatever_the_exit_code(folder, capsys):
    assert run(["check", "sets", "-o", "report.xml"]) == 3
    assert len(list(junitparser.JUnitXml.fromfile("report.xml"))) == len(SCENES)
    assert run(["check", "sets", "-o", "report.xml"]) == 2
    assert "exists already" in capsys.readouterr().err
    assert run(["check", "sets/agrees.yaml", "-o", "report.xml", "--force"]) == 0
    assert len(list(junitparser.JUnitXml.fromfile("report.xml"))) == 1
    for more, said in ((["-o", "report.docx"], "'.docx'"), (["--json", "--format", "sarif"], "choose one"),
                       (["--format", "concise", "-o", "x.json"], "on the screen"), (["--format", "xml"], "'junit'"),
                       (["--max-failures", "0"], "0"), (["--stdin-name", "a.yaml"], "'-'"),
                       (["--jobs", "0"], "0")):
        assert run(["check", "sets", *more]) == 2
        assert said in capsys.readouterr().err, more


def test_files_are_named_from_the_top_of_the_repository(folder, capsys, monkeypatch):
    """A job may run in a folder below, as by `working-directory`: annotations of a change know names from its top."""
    elsewhere = folder / "elsewhere.yaml"
    elsewhere.write_text(SCENES["differs.yaml"])
    course = folder / "course"
    course.mkdir()
    (course / "sets").mkdir()
    (course / "sets" / "differs.yaml").write_text(SCENES["differs.yaml"])
    (course / "linked").symlink_to("sets")
    monkeypatch.chdir(course / "sets")
    for top, name in ((None, "differs.yaml"), (course, "sets/differs.yaml"), (course / "sets", "differs.yaml")):
        if top is not None:
            subprocess.run(["git", "init", "-q", str(top)], check=True)
        for file in ("differs.yaml", str(course / "linked" / "differs.yaml"), "../sets/differs.yaml"):
            assert run(["check", file, "--format", "github"]) == 1
            (_, places, _), = annotations(capsys.readouterr().out)
            assert places["file"] == name, (top, file)
    assert run(["check", "../../elsewhere.yaml", "--format", "github"]) == 1
    (_, places, _), = annotations(capsys.readouterr().out)
    assert places["file"] == str(elsewhere)
    run(["check", "../../elsewhere.yaml", "differs.yaml", "--format", "sarif"])
    places = [one["locations"][0]["physicalLocation"]["artifactLocation"]
              for one in json.loads(capsys.readouterr().out)["runs"][0]["results"]]
    assert places == [{"uri": elsewhere.as_uri()}, {"uri": "differs.yaml", "uriBaseId": "%SRCROOT%"}]


def test_a_name_that_is_not_utf_8_is_told_in_each_form(folder, capsys):
    """SARIF holds it as the bytes that it has, the others with a stand-in or escaped, on the screen as in files."""
    name = b"sets/gr\xfcn.yaml".decode("utf-8", "surrogateescape")
    Path(name).write_text(SCENES["differs.yaml"])
    for form, suffix in (("json", "json"), ("junit", "xml"), ("github", "txt"), ("sarif", "sarif")):
        assert run(["check", name, "--format", form]) == 1
        shown = capsys.readouterr().out
        assert run(["check", name, "--format", form, "-o", f"report.{suffix}"]) == 1
        assert Path(f"report.{suffix}").read_bytes() == shown.encode("utf-8", "replace")
        capsys.readouterr()
    result, = json.loads(Path("report.sarif").read_bytes())["runs"][0]["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "sets/gr%FCn.yaml"


def test_under_github_actions_annotations_come_by_themselves(folder, capsys, monkeypatch):
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    run(["check", "sets/differs.yaml"])
    out = capsys.readouterr().out
    assert "✗ omega[1]" in out and "::error file=sets/differs.yaml,line=5," in out
    assert run(["check", "sets/differs.yaml", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)


def test_it_stops_at_so_many_failures(folder, capsys):
    for jobs in ("1", "2"):
        assert run(["check", "sets", "--max-failures", "1", "--jobs", jobs]) == 1
        assert capsys.readouterr().out.splitlines()[-1] == (
            "1 answer agrees, 1 differs in 2 files; 4 more left, as so many fail")


def test_a_scene_from_stdin(folder, capsys, monkeypatch):
    for text, name, code, said in ((SCENES["differs.yaml"], "x/y.yaml", 1, "x/y.yaml\n  ✗ omega[1]"),
                                   (SCENES["slip, 100 %: a.yaml"], None, 3, "stdin:1:14: error")):
        monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(text.encode()), isatty=lambda: False))
        assert run(["check", "-", *(["--stdin-name", name] if name else [])]) == code
        assert said in "".join(capsys.readouterr())


def test_what_stdin_does_not_give(folder, capsys, monkeypatch):
    long = SimpleNamespace(buffer=io.BytesIO(b"#" * 3 * 2**20))

    class Broken:
        def read(self, size):
            raise OSError(5, "Input/output error")

    for stdin, code, said in ((None, 2, "stdin cannot be read: it is closed"),
                              (SimpleNamespace(buffer=Broken()), 2, "stdin cannot be read: Input/output error"),
                              (long, 3, "the file holds more than 1048576 bytes")):
        monkeypatch.setattr(sys, "stdin", stdin)
        assert run(["check", "-"]) == code
        assert said in capsys.readouterr().err


def test_only_what_has_changed(folder, capsys):
    def git(*args):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *args], check=True, capture_output=True)

    (folder / "sets" / "quake.csv").write_text("0,0\n1,1\n")
    (folder / "sets" / "shaken.yaml").write_text(SCENES["agrees.yaml"] + "# quake.csv\n")
    assert run(["check", "sets", "--changed-since", "HEAD"]) == 2
    assert "git says: fatal" in capsys.readouterr().err
    git("init", "-q")
    git("add", ".")
    git("commit", "-qm", "all")
    assert run(["check", "sets", "--changed-since", "HEAD"]) == 0
    assert capsys.readouterr().out == "no scene has changed since HEAD\n"
    (folder / "sets" / "agrees.yaml").write_text(SCENES["agrees.yaml"] + "\n")
    (folder / "sets" / "new.yaml").write_text(SCENES["agrees.yaml"])
    (folder / "sets" / "quake.csv").write_text("0,0\n1,2\n")
    run(["check", "sets", "--changed-since", "HEAD", "--json"])
    files = [one["file"] for one in json.loads(capsys.readouterr().out)]
    assert files == ["sets/agrees.yaml", "sets/new.yaml", "sets/shaken.yaml"]
    for revision, said in (("nowhere", "git says"), ("--output=x", "expected a revision")):
        assert run(["check", "sets", "--changed-since", revision]) == 2
        assert said in capsys.readouterr().err
    assert not (folder / "x").exists()


def test_the_rules_are_explained_and_the_workflows_run(folder, capsys, monkeypatch):
    for rule in RULES:
        assert run(["explain", rule]) == 0
        assert RULES[rule][:30] in " ".join(capsys.readouterr().out.split())
    from vibcli.manual.ci import GITHUB, GITLAB

    steps, job = yaml.safe_load(GITHUB)["jobs"]["check"]["steps"], yaml.safe_load(GITLAB)["problems"]
    commands = [step["run"] for step in steps if "run" in step] + job["script"]
    kept = [step["with"]["path"] for step in steps if "with" in step and "path" in step["with"]] + job["cache"]["paths"]
    assert kept == [str(folder_of(["problems"]))] * 2
    ours = [command.split()[1:] for command in commands if command.startswith("vibcli ")]
    assert len(ours) == 2
    for number, args in enumerate(ours):
        monkeypatch.chdir(folder / "sets")
        (folder / "sets" / "problems").mkdir(exist_ok=True)
        (folder / "sets" / "problems" / f"{number}.yaml").write_text(SCENES["agrees.yaml"])
        assert run(args) == 0, args


def test_the_hook_is_one(tmp_path):
    clientlib = pytest.importorskip("pre_commit.clientlib")
    hook, = clientlib.load_manifest(str(ROOT / ".pre-commit-hooks.yaml"))
    assert hook["entry"].split()[:2] == ["vibcli", "check"]
    names = "a.yml", "a/b.yaml", "a/b.yaml.txt", ".pre-commit-config.yaml", "a/.b/c.yaml", "a/set.yaml", "a/reset.yaml"
    taken = [name for name in names if re.search(hook["files"], name) and not re.search(hook["exclude"], name)]
    assert taken == ["a.yml", "a/b.yaml", "a/reset.yaml"]


def test_what_sets_up_other_programs_is_no_scene(folder, capsys):
    (folder / ".github").mkdir()
    for name in (".github/ci.yml", ".pre-commit-config.yaml", "sets/.b.yaml"):
        (folder / name).write_text("repos: []\n")
    run(["check", ".", "--json"])
    assert {one["file"] for one in json.loads(capsys.readouterr().out)} == {f"./sets/{name}" for name in SCENES}
    assert run(["check", "sets/.b.yaml"]) == 3          # named, it is read
