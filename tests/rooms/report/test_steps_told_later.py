"""Letters of modes: s_k(τ) tells s₁, s₂ … of the modes that have lines, and of no others."""

import re

import pytest
from support.scenes import problem
from support.worked_lines import told_later

from vibcli.report.blocks import Name
from vibcli.report.steps.worked import worked

STEPPED = """
parameters: {m: 2 kg, k: 300 N/m, F: 5 N}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {r: {k: k, between: [ground, a]}, s: {k: k, between: [a, b]}}
DAMPER
forces: {f: {at: b, force: F*step(t)}}
initial: {x: 0 m}
"""


@pytest.mark.parametrize("damper", ["", "dampers: {d: {c: 6 N*s/m, between: [ground, a]}}"])
def test_a_letter_of_a_mode_that_there_is_not_is_seen(damper):
    scene = problem(STEPPED.replace("DAMPER", damper))
    lines = worked(scene)
    assert not told_later(scene, lines)
    at, i = next((at, i) for at, line in enumerate(lines) for i, part in enumerate(line.parts)
                 if isinstance(part, Name) and part.text == "s2")
    parts = lines[at].parts
    other = lines[at]._replace(parts=(*parts[:i], Name("s3"), *parts[i + 1:]))
    assert told_later(scene, [*lines[:at], other, *lines[at + 1:]]) == [(other.number, "s3")]


def test_the_same_letters_before_any_mode_has_a_line_are_seen():
    scene = problem(STEPPED.replace("DAMPER", ""))
    lines = worked(scene)
    without = [line for line in lines if not re.fullmatch(r"equation of mode \d", line.settles)]
    assert {"s1", "s2"} <= {name for _, name in told_later(scene, without)}
