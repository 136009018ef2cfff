"""Scenes with kinks: the equations and the places of rest are told, and what needs a slope alone is refused."""

import json
import random
import re

import pytest
from support.scenes import problem

from vibcli.cli.program import run
from vibcli.mechanics.equilibrium.dry_friction import span

BLOCK = """
parameters: {m: 2 kg, k: 100 N/m, F: 3 N, R: 5 N}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {friction: R, between: [ground, b]}}
forces: {p: {at: b, force: F}}
"""
INCLINE = """
parameters: {m: 2 kg, s: 0.3, c: sqrt(1 - s^2), g: 9.81 m/s^2, mu: MU}
gravity: g
bodies: {b: {mass: m, at: [0, 0], slide: {along: [c, s], by: x}}}
dampers: {d: {friction: mu*m*g*c, stretch: x}}
"""


@pytest.fixture
def ask(tmp_path, capsys):
    def ask(text, *line):
        path = tmp_path / "scene.yaml"
        path.write_text(text)
        code = run([line[0], str(path), *line[1:]])
        out, err = capsys.readouterr()
        return code, out, err
    return ask


@pytest.mark.parametrize("command", ["solve", "equations"])
@pytest.mark.parametrize("load", ["damper", "force", "Phi"])
def test_equations_and_places_of_rest_are_told(command, load, ask):
    """|k x − F| ≤ R from −0.02 m to 0.08 m, whichever way the friction is written."""
    text = BLOCK
    if load == "force":
        text = text.replace("dampers: {d: {friction: R, between: [ground, b]}}", "").replace(
            "{p: {at: b, force: F}}", "{p: {at: b, force: F - R*sign(x')}}")
    if load == "Phi":
        text = text.replace("dampers: {d: {friction: R, between: [ground, b]}}", "energies: {Phi: R*abs(x')}")
    code, out, err = ask(text, command)
    assert code == 0 and not err
    assert "R·sign ẋ" in out and "|k·x − F| ≤ R" in out and "which is x from −0.02 m to 0.08 m" in out
    assert out.count("at rest wherever") == 1 and "vibcli equations" not in out and "Natural freq" not in out
    code, out, err = ask(text, command, "--json")
    found = json.loads(out)
    assert code == 0 and found["sticking"]["conditions"] == ["abs(k*x - F) <= R"]
    assert (found["sticking"]["from"], found["sticking"]["to"]) == pytest.approx((-0.02, 0.08))
    assert found["equations"][0]["linear_text"] is None and found["equations"][0]["text"]


@pytest.mark.parametrize("find", ["equations", "equations, {response: {until: 1 s}}", "{response: {until: 1 s}}",
                                  "equations, {frequency_response: {to: p}}", "{frequency_response: {to: p}}"])
@pytest.mark.parametrize("command", ["solve", "response", "frf"])
def test_responses_that_need_a_slope_are_refused_in_text_as_in_json(command, find, ask):
    text = BLOCK.replace("force: F", "force: F*sin(3 rad/s*t)") + f"find: [{find}]\n"
    code = 0 if (command, find) == ("solve", "equations") else 4
    assert [ask(text, command, *more)[0] for more in ([], ["--json"])] == [code, code]


def test_full_motions_stand_beside_equations_without_a_slope(ask):
    text = BLOCK + "motion: full\ninitial: {x: 0.2 m}\nfind: [equations, {response: {until: 1 s}}]\n"
    for command in ("solve", "response"):
        code, out, err = ask(text, command)
        assert code == 0 and not err and "Extremes" in out


@pytest.mark.sweep
def test_what_needs_a_slope_is_refused(ask):
    for text, line in ((BLOCK, ["frequencies"]), (BLOCK, ["frequencies", "--json"]),
                       (BLOCK + "find: [equations, frequencies]\n", ["solve"]),
                       (BLOCK + "find: [equations, modes]\n", ["solve", "--json"])):
        code, _, err = ask(text, *line)
        assert code == 4 and "dry friction has a kink at rest" in err
    for words in ("equilibrium", "equations", "equations, equilibrium", "energies"):
        assert ask(BLOCK + f"find: [{words}]\n", "solve")[0] == 0
        assert ask(BLOCK + f"find: [{words}]\n", "solve", "--json")[0] == 0
    assert "linear" not in ask(BLOCK + "find: [equilibria: all]\n", "solve")[1]


@pytest.mark.sweep
@pytest.mark.parametrize("mu, told", [("0.4", "which is anywhere"), ("0.2", "there is no such place")])
def test_a_block_on_an_incline(mu, told, ask):
    """tan α = 0.3145: above it friction holds the block anywhere, below nowhere."""
    code, out, err = ask(INCLINE.replace("MU", mu), "solve")
    assert code == 0 and told in out and "nothing holds" not in out + err


