"""`vibcli sweep`: tables, curves and data over parameters; what cannot be swept over."""

import csv
import json

import numpy as np
import pytest
from support import scenes

import vibcli
from vibcli.api.axis import axis
from vibcli.api.sweep import sweep
from vibcli.api.values import given_expression
from vibcli.cli.program import run
from vibcli.plots.words import width
from vibcli.report.sections.swept_curves import sweep_figure

TWO = """title: Two oscillators on a weak spring
parameters: {m: 1 kg, k1: 100 N/m, k2: 100 N/m, kc: 1 N/m, s: 2*kc, c: 0.5 N*s/m}
bodies: {a: {mass: m, slide: x1}, b: {mass: m, slide: x2}}
springs: {s1: {k: k1, stretch: x1}, s2: {k: k2, stretch: x2}, sc: {k: s/2, stretch: x2 - x1}}
dampers: {d: {c: c, stretch: x1}}
"""
RODS = """title: A rotor
parameters: {m: 1 kg, k: 400 N/m, Omega: 10 rad/s}
bodies:
  disc: {at: [0, 0], pin: {by: Omega*t}}
  bead: {mass: m, at: [0, 0], move: {by: [u, v, 0], carrier: disc}}
energies: {V: k*(u^2 + v^2)/2}
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "two.yaml"
    path.write_text(TWO, encoding="utf-8")
    return str(path)


def out_of(capsys, *args, code=0):
    assert run(["sweep", *args]) == code
    return capsys.readouterr()


@pytest.mark.sweep
def test_a_table_tells_where_branches_veer(scene, capsys):
    out = out_of(capsys, scene, "--over", "k1=50 N/m .. 150", "--of", "omega[1]", "--of", "zeta[1]",
                 "--points", "5").out
    rows = [line.split() for line in out.splitlines() if line.strip()[:1].isdigit()]
    assert [row[0] for row in rows] == ["50", "75", "100", "125", "150"] and rows[2][1] == "10"
    assert "ω₁ [rad/s]" in out and "ζ₁" in out and "Branches 1 and 2 veer at k₁ = 100.0" in out


def test_expressions_of_quantities_are_told_as_in_print(scene, capsys):
    out = out_of(capsys, scene, "--over", "k1=50 .. 150", "--of", "2*k1*omega[1]^2", "--points", "3").out
    assert "2·k₁·ω₁² [" in out and "omega" not in out


@pytest.mark.sweep
def test_branches_that_cross_have_a_column(scene, capsys):
    out = out_of(capsys, scene, "--set", "kc=0", "--over", "k1=50 .. 170", "--of", "omega[1]", "--points", "4").out
    assert "cross at k₁ = 100 N/m" in out
    assert [line.split()[2] for line in out.splitlines() if line.strip()[:1].isdigit()] == ["1", "1", "2", "2"]


def test_natural_frequencies_unless_asked(scene, capsys):
    assert "ω₁ [rad/s]  ω₂ [rad/s]" in out_of(capsys, scene, "--over", "m=500 g .. 2 kg", "--points", "3").out


@pytest.mark.sweep
def test_its_data(scene, capsys):
    found = json.loads(out_of(capsys, scene, "--over", "k1=0.05 N/mm .. 150 N/m", "--of", "omega[2]", "--points", "3",
                              "--json").out)["sweep"]
    assert found["over"] == [{"name": "k1", "unit": "N/mm", "values": [0.05, 0.1, 0.15]}]
    one, = found["quantities"]
    assert one["values"][1] == pytest.approx(102**0.5, rel=1e-15)
    assert one["unit"] == "rad/s" and one["branch"] == [2] * 3


@pytest.mark.sweep
def test_values_without_answer_are_gaps(scene, capsys):
    out = out_of(capsys, scene, "--over", "k1=-10 .. 10", "--of", "omega[1]", "--points", "5").out
    assert "ω₁: no value for k₁ = -10 … -5 N/m: mode 1 is unstable: it has a growth rate, no frequency." in out
    assert [line.split()[1] for line in out.splitlines() if line.split()[:1] in (["-10"], ["-5"])] == ["–", "–"]


@pytest.mark.sweep
def test_it_is_plotted_and_saved(scene, capsys, tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    target, picture = tmp_path / "k.csv", tmp_path / "k.svg"
    out = out_of(capsys, scene, "--over", "k1=50 .. 150", "--of", "omega[1]", "--of", "omega[2]", "--points", "9",
                 "--plot", "--save", str(target), "--save", str(picture)).out
    assert max(map(width, out[out.rindex("Two osc"):].splitlines())) <= 80
    assert "ω₁, ω₂ [rad/s]" in out and "k₁ [N/m]" in out
    rows = list(csv.reader(target.read_text().splitlines()))
    assert rows[0] == ["k1 [N/m]", "omega[1] [rad/s]", "branch of omega[1] []", "omega[2] [rad/s]",
                       "branch of omega[2] []"]
    assert len(rows) == 10 and float(rows[5][1]) == pytest.approx(10, rel=1e-15)
    assert b"<svg" in picture.read_bytes()
    assert run(["sweep", scene, "--over", "k1=1 .. 2", "--save", str(target)]) == 2


@pytest.mark.sweep
def test_an_interrupt_keeps_the_values_that_were_found(scene, capsys, tmp_path, monkeypatch):
    from vibcli.quantities import sweep

    whole, asked, target = sweep._value, [], tmp_path / "k.csv"

    def interrupted(problem, expression):
        asked.append(expression)
        if len(asked) > 4:
            raise KeyboardInterrupt
        return whole(problem, expression)

    monkeypatch.setattr(sweep, "_value", interrupted)
    assert run(["sweep", scene, "--over", "k1=50 .. 150", "--of", "omega[1]", "--points", "9", "--save",
                str(target)]) == 130
    told = capsys.readouterr()
    assert "nterrupted" in told.out and told.err.endswith("interrupted\n")
    assert len([line for line in told.out.splitlines() if len(line.split()) == 2 and line.split()[1] != "–"
                and line.split()[0].replace(".", "").isdigit()]) >= 4
    assert len(target.read_text().splitlines()) == 1 + 4
    asked.clear()
    assert run(["sweep", scene, "--set", "kc=0", "--over", "k1=90 .. 180", "--of", "omega[1]", "--of", "omega[2]",
                "--points", "9", "--json", "--save", str(tmp_path / "crossing.svg")]) == 130
    found = json.loads(capsys.readouterr().out)["sweep"]
    assert found["reached"] == 2 and found["quantities"][0]["values"][2:] == [None, None, *[None] * 5]
    assert found["quantities"][0]["branch"] == [1, 2, *[None] * 7] and (tmp_path / "crossing.svg").exists()
    asked.clear()
    swept = vibcli.load(scene).sweep("omega[1]", k1=[100.0, 110.0, 120.0, 130.0, 140.0, 150.0])
    assert swept.gaps == [(("omega[1]",), [(4,), (5,)], "it was interrupted before")]
    asked.clear()
    swept = vibcli.load(scene).sweep("omega[1]", "omega[2]", "period[1]", k1=[100.0, 110.0, 120.0])
    assert [value == value for value in swept.values["omega[1]"]] == [True, False, False]
    assert [places for _, places, _ in swept.gaps] == [[(1,), (2,)]]


def test_it_is_told_how_far_it_has_come(scene):
    given, told = vibcli.load(scene), []
    given._problem.work.tell = lambda *said: told.append(said)
    given.sweep("omega[1]", k1=[float(k) for k in range(50, 60)])
    assert {said[0] for said in told} == {"the sweep", None}
    parts = [said[1] for said in told if said[2]]
    assert parts == sorted(parts) and set(parts) == {i / 10 for i in range(1, 11)}
    assert all(said[2] for said in told[told.index(("the sweep", 0.1, True)):-1])      # also while a value is found


def test_curves_break_where_the_number_of_natural_modes_changes(tmp_path, capsys):
    """Ω = √(k/m): two rigid modes and one of 2Ω instead of |√(k/m) ± Ω|."""
    problem = scenes.problem(RODS)
    found = sweep(problem, [axis(problem.spec, "Omega=18 .. 22", 5)], [given_expression("omega[2]", "")])
    assert found.columns[0].tolist() == pytest.approx([38, 39, 0, 41, 42], rel=1e-14)
    curve = sweep_figure(found).panels[0].curves[-1]
    assert np.isnan(curve.y).tolist() == [False, False, True, False, True, False, False]
    path = tmp_path / "rotor.yaml"
    path.write_text(RODS, encoding="utf-8")
    assert "At Ω = 20 rad/s there are 3 natural modes, 2 before" in " ".join(
        out_of(capsys, str(path), "--over", "Omega=18 .. 22", "--points", "5").out.split())


@pytest.mark.parametrize("log", [False, True])
def test_values_that_grow_by_one_ratio_are_plotted_by_decades(log):
    problem = scenes.problem(TWO)
    asked = [given_expression(text, "") for text in ("omega[1]", "omega[2]^2")]
    found = sweep(problem, [axis(problem.spec, "k1=1 .. 1e4", 5, log)], asked)
    assert [(panel.x_log, panel.y_log) for panel in sweep_figure(found).panels] == [(log, False), (log, log)]


@pytest.mark.sweep
def test_two_parameters_are_a_grid_with_contours(scene, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    out = out_of(capsys, scene, "--over", "k1=50 .. 150", "--over", "k2=50 .. 100", "--of", "omega[1]", "--points", "9",
                 "--plot").out
    assert "k₂ = 50 N/m" in out and "k₂ = 100 N/m" in out and "ω₁ = 8 rad/s" in out
    found = json.loads(out_of(capsys, scene, "--over", "k1=50 .. 150", "--over", "k2=50 .. 100", "--of", "omega[1]",
                              "--points", "3", "--json").out)["sweep"]
    assert len(found["quantities"][0]["values"]) == 9 and found["quantities"][0]["branch"] is None


@pytest.mark.sweep
def test_a_campbell_diagram(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    path = tmp_path / "rotor.yaml"
    path.write_text(RODS, encoding="utf-8")
    out = out_of(capsys, str(path), "--over", "Omega=1 .. 15", "--points", "8", "--plot").out
    rows = [list(map(float, line.split())) for line in out.splitlines()[5:13]]
    assert len(rows) == 8
    for Omega, low, high in rows:
        assert (low, high) == (pytest.approx(20 - Omega, rel=1e-5), pytest.approx(20 + Omega, rel=1e-5))
    assert "1×" in out and "2×" in out


@pytest.mark.parametrize(("over", "said"), [
    ("k9=1 .. 2", "the file has no parameter 'k9'"),
    ("k1=5 .. 1", "the range is empty: 5 is not below 1"),
    ("k1=5", "write NAME=LOW .. HIGH"),
    ("k1=1 kg .. 2 kg", "the unit of 'k1' does not fit, as in 100 N/m"),
    ("k1=1 N/m .. 2 m", "do not go together"),
    ("k1=a .. 2", "'a' is no number with a unit"),
    ("s=1 .. 2", "'s' is defined by 'kc': vary that"),
    ("m=-1 kg .. 1 kg", "there is no such scene at m = -1 kg: the mass is -1 kg, expected zero or more")])
def test_what_cannot_be_swept_over(scene, capsys, over, said):
    assert said in out_of(capsys, scene, "--over", over, code=2).err


@pytest.mark.parametrize(("options", "said"), [
    (["--over", "k1=1 .. 2", "--of", "omgea[1]"], "did you mean 'omega'?"),
    (["--over", "k1=1 .. 2", "--of", "motion[x1]"], "is a function of the state, no number"),
    (["--over", "k1=1 .. 2", "--over", "k1=1 .. 2"], "'k1' is swept over twice"),
    (["--over", "k1=-1 .. 2", "--log"], "begin above zero"),
    (["--set", "k1=2", "--over", "k1=1 .. 2"], "--set k1=2: 'k1' is swept over"),
    (["--over", "k1=1 .. 2", "--over", "k2=1 .. 2", "--over", "m=1 .. 2"], "more than twice"),
    (["--over", "k1=1 .. 2", "--over", "k2=1 .. 2", "--points", "5000"], "the limit is 1000000")])
def test_what_cannot_be_asked(scene, capsys, options, said):
    assert run(["sweep", scene, *options]) in (2, 3)
    assert said in capsys.readouterr().err


def test_a_scene_that_is_wrong_as_written_is_told_with_its_place(tmp_path, capsys):
    path = tmp_path / "wrong.yaml"
    path.write_text("parameters: {m: 1 kg, k: 1 N/m}\nbodies: {a: {mass: m, at: [0, 0], slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a]}}\n", encoding="utf-8")
    told = out_of(capsys, str(path), "--over", "k=1 .. 2", "--of", "omega[1]", code=3).err
    assert "wrong.yaml:3:31: error: 's' joins a place and bare ground" in told


@pytest.mark.sweep
def test_frequencies_that_end_before_the_middle_of_the_range_have_a_gap(tmp_path, capsys):
    """A bead on a rod that turns faster than its spring can hold it, ω² = k/m − Ω²: it is driven away from its one
    equilibrium, which is said once, as it is of a single value."""
    path = tmp_path / "bead.yaml"
    path.write_text("parameters: {m: 0.5 kg, k: 80 N/m, a: 0.3 m, Omega: 8 rad/s}\nbodies:\n"
                    "  rod: {at: [0, 0], pin: {at: [0, 0], by: Omega*t}}\n"
                    "  bead: {mass: m, at: [a, 0], slide: {along: [1, 0], by: u, carrier: rod}}\n"
                    "springs:\n  s: {k: k, between: [[0, 0], bead]}\n", encoding="utf-8")
    out = out_of(capsys, str(path), "--over", "Omega=4 rad/s .. 28 rad/s", "--points", "4").out
    rows = [line.split() for line in out.splitlines() if line.strip()[:1].isdigit()]
    assert rows[0] == ["4", "12"] and [row[1] for row in rows[2:]] == ["–", "–"]
    assert "no value for Ω = 20 … 28 rad/s" in out
    reason = "reached from the drawn position: forces lead away from the only one that there is"
    assert run(["solve", str(path), "--set", "Omega=20 rad/s"]) == 0
    assert all(reason in " ".join(text.split()) for text in (out, capsys.readouterr().out))


def test_letters_need_values(tmp_path, capsys):
    path = tmp_path / "letters.yaml"
    path.write_text(TWO.replace("m: 1 kg", "m: {unit: kg}"), encoding="utf-8")
    assert "these parameters have none: m" in out_of(capsys, str(path), "--over", "k1=1 .. 2", code=2).err
    assert "ω₁" in out_of(capsys, str(path), "--over", "m=1 kg .. 2 kg", "--points", "3").out


@pytest.mark.parametrize(("values", "said"), [
    ([1.0, float("nan")], "are to be an array of finite numbers"), ([1.0, float("inf")], "of finite numbers"),
    ("1 .. 2", "of finite numbers"), ([2.0, 1.0], "are to ascend"), ([1.0], "two at least")])
def test_arrays_that_are_none_to_sweep_over(scene, values, said):
    with pytest.raises(vibcli.SpecError, match=said):
        vibcli.load(scene).sweep("omega[1]", k1=values)
