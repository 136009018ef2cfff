"""Hints are claims: what a hint of the quantities and signals tells to write or to ask for is written, and answered."""

import math
import re

import pytest
from scenes import problem

from vibcli.algebra.parse import parse
from vibcli.cli import run
from vibcli.document import read
from vibcli.errors import PhysicsError, SpecError
from vibcli.measured import measure, value_of
from vibcli.questions import ASKED
from vibcli.spec import read_spec

SCENE = """
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {block: {mass: m, at: [0, 0], slide: {along: [1, 0], by: u}}}
springs: {spring: {k: k, between: [[-1 m, 0], block]}}
dampers: {dash: {c: c, between: [[-1 m, 0], block]}}
forces: {push: {at: block, force: [3 N*sin(5 rad/s*t), 0]}}
answers:
  "ASKED": ZERO
"""


def diagnostics(asked):
    text = SCENE.replace("ASKED", asked).replace("ZERO", "0 Hz" if asked.startswith("frequency[") else "0")
    node, found = read(text.encode(), "scene.yaml")
    try:
        read_spec(node, "scene.yaml", found)
    except SpecError as error:
        return error.diagnostics
    return []


@pytest.mark.parametrize("head", [head for head, asked in ASKED.items() if asked.indices or asked.args])
def test_a_quantity_written_bare_is_told_in_names_of_the_scene(head):
    one, = diagnostics(head)
    told = one.hint.removeprefix("write ")
    assert one.hint.startswith("write ") and told.startswith(head)
    if head not in ("equation", "motion", "Q"):                 # of these 0 is no answer
        assert diagnostics(told) == [], told


@pytest.mark.parametrize("asked", ["re(omega[1])", "im(M[u,u])", "arg(zeta[1])", "re(amplitude(u))", "re(u)", "arg(u)",
                                   "peak[1](u).value", "half_power[1](omega[1])", "re(frf[u, push])",
                                   "peak[1](frf[u, push](3 Hz)).value", "phase(frf[u, push])", "max(2 s)", "omega",
                                   "omega[1, 2, 3]", "mode[1]", "transmissibility[u]", "sensitivity[1]"])
def test_what_stands_at_the_wrong_place_is_told_how_it_is_written(asked):
    one = diagnostics(asked)[0]
    told = re.sub(r"^(?:write|ask for) | itself$", "", one.hint)
    assert one.hint and (told == one.hint or diagnostics(told) == []), one.hint


ROTOR = """
parameters: {m: 1 kg, k: 100 N/m, W: 3 rad/s}
coordinates: {x: , y: }
energies: {T: "m/2*((x' - W*y)^2 + (y' + W*x)^2)", V: k/2*(x^2 + 2*y^2)}
"""


def test_the_parts_of_a_complex_mode():
    """x'' − 2W y' + (100 − W²) x = 0 and y'' + 2W x' + (200 − W²) y = 0: y/x = −i·(100 − W² − ω²)/(2Wω)·(−1)."""
    scene = problem(ROTOR)
    omega = measure(scene, parse("omega[1]"))[0]
    ratio = (100 - 9 - omega**2) / (2 * 3 * omega)              # (k − W² − ω²) x = 2W iω y
    assert abs(measure(scene, parse("re(mode[1][y])"))[0]) < 1e-9
    assert abs(measure(scene, parse("im(mode[1][y])"))[0]) == pytest.approx(abs(ratio), rel=1e-9)
    assert abs(measure(scene, parse("arg(mode[1][y])"))[0]) == pytest.approx(math.pi / 2, rel=1e-9)


REFUSED = [                 # (scene, quantity): each is refused, with a hint that names what is there instead
    ("""energies: {T: "1 kg/2*x'^2", V: "-3 N/m/2*x^2"}""", "omega[1]"),
    ("""energies: {T: "1 kg/2*x'^2", V: "3 N/m/2*x^2"}""", "growth_rate[1]"),
    ("bodies: {a: {mass: 1 kg, slide: x}}", "period[1]"),
    ("""
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
dampers: {d: {c: 60 N*s/m, between: [ground, a]}}
""", "decrement[1]"),
    ("""
bodies: {a: {slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
dampers: {d: {c: 60 N*s/m, between: [ground, a]}}
""", "omega[1]"),
]


@pytest.mark.parametrize(("scene", "asked"), REFUSED)
def test_what_is_named_instead_is_there(scene, asked):
    scene = problem(scene)
    with pytest.raises(PhysicsError) as refusal:
        measure(scene, parse(asked))
    found = re.findall(r"[a-z_]+\[1\]", refusal.value.hint)
    assert found
    for told in found:
        assert measure(scene, parse(told))


def test_a_complex_number_is_told_to_be_taken_apart():
    scene = problem(ROTOR + "answers: {\"mode[1][y]\": 1}\n")
    with pytest.raises(PhysicsError, match="complex") as refusal:
        value_of(scene, scene.spec.answers[0].asked)
    for part in ("re", "im", "abs", "arg"):
        assert part in refusal.value.hint
        measured = problem(ROTOR + f"answers: {{\"{part}(mode[1][y])\": 1}}\n")
        assert math.isfinite(value_of(measured, measured.spec.answers[0].asked)[0])


SWING = """
bodies: {rod: {shape: rod, mass: 2 kg, from: [0, 0], to: [0, -1 m], pin: {at: [0, 0], by: phi}}}
gravity: 9.81 m/s^2
initial: {phi: 20 deg}
find: [{response: {until: 2 s}}]
"""


@pytest.mark.parametrize(("motion", "signal"), [("full", "phi"), ("full", "rod.x"), ("small", "rod.x"),
                                                ("small", "2*phi"), ("small", "steady(phi)")])
def test_digits_are_refused_with_what_has_them(motion, signal, tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(SWING + f"motion: {motion}\n")
    options = ["--of", signal, "--at", "0.5"]
    assert run(["response", str(file), *options, "--digits", "20"]) == 4
    hint = capsys.readouterr().err.partition("hint: ")[2].strip()
    if hint == "leave --digits out":
        assert run(["response", str(file), *options]) == 0
    else:
        told = hint.removeprefix("ask for ").split()
        assert told[0] == "--of" and run(["response", str(file), *told, "--at", "0.5", "--digits", "20"]) == 0
    assert "0.5" in capsys.readouterr().out


@pytest.mark.parametrize(("asked", "words"), [
    ("rod.reaction.y", "springs and dampers alone"), ("steady(phi)", "no steady part"),
    ("phi + transient(phi)", "no transient")])
def test_signals_that_a_full_motion_has_not(asked, words):
    scene = problem(SWING + "motion: full\n")
    with pytest.raises(PhysicsError) as refusal:
        measure(scene, parse(f"max({asked})"))
    assert words in f"{refusal.value.message} {refusal.value.hint}" and refusal.value.hint
