"""Hostile and faulty surroundings: names that would steer a terminal, files that vanish, read-only folders, full discs,
no home and no locale."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from vibcli.cli.checking import files
from vibcli.cli.program import run

ROOT = Path(__file__).parents[2]
SCENE = """
title: "ω² = k/m"
parameters: {m: 2 kg, k: 800 N/m}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
answers: {"omega[1]": 21.0 rad/s}
"""
LIVE = "\x1b]0;a\x07", "\x1b[35m", "\x9b35m", "\u202e"      # a title, a colour in two ways, text the other way round
CALLS = {
    "no such file": ["solve", "no{}.yaml"], "a file": ["solve", "{}.yaml"],
    "no case": ["solve", "scene.yaml", "--case", "{}"],
    "in full": ["check", "{}.yaml", "--no-cache"], "in short": ["check", "{}.yaml", "--format", "concise"],
    "annotations": ["check", "{}.yaml", "--format", "github"], "no parameter": ["solve", "scene.yaml", "--set", "{}=3"],
    "no command": ["{}"], "no option": ["solve", "--{}"], "no form": ["solve", "scene.yaml", "--format", "{}"],
    "no page": ["explain", "{}"], "no template": ["new", "{}"], "no signal": ["frf", "scene.yaml", "--of", "{}"],
    "no folder": ["draw", "scene.yaml", "-o", "{}/a.svg"], "written": ["solve", "scene.yaml", "-o", "{}.md"],
    "new": ["new", "-o", "{}.yaml"], "no family": ["stress", "--family", "{}"], "no instant": ["response", "scene.yaml",
                                                                                             "--at", "{}"],
    "no revision": ["check", "scene.yaml", "--changed-since", "{}"], "no manifest": ["grade", "{}.json"],
    "no roster": ["homework", "scene.yaml", "-o", "sheets", "--students", "{}.csv", "--salt-file", "scene.yaml"],
    "no cache": ["check", "scene.yaml", "--cache-dir", "scene.yaml/{}"],
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("scene.yaml").write_text(SCENE)
    return tmp_path


@pytest.mark.parametrize("call", CALLS)
def test_names_steer_no_terminal(call, folder, capsys, monkeypatch):
    """As on a terminal, where nothing is stripped of what is printed."""
    monkeypatch.setattr("click.utils.should_strip_ansi", lambda *args: False)
    monkeypatch.setenv("VIBCLI_NO_CACHE", "")
    for live in LIVE:
        if call in ("a file", "in full", "in short", "annotations"):
            Path(f"{live}.yaml").write_text(SCENE)
        code = run([part.format(live) for part in CALLS[call]])
        shown = "".join(capsys.readouterr())
        assert shown and live not in shown
        assert code in ((0, 1) if call in ("a file", "written", "new", "in full", "in short", "annotations", "no cache")
                        else (2, 3, 4))


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_file_that_vanishes_is_told_and_the_others_are_checked(jobs, folder, capfd, monkeypatch):
    for name in "ac":
        Path(f"{name}.yaml").write_text(SCENE.replace("21.0", "20.0"))
    Path("b.yaml").symlink_to("nowhere.yaml")
    Path("scene.yaml").unlink()
    below = files.scenes_below
    monkeypatch.setattr("vibcli.cli.check.scenes_below", lambda path: [*below(path), os.path.join(path, "gone.yaml")])
    assert run(["check", ".", "--jobs", jobs]) == 3
    out, err = capfd.readouterr()
    assert "2 answers agree in 4 files, 2 of which could not be checked" in out
    assert err.count("there is no file of this name") == 2
    assert "leads nowhere" in err and "it was there when the folder was read" in err
    assert run(["solve", "b.yaml"]) == 2
    assert "'b.yaml' is a link that leads to no file" in capfd.readouterr().err


def test_a_folder_that_may_not_be_written_to(folder, capsys, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, how: not how & os.W_OK)
    for args in (["solve", "scene.yaml", "-o", "a.md"], ["draw", "scene.yaml"], ["response", "scene.yaml", "--save",
                 "a.csv"], ["check", "scene.yaml", "-o", "a.xml"], ["bench", "scene.yaml", "-o", "a.svg"],
                 ["new", "-o", "a.yaml"], ["homework", "scene.yaml", "-o", "out", "--paper", "1"]):
        code = run(args)
        assert "may not be written to" in capsys.readouterr().err and code == 2
    assert os.listdir() == ["scene.yaml"]


class Full:
    """A file on a disc that has no room."""

    def __init__(self, descriptor, *args):
        self.descriptor = descriptor

    def __enter__(self):
        return self

    def __exit__(self, *args):
        os.close(self.descriptor)

    def write(self, data):
        raise OSError(28, "No space left on device")


@pytest.mark.sweep
def test_a_full_disc_leaves_nothing_behind(folder, capsys, monkeypatch):
    monkeypatch.setattr("vibcli.base.output_files.os.fdopen", Full)
    for args in (["solve", "scene.yaml", "-o", "a.md"], ["draw", "scene.yaml"], ["response", "scene.yaml", "--save",
                 "a.csv"], ["check", "scene.yaml", "-o", "a.xml"], ["new", "-o", "a.yaml"],
                 ["stress", "--family", "detuning", "-o", "pictures"]):
        assert run(args) == 4
        assert "cannot be written: No space left on device" in capsys.readouterr().err
    assert sorted(os.listdir()) == ["pictures", "scene.yaml"] and not os.listdir("pictures")


SURROUNDINGS = {"nothing": {}, "no locale": {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
                "ascii": {"PYTHONIOENCODING": "ascii"}, "no home": {"HOME": "/nonexistent", "TMPDIR": "/nonexistent"}}


def written(folder, env):
    """What `solve` writes of the scene in a process that has no more of an environment than this."""
    Path(folder, "scene.yaml").write_text(SCENE)
    args = ["solve", "scene.yaml", "-o", "page.html", "--pictures", "--force"]
    done = subprocess.run([sys.executable, "-m", "vibcli", *args], capture_output=True, cwd=folder,
                          env={"PYTHONPATH": str(ROOT), "PATH": "/nonexistent"} | env)
    assert done.returncode == 0 and done.stderr == b"wrote page.html\n"
    return Path(folder, "page.html").read_bytes()


@pytest.fixture(scope="module")
def usual(tmp_path_factory):
    """The same where there is a home, and a locale that knows all letters."""
    folder = tmp_path_factory.mktemp("usual")
    return written(folder, {"LC_ALL": "C.UTF-8", "HOME": str(folder)})


@pytest.mark.sweep
@pytest.mark.parametrize("how", SURROUNDINGS)
def test_what_is_written_hangs_on_no_locale_and_no_home(how, usual, tmp_path):
    assert written(tmp_path, SURROUNDINGS[how]) == usual


def test_a_folder_that_is_gone_while_the_command_runs_in_it(tmp_path, capsys, monkeypatch):
    scene = tmp_path / "scene.yaml"
    scene.write_text(SCENE + "variants: {parameters: {m: [1 kg, 2 kg]}}\n")
    salt = tmp_path / "salt"
    salt.write_text("a secret text that is long enough")
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    for form in ("github", "sarif", "junit"):
        assert run(["check", str(scene), "--format", form, "--no-cache"]) == 1
    assert run(["homework", str(scene), "-o", "week", "--paper", "2", "--salt-file", str(salt)]) == 2
    assert "No such file" in capsys.readouterr().err
