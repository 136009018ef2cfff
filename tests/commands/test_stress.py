"""`vibcli stress`: what is told of families, what is drawn, exit codes."""

import json
from functools import cache

import pytest

from vibcli.cli.program import run
from vibcli.evidence.stress import claims, sweep

kept = cache(sweep.measured)      # points that several runs tell


@pytest.fixture
def measured_once(monkeypatch):
    monkeypatch.setattr(sweep, "measured", kept)


@pytest.mark.sweep
@pytest.mark.usefixtures("measured_once")
def test_a_family_is_a_table_and_a_sentence(capsys):
    assert run(["stress", "--family", "mass_ratio"]) == 0
    out = capsys.readouterr().out
    assert "ratio of the masses  condition  true error  bound stated  plain error  verdict" in out
    assert "plain: scipy eigh" in out and "11 points of 1 family: 11 held; 0 bounds idle" in out


@pytest.mark.sweep
@pytest.mark.usefixtures("measured_once")
def test_as_data_what_is_not_finite_is_null(capsys):
    assert run(["stress", "--family", "double_eigenvalue", "--family", "mass_ratio", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["name"] for one in found["families"]] == ["double_eigenvalue", "mass_ratio"]
    assert found["counts"]["held"] == 28 and found["families"][1]["points"][-1]["knob"] == "1e20"


@pytest.mark.sweep
@pytest.mark.usefixtures("measured_once")
def test_pictures_stand_in_their_folder_and_are_not_replaced(tmp_path, capsys):
    folder = tmp_path / "new" / "pictures"
    assert run(["stress", "--family", "mass_ratio", "-o", str(folder)]) == 0
    assert (folder / "mass_ratio.svg").read_bytes().startswith(b"<?xml")
    assert run(["stress", "--family", "mass_ratio", "-o", str(folder)]) == 2
    assert run(["stress", "--family", "mass_ratio", "-o", str(folder / "mass_ratio.svg")]) == 2
    assert run(["stress", "--family", "mass_ratio", "-o", str(folder), "--force"]) == 0
    assert "is no folder" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "hint"), [("mass_ratios", "did you mean 'mass_ratio'?"),
                                            ("xyz", "valid here: buckling")])
def test_a_family_that_there_is_not(capsys, name, hint):
    assert run(["stress", "--family", name]) == 2
    err = capsys.readouterr().err
    assert f"there is no family '{name}'" in err and hint in err


@pytest.mark.sweep
def test_what_is_broken_ends_with_1(monkeypatch, capsys):
    plain = claims.measure
    monkeypatch.setattr(claims, "measure", lambda *args: (plain(*args)[0], 1e-20))
    assert run(["stress", "--family", "long_times"]) == 1
    assert "broken" in capsys.readouterr().out


SCENE = """parameters: {m: 2.00 kg, k: %s}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
answers: {"omega[1]": 20 rad/s}
cases: {stiff: {parameters: {k: 801 N/m}, answers: {"omega[1]": 10 rad/s}}}
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "one.yaml"
    path.write_text(SCENE % "800 N/m", encoding="utf-8")
    return str(path)


def test_a_scene_is_shaken_and_its_digits_are_told(scene, capsys):
    assert run(["stress", scene]) == 0
    out = capsys.readouterr().out
    assert "springs as two in series              1         equal" in out and "omega[1]  20     2.8     m" in out
    assert run(["stress", scene, "--case", "stiff", "--set", "m=8 kg", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["verdict"] for one in found["shaken"]] == ["equal"] * 22
    assert [one["parameter"] for one in found["supported"]] == ["k"]


def test_what_has_no_number_is_told_with_its_reason_and_is_no_row(tmp_path, capsys):
    path = tmp_path / "still.yaml"
    path.write_text(SCENE.replace("answers: {", "answers: {\"period(x)\": 1 s, ", 1) % "800 N/m", encoding="utf-8")
    assert run(["stress", str(path)]) == 0
    out = capsys.readouterr().out
    assert "\n  period(x): " in out and "omega[1]  20     2.8     m" in out


def test_what_does_not_go_together(scene):
    assert run(["stress", scene, "--family", "mass_ratio"]) == 2
    assert run(["stress", "--set", "m=1 kg"]) == 2


def test_letters_without_value_are_given_the_same_ones_at_every_run_which_are_no_data(tmp_path, capsys):
    letters = tmp_path / "letters.yaml"
    letters.write_text(SCENE.partition("cases")[0] % "", encoding="utf-8")
    assert run(["stress", str(letters), "--json"]) == 0
    first = capsys.readouterr().out
    found = json.loads(first)
    assert list(found["drawn"]) == ["k"] and {one["verdict"] for one in found["shaken"]} == {"equal", "refused"}
    assert [one["parameter"] for one in found["supported"]] == ["m"]
    assert run(["stress", str(letters), "--json"]) == 0 and capsys.readouterr().out == first
    assert run(["stress", str(letters)]) == 0
    assert "k = " + found["drawn"]["k"] + ": drawn for letters that have none" in capsys.readouterr().out
