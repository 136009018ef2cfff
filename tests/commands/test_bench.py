"""The benchmark's table: every part has a file, what fails is a row, what is not installed is said."""

import json
from importlib import import_module, reload
from pathlib import Path

import pytest
from click.testing import CliRunner

from vibcli import bench
from vibcli.bench import __main__ as command
from vibcli.bench import capabilities, members_counted, peers, processes, random_members, shipped
from vibcli.bench.processes import answer, costs, python
from vibcli.bench.rows import HEAD, Failure, Timing, aligned, exponent

FOLDER = Path(bench.__file__).parent


def test_every_part_has_its_file():
    measuring = {path.stem for path in FOLDER.glob("*.py") if "def rows(runs" in path.read_text()}
    assert set(bench.PARTS) == measuring - {"lagranges_method"}
    assert all(callable(import_module(f"vibcli.bench.{name}").rows) for name in bench.PARTS)


def test_budgets_bound_ratios_and_bare_numbers():
    """No row bounds a time by itself."""
    assert Timing("a", 3.0, "ms", 1.5, "b", 2.0).kept and not Timing("a", 3.1, "ms", 1.5, "b", 2.0).kept
    assert Timing("error", 1e-16, "", 1e-15, absolute=True).kept
    assert not Timing("error", 1e-14, "", 1e-15, "b", 1e-3, absolute=True).kept
    missing = Timing("a", 3.0, "ms", 0.1, "heyoka, not installed")
    assert missing.kept and missing.ratio is None and missing.cells()[-1] == ""
    with pytest.raises(ValueError, match="bounded by another"):
        Timing("a", 3.0, "ms", 4.0, absolute=True)


def test_the_exponent_of_a_power():
    assert exponent([2, 5, 12, 40], [3 * n**1.7 for n in (2, 5, 12, 40)]) == pytest.approx(1.7)


def test_a_part_that_fails_is_a_row_and_the_rest_is_printed(monkeypatch):
    def rows_of(name):
        def rows(runs):
            yield Timing(f"{name}, {runs} runs", 1.0, "ms", 2.0, "b", 1.0)
            if name.endswith("growth"):
                answer("import sys; raise ValueError('no such thing')")
        return type("Part", (), {"rows": staticmethod(rows)})

    monkeypatch.setattr(command, "import_module", rows_of)
    done = CliRunner().invoke(command.main, ["--quick", "--only", "growth", "--only", "files"])
    lines = done.stdout.splitlines()
    assert done.exit_code == 1 and len(lines) == 4
    assert "growth, 3 runs" in lines[1] and "files, 3 runs" in lines[3]
    assert "growth: RuntimeError: ValueError: no such thing" in lines[2] and lines[2].endswith("failed")
    done = CliRunner().invoke(command.main, ["--json", "--only", "files"])
    assert done.exit_code == 0 and json.loads(done.stdout)[0]["kept"]


def test_a_capability_stands_beside_the_nearest_plain_method_and_one_that_is_not_compared_says_why(monkeypatch):
    ours = {"method": "vibcli", "with": "", "ms": 2.0, "error": 3e-16, "bound": 1e-15}
    plain = {"method": "odeint", "with": "1e-09", "ms": 8.0, "error": 4e-9}
    told = iter([{**ours, "plain": plain}, {**ours, "error": 2e-15, "plain": None}, {"why": "no reference"}])
    monkeypatch.setattr(capabilities, "answer", lambda *_: json.dumps(next(told)))
    (time, error), (alone, broken), (failed,) = (capabilities._rows("cantilever", 3) for _ in range(3))
    assert time.ratio == 0.25 and time.baseline == "odeint 1e-09, error 4.0e-09" and error.kept
    assert alone.ratio is None and not broken.kept
    assert failed.cells()[0].endswith("no reference") and not failed.kept


def test_an_interrupt_keeps_the_parts_that_are_done(monkeypatch):
    def rows_of(name):
        def rows(runs):
            if name.endswith("files"):
                raise KeyboardInterrupt
            return [Timing(name, 1.0, "ms", None)]
        return type("Part", (), {"rows": staticmethod(rows)})

    monkeypatch.setattr(command, "import_module", rows_of)
    done = CliRunner().invoke(command.main, ["--only", "growth", "--only", "files", "--only", "startup"])
    assert done.exit_code == 1 and "growth" in done.stdout and "files: interrupted" in done.stdout
    assert "vibcli.bench.startup" not in done.stdout


