"""What is told of a motion that was integrated."""

import re

import pytest

from vibcli.cli.program import run

AT_REST = """\
bodies: {base: {slide: 4 mm*sin(14 rad/s*t)}, b: {mass: 2 kg, slide: x}}
springs: {s: {k: 300 N/m, between: [base, b]}, n: {law: 4e4 N/m^3*d^3, between: [ground, b]}}
dampers: {d: {c: 3 N*s/m, between: [base, b]}}
motion: full
"""


def test_no_rounding_is_told_as_energy_at_the_start(scene, capsys):
    """All is at rest there; of the motion 0.7 J are left in the damper."""
    assert run(["response", scene(AT_REST), "--until", "3 s"]) == 0
    assert re.search(r"T \+ V at the start +0\n", capsys.readouterr().out)


PLUCKED = """\
bodies: {b: {mass: 2 kg, slide: x}}
springs: {s: {k: 300 N/m, between: [ground, b]}}
initial: {START}
motion: full
"""


@pytest.mark.parametrize(("start", "told"), [
    ("x': 1 m/s", r"x \[m\] +0 +0\.0768094119612\n"), ("x: 1 m", r"ẋ \[m/s\] +0 +-11\.5214117942\n")])
def test_what_starts_from_zero_is_told_to_start_from_zero(scene, capsys, start, told):
    """Not from 0 ± 4e-16, which none of the digits beside it show."""
    signal, at = ("x", "0.1 s") if "'" in start else ("x'", "0.1 s")
    assert run(["response", scene(PLUCKED.replace("START", start)), "--until", "1 s", "--of", signal, "--at", "0 s",
                "--at", at]) == 0
    assert re.search(told, capsys.readouterr().out)
