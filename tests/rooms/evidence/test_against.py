"""Ratios beside older ones: what has grown beyond its spread, in two runs."""

import pytest

from vibcli.evidence.against import Beside, RatioRow, beside, worse_in_both


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