def test_letters_and_position_kinks(ask):
    letters = "parameters: {m: {unit: kg}, k: {unit: N/m}, R: {unit: N}}\n" + "".join(
        line + "\n" for line in BLOCK.split("\n")[2:5])
    code, out, _ = ask(letters, "solve")
    assert code == 0 and "|k·x| ≤ R" in out and "closed form" not in out
    assert ask(letters, "frequencies")[0] == 4
    code, out, _ = ask("parameters: {m: 1 kg, F: 2 N, k: 3 N/m}\ncoordinates: [x]\n"
                       "energies: {T: m*x'^2/2, V: F*abs(x) - k*x^2/2}\n", "solve")
    assert code == 0 and "a kink: no small oscillations about it" in out and "F·sign x" in out


def test_friction_between_two_blocks(ask):
    code, out, _ = ask("parameters: {m: 2 kg, k: 100 N/m, R: 3 N}\nbodies: {a: {mass: m, slide: x}, b: {mass: m, "
                       "slide: y}}\nsprings: {s: {k: k, between: [ground, a]}, u: {k: k, between: [ground, b]}}\n"
                       "dampers: {d: {friction: R, breakaway: 2*R, between: [a, b]}}\n", "solve", "--json")
    assert code == 0
    assert json.loads(out)["sticking"]["conditions"] == ["k*x - R*sigma_1 = 0", "abs(sigma_1) <= 2",
                                                         "k*y + R*sigma_1 = 0"]


@pytest.mark.parametrize("seed", range(4))
def test_motions_end_within_the_span(seed):
    """Let go from anywhere, a damped pendulum or block comes to rest in a place that is said to be one."""
    draw = random.Random(seed)
    start = draw.uniform(-0.6, 0.6)
    pendulum = seed % 2
    text = ("parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, R: 2 N*m}\ngravity: g\nbodies: {b: {mass: m, at: [0, -L], "
            "pin: {at: [0, 0], by: x}}}\ndampers: {d: {torsion: true, friction: R, between: [ground, b]}}\n"
            if pendulum else BLOCK)
    found = problem(f"{text}initial: {{x: {start}{'' if pendulum else ' m'}}}\nmotion: full\n"
                    "find: [{response: {until: 9 s}}]\n")
    low, high, whole = span(found.configuration, found.system.sticking)
    end = found.response.reaching(9.0).at([9.0])
    assert whole is not bool(pendulum)
    assert low - 1e-9 <= end[0][0, 0] <= high + 1e-9 and abs(end[1][0, 0]) < 1e-12


HELD = """
motion: full
parameters: {m: 2 kg, R: 8 N}
bodies: {b: {mass: m, slide: x}}
forces: {f: {at: b, force: FORCE}}
dampers: {d: {friction: R, between: [ground, b]}}
INITIAL
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("force", "holds"), [("5 N", True), ("8 N", True), ("-8 N", True), ("8.001 N", False),
                                              ("5 N + 9 N*step(t - 1 s)", True)])
def test_a_motion_starts_as_drawn_where_friction_alone_holds_the_scene(force, holds, ask):
    """Where it does not, as drawn too: nothing holds it."""
    text = HELD.replace("FORCE", force)
    code, out, err = ask(text.replace("INITIAL", ""), "response", "--until", "2", "--at", "0.9", "--of", "x'")
    assert code == 0
    assert "from x(0) = 0 m" in out and "T + V at the start  0" in out
    same = ask(text.replace("INITIAL", "initial: {x: 0 m}"), "response", "--until", "2", "--at", "0.9", "--of", "x'")
    assert "(as drawn: no equilibrium is reached)" in out
    assert same == (code, out.replace("   (as drawn: no equilibrium is reached)", ""), err)
    assert bool(re.search(r"ẋ \[m/s\] +0\n", out)) == holds


@pytest.mark.sweep
def test_forces_in_an_equilibrium_that_is_none_are_refused(ask):
    """What friction alone holds against a load is at rest, but no equilibrium of the scene without it: no damper's
    force there is 0."""
    code, _, err = ask("parameters: {m: 2 kg, F: 3 N, R: 5 N, c: 4 N*s/m}\nbodies: {b: {mass: m, slide: x}}\n"
                       "dampers: {d: {friction: R, between: [ground, b]}, e: {c: c, between: [ground, b]}}\n"
                       "forces: {f: {at: b, force: F}}\n"
                       "answers: {'equilibrium[d.force]': 0 N, 'equilibrium[e.force]': 0 N}\n", "check")
    assert code == 4 and err.count("no equilibrium is reached") == 1 and "(so of 2 answers)" in err
