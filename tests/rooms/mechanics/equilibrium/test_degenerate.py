"""Equilibria at which the stiffness is singular, and places that are none: what is said of them is true."""

import json

import pytest
from support.scenes import problem

from vibcli.analyses.modal.stability import FALLING, HELD, NEUTRAL, stability
from vibcli.cli.program import run

SCENE = "parameters: {J: 1 kg*m^2, E: 1 J}\ncoordinates: [x]\nenergies:\n  T: J*x'^2/2\n  V: E*(POTENTIAL)\n"
RING = """
parameters: {m: 1 kg, k: 10 N/m, a: 1 m}
bodies: {p: {mass: m, at: [1.3 m, 0.2 m], move: [x, y, 0]}}
springs: {s: {k: k, between: [[0, 0], p], free_length: a}}
"""


@pytest.fixture
def ask(tmp_path, capsys):
    def ask(text, *line):
        path = tmp_path / "scene.yaml"
        path.write_text(text)
        code = run([line[0], str(path), *line[1:]])
        return code, *capsys.readouterr()
    return ask


@pytest.mark.sweep
@pytest.mark.parametrize("V, place", [("(x - 1)^4", 1.0), ("(x - 1)^6", 1.0), ("(x + 1/3)^4*(x - 3)^2", -1 / 3)])
def test_a_multiple_zero_away_from_the_drawn_position(V, place, ask):
    """No digits are asked, so that none are refused; nor does the place show digits that are not known."""
    text = SCENE.replace("POTENTIAL", V)
    found = problem(text)
    assert stability(found.modal).kind == HELD
    assert found.configuration.equilibrium.values["x"] == pytest.approx(place, abs=1e-8)
    code, out, err = ask(text, "solve")
    assert code == 0 and not err and "digits" not in out
    code, _, err = ask(text, "frequencies", "--digits", "30")
    assert code == 4 and "degenerate" in err and "leave --digits out" in err
    assert ask(text, "frequencies")[0] == 0


@pytest.mark.parametrize("start", ["", "equilibrium: {x: 0.8}\n"])
@pytest.mark.parametrize("V, place", [("(x - 1)^4", 1.0), ("(x - 1)^6", 1.0), ("(x - 1)^8", 1.0), ("(x - 1)^10", 1.0),
                                      ("(x - 1/3)^6*(x - 3)^2", 1 / 3), ("cosh(x - 1) - (x - 1)^2/2", 1.0)])
def test_its_place_is_right_whoever_asks_first(V, place, start, ask):
    """The forces of (x - 1)^10 are rounding from 0.99 on."""
    text = start + SCENE.replace("POTENTIAL", V)
    assert problem(text).configuration.at_rest["x"] == pytest.approx(place, abs=1e-9)
    assert ask(text + f"answers: {{'equilibrium[x]': {place!r}}}\n", "check")[0] == 0


def test_a_line_of_equilibria_that_bends_is_neutral():
    assert stability(problem(RING).modal).kind == NEUTRAL


@pytest.mark.parametrize("V, kind", [("x^3", FALLING), ("x^4", HELD), ("-x^4", FALLING)])
def test_as_drawn_terms_beyond_the_linear_ones_decide(V, kind):
    assert stability(problem(SCENE.replace("POTENTIAL", V)).modal).kind == kind


@pytest.mark.sweep
def test_where_there_is_none(ask):
    """V′ = (x − 1)² + 10⁻¹⁶ comes near zero at x = 1 and stays above it."""
    text = ("parameters: {J: 1 kg*m^2, E: 1 J}\ncoordinates: [x, y]\nequilibrium: {x: 1.0001, y: 0}\nenergies:\n"
            "  T: J*(x'^2 + y'^2)/2\n  V: E*((x - 1)^3/3 + 1e-16*x + y^2)\n")
    code, _, err = ask(text, "frequencies")
    assert code == 4 and "no equilibrium is found there" in err and "digits" not in err


@pytest.mark.sweep
def test_a_list_stands_where_the_drawn_position_leads_nowhere(ask):
    text = SCENE.replace("POTENTIAL", "(x + 3/2)^2/2 - (x + 3/2)^4/4") + (
        "find: {equilibria: all, within: {x: [-4, 4]}}\n")
    code, out, err = ask(text, "solve")
    assert code == 0 and not err and out.count("unstable") == 2
    code, out, err = ask(text, "solve", "--json")
    found = json.loads(out)
    assert code == 0 and [entry["stable"] for entry in found["equilibria"]] == [False, True, False]
    assert found["equilibrium"] is None and "no equilibrium is reached" in found["remark"] and found["equations"]
    code, out, err = ask(text.replace("find: {", "find: [equilibrium, {").replace("]}}", "]}}]"), "solve")
    assert code == 4 and out.count("unstable") == 2 and "no equilibrium is reached" in err


@pytest.mark.parametrize("V, places", [("(x - 1)^8", [1]), ("(x - 1)^10", [1]), ("(x - 1)^12*(x + 1)^8", [-1, -0.2, 1]),
                                       ("-(x - 1/2)^9", [0.5]), ("(x - 1)^8 + x", None)])
def test_a_flat_place_is_no_line_of_equilibria(V, places):
    """Floats see no force on a stretch about it; more digits do."""
    found = problem(SCENE.replace("POTENTIAL", V) + "find: [{equilibria: all, within: {x: [-2, 3]}}]\n").equilibria
    assert not any(item.free for item in found.items)
    if places is not None:
        assert [item.equilibrium.values["x"] for item in found.items] == pytest.approx(places, abs=1e-9)


@pytest.mark.parametrize("play", ["1 m", "0.3 m"])
def test_a_line_of_equilibria_is_one(play):
    found = problem(f"""
bodies: {{b: {{mass: 1 kg, slide: x}}}}
springs:
  s: {{k: 100 N/m, between: [ground, b], gap: {play}}}
  r: {{k: 100 N/m, between: [b, ground], gap: {play}}}
find: [{{equilibria: all, within: {{x: [-2 m, 3 m]}}}}]
""").equilibria
    assert [item.free for item in found.items] == [[{"x": 1.0}]]


def test_tiny_places_of_a_list_are_right_to_the_last_digit():
    """A shallow truss under 1e-12 N: w = P/K, K = 2 k h²/ℓ²."""
    found = problem("""
parameters: {k: 1000 N/m, a: 1 m, h: 0.1 m, P: 1e-12 N}
bodies: {p: {mass: 1 kg, at: [0, h], slide: {by: w, along: [0, -1]}}}
springs: {s: {k: k, between: [[-a, 0], p]}, r: {k: k, between: [[a, 0], p]}}
forces: {f: {at: p, force: [0, -P]}}
find: [{equilibria: all, within: {w: [-0.05 m, 0.05 m]}}]
""").equilibria
    assert [item.equilibrium.values["w"] for item in found.items] == pytest.approx([1e-12 * 1.01 / 20], rel=1e-10)
