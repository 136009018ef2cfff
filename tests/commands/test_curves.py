"""`vibcli response` and `vibcli frf` from the command line: what they print, plot and save, and what they refuse."""

import csv
import json
import math
import warnings

import pytest
from support.scenes import problem

from vibcli.cli.program import run
from vibcli.manual import scenes

SHAKEN = """
parameters: {m: 2 kg, k: 800 N/m, Y: 1 cm, Omega: 15 rad/s}
points: {base: {at: [0, 0], moves: [0, Y*sin(Omega*t)]}}
bodies: {block: {mass: m, at: [0, 1 m], slide: {along: [0, 1], by: y}}}
springs: {s: {k: k, between: [base, block]}}
"""
PARAMETRIC = """
parameters: {m: 1 kg, L: 0.5 m, Y: 1 cm, Omega: 60 rad/s, g: 9.81 m/s^2}
gravity: g
points: {pivot: {at: [0, 0], moves: [0, Y*sin(Omega*t)]}}
bodies: {bob: {mass: m, at: [0, -L], pin: {at: pivot, by: phi}}}
initial: {phi: 10 deg}
motion: full
"""


@pytest.fixture
def call(tmp_path, capsys):
    """call(command, text of a scene or name of an example, options…) -> (exit code, stdout, stderr)"""
    def called(command, scene, *options):
        path = scenes.path(scene) if "\n" not in scene else tmp_path / "scene.yaml"
        if "\n" in scene:
            path.write_text(scene, encoding="utf-8")
        capsys.readouterr()
        code = run([command, str(path), *options])
        return code, *capsys.readouterr()
    return called


@pytest.mark.sweep
def test_a_chosen_scene_is_plotted_until_the_end_given(call):
    code, out, _ = call("response", "tuned_absorber", "--until", "1", "--plot")
    assert code == 0 and "0 ≤ t ≤ 1 s" in out and "x₁, x₂ [mm]" in out
    code, out, _ = call("frf", "tuned_absorber", "--of", "x1", "--plot")
    assert code == 0 and "phase lag" in out and "\n|x₁/drive| [m/N]\n" in out
    assert "\n|y/base|\n" in call("frf", SHAKEN, "--of", "y", "--to", "base", "--plot")[1]
    mixed = call("frf", "frequency_response", "--plot")[1]
    assert "\n|H| to drive  " in mixed and " x [m/N] " in mixed and " ẋ [(m/s)/N]\n" in mixed
    assert "\n|x₁/Q_x₂| [m/N]\n" in call("frf", "tuned_absorber", "--of", "x1", "--to", "x2", "--plot")[1]


def test_what_stands_still_is_told(call):
    assert "without vibration: x₁" in call("response", "tuned_absorber")[1]
    assert "without vibration" not in call("response", "step_load")[1]


@pytest.mark.parametrize(("command", "options", "words"), [
    ("response", ["--steady"], "--steady belongs to --plot or --save"),
    ("response", ["--transient"], "--transient belongs to --plot or --save"),
    ("response", ["--plot", "--json"], "--plot does not go with --json"),
    ("response", ["--until", "-1"], "expected a time"), ("response", ["--until", "5 Hz"], "expected a time"),
    ("response", ["--save", "x.jpg"], "it has '.jpg'"), ("response", ["--save", "no/x.csv"], "there is no folder no"),
    ("frf", ["--nyquist"], "--nyquist belongs to --plot or --save"),
    ("frf", ["--from", "2"], "--from belongs to --plot or --save"),
    ("frf", ["--plot", "--from", "5", "--up-to", "3"], "--from 5 is not below --up-to 3"),
    ("frf", ["--plot", "--from", "2 m"], "expected a frequency")])
def test_options_that_do_not_fit_are_refused(call, command, options, words):
    code, out, err = call(command, "forced_vibration", *options)
    assert (code, out) == (2, "") and words in err


def test_saved_columns(call, tmp_path):
    file = tmp_path / "motion.csv"
    options = ["--of", "x", "--of", "ground.force", "--steady", "--points", "5", "--until", "0.4", "--save", str(file)]
    assert call("response", "forced_vibration", *options)[0] == 0
    head, *rows = csv.reader(file.read_text(encoding="utf-8").splitlines())
    assert head == ["t [s]", "x [m]", "steady x [m]", "ground.force [N]", "steady ground.force [N]"]
    assert [float(row[0]) for row in rows] == pytest.approx([0, 0.1, 0.2, 0.3, 0.4])
    assert float(rows[0][1]) == 0 and float(rows[0][2]) != 0
    assert call("response", "forced_vibration", "--save", str(file))[0] == 2        # it is not replaced


def test_the_range_of_the_file_takes_hertz(call, tmp_path):
    file = tmp_path / "curve.json"
    assert call("frf", "frequency_response", "--save", str(file))[0] == 0           # from: 2 Hz, up_to: 30 rad/s
    first, *others = json.loads(file.read_text(encoding="utf-8"))["columns"]
    assert (first["name"], first["unit"]) == ("Omega", "rad/s")
    assert (first["values"][0], first["values"][-1]) == pytest.approx((4 * 3.141592653589793, 30.0))
    assert [column["name"] for column in others] == ["re x", "im x", "re x'", "im x'"]


def test_an_undamped_rate_lags_by_a_right_angle(call):
    code, out, _ = call("frf", SHAKEN, "--of", "y'")
    assert code == 0 and "H = i·k·Ω/(k − m·Ω²)" in out
    code, out, _ = call("frf", SHAKEN)
    assert code == 0 and "at rest (Ω → 0): 1\n" in out


