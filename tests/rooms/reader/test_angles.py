"""Numbers without a unit beyond a full turn where an angle is due are told at their place; nothing else is."""

import json
from pathlib import Path

import pytest

from vibcli.cli.program import run
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec

ROOT = Path(__file__).parents[3]
SHIPPED = [path for path in sorted((ROOT / "problems").glob("*/*.yaml")) if "cos(" in path.read_text()][::6]

SCENE = """\
parameters:
  a: {a}
  b: {b}
coordinates: [x]
bodies:
  p: {{mass: 2 kg, at: [0, 0], move: [x*cos({arg}), x*sin({arg})]}}
  r: {{shape: rod, mass: 3 kg, from: [1 m, 0], to: [1 m, -1 m], pin: {{at: [1 m, 0], by: phi}}}}
springs:
  s: {{k: 500 N/m, stretch: x + 1 mm*tan(b)}}
  u: {{torsion: 2 N*m, stretch: phi}}
gravity: 9.81 m/s^2
initial: {{x: 1 cm, phi: {phi}}}
answers: {{"omega[1]": 4.088 rad/s}}
"""
PLAIN = {"a": "30 deg", "b": "0.5", "arg": "a", "phi": "10 deg"}


def remarks(**changed):
    """[(line, what is told)] of a scene."""
    text = SCENE.format(**{**PLAIN, **changed})
    node, diagnostics = read(text.encode(), "scene.yaml")
    return [(one.where.line, one.message.partition(" has")[0]) for one in
            read_spec(node, "scene.yaml", diagnostics).remarks]


@pytest.mark.parametrize("changed, expected", [
    ({"a": "30"}, [(2, "a = 30")]),
    ({"a": "-30"}, [(2, "a = 30")]),
    ({"b": "90 - a", "a": "30"}, [(2, "a = 30"), (3, "90")]),
    ({"arg": "a/2", "a": "7"}, [(2, "a = 7")]),
    ({"arg": "2*(a + 45)"}, [(6, "45"), (6, "45")]),
    ({"phi": "10"}, [(12, "10")]),
])
def test_degrees_without_a_unit_are_told(changed, expected):
    assert remarks(**changed) == expected


@pytest.mark.parametrize("changed", [
    {}, {"a": "30 rad"}, {"a": "0.5"}, {"a": "6.28"}, {"arg": "pi*a/180", "a": "30"}, {"arg": "a/57.3", "a": "30"},
    {"arg": "12*a", "a": "0.5"}, {"b": "pi*45/180"}, {"phi": "2*pi"}, {"phi": "1000 deg"},
])
def test_what_is_an_angle_or_made_one_is_not(changed):
    assert remarks(**changed) == []


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_problems_are_not_told_of(path):
    node, diagnostics = read(path.read_bytes(), str(path))
    assert not read_spec(node, str(path), diagnostics).remarks


def test_a_warning_is_told_once_with_its_caret_and_fails_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = SCENE.format(**{**PLAIN, "a": "30"})
    Path("scene.yaml").write_text(text + "cases: {heavy: {bodies: {p: {mass: 3 kg}}}}\n")
    assert run(["frequencies", "scene.yaml"]) == 0
    told = capsys.readouterr().err
    assert told.splitlines() == [
        "scene.yaml:2:6: warning: a = 30 has no unit and is taken in radians: 1719°", "    a: 30", "       ^^",
        "hint: write 30 deg, or 30 rad"]
    assert run(["check", "scene.yaml", "--no-cache"]) == 0
    assert capsys.readouterr().err == told
    assert run(["check", "scene.yaml", "--format", "concise"]) == 0         # kept in the cache, it is told again
    assert capsys.readouterr().out.startswith("scene.yaml:2:6: taken-in-radians: a = 30 has")
    assert run(["check", "scene.yaml", "--format", "github"]) == 0
    assert capsys.readouterr().out.startswith("::warning file=scene.yaml,line=2,col=6,endColumn=8,title=taken-in-rad")
    assert run(["check", "scene.yaml", "--format", "sarif"]) == 0
    (result,) = json.loads(capsys.readouterr().out)["runs"][0]["results"]
    assert (result["ruleId"], result["level"]) == ("taken-in-radians", "warning")
    assert run(["check", "scene.yaml", "--format", "junit"]) == 0
    assert 'failures="0" errors="0"' in capsys.readouterr().out
