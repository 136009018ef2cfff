"""The README's example happens as printed, and its words are true."""

import re
from pathlib import Path

import pytest

from vibcli.cli import COMMANDS
from vibcli.cli.program import run

README = (Path(__file__).parents[2] / "README.md").read_text()


@pytest.fixture
def scene(tmp_path, monkeypatch):
    """The scene of the README as rod.yaml in the working folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rod.yaml").write_text(re.search(r"```yaml\n(.*?)```", README, re.DOTALL).group(1))


@pytest.mark.parametrize("command, index", [("solve", 0), ("check", 1)])
def test_example(scene, capsys, command, index):
    shown = re.findall(r"```text\n(.*?)```", README, re.DOTALL)[index]
    assert run([command, "rod.yaml"]) == 0
    assert capsys.readouterr().out == shown


def test_settings_shown_work(scene, capsys):
    for setting in ("k=600", "k=0.6 N/mm"):
        assert run(["solve", "rod.yaml", "--set", setting]) == 0
    assert "--set k=600" in README
    assert "--set 'k=0.6 N/mm'" in README


def test_every_command_is_in_the_map():
    missing = [name for name in COMMANDS if f"vibcli {name}" not in README]
    assert not missing


@pytest.mark.sweep
def test_words_shown_are_explained(capsys):
    for word in re.findall(r"`vibcli explain (\w+)`", README):
        assert run(["explain", word]) == 0


def test_make_targets_exist():
    makefile = (Path(__file__).parents[2] / "Makefile").read_text()
    for target in re.findall(r"^make (\w+)", README, re.MULTILINE):
        assert f"\n{target}:" in makefile
