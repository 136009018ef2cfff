"""Cycles and radians: Hz is refused wherever radians are due, what the hints say works, and the rest counts neither."""

import re
from pathlib import Path

import pytest

from vibcli.base.errors import SpecError
from vibcli.language.document.document import read
from vibcli.reader.read import read_spec

ROOT = Path(__file__).parents[3]
SCENES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml"),
                 *(ROOT / "tests" / "trials").glob("*.yaml")])
ANGULAR = re.compile(r"(\b[A-Za-z_]\w*): (\d[\d.e+-]*) (rad/s|rpm)(?=[,}\s])")

SCENE = """
parameters:
  f: {{value: 5 Hz, unused: allowed}}
  w: {{value: 5 rad/s, unused: allowed}}
  T: {{value: 1/f, unused: allowed}}
  n: {{value: 4, unused: allowed}}
  v: {{value: 3 m/s, unused: allowed}}
  R: {{value: 0.2 m, unused: allowed}}
  a: {{value: {a}, unused: allowed}}
  m: 2 kg
bodies: {{one: {{mass: m, slide: x}}}}
springs: {{s: {{k: {k}, between: [ground, one]}}}}
energies: {{V: "{V}"}}
forces: {{F: {{coordinate: x, value: "{force}"}}}}
initial: {{x: {x}}}
"""
PLAIN = {"a": "3 mm", "k": "90 N/m", "V": "0 J", "force": "3 N*sin(w*t)", "x": "1 mm"}


def wrong(text, file="scene.yaml"):
    """[(message, hint)] of what is wrong with a scene."""
    node, diagnostics = read(text.encode(), file)
    try:
        read_spec(node, file, diagnostics)
    except SpecError as error:
        return [(d.message, d.hint) for d in error.diagnostics]
    return []


REFUSED = [
    {"force": "3 N*sin(f*t)"}, {"force": "3 N*cos(2*f*t)"}, {"force": "3 N*sin(5 Hz*t)"}, {"force": "3 N*square(f*t)"},
    {"force": "3 N*sin(t/T)"}, {"force": "3 N*sin(t/(2*T))"}, {"force": "3 N*exp(-f*t)"},
    {"force": "3 N*sin(a*t)", "a": "f"}, {"force": "3 N*sin(a*t)", "a": "f*n"}, {"force": "3 N*sin(a)", "a": "30*f/w"},
    {"k": "m*f^2"}, {"k": "m*pi*f^2"}, {"k": "m*(2*f)^2"}, {"k": "m*25 Hz^2"}, {"k": "m*a", "a": "f^2"},
    {"k": "m*f*w"}, {"k": "m/T^2"}, {"k": "m*(f + w)^2"}, {"k": "m*sqrt(f^4)"}, {"force": "m*v*f"},
    {"force": "3 N*sin(2*pi*(f + w)*t)"}, {"force": "3 N*sin(f*t + 30 deg)"}, {"a": "v/f", "x": "a"}, {"x": "v/f"},
    {"V": "x^2*m*f^2"}, {"x": "9.81 m/s^2/f^2"}, {"force": "3 N*step(t - 2*pi/f)"}, {"force": "3 N*sin(max(f, w)*t)"},
]
ACCEPTED = [
    {"force": "3 N*sin(2*pi*f*t)"}, {"force": "3 N*sin(f*pi*t)"}, {"force": "3 N*cos(2*pi*(f*t + 0.25))"},
    {"force": "3 N*sin(2*pi*t/T)"}, {"force": "3 N*sin(2*pi*f*(t - T/4))"}, {"force": "3 N*sin(a*t)", "a": "2*pi*f"},
    {"force": "3 N*sin(pi*a*t)", "a": "2*f"}, {"force": "3 N*sin(v/R*t)"}, {"force": "3 N*sin(2*pi*(f + v/R)*t)"},
    {"force": "3 N*sin((2*pi*f + w)*t)"}, {"force": "3 N*sin(300 rpm*t)"}, {"force": "3 N*step(t - 3/f)"},
    {"force": "3 N*step(t - 1/f - 0.1 s)"}, {"force": "3 N*step(t - T)"}, {"force": "3 N*step(t - a)", "a": "n/f"},
    {"force": "3 N*step(t - 1/(2*pi*f))"}, {"k": "m*(2*pi*f)^2"}, {"k": "m*4*pi^2*f^2"}, {"k": "4*m*pi^2/T^2"},
    {"k": "m*w^2"}, {"k": "m*(v/R)^2"}, {"k": "m*pi*f*pi*f"}, {"x": "v*T"}, {"x": "v/(2*pi*f)"}, {"x": "v/f/2/pi"},
    {"x": "9.81 m/s^2/(2*pi*f)^2"}, {"force": "3 N*sin(2*pi*sqrt(f^2)*t)"}, {"force": "3 N*sin(2*pi*max(f, 3 Hz)*t)"},
    {"k": "m*w/T*T*w"}, {"x": "R*f*T"}, {"force": "3 N*sin(2*pi*t*2000 mm/s/(500 mm))"},
    {"force": "3 N*atan2(f, 2 Hz)"}, {"force": "3 N*f/(2 Hz)"},
]


