"""Records: files beside a scene, read safely and explained where they are wrong."""

import os
import random
from pathlib import Path

import numpy as np
import pytest

from vibcli.base.errors import SpecError
from vibcli.check.verdicts import check
from vibcli.cli.program import run
from vibcli.language import data_columns
from vibcli.language.document.document import read_file
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.sampled_functions import Samples

SCENE = """parameters: {{m: 2 kg, k: 800 N/m}}
records:
  ag: {record}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
forces: {{f: {{at: b, force: {force}}}}}
"""
PLAIN = "t,a\n0,0\n0.1,2\n0.3,-1\n0.4,0\n"


@pytest.fixture
def beside(tmp_path):
    """scene(record, force, **files) → path of a scene with files beside it."""
    def scene(record="{file: a.csv, unit: m/s^2}", force="m*ag(t)", text=PLAIN, **files):
        for name, content in {"a.csv": text, **files}.items():
            data = content if isinstance(content, bytes) else content.encode()
            (tmp_path / name).write_bytes(data)
        path = tmp_path / "scene.yaml"
        path.write_text(SCENE.format(record=record, force=force))
        return str(path)
    return scene


def problem(path):
    root, diagnostics, _ = read_file(path)
    return Problem(read_spec(root, path, diagnostics))


def samples(path):
    return problem(path).scene.table.records["ag"]


# what is read


@pytest.mark.parametrize(("record", "text"), [
    ("a.csv", PLAIN), ("{file: a.csv}", PLAIN), ("{file: a.csv, time: 1, value: 2}", PLAIN),
    ("{file: a.csv, time: t, value: a}", "x,a,t\n9,0,0\n9,2,0.1\n9,-1,0.3\n9,0,0.4\n"),
    ("a.csv", PLAIN.replace(",", ";")), ("a.csv", PLAIN.replace(",", "\t")), ("a.csv", PLAIN.replace(",", "   ")),
    ("a.csv", PLAIN.partition("\n")[2]), ("a.csv", "# a remark\n\n" + PLAIN + "\n\n"),
    ("a.csv", "\ufeff" + PLAIN.replace("\n", "\r\n")), ("a.csv", '"t","a"\n"0","0"\n0.1, "2"\n 0.3 ,-1\n4e-1,0\n'),
    ("{file: a.csv, time_unit: ms, value: 2}", "0,0\n100,2\n300,-1\n400,0\n")])
def test_files_are_read_as_people_write_them(beside, record, text):
    found = samples(beside(record, "ag(t)*(1 N)", text))
    assert found.times == pytest.approx((0, 0.1, 0.3, 0.4)) and found.values == (0, 2, -1, 0)


def test_units_and_equal_intervals(beside):
    found = samples(beside("{file: a.csv, every: 5 ms, unit: cm/s^2}", text="10\n20\n30\n"))
    assert found.times == (0.0, 0.005, 0.01) and found.values == pytest.approx((0.1, 0.2, 0.3), rel=1e-15)


def test_a_record_is_read_once_for_all_cases(beside, monkeypatch):
    path = beside()
    with open(path, "a") as file:
        file.write("cases:\n" + "".join(f"  c{i}: {{parameters: {{k: {i + 1} N/m}}}}\n" for i in range(9)))
    calls = []
    kept = data_columns._parsed
    monkeypatch.setattr(data_columns, "_parsed", lambda *args: calls.append(1) or kept(*args))
    problem(path)
    assert len(calls) == 1


SLIPS = ("1.O", "0x10", "1e400", "nan", "-inf", "1_0", "1,5", "", "O.5", "--1", "5 m", "1e", "−2", "½", "x")


