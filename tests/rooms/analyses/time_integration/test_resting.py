"""A start in equilibrium, at rest, is a solution: it stays there to the last digit, until something acts on it."""

import math

import numpy as np
import pytest
from support.motions import AT_THE_TOP, RESTING, problem

from vibcli.analyses.time_integration import integrate as simulating
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.cli.program import run

HANGING = """
motion: full
parameters: {{m: 2 kg, k: 300 N/m, F: 5 N, P: 2 N*s, w: 7 rad/s}}
gravity: 9.81 m/s^2
bodies: {{b: {{mass: m, at: [0, 0], slide: {{along: [0, 1], by: x}}}}}}
springs: {{s: {{k: k, between: [[0, 1 m], b], free_length: 1 m}}}}
forces: {{f: {{at: b, force: [0, {}]}}}}
"""
UNUSED = {"F: 5 N": "F: {value: 5 N, unused: allowed}", "P: 2 N*s": "P: {value: 2 N*s, unused: allowed}",
          "w: 7 rad/s": "w: {value: 7 rad/s, unused: allowed}"}


def hanging(force, more=""):
    text = HANGING.format(force) + more
    for short, long in UNUSED.items():
        text = text.replace(short, long)
    return problem(text)


@pytest.mark.parametrize("mass", ["1e-3 kg", "1e3 kg", "2e4 kg"])
@pytest.mark.parametrize("k", ["5 N/m", "5e5 N/m"])
@pytest.mark.parametrize("height", ["0.8 m", "80 m"])
def test_a_plate_on_a_line_rests_whatever_it_weighs(mass, k, height):
    scene = problem(RESTING.replace("m: 1 kg", "m: " + mass).replace("500 N/m", k).replace("0.8 m", height))
    found = known_motion(scene.configuration, 50.0)
    q, v, a = found.at(np.linspace(0, 50, 30))
    assert (q == q[:, :1]).all() and not v.any() and not a.any()
    assert (found.end, found.rests, found.balance.error, found.shared.error.max() < 1e-9) == (50.0, 50.0, 0.0, True)
    assert dict(zip(found.names, q[:, 0], strict=True)) == scene.configuration.equilibrium.values


@pytest.mark.parametrize("text", ["{p: pi}", "{p: 3*pi}"])
def test_at_the_top_it_stays_where_that_is_the_equilibrium_that_is_named(text):
    one = problem(AT_THE_TOP.replace("initial: {p: pi}", f"equilibrium: {text}"))
    found = known_motion(one.configuration, 30.0, one.initial.given)
    assert found.end == 30.0 and np.ptp(found.at(np.linspace(0, 30, 50))[0]) == 0.0


# x − x₀ of each force that begins at t₁, m ẍ + k x = F(t): by hand
BEGINS = {"P*impulse(t - 0.3 s)": lambda t, m, w0: 2 / (m * w0) * np.sin(w0 * t),
          "F*step(t - 0.3 s)": lambda t, m, w0: 5 / (m * w0**2) * (1 - np.cos(w0 * t)),
          "F*step(t - 0.3 s)*sin(w*(t - 0.3 s))": lambda t, m, w0: 5 / m / (w0**2 - 49) * (
              np.sin(7 * t) - 7 / w0 * np.sin(w0 * t)),
          "P*impulse(t - 0.3 s)*cos(w*t)": lambda t, m, w0: 2 * math.cos(2.1) / (m * w0) * np.sin(w0 * t)}


@pytest.mark.parametrize("force", BEGINS)
def test_it_rests_to_the_last_digit_until_a_force_begins(force):
    found, w0 = known_motion(hanging(force).configuration, 2.0), math.sqrt(150)
    assert found.rests == pytest.approx(0.3, rel=1e-15) and found.end == 2.0
    before, after = np.linspace(0, 0.3 * (1 - 1e-15), 20), np.linspace(0.31, 2, 40)
    q, v, _ = found.at(before)
    assert (q == q[0, 0]).all() and not v.any()
    assert np.abs(found.at(after)[0][0] - q[0, 0] - BEGINS[force](after - 0.3, 2.0, w0)).max() < 3e-14
    assert [event.kind for event in found.events] == ["impulse"] * ("impulse" in force)


@pytest.mark.parametrize("force", ["F*(1 - step(t - 1 s))", "F*step(t + 1 s)", "F*step(1 s - t)", "F*sin(w*t)^8",
                                   "1e-9*F*cos(w*t)", "F*square(w*t)", "P*impulse(t)", "F*t/(1 s)"])
def test_what_acts_from_the_start_moves_it(force):
    found = known_motion(hanging(force).configuration, 0.5)
    assert found.rests == 0.0 and np.ptp(found.at(np.linspace(0, 0.5, 40))[0]) > 1e-12


@pytest.mark.parametrize("initial", ["{x: 0}", "{x': 1e-9 m/s}"])
def test_what_is_let_go_elsewhere_moves(initial):
    one = hanging("0*F", f"initial: {initial}\n")
    found = known_motion(one.configuration, 1.0, one.initial.given)
    assert found.rests == 0.0 and np.ptp(found.at(np.linspace(0, 1, 40))[0]) > 1e-11