@pytest.mark.sweep
def test_whole_processes_are_measured_by_turns():
    found = costs({"one": (python("pass"), (0,)), "two": (python("raise SystemExit(3)"), (3,))}, 1)
    assert all(cost.time > 0 and cost.memory > 1 and cost.elapsed > 0 for cost in found.values())
    with pytest.raises(RuntimeError, match="exit code 3"):
        costs({"one": (python("raise SystemExit(3)"), (0,))}, 1)


def test_columns_are_aligned():
    lines = aligned([HEAD, Timing("a", 1.0, "ms", None).cells(), Failure("part", "why" * 99).cells()]).splitlines()
    assert len(lines) == 3 and lines[2].endswith("failed") and len(lines[2]) < 200


@pytest.fixture
def meshed_once(monkeypatch):
    """What finite elements of a row find is found once for all that is held against it."""
    known, found = {}, random_members.squares_by_finite_elements

    def kept(row, *asked):
        if (repr(row), asked) not in known:
            known[repr(row), asked] = found(row, *asked)
        return known[repr(row), asked]

    monkeypatch.setattr(random_members, "squares_by_finite_elements", kept)


@pytest.mark.sweep
@pytest.mark.usefixtures("meshed_once")
def test_missed_and_spurious_frequencies_of_members_are_seen(monkeypatch):
    found, seeds = members_counted.counted(4, 49), [49, 50, 51, 52]
    assert not found.wrong and len(found.ratios) == members_counted.MODES and max(found.ratios) <= 1
    agree = members_counted.agree
    for planted in (lambda squares: [*squares[1:], 2 * squares[-1]], lambda squares: [*squares[:3], *squares[2:-1]]):
        monkeypatch.setattr(members_counted, "agree", lambda found, row, planted=planted: agree(planted(found), row))
        assert members_counted.counted(4, 49).wrong == seeds


@pytest.mark.sweep
def test_errors_of_members_are_measured_in_more_digits_than_they_are_found():
    """By 40 digits the first ω of this one is 0.08686265014900210730, rounded once: half of half a unit in its last."""
    assert members_counted.counted(1, 300).ratios[0] == pytest.approx(0.52408, rel=1e-4)


def test_how_far_a_reference_goes_beyond_the_best_method():
    points = [{"error": 1e-14}, {"error": 1e-30}, {"error": None}]
    one = {"reference": {"digits": 40}, "points": points}
    assert shipped.beyond(one) == pytest.approx(40 - 16, abs=0.1)       # no better than a float is
    assert shipped.beyond({**one, "points": points[:1]}) == 26.0 and shipped.beyond({**one, "points": []}) == 40.0
    kept = {"code": 0, "error": "", "full": False, "not compared": {"T": "why"}}
    told = shipped.summary([{**kept, "file": "a.yaml", "seconds": 3.0, "beyond": {"omega": 30.0}},
                            {**kept, "file": "b.yaml", "seconds": 61.0, "beyond": {"x": 7.5}},
                            {**kept, "file": "c.yaml", "seconds": 61.0, "full": True, "beyond": {}}])
    assert told[0] == ("3 files, 2 quantities compared, 1 over 60 s (180 s with a full motion), 1 references less than "
                       "8 digits beyond")
    assert "near: 7.5 digits  b.yaml  x" in told and told[-1] == "not compared:    3  why"


def test_peers_that_are_not_installed_are_rows_that_say_so(monkeypatch):
    monkeypatch.setattr(peers, "installed", lambda package: False)
    monkeypatch.setattr(peers, "answer", lambda *_: json.dumps(
        {"frequencies": [1.0, 1e-15], "instants": [1.0, 1e-15], "double": [50.0, 1e-13]}))
    found = peers.rows(3)
    assert [row.baseline for row in found] == ["python-control, not installed"] * 4 + ["MuJoCo, not installed"] * 2
    assert all(row.kept and row.against is None for row in found)
    monkeypatch.setattr(peers, "answer", lambda *_: json.dumps(
        {"frequencies": [1.0, 1e-3], "instants": [1.0, 1e-15], "double": [50.0, 1e-13]}))
    assert [row.kept for row in peers.rows(3)] == [True, False, True, True, True, True]


@pytest.mark.sweep
def test_what_the_benchmark_checks_is_no_result_that_was_kept(tmp_path, monkeypatch):
    monkeypatch.delenv("VIBCLI_NO_CACHE", raising=False)
    fresh = reload(processes)
    (tmp_path / "scene.yaml").write_text("bodies: {a: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 4 N/m, between: "
                                         "[ground, a]}}\nanswers:\n  omega[1]: 2 rad/s\n")
    fresh.costs({"check": (fresh.vibcli("check", str(tmp_path / "scene.yaml")), (0,))}, 1)
    assert not (tmp_path / ".vibcli_cache").exists()