@pytest.mark.parametrize("heading", [True, False])
@pytest.mark.parametrize("row", [0, 1, 3])
@pytest.mark.parametrize("column", [0, 1])
def test_a_slip_in_any_row_is_found_where_it_is(beside, heading, row, column):
    """Of no row is a slip taken for a heading, and no row is left out."""
    for slip in SLIPS:
        cells = [["0", "5"], ["0.1", "2"], ["0.3", "-1"], ["0.4", "0"]]
        cells[row][column] = slip
        lines = ["t;a"] * heading + [";".join(pair) for pair in cells]
        with pytest.raises(SpecError) as error:
            problem(beside(text="\n".join(lines) + "\n"))
        place = error.value.diagnostics[0].where
        assert (place.line, place.column) == (row + heading + 1, 1 if column == 0 else len(cells[row][0]) + 2)


@pytest.mark.parametrize("first", ["t,a", '"time [s]","a in m/s²"', "Zeit,Beschl.", "(t),[a]", "$t$,\\ddot{x}", "μ,α"])
def test_headings_are_names_throughout(beside, first):
    assert samples(beside(text=first + "\n0,5\n0.1,2\n")).values == (5, 2)
    for mixed in ("t,2", "0,a", "t,1.O", "t,"):
        with pytest.raises(SpecError, match="expected a number"):
            problem(beside(text=mixed + "\n0,5\n0.1,2\n"))


def test_rows_have_as_many_cells_as_the_first(beside):
    for text in ("0,5\n0.1,2,5\n0.2,3\n", "t,a\n0,5\n0.1\n0.2,3\n", "t,a\n0,5,1\n0.1,2,5\n"):
        with pytest.raises(SpecError, match="expected 2 columns, found"):
            problem(beside(text=text))


# values


def test_values_and_rates_in_all_arithmetics():
    table, generator = Table(), random.Random(1)
    table.records["ag"] = Samples((0, 0.1, 0.3, 0.4), (0, 2, -1, 0))
    time = table.time = table.variable("t")
    node = table.call("ag", time * 2 - 1)
    rate = gradient(node)[time]
    t = np.array([generator.uniform(0.3, 0.9) for _ in range(200)])
    arrays = evaluate([node, rate], Arrays, {"t": t})
    for i, x in enumerate(t):
        assert evaluate([node, rate], Floats, {"t": float(x)}) == pytest.approx([arrays[0][i], arrays[1][i]])
        wanted = np.interp(2 * x - 1, (0, 0.1, 0.3, 0.4), (0, 2, -1, 0), left=0, right=0)
        assert arrays[0][i] == pytest.approx(wanted)
    assert evaluate([node, rate], Floats, {"t": 0.53}) == pytest.approx([1.2, 40])


def test_the_response_of_a_record_is_that_of_its_lines(beside):
    """A record of three samples is a triangle of ramps."""
    text = "0,0\n0.1,1\n0.2,0\n"
    force = "(20 N)*(ramp(t) - 2*ramp(t - 0.1 s) + ramp(t - 0.2 s))/(0.1 s)"
    values = []
    for path in (beside("a.csv", "(20 N)*ag(t)", text), None):
        if path is None:
            path = beside("a.csv", force + " + 0*ag(t)*(1 N)", text)
        with open(path, "a") as file:
            file.write("answers: {x(0.15 s): 1 mm, x(0.9 s): 1 mm}\n")
        values.append([verdict.found for verdict in check(problem(path))])
    assert values[0] == pytest.approx(values[1], rel=1e-12)


