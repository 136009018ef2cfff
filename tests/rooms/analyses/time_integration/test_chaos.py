"""What two solutions of one motion do not share is not said: chaotic motions, and starts at unstable places."""

import json
import math
import re

import mpmath
import numpy as np
import pytest
from support.motions import AT_THE_TOP, RESTING, problem

import vibcli
from vibcli.analyses.time_integration import integrate as simulating
from vibcli.analyses.time_integration.integrate import simulate
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.cli.program import run

FAR_UP = """title: Let go from far up
motion: full
parameters: {m: 1 kg, L: 1 m}
gravity: 9.81 m/s^2
bodies:
  upper: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}
  lower: {mass: m, at: [0, -2*L], pin: {at: [0, -L], carrier: upper, by: r}}
initial: {p: 2.5, r: 2.5}
find: [{response: {until: 50 s}}]
"""
# (p, r, p', r') of FAR_UP: the eighth-order rule of Dormand and Prince in 64 bits of mantissa, 800 steps a second;
# those of 400 steps a second agree to the digits given
TRUE = {1: ("0.3835508636920", "-0.379137290295", "-2.358935793723", "-7.966675306615"),
        5: ("-19.665360017703", "0.9928452151867", "-6.2619650107", "1.44294335456"),
        10: ("-19.1318962", "4.42957839", "6.29396214", "-0.36941636"),
        15: ("-19.3894088", "16.0048074", "-0.65007", "-8.27114"),
        19: ("-16.03802", "13.52904", "3.3202", "0.74987")}
DUFFING = """
motion: full
parameters: {m: 1 kg, k: 1 N/m, k3: 1 N/m^3, c: 0.3 N*s/m, F: 0.5 N, w: 1.2 rad/s}
bodies: {b: {mass: m, slide: x}}
springs: {s: {law: -k*d + k3*d^3, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: b, force: F*cos(w*t)}}
initial: {x: 1 m}
"""
BESIDE_THE_TOP = "3.141592"
SPHERES = """
motion: full
parameters: {m: 1 kg, k: 40 N/m, a: 1 m}
bodies: {b: {mass: m, at: [1 m, 0.2 m], move: [x, y, 0]}}
energies: {V: k*x^2*y^2/(2*a^2) + k*(x^2 + y^2)/200}
initial: {x: 0.8 m, y: 0.1 m}
"""


def agrees(text, true):
    """Is a printed number within two units of its last digit?"""
    text = text.replace("−", "-")
    places = len(text.partition(".")[2])
    return abs(float(text) - float(true)) <= 2 * 10.0**-places


@pytest.mark.sweep
def test_every_printed_digit_of_a_chaotic_motion_is_true(scene, capsys):
    file = scene(FAR_UP)
    times = [option for t in (*TRUE, 30) for option in ("--at", str(t))]
    signals = [option for name in ("p", "r", "p'", "r'") for option in ("--of", name)]
    assert run(["response", file, *times, *signals]) == 4
    out, err = capsys.readouterr()
    table = re.search(r"Values\n.*\n((?:.+\n){4})", out)[1].splitlines()
    shown = [[text.rstrip("?") for text in re.split(r" {2,}", line.strip())[1:]] for line in table]
    for i, row in enumerate(shown):
        assert row.pop() == "–"
        for text, true in zip(row, TRUE.values(), strict=True):
            assert agrees(text, true[i]), (text, true[i])
        digits = [len(text.strip("−-").replace(".", "").lstrip("0")) for text in row]
        assert digits[0] >= 11 and digits[-1] <= 6
    assert re.search(r"digits run out at t ≈ 19\.\d+ s: neighbouring motions part e-fold every 0\.\d s; its motion is "
                     r"not known at t = 50 s", err)
    known = float(re.search(r"up to t = (\S+) s, from where", out)[1])
    assert 18 < known < 23
    assert f"Extremes for 0 ≤ t ≤ {known:.4g}"[:24] in out


@pytest.mark.sweep
def test_what_is_not_known_is_refused_by_name(scene, capsys):
    """One answer differs, the others are refused."""
    asked = "{p(5 s): -19.665360017700, p(30 s): 1, max(p): 2.5, rms(p): 2.5}"
    assert run(["check", "--json", scene(FAR_UP + f"answers: {asked}\n")]) == 4
    out, err = capsys.readouterr()
    differs, *refused = json.loads(out)[0]["answers"]
    assert not differs["agrees"] and differs["found"] is not None
    assert [(one["agrees"], one["found"]) for one in refused] == [(False, None)] * 3
    assert "not known at t = 30 s" in err and err.count("not known") >= 2
    known = ("{'max(r)': {value: 20.9472, rtol: 1e-5}, 'argmax(r)': 14.37 s, p(1 s): 0.383550863692, "
             "r(15 s): {value: 16.0048, rtol: 1e-5}}")
    within = FAR_UP.replace("50 s", "16 s") + f"answers: {known}\n"
    assert run(["check", scene(within)]) == 0


