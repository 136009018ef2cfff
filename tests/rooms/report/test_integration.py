"""What is told of a motion that was integrated."""

import re

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