@pytest.mark.sweep
def test_a_record_moves_a_support(tmp_path):
    """The support of a spring and damper follows a record: its rate is a staircase."""
    (tmp_path / "u.csv").write_text("0 0\n0.2 0.01\n0.5 -0.02\n0.6 0\n")
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m, c: 9 N*s/m}\nrecords: {u: {file: u.csv, unit: m}}\n"
                    "points: {S: {at: [0, 0], moves: [0, u(t)]}}\n"
                    "bodies: {b: {mass: m, at: [0, 1 m], slide: {along: [0, 1], by: y}}}\n"
                    "springs: {s: {k: k, between: [S, b]}}\ndampers: {d: {c: c, between: [S, b]}}\n"
                    "answers:\n  omega[1]: sqrt(k/m)\n  equation[y]: m*y'' + c*y' + k*y = 0\n  y(0.55 s): 1 mm\n")
    found = problem(str(path))
    good, bad, moved = check(found)
    assert good.agrees and not bad.agrees       # the excitation is missing from the expected equation
    y, v, h, t = 0.0, 0.0, 1e-5, 0.0

    def pull(t):
        return np.interp(t, (0, 0.2, 0.5, 0.6), (0, 0.01, -0.02, 0))

    def acceleration(t, y, v):
        slope = 0.05 if t < 0.2 else -0.1 if t < 0.5 else 0.2
        return (800 * (pull(t) - y) + 9 * (slope - v)) / 2

    while t < 0.55 - h / 2:                     # midpoint rule
        a = acceleration(t, y, v)
        b = acceleration(t + h / 2, y + h / 2 * v, v + h / 2 * a)
        y, v, t = y + h * (v + h / 2 * a), v + h * b, t + h
    assert moved.found == pytest.approx(y, rel=1e-5)


# what is wrong


def complaints(path, capsys):
    """(exit code, what stderr says) of solving."""
    code = run(["solve", path])
    return code, capsys.readouterr().err


WRONG = {
    "0,0\n0.1,abc\n0.2,0\n": ("a.csv:2:5", "expected a number, found 'abc'"),
    "t,a\n0,0\n0.1,nan\n0.2,1\n": ("a.csv:3:5", "expected a number, found 'nan'"),
    "0,0\n0.1,inf\n": ("a.csv:2:5", "found 'inf'"), "0,0\n0.1,1e999\n": ("a.csv:2:5", "found '1e999'"),
    "0,0\n0.1,\n": ("a.csv:2:5", "found nothing"), "0,0\n0.1\n": ("a.csv:2:1", "expected 2 columns, found 1"),
    "0,0\n0.2,1\n0.1,2\n": ("a.csv:3:1", "the times must ascend"), "0,0\n0,1\n": ("a.csv:2:1", "the times must ascend"),
    "0;0\n0,1;2\n": ("a.csv:2:1", "decimals are written with a point"), "0,1_0\n1,2\n": ("a.csv:1:3", "found '1_0'"),
    "t,a\n0,1\n": ("a.csv", "at least two rows"), "": ("a.csv", "at least two rows"),
    "0,0\n1,1e99\n": ("a.csv:2:3", "out of range"), b"0,0\n\xff,1\n": ("a.csv:2", "not UTF-8"),
    "\u0660,0\n\u0661,1\n\u0662,1\n": ("a.csv:2:1", "expected a number"), "0\n1\n2\n": ("scene.yaml:3", "no column 2"),
}


@pytest.mark.parametrize("text", WRONG, ids=repr)
def test_wrong_files_are_explained(text, beside, capsys):
    code, said = complaints(beside(text=text), capsys)
    place, message = WRONG[text]
    assert code == 3 and place in said and message in said and "Traceback" not in said


def test_line_ends_are_not_shown(beside, capsys):
    _, said = complaints(beside(text="0,0\r\n0.1,abc\r\n0.2,0\r\n"), capsys)
    assert "  0.1,abc\n" in said