def test_a_start_is_told_with_its_units_and_what_lets_go(call):
    assert "lets go" in call("response", "cut_cable")[1]
    code, out, _ = call("response", SHAKEN + "initial: {y': 0.2 m/s}\n")
    assert code == 0 and "(0) = 0.2 m/s" in out


def test_motion_without_natural_frequencies_is_integrated(call):
    code, out, _ = call("response", PARAMETRIC, "--until", "2")
    assert code == 0 and "the balance of these energies holds to" in out
    code, _, err = call("response", PARAMETRIC.replace("full", "small"), "--until", "2")
    assert code == 4 and "motion: full" in err


def test_symbols_are_named_that_need_values(call):
    code, _, err = call("response", SHAKEN.replace("m: 2 kg, k: 800 N/m", "m: , k: "), "--at", "1")
    assert code == 4 and "give values with --set to m, k" in err


@pytest.mark.parametrize("columns", [40, 55, 119, 120, 121, 300])
def test_a_plot_is_as_wide_as_the_terminal_up_to_a_line_that_can_be_read(call, columns, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(columns))
    lines = call("frf", "forced_vibration", "--plot")[1].splitlines()
    axis = max(i for i, line in enumerate(lines) if "└" in line)
    assert min(columns, 120) - 2 <= max(map(len, lines[axis - 10:])) <= min(columns, 120)


LN, TURN = math.log(1000), 2 * math.pi
STEP, WAVE = "step(t - 3 s)", "sin(2 rad/s*t)"


@pytest.mark.parametrize(("k", "c", "load", "end"), [
    ([100], 0, None, TURN), ([100], 2, None, LN), ([100], 0.002, None, 6 * TURN), ([100], 101, None, LN),
    ([100], 18, None, 2 * TURN / 19**0.5), ([100], -2, None, 10 * TURN / 99**0.5), ([100], -10, None, LN / 5),
    ([100], 0, STEP, 3 + TURN), ([100], 0, WAVE, 5 * TURN), ([100], 2, WAVE, LN), ([100], 4, WAVE, TURN),
    ([100, 121], 0, None, 2 * TURN), ([100, 104], 0, None, 6 * TURN), ([100, 400], 0, None, TURN),
    ([0], 0, STEP, 6), ([0], 0, None, 1), ([0], 2, None, LN / 2), ([0], 2, STEP, 3 + LN / 2)])
def test_a_motion_is_looked_at_as_long_as_the_manual_says(k, c, load, end):
    lines = [f"  b{i}: {{mass: 1 kg, slide: x{i}}}" for i in range(len(k))]
    text = "\n".join(["bodies:", *lines, "springs:", *(f"  s{i}: {{k: {k[i]} N/m, between: [ground, b{i}]}}"
                                                      for i in range(len(k)))])
    text += f"\ndampers: {{d: {{c: {c} N*s/m, between: [ground, b0]}}}}" * bool(c)
    text += f"\nforces: {{F: {{at: b0, force: 5 N*{load}}}}}" * bool(load) + "\ninitial: {x0': 1 m/s}"
    assert problem(text).response.lasting() == pytest.approx(end, rel=1e-2 if c == 0.002 else 1e-12)


@pytest.mark.parametrize(("force", "sign"), [
    ("F/(1 - cos(W*t))", 1), ("F/(cos(W*t) - 1)", -1), ("-F*sin(W*t)", -1), ("F/(1 - step(t - 1 s)*cos(W*t)^2)", 1)])
def test_a_load_that_is_not_defined_where_its_waves_are_one_is_an_input(call, force, sign):
    code, out, _ = call("frf", "parameters: {m: 2 kg, k: 200 N/m, F: 3 N, W: 4 rad/s}\n"
                        "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
                        f"forces: {{f: {{at: b, force: {force}}}}}\n")
    assert code == 0 and f"H = {'−' * (sign < 0)}1/(k − m·Ω²)" in out


def test_a_force_without_a_value_at_the_start_is_refused_in_a_sentence(call):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        code, _, err = call("response", """
parameters: {m: 2 kg, k: 200 N/m, F: 3 N, W: 4 rad/s}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
forces: {f: {at: b, force: F/(1 - cos(W*t))}}
motion: full
""", "--until", "1")
    assert code == 4 and "not defined at t = 0 s" in err and "Warning" not in err


def test_energies_without_a_value_are_refused_in_a_sentence(call):
    code, _, err = call("response", """
parameters: {m: 2 kg, k: 200 N/m, b: 1 mm}
bodies: {b1: {mass: m, slide: x}}
springs: {s: {law: k*b*tan(d/b), between: [ground, b1]}}
initial: {x: 3 mm}
motion: full
""", "--until", "1")
    assert code == 4 and "nan" not in err and "the energies of this motion are not defined" in err


def test_a_free_motion_in_letters_is_that_of_its_coordinate(call):
    scene = "parameters: {m: , k: }\nbodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
    assert call("response", scene, "--of", "x")[0] == 0
    assert call("response", scene, "--of", "z")[0] == 3
    code, _, err = call("response", scene, "--of", "x'")
    assert code == 4 and "found of 'x' alone" in err


@pytest.mark.parametrize("find", ["", "find: [{response: {until: 0.5 s}}]"])
@pytest.mark.parametrize("command", ["animate", "response"])
def test_a_full_motion_in_letters_asks_for_values(call, command, find):
    scene = f"""
parameters: {{m: , k: }}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
initial: {{x: 2 cm}}
motion: full
{find}
"""
    code, _, err = call(command, scene, *(["--response"] if command == "animate" else ["--plot"]))
    assert code == 4 and "numbers" in err and "--set" in err
