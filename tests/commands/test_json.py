"""--json and --set: the documented keys and no others, SI numbers or strings, null for nothing, never NaN."""

import cmath
import json
import math
from decimal import Decimal
from pathlib import Path

import pytest
from support.motions import DOUBLE
from support.scenes import kept_problem_of

from vibcli.cli import common
from vibcli.cli.program import run

PROBLEMS = sorted((Path(__file__).parents[2] / "problems").glob("*/*.yaml"))
EQUATIONS = ["coordinate", "text", "latex", "linear_text", "linear_latex", "left_out"]
EQUILIBRIUM = ["coordinates", "dependent", "from_start", "stable", "residual", "condition", "warning", "of_members"]
MATRICES = ["M", "C", "G", "K"]
MODE = ["index", "omega", "frequency", "period", "growth_rate", "shape", "error"]
DAMPED = ["index", "eigenvalue", "omega", "zeta", "omega_d", "omega_d_where", "decay", "growth_rate", "shape",
          "error"]
FREQUENCIES = {"title", "coordinates", "equilibrium", "matrices", "modes", "damped"}
KEYS = {"solve": FREQUENCIES | {"energies", "equations"}, "frequencies": FREQUENCIES,
        "equations": {"title", "coordinates", "energies", "equations", "matrices"}}
PRESCRIBED = ("pump_turned_by_a_motor",)             # nothing moves freely: answers ask its motion in time
STATICS = {"title", "coordinates", "reactions"}     # of a scene without freedom