KEYS = {
    "{file: b.csv}": "did you mean 'a.csv'?", "{file: ../a.csv}": "beside the scene", "{file: /etc/passwd}":
    "beside the scene", "{file: 'C:\\a.csv'}": "beside the scene", "{file: sub/../../a.csv}": "beside the scene",
    "{file: .}": "is no file", "{file: a.csv, value: b}": "no column 'b'", "{file: a.csv, value: 3}": "no column 3",
    "{file: a.csv, time: 0}": "no column 0", "{file: a.csv, time_unit: kg}": "expected a unit of time",
    "{file: a.csv, every: -1 s}": "expected a positive time", "{file: a.csv, every: 0.1 m}": "expected a time",
    "{file: a.csv, every: 1 s, time: t}": "contradicts", "{file: a.csv, unit: metre}": "expected a unit",
    "{value: a}": "needs 'file'", "{file: }": "the name of a file", "{file: a.csv, scale: 2}": "unknown key 'scale'",
    "[a.csv]": "found a list", "{file: a.csv, unit: m/s^2, every: 2*k}": "expected",
}


@pytest.mark.parametrize("record", KEYS)
def test_wrong_keys_are_explained(record, beside, capsys):
    code, said = complaints(beside(record), capsys)
    assert code == 3 and KEYS[record] in said


FORCES = {
    "m*ag(x)": "the coordinate 'x' cannot stand in it", "m*ag": "write ag(t)", "m*ag(t, 2)": "takes one argument",
    "m*ag(2*k)": "the argument of ag is a time", "k*ag(t)": "expected a force", "m*aq(t)": "unknown function 'aq'",
    "m*ag'": "function of the time", "(1 N)*t/(1 s)": "the record 'ag' is not used",
}


@pytest.mark.parametrize("force", FORCES)
def test_wrong_uses_are_explained(force, beside, capsys):
    code, said = complaints(beside(force=force), capsys)
    assert code == 3 and FORCES[force] in said


@pytest.mark.parametrize("name", ["step", "sin", "max", "t", "pi", "power", "m", "x"])
def test_names_that_are_taken(name, beside, capsys):
    path = beside(force=f"m*{name}(t)")
    with open(path) as file:
        text = file.read().replace("  ag:", f"  {name}:")
    with open(path, "w") as file:
        file.write(text)
    code, said = complaints(path, capsys)
    assert code == 3 and ("word of the language" in said or "rename one of them" in said)


def test_links_do_not_leave_the_folder(tmp_path, capsys):
    (tmp_path / "outside.csv").write_text(PLAIN)
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "link.csv").symlink_to(tmp_path / "outside.csv")
    (folder / "near.csv").symlink_to(folder / "real.csv")
    (folder / "real.csv").write_text(PLAIN)
    path = folder / "scene.yaml"
    path.write_text(SCENE.format(record="link.csv", force="ag(t)*(1 N)"))
    code, said = complaints(str(path), capsys)
    assert code == 3 and "leads out of the folder" in said
    path.write_text(SCENE.format(record="near.csv", force="ag(t)*(1 N)"))
    assert complaints(str(path), capsys)[0] == 0


def test_what_is_too_large_or_no_file(beside, tmp_path, capsys, monkeypatch):
    assert (data_columns.MAX_BYTES, data_columns.MAX_ROWS) == (100 * 2**20, 2_000_000)
    monkeypatch.setattr(data_columns, "MAX_ROWS", 2000)
    path = beside(record="many.csv", **{"many.csv": "".join(f"{i},1\n" for i in range(2001))})
    assert "more than 2000 rows" in complaints(path, capsys)[1]
    monkeypatch.setattr(data_columns, "MAX_BYTES", 2**20)
    path = beside(text="0,0\n" + "1,1\n" * 10, record="big.csv", **{"big.csv": b"1,1\n" * 300_000})
    assert "more than 1 MB" in complaints(path, capsys)[1]
    os.mkfifo(tmp_path / "pipe.csv")
    assert "is no file" in complaints(beside(record="pipe.csv"), capsys)[1]


@pytest.mark.sweep
def test_noise_is_never_an_error_of_our_own(beside, capsys):
    generator = random.Random(8)
    for _ in range(60):
        letters = "0123456789.,;\n\t #-eE\"'\u00e9\0nai"
        text = "".join(generator.choice(letters) for _ in range(generator.randint(0, 80)))
        code, said = complaints(beside(text=text), capsys)
        assert code in (0, 3, 4) and "error of its own" not in said


