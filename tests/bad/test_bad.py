"""Wrong scenes: each file of this folder says in its first comments what vibcli must say about it, word for word."""

import subprocess
import sys
from pathlib import Path

import pytest
from support.wrong_scenes import BAD, diagnostics, expected

from vibcli.cli.program import run


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_each_is_explained(path, capsys):
    code, command, wanted = expected(path)
    assert run([command, str(path)]) == code
    out, err = capsys.readouterr()
    found = diagnostics(err, str(path))
    assert [tuple(part[:3]) for part in found] == wanted
    assert "✓" not in out.split("\n")[0]
    assert not ((out if command == "solve" else "") if code == 3 else "Natural frequencies" in out)
    lines = path.read_text(encoding="utf-8").split("\n")
    for place, _, _, shown, caret in found:
        if place != "-":
            line, column = map(int, place.split(":"))
            source = lines[line - 1]
            assert caret is not None
            assert shown.strip("…") in source or "\\" in shown
            if column <= len(source) and source[column - 1].isprintable():
                assert shown[caret] == source[column - 1]


def test_all_were_swept():
    assert len(BAD) >= 220
    assert sum(len(expected(path)[2]) for path in BAD) >= 650


def test_every_kind_of_file_has_hints():
    """At least three of four diagnostics say what to write instead."""
    hints = [bool(hint) for path in BAD for _, _, hint in expected(path)[2]]
    assert sum(hints) >= 0.75 * len(hints)


ONE_OF_EACH = {expected(path)[:2]: path for path in BAD}        # exit code and command


@pytest.mark.sweep
@pytest.mark.parametrize("path", ONE_OF_EACH.values(), ids=lambda path: path.stem)
def test_a_process_says_the_same(path):
    code, command, wanted = expected(path)
    done = subprocess.run([sys.executable, "-m", "vibcli", command, str(path)], capture_output=True, text=True)
    assert done.returncode == code
    assert [tuple(part[:3]) for part in diagnostics(done.stderr, str(path))] == wanted


WHOLE = {
    "empty": (b"", "the file is empty, expected a scene"),
    "comment": (b"# nothing\n", "the file is empty, expected a scene"),
    "binary": (b"\x7fELF\x00\x01", "found a NUL byte: this is not a text file"),
    "latin": ("title: größe\n".encode("latin-1"), "the byte 0xf6 is not UTF-8 (in Latin-1 it would be 'ö')"),
    "utf16": ("title: x\n".encode("utf-16"), "the file is written in UTF-16, expected UTF-8"),
    "long": (b"# " + b"x" * 2**20, "the file holds 1048578 bytes, expected at most 1048576"),
}


@pytest.mark.parametrize("name", WHOLE)
def test_what_is_no_scene_at_all(name, tmp_path, capsys):
    data, message = WHOLE[name]
    path = tmp_path / f"{name}.yaml"
    path.write_bytes(data)
    for command in ("solve", "check", "equations", "frequencies"):
        assert run([command, str(path)]) == 3
        assert message in capsys.readouterr().err


def test_a_folder_is_no_scene(tmp_path, capsys):
    assert run(["solve", str(tmp_path)]) == 3
    assert "expected a scene file, found a directory" in capsys.readouterr().err


LINE = [("solve", "no_such_file.yaml"), ("check", "no_such_file.yaml"), ("sovle", "x.yaml"), ("solve",),
        ("solve", "-z", "x"), ("solve", "FILE", "--set", "k"), ("solve", "FILE", "--set", "kk=3"),
        ("solve", "FILE", "--set", "k=3 ++"), ("solve", "FILE", "--case", "none"),
        ("frequencies", "FILE", "--digits", "0"), ("frequencies", "FILE", "--normalise", "x")]


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {k: 3 N/m}\nbodies: {a: {mass: 1 kg, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a]}}\n")
    return str(path)


@pytest.mark.parametrize("line", LINE, ids=" ".join)
def test_a_wrong_command_line_leaves_with_2(line, scene, capsys):
    assert run([scene if word == "FILE" else word for word in line]) == 2
    out, err = capsys.readouterr()
    assert "Error" in err or "error" in err
    assert not out


@pytest.mark.parametrize("value", ["-3 kg", "nan", "3 m", "1e400", "sqrt(-1)", "0"])
def test_a_setting_of_no_sense_is_refused(value, scene, capsys):
    Path(scene).write_text("parameters: {m: 3 kg}\nbodies: {a: {mass: m, slide: x}}\n")
    assert run(["frequencies", scene, "--set", f"m={value}"]) in (2, 3, 4)
    assert "error" in capsys.readouterr().err.lower()
