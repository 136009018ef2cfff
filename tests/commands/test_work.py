"""Long work: counted in steps, told of on a terminal, given up beyond a limit that --patience multiplies."""

import math
import re
from contextlib import suppress

import click
import pytest
from support.scenes import problem

from vibcli.analyses.closed_form import characteristic, many_degrees
from vibcli.analyses.excitation import forcing
from vibcli.analyses.modal import modal_analysis as modes
from vibcli.analyses.time_integration import integrate, pace
from vibcli.analyses.transient import extremes, isolating_intervals, pieces, zeros
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent, Work
from vibcli.cli import COMMANDS, progress
from vibcli.cli.common import require_quick
from vibcli.cli.program import run
from vibcli.mechanics.equilibrium import all_equilibria
from vibcli.results import frequency_response
from vibcli.symbolic.syntax import NameRef

SCENELESS = {"explain", "schema", "new", "grade"}
MOTION = """motion: full
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {law: (10 N/m)*d + (4 N/m^3)*d^3, between: [ground, b]}}
initial: {x: 0.5 m}
find: [{response: {until: 200 s}}]
"""
TWO_PENDULUMS = """bodies:
  a: {mass: 1 kg, at: [0, -1 m], pin: {at: [0, 0], by: p}}
  b: {mass: 1 kg, at: [0, -2 m], pin: {at: [0, -1 m], carrier: a, by: r}}
gravity: 9.81 m/s^2
find: [{equilibria: all}]
"""


def test_steps_count_for_the_tasks_around():
    work = Work()
    with work.task("outer", 10) as outer:
        with work.task("inner", 8) as inner:
            inner.step(steps=3)
            work.step(4)
        assert (inner.steps, outer.steps) == (7, 7)
        with work.task("another", 8) as another:
            another.step(steps=3)
            with pytest.raises(Spent) as spent:
                another.step()
        assert spent.value.task is outer
    assert not work.open
    work.step(1000)


def test_a_search_does_not_swallow_its_own_limit():
    work = Work(patience=2)

    def search():
        with work.task("the search", 10):
            for _ in range(100):
                with suppress(PhysicsError), work.task("a place", 50) as place:
                    place.step()

    with pytest.raises(PhysicsError, match="the search is given up after 20 steps") as refusal:
        search()
    assert "--patience 20" in refusal.value.hint
    assert not work.open


def test_every_command_that_reads_a_scene_has_patience(capsys):
    for command in COMMANDS.keys() - SCENELESS:
        run([command, "--help"])
        assert re.search(r"--patience N", capsys.readouterr().out), command


@pytest.mark.sweep
def test_a_motion_is_kept_up_to_where_it_has_come(scene, capsys, monkeypatch):
    file = scene(MOTION)
    assert run(["response", file, "--at", "2"]) == 0
    whole = capsys.readouterr().out
    monkeypatch.setattr(integrate, "MOST_STEPS", 30)
    assert run(["response", file, "--at", "2"]) == 4
    out, err = capsys.readouterr()
    values = re.search(r"Values.*\n.*\n.*", out)[0]
    assert values in whole
    assert "of at most 30 steps" in err and "--patience 10" in err
    assert run(["response", file, "--at", "2", "--patience", "100"]) == 0
    assert run(["check", scene(MOTION + "answers: {'x(2 s)': 1 m, 'x(199 s)': 0 m}\n")]) == 4
    assert run(["check", scene(MOTION + "answers: {'x(2 s)': 1 m}\n")]) == 1


@pytest.mark.parametrize(("times", "early"), [(18, True), (5, False)])
def test_a_motion_far_beyond_the_limit_is_given_up_early(times, early, monkeypatch):
    """At an even pace: it is known soon how far the limit would bring it."""
    whole = problem(MOTION)
    per_second = len(integrate.simulate(whole.configuration, 20.0, initial=whole.initial.given).windows) / 20
    monkeypatch.setattr(integrate, "MOST_STEPS", 400)
    monkeypatch.setattr(pace, "STEPS", 20)
    found = integrate.simulate(whole.configuration, times * 400 / per_second, initial=whole.initial.given)
    windows = len(found.windows)
    assert windows <= 60 if early else 300 <= windows <= 400


@pytest.mark.sweep
def test_equilibria_are_kept_and_not_called_complete(scene, capsys, monkeypatch):
    monkeypatch.setattr(all_equilibria, "MOST_WORK", 1)
    monkeypatch.setattr(all_equilibria, "LEAST", 10)
    file = scene(TWO_PENDULUMS)
    assert run(["solve", file]) == 0
    assert "cut short" in capsys.readouterr().out
    assert run(["solve", file, "--patience", "1000"]) == 0
    assert "cut short" not in capsys.readouterr().out