CARRIED = """parameters: {m: 2 kg, k: 800 N/m}
records: {u: {file: u.csv, unit: m}}
bodies:
  c: {mass: m, at: [0, 0], slide: {along: [1, 0], by: u(t)}}
  b: {mass: m, at: [0, 0], slide: {along: [1, 0], by: x, carrier: c}}
springs: {s: {k: k, stretch: x}}
answers: {x(1 s): 0.1 m}
"""


@pytest.mark.parametrize(("text", "jumps"), [
    ("0,0.1\n1,0\n", True), ("0,0\n1,0.1\n", True), ("0,0\n0.3,0.1\n1,0\n", False)])
def test_what_carries_another_body_must_not_jump(text, jumps, tmp_path):
    (tmp_path / "u.csv").write_text(text)
    path = tmp_path / "scene.yaml"
    path.write_text(CARRIED)
    verdict, = check(problem(str(path)))
    assert (verdict.remark is not None and "rate of an impulse" in verdict.remark) == jumps
    if not jumps:       # m x'' + k x = -m u'': blows of -m times the changes of slope, at 0, 0.3 s and 1 s
        omega, slopes = 20.0, (0.1 / 0.3, -0.1 / 0.7)
        wanted = -slopes[0] * np.sin(omega) / omega - (slopes[1] - slopes[0]) * np.sin(0.7 * omega) / omega
        assert verdict.found == pytest.approx(wanted, rel=1e-12)


def test_full_motion_of_what_a_record_carries(beside):
    """A block in a cart that moves as measured is struck at each sample, in small and full motion alike."""
    path = beside()
    values = []
    for motion in ("small", "full"):
        Path(path).write_text(f"{SHAKEN}motion: {motion}\n", encoding="utf-8")
        values.append([verdict.found for verdict in check(problem(str(path)))])
    assert values[1] == pytest.approx(values[0], rel=1e-8)
    omega, late = 20.0, 0.139           # x'' + ω² x = −u'': blows at the changes of the slope of u
    rates = np.diff([0, 0.2, -0.15, 0.1, 0])        # of the straight lines of a.csv
    wanted = 0.01 * np.cos(0.7 * omega) - sum(rate * np.sin(omega * (0.7 - late - at)) / omega for rate, at in zip(
        rates, (0, 0.1, 0.3, 0.4), strict=True))
    assert values[0][0] == pytest.approx(wanted, rel=1e-9)


SHAKEN = """records: {ag: {file: a.csv, unit: cm}}
bodies:
  cart: {mass: 3 kg, at: [0, 0], slide: {along: [1, 0], by: ag(t - 0.139 s)}}
  block: {mass: 2 kg, at: [0, 1 m], slide: {along: [1, 0], by: x, carrier: cart}}
points: {A: {body: cart, at: [-1 m, 1 m]}}
springs: {s: {k: 800 N/m, between: [A, block]}}
initial: {x: 1 cm}
find: [{response: {until: 0.7 s}}]
answers: {x(0.7 s): 1 m, T(0.7 s): 1 J}
"""


def test_what_is_read_is_said(beside, capsys):
    assert run(["solve", beside(record="{file: a.csv, unit: cm/s^2}")]) == 0
    assert "ag(t)  4 samples of a.csv, from 0 s to 0.4 s, the largest 0.02 m/s²" in capsys.readouterr().out


def test_new_writes_the_record_too(tmp_path, capsys):
    path = tmp_path / "blow.yaml"
    assert run(["new", "measured_blow", "-o", str(path)]) == 0
    assert "hammer.csv" in capsys.readouterr().err
    assert run(["check", str(path)]) == 0
    assert run(["new", "measured_blow", "-o", str(tmp_path / "other.yaml")]) == 2
    assert not (tmp_path / "other.yaml").exists()