SCENE = """
title: Two cars
parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [a, b]}}
dampers: {d: {c: c, between: [a, b]}}
"""
CREEPING = """
parameters: {L: 1 m, EI: 20 N*m^2, mu: 1 kg/m, F: 1 N}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, attached: [{at: L/2, c: 2 N*s/m}]}}
points: {p: {body: arm, at: L}}
forces: {f: {at: p, force: F}}
damping: {caughey: {1: 1 %, 2: 2 %, 3: 8 %}}
"""
SYMBOLS = SCENE.replace("m: 2 kg, k: 800 N/m, c: 3 N*s/m", "m: , k: , c: ")
UPRIGHT = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}}
"""


def refuse(constant):
    raise AssertionError(f"{constant} in JSON")


@pytest.fixture
def ask(tmp_path, capsys):
    """ask(text or path, command, options…) -> the object printed with --json."""
    def asked(scene, command="solve", *options, code=0):
        path = scene
        if not isinstance(scene, Path):
            path = tmp_path / "scene.yaml"
            path.write_text(scene)
        capsys.readouterr()
        assert run([command, str(path), "--json", *options]) == code
        out = capsys.readouterr().out
        return json.loads(out, parse_constant=refuse) if out else None
    return asked


def numbers(data):
    """Every number within a JSON value."""
    if isinstance(data, dict):
        return [x for value in data.values() for x in numbers(value)]
    if isinstance(data, list):
        return [x for value in data for x in numbers(value)]
    return [data] if isinstance(data, float) else []


def well_formed(data, command):
    optional = {"accelerations", "backbone", "cases", "certificate", "characteristic_polynomial", "chosen",
                "closed_forms", "count", "equilibria", "equivalents", "expansion", "frequency_response", "insight",
                "phase_plane", "remark", "response", "search", "sticking"}
    if not data["coordinates"] and not data.get("modes"):
        assert set(data) - {"certificate"} == STATICS and data["reactions"]
        return
    assert set(data) - optional == KEYS[command]
    n = len(data["coordinates"])
    assert all(list(entry) == EQUATIONS for entry in data.get("equations") or ())
    assert all(math.isfinite(x) for x in numbers(data))
    inertless = "count" not in data and not any((data["matrices"] or {}).get(name) for name in "MC")
    assert ("remark" in data) == ("equilibrium" in data and inertless)      # with C alone it creeps
    if "equilibrium" in data and data["equilibrium"] is None:
        return
    if "equilibrium" in data:
        assert list(data["equilibrium"]) == EQUILIBRIUM
        assert set(data["equilibrium"]["coordinates"]) == set(data["coordinates"])
        members = ["members"] if "count" in data else []
        for keys, modes in (([*MODE, *members], data["modes"]), (DAMPED, data["damped"])):
            assert all(set(mode) == set(keys) for mode in modes or ())
            assert all(set(mode["shape"]) == set(data["coordinates"]) for mode in modes or () if mode["shape"])
    if data["matrices"] is None:        # members with inertia have none, nor has what a kink holds
        assert "remark" in data or (data["equations"] is None and data["count"] >= len(data["modes"]))
        return
    assert list(data["matrices"]) == MATRICES
    assert all(len(rows) == n and all(len(row) == n for row in rows) for rows in data["matrices"].values() if rows)


def test_responses(ask):
    driven = SCENE + "forces: {f: {at: a, force: (3 N)*sin((5 rad/s)*t)}}\ninitial: {y: 2 cm, y': 0.1 m/s}\n"
    data = ask(driven, "response", "--of", "y - x", "--until", "0.5")
    assert set(data) == {"title", "coordinates", "response", "certificate"}
    assert data["certificate"]["force_balance"] <= 20 and 0 <= data["certificate"]["energy_balance"] <= 1e-14
    assert {key: data["response"][key] for key in ("until", "initial", "balance")} == {
        "until": 0.5, "initial": {"x": 0.0, "y": 0.02, "x'": 0.0, "y'": 0.1}, "balance": None}
    stretch, = data["response"]["signals"]
    assert list(stretch) == ["signal", "unit", "max", "max_error", "argmax", "min", "min_error", "argmin", "no_bound",
                             "steady", "at", "fronts", "estimated"]
    assert (stretch["signal"], stretch["unit"], stretch["fronts"]) == ("y - x", "m", [])
    assert stretch["min"] < 0 < stretch["max"] and 0 <= stretch["argmin"] <= 0.5
    wave, = stretch["steady"]
    H = -1.5 / (800 - 25 + 3j * 5)          # relative motion z'' + 2 c/m z' + 2 k/m z = −f/m
    assert wave["Omega"] == pytest.approx(5.0)
    assert wave["amplitude"] == pytest.approx(abs(H), rel=1e-12)
    assert wave["phase"] == pytest.approx(-cmath.phase(H), rel=1e-12)


@pytest.mark.parametrize("until", ["0.74", "0.3", "1.1", "2"])
def test_the_last_instant_of_a_full_motion_has_a_value(ask, capsys, tmp_path, until):
    """Its end is a float, and the instants that are asked for are exact."""
    text = ("parameters: {m: 2 kg, k: 100 N/m}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {law: 'k*d + (10 N/m^3)*d^3', between: [ground, b]}}\nmotion: full\ninitial: {x: 0.1 m}\n"
            f"find: [{{response: {{until: {until} s}}}}]\n")
    data, = ask(text, "response", "--at", until)["response"]["signals"]
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    assert run(["response", str(path), "--at", until]) == 0
    printed = capsys.readouterr().out.split("Values")[1].splitlines()[2].split()[-1].replace("−", "-")
    assert float(printed) == pytest.approx(data["at"][0]["value"], rel=1e-9)


def test_small_motions_are_told_beyond_the_end_at_which_they_are_looked_at(ask, capsys, tmp_path):
    text = ("parameters: {m: 2 kg, k: 800 N/m}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {k: k, between: [ground, b]}}\ninitial: {x: 0.1 m}\n")
    data, = ask(text, "response", "--until", "1", "--at", "30")["response"]["signals"]
    told, = data["at"]
    assert told["t"] == 30 and abs(told["value"] - 0.1 * math.cos(600)) <= told["error"] <= 1e-9
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    assert run(["response", str(path), "--until", "1", "--at", "30"]) == 0
    assert "-0.09990234788" in capsys.readouterr().out.split("Values")[1]


def test_values_at_instants(ask):
    data, = ask(SCENE + "initial: {y': 0.1 m/s}\n", "response", "--of", "x + y", "--at", "0.5", "--at", "80 ms",
                "--until", "0.1")["response"]["signals"]
    assert [one["t"] for one in data["at"]] == [0.5, 0.08]
    assert [one["value"] for one in data["at"]] == pytest.approx([0.05, 0.008], rel=1e-12)      # nothing holds them
    digits, = ask(SCENE + "initial: {x': 1 m/s, y': 1 m/s}\n", "response", "--of", "y", "--at", "0.1", "--digits",
                  "20")["response"]["signals"]
    assert digits["at"] == [{"t": 0.1, "value": "0.10000000000000000000", "error": None, "no_bound": None}]
    driven = "bodies: {a: {mass: 2 kg, slide: 1 m*cos(2 rad/s*t)}}\n"
    prescribed = ask(driven, "response", "--of", "T", "--at", "0.7", "--json")["response"]
    assert prescribed["until"] is None
    assert prescribed["signals"][0]["at"][0]["value"] == pytest.approx(4 * math.sin(1.4) ** 2, rel=1e-12)


def test_frequency_responses(ask):
    data = ask(SCENE, "frf", "--of", "s.stretch", "--of", "x", "--to", "y")
    assert set(data) == {"title", "coordinates", "frequency_response", "certificate"}
    stretch, x = data["frequency_response"]
    assert (stretch["signal"], stretch["input"], stretch["unit"]) == ("s.stretch", "y", "m/N")
    peak, = stretch["peaks"]
    assert list(peak) == ["Omega", "value", "quality"]
    assert peak["Omega"] == pytest.approx(math.sqrt(800 - 2 * 1.5**2), rel=1e-12)
    assert peak["value"] == pytest.approx(0.5 / (3 * math.sqrt(800 - 1.5**2)), rel=1e-12)
    assert peak["quality"] == pytest.approx(math.sqrt(800) / 3, rel=1e-2)
    assert stretch["antiresonances"] == [] and x["signal"] == "x"
    assert stretch["peaks_counted"] and stretch["antiresonances_counted"]


@pytest.mark.sweep
def test_frequency_responses_that_are_not_counted(ask):
    creeping, = ask(CREEPING, "frf", "--of", "arm.u(L)")["frequency_response"]
    assert creeping["peaks_counted"] and not creeping["antiresonances_counted"]


@pytest.mark.parametrize("asked, key", [("{response: {until: 2 s}}", "response"),
                                        ("{frequency_response: {to: f}}", "frequency_response")])
@pytest.mark.parametrize("force", ["F*sin(W*t)", "F*sin(W*sqrt(k/m)*t)"])
def test_responses_that_find_asks_of_a_scene_in_letters(ask, asked, key, force):
    loaded = f"forces: {{f: {{at: a, force: {force}}}}}\nfind: [equations, {asked}]\n"
    text = SYMBOLS.replace("c: }", "c: , F: , W: }") + loaded
    data = ask(text)
    well_formed(data, "solve")
    assert data[key] is None
    rate = "W: 1" if "sqrt" in force else "W: 3 rad/s"
    assert ask(SCENE.replace("s/m}", f"s/m, F: 1 N, {rate}}}") + loaded)[key]


@pytest.mark.parametrize("command", KEYS)
@pytest.mark.parametrize("text", [SCENE, SYMBOLS, UPRIGHT], ids=["numbers", "symbols", "unstable"])
def test_keys(ask, command, text):
    well_formed(ask(text, command), command)


@pytest.mark.sweep
@pytest.mark.parametrize("path", [path for path in PROBLEMS[::3] if path.stem not in PRESCRIBED],
                         ids=lambda path: path.stem)
def test_every_problem_is_well_formed(ask, path, monkeypatch):
    monkeypatch.setattr(common, "problem_in", lambda source, settings, patience: kept_problem_of(path))
    data = ask(path)
    well_formed(data, "solve")
    for case in data.get("cases", {}).values():
        well_formed(case, "solve")


@pytest.mark.parametrize("path", [path for path in PROBLEMS if path.stem in PRESCRIBED], ids=lambda path: path.stem)
def test_what_is_driven_alone_has_its_energies_and_equations(ask, path):
    data = ask(path)
    assert set(data) - {"cases"} == KEYS["equations"] and data["coordinates"] == [] and data["matrices"] is None
    assert [entry["coordinate"] for entry in data["equations"]] == ["psi", "x"]


def test_numbers(ask):
    data = ask(SCENE)
    assert data["title"] == "Two cars"
    assert data["coordinates"] == ["x", "y"]
    assert data["equilibrium"] == {"coordinates": {"x": 0.0, "y": 0.0}, "dependent": {}, "from_start": None,
                                   "stable": True, "residual": 0.0, "condition": 1.0, "warning": None,
                                   "of_members": []}
    assert data["matrices"] == {"M": [[2.0, 0.0], [0.0, 2.0]], "C": [[3.0, -3.0], [-3.0, 3.0]], "G": None,
                                "K": [[800.0, -800.0], [-800.0, 800.0]]}
    rigid, elastic = data["modes"]
    assert (rigid["omega"], rigid["frequency"], rigid["period"], rigid["growth_rate"]) == (0.0, 0.0, None, None)
    assert rigid["shape"] == {"x": 1.0, "y": 1.0}
    assert elastic["omega"] == pytest.approx(math.sqrt(800), rel=1e-14)
    assert elastic["frequency"] * elastic["period"] == pytest.approx(1.0, rel=1e-14)
    assert elastic["shape"] == {"x": 1.0, "y": pytest.approx(-1.0)}
    assert 0 <= elastic["error"] < 1e-13
    last = data["damped"][-1]
    assert last["eigenvalue"] == pytest.approx([-1.5, math.sqrt(800 - 2.25)], rel=1e-13)
    assert last["zeta"] == pytest.approx(1.5 / math.sqrt(800), rel=1e-13)
    assert last["omega_d"] == pytest.approx(math.sqrt(800 - 2.25), rel=1e-13)


def test_symbols_are_strings(ask):
    data = ask(SYMBOLS)
    assert data["equilibrium"]["coordinates"] == {"x": "0", "y": "0"}
    assert data["matrices"]["K"] == [["k", "-k"], ["-k", "k"]]
    assert data["modes"][1]["omega"].replace(" ", "") in ("sqrt(2)*sqrt(k)/sqrt(m)", "sqrt(2*k/m)", "sqrt(2*k)/sqrt(m)")
    assert not numbers({key: data[key] for key in ("equilibrium", "matrices", "equations")})


@pytest.mark.parametrize("law", ["k*d + F*sin(d/L)", "k*d + F*exp(d/L)"])
def test_what_is_not_found_in_letters_is_null_beside_the_equations_and_refused_alone(ask, law):
    text = ("parameters: {m: , k: , F: , g: , L: }\ngravity: g\n"
            "bodies: {b: {mass: m, at: [0, -L], slide: {along: [0, -1], by: x}}}\n"
            f"springs: {{s: {{law: {law}, between: [[0, 0], b]}}}}\n")
    whole, alone = ask(text), ask(text, "equations")
    well_formed(whole, "solve")
    assert whole["modes"] is whole["matrices"] is None and "in letters" in whole["remark"]
    assert whole["equations"] == alone["equations"] and whole["equations"][0]["text"]
    assert ask(text, "frequencies", code=4) is None


def test_undamped_and_unstable(ask):
    data = ask(UPRIGHT)
    assert data["damped"] is None
    assert data["equilibrium"]["stable"] is False
    mode, = data["modes"]
    assert (mode["omega"], mode["frequency"], mode["period"]) == (None, None, None)
    assert mode["growth_rate"] == pytest.approx(math.sqrt(9.81 / 0.5), rel=1e-14)


@pytest.mark.parametrize("digits", [5, 30, 60])
def test_digits_are_strings(ask, digits):
    data = ask(SCENE, "frequencies", "--digits", str(digits))
    omega = data["modes"][1]["omega"]
    assert isinstance(omega, str)
    assert len(omega.replace(".", "").lstrip("0")) >= digits
    exact = Decimal(800).sqrt() if digits < 28 else root(800, digits + 10)
    assert abs(Decimal(omega) / exact - 1) < Decimal(10) ** (1 - digits)
    assert isinstance(data["damped"][-1]["eigenvalue"][1], str)


def root(value, digits):
    import mpmath

    with mpmath.workdps(digits):
        return Decimal(mpmath.nstr(mpmath.sqrt(value), digits))


@pytest.mark.parametrize("setting, stiffness", [
    ("k=200", 200.0), ("k=0.2 N/mm", 200.0), ("k=2e2", 200.0), ("k=200 N/m", 200.0)])
def test_set(ask, setting, stiffness):
    assert ask(SCENE, "frequencies", "--set", setting)["matrices"]["K"][0][0] == stiffness


def test_a_bare_number_takes_the_unit_of_the_file(ask):
    text = SCENE.replace("800 N/m", "0.8 kN/m")
    assert ask(text, "frequencies", "--set", "k=2")["matrices"]["K"][0][0] == 2000.0
    assert ask(text, "frequencies", "--set", "k=2 N/m")["matrices"]["K"][0][0] == 2.0
    assert ask(SYMBOLS, "frequencies", "--set", "k=2", "--set", "m=1", "--set", "c=0")["matrices"]["K"][0][0] == 2.0


def test_negative_settings(ask):
    assert ask(SCENE, "frequencies", "--set", "c=-3")["matrices"]["C"][0][0] == -3.0


@pytest.mark.parametrize("setting, code", [
    ("q=3", 2), ("k", 2), ("k=", 2), ("=3", 2), ("k=3 kg", 3), ("k=3 N/mmm", 3), ("k=(", 2)])
def test_wrong_settings(ask, setting, code):
    ask(SCENE, "frequencies", "--set", setting, code=code)


def test_cases(ask):
    data = ask(SCENE + "cases:\n  soft: {parameters: {k: 200 N/m}}\n")
    assert data["cases"]["soft"]["matrices"]["K"][0][0] == 200.0
    assert data["matrices"]["K"][0][0] == 800.0
    alone = ask(SCENE + "cases:\n  soft: {parameters: {k: 200 N/m}}\n", "solve", "--case", "soft")
    assert alone["matrices"]["K"][0][0] == 200.0


@pytest.mark.parametrize("command", KEYS)
def test_nothing_is_printed_where_there_is_no_answer(ask, command):
    assert ask("bodies: {b: {mass: 1 kg, at: [0, 0]}}", command, code=4) is None
    assert ask("bodies: {b: {mass: 1 kg, wrong: 3}}", command, code=3) is None


CHAOS = DOUBLE + "motion: full\ninitial: {p: 3 rad, r: 2 rad}\n"


@pytest.mark.sweep
def test_a_motion_that_is_known_in_part_is_given_as_far_as_it_is_known(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(CHAOS)
    assert run(["response", str(path), "--json", "--until", "60", "--at", "10", "--at", "40"]) == 4
    out, err = capsys.readouterr()
    found = json.loads(out)["response"]
    assert 10 < found["until"] < 40 and found["unknown"] in err
    assert "its motion is not known at t = 60 s" in found["unknown"]
    for signal in found["signals"]:
        early, late = signal["at"]
        assert early["value"] is not None and late["value"] is None
        assert signal["argmax"] <= found["until"] and signal["argmin"] <= found["until"]
    assert run(["response", str(path), "--json", "--until", "2"]) == 0
    assert json.loads(capsys.readouterr().out)["response"]["unknown"] is None


def test_digits_are_not_passed_over_in_letters(tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(SYMBOLS, encoding="utf-8")
    for options in ((), ("--json",)):
        assert run(["solve", str(file), "--digits", "15", *options]) == 4
        assert "--digits needs numbers" in capsys.readouterr().err


def test_nothing_has_insight_without_inertia(tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(SCENE.replace("m: 2 kg", "m: 0 kg").replace("x}", "x}, w: {slide: z}"), encoding="utf-8")
    codes = [run(["solve", str(file), "--insight", *options]) for options in ((), ("--json",))]
    assert len(set(codes)) == 1, capsys.readouterr()