@pytest.mark.parametrize("changes", REFUSED, ids=str)
def test_cycles_are_refused_where_radians_are_due(changes):
    found = wrong(SCENE.format(**PLAIN | changes))
    assert len(found) == 1
    assert "cycles (Hz)" in found[0][0]
    assert "2*pi*f" in found[0][1] or "1/f" in found[0][1] or "2*pi/T" in found[0][1]


@pytest.mark.parametrize("changes", ACCEPTED, ids=str)
def test_each_cycle_has_its_factor(changes):
    assert wrong(SCENE.format(**PLAIN | changes)) == []


@pytest.mark.parametrize(("key", "text"), [
    ("force", "3 N*sin(f*t)"), ("force", "3 N*sin(5 Hz*t)"), ("k", "m*f^2"), ("k", "m*f*w"), ("k", "m*(f + w)^2"),
    ("k", "m*25 Hz*f"), ("x", "9.81 m/s^2/f^2"), ("x", "v/f"), ("force", "3 N*exp(-f*t)"), ("force", "m*v*f"),
])
def test_what_the_hint_says_is_accepted(key, text):
    while found := wrong(SCENE.format(**PLAIN | {key: text})):
        turned = re.search(r"write (\(2\*pi\*([^)]+)\))", found[0][1])
        assert re.search(rf"(?<!pi\*){turned[2]}", text)
        text = re.sub(rf"(?<!pi\*)\b{turned[2]}", turned[1], text, count=1)


@pytest.mark.parametrize(("k", "line", "fits"), [
    ("80 N/m", "frequency[1]: 0", True), ("80 N/m", "frequency[1]: 0 Hz", True), ("80 N/m", "frequency[1]: 1 Hz", True),
    ("80", "frequency[1]: 1.007", True), ("80", "frequency[1]: 0", True), ("80", "frequency[1]: 3", True),
    ("80", "2*frequency[1]: 0.5", True), ("80", "omega[1]/(2*pi): frequency[1]", True), ("80", "omega[1]: 6.3", True),
    ("k", "frequency[1]: sqrt(k/m)/(2*pi)", True), ("k", "omega[1]: 2*pi*frequency[1]", True),
    ("k", "frequency[1]: 1/period[1]", True), ("k", "period[1]: 1/frequency[1]", True),
    ("k", "period[1]: 2*pi/omega[1]", True), ("k", "period[1]: 2*pi/frequency[1]", False),
    ("k", "omega[1]: frequency[1]", False), ("k", "frequency[1]: omega[1]", False),
    ("k", "omega[1]: 1/period[1]", False), ("k", "2*omega[1]: 1/period[1]", False),
    ("k", "omega[1] - 2*pi/period[1]: 0", True)])
def test_answers_about_frequencies(k, line, fits):
    m = "2" if k == "80" else "m"
    found = wrong(f"""
parameters: {{m: {"2 kg" if m == "m" else 2}, k: {{value: {k if k != "k" else "80 N/m"}, unused: allowed}}}}
bodies: {{one: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, one]}}}}
answers: {{"{line.partition(": ")[0]}": "{line.partition(": ")[2]}"}}
""")
    assert (found == []) is fits


def angular_parameters():
    for path in SCENES:
        text = path.read_text(encoding="utf-8")
        for match in ANGULAR.finditer(text):
            if match[1] not in ("from", "to", "up_to"):
                yield pytest.param(path, match.span(3), id=f"{path.stem}-{match[1]}")


@pytest.mark.parametrize(("path", "span"), list(angular_parameters()))
def test_no_scene_takes_hz_for_its_angular_frequency(path, span):
    """Of every problem and example: rad/s and rpm written as Hz are an error, never another number."""
    text = path.read_text(encoding="utf-8")
    found = wrong(text[:span[0]] + "Hz" + text[span[1]:], str(path))
    assert any("cycles (Hz)" in message or "found Hz" in message for message, _ in found)


@pytest.mark.parametrize(("k", "advice"), [
    ("m*f^2", "where 'k'"), ("m/T^2", "where 'k'"), ("m*n^2", "where 'k'"), ("m*N^2", "where 'k'")])
def test_a_stiffness_that_counts_cycles_is_mended_where_it_is_defined(k, advice):
    found = wrong(f"""
parameters: {{m: 2 kg, f: {{value: 5 Hz, unused: allowed}}, T: {{value: 1/f, unused: allowed}}, k: {k},
  n: {{value: 1/T, unused: allowed}}, N: {{value: 1/(1/f), unused: allowed}}}}
bodies: {{one: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, one]}}}}
""")
    assert len(found) == 1 and advice in found[0][1] and "2*pi/" not in found[0][1]