LONG = """bodies: {b: {mass: 1 kg, slide: x}, c: {mass: 1 kg, slide: y}}
springs: {s: {k: 100 N/m, between: [ground, b]}, s2: {k: 37 N/m, between: [b, c]}}
initial: {x: 0.5 m}
find: [{response: {until: 300 s}}]
answers: {'max(x)': 0.5 m}
"""


@pytest.mark.parametrize(("quantity", "known"), [
    ("max(y)", r"so far (\S+) at t = \S+ s is the largest \(in SI units\), and none is above it by more than (\S+)"),
    ("min(y)", r"so far (\S+) at t = \S+ s is the smallest \(in SI units\), and none is below it by more than (\S+)"),
    ("period(x)", r"before t = (\S+) s it passes (\d+) times")])
def test_searches_through_linear_motions_tell_what_is_known(monkeypatch, quantity, known):
    sense, name = 1 if quantity.startswith("max") else -1, "x" if quantity == "period(x)" else "y"

    def search(scene):
        signal = scene.response.signal(NameRef(0, 0, name, 0))
        return signal.zeros(0.0, 300.0) if name == "x" else signal.extreme(0.0, 300.0, sense)[1]

    scene, later = problem(LONG), problem(LONG)
    full = search(scene) if name == "x" else None
    for module in (zeros, extremes):
        monkeypatch.setattr(module, "MOST", 2)
    monkeypatch.setattr(isolating_intervals, "BATCH", 1)
    with pytest.raises(PhysicsError) as refused:
        search(scene)
    assert "--patience 10" in refused.value.hint
    first, second = map(float, re.search(known, refused.value.message).groups())
    scene.work.patience = 1000
    found = search(scene)
    if quantity == "period(x)":
        assert len(full[full < first]) == second and 0 < first < 300 and found.tolist() == full.tolist()
    else:
        assert -1e-6 < sense * (found - first) <= second
    later.work.patience = 2
    with pytest.raises(PhysicsError) as refused:
        search(later)
    further, least = map(float, re.search(known, refused.value.message).groups())
    assert further > first if quantity == "period(x)" else least <= second


class Clock:
    now = 0.0

    def __call__(self):
        return self.now


def test_what_is_told_on_a_terminal(capsys, monkeypatch):
    clock = Clock()
    monkeypatch.setattr(progress, "monotonic", clock)
    work = Work(tell=progress.Progress())
    told = []
    with work.task("the integration", 1000) as task:
        for number in range(1, 11):
            clock.now = 2.0 * number
            task.step(number / 40)
            told.append(capsys.readouterr().err)
    assert not told[0]
    assert told[-1].endswith("the integration: 25 % done, 54 s left")
    assert capsys.readouterr().err == "\r\x1b[K"
    with work.task("the search", 100) as task, work.task("the integration", 1000) as inner:
        inner.step(0.9)
        clock.now += 4.0
        inner.step(0.9, 24)
        assert capsys.readouterr().err.endswith("the search: up to 25 % done, at most 12 s left")
    assert task.steps == 25


def test_nothing_is_told_where_there_is_no_terminal():
    assert progress.teller() is None


def test_the_patience_that_many_digits_ask_for_is_enough(tmp_path):
    """The estimate depends on the scene alone; the refusal names the least --patience that passes."""
    n = 60
    text = "bodies:\n" + "".join(f"  b{i}: {{mass: 1 kg, slide: x{i}}}\n" for i in range(n)) + "springs:\n" + "".join(
        f"  s{i}: {{k: 1 N/m, between: [{f'b{i - 1}' if i else 'ground'}, b{i}]}}\n" for i in range(n))
    scene = problem(text)
    for digits in range(5000, 12000, 70):
        scene.work.patience = 1
        with pytest.raises(click.UsageError) as refused:
            require_quick(scene, digits)
        patience = int(re.search(r"--patience (\d+)", refused.value.message)[1])
        scene.work.patience = patience
        require_quick(scene, digits)
        scene.work.patience = patience - 1
        with pytest.raises(click.UsageError):
            require_quick(scene, digits)


OFTEN = "bodies: {b: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 100 N/m, between: [ground, b]}}\ndampers: " \
    "{d: {c: 1 N*s/m, between: [ground, b]}}\nforces: {f: {coordinate: x, value: %s}}\n" \
    "find: [{response: {until: 1 s}}]\n"