CRANK = """
motion: full
parameters: {k: 90 N/m, c: 2 N*s/m, w: 40 rad/s}
bodies:
  crank: {shape: rod, mass: 3 kg, from: [0, 0], to: [0.2 m, 0], pin: {at: [0, 0], by: w*t}}
  b: {mass: 1 kg, at: [1 m, 0], slide: {along: [1, 0], by: x}}
  c: {mass: 1 kg, at: [2 m, 0], slide: {along: [1, 0], by: 0.1*k*0.1 m^2/N*sin(w*t)}}
springs: {s: {k: k, between: [[0.5 m, 0], b]}}
dampers: {d: {c: c, between: [[3 m, 0], c]}}
points: {P: {body: crank, at: [0.2 m, 0]}}
"""


def test_a_block_that_rests_beside_what_is_driven_does_not_hide_its_motion():
    one = problem(CRANK)
    found = known_motion(one.configuration, 2.0)
    assert found.rests == 0.0 and not found.at(np.linspace(0, 2, 50))[0].any()
    t = found.balance.times[-1]
    dissipated = 2 * (0.9 * 40) ** 2 * (t / 2 + math.sin(2 * 40 * t) / (4 * 40))
    assert found.balance.dissipated[-1] == pytest.approx(dissipated, rel=1e-9)
    assert max(found.lengths) < 1.0


@pytest.mark.sweep
@pytest.mark.parametrize("until", [20.0, 60.0])
def test_windows_resolve_what_is_driven_and_felt_by_nothing(until):
    found = known_motion(problem(CRANK).configuration, until)
    t = found.balance.times[-1]
    dissipated = 2 * (0.9 * 40) ** 2 * (t / 2 + math.sin(2 * 40 * t) / (4 * 40))
    assert found.end == until and found.balance.dissipated[-1] == pytest.approx(dissipated, rel=1e-9)
    moving = known_motion(problem(CRANK + "initial: {x: 0.1 m}\n").configuration, 20.0, {"x": 0.1})
    assert moving.balance.error < 1e-11
    assert moving.at([20.0])[0][0, 0] == pytest.approx(0.1 * math.cos(20 * math.sqrt(90)), rel=1e-9)


@pytest.mark.parametrize("drive", ["abs(sin(w*t))", "sawtooth(w*t)*sin(w*t)^2", "(w*t - 4)*step(w*t - 4)"])
def test_windows_end_where_what_is_felt_by_nothing_turns_at_another_speed(drive):
    text = CRANK.replace("0.1*k*0.1 m^2/N*sin(w*t)", f'"0.1*k*0.1 m^2/N*({drive})"')
    found = known_motion(problem(text + "initial: {x: 0.1 m}\n").configuration, 3.0, {"x": 0.1})
    assert found.end == 3.0 and found.balance.error < 1e-11


@pytest.mark.sweep
def test_what_rests_costs_no_step_and_is_told(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(simulating, "MOST_STEPS", 0)
    path = tmp_path / "rests.yaml"
    text = RESTING.replace("m: 1 kg", "m: 1e3 kg")
    path.write_text(f"title: It rests\n{text}find: [{{response: {{until: 10 s}}}}]\n")
    assert run(["response", str(path)]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "it starts at rest where its forces balance, and nothing acts on it in time: there it stays" in out
    assert "second solution" not in out and "balance of" not in out
    path.write_text(path.read_text() + "answers: {period(x): 1 s}\n")
    assert run(["check", str(path)]) != 0
    assert "the scene is at rest: its motion has no period" in capsys.readouterr().err


@pytest.mark.sweep
@pytest.mark.parametrize("off", [1e-15, 1e-13, 1e-12, 1e-9])
@pytest.mark.parametrize(("mass", "k", "height"), [("1e3 kg", "500 N/m", "0.8 m"), ("1 kg", "50 N/m", "800 m"),
                                                   ("1e4 kg", "5e3 N/m", "800 m"), ("1e6 kg", "5e5 N/m", "0.8 m")])
def test_a_start_beside_a_stable_equilibrium_is_not_chaotic(mass, k, height, off):
    scene = problem(RESTING.replace("m: 1 kg", "m: " + mass).replace("500 N/m", k).replace("0.8 m", height))
    rest = scene.configuration.equilibrium.values
    found = known_motion(scene.configuration, 3.0, {name: value + off for name, value in rest.items()})
    assert (found.end, found.rests) == (3.0, 0.0)
    away = found.at(np.linspace(0, 3, 60))[0] - np.array(list(rest.values()))[:, None]
    assert np.abs(away).max() < 3 * off + 1e-13


def test_friction_holds_a_block_where_it_is_put_to_the_last_digit():
    text = """
motion: full
parameters: {m: 2 kg, k: 30 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {friction: 3 N, breakaway: 4 N, between: [ground, b]}}
initial: {x: START}
"""
    held, gone = (problem(text.replace("START", start)) for start in ("0.13 m", "0.14 m"))
    found = known_motion(held.configuration, 30.0, held.initial.given)
    assert found.rests == 30.0 and (found.at(np.linspace(0, 30, 9))[0] == 0.13).all()
    moved = known_motion(gone.configuration, 0.1, gone.initial.given)
    assert moved.rests == 0.0 and np.ptp(moved.at([0.0, 0.1])[0]) > 1e-4
