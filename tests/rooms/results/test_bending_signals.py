"""Extremes of signals that bend along a smooth motion: they are those of the signals that they are made of."""

import pytest
from support.motions import PENDULUM, problem

from vibcli.quantities.expression import value_of

WIDE = PENDULUM + "initial: {phi: 2, phi': 0.3 rad/s}\nmotion: full\nfind: [{response: {until: 7 s}}]\n"


@pytest.mark.parametrize(("bent", "plain"), [
    ("max(abs(phi))", "max(phi)"), ("-min(abs(phi))", "0*max(phi)"), ("max(min(phi, 0.5))", "0*max(phi) + 0.5"),
    ("min(max(phi, -phi/2))", "0*max(phi)"), ("max(ramp(phi - 1))", "max(phi) - 1"),
    ("min(phi - abs(phi))", "2*min(phi)"), ("max(abs(bob.x))", "0*max(phi) + 0.8 m/(1 m)")])
def test_extremes_of_what_bends(bent, plain):
    if "bob.x" in bent:
        bent += "/(1 m)"
    scene = problem(WIDE + f"answers: {{'{bent}': '{plain}'}}\n")
    answer, = scene.spec.answers
    found, expected = (value_of(scene, one)[0] for one in (answer.asked, answer.expected))
    assert abs(found - expected) < 1e-9
