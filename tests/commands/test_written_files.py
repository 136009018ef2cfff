"""Files that commands write: under a name that is one, never over another's, and nothing said but that they are."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from vibcli.base.errors import PhysicsError
from vibcli.base.output_files import refuse_unwritable, write_whole
from vibcli.cli import COMMANDS, new, pictures
from vibcli.cli.program import run
from vibcli.cli.reports import SUFFIXES

SCENE = """
parameters: {k: 4 N/m}
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
forces: {f: {at: a, force: 3 N*cos(1 rad/s*t)}}
answers: {"omega[1]": 2.00 rad/s}
variants: {parameters: {k: [4 N/m, 5 N/m]}, without: [told]}
"""
REPORTS = ("solve", "equations", "frequencies", "response", "frf")
WRITING = {**{f"{command} -o": (command, "-o", "r.md") for command in REPORTS}, "draw": ("draw", "-o", "d.svg"),
           "animate": ("animate", "-o", "a.gif"), "response --save": ("response", "--save", "r.csv"),
           "frf --save": ("frf", "--save", "f.svg"), "frequencies --save": ("frequencies", "--save", "e.png"),
           "variants -o": ("variants", "-o", "r.md"), "sweep -o": ("sweep", "-o", "r.md"),
           "sweep --save": ("sweep", "--save", "k.csv"),
           "json": ("solve", "-o", "s.json"), "new": ("new", "-o", "n.yaml")}


@pytest.fixture(autouse=True)
def scene(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.yaml").write_text(SCENE)
    return tmp_path


def arguments(command, option, name):
    return [command, *([] if command == "new" else ["scene.yaml"]), *["--over", "k=3 .. 5"] * (command == "sweep"),
            option, name]


def test_every_command_that_writes_is_there():
    named = {command for command, *_ in WRITING.values()}
    assert named == set(COMMANDS) - {"check", "explain", "schema", "view", "homework", "grade", "bench", "stress"}


@pytest.mark.parametrize("way", WRITING)
def test_an_empty_name_is_none(way, scene, capsys):
    command, option, _ = WRITING[way]
    before = sorted(scene.iterdir())
    for name in ("", "  "):
        assert run(arguments(command, option, name)) == 2
        assert "this is empty" in capsys.readouterr().err
    assert sorted(scene.iterdir()) == before


@pytest.mark.parametrize("way", WRITING)
def test_of_two_writers_one_is_refused(way, scene, monkeypatch, capsys):
    """Another one writes the file between the look at it and the end of the work."""
    command, option, name = WRITING[way]
    looked = pictures.refuse

    def refuse(path, *rest):
        looked(path, *rest)
        Path(path).write_text("another's")

    monkeypatch.setattr(pictures, "refuse", refuse)
    monkeypatch.setattr("vibcli.cli.sampled.refuse", refuse)
    monkeypatch.setattr(new, "refuse", refuse)
    assert run(arguments(command, option, name)) == 2
    err = capsys.readouterr().err
    assert f"'{name}' exists already and is left as it is" in err and "wrote" not in err
    assert (scene / name).read_text() == "another's"
    assert sorted(os.listdir(scene)) == sorted([name, "scene.yaml"])


@pytest.mark.parametrize(("way", "links"), [*((way, True) for way in WRITING), ("draw", False), ("new", False)])
def test_a_new_file_is_written_and_replaced_only_by_force(way, links, scene, monkeypatch, capsys):
    command, option, name = WRITING[way]
    if not links:
        monkeypatch.setattr("os.link", _without_links)
    assert run(arguments(command, option, name)) == 0
    written = (scene / name).read_bytes()
    assert written and sorted(os.listdir(scene)) == sorted([name, "scene.yaml"])
    assert run(arguments(command, option, name)) == 2
    if command != "new":
        (scene / name).write_text("old")
        assert run([*arguments(command, option, name), "--force"]) == 0
        assert (scene / name).read_bytes() == written


def _without_links(*_):
    raise PermissionError(1, "Operation not permitted")


@pytest.mark.parametrize("command", REPORTS)
def test_a_name_without_suffix_is_told_all_of_them(command, capsys):
    assert run([command, "scene.yaml", "-o", "x"]) == 2
    err = " ".join(capsys.readouterr().err.split())
    assert all(suffix in err for suffixes in SUFFIXES.values() for suffix in suffixes)
    assert run([command, "scene.yaml", "-o", "x", "--format", "markdown"]) == 2
    err = capsys.readouterr().err
    assert ".md" in err and ".tex" not in err


def test_a_record_beside_an_example_is_not_written_without_it(scene, capsys):
    (scene / "n.yaml").write_text("mine")
    assert run(["new", "measured_blow", "-o", "n.yaml"]) == 2
    assert sorted(os.listdir(scene)) == ["n.yaml", "scene.yaml"]


@pytest.mark.parametrize("args", [
    ["nonsense"], ["new", "nonsense"], ["new", "penduluum"], ["solve", "scene.yaml", "--case", "z"],
    ["solve", "scene.yaml", "--set", "z=1"], ["explain", "qqqq"], ["solve", "no.yaml"],
    ["draw", "scene.yaml", "-o", "x"], ["frf", "scene.yaml", "--of", "qqqq"],
    ["response", "scene.yaml", "--until", "qqqq"]])
def test_what_is_not_there_is_refused_by_name(args, capsys):
    assert run(args) in (2, 3, 4)
    out, err = capsys.readouterr()
    assert not out and "None" not in err and "an error of its own" not in err


@pytest.mark.sweep
def test_without_a_home_nothing_is_said_of_caches(scene):
    there = {"HOME": "/dev/null/home", "XDG_CACHE_HOME": "/dev/null/c", "XDG_CONFIG_HOME": "/dev/null/d"}
    kept = {key: value for key, value in os.environ.items() if key != "MPLCONFIGDIR"}
    done = subprocess.run([sys.executable, "-m", "vibcli", "draw", "scene.yaml"], capture_output=True, text=True,
                          env={**kept, **there})
    assert done.returncode == 0 and done.stderr == "wrote scene.png\n"


def test_a_wrong_path_is_refused_in_words(tmp_path):
    folder = tmp_path / "pictures"
    folder.mkdir()
    (folder / "there.png").write_bytes(b"kept")
    (folder / "link.png").symlink_to(folder / "there.png")
    (folder / "folder.png").mkdir()
    for name, words in (("plot.jpg", "'.jpg'"), ("plot", "no suffix"), ("none/plot.png", "no folder"),
                        ("link.png", "is a link"), ("folder.png", "no file"), ("x" * 300 + ".png", "too long"),
                        ("\0.png", "null")):
        with pytest.raises(PhysicsError, match=words) as found:
            refuse_unwritable(folder / name, (".png", ".svg", ".pdf"))
            write_whole(folder / name, b"new")
        assert found.value.hint
    refuse_unwritable(folder / "there.png", (".png",))
    assert (folder / "there.png").read_bytes() == b"kept"
    assert sorted(entry.name for entry in folder.iterdir()) == ["folder.png", "link.png", "there.png"]
