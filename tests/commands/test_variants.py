"""`vibcli variants`: counts, tables, data, exit codes; nothing of it is imported where it is not asked."""

import json

import pytest
from support.homework_scenes import BY_STRETCH as SCENE

from vibcli.cli.program import run

GRID = """variants:
  parameters: {m: {from: 1 kg, to: 3 kg, step: 0.5 kg}, k: [600 N/m, 800 N/m]}
  require: ["omega[1] < 24 rad/s"]
"""


@pytest.fixture
def call(tmp_path, capsys):
    def called(text, *options):
        path = tmp_path / "block.yaml"
        path.write_text(text, encoding="utf-8")
        code = run(["variants", str(path), *options])
        return code, *capsys.readouterr()

    return called


@pytest.mark.sweep
def test_counts_and_tables(call):
    code, out, _ = call(SCENE + GRID, "--table", "--rejected")
    assert code == 0
    assert "10 candidates, 8 accepted." in out
    row = next(line.split() for line in out.splitlines() if line.split()[:1] == ["4"])
    assert row == ["4", "2", "kg", "800", "N/m", "19.9"]
    assert out.count("not omega[1] < 24 rad/s") == 2


def test_data(call):
    code, out, _ = call(SCENE + GRID, "--json")
    found = json.loads(out)["variants"]
    assert code == 0 and found["candidates"] == 10 and len(found["accepted"]) == 8
    assert {one["gate"]: one["rejected"] for one in found["counts"]}["require"] == 2
    first = found["accepted"][0]
    assert first["given"] == [{"name": "m", "value": "1.5 kg"}, {"name": "k", "value": "600 N/m"}]
    assert first["keys"][0]["value"] == pytest.approx((400 - (8 / 3)**2)**0.5, rel=1e-14)


@pytest.mark.sweep
def test_exit_codes(call):
    assert call(SCENE + GRID, "--at-least", "8")[0] == 0
    assert call(SCENE + GRID, "--at-least", "9")[0] == 1
    code, _, err = call(SCENE + GRID.replace("from: 1 kg", "from: 1 mg").replace("step: 0.5 kg", "step: 2999999 mg"))
    assert code == 0, err
    code, _, err = call(SCENE.replace("2 kg", "20 kg") + GRID.replace("< 24", "< 10"))
    assert code == 4
    assert "no variant is left" in err and "'require' took 10 of 10" in err and "larger values of m come nearer" in err
    code, _, err = call(SCENE)
    assert code == 3 and "this scene says nothing of variants" in err
    code, _, err = call(SCENE + "cases: {soft: {answers: {'omega[1]': 20.0 rad/s}, variants: {parameters: {m: [1 kg, "
                                "2 kg]}}}}\n")
    assert code == 3 and "--case soft" in err


def test_set_replaces_what_is_not_varied(call):
    _, out, _ = call(SCENE + GRID, "--set", "c=4", "--json")
    first = json.loads(out)["variants"]["accepted"][0]
    assert first["keys"][0]["value"] == pytest.approx((400 - (4 / 3)**2)**0.5, rel=1e-14)


@pytest.mark.sweep
def test_reports_of_other_formats(call):
    for kind in ("markdown", "latex", "html", "asciidoc"):
        code, out, _ = call(SCENE + GRID, "--format", kind, "--table")
        assert code == 0 and "omega" in out