@pytest.mark.sweep
def test_extremes_that_floats_do_not_tell_are_found_in_more_digits(scene, capsys):
    """Let go beside the top a pendulum passes the lowest place at K(sin ½φ₀)/√(g/l), with √(2g/l (1 − cos φ₀))."""
    with mpmath.workdps(30):
        start, g = mpmath.mpf(BESIDE_THE_TOP), mpmath.mpf("9.81")
        passes = mpmath.ellipk(mpmath.sin(start / 2)**2) / mpmath.sqrt(g)
        fastest = mpmath.sqrt(2 * g * (1 - mpmath.cos(start)))
        told = f"{{\"argmin(p')\": {mpmath.nstr(passes, 13)} s, \"min(p')\": -{mpmath.nstr(fastest, 13)} rad/s}}"
    text = AT_THE_TOP.replace("p: pi", f"p: {BESIDE_THE_TOP}") + "find: [{response: {until: 5.8 s}}]\n"
    in_floats = vibcli.loads(text)["argmin(p')"]
    assert 1e-11 < abs(in_floats.value - passes) < in_floats.error < 1e-8
    assert run(["check", "--json", scene(f"{text}answers: {told}\n")]) == 0
    for found, exact in zip(json.loads(capsys.readouterr().out)[0]["answers"], (passes, -fastest), strict=True):
        assert abs(found["found"] - exact) <= found["error"] < 1e-13


@pytest.mark.sweep
def test_plots_and_files_end_where_the_motion_ends_to_be_known(scene, capsys, tmp_path):
    file = scene(FAR_UP)
    saved = [tmp_path / f"motion.{kind}" for kind in ("csv", "json", "svg")]
    assert run(["response", file, "--plot", *(word for path in saved for word in ("--save", str(path)))]) == 4
    out = capsys.readouterr().out
    assert re.search(r"known up to t = (\d\d\.\d+) s", out)
    *_, known, end = (row.split(",") for row in saved[0].read_text().splitlines())
    assert 18 < float(known[0]) < 23 and all(known) and float(end[0]) > 23 and not any(end[1:])
    assert all(column["values"][-1] is None for column in json.loads(saved[1].read_text())["columns"][1:])
    assert "known up to t = " in saved[1].read_text()
    assert run(["animate", file, "--response", "-o", str(tmp_path / "motion.html")]) == 0
    assert "0 s to 50 s" not in (tmp_path / "motion.html").read_text()


def test_a_start_at_an_unstable_place_is_known_until_its_last_digit_shows(scene, capsys):
    file = scene(AT_THE_TOP + "find: [{response: {until: 30 s}}]\n")
    assert run(["response", file, "--at", "5"]) == 4
    out, err = capsys.readouterr()
    known = float(re.search(r"not known at t = 30", err) and re.search(r"digits run out at t ≈ (\S+) s", err)[1])
    rate = math.sqrt(9.81)
    assert "e-fold every 0.3 s" in err
    assert 0.7 < known / (math.log(1e-3 / 2.0**-52) / rate) < 1.3
    shown = re.search(r"p \[rad\] +(3\.14\d*)\n", out)[1]
    assert agrees(shown, math.pi) and len(shown) < 12       # it stays there for ever
    assert run(["response", scene(AT_THE_TOP.replace("-L]", "L]").replace("p: pi", "p: 0") +
                                  "find: [{response: {until: 30 s}}]\n")]) == 0


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "until"), [(FAR_UP, 18.0), (DUFFING, 120.0), (AT_THE_TOP, 9.0), (SPHERES, 40.0)],
                         ids=["double pendulum", "driven", "at the top", "two wells"])
def test_a_third_solution_lies_within_the_error_that_is_stated(text, until):
    one = problem(text)
    found = known_motion(one.configuration, until, one.initial.given)
    third = simulate(one.configuration, found.end, rtol=3e-13, initial=one.initial.given)
    for t in np.linspace(0.02, 0.98, 40) * found.end:
        for i in range(len(found.names)):
            def value(trajectory, times, i=i):
                return trajectory.at(times)[0][i]
            error = found.shared.of_signal(value, t)
            off = abs(value(found, [t]) - value(third, [t]))[0]
            assert off <= 30 * error + 1e-13 * np.ptp(value(found, np.linspace(0, found.end, 200))), (t, off, error)


@pytest.mark.sweep
def test_a_motion_whose_energies_do_not_balance_is_refused(scene, capsys, monkeypatch):
    file = scene(FAR_UP.replace("50 s", "5 s"))
    assert run(["response", file]) == 0
    balance = simulating.balance

    def spoilt(*args):
        found = balance(*args)
        size = max(abs(found.energy))
        return found._replace(error=2e-8, work=found.work + 2e-8 * size * np.linspace(0, 1, len(found.work)))

    monkeypatch.setattr(simulating, "balance", spoilt)
    assert run(["response", file]) == 4
    assert "balance to 2e-08 of the largest" in capsys.readouterr().err




@pytest.mark.parametrize("change", [("", ""), ("P: 20", "P: 1e-3"), ("500 N/m", "5e5 N/m"), ("0.2 m]]", "0.3 m]]"),
                                    ("m: 1 kg", "m: 10 kg")])
def test_what_rests_in_equilibrium_rests(change):
    """Nothing in time disturbs it, so that the two solutions differ by rounding alone, and so do its energies."""
    scene = problem(RESTING.replace(*change))
    found = known_motion(scene.configuration, 1.0)
    assert found.end == 1.0 and found.balance.error < 1e-8
    q = found.at(np.linspace(0, 1.0, 50))[0]
    assert np.abs(q - q[:, :1]).max() < 1e-11


@pytest.mark.parametrize(("text", "until"), [(AT_THE_TOP, 14), (FAR_UP.partition("find")[0], 21)],
                         ids=["at the top", "far up"])
def test_digits_that_are_offered_beyond_the_horizon_follow_the_motion(scene, capsys, text, until):
    file, times = scene(text), ["--until", str(until), "--at", str(until)]
    assert run(["response", file, *times]) == 4
    digits = re.search(r"--digits (\d+) carries", capsys.readouterr().err)[1]
    assert run(["response", file, *times, "--digits", digits]) == 0
    assert "–" not in capsys.readouterr().out.partition("Values")[2]