@pytest.mark.parametrize("motion", ["small", "full"])
@pytest.mark.parametrize("load", [
    "(1 N)*square((100 rad/s)*t)*(step(t) - step(t - 5 s))", "(1 N)*square((100 rad/s)*t)",
    "(1 N)*(square((100 rad/s)*t) + square((141.42135623730951 rad/s)*t))"])
def test_what_jumps_too_often_is_refused_with_what_is_enough(scene, capsys, monkeypatch, motion, load):
    file = scene(OFTEN % load + f"motion: {motion}\n")
    ask = ["response", file, "--at", "0.9", "--patience"]
    assert run([*ask, "1"]) == 0
    whole = capsys.readouterr().out
    monkeypatch.setattr(forcing, "MOST", 10)
    assert run([*ask, "1"]) == 4
    err = capsys.readouterr().err
    assert "jumps or bends too often" in err and "stretches of time, and 10 are the most" in err
    assert run([*ask, re.search(r"--patience (\d+) allows twice", err)[1]]) == 0
    assert capsys.readouterr().out == whole


LETTERS = """parameters: {m: {unit: kg}, M: {unit: kg}, k: {unit: N/m}, K: {unit: N/m}}
bodies: {b: {mass: m, slide: x}, c: {mass: M, slide: y}}
springs: {s: {k: k, between: [ground, b]}, s2: {k: K, between: [b, c]}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("command", ["solve", "frequencies"])
def test_closed_forms_that_are_given_up_are_said_to_be(scene, capsys, monkeypatch, command):
    file = scene(LETTERS)
    assert run([command, file]) == 0
    whole = capsys.readouterr().out
    monkeypatch.setattr(many_degrees, "CALLS", 1)
    monkeypatch.setattr(characteristic, "CALLS", 1)
    assert run([command, file]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "before the search was given up; --patience 10 lets" in said
    assert run([command, file, "--patience", "1000000"]) == 0
    assert capsys.readouterr().out == whole


DRIVEN = """bodies: {b: {mass: 1 kg, slide: x}, c: {mass: 1 kg, slide: y}}
springs: {s: {k: 100 N/m, between: [ground, b]}, s2: {k: 37 N/m, between: [b, c]}}
dampers: {d: {c: 1 N*s/m, between: [b, c]}}
forces: {f: {coordinate: x, value: (1 N)*square((20 rad/s)*t)}}
find: [{frequency_response: {of: [x], to: f}}, {response: {until: 2 s}}]
"""


@pytest.mark.parametrize(("room", "command"), [
    (pieces, ["response", "--at", "1.5"]), (pieces, ["animate", "--response", "-o", "a.html"]),
    (pieces, ["check"]), (frequency_response, ["frf"]), (frequency_response, ["frf", "--save", "a.csv"]),
    (modes, ["solve"]),
    (modes, ["frequencies"]), (modes, ["draw", "--mode", "1", "-o", "a.svg"]), (modes, ["animate", "-o", "a.html"])],
    ids=lambda part: str(part)[-20:])
def test_each_command_stops_at_its_limit_and_goes_on_with_patience(tmp_path, monkeypatch, capsys, room, command):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.yaml").write_text(DRIVEN + "answers: {'x(1 s)': 1 m}\n" * (command == ["check"]))
    monkeypatch.setattr(room, "MOST", 1e-7)
    name, *options = command
    assert run([name, "scene.yaml", *options]) == 4
    out, err = capsys.readouterr()
    assert re.search(r"(the motion|the search|the curve).* is given up after 0 steps", out + err)
    assert "--patience 10 allows" in out + err
    assert run([name, "scene.yaml", *options, "--patience", "1000000"]) == (name == "check")


@pytest.mark.sweep
def test_the_largest_value_of_a_slow_resonance_is_found_soon(tmp_path, monkeypatch, capsys):
    """Of a billion seconds: x = (1 − e^{−ct/2})/c sin t but for parts of 1e-9."""
    monkeypatch.setattr(extremes, "MOST", 1500)
    path = tmp_path / "slow.yaml"
    path.write_text("bodies: {a: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 1 N/m, between: [ground, a]}}\n"
                    "dampers: {d: {c: 2e-11 N*s/m, between: [ground, a]}}\nforces: {f: {at: a, force: 1 N*cos(1 rad/s*t"
                    ")}}\nfind: [{response: {until: 1e9 s}}]\n"
                    f"answers: {{max(x): {{value: {-math.expm1(-0.01) / 2e-11!r} m, rtol: 1e-5}}}}\n")
    assert run(["check", str(path), "--no-cache"]) == 0, capsys.readouterr()
