"""Ratios beside older ones: what has grown beyond its spread, in two runs."""

import json

import pytest

from vibcli.evidence import against
from vibcli.evidence.against import Beside, RatioRow, beside, document, older, worse_in_both


@pytest.mark.parametrize(("before", "now", "spread", "worse"), [
    (2.0, 2.5, 0.01, False), (2.0, 2.7, 0.01, True), (2.0, 2.7, 0.2, False), (2.0, 4.0, 0.2, True),
    (2.0, 1.0, 0.0, False)])
def test_a_row_is_worse_beyond_thirty_percent_and_three_spreads(before, now, spread, worse):
    assert RatioRow("a", before, now, spread).worse == worse


def test_in_two_runs_out_of_two():
    bad, good = RatioRow("a", 1.0, 2.0, 0.0), RatioRow("a", 1.0, 1.1, 0.0)
    assert worse_in_both(Beside([bad], [], ""), Beside([bad], [], "")) == ["a"]
    assert worse_in_both(Beside([bad], [], ""), Beside([good], [], "")) == []
    assert worse_in_both(Beside([good], [], ""), Beside([bad], [], "")) == []


def point(method, seconds, runs=7, error=1e-9):
    return {"method": method, "with": None, "seconds": seconds, "quartiles": [seconds * 0.9, seconds * 1.1],
            "runs": runs, "error": error}


def test_points_of_one_run_and_refused_ones_are_left_out():
    data = {"compared": [{"asked": "omega", "points": [point("vibcli", 2.0), point("eigh", 1.0), point("slow", 9.0, 1),
                                                        point("no", 1.0, 7, None)]}]}
    found = beside(data, data)
    assert [(row.name, row.before) for row in found.rows] == [("omega: eigh", 2.0)]
    assert found.rows[0].spread == pytest.approx(0.2) and found.alone == []


def of_modes(*points):
    return {"compared": [{"asked": "omega", "points": list(points)}]}


def test_of_a_time_of_zero_there_is_no_ratio():
    full = of_modes(point("vibcli", 2.0), point("eigh", 1.0), point("eig", 0.5))
    for some, alone in ((of_modes(point("vibcli", 2.0), point("eigh", 0.0), point("eig", 0.5)), ["omega: eigh"]),
                        (of_modes(point("vibcli", 0.0), point("eigh", 1.0), point("eig", 0.5)),
                         ["omega: eig", "omega: eigh"])):
        for found in beside(some, full), beside(full, some):
            assert found.alone == alone and len(found.rows) == 2 - len(alone)
    assert "Nothing is on both sides" in str(document(beside(some, full), []))


@pytest.mark.parametrize(("text", "said"), [
    ("", "no JSON"), ("[" * 100_000, "no JSON"), ("1" * 5000, "no JSON"), ("[1]", "no comparison"),
    (json.dumps(of_modes(point("vibcli", 1.0), {**point("eigh", 1.0), "seconds": 10**400})), "no comparison"),
    (json.dumps(of_modes(point("vibcli", 1.0), point("eigh", float("nan")))), "no comparison"),
    (json.dumps(of_modes(point("vibcli", 1.0), point("eigh", -1.0))), "no comparison"),
    (json.dumps(of_modes(point("vibcli", 1.0), {**point("eigh", 1.0), "quartiles": [1]})), "no comparison")])
def test_what_is_no_older_comparison(tmp_path, text, said):
    path = tmp_path / "old.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=said):
        older(str(path))


def test_an_older_comparison_of_other_size_is_not_read(tmp_path, monkeypatch):
    path = tmp_path / "old.json"
    data = of_modes(point("vibcli", 2.0), point("eigh", 1.0))
    path.write_text(json.dumps(data), encoding="utf-8")
    assert older(str(path)) == data
    monkeypatch.setattr(against, "LARGEST", 100)
    with pytest.raises(ValueError, match="longer than 100 bytes"):
        older(str(path))
