"""How accurately a motion is integrated can be asked: less is sooner found, and what is asked holds or is refused."""

import json

import mpmath
import numpy as np
import pytest
from support.motions import DOUBLE, PENDULUM, problem

import vibcli
from vibcli.analyses.time_integration import integrate
from vibcli.analyses.time_integration import known_motion as known_motions
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.analyses.time_integration.refined_windows import RefinedWindows
from vibcli.analyses.time_integration.time_stepping import March
from vibcli.bench.asked_motions import links
from vibcli.bench.trajectories import AT_100
from vibcli.cli.program import run

SWINGING = "motion: full\n" + DOUBLE + "initial: {p: 0.3, r: 0.5}\nfind: [{response: {until: 100 s}}]\n"
FAR_UP = SWINGING.replace("p: 0.3, r: 0.5", "p: 2.5, r: 2.5").replace("100 s", "25 s")
SMALL = "bodies: {b: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 3 N/m, between: [ground, b]}}\ninitial: {x: 1 m}\n"
ASKED = (1e-4, 1e-6, 1e-9, 1e-11)


@pytest.fixture
def counts(monkeypatch):
    """{what: how often it was done}: windows by collocation, steps that guess others."""
    found, advance, init = {}, March.advance, RefinedWindows.__init__

    def counted(what, function):
        def counting(*args):
            found[what] = found.get(what, 0) + 1
            return function(*args)
        return counting

    def made(self, *args):
        init(self, *args)
        self.step = counted("steps", self.step)

    monkeypatch.setattr(March, "advance", counted("windows", advance))
    monkeypatch.setattr(RefinedWindows, "__init__", made)
    return found


@pytest.mark.sweep
def test_what_is_asked_holds_and_less_is_less_work(counts):
    one, spent = problem(SWINGING), []
    for asked in ASKED:
        counts.clear()
        found = known_motion(one.configuration, 100.0, one.initial.given, asked)
        spent.append((len(found.windows), counts["steps"]))
        assert set(counts) == {"steps"} and found.end == 100.0 and found.reason is None
        q, v, _ = found.at([100.0])
        off = np.abs(np.concatenate([q[:, 0], v[:, 0]]) - AT_100)
        size = [*np.abs(found.at(np.linspace(0, 100, 5001))[0]).max(axis=1), 1.0, 1.0]
        assert (off <= asked * np.array(size)).all()
        assert off[:2].max() <= max(found.shared.of_signal(lambda one, times: one.at(times)[0][0], 100.0) * 4, 1e-13)
    windows, steps = zip(*spent, strict=True)
    assert list(windows) == sorted(windows) and windows[0] < 0.6 * windows[3] and max(steps) < 1000


@pytest.mark.sweep
def test_more_than_floats_have_ends_the_motion_where_it_is_held(scene, capsys):
    file = scene(SWINGING)
    assert run(["response", file, "--accuracy", "1e-12", "--at", "100"]) == 4
    out, err = capsys.readouterr()
    assert "the accuracy 1e-12 that is asked is held up to t = " in err and "less accuracy" in err
    assert "p [rad]  –" in out
    assert run(["response", file, "--accuracy", "1e-9", "--at", "100"]) == 0


@pytest.mark.sweep
def test_where_neighbours_part_steps_are_tightened_before_the_motion_ends():
    """Of 1e-6 steps of 1e-9 would be enough for a motion that is not chaotic."""
    one = problem(FAR_UP)
    held, far = (known_motion(one.configuration, 25.0, one.initial.given, asked).end for asked in (1e-6, None))
    assert 0.4 * far < held < far
    truth = integrate.simulate(one.configuration, held, 3e-13, one.initial.given)
    found = known_motion(one.configuration, held, one.initial.given, 1e-6)
    times = np.linspace(0, held, 400)
    q, true = found.at(times)[0], truth.at(times)[0]
    assert (np.abs(q - true).max(axis=1) <= 1e-6 * np.abs(true).max(axis=1)).all()


def test_energies_that_balance_to_what_is_asked_are_enough(monkeypatch):
    one, balance = problem(SWINGING), integrate.balance

    def spoilt(*args):
        return balance(*args)._replace(error=1e-7)

    monkeypatch.setattr(integrate, "balance", spoilt)
    assert known_motion(one.configuration, 5.0, one.initial.given, 1e-6).balance.error == 1e-7


@pytest.mark.parametrize("text", ["0", "-1e-6", "2", "1e-20", "fine", "", "nan", "1_0e-7"])
def test_what_is_no_accuracy_is_a_usage_error(scene, capsys, text):
    assert run(["response", scene(SWINGING), f"--accuracy={text}"]) == 2
    err = capsys.readouterr().err
    assert "expected an accuracy from 1e-13 to 0.001, as in 1e-6" in err
    assert ("--digits" in err) == (text == "1e-20")
    with pytest.raises(vibcli.SpecError, match="expected an accuracy"):
        vibcli.load(scene(SWINGING)).with_accuracy(text)


