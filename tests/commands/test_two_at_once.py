"""Two processes that write one output at once: it is one's, whole, and the other is told."""

import os
import subprocess
import sys

import pytest

SCENE = """
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
answers: {"omega[1]": 2 rad/s}
"""
WRITING = {"bench": (["bench", "scene.yaml", "--quick", "-o", "out.md"], "out.md", "# "),
           "stress": (["stress", "--family", "detuning", "-o", "out"], "out/detuning.svg", "</svg>")}


def both(arguments, folder):
    """[(exit code, what is told as errors)] of two processes."""
    started = [subprocess.Popen([sys.executable, "-m", "vibcli", *arguments], cwd=folder, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True) for _ in "ab"]
    return sorted((process.returncode, told) for process in started for told in [process.communicate(timeout=300)[1]])


@pytest.mark.sweep
@pytest.mark.parametrize("way", WRITING)
def test_the_file_is_whole_and_one_is_told(way, tmp_path):
    (tmp_path / "scene.yaml").write_text(SCENE)
    arguments, written, whole = WRITING[way]
    (first, _), (last, told) = both(arguments, tmp_path)
    assert (first, last) == (0, 2) and "exists already and is left as it is" in told
    assert whole in (tmp_path / written).read_text()
    found = {name for _, _, names in os.walk(tmp_path) for name in names}
    assert found <= {"scene.yaml", os.path.basename(written), "out-1-curve-1.svg"}


@pytest.mark.sweep
@pytest.mark.parametrize("way", WRITING)
def test_of_two_writers_one_is_refused(way, tmp_path, monkeypatch, capsys):
    """Another one writes the file between the look at it and the end of the work."""
    from importlib import import_module

    from vibcli.cli.program import run

    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.yaml").write_text(SCENE)
    arguments, written, _ = WRITING[way]
    command = import_module(f"vibcli.cli.{way}")
    looked = command.refuse

    def refuse(path, *rest):
        looked(path, *rest)
        path.write_text("another's")

    monkeypatch.setattr(command, "refuse", refuse)
    assert run(arguments) == 2
    assert f"'{written}' exists already and is left as it is" in capsys.readouterr().err
    assert (tmp_path / written).read_text() == "another's"