@pytest.mark.parametrize(("command", "words"), [
    (["response"], "small oscillations are exact"), (["solve"], "small oscillations are exact"),
    (["animate", "--response"], "small oscillations are exact"), (["animate"], "belongs to --response"),
    (["sweep", "--over", "k=1 .. 2"], "small oscillations are exact")])
def test_nothing_is_asked_of_what_is_not_integrated(scene, capsys, command, words):
    name, *rest = command
    assert run([name, scene("motion: small\n" + SMALL), *rest, "--accuracy", "1e-6"]) == 2
    assert words in capsys.readouterr().err


def test_where_motions_are_small_by_themselves_an_accuracy_is_refused(scene, capsys):
    assert run(["response", scene(SMALL), "--accuracy", "1e-6"]) == 4
    assert "no accuracy can be asked of it" in capsys.readouterr().err
    assert run(["solve", scene(SMALL), "--accuracy", "1e-6"]) == 2
    assert "none is asked for" in capsys.readouterr().err
    assert run(["response", scene(SWINGING), "--digits", "20", "--accuracy", "1e-6"]) == 2
    assert "does not go with --digits" in capsys.readouterr().err


@pytest.mark.sweep
def test_the_scene_the_option_and_python_ask_alike(scene, capsys):
    asked = SWINGING.replace("motion: full", "motion: {accuracy: 1e-4}").replace("100 s", "20 s")
    ways = [["response", scene(asked), "--json", "--at", "20"]]
    found = []
    for way in ways:
        assert run(way) == 0
        found.append(json.loads(capsys.readouterr().out))
    file = scene(SWINGING.replace("100 s", "20 s"))
    assert run(["response", file, "--accuracy", "1e-4", "--json", "--at", "20"]) == 0
    found.append(json.loads(capsys.readouterr().out))
    assert found[0]["response"]["signals"] == found[1]["response"]["signals"]
    model = vibcli.load(scene(SWINGING)).with_accuracy(1e-4)
    given = model.with_values(L=1)      # what is asked stays
    assert given._problem.spec.accuracy == model._problem.spec.accuracy == 1e-4
    assert vibcli.load(scene(asked + "cases: {heavy: {parameters: {m: 2 kg}}}\n")).case(
        "heavy").with_accuracy("1e-5")._problem.spec.accuracy == 1e-5


def test_expanded_equations_are_integrated_as_accurately_as_is_asked(scene):
    text = SWINGING.replace("motion: full", "motion: {order: 3, accuracy: 1e-5}").replace("100 s", "10 s")
    model = vibcli.load(scene(text))
    assert model._problem.response.WORDS.startswith("equations to the third order")
    assert model["p(10 s)"].error < 1e-5


@pytest.mark.parametrize("asked", [None, 1e-4, 1e-6])
def test_of_peaks_that_are_alike_the_first_is_the_largest(asked):
    """A pendulum without damping comes back to its start; how far errors lift a later peak does not matter."""
    one = problem("motion: full\n" + PENDULUM + "initial: {phi: 0, phi': 3 rad/s}\nfind: [{response: {until: 20 s}}]\n")
    one = one if asked is None else one.with_accuracy(asked)
    omega, k = mpmath.sqrt(mpmath.mpf("9.81") / mpmath.mpf("0.8")), 3 / (2 * mpmath.sqrt(mpmath.mpf("9.81") / 0.8))
    signal, quarter = one.response.state_signal(one.scene.symbol("phi", 0)), float(mpmath.ellipk(k * k) / omega)
    for sense, expected in ((1, quarter), (-1, 3 * quarter)):
        t, value = signal.extreme(0.0, 20.0, sense)
        assert abs(t - expected) <= signal.error_of_time(t) + 1e-15
        assert abs(value - sense * float(2 * mpmath.asin(k))) <= signal.error(t)


@pytest.mark.sweep
@pytest.mark.parametrize("asked", [1e-4, 1e-6])
def test_of_many_links_what_is_asked_is_met_at_the_first_try(counts, monkeypatch, asked):
    tries, solved = [], integrate.solved
    monkeypatch.setattr(known_motions, "solved", lambda *args: tries.append(args[1]) or solved(*args))
    start = {f"p{i + 1}": float(angle) for i, angle in enumerate(np.linspace(0.5, 0.25, 6))}
    found = known_motion(problem(links(6)).configuration, 15.0, start, asked)
    assert len(tries) == 1 and set(counts) == {"steps"} and found.shared.largest <= asked


@pytest.mark.sweep
def test_what_goes_by_collocation_is_as_accurate_whatever_is_asked():
    """Errors of coarse steps by its two rules may be alike, so that their difference tells less than they are."""
    one = problem("""
motion: full
parameters: {m: 1 kg, k: 100 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}, stop: {k: 3*k, gap: 0.1 m, between: [ground, b]}}
initial: {x: 0.3 m}
""")
    found, coarse = (known_motion(one.configuration, 6.0, one.initial.given, asked) for asked in (None, 1e-3))
    assert found.events and len(found.windows) == len(coarse.windows)
    times = np.linspace(0, 6, 50)
    assert np.array_equal(found.at(times)[0], coarse.at(times)[0])
